"""The command `python -m pelt`."""

import sys

from pelt._command import main

if __name__ == "__main__":
    sys.exit(main())
