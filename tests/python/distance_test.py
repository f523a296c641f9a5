"""pelt.distance and pelt.closest_points."""

import unittest

import numpy as np

import pelt
from support import Case, box_model, demo, moved


class Cubes(Case):
    def test_distance(self):
        cube = box_model()
        found = pelt.distance(cube, moved([0, 0, 0]), cube, moved([5, 0, 0], [2, 0, 0], [0, 0, 9]))
        self.assertEqual(found.distance.tolist(), [3, 0, 7])
        self.assertEqual(found.a.position[0, 0], 1)
        self.assertEqual(found.b.position[2, 2], 8)
        self.assertEqual(len(found), 3)

    def test_max_distance(self):
        cube = box_model()
        found = pelt.distance(cube, moved([0, 0, 0]), cube, moved([5, 0, 0]), max_distance=2)
        self.assertEqual((found.distance[0], found.a.triangle[0]), (np.inf, -1))
        self.assertTrue(np.isnan(found.b.position).all())

    def test_closest_points(self):
        cube = box_model()
        found = pelt.closest_points(cube, moved([0, 0, 0], [1, 0, 0]), [[3, 0, 0], [0, 0, 0.5]])
        self.assertEqual(found.distance.tolist(), [[2, 0.5], [1, 0]])
        self.assertEqual(found.point.position[0, 0].tolist(), [1, 0, 0])
        none = pelt.closest_points(cube, moved([0, 0, 0]), [[3, 0, 0]], max_distance=1)
        self.assertEqual(none.point.triangle[0, 0], -1)
        moving = pelt.closest_points(cube, moved([0, 0, 0], [1, 0, 0]), [[[3, 0, 0]], [[4, 0, 0]]])
        self.assertEqual(moving.distance.tolist(), [[2], [2]])

    def test_refusals(self):
        cube, here = box_model(), moved([0, 0, 0])
        self.refuses("max_distance", pelt.distance, cube, here, cube, here, max_distance=-1)
        self.refuses("tolerance", pelt.distance, cube, here, cube, here, tolerance=np.nan)
        self.refuses("points: row 1 has the coordinate", pelt.closest_points, cube, here,
                     [[0, 0, 0], [0, np.inf, 0]])
        self.refuses("points", pelt.closest_points, cube, here, [[0, 0, 2.0 ** 61]])
        self.refuses("points", pelt.closest_points, cube, here, [0, 0, 0])
        self.refuses("points", pelt.closest_points, cube, here, np.zeros((3, 1, 3)))


class Demo(Case):
    def test_zero_if_and_only_if_they_touch(self):
        (a, poses_a), (b, poses_b) = demo()
        found = pelt.distance(a, poses_a, b, poses_b)
        touch = pelt.intersects(a, poses_a, b, poses_b)
        self.assertTrue(np.array_equal(found.distance == 0, touch))
        apart = ~touch
        self.assertTrue(np.allclose(
            np.linalg.norm(found.a.position - found.b.position, axis=1)[apart],
            found.distance[apart], atol=1e-5))
        self.assertGreater(np.count_nonzero(touch), 5)
        self.assertGreater(np.count_nonzero(apart), 5)


if __name__ == "__main__":
    unittest.main()
