#!/usr/bin/env python3
"""`pelt check --shard` and `pelt merge` give the answer of one `pelt check`.

    merge_test.py COMMAND
"""

import json
import pathlib
import sys
import unittest

sys.path.append(str(pathlib.Path(__file__).parent))
import check_runs  # noqa: E402  pylint: disable=wrong-import-position

COMMAND = sys.argv.pop()


class MergeTests(check_runs.CheckTests):
    command = COMMAND

    def merged(self, files, *arguments):
        return check_runs.answer(COMMAND, self.folder, "merge", *files, *arguments)

    def test_merged_shards_are_the_answer_of_one_run(self):
        in_contact = 0
        for case in check_runs.CASES:
            extra = ["--list", "10"] if "--list" not in case else ["--list", "3"]
            question = [word for i, word in enumerate(case)
                        if word != "--list" and (i == 0 or case[i - 1] != "--list")]
            expected = check_runs.answer(COMMAND, self.folder, "check", *question, *extra)
            in_contact += check_runs.contacts_of(expected[1]) > 0
            files = self.shards_of(question, self.random.choice((1, 2, 3, 9)))
            self.random.shuffle(files)
            with self.subTest(case=case, files=files, seed=check_runs.SEED):
                self.assertEqual(self.merged(files, *extra), expected)
                threads = self.random.choice("1237")
                self.assertEqual(self.merged(files, *extra, "--threads", threads), expected)
        self.assertGreaterEqual(in_contact, 14)

    def test_the_verdict_is_that_of_the_merged_answer(self):
        self.pelt("check", "pair.json", "--frames", "0:4", "--jsonl", "part.jsonl")
        self.pelt("check", "pair.json", "--jsonl", "all.jsonl")
        files = self.shards_of(["pair.json"], 3)
        codes = []
        for options in (["--baseline", "part.jsonl"], ["--baseline", "all.jsonl"],
                        ["--fail-on", "never"], ["--baseline", "part.jsonl", "--fail-on", "new"],
                        ["--glb-frame", "7"]):
            expected = check_runs.answer(COMMAND, self.folder, "check", "pair.json", *options)
            self.assertEqual(self.merged(files, *options), expected)
            codes.append(expected[0][0])
        self.assertEqual(codes[:3], [1, 0, 0])

    def test_a_check_of_nothing_fails_when_it_is_merged(self):
        files = self.shards_of(["one.json", "--self", "no"], 2)
        self.assertEqual(self.merged(files)[0],
                         check_runs.answer(COMMAND, self.folder, "check", "one.json", "--self",
                                           "no")[0])
        self.assertEqual(self.pelt("merge", *files, "--allow-empty")[0], 0)

    def test_missing_and_doubled_shards_are_named(self):
        files = self.shards_of(["pair.json"], 3)
        self.assertIn("shard 2/3 is missing: write it with --shard 2/3",
                      self.refusal("merge", files[0], files[2]))
        self.assertIn("shard 3/3 is missing", self.refusal("merge", *files[:2]))
        (self.folder / "copy.shard").write_bytes((self.folder / files[1]).read_bytes())
        self.assertIn("copy.shard: is the same shard as s2.shard",
                      self.refusal("merge", *files, "copy.shard"))
        self.assertIn("none.shard: cannot be read", self.refusal("merge", *files, "none.shard"))

    def test_foreign_shards_are_named(self):
        files = self.shards_of(["pair.json"], 2)
        for case, words in ((["pair.json", "--pairs"], "its pairs differs"),
                            (["pair.json", "--frames", "0:4"], "its frames differs"),
                            (["apart.json"], "its inputs differs")):
            other = self.shards_of(case, 2, "o")
            error = self.refusal("merge", files[0], other[1])
            self.assertIn("o2.shard: is from another check than s1.shard", error)
            self.assertIn(words, error)
        three = self.shards_of(["pair.json"], 3, "t")
        self.assertIn("t2.shard: is one of 3 shards, but s1.shard is one of 2",
                      self.refusal("merge", files[0], three[1]))

    def test_changed_inputs_are_named(self):
        files = self.shards_of(["pair.json"], 2)
        path = self.folder / "pair.json"
        path.write_text(path.read_text().replace("0.7", "0.6"))
        self.assertIn("pair.json: has changed since the shards were written", self.refusal("merge", *files))

    def test_damaged_files_are_named(self):
        files = self.shards_of(["pair.json", "--between"], 2)
        self.expect_cuts_are_named(files)
        good = (self.folder / files[1]).read_bytes()
        place = self.random.randrange(good.find(b"\n") + 1, len(good) - 1)
        (self.folder / files[1]).write_bytes(good[:place] + b"!" + good[place + 1:])
        self.assertIn("s2.shard: is incomplete or was changed", self.refusal("merge", *files))

    def test_other_versions_are_named(self):
        files = self.shards_of(["pair.json"], 1)
        text = (self.folder / files[0]).read_text()
        for old, new in (('"version":2', '"version":1'), ('"pelt":"', '"pelt":"9'),
                         ('"budget":', '"budgets":'), ('"budget":', '"news":0,"budget":')):
            self.assertIn(old, text)
            (self.folder / files[0]).write_text(text.replace(old, new, 1))
            self.assertIn("s1.shard: was written by another version of pelt", self.refusal("merge", *files))

    def test_hostile_values_are_refused(self):
        case = ["pair.json", "--between", "--inside", "--contacts", "--self", "--frames", "4:6"]
        files = self.shards_of(case, 1)
        lines = (self.folder / files[0]).read_bytes().splitlines()[:-1]
        self.assertEqual(len(lines), 7)  # the header and two frames
        refused = 0
        for _ in range(40):
            changed = list(lines)
            place = self.random.choice((1, 4))
            values = json.loads(lines[place])
            key = self.damage(values)
            changed[place] = json.dumps(values, separators=(",", ":")).encode()
            check_runs.write_shard(self.folder / files[0], changed)
            code, _, error = self.pelt("merge", *files)
            self.assertIn(code, (0, 1, 2), (check_runs.SEED, key, error))
            refused += code == 2
        self.assertGreaterEqual(refused, 20, check_runs.SEED)

    def damage(self, value):
        """Replaces a random part of an object by something else."""
        path = []
        while True:
            keys = list(value) if isinstance(value, dict) else range(len(value))
            key = self.random.choice(list(keys))
            path.append(key)
            if not isinstance(value[key], (dict, list)) or not value[key]:
                break
            value = value[key]
        value[key] = self.random.choice(
            [-1, 4294967295, 18446744073709551615, 1e300, "x", None, [], {}, True, 0.5])
        return path

    def test_hostile_contacts_are_refused(self):
        files = self.shards_of(["pair.json", "--frames", "3:4"], 1)
        path = self.folder / files[0]
        lines = path.read_bytes().splitlines()[:-1]
        self.assertGreater(len(lines[3]), 300)
        # A wrong pair, no contacts, too many, numbers that do not end, other characters, a triangle
        # beyond the last one and before the first one, contacts and pairs that do not ascend.
        for bad in (b"0", b"01", b"1013@", b"0213@", b"010", b"012@@", b"0122@", b"01" + b"o" * 20,
                    b"01" + b"o" * 11 + b"0", b"01100 ", b"0110\xff", b'{"a": 1}', b"011o80",
                    b"01103", b"01200o0", b"0120000", b"0111001110", lines[3] + b"0",
                    lines[3][:-1], lines[3] + lines[3]):
            check_runs.write_shard(path, [*lines[:3], bad])
            self.assertIn("frame 3: bad value of contacts", self.refusal("merge", *files), bad)
        refused = 0
        for _ in range(60):
            bad = bytearray(lines[3])
            bad[self.random.randrange(len(bad))] = self.random.choice(
                [byte for byte in range(256) if byte != 10])
            check_runs.write_shard(path, [*lines[:3], bytes(bad)])
            code, _, error = self.pelt("merge", *files)
            self.assertIn(code, (1, 2), (check_runs.SEED, error))
            refused += code == 2
        self.assertGreaterEqual(refused, 30, check_runs.SEED)

    def test_options_of_the_answer_belong_to_merge(self):
        for option in (["--jsonl", "a.jsonl"], ["--baseline", "a.jsonl"], ["--fail-on", "never"],
                       ["--html", "a.html"], ["--glb", "a.glb"], ["--allow-empty"]):
            code, _, error = self.pelt("check", "pair.json", "--shard", "1/2", "-o", "a.shard",
                                       *option)
            self.assertEqual(code, 2)
            self.assertIn(f"{option[0]}: cannot be combined with --shard: give it to pelt merge",
                          error)
        for shard in ("0/2", "3/2", "1", "1/0", "/", "1/2/3", "-1/2", "1/9999999999", "a/b"):
            code, _, error = self.pelt("check", "pair.json", "--shard", shard, "-o", "a.shard")
            self.assertEqual(code, 2)
            self.assertIn("is not a shard: give I/N", error)
        self.assertIn("--shard: requires a file",
                      self.pelt("check", "pair.json", "--shard", "1/2")[2])
        self.assertIn("-o: requires --shard", self.pelt("check", "pair.json", "-o", "x")[2])
        self.assertFalse((self.folder / "a.shard").exists())

    def test_merge_does_not_replace_its_inputs(self):
        files = self.shards_of(["pair.json"], 1)
        before = (self.folder / files[0]).read_bytes()
        self.assertEqual(self.pelt("merge", *files, "--jsonl", files[0])[0], 2)
        self.assertEqual((self.folder / files[0]).read_bytes(), before)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
