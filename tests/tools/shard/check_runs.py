"""Runs `pelt check` and `pelt merge` on small scenes, for the tests beside this file."""

import json
import math
import pathlib
import random
import re
import struct
import subprocess
import tempfile
import unittest

# Measured times, which differ from run to run.
MEASURED = re.compile(r"^(time|steps) .*\n", re.MULTILINE)

BODY = '{"model": "a", "clip": "%s", "start": %g, "translation": [%g, 0, 0]}'
RINGS, SIDES = 14, 10


def limb():
    """A closed tube along y of 2 units whose upper half bends, as a glTF file with two clips."""
    points, joints, weights, triangles = [], [], [], []
    for ring in range(RINGS):
        y = 2 * ring / (RINGS - 1)
        for side in range(SIDES):
            angle = 2 * math.pi * side / SIDES
            points += [0.3 * math.cos(angle), y, 0.3 * math.sin(angle)]
            joints += [0, 1, 0, 0]
            weights += [1 - y / 2, y / 2, 0, 0]
    for ring in range(RINGS - 1):
        for side in range(SIDES):
            low, next_low = ring * SIDES + side, ring * SIDES + (side + 1) % SIDES
            triangles += [low, low + SIDES, next_low, next_low, low + SIDES, next_low + SIDES]
    top = (RINGS - 1) * SIDES
    for side in range(1, SIDES - 1):
        triangles += [0, side, side + 1, top, top + side + 1, top + side]
    bend = []
    for degrees in (0, 170, 0):
        half = math.radians(degrees) / 2
        bend += [0, 0, math.sin(half), math.cos(half)]
    arrays = [("f", points, 5126, "VEC3"), ("H", joints, 5123, "VEC4"), ("f", weights, 5126, "VEC4"),
              ("H", triangles, 5123, "SCALAR"), ("f", [0, 0.5, 1], 5126, "SCALAR"),
              ("f", bend, 5126, "VEC4")]
    data, views, accessors = b"", [], []
    for code, values, component, kind in arrays:
        packed = struct.pack(f"<{len(values)}{code}", *values)
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[kind]
        accessors.append({"bufferView": len(views), "componentType": component, "type": kind,
                          "count": len(values) // width})
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(packed)})
        data += packed + bytes(-len(packed) % 4)
    accessors[0].update(min=[-.3, 0, -.3], max=[.3, 2, .3])
    accessors[4].update(min=[0], max=[1])
    sampler = {"samplers": [{"input": 4, "output": 5}],
               "channels": [{"sampler": 0, "target": {"node": 1, "path": "rotation"}}]}
    document = {
        "asset": {"version": "2.0"}, "buffers": [{"byteLength": len(data)}], "bufferViews": views,
        "accessors": accessors, "scenes": [{"nodes": [0, 2]}], "scene": 0,
        "nodes": [{"name": "lower", "children": [1]}, {"name": "upper", "translation": [0, 1, 0]},
                  {"name": "limb", "mesh": 0, "skin": 0}],
        "skins": [{"joints": [0, 1], "inverseBindMatrices": 6}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "JOINTS_0": 1, "WEIGHTS_0": 2},
                                    "indices": 3}]}],
        "animations": [{"name": "bend", **sampler}, {"name": "again", **sampler}]}
    identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    lowered = [*identity[:13], -1, *identity[14:]]
    packed = struct.pack("<32f", *identity, *lowered)
    accessors.append({"bufferView": len(views), "componentType": 5126, "type": "MAT4", "count": 2})
    views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(packed)})
    data += packed
    document["buffers"][0]["byteLength"] = len(data)
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    chunks += struct.pack("<II", len(data), 0x004E4942) + data
    return struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks


def scene(instances, frames='"count": 9, "fps": 8'):
    return ('{"models": {"a": "limb.glb"}, '
            f'"frames": {{{frames}}}, '
            f'"instances": [{", ".join(BODY % one for one in instances)}]}}')


def write_scenes(folder):
    folder = pathlib.Path(folder)
    (folder / "limb.glb").write_bytes(limb())
    (folder / "pair.json").write_text(scene([("bend", 0, 0), ("bend", .3, .7)]))
    dual = '{"a": {"file": "limb.glb", "skinning": "dual-quaternion"}}'
    (folder / "dual.json").write_text(
        scene([("bend", 0, 0), ("bend", .3, .7)]).replace('{"a": "limb.glb"}', dual))
    (folder / "one.json").write_text(scene([("bend", 0, 0)]))
    (folder / "apart.json").write_text(scene([("bend", 0, 0), ("bend", 0, 9)]))
    (folder / "clips.json").write_text(scene([("*", 0, 0), ("bend", .2, .7)], '"fps": 4'))


# The options of `pelt check` in combinations that are allowed.
CASES = [
    ["pair.json"],
    ["pair.json", "--pairs", "--list", "3"],
    ["pair.json", "--contacts"],
    ["pair.json", "--inside", "--pairs"],
    ["pair.json", "--clearance", "0.01", "--pairs"],
    ["pair.json", "--budget", "300", "--pairs"],
    ["pair.json", "--between", "--substeps", "2", "--pairs"],
    ["pair.json", "--between", "--self", "--inside", "--contacts"],
    ["pair.json", "--self", "only", "--self-always", "0.5", "--self-rings", "1", "--pairs"],
    ["pair.json", "--self", "--self-near-joints", "keep", "--pairs"],
    ["pair.json", "--first"],
    ["pair.json", "--max-contacts", "3", "--pairs"],
    ["pair.json", "--ignore", "a/upper,a/lower", "--pairs", "--between"],
    ["pair.json", "--frames", "1:9:2", "--between", "--pairs"],
    ["pair.json", "--frames", "4:5", "--pairs"],
    ["pair.json", "--method", "brute", "--frames", "0:2"],
    ["pair.json", "--method", "paper", "--pairs"],
    ["pair.json", "--skinning", "dual-quaternion", "--pairs"],
    ["dual.json", "--between", "--pairs"],
    ["one.json", "--pairs", "--by", "part", "--self"],
    ["clips.json", "--between", "--self", "--pairs"],
    ["apart.json", "--inside", "--between"],
]

# Options of the verdict and of the files, which `pelt merge` has, too.
OUTCOMES = [[], ["--fail-on", "never"], ["--list", "2"]]

SEED = random.randrange(2**32)


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


def hash_of(data):
    state = 0xcbf29ce484222325
    for byte in data:
        state = ((state ^ byte) * 0x100000001b3) & (2**64 - 1)
    return f"{state:016x}"


def write_shard(path, lines):
    """Writes lines of bytes as the file of a shard, with a matching last line."""
    body = b"".join(line + b"\n" for line in lines)
    last = {"lines": len(lines) - 1, "hash": hash_of(body)}
    path.write_bytes(body + json.dumps(last, separators=(",", ":")).encode() + b"\n")


def contacts_of(files):
    return json.loads(files[0].splitlines()[-1])["totals"]["contacts"]


class CheckTests(unittest.TestCase):
    """Runs `command` in a folder with the scenes."""

    command = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        write_scenes(self.folder)
        self.random = random.Random(SEED)

    def pelt(self, *arguments):
        return run(self.command, self.folder, *arguments)

    def refusal(self, *arguments):
        code, out, error = self.pelt(*arguments)
        self.assertEqual((code, out), (2, ""), error)
        return error

    def shards_of(self, check, count, name="s"):
        """Writes the shards of a check. Returns the names of their files."""
        files = []
        for index in range(1, count + 1):
            files.append(f"{name}{index}.shard")
            code, out, error = self.pelt("check", *check, "--shard", f"{index}/{count}", "-o",
                                         files[-1])
            self.assertEqual(code, 0, error)
            self.assertIn(f"shard      {index} of {count}: ", out)
        return files

    def expect_cuts_are_named(self, files):
        """Cuts the second of two shards anywhere, and merges them."""
        path = self.folder / files[1]
        good = path.read_bytes()
        cuts = {0, 1, len(good) - 1, good.rstrip().rfind(b"\n") + 1}
        cuts |= {self.random.randrange(len(good)) for _ in range(8)}
        for cut in sorted(cuts):
            path.write_bytes(good[:cut])
            error = self.refusal("merge", *files)
            self.assertRegex(error, "s2.shard: .*: (write shard 2/2 again|give files)", (SEED, cut))
        path.write_bytes(good)
