"""check_wide_symbols.py prints the shared symbols of an object file, for any output of nm."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECKER = sys.argv.pop()
SOUND = """\
0000000000000000 T pelt::detail::avx2::open_all(pelt::detail::PosedTree const&)
0000000000000040 t pelt::detail::(anonymous namespace)::helper()
0000000000000080 W void twice<pelt::detail::avx2::Box4>(pelt::detail::avx2::Box4)
0000000000000000 r .LC0
"""
SHARED = ["W std::vector<int, std::allocator<int> >::push_back(int const&)",
          "T pelt::detail::forgotten()", "V typeinfo for Thing", "u guard of a static",
          "W pelt::detail::simd128::other_target()"]


class WideSymbolsTests(unittest.TestCase):
    def check(self, *listings):
        with tempfile.TemporaryDirectory() as folder:
            files = [pathlib.Path(folder, f"{i}.o") for i in range(len(listings))]
            for file, listing in zip(files, listings):
                file.write_text(listing)
            nm = pathlib.Path(folder, "nm")
            nm.write_text('#!/bin/sh\nfor file; do :; done\ncat "$file"\n')
            nm.chmod(0o755)
            run = subprocess.run([sys.executable, CHECKER, nm, "avx2", *files],
                                 capture_output=True, text=True)
            return run.returncode, run.stdout.splitlines()

    def test_what_stands_in_the_namespace_is_sound(self):
        status, lines = self.check(SOUND, SOUND)
        self.assertEqual((status, lines), (0, ["2 files of avx2 share nothing"]))

    def test_what_is_shared_is_named_with_its_file(self):
        for symbol in SHARED:
            status, lines = self.check(SOUND, SOUND + f"0000000000000000 {symbol}\n")
            self.assertEqual(status, 1)
            self.assertEqual(len(lines), 1)
            self.assertTrue(lines[0].endswith("1.o: " + symbol[2:]), lines)

    def test_no_files_is_no_success(self):
        self.assertEqual(self.check()[0], 1)

    def test_skipping_says_why(self):
        run = subprocess.run([sys.executable, CHECKER, "--skip", "not optimised"],
                             capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stdout), (77, "skipped: not optimised\n"))


if __name__ == "__main__":
    unittest.main()
