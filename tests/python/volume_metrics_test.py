"""Volumes of pelt.metrics on shapes with known answers."""

import unittest

import numpy as np

import generated_body
import pelt
from metric_shapes import apart, brute_winding, sphere, two_boxes
from pelt import metrics
from support import Case, box, box_model, moved


class Volumes(Case):
    def test_boxes(self):
        found = metrics.intersection_volume(box_model(), moved([1.5, 0.25, 0], [9, 0, 0]), box_model(),
                                            moved([0, 0, 0]))
        self.assertTrue((np.abs(found.value - [0.5 * 1.75 * 2, 0]) <= found.error).all())
        self.assertLess(found.error.max(), 1e-9)
        self.assertAlmostEqual(metrics.volume(box_model(), moved([3, 0, 0])).value[0], 8)

    def test_spheres(self):
        model = pelt.Model(*sphere(rings=48))
        lens = 5 * np.pi / 12  # of unit spheres at distance 1
        found = metrics.intersection_volume(model, moved([1, 0, 0]), model, moved([0, 0, 0]))
        self.assertLess(abs(found.value[0] / lens - 1), 0.01)
        self.assertLess(abs(metrics.volume(model, moved([0, 0, 0])).value[0] / (4 / 3 * np.pi) - 1), 0.01)

    def test_of_one_body(self):
        model, poses = pelt.Model(*two_boxes()), apart([1.5, 0.25, 0], [5, 0, 0])
        found = metrics.self_intersection_volume(model, poses)
        self.assertTrue((np.abs(found.value - [1.75, 0]) <= found.error + 1e-12).all())

    def test_triangles_that_face_inwards(self):
        rest, faces = box()
        inwards, here = pelt.Model(rest, faces[:, ::-1]), moved([0, 0, 0])
        self.assertEqual(metrics.volume(inwards, here).value[0], -8)
        self.assertEqual(metrics.self_intersection_volume(inwards, here).value[0], 8)
        found = metrics.intersection_volume(inwards, here, box_model(), moved([1.5, 0.25, 0]))
        self.assertLessEqual(abs(found.value[0] + 0.5 * 1.75 * 2), found.error[0])

    def test_is_not_negative(self):
        # Without the bound, rounding made some of these values -1e-17.
        random = np.random.default_rng(5)
        keys = generated_body.arrays()
        rest = keys["v_template"] + random.normal(size=(200, 1, 3))
        model = pelt.Model(keys["v_template"], keys["f"].astype(int))
        found = metrics.self_intersection_volume(model, pelt.Vertices(rest))
        self.assertGreaterEqual(found.value.min(), 0)
        self.assertTrue((found.value <= found.error).all())

    def test_voxels_of_one_body(self):
        model = pelt.Model(*two_boxes())
        poses = apart([1.5, 0.25, 0.1], [5, 0, 0])
        found = metrics.voxel_self_intersection_volume(model, poses, side=0.25)
        triangles = pelt.posed_vertices(model, poses)[:, two_boxes()[1]]
        for frame in (0, 1):
            axes = [np.arange(-12, 28)] * 3
            centres = (np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3) + 0.5) * 0.25
            centres = centres[(np.abs(centres[:, 1:]) < 1.5).all(axis=1)]
            counts = [brute_winding(centre, triangles[frame]) for centre in centres]
            self.assertTrue(all(is_sure for _, is_sure in counts))
            windings = np.array([count for count, _ in counts])
            shared = windings[windings >= 2].sum()
            self.assertEqual(found.volume[frame], shared * 0.25**3)
            self.assertEqual(found.percent[frame], 100 * shared / windings.sum())
        self.assertGreater(found.volume[0], 0)
        self.refuses("side: expected a positive number", metrics.voxel_self_intersection_volume, model,
                     poses, side=0)

    def test_open_surfaces(self):
        rest, faces = box()
        self.refuses("not closed", metrics.volume, pelt.Model(rest, faces[1:]), moved([0, 0, 0]))

    def test_voxels(self):
        bodies = [(box_model(), moved([1.5, 0.2, 0], [9, 0, 0])), (box_model(), moved([0, 0, 0]))]
        coarse = metrics.voxel_intersection_volume(bodies, side=0.5)
        self.assertEqual(coarse.volume.tolist(), [1 * 4 * 4 * 0.125, 0])  # 1.8 is rounded up to 2
        self.assertEqual(coarse.percent.tolist(), [100 * 16 / (64 + 64 - 16), 0])
        fine = metrics.voxel_intersection_volume(bodies, side=0.1)
        self.assertLess(abs(fine.volume[0] - 1.8), 0.2)
        self.refuses("side: frame 0 would need", metrics.voxel_intersection_volume, bodies, side=1e-3)

    def test_voxels_miss_what_is_thin(self):
        bodies = [(box_model(), moved([1.99, 0, 0])), (box_model(), moved([0.0, 0, 0]))]
        self.assertEqual(metrics.voxel_intersection_volume(bodies, side=0.25).volume[0], 0)
        exact = metrics.intersection_volume(*bodies[0], *bodies[1])
        self.assertAlmostEqual(exact.value[0], 0.04, 6)


if __name__ == "__main__":
    unittest.main()
