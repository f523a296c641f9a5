#!/usr/bin/env python3
"""`pelt check --threads` gives the same answer with any number of threads.

    check_threads_test.py COMMAND
"""

import os
import pathlib
import re
import sys
import unittest

sys.path.append(str(pathlib.Path(__file__).parent.parent / "shard"))
import check_runs  # noqa: E402  pylint: disable=wrong-import-position

COMMAND = sys.argv.pop()


class ThreadsTests(check_runs.CheckTests):
    command = COMMAND

    def test_answers_do_not_depend_on_threads(self):
        in_contact = 0
        for case in check_runs.CASES:
            expected = check_runs.answer(COMMAND, self.folder, "check", *case, "--threads", "1")
            self.assertIn(expected[0][0], (0, 1), expected)
            in_contact += check_runs.contacts_of(expected[1]) > 0
            for threads in ("2", "3", "7") if "--between" in case else ("3",):
                with self.subTest(case=case, threads=threads):
                    found = check_runs.answer(COMMAND, self.folder, "check", *case, "--threads",
                                              threads)
                    self.assertEqual(found, expected)
        self.assertGreaterEqual(in_contact, 14)

    def test_baselines_do_not_depend_on_threads(self):
        self.pelt("check", "pair.json", "--frames", "0:4", "--jsonl", "known.jsonl")
        codes = []
        for threads in ("1", "3"):
            codes.append(check_runs.answer(COMMAND, self.folder, "check", "pair.json",
                                           "--baseline", "known.jsonl", "--threads", threads))
        self.assertEqual(codes[0], codes[1])
        self.assertEqual(codes[0][0][0], 1)

    def test_pages_do_not_depend_on_threads(self):
        version = self.pelt("--version")[1].split()[-1]
        page = pathlib.Path(self.folder, "viewer.html")
        page.write_text(f'<meta name="generator" content="Pelt {version}">'
                        '<script type="application/json" id="pelt-data"></script>')
        os.environ["PELT_VIEWER"] = str(page)
        pages = set()
        for options in ([], ["--threads", "1"], ["--threads", "3"]):
            self.pelt("check", "pair.json", "--between", "--html", "out.html", *options)
            text = pathlib.Path(self.folder, "out.html").read_text()
            pages.add(re.sub('"made":"[^"]*"', "", text))
        self.assertEqual(len(pages), 1)

    def test_the_first_bad_frame_is_reported(self):
        # From frame 2 on, the body is too far away to be posed.
        text = pathlib.Path(self.folder, "pair.json").read_text()
        text = text.replace('"fps": 8', '"fps": 1e-6')
        text = text.replace('"translation": [0.7', '"velocity": [1e12, 0, 0], "translation": [0.7')
        pathlib.Path(self.folder, "far.json").write_text(text)
        errors = {check_runs.answer(COMMAND, self.folder, "check", "far.json", "--threads", n)[0]
                  for n in ("1", "2", "7")}
        self.assertEqual(len(errors), 1, errors)
        code, _, error = errors.pop()
        self.assertEqual(code, 2)
        self.assertIn("far.json: frame 2: instances[1]: ", error)

    def test_numbers_of_threads_are_validated(self):
        for threads in ("0", "-1", "x", "99999"):
            self.assertEqual(self.pelt("check", "pair.json", "--threads", threads)[0], 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
