"""pelt.Poses, pelt.Vertices and pelt.posed_vertices."""

import pickle
import unittest

import numpy as np

import pelt
from support import Case, box, box_model, creature, moved


class OfPoses(Case):
    def test_slices(self):
        poses = pelt.Poses(moved([0, 0, 0], [1, 0, 0], [2, 0, 0]), np.zeros((3, 2)))
        self.assertEqual(len(poses), 3)
        self.assertEqual(len(poses[1:]), 2)
        self.assertEqual(poses[1:].morph_weights.shape, (2, 2))
        self.assertEqual(repr(poses), "<pelt.Poses: 3 frames, 1 joints, 2 morph weights>")
        poses = pelt.Poses(moved([0, 0, 0], [1, 0, 0]), offsets=np.zeros((8, 3)))
        self.assertEqual(poses[1:].offsets.shape, (1, 8, 3))
        self.assertEqual(repr(poses), "<pelt.Poses: 2 frames, 1 joints, offsets>")

    def test_one_set_of_weights(self):
        self.assertEqual(pelt.Poses(moved(*np.zeros((3, 3))), [1, 2]).morph_weights.shape, (3, 2))

    def test_vertices(self):
        vertices = pelt.Vertices(np.zeros((2, 8, 3)))
        self.assertEqual(repr(vertices[:1]), "<pelt.Vertices: 1 frames, 8 vertices>")


class GivenVertices(Case):
    def test_answers_are_those_of_palettes(self):
        character = creature()
        walk = character.palettes("walk", frames=5)
        given = pelt.Vertices(pelt.posed_vertices(character.model, walk).astype(np.float64))
        self.assertEqual(pelt.self_collide(character.model, given),
                         pelt.self_collide(character.model, walk))
        self.assertTrue(np.array_equal(pelt.bounds(character.model, given).low,
                                       pelt.bounds(character.model, walk).low))

    def test_of_a_mesh_without_joints(self):
        cube = box_model()
        rest = pelt.posed_vertices(cube, moved([0, 0, 0]))
        stretched = pelt.Vertices(rest * [[[1, 1, 1]], [[4, 1, 1]]])
        self.assertEqual((pelt.collide(cube, stretched, cube, moved([3, 0, 0])).per_frame() > 0)
                         .tolist(), [False, True])

    def test_refusals(self):
        cube = box_model()
        bad = np.zeros((2, 8, 3))
        bad[1, 3, 2] = np.nan
        self.refuses("poses, frame 1: .*3", pelt.posed_vertices, cube, pelt.Vertices(bad))
        self.refuses(r"poses: expected the shape \[F, 8, 3\], found \[2, 7, 3\]",
                     pelt.posed_vertices, cube, pelt.Vertices(bad[:, :7]))

    def test_of_equal_vertices(self):
        rest, faces = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 1, 0]], [[0, 1, 2], [1, 0, 3]]
        folded = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.2, 0.2, 0]]
        opened = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, -1, 0]]
        found = pelt.self_collide(pelt.Model(rest, faces, weld=False), pelt.Vertices([folded, opened]))
        self.assertEqual(found.per_frame().tolist(), [1, 0])
        self.refuses(r"merged both .*pelt\.Model\(\.\.\., weld=False\)", pelt.posed_vertices,
                     pelt.Model(rest, faces), pelt.Vertices(opened))


class Offsets(Case):
    def setUp(self):
        self.rest, self.faces = box()
        self.model = pelt.Model(self.rest, self.faces, np.ones((8, 1)), offset_caps=np.full(8, 0.5))
        self.offsets = np.random.default_rng(2).uniform(-0.5, 0.5, (3, 8, 3)).astype(np.float32)

    def test_are_added_after_the_joints(self):
        palettes = moved([0, 0, 0], [1, 0, 0], [2, 0, 0])
        palettes[:, :, :3, :3] *= 2
        without = pelt.posed_vertices(self.model, palettes)
        for model in self.model, pickle.loads(pickle.dumps(self.model)):
            posed = pelt.posed_vertices(model, pelt.Poses(palettes, offsets=self.offsets))
            self.assertTrue(np.array_equal(posed, without + self.offsets))
        once = pelt.posed_vertices(self.model, pelt.Poses(palettes, offsets=self.offsets[1]))
        self.assertTrue(np.array_equal(once, without + self.offsets[1]))

    def test_queries(self):
        poses = pelt.Poses(moved(*np.zeros((3, 3))), offsets=self.offsets)
        given = pelt.Vertices(pelt.posed_vertices(self.model, poses))
        other, there = box_model(), moved([2, 0.3, 0.2])
        for threads in (1, 2):
            found = pelt.collide(self.model, poses, other, there, threads=threads)
            self.assertEqual(found, pelt.collide(self.model, given, other, there))
        self.assertEqual(len(set(found.per_frame().tolist()) - {0}), 3)  # frames differ

    def test_refusals(self):
        here = moved([0, 0, 0], [0, 0, 0], [0, 0, 0])
        for element in (0.6, np.nan):
            self.offsets[1, 2, 0] = element
            self.refuses("poses, frame 1: the offsets of 1 vertices are NaN or beyond the caps",
                         pelt.posed_vertices, self.model, pelt.Poses(here, offsets=self.offsets))
        self.refuses(r"poses, offsets: expected the shape \[3, 8, 3\]", pelt.posed_vertices, self.model,
                     pelt.Poses(here, offsets=self.offsets[:2]))
        self.refuses("poses, frame 0: .*: give pelt.Model offset_caps", pelt.posed_vertices,
                     pelt.Model(self.rest, self.faces), pelt.Poses(here, offsets=self.offsets))
        self.refuses(r"offset_caps: expected the shape \[8\]", pelt.Model, self.rest, self.faces,
                     offset_caps=[1])
        self.refuses("offset_cap", pelt.Model, self.rest, self.faces, offset_caps=np.full(8, -1.0))


class OfPosedVertices(Case):
    def test_skinning(self):
        """Linear blend skinning in NumPy gives nearly the same."""
        random = np.random.default_rng(3)
        rest = random.normal(size=(30, 3))
        faces = random.integers(0, 30, (40, 3))
        weights = random.uniform(size=(30, 5)) * (random.uniform(size=(30, 5)) < 0.5)
        weights[:, 2] += 0.1
        weights /= weights.sum(axis=1, keepdims=True)
        palettes = np.tile(np.eye(4), (6, 5, 1, 1))
        palettes[:, :, :3] += random.normal(size=(6, 5, 3, 4))
        blended = np.einsum("vj,fjab->fvab", weights, palettes)
        expected = np.einsum("fvab,vb->fva", blended, np.c_[rest, np.ones(30)])[..., :3]
        found = pelt.posed_vertices(pelt.Model(rest, faces, weights), palettes)
        self.assertEqual(found.dtype, np.float32)
        self.assertTrue(np.allclose(found, expected, atol=1e-5))

    def test_an_error_leaves_nothing_behind(self):
        """Morph weights that are too large in one frame do not make the next palette invalid."""
        model = pelt.Model(*(np.zeros((3, 3)) + np.eye(3), [[0, 1, 2]]),
                           morph_targets=np.ones((1, 3, 3)))
        palettes = moved([0, 0, 0], [0, 0, 0])
        palettes[1, 0, :3, :3] *= 2.0 ** 40
        weights = [[2.0 ** 40], [1.0]]
        both = pelt.posed_vertices(model, pelt.Poses(palettes, weights), threads=1)
        alone = pelt.posed_vertices(model, pelt.Poses(palettes[1:], weights[1:]))
        self.assertTrue(np.array_equal(both[1:], alone))


class Refusals(Case):
    def test_messages(self):
        cube, good = box_model(), moved([0, 0, 0], [1, 0, 0])
        transposed = np.swapaxes(good, 2, 3)
        self.refuses("poses, frame 1: the last row of the matrix of joint 0", pelt.posed_vertices,
                     cube, transposed)
        bad = good.copy()
        bad[1, 0, 1, 2] = np.nan
        self.refuses("poses, frame 1: palette\\[0\\] has the element nan", pelt.posed_vertices, cube, bad)
        bad[1, 0, 1, 2] = 1e300
        self.refuses("poses, frame 1", pelt.posed_vertices, cube, bad)
        self.refuses(r"expected the shape \[F, 1, 4, 4\] or \[F, 1, 3, 4\], found \[2, 3, 4, 4\]",
                     pelt.posed_vertices, cube, np.zeros((2, 3, 4, 4)))
        self.refuses("there are no frames", pelt.posed_vertices, cube, np.zeros((0, 1, 4, 4)))
        self.refuses("complex", pelt.posed_vertices, cube, good.astype(complex))
        self.refuses("morph_weights", pelt.posed_vertices, cube, pelt.Poses(good, [[1]] * 2))

    def test_types(self):
        with self.assertRaisesRegex(TypeError, "model_a: expected a pelt.Model"):
            pelt.collide(creature(), moved([0, 0, 0]), box_model(), moved([0, 0, 0]))


if __name__ == "__main__":
    unittest.main()
