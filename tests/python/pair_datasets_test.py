"""Tables of pairs of clips: which clips are pairs, their rows, `python -m pelt metrics` for pairs."""

import pathlib
import pickle
import tempfile
import unittest
import unittest.mock

import numpy as np

import generated_body
import pelt
from datasets_test import read_rows, run_command
from pelt import body_models, datasets, metrics, motions
from support import Case

# Where the second person stands: their arms reach the first one, who is met, missed, or far away.
STEPS = np.array([0.1, 0.35, 0.6, 0.9, 1.4, 5.0])


def person(path, seed, apart, **changes):
    """Writes a motion of a person who steps away from the origin."""
    keys = generated_body.motion_keys(seed=seed)
    keys["trans"] = np.stack([apart, 0 * apart, 0 * apart], axis=1)
    return generated_body.save_motion(path, keys, **changes)


class Folder(Case):
    pairs = [("a/P1.npz", "a/P2.npz"), ("b/P1.npz", "b/P2.npz"), ("c/P1.npz", "c/P2.npz")]

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.data, self.table = self.root / "data", self.root / "table.csv"
        self.body = generated_body.save_body(self.root / "body.npz")
        for seed, (first, second) in enumerate(self.pairs):
            person(self.data / first, seed, np.zeros(6))
            person(self.data / second, seed + 10, STEPS)

    def command(self, *more):
        return run_command("metrics", self.data, "--out", self.table, "--body-model", self.body, *more)

    def of_pairs(self, *more):
        return self.command("--pair-words", "P1,P2", *more)


class Names(Folder):
    def touch(self, *names):
        for name in names:
            (self.data / name).parent.mkdir(parents=True, exist_ok=True)
            (self.data / name).write_bytes(b"")

    def test_words(self):
        self.touch("alone/P2.npz", "P1/x_P1.npz", "P1/x_P2.npz", "P10.npz", "aP1.npz", "other.npz")
        self.assertEqual(datasets.find_pairs(self.data, "P1", "P2"),
                         sorted([*self.pairs, ("alone/P1.npz", "alone/P2.npz"),
                                 ("P1/x_P1.npz", "P1/x_P2.npz")]))

    def test_folders(self):
        self.touch("person1/a.npz", "person2/a.npz", "person1/b.npz", "person2/b.npz")
        self.assertEqual(datasets.find_pairs(self.data, "person1", "person2"),
                         [("person1/a.npz", "person2/a.npz"), ("person1/b.npz", "person2/b.npz")])

    def test_words_are_no_patterns(self):
        self.touch("x/A.+.npz", "x/B.+.npz")
        self.assertEqual(datasets.find_pairs(self.data, "A.+", "B.+"), [("x/A.+.npz", "x/B.+.npz")])

    def test_refused_words(self):
        self.refuses("none of its 6 clips has the word 'L' or 'R'", datasets.find_pairs, self.data,
                     "L", "R")
        self.refuses("expected two different words", datasets.find_pairs, self.data, "P1", "P1")
        self.refuses("nowhere: not a folder", datasets.find_pairs, "nowhere", "P1", "P2")

    def read(self, text):
        path = self.root / "pairs.csv"
        path.write_text(text)
        return datasets.read_pairs(path)

    def test_lists(self):
        expected = [("a.npz", "b, c.npz"), ("d.npz", "a.npz")]
        self.assertEqual(self.read('a.npz,"b, c.npz"\n\nd.npz,a.npz\na.npz,"b, c.npz"\n'), expected)
        self.assertEqual(self.read('split,clip_b,clip_a\n1,"b, c.npz",a.npz\n2,a.npz,d.npz\n'), expected)

    def test_refused_lists(self):
        self.refuses("pairs.csv: row 2: expected two names", self.read, "a,b\na\n")
        self.refuses("pairs.csv: row 1: expected two names", self.read, "a,b,c\n")
        self.refuses("pairs.csv: row 3: expected two names", self.read, "clip_a,clip_b\na,b\n,b\n")
        self.refuses("pairs.csv: lists no pairs", self.read, "clip_a,clip_b\n")
        self.refuses("absent.csv: ", datasets.read_pairs, self.root / "absent.csv")


class Rows(Folder):
    def bodies(self, pair):
        result = []
        for clip in pair:
            motion = motions.load(self.data / clip)
            subject = body_models.load(self.body).subject(motion.betas)
            result += [subject.model, subject.poses(motion)]
        return result

    def test_row_is_that_of_the_metrics(self):
        row = datasets.PairMeasurement(self.data, self.body)(self.pairs[0])
        bodies = self.bodies(self.pairs[0])
        inside = metrics.vertices_inside(*bodies)
        volume, error = metrics.intersection_volume(*bodies)
        expected = {"touching": pelt.collide(*bodies).per_frame(),
                    "inside": 50 * (inside.fraction_a + inside.fraction_b),
                    "depth": metrics.depth(*bodies).per_frame,
                    "summed_depth": metrics.summed_depth(*bodies).per_frame, "volume": volume}
        for name, values in expected.items():
            with self.subTest(name):
                self.assertAlmostEqual(row[f"{name}_mean"], values.mean(), delta=1e-12)
                self.assertAlmostEqual(row[f"{name}_max"], values.max(), delta=1e-12)
                self.assertEqual(row[f"{name}_frame"], values.argmax())
                self.assertLess(0, row[f"{name}_percent"])
                self.assertLess(row[f"{name}_percent"], 100)
        self.assertEqual(row["volume_error"], error.max())
        penetration = metrics.penetration_frames(*bodies)
        self.assertEqual(row["inside_percent"], penetration.frame_percent)
        self.assertAlmostEqual(row["inside_mean"] / row["inside_percent"], penetration.penetration)
        self.assertEqual((row["frames"], row["fps"], row["gender_b"]), (6, 120.0, "male"))

    def test_each_metric_alone_is_the_same(self):
        row = datasets.PairMeasurement(self.data, self.body)(self.pairs[1])
        for name in datasets.PAIR_METRICS:
            measure = datasets.PairMeasurement(self.data, self.body, [name])
            alone = measure(self.pairs[1])
            self.assertEqual(set(alone), set(measure.columns))
            self.assertEqual({key: row[key] for key in alone}, alone)

    def test_chunks_do_not_change_the_row(self):
        measure = datasets.PairMeasurement(self.data, self.body)
        whole = measure(self.pairs[0])
        with unittest.mock.patch("pelt.datasets._pairs.AT_A_TIME", 4):
            chunked = measure(self.pairs[0])
        self.assertEqual(chunked, whole)

    def test_order_of_the_people_does_not_matter(self):
        measure = datasets.PairMeasurement(self.data, self.body)
        first, second = self.pairs[0]
        row, swapped = measure((first, second)), measure((second, first))
        for name in datasets.PAIR_METRICS:
            self.assertAlmostEqual(row[f"{name}_mean"], swapped[f"{name}_mean"], delta=1e-12)

    def test_every(self):
        row = datasets.PairMeasurement(self.data, self.body, ["touching"], every=5)(self.pairs[0])
        self.assertEqual((row["frames"], row["touching_frame"], row["touching_percent"]), (2, 0, 50))

    def test_open_bodies(self):
        open_body = generated_body.save_body(self.root / "open.npz", f=generated_body.arrays()["f"][1:])
        row = datasets.PairMeasurement(self.data, open_body)(self.pairs[0])
        self.assertLess(0, row["touching_max"])
        for name in ("inside", "depth", "summed_depth", "volume"):
            self.assertEqual({row[f"{name}_{kind}"] for kind in ("mean", "max", "frame", "percent")},
                             {""})
        self.assertEqual(row["volume_error"], "")
        closed = datasets.PairMeasurement(self.data, open_body, close_holes=True)(self.pairs[0])
        whole = datasets.PairMeasurement(self.data, self.body)(self.pairs[0])
        self.assertAlmostEqual(closed["volume_max"], whole["volume_max"], delta=1e-6)
        self.assertAlmostEqual(closed["depth_max"], whole["depth_max"], delta=1e-6)

    def test_each_person_has_a_body_model(self):
        person(self.data / "a/P2.npz", 10, STEPS, gender=np.array("female"))
        female = generated_body.save_body(self.root / "female.npz")
        row = datasets.PairMeasurement(self.data, {"male": self.body, "female": female},
                                       ["touching"])(self.pairs[0])
        self.assertEqual((row["body_model_a"], row["body_model_b"], row["gender_b"]),
                         ("body.npz", "female.npz", "female"))

    def test_pickled(self):
        measure = datasets.PairMeasurement(self.data, self.body, ["touching"])
        copy = pickle.loads(pickle.dumps(measure))
        self.assertEqual(copy(self.pairs[0]), measure(self.pairs[0]))

    def test_refused(self):
        measure = datasets.PairMeasurement(self.data, self.body)
        keys = generated_body.motion_keys(frames=5)
        generated_body.save_motion(self.data / "short.npz", keys)
        self.refuses("P1.npz has 6 frames, but .*short.npz has 5", measure, ("a/P1.npz", "short.npz"))
        person(self.data / "slow.npz", 1, STEPS, mocap_framerate=np.array(30.0))
        self.refuses("P1.npz has 120 frames per second, but .*slow.npz has 30", measure,
                     ("a/P1.npz", "slow.npz"))
        self.refuses("absent.npz", measure, ("a/P1.npz", "absent.npz"))
        generated_body.save_motion(self.data / "wide.npz", poses=np.zeros((6, 165)))
        self.refuses("P1.npz and .*wide.npz: motion: has poses of 55 joints", measure,
                     ("a/P1.npz", "wide.npz"))
        self.refuses("metrics: unknown 'contact'", datasets.PairMeasurement, self.data, self.body,
                     ["contact"])


class Command(Folder):
    def test_words(self):
        result = self.of_pairs()
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("3 pairs measured, 0 failed", result.stdout)
        rows = read_rows(self.table)
        self.assertEqual([(row["clip_a"], row["clip_b"]) for row in rows], self.pairs)
        self.assertTrue(all(float(row["touching_max"]) > 0 for row in rows))

    def test_list(self):
        pairs = self.root / "pairs.csv"
        pairs.write_text("a/P1.npz,a/P2.npz\na/P1.npz,b/P2.npz\n")
        result = self.command("--pairs", pairs, "--metrics", "touching")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual([row["clip_b"] for row in read_rows(self.table)], ["a/P2.npz", "b/P2.npz"])
        again = self.command("--pairs", self.table, "--metrics", "touching")
        self.assertIn("0 pairs measured, 2 were there before", again.stdout)

    def test_failed_pairs_are_listed(self):
        (self.data / "b/P2.npz").unlink()
        failed = self.root / "failed.csv"
        result = self.of_pairs("--failed", failed, "--metrics", "touching")
        self.assertEqual(result.returncode, 1)
        self.assertIn("2 pairs measured, 1 failed", result.stdout)
        row, = read_rows(failed)
        self.assertEqual((row["clip_a"], row["clip_b"]), self.pairs[1])
        self.assertIn(f"failed: {row['reason']}", result.stderr)
        self.assertIn("b/P2.npz", row["reason"])
        person(self.data / "b/P2.npz", 11, STEPS)
        result = self.command("--pairs", failed, "--metrics", "touching")
        self.assertIn("1 pairs measured, 2 were there before, 0 failed", result.stdout)

    def test_resumes(self):
        self.of_pairs("--metrics", "touching,depth")
        whole = self.table.read_bytes()
        for cut in (0, 3, whole.index(b"\n") + 1, len(whole) - 1, len(whole) - 90):
            self.table.write_bytes(whole[:cut])
            self.assertEqual(self.of_pairs("--metrics", "touching,depth").returncode, 0)
            self.assertEqual(self.table.read_bytes(), whole)

    def test_empty_columns_are_announced(self):
        generated_body.save_body(self.body, f=generated_body.arrays()["f"][2:])
        notice = "so its columns of depth, volume stay empty: close them with `--close-holes`"
        metrics = ("--metrics", "touching,depth,volume")
        self.assertIn(notice, self.of_pairs(*metrics).stderr)
        self.table = self.root / "closed.csv"
        self.assertEqual(self.of_pairs(*metrics, "--close-holes").stderr, "")
        self.table = self.root / "touching.csv"
        self.assertEqual(self.of_pairs("--metrics", "touching").stderr, "")

    def test_other_measurements_are_refused(self):
        self.of_pairs("--metrics", "touching")
        other = generated_body.save_body(self.root / "other.npz")
        for more, message in [(("--metrics", "depth"), "has other columns"),
                              (("--metrics", "touching", "--every", 2), "row 2 is of another"),
                              (("--metrics", "touching", "--close-holes"), "row 2 is of another")]:
            result = self.of_pairs(*more)
            self.assertEqual(result.returncode, 2)
            self.assertIn(message, result.stderr)
        result = run_command("metrics", self.data, "--out", self.table, "--body-model", other,
                             "--pair-words", "P1,P2", "--metrics", "touching")
        self.assertIn("row 2 is of another", result.stderr)
        self.assertIn("has other columns", self.command("--metrics", "colliding").stderr)

    def test_shards_are_the_whole(self):
        self.of_pairs("--metrics", "touching")
        whole = read_rows(self.table)
        parts = []
        for shard in (1, 2):
            self.table = self.root / f"table-{shard}.csv"
            self.of_pairs("--metrics", "touching", "--shard", f"{shard}/2", "--threads", 1)
            parts += read_rows(self.table)
        self.assertEqual(sorted(parts, key=lambda row: row["clip_a"]), whole)

    def test_a_log_has_a_line_each_minute(self):
        with unittest.mock.patch("pelt._command._SECONDS_BETWEEN_LINES", 0):
            lines = self.of_pairs("--metrics", "touching").stderr.splitlines()
        self.assertEqual(lines[1], "1 of 3 pairs, 0 failed  b/P1.npz and b/P2.npz")

    def test_invalid_arguments(self):
        for more in (("--pair-words", "P1"), ("--pair-words", "P1,P1"), ("--pair-words", "X,Y"),
                     ("--pairs", "absent.csv"), ("--pairs", "x.csv", "--pair-words", "P1,P2"),
                     ("--pair-words", "P1,P2", "--metrics", "filtered"), ("--fps", "-1")):
            with self.subTest(more):
                self.assertEqual(self.command(*more).returncode, 2)
        listed = self.root / "pairs.csv"
        listed.write_text("a,b\n")
        result = run_command("metrics", "nowhere", "--out", self.table, "--body-model", self.body,
                             "--pairs", listed)
        self.assertIn("nowhere: not a folder", result.stderr)

    def test_help(self):
        text = run_command("metrics", "--help").stdout
        for word in (*datasets.PAIR_METRICS, "--pairs", "--pair-words", "--close-holes", "--fps"):
            self.assertIn(word, text)


if __name__ == "__main__":
    unittest.main()
