#!/usr/bin/env bash
# Which part is mine? Called as one_shard.sh I N by whatever schedules it; writes OUT.I-of-N.parquet.
#
# One thread, because the scheduler hands out the cores. A part that was killed goes on when it is
# called again.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
exec "${CAROM:-carom}" sweep "${SWEEP:-$here/sweep.toml}" --out "${OUT:-$here/sweep.parquet}" \
    --shard "$1/$2" --threads 1
