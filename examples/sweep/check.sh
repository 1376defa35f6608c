#!/usr/bin/env bash
# Is the merged file the same however the sweep is spread? Runs it by one process, HyperQueue, GNU
# parallel, the Slurm script and with kills; writes to a temporary folder, compares byte for byte.
#
#   CAROM=target/release/carom examples/sweep/check.sh
#
# What is not installed (python3 with hyperqueue, parallel) is left out, and said to be.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
CAROM=$(realpath "${CAROM:-$(command -v carom)}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export CAROM
cp "$here"/*.sh "$here"/*.toml "$here"/*.py "$folder"
cd "$folder"
"$CAROM" sweep sweep.toml --out one.parquet >/dev/null

same() { cmp one.parquet "$1" && echo "$2: the same bytes"; }

if python3 -c 'import hyperqueue' 2>/dev/null; then
    python3 hyperqueue_sweep.py "$CAROM" hq.parquet 8 >/dev/null 2>hq.log || { cat hq.log; exit 1; }
    same hq.parquet "200 runs over HyperQueue, 8 shards"
else
    echo "HyperQueue: left out (pip install hyperqueue)"
fi

if command -v parallel >/dev/null; then
    OUT=$folder/parallel.parquet N=5 ./parallel.sh >/dev/null
    same parallel.parquet "GNU parallel, 5 shards"
else
    echo "GNU parallel: left out"
fi

for task in 3 1 4 2; do
    OUT=$folder/slurm.parquet SLURM_SUBMIT_DIR=$folder SLURM_ARRAY_TASK_ID=$task \
        SLURM_ARRAY_TASK_COUNT=4 ./slurm.sh >/dev/null
done
"$CAROM" merge slurm.*-of-4.parquet --out slurm.parquet >/dev/null
same slurm.parquet "the Slurm script as its tasks see it, 4 shards"

# The shell reports each kill on its standard error.
kills=0
{
    while ! timeout --signal=KILL 0.1 "$CAROM" sweep sweep.toml --out killed.parquet --threads 1 >/dev/null; do
        kills=$((kills + 1))
        [ "$kills" -lt 1000 ] || exit 1
    done
} 2>/dev/null
same killed.parquet "killed $kills times"
