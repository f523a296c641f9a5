"""Shapes and oracles for the tests of pelt.metrics."""

import itertools

import numpy as np

from support import box, moved

HERE = [[0, 0, 0]]


def joined(*meshes):
    """Returns one mesh of several."""
    starts = np.cumsum([0] + [len(rest) for rest, _ in meshes])
    return (np.concatenate([rest for rest, _ in meshes]),
            np.concatenate([faces + start for (_, faces), start in zip(meshes, starts)]))


def sphere(radius=1.0, rings=24):
    """Returns a sphere of latitudes and longitudes."""
    latitudes = np.linspace(0, np.pi, rings + 1)[1:-1]
    longitudes = np.arange(2 * rings) * np.pi / rings
    ring = [[np.sin(a) * np.cos(b), np.sin(a) * np.sin(b), np.cos(a)]
            for a in latitudes for b in longitudes]
    count, rows = 2 * rings, len(latitudes)
    rest = np.array([[0, 0, 1], *ring, [0, 0, -1]]) * radius
    faces = []
    for row, at in itertools.product(range(rows + 1), range(count)):
        after = (at + 1) % count
        above, below = 1 + (row - 1) * count, 1 + row * count
        if row < rows:
            faces.append([above + at if row else 0, below + at, below + after])
        if row > 0:
            faces.append([above + at, below + after if row < rows else len(rest) - 1, above + after])
    return rest, np.array(faces)


def boxes(count):
    """Returns cubes of side 2 in one mesh, 16 apart at rest, each with a joint of its own."""
    rest, faces = joined(*[box()] * count)
    rest[:, 0] += np.repeat(16 * np.arange(count), 8)
    return rest, faces, np.repeat(np.eye(count), 8, axis=0)


def two_boxes():
    return boxes(2)


def boxes_at(*offsets):
    """Returns palettes [F, n, 4, 4] that move each of n boxes from the first one by offsets [F, 3]."""
    return np.concatenate([moved(*np.asarray(offset, float) - [16 * joint, 0, 0])
                           for joint, offset in enumerate(offsets)], axis=1)


def apart(*offsets):
    """Returns palettes [F, 2, 4, 4] that move the second of two boxes by these offsets."""
    return boxes_at(HERE * len(offsets), offsets)


def ends_apart(*offsets):
    """Returns palettes [F, 2, 4, 4] that move the second joint only."""
    return np.concatenate([moved(*HERE * len(offsets)), moved(*offsets)], axis=1)


def brute_winding(point, triangles):
    """The winding number by solid angles, and whether it is near an integer."""
    a, b, c = np.moveaxis(triangles.astype(float) - point, 1, 0)
    lengths = [np.linalg.norm(v, axis=1) for v in (a, b, c)]
    volume = np.einsum("ij,ij->i", a, np.cross(b, c))
    below = (lengths[0] * lengths[1] * lengths[2] + (a * b).sum(1) * lengths[2]
             + (b * c).sum(1) * lengths[0] + (c * a).sum(1) * lengths[1])
    exact = 2 * np.arctan2(volume, below).sum() / (4 * np.pi)
    return round(exact), abs(exact - round(exact)) < 1e-6
