"""The same answers for all element types and layouts of arrays."""

import unittest

import numpy as np

import pelt
from support import Case, creature, demo


def layouts(array):
    """Yields arrays with the same elements in other layouts."""
    yield "fortran", np.asfortranarray(array)
    yield "every second", np.repeat(array, 2, axis=0)[::2]
    yield "reversed", array[::-1].copy()[::-1]
    yield "transposed", np.ascontiguousarray(np.swapaxes(array, -1, -2)).swapaxes(-1, -2)
    yield "big endian", array.astype(array.dtype.newbyteorder(">"))
    raw = np.zeros(array.nbytes + 1, np.uint8)
    unaligned = raw[1:].view(np.uint8)[:array.nbytes].view(array.dtype).reshape(array.shape)
    unaligned[...] = array
    yield "not aligned", unaligned
    read_only = array.copy()
    read_only.flags.writeable = False
    yield "read-only", read_only


class Palettes(Case):
    @classmethod
    def setUpClass(cls):
        (cls.a, poses_a), (cls.b, poses_b) = demo()
        cls.palettes_a, cls.palettes_b = poses_a.palettes, poses_b.palettes
        cls.expected = pelt.collide(cls.a, cls.palettes_a, cls.b, cls.palettes_b)
        assert len(cls.expected) > 1000

    def same(self, palettes, what):
        found = pelt.collide(self.a, palettes, self.b, self.palettes_b)
        self.assertEqual(found, self.expected, what)

    def test_layouts(self):
        self.assertEqual(self.palettes_a.dtype, np.float32)
        for what, palettes in layouts(self.palettes_a):
            self.same(palettes, what)

    def test_masked(self):
        masked = np.ma.masked_array(self.palettes_a, np.zeros(self.palettes_a.shape, bool))
        self.same(masked, "masked arrays without a masked element")
        masked[0, 0, 0, 3] = np.ma.masked
        self.refuses("poses_a: has masked elements", pelt.collide, self.a, masked, self.b,
                     self.palettes_b)

    def test_double(self):
        for what, palettes in layouts(self.palettes_a.astype(np.float64)):
            self.same(palettes, what)

    def test_three_rows(self):
        self.same(self.palettes_a[:, :, :3], "view of three rows")
        self.same(np.ascontiguousarray(self.palettes_a[:, :, :3]), "three rows")

    def test_lists(self):
        few = slice(40, 42)
        self.assertEqual(
            pelt.collide(self.a, self.palettes_a[few].tolist(), self.b,
                         self.palettes_b[few].tolist()),
            pelt.collide(self.a, self.palettes_a[few], self.b, self.palettes_b[few]))

    def test_poses(self):
        self.same(pelt.Poses(self.palettes_a), "Poses")

    def test_rounds_double_once(self):
        palettes = self.palettes_a.astype(np.float64)
        halfway = np.nextafter(palettes.astype(np.float32), np.float32(np.inf)).astype(np.float64)
        palettes[:, :, :3] += (halfway - palettes)[:, :, :3] * 0.4
        self.same(palettes, "rounded")


class Meshes(Case):
    def test_layouts(self):
        character = creature()
        rest, faces = character.rest, character.faces
        weights = np.ones((len(rest), 1), np.float32)
        expected = pelt.Model(rest, faces, weights).to_bytes()
        for what, array in layouts(rest):
            self.assertEqual(pelt.Model(array, faces, weights).to_bytes(), expected, what)
        for what, array in layouts(weights):
            self.assertEqual(pelt.Model(rest, faces, array).to_bytes(), expected, what)
        for what, array in layouts(faces):
            self.assertEqual(pelt.Model(rest, array, weights).to_bytes(), expected, what)
        for kind in (np.uint16, np.int64, np.uint64, np.uint32):
            self.assertEqual(pelt.Model(rest, faces.astype(kind), weights).to_bytes(), expected)


if __name__ == "__main__":
    unittest.main()
