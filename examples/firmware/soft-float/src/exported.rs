//! Under which names does a compiler look for these routines? Reads and writes nothing else.
//!
//! `compiler-builtins` has the same names as weak symbols: these take their place.

macro_rules! exported {
    ($($arm:ident, $other:ident = $function:ident;)*) => {$(
        #[cfg(target_arch = "arm")]
        #[unsafe(no_mangle)]
        extern "C" fn $arm(a: u32, b: u32) -> u32 {
            super::$function(a, b)
        }

        #[cfg(not(target_arch = "arm"))]
        #[unsafe(no_mangle)]
        extern "C" fn $other(a: u32, b: u32) -> u32 {
            super::$function(a, b)
        }
    )*};
}

exported! {
    __aeabi_fadd, __addsf3 = add;
    __aeabi_fsub, __subsf3 = subtract;
    __aeabi_fmul, __mulsf3 = multiply;
    __aeabi_fdiv, __divsf3 = divide;
}
