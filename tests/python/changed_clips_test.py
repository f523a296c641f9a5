"""Tables whose clips or body models have changed: which rows are measured again, and which are refused."""

import csv
import os
import stat
import unittest
import unittest.mock

import numpy as np

import generated_body
import pair_datasets_test
from datasets_test import Folder, read_rows, run_command
from pelt import datasets, motions
from pelt.datasets._contents import contents_hash


def remove_hashes(path):
    """Makes a table one of an early version."""
    rows = [{name: value for name, value in row.items() if "_hash" not in name}
            for row in read_rows(path)]
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


class Hashes(Folder):
    def hash_of(self, **changes):
        return contents_hash(generated_body.save_motion(self.data / "x.npz", **changes))

    def test_each_array_counts(self):
        keys = generated_body.motion_keys()
        first = self.hash_of()
        self.assertRegex(first, "^[0-9a-f]{16}$")
        others = {self.hash_of(trans=keys["trans"] + 1e-9), self.hash_of(betas=None),
                  self.hash_of(gender=np.array("female"))}
        self.assertEqual(len(others - {first}), 3)
        self.assertEqual(self.hash_of(), first)

    def test_time_and_compression_do_not_count(self):
        first = self.hash_of()
        np.savez_compressed(self.data / "x.npz", **generated_body.motion_keys())
        os.utime(self.data / "x.npz", (1, 1))
        self.assertEqual(contents_hash(self.data / "x.npz"), first)

    def test_other_files(self):
        self.assertIsNone(contents_hash(self.data / "absent.npz"))
        whole = (self.data / "b/sit.npz").read_bytes()
        for data in (b"", b"PK", whole[:-1], whole[:len(whole) // 2]):
            (self.data / "x.npz").write_bytes(data)
            self.assertEqual(contents_hash(self.data / "x.npz"), "")


class TableOfClips(Folder):
    def measured(self, *more):
        return self.command("--metrics", "colliding", *more)

    def change(self, *clips):
        """Writes other motions, which look as old as the clips were."""
        for clip in clips:
            times = (self.data / clip).stat()
            generated_body.save_motion(self.data / clip, generated_body.motion_keys(seed=99))
            os.utime(self.data / clip, ns=(times.st_atime_ns, times.st_mtime_ns))

    def rows(self):
        return {row["clip"]: row for row in read_rows(self.table)}


class Changed(TableOfClips):
    def test_rows_of_changed_clips_are_measured_again(self):
        self.measured()
        before, text = self.rows(), self.table.read_bytes()
        self.change("a/run.npz", "b/sit.npz")
        result = self.measured()
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stderr, r"warning: a/run.npz and 1 more: changed.*table.csv.old-1 has")
        self.assertIn("2 clips measured, 2 were there before", result.stdout)
        self.assertEqual((self.root / "table.csv.old-1").read_bytes(), text)
        after = self.rows()
        self.assertEqual({clip for clip in self.clips if before[clip] != after[clip]},
                         {"a/run.npz", "b/sit.npz"})
        self.table = self.root / "fresh.csv"
        self.measured()
        self.assertEqual(self.rows(), after)

    def test_copies_of_the_table_have_names_of_their_own(self):
        self.measured()
        for number in (1, 2):
            generated_body.save_motion(self.data / "a/run.npz", generated_body.motion_keys(seed=number + 50))
            self.assertIn(f"table.csv.old-{number} has", self.measured().stderr)

    def test_changes_are_named_even_if_the_run_fails(self):
        self.measured()
        self.change("a/run.npz")
        result = self.measured("--failed", str(self.root / "nowhere/failed.csv"))
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, "warning: a/run.npz: changed[^$]*failed.csv: No such file")

    def test_files_that_only_look_new(self):
        self.measured()
        text = self.table.read_bytes()
        later = self.table.stat().st_mtime + 1
        for path in (self.data / "b/sit.npz", self.body):
            os.utime(path, (later, later))
        result = self.measured()
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(self.table.read_bytes(), text)

    def test_file_that_is_broken_now(self):
        self.measured()
        (self.data / "b/sit.npz").write_bytes(b"PK")
        result = self.measured()
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, "warning: b/sit.npz: changed[^$]*failed: .*sit.npz: not a complete")
        self.assertNotIn("b/sit.npz", self.rows())

    def test_file_that_is_not_there(self):
        """Datasets are larger than some disks: clips may go when they are measured."""
        self.measured()
        (self.data / "b/sit.npz").unlink()
        self.assertEqual(self.measured().stderr, "")
        self.assertIn("b/sit.npz", self.rows())

    def test_file_that_changes_while_it_is_read(self):
        load = motions.load

        def replaced(path, **options):
            self.change("a/run.npz")
            return load(path, **options)
        measure = datasets.Measurement(self.data, self.body, ["colliding"])
        with datasets.Table(self.table, measure) as table, \
                unittest.mock.patch("pelt.motions.load", replaced):
            table.append(measure("a/run.npz"))
        with datasets.Table(self.table, measure) as table:
            self.assertEqual((table.done, table.changed), (set(), ["a/run.npz"]))

    def test_body_model_whose_file_has_changed(self):
        self.measured()
        old = datasets.Measurement(self.data, self.body, ["colliding"])
        text = self.table.read_bytes()
        generated_body.save_body(self.body, v_template=2 * generated_body.arrays()["v_template"])
        result = self.measured()
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, "row 2 is of another .*or a body model whose file has changed")
        self.assertEqual(self.table.read_bytes(), text)
        with datasets.Table(self.table, old) as table:
            self.refuses("of a/run.npz is of another .* whose file has changed", table.append,
                         old("a/run.npz"))

    def test_tables_of_early_versions(self):
        self.measured()
        whole = read_rows(self.table)
        remove_hashes(self.table)
        text = self.table.read_bytes()
        self.table.write_bytes(text[:text.rindex(b"\n", 0, -1) + 1])
        self.change("a/run.npz")
        result = self.measured()
        self.assertEqual(result.returncode, 0)
        self.assertIn("table.csv: of an earlier version, without hashes", result.stderr)
        self.assertIn("1 clips measured, 3 were there before", result.stdout)
        self.assertEqual(self.table.read_bytes(), text)
        self.assertEqual(whole[0].keys() - read_rows(self.table)[0].keys(),
                         {"clip_hash", "body_model_hash"})

    def test_names_that_are_not_unicode(self):
        name = os.fsdecode(b"odd \xff.npz")
        generated_body.save_motion(self.data / name)
        self.assertIn("5 clips measured", self.measured().stdout)
        self.assertIn("0 clips measured, 5 were there before", self.measured().stdout)
        self.change(name)
        self.assertIn("1 clips measured, 4 were there before", self.measured().stdout)


class Replaced(TableOfClips):
    """The file of the table, which is replaced."""

    def test_links_and_permissions(self):
        real = self.root / "real.csv"
        self.table.symlink_to(real)
        self.measured()
        real.chmod(0o640)
        self.change("a/run.npz")
        self.assertIn("real.csv.old-1 has", self.measured().stderr)
        self.assertTrue(self.table.is_symlink())
        self.assertEqual(stat.S_IMODE(real.stat().st_mode), 0o640)
        self.assertEqual(len(read_rows(real)), 4)

    def test_full_disk_changes_nothing(self):
        self.measured()
        before = {path.name: path.read_bytes() for path in self.root.glob("table*")}
        self.change("a/run.npz")
        for function in ("fsync", "replace"):
            with self.subTest(function=function):
                with unittest.mock.patch(f"os.{function}", side_effect=OSError(28, "No space left on device")):
                    result = self.measured()
                self.assertEqual(result.returncode, 2)
                self.assertRegex(result.stderr, "table.csv: the rows .*: No space left on device: make room")
                after = {path.name: path.read_bytes() for path in self.root.glob("table*")}
                self.assertEqual(after, before)
        self.assertIn("1 clips measured, 3 were there before", self.measured().stdout)

    def test_process_that_has_opened_the_earlier_file(self):
        self.measured()
        measure = datasets.Measurement(self.data, self.body, ["colliding"])

        def replace_first(*_):
            (self.root / "other.csv").write_bytes(self.table.read_bytes())
            os.replace(self.root / "other.csv", self.table)
        with unittest.mock.patch("fcntl.flock", replace_first):
            self.refuses("another process is writing this table", datasets.Table, self.table, measure)


class Pairs(pair_datasets_test.Folder):
    def test_either_clip(self):
        self.of_pairs("--metrics", "touching")
        pair_datasets_test.person(self.data / "a/P1.npz", 50, np.zeros(6))
        pair_datasets_test.person(self.data / "c/P2.npz", 51, pair_datasets_test.STEPS)
        result = self.of_pairs("--metrics", "touching")
        self.assertIn("warning: a/P1.npz and a/P2.npz and 1 more: changed", result.stderr)
        self.assertIn("2 pairs measured, 1 were there before", result.stdout)
        again = self.root / "again.csv"
        run_command("metrics", self.data, "--out", again, "--body-model", self.body,
                    "--pair-words", "P1,P2", "--metrics", "touching")
        self.assertEqual(sorted(read_rows(self.table), key=lambda row: row["clip_a"]), read_rows(again))

    def test_tables_of_early_versions(self):
        self.of_pairs("--metrics", "touching")
        remove_hashes(self.table)
        result = self.of_pairs("--metrics", "touching")
        self.assertIn("of an earlier version", result.stderr)
        self.assertIn("0 pairs measured, 3 were there before", result.stdout)

    def test_body_model_whose_file_has_changed(self):
        self.of_pairs("--metrics", "touching")
        generated_body.save_body(self.body, v_template=2 * generated_body.arrays()["v_template"])
        self.assertIn("row 2 is of another measurement", self.of_pairs("--metrics", "touching").stderr)


if __name__ == "__main__":
    unittest.main()
