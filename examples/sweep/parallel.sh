#!/usr/bin/env bash
# How does GNU parallel spread a sweep? Writes the shards and the merged sweep.parquet.
#
# One line does it; with --sshloginfile hosts and a shared folder, over as many machines as there are.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
OUT=${OUT:-$here/sweep.parquet} N=${N:-8}
export OUT
parallel --halt now,fail=1 "$here/one_shard.sh" {} "$N" ::: $(seq "$N")
"${CAROM:-carom}" merge "${OUT%.parquet}".*-of-"$N".parquet --out "$OUT"
