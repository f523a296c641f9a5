#!/usr/bin/env python3
"""Asks `pelt view` for its page as a browser does.

    view_test.py COMMAND
"""

import contextlib
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

SAID = subprocess.run([sys.argv[1], "--version"], capture_output=True, text=True, check=True).stdout
PAGE = (f'<meta name="generator" content="Pelt {SAID.split()[-1]}">'
        '<script type="application/json" id="pelt-data"></script>')
SCENE = '{"models": {"a": {"creature": {"triangles": 1000}}}, "instances": [{"model": "a"}]}'
PATIENCE = 20

# Stands for a browser that runs until it is closed: leaves what it was told and which signals are
# blocked for it.
BROWSER = """#!/bin/sh
grep SigBlk /proc/self/status > "$LEFT.part"
echo "$1 $$" >> "$LEFT.part"
mv "$LEFT.part" "$LEFT"
exec sleep 60
"""


@contextlib.contextmanager
def start(command, folder, *arguments, **environment):
    environment = {**os.environ, "PELT_VIEWER": str(folder / "viewer.html"), **environment}
    with subprocess.Popen([command, "view", *arguments], cwd=folder, text=True,
                          stdout=subprocess.PIPE, env=environment) as running:
        try:
            yield running
        finally:
            running.kill()


def end(running):
    """The exit code after Ctrl+C."""
    running.send_signal(signal.SIGINT)
    return running.wait(timeout=PATIENCE)


def address_of(running):
    address = running.stdout.readline().split()[0]
    assert address.startswith("http://127.0.0.1:"), address
    return address


def answer(address, **headers):
    asked = urllib.request.Request(address, headers=headers)
    with urllib.request.urlopen(asked, timeout=PATIENCE) as answered:
        return answered.read().decode(), answered.headers


def serves_page(command, folder):
    with start(command, folder, "--no-browser") as running:
        page, headers = answer(address_of(running))
        assert page == PAGE
        assert headers["Cache-Control"] == "no-store", headers
        assert end(running) == 0


def serves_scene(command, folder):
    with start(command, folder, "--no-browser", "scene.json") as running:
        page, _ = answer(address_of(running))
        assert '"format":"pelt-report"' in page and '"command":"pelt view' in page, page
        assert end(running) == 0


def refuses_other_names(command, folder):
    with start(command, folder, "--no-browser") as running:
        address = address_of(running)
        port = address.split(":")[-1].strip("/")
        assert answer(address, Host="localhost:" + port)[0] == PAGE
        try:
            page, _ = answer(address, Host="example.com:" + port)
            raise AssertionError("answered under another host's name: " + page)
        except urllib.error.HTTPError as error:
            assert error.code == 403, error
        assert end(running) == 0


def ends_at_once(command, folder):
    """Ctrl+C as early as it can come."""
    with start(command, folder, "--no-browser") as running:
        address_of(running)
        assert end(running) == 0


def refuses_taken_port(command, folder):
    with start(command, folder, "--no-browser") as running:
        port = address_of(running).split(":")[-1].strip("/")
        with start(command, folder, "--no-browser", "--port", port) as second:
            assert second.wait(timeout=PATIENCE) == 2
        assert end(running) == 0


def path_with(folder, opener):
    """A PATH on which `xdg-open` is that script."""
    programs = folder / "programs"
    programs.mkdir(exist_ok=True)
    (programs / "xdg-open").write_text(opener)
    (programs / "xdg-open").chmod(0o755)
    return str(programs) + os.pathsep + os.environ["PATH"]


def opens_browser(command, folder):
    """One that has no signal blocked, is not waited for, and is not ended by our Ctrl+C."""
    left = folder / "left"
    path = path_with(folder, BROWSER)
    with start(command, folder, PATH=path, LEFT=str(left)) as running:
        address = address_of(running)
        deadline = time.monotonic() + PATIENCE
        while not left.exists() and time.monotonic() < deadline:
            time.sleep(0.01)
        blocked, told = left.read_text().splitlines()
        opened, browser = told.split()
        try:
            assert opened == address, told
            assert int(blocked.split()[1], 16) == 0, blocked
            assert os.getpgid(int(browser)) != os.getpgid(running.pid)
            assert end(running) == 0
            os.kill(int(browser), 0)  # still there
        finally:
            os.kill(int(browser), signal.SIGKILL)


def says_where_no_browser_opens(command, folder):
    with start(command, folder, PATH=path_with(folder, "#!/bin/sh\nexit 3\n")) as running:
        address_of(running)
        assert running.stdout.readline() == "open this address in a browser\n"
        assert end(running) == 0


def main(command):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "viewer.html").write_text(PAGE)
        (folder / "scene.json").write_text(SCENE)
        for promise in (serves_page, serves_scene, refuses_other_names, ends_at_once,
                        refuses_taken_port, opens_browser, says_where_no_browser_opens):
            promise(command, folder)


main(sys.argv[1])
