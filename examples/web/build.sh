#!/usr/bin/env bash
# How is the page made? Reads page/ and src/; writes dist/: static files for any file server.
# Needs a stable Rust toolchain with the target wasm32-unknown-unknown (rustup target add wasm32-unknown-unknown).
# Where that target cannot be had, Debian's rustc-web (same compiler, with its library's source) builds it.
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

rm -rf dist
mkdir dist
cp page/* dist/
for dimension in line plane space; do
  # Three dimensions are the largest copy of the engine and no page's: for size above all.
  level=s && [ $dimension != space ] || level=z
  "${build[@]}" --release --locked --quiet --target $target --features $dimension \
    --config "profile.release.opt-level=\"$level\""
  cp "$out" dist/carom-$dimension.wasm
done
printf '%s: %s bytes, of at most 153600\n' $(stat -c '%n %s' dist/*.wasm)
