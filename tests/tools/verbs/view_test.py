#!/usr/bin/env python3
"""Requests the page of `pelt view` like a browser.

    view_test.py COMMAND
"""

import contextlib
import os
import pathlib
import signal
import socket
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
    """Ctrl+C as early as possible."""
    with start(command, folder, "--no-browser") as running:
        address_of(running)
        assert end(running) == 0


def refuses_taken_port(command, folder):
    with start(command, folder, "--no-browser") as running:
        port = address_of(running).split(":")[-1].strip("/")
        with start(command, folder, "--no-browser", "--port", port) as second:
            assert second.wait(timeout=PATIENCE) == 2
        assert end(running) == 0


def port_of(address):
    return int(address.split(":")[-1].strip("/"))


def connect(address):
    return socket.create_connection(("127.0.0.1", port_of(address)), timeout=PATIENCE)


def reply(connection):
    """Returns all that the server sends until it closes the connection."""
    parts = []
    while part := connection.recv(1 << 16):
        parts.append(part)
    return b"".join(parts).decode()


def ask(address, request):
    with connect(address) as connection:
        connection.sendall(request.encode())
        return reply(connection)


def peak_memory(running):
    """Returns MiB."""
    for line in pathlib.Path(f"/proc/{running.pid}/status").read_text().splitlines():
        if line.startswith("VmHWM:"):
            return int(line.split()[1]) / 1024
    raise AssertionError("no VmHWM")


def answers_ranges_whole(command, folder):
    """A request for a thousand ranges of a large page does not copy the page a thousand times."""
    large = PAGE + "x" * (4 << 20)
    (folder / "large.html").write_text(large)
    with start(command, folder, "--no-browser", PELT_VIEWER=str(folder / "large.html")) as running:
        address = address_of(running)
        before = peak_memory(running)
        page, headers = answer(address, Range="bytes=" + ",".join(["0-"] * 2000))
        assert page == large
        assert headers["Content-Length"] == str(len(large)), headers
        assert peak_memory(running) < before + 20, (before, peak_memory(running))
        assert end(running) == 0


def refuses_what_it_does_not_serve(command, folder):
    with start(command, folder, "--no-browser") as running:
        address = address_of(running)
        host = f"Host: localhost:{port_of(address)}\r\n"
        for request, status in (
                (f"GET / HTTP/1.1\r\n{host}\r\n", 200),
                (f"GET /?a=b HTTP/1.1\r\n{host}\r\n", 200),
                (f"HEAD / HTTP/1.1\r\n{host}\r\n", 200),
                (f"GET /secret HTTP/1.1\r\n{host}\r\n", 404),
                (f"GET /../../etc/passwd HTTP/1.1\r\n{host}\r\n", 404),
                (f"POST / HTTP/1.1\r\n{host}\r\n", 405),
                (f"POST / HTTP/1.1\r\n{host}Content-Length: 9999999999\r\n\r\n", 413),
                (f"GET / HTTP/1.1\r\n{host}Transfer-Encoding: chunked\r\n\r\n", 413),
                (f"GET / HTTP/1.1\r\n{host}{host}\r\n", 403),
                ("GET / HTTP/1.1\r\n\r\n", 403),
                (f"GET / HTTP/1.1\r\n{host}no colon\r\n\r\n", 400),
                (f"GET /\r\n{host}\r\n", 400),
                (f"GET / HTTP/2.0\r\n{host}\r\n", 400),
                ("\0\r\n\r\n", 400),
                (f"GET / HTTP/1.1\r\n{host}A: {'x' * 20000}\r\n\r\n", 431),
                (f"GET / HTTP/1.1\r\n{host}" + "B: y\r\n" * 5000 + "\r\n", 431),
                (f"GET /{'x' * 20000} HTTP/1.1\r\n{host}\r\n", 431)):
            said = ask(address, request)
            assert said.startswith(f"HTTP/1.1 {status} "), (request[:60], said[:200])
            assert "\r\nConnection: close\r\n" in said, said[:200]
        assert ask(address, f"HEAD / HTTP/1.1\r\n{host}\r\n").endswith("\r\n\r\n")
        assert answer(address)[0] == PAGE
        assert end(running) == 0


def open_descriptors(running):
    return len(list(pathlib.Path(f"/proc/{running.pid}/fd").iterdir()))


def outlasts_silent_connections(command, folder):
    """More clients than the server accepts send nothing, or too little; a browser is still answered."""
    with start(command, folder, "--no-browser") as running:
        address = address_of(running)
        with contextlib.ExitStack() as stack:
            silent = [stack.enter_context(connect(address)) for _ in range(40)]
            for connection in silent[::2]:
                connection.sendall(b"GET / HTTP/1.1\r\n")
            assert answer(address)[0] == PAGE
            assert silent[0].recv(1) == b"", "still open"
        deadline = time.monotonic() + PATIENCE
        while open_descriptors(running) > 12 and time.monotonic() < deadline:
            time.sleep(0.05)
        assert open_descriptors(running) <= 12
        assert end(running) == 0


def answers_beside_silent_connections(command, folder):
    """A browser replaces a client that has sent nothing, and does not wait for its end after 10 s."""
    with start(command, folder, "--no-browser") as running:
        address = address_of(running)
        with contextlib.ExitStack() as stack:
            silent = [stack.enter_context(connect(address)) for _ in range(40)]
            assert answer(address)[0] == PAGE
            silent[-1].setblocking(False)
            try:
                closed = silent[-1].recv(1) == b""
            except BlockingIOError:
                closed = False
            assert not closed, "waited until the silent connections ended"
        assert end(running) == 0


def stops_beside_a_waiting_connection(command, folder):
    with start(command, folder, "--no-browser") as running:
        with connect(address_of(running)):
            assert end(running) == 0


def answers_bytes_that_come_slowly(command, folder):
    with start(command, folder, "--no-browser") as running:
        address = address_of(running)
        with connect(address) as connection:
            for byte in f"GET / HTTP/1.1\r\nHost: localhost:{port_of(address)}\r\n\r\n".encode():
                connection.sendall(bytes([byte]))
                time.sleep(0.001)
            assert reply(connection).endswith(PAGE)
        assert end(running) == 0


def path_with(folder, opener):
    """Returns a PATH on which `xdg-open` is that script."""
    programs = folder / "programs"
    programs.mkdir(exist_ok=True)
    (programs / "xdg-open").write_text(opener)
    (programs / "xdg-open").chmod(0o755)
    return str(programs) + os.pathsep + os.environ["PATH"]


def opens_browser(command, folder):
    """The browser has no blocked signals, is not waited for, and is not ended by our Ctrl+C."""
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
            os.kill(int(browser), 0)  # still running
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
                        refuses_taken_port, answers_ranges_whole, refuses_what_it_does_not_serve,
                        outlasts_silent_connections, answers_beside_silent_connections,
                        stops_beside_a_waiting_connection, answers_bytes_that_come_slowly,
                        opens_browser, says_where_no_browser_opens):
            promise(command, folder)


main(sys.argv[1])
