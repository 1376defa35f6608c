#!/usr/bin/env bash
# How is the page made? Reads page/ and src/; writes dist/: static files for any file server.
# Needs a stable Rust toolchain with the target wasm32-unknown-unknown (rustup target add wasm32-unknown-unknown).
# Where that target cannot be had, Debian's rustc-web (same compiler, with its library's source) builds it.
# Where there is npm, binaryen's wasm-opt makes the modules smaller.
set -euo pipefail
cd "$(dirname "$0")"
target=wasm32-unknown-unknown
out=${CARGO_TARGET_DIR:-target}/$target/release/carom_web.wasm

if [ -d "$(rustc --print target-libdir --target $target)" ]; then
  build=(cargo build)
else
  if ! dpkg -s rustc-web cargo-web rust-web-src >/dev/null 2>&1; then
    apt-get update -qq
    apt-get install -qq -y --no-install-recommends rustc-web cargo-web rust-web-src >/dev/null
  fi
  PATH=$(rustc --print sysroot)/lib/rustlib/$(rustc --print host-tuple)/bin:$PATH # rust-lld
  RUSTC=$(dpkg -L rustc-web | grep 'bin/rustc$')
  export PATH RUSTC RUSTC_BOOTSTRAP=1
  build=("$(dpkg -L cargo-web | grep 'bin/cargo$' | head -1)" build -Zbuild-std=core,panic_abort)
fi

wasm_opt=node_modules/.bin/wasm-opt
[ -e $wasm_opt ] || ! command -v npm >/dev/null || npm ci --silent --no-audit --no-fund
# The features that rustc uses for this target, and that of .cargo/config.toml.
features=(bulk-memory mutable-globals multivalue nontrapping-float-to-int reference-types sign-ext simd)
optimise() { # from, to
  if [ -e $wasm_opt ]; then
    $wasm_opt -Oz "${features[@]/#/--enable-}" "$1" -o "$2"
  else
    cp "$1" "$2"
  fi
}

rm -rf dist
mkdir dist
cp page/* dist/
# Small and fast (s); the plane, whose 500 grains have to keep up with the screen, fast above all (3); where grains are
# rough 2 is as fast as 3.
for module in line:s:200 plane:3:240 space:s:210 rough:2:270; do
  IFS=: read -r dimension level kib <<<"$module"
  "${build[@]}" --release --locked --quiet --target $target --features "$dimension" \
    --config "profile.release.opt-level=${level/s/\"s\"}"
  module=dist/carom-$dimension.wasm
  optimise "$out" "$module"
  printf 'carom-%s.wasm: %s bytes of at most %s (opt-level %s)\n' \
    "$dimension" "$(stat -c %s "$module")" $((kib * 1024)) "$level"
done
