#!/usr/bin/env python3
"""Asks `pelt view` for its page as a browser does.

    view_test.py COMMAND
"""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import urllib.request

PAGE = '<script type="application/json" id="pelt-data"></script>'
SCENE = '{"models": {"a": {"creature": {"triangles": 1000}}}, "instances": [{"model": "a"}]}'


def served(command, folder, *arguments):
    """The page, and the exit code after Ctrl+C."""
    environment = {**os.environ, "PELT_VIEWER": str(folder / "viewer.html")}
    with subprocess.Popen([command, "view", "--no-browser", *arguments], cwd=folder, text=True,
                          stdout=subprocess.PIPE, env=environment) as running:
        address = running.stdout.readline().split()[0]
        assert address.startswith("http://127.0.0.1:"), address
        with urllib.request.urlopen(address, timeout=60) as answer:
            page = answer.read().decode()
        running.send_signal(signal.SIGINT)
        return page, running.wait(timeout=60)


def main(command):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "viewer.html").write_text(PAGE)
        (folder / "scene.json").write_text(SCENE)
        assert served(command, folder) == (PAGE, 0)
        page, code = served(command, folder, "scene.json")
        assert code == 0
        assert '"format":"pelt-report"' in page and '"command":"pelt view scene.json' in page, page


main(sys.argv[1])
