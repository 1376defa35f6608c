#!/usr/bin/env bash
# Does carom work from Python? Makes the wheel in a new environment, checks types and stubs, runs tests and notebooks.
# Needs Python 3.11 or later with venv, a Rust toolchain and PyPI; writes to target/ here.
set -euo pipefail
cd "$(dirname "$0")"
export CARGO_TERM_COLOR=never CARGO_INCREMENTAL=0

cargo fmt --check
cargo metadata --locked --format-version 1 >/dev/null
# The program whose digests and words the package must have: built already where the workspace was.
cargo build --quiet --release --locked --manifest-path ../../Cargo.toml -p carom-host

rm -rf target/venv
python3 -m venv target/venv
# One build for lints and wheel: cargo gives this package to clippy, which compiles as rustc does, and warnings are errors.
# (Clippy splits its arguments at that word.)
RUSTC_WORKSPACE_WRAPPER=clippy-driver CLIPPY_ARGS="-D__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__" \
  target/venv/bin/pip install --quiet --disable-pip-version-check ".[test]"

CAROM=$(cargo metadata --format-version 1 --no-deps --manifest-path ../../Cargo.toml |
  sed -n 's/.*"target_directory":"\([^"]*\)".*/\1/p')/release/carom
export CAROM
# Away from here, so that the installed package is what is tested.
here=$PWD
cd target
venv/bin/python -m mypy --strict -p carom
venv/bin/python -m mypy.stubtest carom
MYPYPATH=$here/tests venv/bin/python -m mypy --strict "$here/tests"
venv/bin/python -m pytest -q -p no:cacheprovider "$here/tests"
