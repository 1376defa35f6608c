//! Can any obstacles break the engine? Reads the fuzzer's bytes; writes nothing, the body panics if they can.
#![no_main]

#[path = "../../tests/fuzz/body/mod.rs"]
#[allow(dead_code, reason = "each target uses its part of the bodies")]
mod body;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let _ = body::mesh::run(bytes);
});
