"""pelt.metrics.ground, by hand."""

import unittest

import numpy as np

import pelt
from pelt import metrics
from support import Case, box_model, moved


class Ground(Case):
    def of_boxes(self, *centres, **options):
        """A cube of side 2 at these places."""
        return metrics.ground(box_model(), moved(*centres), **options)

    def test_heights(self):
        found = self.of_boxes([0, 0, 1], [0, 0, 0.9], [0, 0, 1.25], [5, 0, 0.996], [0, 0, 1.004])
        np.testing.assert_allclose(found.penetrate, [0, 0.1, 0, 0, 0], atol=1e-6)
        np.testing.assert_allclose(found.floating, [0, 0, 0.25, 0, 0], atol=1e-6)

    def test_skate(self):
        found = self.of_boxes([0, 0, 0.5], [3, 4, 0.25], [3, 4, 2], [3, 5, 0.5])
        np.testing.assert_allclose(found.skate, [5, 0, 0], atol=1e-6)
        self.assertEqual(self.of_boxes([0, 0, 0]).skate.shape, (0,))

    def test_skate_is_a_mean_over_vertices(self):
        """One of the eight vertices moves, among four on the ground."""
        rest = box_model()
        frames = np.array([np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (0, 2)], float)
                           for _ in range(2)])
        frames[1, 0] += [2, 0, 0]
        found = metrics.ground(rest, pelt.Vertices(frames))
        np.testing.assert_allclose(found.skate, [0.5])

    def test_up_and_height(self):
        places = np.array([[0, 3.5, 0], [1, 3.25, 2]])
        found = self.of_boxes(*places, up=[0, 4, 0], height=3)
        np.testing.assert_allclose(found.penetrate, [0.5, 0.75], atol=1e-6)
        np.testing.assert_allclose(found.skate, [np.sqrt(5)], atol=1e-6)

    def test_up_of_any_length(self):
        expected = self.of_boxes([0, 3.5, 0], [1, 3.25, 2], up=[0, 1, 1], height=2)
        self.assertGreater(expected.penetrate[0], 0.5)
        for length in (1e-200, 1e200, 3e307):
            found = self.of_boxes([0, 3.5, 0], [1, 3.25, 2], up=[0, length, length], height=2)
            for a, b in zip(found, expected):
                np.testing.assert_allclose(a, b, rtol=1e-12, err_msg=str(length))

    def test_triangles_of_the_half_space(self):
        """The triangles at the ground are those of a half-space whose normal has the length 1."""
        solid = pelt.HalfSpace([0, 1, 0], 0.25)
        poses = moved([0, 1.25, 0], [0, 1.375, 0])
        found = pelt.collide_solid(box_model(), poses, solid).per_frame() > 0
        np.testing.assert_array_equal(found, [True, False])
        lowest = metrics.ground(box_model(), poses, up=[0, 2, 0], height=0.25, tolerance=0)
        np.testing.assert_array_equal(lowest.floating, [0, 0.125])

    def test_vertices_on_the_ground_along_an_axis(self):
        """Vertices exactly at the height of the ground stay on it."""
        for up in ([0, 0, 3], [0, 0, 0.1]):
            found = self.of_boxes([0.1, 0.1, 1.125], [3.1, 4.1, 1.125], up=up, height=0.125)
            np.testing.assert_allclose(found.skate, [5], atol=1e-6)

    def test_tolerance(self):
        found = self.of_boxes([0, 0, 0.9], tolerance=0.2)
        self.assertEqual(found.penetrate[0], 0)

    def test_refused(self):
        for options in ({"up": [0, 0, 0]}, {"up": [0, 1]}, {"up": [0, 0, np.nan]}, {"up": "z"},
                        {"height": np.inf}, {"tolerance": -1}, {"height": "low"}):
            with self.subTest(options):
                self.refuses("up|height", self.of_boxes, [0, 0, 0], **options)


if __name__ == "__main__":
    unittest.main()
