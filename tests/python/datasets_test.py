"""pelt.datasets and `python -m pelt metrics`: tables of folders, bad files, resumed and killed runs."""

import contextlib
import csv
import io
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import types
import unittest
import unittest.mock

import numpy as np

import generated_body
import pelt
from pelt import _command, body_models, datasets, metrics, motions
from support import Case


def run_command(*arguments):
    """Runs the command in this process, which is much faster than in a new one."""
    output, errors = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
        try:
            status = _command.main([str(argument) for argument in arguments])
        except SystemExit as exit:
            status = exit.code
    return types.SimpleNamespace(returncode=status, stdout=output.getvalue(), stderr=errors.getvalue())


def read_rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


class Folder(Case):
    clips = ("a/run.npz", "a/walk.npz", "b/jump, high.npz", "b/sit.npz")

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.data, self.table = self.root / "data", self.root / "table.csv"
        self.body = generated_body.save_body(self.root / "body.npz")
        for seed, clip in enumerate(self.clips):
            generated_body.save_motion(self.data / clip, generated_body.motion_keys(seed=seed))

    def command(self, *more):
        return run_command("metrics", self.data, "--out", self.table, "--body-model", self.body, *more)


class Clips(Folder):
    def test_find_clips(self):
        for name in ("a/shape.npz", "a/female_stagei.npz", "a/notes.txt"):
            (self.data / name).write_bytes(b"")
        (self.data / "b/old.pkl").write_bytes(b"")
        self.assertEqual(datasets.find_clips(self.data), sorted([*self.clips, "b/old.pkl"]))
        self.refuses("nowhere: not a folder", datasets.find_clips, "nowhere")

    def test_row_is_that_of_the_metrics(self):
        row = datasets.Measurement(self.data, self.body)("a/walk.npz")
        motion = motions.load(self.data / "a/walk.npz")
        subject = body_models.load(self.body).subject(motion.betas)
        poses = subject.poses(motion)
        percent = metrics.colliding_triangles(subject.model, poses).percent
        volume, error = metrics.self_intersection_volume(subject.model, poses)
        kept = metrics.smplify_x_filter(subject.model, subject.body.parents)
        filtered = metrics.colliding_triangles(subject.model, poses, kept).pairs
        self.assertEqual(row["colliding_mean"], percent.mean())
        self.assertEqual(row["colliding_max"], percent.max())
        self.assertEqual(row["colliding_frame"], percent.argmax())
        self.assertEqual(row["filtered_mean"], filtered.mean())
        self.assertLess(0, filtered.sum())
        self.assertEqual((row["volume_max"], row["volume_error"]), (volume.max(), error.max()))
        self.assertEqual((row["frames"], row["fps"], row["gender"]), (6, 120.0, "male"))

    def test_each_metric_alone_is_the_same(self):
        row = datasets.Measurement(self.data, self.body)("a/walk.npz")
        for name in datasets.METRICS:
            measure = datasets.Measurement(self.data, self.body, [name])
            alone = measure("a/walk.npz")
            self.assertEqual(set(alone), set(measure.columns))
            self.assertEqual({key: row[key] for key in alone}, alone)

    def test_chunks_do_not_change_the_row(self):
        measure = datasets.Measurement(self.data, self.body, ["colliding", "contact"])
        whole = measure("a/walk.npz")
        with unittest.mock.patch("pelt.datasets._measurement.AT_A_TIME", 4):
            self.assertEqual(measure("a/walk.npz"), whole)

    def test_every(self):
        row = datasets.Measurement(self.data, self.body, ["colliding"], every=5)("a/walk.npz")
        self.assertEqual((row["frames"], row["colliding_frame"]), (2, 5))

    def test_open_body_has_no_volume(self):
        faces = generated_body.arrays()["f"][1:]
        open_body = generated_body.save_body(self.root / "open.npz", f=faces)
        row = datasets.Measurement(self.data, open_body, ["volume"])("a/walk.npz")
        self.assertEqual((row["volume_mean"], row["volume_error"]), ("", ""))

    def test_close_holes(self):
        faces = generated_body.arrays()["f"][1:]  # the hole is a triangle
        open_body = generated_body.save_body(self.root / "open.npz", f=faces)
        row = datasets.Measurement(self.data, open_body, ["volume"], close_holes=True)("a/walk.npz")
        whole = datasets.Measurement(self.data, self.body, ["volume"])("a/walk.npz")
        self.assertEqual((row["options"], whole["options"]), ("close-holes", ""))
        self.assertLess(0, whole["volume_max"])
        self.assertAlmostEqual(row["volume_max"], whole["volume_max"], delta=1e-6)

    def test_fps(self):
        generated_body.save_motion(self.data / "still.npz", mocap_framerate=None)
        self.refuses("still.npz: mocap_framerate: missing.*--fps",
                     datasets.Measurement(self.data, self.body), "still.npz")
        measure = datasets.Measurement(self.data, self.body, ["colliding"], fps=30)
        rows = [measure(clip) for clip in ("still.npz", "a/walk.npz")]
        self.assertEqual([row["fps"] for row in rows], [30, 120])
        self.assertEqual(rows[0]["seconds"], 6 / 30)
        generated_body.save_motion(self.data / "two.npz", mocap_frame_rate=np.array(60.0))
        self.refuses("two.npz: mocap_framerate: is 120.0, but mocap_frame_rate is 60.0: .*--fps", measure,
                     "two.npz")
        self.assertEqual(datasets.Measurement(self.data, self.body, ["colliding"], fps=60)("two.npz")["fps"],
                         60)
        self.refuses("fps: expected a positive", datasets.Measurement, self.data, self.body, fps=0)

    def test_genders(self):
        self.refuses("gender: no body model for 'male': add `--body-model male=FILE`",
                     datasets.Measurement(self.data, {"female": self.body}), "a/walk.npz")

    def test_betas(self):
        few = generated_body.save_body(self.root / "few.npz",
                                       shapedirs=generated_body.arrays()["shapedirs"][:, :, :10])
        self.refuses("walk.npz: betas: 16 shape parameters, but .*few.npz has 10: .*--betas 10",
                     datasets.Measurement(self.data, few), "a/walk.npz")
        rows = [datasets.Measurement(self.data, body, ["volume"], betas=10)("a/walk.npz")
                for body in (few, self.body)]
        self.assertEqual(rows[0]["volume_max"], rows[1]["volume_max"])
        self.assertEqual(rows[0]["options"], "betas=10")
        shapes = {datasets.Measurement(self.data, self.body, ["volume"], betas=betas)("a/walk.npz")
                  ["volume_max"] for betas in (0, 10, None)}
        self.assertEqual(len(shapes), 3)

    def test_shapes_that_overflow(self):
        """The message names the clip and the body model, one of which is at fault."""
        directions = generated_body.arrays()["shapedirs"].copy()
        directions[0, 0, 0] = 1e18
        body = generated_body.save_body(self.root / "wide.npz", shapedirs=directions)
        generated_body.save_motion(self.data / "a/walk.npz", betas=np.full(16, 9.0))
        self.refuses("walk.npz: .*wide.npz: betas: vertex 0 of this shape is at .*: use smaller",
                     datasets.Measurement(self.data, body), "a/walk.npz")

    def test_triangles_that_face_inwards(self):
        """Their self-intersection would be the whole body."""
        faces = generated_body.arrays()["f"][:, ::-1]
        body = generated_body.save_body(self.root / "inwards.npz", f=faces)
        self.refuses(r"inwards.npz: f: the triangles face inwards, .*: save f\[:, ::-1\]",
                     datasets.Measurement, self.data, body)
        row = datasets.Measurement(self.data, body, ["colliding"])("a/walk.npz")
        self.assertEqual(row["colliding_max"],
                         datasets.Measurement(self.data, self.body, ["colliding"])("a/walk.npz")
                         ["colliding_max"])
        holes = np.delete(generated_body.arrays()["f"], [5, 70], axis=0)
        datasets.Measurement(self.data, generated_body.save_body(self.root / "open.npz", f=holes))

    def test_body_model_that_is_replaced(self):
        """In a notebook, the same process measures with the old file and with the new one."""
        def volume():
            return datasets.Measurement(self.data, self.body, ["volume"])("a/walk.npz")["volume_max"]
        old = volume()
        keys = generated_body.arrays()
        generated_body.save_body(self.body, v_template=2 * keys["v_template"])
        self.assertGreater(volume(), 4 * old)

    def test_row_of_another_measurement(self):
        """Programs that collect rows of workers may mix them up."""
        few = datasets.Measurement(self.data, self.body, ["colliding"], every=2)
        with datasets.Table(self.table, datasets.Measurement(self.data, self.body, ["colliding"])) as table:
            self.refuses("table.csv: the row of a/walk.npz is of another measurement", table.append,
                         few("a/walk.npz"))
            self.assertEqual(table.done, set())
        self.assertEqual(read_rows(self.table), [])

    def test_without_betas(self):
        """The mean shape is a decision, not a default."""
        generated_body.save_motion(self.data / "a/walk.npz", betas=None)
        self.refuses("walk.npz: betas: missing: .*--betas 0.* mean shape",
                     datasets.Measurement(self.data, self.body), "a/walk.npz")
        row = datasets.Measurement(self.data, self.body, ["colliding"], betas=0)("a/walk.npz")
        self.assertEqual(row["options"], "betas=0")

    def test_refused(self):
        self.refuses("betas: expected 0", datasets.Measurement, self.data, self.body, betas=-1)
        self.refuses("metrics: unknown 'depth'", datasets.Measurement, self.data, self.body, ["depth"])
        self.refuses("every: expected 1", datasets.Measurement, self.data, self.body, every=0)


class Command(Folder):
    def test_module(self):
        result = subprocess.run([sys.executable, "-B", "-m", "pelt", "--help"], capture_output=True,
                                text=True)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("metrics", result.stdout)

    def test_all_clips(self):
        result = self.command()
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("4 clips measured, 0 failed", result.stdout)
        rows = read_rows(self.table)
        self.assertEqual([row["clip"] for row in rows], list(self.clips))
        self.assertTrue(all(float(row["filtered_max"]) > 0 for row in rows))

    def test_bad_files_are_listed(self):
        (self.data / "a/broken.npz").write_bytes((self.data / "a/run.npz").read_bytes()[:5000])
        (self.data / "a/model.pkl").write_bytes(b"")
        generated_body.save_motion(self.data / "b/wide.npz", poses=np.zeros((6, 165)))
        failed = self.root / "failed.csv"
        failed.write_text("an earlier run\n")
        result = self.command("--failed", failed)
        self.assertEqual(result.returncode, 1)
        self.assertIn("4 clips measured, 3 failed", result.stdout)
        self.assertEqual([row["clip"] for row in read_rows(failed)],
                         ["a/broken.npz", "a/model.pkl", "b/wide.npz"])
        for row in read_rows(failed):
            self.assertIn(f"failed: {row['reason']}", result.stderr)
        for reason in ("broken.npz: not a complete .npz file", "model.pkl: pickled files can run",
                       "wide.npz: motion: has poses of 55 joints", "`--body-only`"):
            self.assertIn(reason, result.stderr)
        self.assertEqual(len(read_rows(self.table)), 4)

    def test_a_log_has_a_line_each_minute(self):
        with unittest.mock.patch("pelt._command._SECONDS_BETWEEN_LINES", 0):
            lines = self.command("--metrics", "colliding").stderr.splitlines()
        self.assertEqual(lines[0], "0 of 4 clips, 0 failed  a/run.npz")
        self.assertEqual(len(lines), 5)

    def test_resumes(self):
        self.command()
        whole = self.table.read_bytes()
        for cut in (0, 3, whole.index(b"\n") + 1, len(whole) - 1, len(whole) - 90):
            self.table.write_bytes(whole[:cut])
            result = self.command()
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.assertEqual(self.table.read_bytes(), whole)
        self.assertIn("0 clips measured, 4 were there before", self.command().stdout)

    def test_other_measurements_are_refused(self):
        self.command("--metrics", "colliding")
        for more, message in [(("--metrics", "contact"), "has other columns"),
                              (("--metrics", "colliding", "--every", 2), "row 2 is of another"),
                              (("--metrics", "colliding", "--betas", 3), "row 2 is of another"),
                              (("--metrics", "colliding", "--body-only"), "row 2 is of another")]:
            result = self.command(*more)
            self.assertEqual(result.returncode, 2)
            self.assertIn(message, result.stderr)
        self.assertEqual(len(read_rows(self.table)), 4)

    def test_rows_of_another_body_model_are_refused(self):
        """A body model for women that is added later must not leave their rows as they are."""
        generated_body.save_motion(self.data / "a/woman.npz", gender=np.array("female"))
        other = generated_body.save_body(self.root / "other.npz")
        self.command("--metrics", "colliding")
        result = self.command("--metrics", "colliding", "--body-model", f"female={other}")
        self.assertEqual(result.returncode, 2)
        self.assertIn("row 4 is of another measurement (other body models", result.stderr)
        result = self.command("--metrics", "colliding", "--body-model", f"neutral={other}")
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_body_models_of_one_name(self):
        """Those of SMPL-H are male/model.npz and female/model.npz."""
        generated_body.save_motion(self.data / "a/woman.npz", gender=np.array("female"))
        paths = {}
        for gender in ("male", "female"):
            (self.root / gender).mkdir()
            paths[gender] = generated_body.save_body(self.root / gender / "model.npz")
        measure = datasets.Measurement(self.data, paths, ["colliding"])
        self.assertEqual([measure(f"a/{clip}.npz")["body_model"] for clip in ("walk", "woman")],
                         ["male/model.npz", "female/model.npz"])
        with datasets.Table(self.table, measure) as table:
            table.append(measure("a/woman.npz"))
        swapped = {"male": paths["female"], "female": paths["male"]}
        self.refuses("row 2 is of another measurement", datasets.Table, self.table,
                     datasets.Measurement(self.data, swapped, ["colliding"]))

    def test_shards_are_the_whole(self):
        self.command("--metrics", "colliding")
        whole = read_rows(self.table)
        parts = []
        for shard in (1, 2, 3):
            self.table = self.root / f"table-{shard}.csv"
            self.command("--metrics", "colliding", "--shard", f"{shard}/3", "--threads", 1)
            parts += read_rows(self.table)
        self.assertEqual(sorted(parts, key=lambda row: row["clip"]), whole)

    def test_killed_run_loses_one_clip_at_most(self):
        for seed in range(12):
            generated_body.save_motion(self.data / f"c/{seed}.npz",
                                       generated_body.motion_keys(seed=seed))
        arguments = [sys.executable, "-B", "-m", "pelt", "metrics", self.data, "--out", self.table,
                     "--body-model", self.body, "--metrics", "colliding"]
        process = subprocess.Popen(arguments, stdout=subprocess.DEVNULL)
        while process.poll() is None and not (self.table.exists() and len(read_rows(self.table)) >= 3):
            time.sleep(0.01)
        process.send_signal(signal.SIGKILL)
        process.wait()
        before = read_rows(self.table)
        self.assertEqual(self.command("--metrics", "colliding").returncode, 0)
        after = read_rows(self.table)
        self.assertEqual(len(after), 16)
        self.assertEqual([row for row in before if None not in row.values()], after[:len(before)])

    def test_one_process_at_a_time(self):
        measure = datasets.Measurement(self.data, self.body)
        with datasets.Table(self.table, measure):
            result = self.command()
        self.assertEqual(result.returncode, 2)
        self.assertIn("another process is writing this table", result.stderr)

    def test_invalid_arguments(self):
        for more in (("--shard", "0/2"), ("--shard", "3/2"), ("--shard", "two"), ("--every", "x"),
                     ("--every", "0"), ("--metrics", "nothing"), ("--body-model", "female=absent.npz"),
                     ("--failed", self.root / "no" / "folder.csv")):
            with self.subTest(more):
                self.assertEqual(self.command(*more).returncode, 2)
        self.assertEqual(run_command().returncode, 2)

    def test_help(self):
        self.assertIn("metrics", run_command("--help").stdout)
        text = run_command("metrics", "--help").stdout
        for word in (*datasets.METRICS, "--shard", "examples:", "exit status"):
            self.assertIn(word, text)


if __name__ == "__main__":
    unittest.main()
