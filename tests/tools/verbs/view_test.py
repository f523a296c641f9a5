#!/usr/bin/env python3
"""Writes pages with `pelt view` and opens them with a replacement for a browser.

    view_test.py COMMAND
"""

import contextlib
import os
import pathlib
import signal
import stat
import subprocess
import sys
import tempfile
import time

SAID = subprocess.run([sys.argv[1], "--version"], capture_output=True, text=True, check=True).stdout
PAGE = (f'<meta name="generator" content="Pelt {SAID.split()[-1]}">'
        '<script type="application/json" id="pelt-data"></script>')
SCENE = '{"models": {"a": {"creature": {"triangles": 1000}}}, "instances": [{"model": "a"}]}'
PATIENCE = 20

# Replaces a browser and runs until it is ended: records its arguments and the signals that are
# blocked.
BROWSER = """#!/bin/sh
grep SigBlk /proc/self/status > "$LEFT.part"
echo "$1 $$" >> "$LEFT.part"
mv "$LEFT.part" "$LEFT"
exec sleep 60
"""


@contextlib.contextmanager
def start(command, folder, *arguments, **environment):
    environment = {**os.environ, "PELT_VIEWER": str(folder / "viewer.html"),
                   "TMPDIR": str(folder / "tmp"), **environment}
    with subprocess.Popen([command, "view", *arguments], cwd=folder, text=True,
                          stdout=subprocess.PIPE, env=environment) as running:
        try:
            yield running
        finally:
            running.kill()


def written_by(running):
    """The path of the page that the command says it wrote."""
    word, path = running.stdout.readline().split()
    assert word == "wrote", word
    return pathlib.Path(path)


def view(command, folder, *arguments):
    """Returns the path of the page, after the end of the command."""
    with start(command, folder, "--no-browser", *arguments) as running:
        path = written_by(running)
        assert running.wait(timeout=PATIENCE) == 0
        assert running.stdout.read() == "", "more words"
        return path


def writes_page(command, folder):
    """The temporary file outlives the command, and only its owner can read it."""
    page = view(command, folder)
    assert page.read_text() == PAGE
    assert page.parent.parent == folder / "tmp", page
    assert stat.S_IMODE(page.parent.stat().st_mode) == 0o700
    assert view(command, folder) != page


def writes_scene(command, folder):
    page = view(command, folder, "scene.json").read_text()
    assert '"format":"pelt-report"' in page and '"command":"pelt view' in page, page


def writes_named_file(command, folder):
    assert view(command, folder, "-o", "page.html") == pathlib.Path("page.html")
    assert (folder / "page.html").read_text() == PAGE
    with start(command, folder, "-o", "-", PATH="/nonexistent") as running:
        assert running.communicate(timeout=PATIENCE)[0] == PAGE
        assert running.returncode == 0


def refuses_missing_temporary_folder(command, folder):
    with start(command, folder, TMPDIR="/nonexistent") as running:
        assert running.wait(timeout=PATIENCE) == 2


def path_with(folder, opener):
    """Returns a PATH on which `xdg-open` is that script."""
    programs = folder / "programs"
    programs.mkdir(exist_ok=True)
    (programs / "xdg-open").write_text(opener)
    (programs / "xdg-open").chmod(0o755)
    return str(programs) + os.pathsep + os.environ["PATH"]


def opens_browser(command, folder):
    """The browser has no blocked signals, and is not ended by our Ctrl+C."""
    left = folder / "left"
    path = path_with(folder, BROWSER)
    with start(command, folder, "-o", "a page's.html", PATH=path, LEFT=str(left)) as running:
        assert running.stdout.readline() == "wrote a page's.html\n"
        deadline = time.monotonic() + PATIENCE
        while not left.exists() and time.monotonic() < deadline:
            time.sleep(0.01)
        blocked, told = left.read_text().splitlines()
        opened, browser = told.rsplit(maxsplit=1)
        try:
            assert opened == str(folder / "a page's.html"), told
            assert int(blocked.split()[1], 16) == 0, blocked
            assert os.getpgid(int(browser)) != os.getpgid(running.pid)
            running.send_signal(signal.SIGINT)
            assert running.wait(timeout=PATIENCE) == -signal.SIGINT
            os.kill(int(browser), 0)  # still running
        finally:
            os.kill(int(browser), signal.SIGKILL)


def says_where_no_browser_opens(command, folder):
    for path in (path_with(folder, "#!/bin/sh\nexit 3\n"), "/nonexistent"):
        with start(command, folder, PATH=path) as running:
            assert written_by(running).read_text() == PAGE
            said = running.stdout.readline()
            assert said == "no browser was opened: open this file in a browser\n", said
            assert running.wait(timeout=PATIENCE) == 0


def main(command):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name).resolve()
        (folder / "viewer.html").write_text(PAGE)
        (folder / "scene.json").write_text(SCENE)
        (folder / "tmp").mkdir()
        for promise in (writes_page, writes_scene, writes_named_file,
                        refuses_missing_temporary_folder, opens_browser,
                        says_where_no_browser_opens):
            promise(command, folder)


main(sys.argv[1])
