//! Under which names does a compiler look for these routines? Reads and writes nothing else.
//!
//! `compiler-builtins` has the same names as weak symbols: these take their place.

use super::Ordering;

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

/// On Arm each question has a routine, which says yes by 1 and no by 0.
#[cfg(target_arch = "arm")]
macro_rules! asked {
    ($($name:ident = $($ordering:ident)|+;)*) => {$(
        #[unsafe(no_mangle)]
        extern "C" fn $name(a: u32, b: u32) -> u32 {
            u32::from(matches!(super::compare(a, b), $(Ordering::$ordering)|+))
        }
    )*};
}

#[cfg(target_arch = "arm")]
asked! {
    __aeabi_fcmplt = Below;
    __aeabi_fcmple = Below | Equal;
    __aeabi_fcmpeq = Equal;
    __aeabi_fcmpge = Above | Equal;
    __aeabi_fcmpgt = Above;
}

/// Elsewhere they answer by a number that is compared with zero; what is no number gives the answer that says no.
#[cfg(not(target_arch = "arm"))]
macro_rules! answered {
    ($($name:ident: $none:literal;)*) => {$(
        #[unsafe(no_mangle)]
        extern "C" fn $name(a: u32, b: u32) -> i32 {
            match super::compare(a, b) {
                Ordering::Below => -1,
                Ordering::Equal => 0,
                Ordering::Above => 1,
                Ordering::None => $none,
            }
        }
    )*};
}

#[cfg(not(target_arch = "arm"))]
answered! {
    __ltsf2: 1;
    __lesf2: 1;
    __eqsf2: 1;
    __nesf2: 1;
    __gesf2: -1;
    __gtsf2: -1;
}
