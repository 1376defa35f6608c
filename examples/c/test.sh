#!/usr/bin/env bash
# Is carom from C what it is from Rust? Builds and tests the library, the header and C's programs; with the library for
# a Cortex-M4F as its argument also the Arduino sketch, under QEMU. Needs cc, c++, and for the sketch
# arm-none-eabi-g++ and qemu-system-arm. CAROM_WRITE_HEADER=1 makes the header anew.
set -euo pipefail
cd "$(dirname "$0")"
export CARGO_TERM_COLOR=never
target=${CARGO_TARGET_DIR:-$PWD/target}
out=$target/c
mkdir -p "$out"

cargo clippy --quiet --locked --all-targets -- -D warnings
cargo test --quiet --locked

# Does it say what Rust says? Optimised and not, and as C++.
cargo build --quiet --release --locked
library=$target/release/libcarom_c.a
cargo run --quiet --release --locked --example tilt_box >"$out/rust.txt"
strict=(-Iinclude -Wall -Wextra -Wpedantic -Wconversion -Werror)
cc "${strict[@]}" -std=c11 -O0 -g -fsanitize=address,undefined demo/tilt_box.c "$library" -lm -o "$out/tilt_box"
"$out/tilt_box" | diff "$out/rust.txt" -
c++ "${strict[@]}" -std=c++11 -O3 -march=native -x c++ demo/tilt_box.c -x none "$library" -lm -o "$out/tilt_box"
"$out/tilt_box" | diff "$out/rust.txt" -
cc "${strict[@]}" -std=c11 -g -fsanitize=address,undefined demo/bad_input.c "$library" -lm -o "$out/bad_input"
"$out/bad_input"

# Does Miri find undefined behaviour in the unsafe blocks? It comes with a nightly toolchain.
if cargo +nightly --version >/dev/null 2>&1; then
  cargo +nightly miri --version >/dev/null 2>&1 ||
    rustup component add --toolchain nightly miri rust-src >/dev/null 2>&1 || true
fi
if cargo +nightly miri --version >/dev/null 2>&1; then
  # A target for which libm has no assembler, which Miri does not know; its pointers have 32 bits, as firmware's.
  # Runs of the engine, which is safe code, would take it hours: those tests that run little of it.
  MIRIFLAGS=-Zmiri-strict-provenance cargo +nightly miri test --quiet --locked --test calls \
    --target armv7-unknown-linux-gnueabihf -- a_snapshot_goes_on a_world_takes codes_have
else
  echo "no nightly toolchain with Miri: its tests were not run" >&2
fi

[[ $# -eq 0 ]] || ./arduino/check.sh "$1" "$out"
