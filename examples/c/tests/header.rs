//! Is `include/carom.h` what the functions are? Reads the crate by cbindgen; with CAROM_WRITE_HEADER=1 it writes the header.
#![cfg(not(miri))]

use std::path::Path;

#[test]
fn the_header_is_up_to_date() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let config = cbindgen::Config::from_file(root.join("cbindgen.toml")).unwrap();
    // The functions are made by macros, which stable compilers expand for those only who say this.
    // SAFETY: this is the only test of its program, and has no other thread.
    unsafe { std::env::set_var("RUSTC_BOOTSTRAP", "1") };
    let made = cbindgen::Builder::new().with_crate(root).with_config(config).generate().unwrap();
    let mut text = Vec::new();
    made.write(&mut text);
    let text = String::from_utf8(text).unwrap();
    let path = root.join("include/carom.h");
    if std::env::var_os("CAROM_WRITE_HEADER").is_some() {
        std::fs::write(&path, &text).unwrap();
    }
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    let differs = text.lines().zip(committed.lines()).find(|(made, is)| made != is);
    assert!(
        text == committed,
        "include/carom.h is not what src/export is (CAROM_WRITE_HEADER=1 cargo test --test header): {differs:?}"
    );
}
