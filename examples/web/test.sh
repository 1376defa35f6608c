#!/usr/bin/env bash
# Does the page work? Builds dist/, checks types, tests the API in Node and the page in Chromium; writes screenshots/.
# Needs what build.sh needs, Node 20, and Chromium (Debian's, where there is none); npm fetches what tests need.
set -euo pipefail
cd "$(dirname "$0")"
./build.sh
[ -e node_modules/.bin/tsc ] || npm ci --silent --no-audit --no-fund
if ! command -v chromium >/dev/null; then
  apt-get update -qq
  apt-get install -qq -y --no-install-recommends chromium >/dev/null
fi
npx tsc
node --test --test-concurrency=1 test/*.test.js
node test/screenshots.js
