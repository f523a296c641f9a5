"""pelt.cast_rays."""

import unittest

import numpy as np

import pelt
from support import Case, box_model, moved


class Cubes(Case):
    def test_hits(self):
        cube = box_model()
        hits = pelt.cast_rays(cube, moved([0, 0, 0], [1, 0, 0]), [[-5, 0.25, 0.5], [0, 9, 0]],
                              [[2, 0, 0], [1, 0, 0]])
        self.assertEqual(hits.t.tolist(), [[2, np.inf], [2.5, np.inf]])
        self.assertEqual(hits.hit.tolist(), [[True, False], [True, False]])
        self.assertEqual(hits.normal[0, 0].tolist(), [-1, 0, 0])
        vertices = pelt.posed_vertices(cube, moved([0, 0, 0]))[0]
        from support import box
        corners = vertices[box()[1][hits.triangle[0, 0]]]
        self.assertTrue(np.allclose(hits.barycentrics[0, 0] @ corners, [-1, 0.25, 0.5]))

    def test_options(self):
        cube, here = box_model(), moved([0, 0, 0])
        ray = [[-5, 0.25, 0.5]], [[1, 0, 0]]
        self.assertEqual(pelt.cast_rays(cube, here, *ray, facing="back").t[0, 0], 6)
        self.assertEqual(pelt.cast_rays(cube, here, *ray, t_min=5).t[0, 0], 6)
        self.assertFalse(pelt.cast_rays(cube, here, *ray, t_max=3).hit.any())
        moving = pelt.cast_rays(cube, moved([0, 0, 0], [0, 0, 0]),
                                [[[-5, 0.25, 0.5]], [[-6, 0.25, 0.5]]], [[1, 0, 0]])
        self.assertEqual(moving.t.tolist(), [[4], [5]])

    def test_refusals(self):
        cube, here = box_model(), moved([0, 0, 0])
        self.refuses("facing", pelt.cast_rays, cube, here, [[0, 0, 0]], [[1, 0, 0]], facing="up")
        self.refuses("origins", pelt.cast_rays, cube, here, [[0, 0, np.nan]], [[1, 0, 0]])
        self.refuses("directions", pelt.cast_rays, cube, here, [[0, 0, 0]], [[np.inf, 0, 0]])
        self.refuses("one for each of the 2 origins", pelt.cast_rays, cube, here,
                     [[0, 0, 0]] * 2, [[1, 0, 0]])
        self.refuses("t_min", pelt.cast_rays, cube, here, [[0, 0, 0]], [[1, 0, 0]], t_min=np.nan)


if __name__ == "__main__":
    unittest.main()
