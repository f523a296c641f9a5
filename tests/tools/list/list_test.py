#!/usr/bin/env python3
"""`pelt check --scenes` checks each scene of a list, in one run or in shards.

    list_test.py COMMAND
"""

import json
import pathlib
import sys
import unittest

sys.path.append(str(pathlib.Path(__file__).parent.parent / "shard"))
import check_runs  # noqa: E402  pylint: disable=wrong-import-position

COMMAND = sys.argv.pop()
SCENES = ["pair.json", "missing.json", "apart.json", "one.json", "broken.json", "clips.json",
          "limb.glb"]
IN_CONTACT = ["pair.json", "one.json", "clips.json"]
OPTIONS = [[], ["--pairs", "--threads", "1"], ["--threads", "2", "--self", "--inside"],
           ["--between", "--threads", "20", "--by", "part"], ["--first", "--fail-on", "never"]]


class ListTests(check_runs.CheckTests):
    command = COMMAND

    def setUp(self):
        super().setUp()
        (self.folder / "broken.json").write_text("{")
        self.write_list(SCENES)

    def write_list(self, names, name="list.txt"):
        (self.folder / name).write_text("".join(f"{one}\n" for one in names))

    def answer(self, *arguments):
        """The exit code, the summary, the errors, and the bytes of --jsonl."""
        ended = self.pelt(*arguments, "--jsonl", "out.jsonl")
        path = self.folder / "out.jsonl"
        data = path.read_bytes() if path.exists() else None
        path.unlink(missing_ok=True)
        return ended, data

    def check(self, *options, scenes="list.txt"):
        return self.answer("check", "--scenes", scenes, *options)

    def write_shards(self, count, *options, name="s"):
        return self.shards_of(["--scenes", "list.txt", *options], count, name)

    def entries(self, data):
        """The line of each scene, with the lines of its check as "check"."""
        lines = data.splitlines(keepends=True)
        found, next_line = [], 1
        while next_line < len(lines) - 1:
            entry = json.loads(lines[next_line])
            next_line += 1 + entry["lines"]
            entry["check"] = b"".join(lines[next_line - entry["lines"]:next_line])
            found.append(entry)
        return found

    def test_each_scene_has_the_lines_of_its_own_check(self):
        for options in OPTIONS:
            (code, _, error), data = self.check(*options)
            self.assertEqual(code, 2)
            entries = self.entries(data)
            self.assertEqual([one["scene"] for one in entries], SCENES)
            for entry in entries:
                alone, lines = self.answer("check", entry["scene"], *options)
                with self.subTest(scene=entry["scene"], options=options):
                    if entry["scene"] in ("missing.json", "broken.json"):
                        self.assertEqual(alone[0], 2)
                        self.assertEqual(alone[2], f"pelt: error: {entry['error']}\n")
                        self.assertIn(alone[2], error)
                        self.assertEqual(set(entry), {"scene", "error", "lines", "check"})
                    else:
                        self.assertEqual(lines, entry["check"], error)
                        self.assertIsNone(entry["error"])
                        self.assertEqual(entry["failed"], alone[0] == 1)

    def test_the_totals_are_those_of_all_scenes(self):
        (code, out, _), data = self.check()
        entries = [one for one in self.entries(data) if one["error"] is None]
        last = json.loads(data.splitlines()[-1])
        contacts = sum(one["contacts"] for one in entries)
        self.assertEqual(last["totals"]["contacts"], contacts)
        self.assertEqual(last["totals"]["frames"], sum(one["frames"] for one in entries))
        self.assertEqual((last["totals"]["scenes"], last["totals"]["unchecked"],
                          last["totals"]["failed"], last["totals"]["in_contact"]), (7, 2, 3, 3))
        self.assertGreater(contacts, 100)
        self.assertIsNone(last["hash"])
        self.assertIn("scenes     7: 3 failed, 2 could not be checked\n", out)
        self.assertEqual(code, 2)

    def test_the_exit_code_is_that_of_the_worst_scene(self):
        for names, options, code in ((["apart.json", "limb.glb"], [], 0), (IN_CONTACT, [], 1),
                                     (IN_CONTACT, ["--fail-on", "never"], 0),
                                     (["apart.json", "pair.json"], [], 1),
                                     (["apart.json", "missing.json"], [], 2),
                                     (["one.json", "pair.json"], ["--self", "no"], 2),
                                     (["one.json", "apart.json"],
                                      ["--self", "no", "--allow-empty"], 0)):
            self.write_list(names)
            (found, _, error), data = self.check(*options)
            self.assertEqual(found, code, error)
            self.assertEqual(json.loads(data.splitlines()[-1])["hash"] is None, code == 2)

    def test_merged_shards_are_the_answer_of_one_run(self):
        for options in OPTIONS:
            expected = self.check(*options)
            self.assertEqual(expected[0][0], 2)
            for count in (1, 3, self.random.choice((2, 4, 7, 11))):
                files = self.write_shards(count, *options)
                self.random.shuffle(files)
                with self.subTest(options=options, files=files, seed=check_runs.SEED):
                    self.assertEqual(self.answer("merge", *files), expected)

    def test_a_baseline_is_the_answer_for_an_earlier_list(self):
        self.write_list(["pair.json", "one.json", "apart.json"])
        (self.folder / "known.jsonl").write_bytes(self.check()[1])
        options = ["--baseline", "known.jsonl"]
        self.assertEqual(self.check(*options)[0][0], 0)
        self.write_list(["apart.json", "clips.json", "one.json", "pair.json"])  # clips.json is new
        expected = self.check(*options)
        self.assertEqual(expected[0][0], 1)
        failed = [one["scene"] for one in self.entries(expected[1]) if one["failed"]]
        self.assertEqual(failed, ["clips.json"])
        for threads in ("1", "2"):
            files = self.write_shards(3, *options, "--threads", threads)
            self.assertEqual(self.answer("merge", *reversed(files)), expected)
        self.assertEqual(self.check(*options, "--fail-on", "never")[0][0], 0)
        text = (self.folder / "apart.json").read_text()
        (self.folder / "apart.json").write_text(text.replace("[9, 0, 0]", "[0.7, 0, 0]"))
        failed = [one["scene"] for one in self.entries(self.check(*options)[1]) if one["failed"]]
        self.assertEqual(failed, ["apart.json", "clips.json"])

    def test_scenes_of_the_baseline_that_the_list_lacks_are_named(self):
        self.write_list(["missing.json", "pair.json", "one.json", "apart.json"])
        (self.folder / "known.jsonl").write_bytes(self.check()[1])
        options = ["--baseline", "known.jsonl"]
        for names, words in ((["apart.json", "pair.json", "one.json"], None),
                             (["apart.json", "pair.json"], '1 scene that list.txt lacks, first "one.json"'),
                             (["one.json"], '2 scenes that list.txt lacks, first "pair.json"')):
            self.write_list(names)
            shards = self.pelt("check", "--scenes", "list.txt", *options, "--shard", "1/1", "-o", "1.shard")
            for code, _, error in (self.check(*options)[0], shards):
                self.assertEqual(code, 0)
                self.assertEqual(error, words and f"pelt: warning: --baseline: known.jsonl: has {words}: "
                                                  "add scenes that were lost or renamed, or write a new baseline\n" or "")

    def test_bad_baselines_are_named(self):
        self.write_list(["pair.json"])
        good = self.check()[1]
        path = self.folder / "known.jsonl"
        check = ["check", "--scenes", "list.txt", "--baseline", "known.jsonl"]
        self.assertIn("--baseline: known.jsonl: cannot be read", self.refusal(*check))
        self.pelt("check", "pair.json", "--jsonl", "known.jsonl")
        self.assertIn("known.jsonl: is not an answer for a list of scenes", self.refusal(*check))
        lines = good.splitlines(keepends=True)
        for bad in (b"".join(lines[:-1]), b"".join(lines[:4]), good[:-1], lines[0],
                    b"".join([lines[0], b"x\n", *lines[1:]])):
            path.write_bytes(bad)
            self.assertIn("known.jsonl: is incomplete or damaged", self.refusal(*check))
        path.write_bytes(good)
        code, _, error = self.pelt(*check, "--by", "part")
        self.assertEqual(code, 2)
        self.assertIn("pair.json: --baseline: known.jsonl: ", error)

    def test_lists_are_validated(self):
        check = ["check", "--scenes", "list.txt"]
        self.write_list(["", "pair.json", "", "one.json", "pair.json"])
        self.assertIn('list.txt: line 5: "pair.json" is already in line 2', self.refusal(*check))
        self.write_list(["", ""])
        self.assertIn("--scenes: list.txt: lists no scene", self.refusal(*check))
        self.write_list(["a\0b"])
        self.assertIn("list.txt: line 1: is not text", self.refusal(*check))
        self.assertIn("--scenes: none.txt: ", self.refusal("check", "--scenes", "none.txt"))
        (self.folder / "list.txt").write_bytes(b"pair.json\r\n\r\napart.json")
        data = self.check()[1]
        self.assertEqual([one["scene"] for one in self.entries(data)], ["pair.json", "apart.json"])

    def test_options_that_a_list_lacks_are_refused(self):
        check = ["check", "--scenes", "list.txt"]
        self.assertIn("--scenes: cannot be combined with INPUT", self.refusal(*check, "pair.json"))
        for option in (["--html", "a.html"], ["--glb", "a.glb"], ["--glb-frame", "1"]):
            self.assertIn(f"{option[0]}: cannot be combined with --scenes",
                          self.refusal(*check, *option))
        self.assertIn("-o: requires --shard", self.refusal(*check, "-o", "x"))
        self.assertIn("INPUT: is required", self.refusal("check"))
        files = self.write_shards(1)
        for option in (["--html", "a.html"], ["--glb", "a.glb"], ["--glb-frame", "1"],
                       ["--fail-on", "never"], ["--baseline", "a.jsonl"], ["--allow-empty"]):
            self.assertIn(f"{option[0]}: cannot be combined with shards of a list",
                          self.refusal("merge", *files, *option))

    def test_options_are_validated_once_before_scenes_are_loaded(self):
        shard = ["--shard", "1/1", "-o", "x.shard"]
        for option in (["--fail-on", "typo"], ["--fail-on", "grown"], ["--by", "typo"],
                       ["--method", "typo"], ["--frames", "typo"], ["--fps", "0"],
                       ["--self-always", "2"], ["--ignore", "one"], ["--substeps", "2"],
                       ["--clearance", "-1"], ["--clearance", "1", "--contacts"],
                       ["--between", "--first"], ["--first", "--ignore", "a,b"],
                       ["--baseline", "none.jsonl", "--first"]):
            with self.subTest(option=option):
                for output in (shard, ["--jsonl", "x.jsonl"]):
                    error = self.refusal("check", "--scenes", "list.txt", *option, *output)
                    self.assertTrue(error.startswith(f"pelt: error: {option[0]}: "), error)
                    self.assertEqual(error.count("\n"), 1, error)
                    self.assertFalse((self.folder / output[-1]).exists())

    def test_outputs_do_not_replace_inputs(self):
        self.write_list(["pair.json", "one.json"])
        files = self.write_shards(1)
        for name in ("list.txt", "pair.json", "limb.glb"):
            before = (self.folder / name).read_bytes()
            self.assertIn(f"{name} is ",
                          self.refusal("check", "--scenes", "list.txt", "--jsonl", name))
            self.assertIn(f"{name} is ", self.refusal("check", "--scenes", "list.txt", "--shard",
                                                      "1/1", "-o", name))
            self.assertEqual((self.folder / name).read_bytes(), before)
        self.assertIn("s1.shard is the shard s1.shard",
                      self.refusal("merge", *files, "--jsonl", "s1.shard"))

    def test_missing_doubled_and_foreign_shards_are_named(self):
        files = self.write_shards(3)
        self.assertIn("shard 2/3 is missing: write it with --shard 2/3",
                      self.refusal("merge", files[0], files[2]))
        (self.folder / "copy.shard").write_bytes((self.folder / files[1]).read_bytes())
        self.assertIn("copy.shard: is the same shard as s2.shard",
                      self.refusal("merge", *files, "copy.shard"))
        other = self.write_shards(3, "--pairs", name="o")
        self.assertIn("o2.shard: is from another check than s1.shard (its pairs differs)",
                      self.refusal("merge", files[0], other[1], files[2]))
        self.pelt("check", "pair.json", "--shard", "2/3", "-o", "pair.shard")
        self.assertIn("pair.shard: is from another check than s1.shard",
                      self.refusal("merge", files[0], "pair.shard", files[2]))
        self.write_list(SCENES[:-1])
        other = self.write_shards(3, name="l")
        self.assertIn("l2.shard: is from another check than s1.shard (its input files differ)",
                      self.refusal("merge", files[0], other[1], files[2]))

    def test_damaged_shards_are_named(self):
        self.expect_cuts_are_named(self.write_shards(2))

    def test_hostile_shards_are_refused(self):
        files = self.write_shards(1)
        path = self.folder / files[0]
        lines = path.read_bytes().splitlines()[:-1]
        entries = [i for i, line in enumerate(lines) if line.startswith(b'{"scene"')]
        self.assertEqual(len(entries), len(SCENES))
        for value in (b"-1", b"0", b"18446744073709551615", b'"x"', b"null", b"1e300", b"{}"):
            changed = list(lines)
            changed[entries[0]] = changed[entries[0]].replace(b'"lines":11', b'"lines":' + value)
            check_runs.write_shard(path, changed)
            self.assertRegex(self.refusal("merge", *files),
                             "s1.shard: (lacks a |has more scenes than the shard)")
        check_runs.write_shard(path, lines + [lines[entries[1]]])
        self.assertIn("s1.shard: has more scenes", self.refusal("merge", *files))
        check_runs.write_shard(path, lines[:-1])
        self.assertIn("s1.shard: lacks a line of a scene", self.refusal("merge", *files))
        for value in (b"8", b"-1", b"null", b"1e9", b"18446744073709551615", b"[]"):
            header = lines[0].replace(b'"scenes":7', b'"scenes":' + value)
            self.assertNotEqual(header, lines[0])
            check_runs.write_shard(path, [header, *lines[1:]])
            self.assertIn("s1.shard: ", self.refusal("merge", *files))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
