#!/usr/bin/env bash
# How is carom packed for npm? Reads dist/ (build.sh makes it) and npm.json; writes carom-VERSION.tgz, or where it is told.
# Usage: package.sh [FOLDER]. Needs npm.
set -euo pipefail
cd "$(dirname "$0")"
into=$(realpath "${1:-.}")
[ -e dist/carom-plane.wasm ] || ./build.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp dist/carom.js dist/carom.d.ts dist/carom-{line,plane,rough,space}.wasm ../../LICENSE-{MIT,APACHE} "$work"
cp NPM.md "$work/README.md"
# The version is that of the Rust package.
version=$(sed -n 's/^version = "\(.*\)"/\1/p' ../../Cargo.toml | head -1)
node -e 'const [from, to, version] = process.argv.slice(1), fs = require("node:fs");
  const { name, ...rest } = JSON.parse(fs.readFileSync(from));
  fs.writeFileSync(to, JSON.stringify({ name, version, ...rest }, null, 2));' npm.json "$work/package.json" "$version"
(cd "$work" && npm pack --silent --pack-destination "$into")
