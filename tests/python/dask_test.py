"""The example dask_metrics.py: a worker that is killed in the middle of a run loses nothing."""

import csv
import os
import signal
import subprocess
import sys
import tempfile
import pathlib
import time
import unittest

import generated_body
from pelt import datasets
from support import SOURCE, Case, skip_program

try:
    import distributed
except ImportError:
    skip_program("no Dask (package python3-distributed)")

EXAMPLE = SOURCE / "bindings" / "python" / "examples" / "dask_metrics.py"
CLIPS = 24


def read_rows(path):
    with open(path, newline="") as file:
        return sorted(csv.DictReader(file), key=lambda row: row["clip"])


def workers_of(process):
    """Returns the processes of workers, which are children of the example's children."""
    found = []
    for entry in pathlib.Path("/proc").iterdir():
        try:
            parent = int((entry / "stat").read_text().rsplit(")", 1)[1].split()[1])
            command = (entry / "cmdline").read_bytes()
        except (OSError, IndexError, ValueError):
            continue
        if parent == process.pid and b"spawn_main" in command:
            found.append(int(entry.name))
    return found


class Killed(Case):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.data = self.root / "data"
        self.body = generated_body.save_body(self.root / "body.npz")
        for seed in range(CLIPS):
            generated_body.save_motion(self.data / f"{seed}.npz",
                                       generated_body.motion_keys(frames=40, seed=seed))

    def start(self, table, body=None, *scheduler):
        environment = {**os.environ, "DASK_DISTRIBUTED__DASHBOARD__LINK": "",
                       "DASK_TEMPORARY_DIRECTORY": str(self.root)}
        return subprocess.Popen([sys.executable, "-B", EXAMPLE, self.data, body or self.body, table,
                                 *scheduler], cwd=self.root, env=environment, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True)

    def wait_for_rows(self, process, table, count):
        while process.poll() is None:
            if table.exists() and table.read_bytes().count(b"\n") > count:
                return
            time.sleep(0.01)

    def test_worker(self):
        measure = datasets.Measurement(self.data, self.body)
        (self.data / "broken.npz").write_bytes(b"PK")
        table = self.root / "table.csv"
        process = self.start(table)
        self.wait_for_rows(process, table, 3)
        workers = workers_of(process)
        self.assertGreater(len(workers), 0)
        os.kill(workers[0], signal.SIGKILL)
        rows_then = len(read_rows(table))
        output, errors = process.communicate(timeout=240)
        self.assertLess(rows_then, CLIPS)
        self.assertEqual(process.returncode, 1, errors)
        self.assertIn(f"{CLIPS} clips measured, 1 failed", output)
        self.assertIn("failed: broken.npz", errors)
        alone = self.root / "alone.csv"
        with datasets.Table(alone, measure) as serial:
            for clip in datasets.find_clips(self.data):
                if clip != "broken.npz":
                    serial.append(measure(clip))
        self.assertEqual(read_rows(table), read_rows(alone))

    def test_whole_run(self):
        table = self.root / "table.csv"
        process = self.start(table)
        self.wait_for_rows(process, table, 3)
        process.kill()
        process.communicate()
        before = table.read_bytes()
        before = before[:before.rfind(b"\n") + 1]
        self.assertLess(before.count(b"\n"), CLIPS)
        again = self.start(table)
        _, errors = again.communicate(timeout=240)
        self.assertEqual(again.returncode, 0, errors)
        self.assertTrue(table.read_bytes().startswith(before))
        self.assertEqual(len({row["clip"] for row in read_rows(table)}), CLIPS)

    def test_clips_that_have_changed(self):
        measure = datasets.Measurement(self.data, self.body)
        table = self.root / "table.csv"
        with datasets.Table(table, measure) as earlier:
            for clip in datasets.find_clips(self.data):
                earlier.append(measure(clip))
        generated_body.save_motion(self.data / "7.npz", generated_body.motion_keys(seed=99))
        output, errors = self.start(table).communicate(timeout=240)
        self.assertIn("1 clips measured, 0 failed", output, errors)
        self.assertEqual([row["frames"] for row in read_rows(table)].count("6"), 1)
        self.assertEqual(len(read_rows(table)), CLIPS)

    def test_two_runs_on_one_scheduler(self):
        """Dask gives equal keys of two programs one result, so the keys must differ."""
        tall = generated_body.save_body(self.root / "tall.npz",
                                        v_template=1.2 * generated_body.arrays()["v_template"])
        runs = [(self.root / "table.csv", self.body), (self.root / "tall.csv", tall)]
        with distributed.LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None,
                                      local_directory=str(self.root)) as cluster:
            programs = [self.start(table, body, cluster.scheduler_address) for table, body in runs]
            errors = [program.communicate(timeout=240)[1] for program in programs]
        self.assertEqual([program.returncode for program in programs], [0, 0], errors)
        for table, body in runs:
            self.assertEqual({row["body_model"] for row in read_rows(table)}, {body.name})
            self.assertEqual(len(read_rows(table)), CLIPS)


if __name__ == "__main__":
    unittest.main()
