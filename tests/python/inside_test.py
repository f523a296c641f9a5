"""pelt.side_of, pelt.winding_numbers, pelt.vertices_inside and pelt.deepest_vertex."""

import unittest

import numpy as np

import pelt
from support import Case, box, box_model, demo, moved


class Cubes(Case):
    def test_side_of(self):
        sides = pelt.side_of(box_model(), moved([0, 0, 0], [5, 0, 0]),
                             [[0, 0, 0], [1, 0.5, 0], [3, 0, 0], [5, 0, 0]])
        self.assertEqual(sides.tolist(), [[1, 0, -1, -1], [-1, -1, -1, 1]])

    def test_winding_numbers(self):
        rest, faces = box()
        # One cube inside another one, and one that is inside out.
        model = pelt.Model(np.concatenate([2 * rest, rest, rest + [9, 0, 0]]),
                           np.concatenate([faces, faces + 8, faces[:, ::-1] + 16]))
        points = [[0, 0, 0], [1.5, 0, 0], [3, 0, 0], [9, 0, 0], [2, 0, 0]]
        found = pelt.winding_numbers(model, moved([0, 0, 0], [3, 0, 0]), points)
        self.assertEqual(found.tolist(), [[2, 1, 0, -1, 0], [0, 1, 2, 0, 0]])
        self.assertEqual(found.dtype, np.int32)
        sides = pelt.side_of(model, moved([0, 0, 0], [3, 0, 0]), points)
        self.assertEqual(sides.tolist(), [[1, 1, -1, 1, 0], [-1, 1, 1, -1, 0]])
        self.refuses("points: row 0", pelt.winding_numbers, model, moved([0, 0, 0]), [[0, 0, np.nan]])

    def test_vertices_inside(self):
        inside = pelt.vertices_inside(box_model(), moved([0, 0, 0], [1.5, 1.5, 1.5], [9, 0, 0]),
                                      box_model(1.25), moved([0, 0, 0]))
        self.assertEqual(inside.sum(axis=1).tolist(), [8, 1, 0])
        self.assertEqual(inside.dtype, np.bool_)

    def test_deepest_vertex(self):
        found = pelt.deepest_vertex(box_model(), moved([1.5, 1.25, 1.5], [9, 0, 0]), box_model(),
                                    moved([0, 0, 0]))
        self.assertEqual(found.vertex.tolist(), [0, -1])
        self.assertEqual(found.depth.tolist(), [0.5, 0])
        self.assertEqual(found.position[0].tolist(), [0.5, 0.25, 0.5])
        self.assertTrue(np.isnan(found.position[1]).all())

    def test_open_surfaces_are_refused(self):
        rest, faces = box()
        opened, here = pelt.Model(rest, faces[1:]), moved([0, 0, 0])
        self.refuses("poses: the surface of the model is not closed", pelt.side_of, opened, here,
                     [[0, 0, 0]])
        self.refuses("poses: the surface of the model is not closed", pelt.winding_numbers, opened,
                     here, [[0, 0, 0]])
        self.refuses("poses_b", pelt.vertices_inside, box_model(), here, opened, here)
        self.refuses("poses_b", pelt.deepest_vertex, box_model(), here, opened, here)
        self.assertEqual(pelt.vertices_inside(opened, here, box_model(2), here).sum(), 8)


class Demo(Case):
    def test_deepest_is_inside(self):
        (a, poses_a), (b, poses_b) = demo()
        few = slice(30, 50)
        deepest = pelt.deepest_vertex(a, poses_a[few], b, poses_b[few])
        inside = pelt.vertices_inside(a, poses_a[few], b, poses_b[few])
        self.assertTrue(np.array_equal(inside.any(axis=1), deepest.vertex >= 0))
        frames = np.flatnonzero(deepest.vertex >= 0)
        self.assertGreater(len(frames), 3)
        self.assertTrue(inside[frames, deepest.vertex[frames]].all())


if __name__ == "__main__":
    unittest.main()
