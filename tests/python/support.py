"""Shared by the tests: files, the command, simple bodies."""

import functools
import os
import pathlib
import subprocess
import sys
import unittest

import numpy as np

import pelt

COMMAND = os.environ["PELT_COMMAND"]
DEMO = pathlib.Path(os.environ["PELT_DEMO"])
SHARED = pathlib.Path(os.environ["PELT_SHARED"])
SOURCE = pathlib.Path(os.environ["PELT_SOURCE"])


def skip_program(reason):
    """Ends the test as skipped."""
    print(f"skipped: {reason}")
    sys.exit(77)


def shared(file):
    """Returns a file of the folder of shared characters, or skips the test."""
    if not (SHARED / file).exists():
        raise unittest.SkipTest(f"no {SHARED / file}")
    return SHARED / file


def printed_hash(*arguments):
    """Returns the hash that `pelt check` prints."""
    result = subprocess.run([COMMAND, "check", *map(str, arguments)], capture_output=True, text=True)
    lines = [line.split() for line in result.stdout.splitlines() if line.startswith("hash ")]
    assert len(lines) == 1, result.stdout + result.stderr
    return lines[0][1]


@functools.lru_cache(None)
def demo():
    """Returns (model, poses) of the two characters of the demo's scene."""
    from scene_poses import load_scene

    return load_scene(DEMO / "scene.json")


@functools.lru_cache(None)
def creature():
    """Returns a character of the demo."""
    return pelt.load(DEMO / "azure.glb")


def box(half=1.0):
    """Returns rest positions and faces of a cube around the origin; its faces point outwards."""
    corners = [[x, y, z] for x in (-half, half) for y in (-half, half) for z in (-half, half)]
    faces = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6],
             [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]
    return np.array(corners, float), np.array(faces)


def box_model(half=1.0):
    """Returns a cube that moves as one piece."""
    return pelt.Model(*box(half))


def moved(*positions):
    """Returns palettes [F, 1, 4, 4] of a body of one joint at these positions."""
    palettes = np.tile(np.eye(4), (len(positions), 1, 1, 1))
    palettes[:, 0, :3, 3] = positions
    return palettes


def random_rotation(random):
    """Returns a random rotation [3, 3]."""
    q, _ = np.linalg.qr(random.normal(size=(3, 3)))
    return q * np.linalg.det(q)


class Case(unittest.TestCase):
    """A test that can expect a message."""

    def refuses(self, pattern, function, *arguments, **options):
        with self.assertRaisesRegex(pelt.Error, pattern):
            function(*arguments, **options)
