"""Runs `pelt check` and `pelt merge` on small generated scenes, for the tests beside this file."""

import json
import pathlib
import re
import subprocess

# Measured times, which differ from run to run.
MEASURED = re.compile(r"^(time|steps) .*\n", re.MULTILINE)

BODY = '{"model": "a", "clip": "%s", "start": %g, "translation": [%g, 0, 0]}'


def scene(instances, frames='"count": 7, "fps": 6'):
    return ('{"models": {"a": {"creature": {"triangles": 1000}}}, '
            f'"frames": {{{frames}}}, '
            f'"instances": [{", ".join(BODY % one for one in instances)}]}}')


def write_scenes(folder):
    pathlib.Path(folder, "pair.json").write_text(scene([("walk", 0, 0), ("idle", .3, .4)]))
    pathlib.Path(folder, "one.json").write_text(scene([("walk", 0, 0)]))
    pathlib.Path(folder, "apart.json").write_text(scene([("walk", 0, 0), ("idle", 0, 9)]))
    pathlib.Path(folder, "clips.json").write_text(
        scene([("*", 0, 0), ("walk", .2, .4)], '"fps": 2'))


# The options of `pelt check` in combinations that are allowed.
CASES = [
    ["pair.json"],
    ["pair.json", "--pairs", "--list", "3"],
    ["pair.json", "--contacts"],
    ["pair.json", "--inside", "--pairs"],
    ["pair.json", "--clearance", "0.01", "--pairs"],
    ["pair.json", "--budget", "2000", "--pairs"],
    ["pair.json", "--between", "--substeps", "2", "--pairs"],
    ["pair.json", "--between", "--self", "--inside", "--contacts"],
    ["pair.json", "--self", "only", "--self-always", "0.5", "--self-rings", "1", "--pairs"],
    ["pair.json", "--self", "--self-near-joints", "keep", "--pairs"],
    ["pair.json", "--first"],
    ["pair.json", "--max-contacts", "3", "--pairs"],
    ["pair.json", "--ignore", "a/head,a/*", "--pairs", "--between"],
    ["pair.json", "--frames", "1:7:2", "--between", "--pairs"],
    ["pair.json", "--frames", "4:5", "--pairs"],
    ["pair.json", "--method", "brute", "--frames", "0:2"],
    ["pair.json", "--method", "paper", "--pairs"],
    ["one.json", "--pairs", "--by", "part", "--self"],
    ["clips.json", "--between", "--self", "--pairs"],
    ["apart.json", "--inside", "--between"],
]

# Options of the verdict and of the files, which `pelt merge` has, too.
OUTCOMES = [[], ["--fail-on", "never"], ["--list", "2"]]


def run(command, folder, *arguments):
    """The exit code, the summary without measured times, and the errors."""
    ended = subprocess.run([command, *arguments], cwd=folder, capture_output=True, text=True,
                           check=False)
    return ended.returncode, MEASURED.sub("", ended.stdout), ended.stderr


def answer(command, folder, *arguments):
    """As `run`, and the bytes of all outputs."""
    ended = run(command, folder, *arguments, "--jsonl", "out.jsonl", "--glb", "out.glb")
    files = []
    for name in ("out.jsonl", "out.glb"):
        path = pathlib.Path(folder, name)
        files.append(path.read_bytes() if path.exists() else None)
        path.unlink(missing_ok=True)
    return ended, files


def contacts_of(files):
    return json.loads(files[0].splitlines()[-1])["totals"]["contacts"]
