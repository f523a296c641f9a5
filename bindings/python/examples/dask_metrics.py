"""Metrics of a folder of clips on the workers of Dask: dask_metrics.py DIR BODY_MODEL TABLE [SCHEDULER]

Workers read the clips themselves, so each machine needs the folder and the body model at the same
path. If a worker is lost, Dask gives its clips to others. If this program is lost, it goes on where it
ended when it is started again.
"""

import os
import sys

from distributed import Client, as_completed

from pelt import datasets


def main(folder: str, body_model: str, path: str, *scheduler: str) -> int:
    # One thread for each clip: Dask runs as many clips at once as there are processors.
    measure = datasets.Measurement(folder, body_model, threads=1)
    failed = 0
    local = {} if scheduler else {"n_workers": os.cpu_count(), "threads_per_worker": 1}
    with datasets.Table(path, measure) as table, Client(*scheduler, **local) as client:
        if table.changed:
            print(f"{len(table.changed)} clips have changed; {table.copy} has their rows", file=sys.stderr)
        clips = [clip for clip in datasets.find_clips(folder) if clip not in table.done]
        # Programs that share a scheduler share the results of equal keys.
        keys = [f"{os.path.abspath(path)}: {clip}" for clip in clips]
        futures = dict(zip(client.map(measure, clips, key=keys, retries=3), clips))
        for future in as_completed(futures):
            if future.status == "finished":
                table.append(future.result())
            else:
                failed += 1
                print(f"failed: {futures[future]}: {future.exception()}", file=sys.stderr)
    print(f"{len(clips) - failed} clips measured, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) if len(sys.argv) in (4, 5) else __doc__)
