"""The version, and what `help` says."""

import inspect
import re
import unittest

import pelt
from support import SOURCE, Case


class Package(Case):
    def test_version(self):
        stated = re.search(r"project\(pelt VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text())
        self.assertEqual(pelt.__version__, stated[1])

    def test_all_names_exist(self):
        self.assertEqual(sorted(pelt.__all__), sorted(set(pelt.__all__)))
        for name in pelt.__all__:
            self.assertTrue(hasattr(pelt, name), name)

    def test_everything_has_help(self):
        for name in pelt.__all__:
            value = getattr(pelt, name)
            if not (inspect.isclass(value) or inspect.isfunction(value)):
                continue
            self.assertGreater(len(inspect.getdoc(value) or ""), 20, name)
            members = inspect.getmembers(value) if inspect.isclass(value) else []
            for member_name, member in members:
                if not member_name.startswith("_") and inspect.isfunction(member):
                    self.assertTrue(inspect.getdoc(member), f"{name}.{member_name}")

    def test_help_lists_all_functions(self):
        for name in pelt.__all__:
            if inspect.isfunction(getattr(pelt, name)):
                self.assertIn(name, pelt.__doc__)

    def test_help_names_types_as_the_source_does(self):
        self.assertIn("poses_a: 'PosesLike'", str(inspect.signature(pelt.collide)))
        for name in pelt.__all__:
            value = getattr(pelt, name)
            if inspect.isfunction(value):
                self.assertNotIn("_array_like", str(inspect.signature(value)), name)

    def test_the_error_is_a_value_error(self):
        self.assertTrue(issubclass(pelt.Error, ValueError))


if __name__ == "__main__":
    unittest.main()
