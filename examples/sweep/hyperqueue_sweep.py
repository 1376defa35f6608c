"""How does HyperQueue spread a sweep? Starts a local cluster, runs the shards as tasks, merges them.

pip install hyperqueue; python hyperqueue_sweep.py [CAROM] [OUT.parquet] [SHARDS]
On real machines replace LocalCluster by a server (`hq server start`) and its workers, and connect
with Client().
"""

import pathlib
import subprocess
import sys

from hyperqueue import Job, LocalCluster
from hyperqueue.cluster import WorkerConfig

HERE = pathlib.Path(__file__).resolve().parent


def main(carom="carom", out=HERE / "sweep.parquet", shards=8):
    """Runs sweep.toml in that many shards and merges them into `out`."""
    out, shards = pathlib.Path(out).resolve(), int(shards)
    job = Job(max_fails=0)
    for i in range(1, shards + 1):
        job.program(
            [str(HERE / "one_shard.sh"), str(i), str(shards)],
            env={"CAROM": str(carom), "OUT": str(out)},
            stdout=None,
            stderr=out.with_suffix(f".{i}-of-{shards}.log"),
        )
    with LocalCluster() as cluster:
        cluster.start_worker(WorkerConfig())
        client = cluster.client()
        client.wait_for_jobs([client.submit(job)])
    for log in out.parent.glob(f"{out.stem}.*-of-{shards}.log"):
        if log.stat().st_size == 0:
            log.unlink()
    parts = [out.with_suffix(f".{i}-of-{shards}.parquet") for i in range(1, shards + 1)]
    subprocess.run([carom, "merge", *parts, "--out", out], check=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
