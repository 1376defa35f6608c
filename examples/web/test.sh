#!/usr/bin/env bash
# Does the page work? Builds dist/ (not with --built), checks types, tests the API in Node and the page in Chromium.
# Needs what build.sh needs, Node 20, and Chromium (Debian's, where there is none); npm fetches what tests need.
set -euo pipefail
cd "$(dirname "$0")"
[[ ${1:-} == --built ]] || ./build.sh
[ -e node_modules/.bin/tsc ] || npm ci --silent --no-audit --no-fund
if ! command -v chromium >/dev/null; then
  apt-get update -qq
  apt-get install -qq -y --no-install-recommends chromium >/dev/null
fi
npx tsc
node --test --test-concurrency=1 test/*.test.js
