#!/usr/bin/env bash
# How does Slurm spread a sweep? sbatch slurm.sh; then carom merge as the last line says.
#SBATCH --job-name=carom-sweep
#SBATCH --array=1-8
#SBATCH --cpus-per-task=1
#SBATCH --time=01:00:00
#SBATCH --requeue
#
# A task that is preempted and requeued goes on where it stopped. Slurm runs a copy of this script,
# so the folder is the one in which sbatch was called.
set -euo pipefail
here=${SLURM_SUBMIT_DIR:-$PWD}
"$here/one_shard.sh" "$SLURM_ARRAY_TASK_ID" "$SLURM_ARRAY_TASK_COUNT"

# When all tasks are done (sbatch --dependency=afterok:JOB --wrap '...'):
#   carom merge sweep.*-of-8.parquet --out sweep.parquet
