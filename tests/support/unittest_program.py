"""The end of a program of tests, for ctest with SKIP_RETURN_CODE 77."""

import sys
import unittest


def main(names=()):
    """Runs the tests of the program, or those with these names such as `Class.test`, and exits.

    The exit status is 77, with a reason, if no test failed and each was skipped. unittest itself
    ends with 0, and ctest would call the program passed.
    """
    result = unittest.main(argv=[sys.argv[0], *names], exit=False).result
    if result.wasSuccessful() and result.skipped and len(result.skipped) >= result.testsRun:
        print(f"skipped: {result.skipped[0][1]}", flush=True)
        sys.exit(77)
    sys.exit(0 if result.wasSuccessful() else 1)
