"""pelt.collide_solid and pelt.solid_distance, compared with brute force."""

import unittest

import numpy as np

import pelt
from support import Case, box, box_model, creature, moved, random_rotation


def triangles_of(character, poses):
    """Returns the posed triangles [F, T, 3, 3] in float64."""
    return pelt.posed_vertices(character.model, poses)[:, character.faces].astype(float)


def pairs_of(found):
    return set(zip(found.frame.tolist(), found.triangle.tolist()))


def point_triangle(point, triangles):
    """Returns the distances of a point from triangles [T, 3, 3], by the face and the three edges."""
    a, b, c = np.moveaxis(triangles, 1, 0)
    normals = np.cross(b - a, c - a)
    lengths = np.linalg.norm(normals, axis=1)
    normals /= np.maximum(lengths, 1e-300)[:, np.newaxis]
    above = np.einsum("ij,ij->i", point - a, normals)
    foot = point - above[:, np.newaxis] * normals
    inside = lengths > 0
    least = np.full(len(a), np.inf)
    for p, q in ((a, b), (b, c), (c, a)):
        inside &= np.einsum("ij,ij->i", np.cross(q - p, foot - p), normals) >= 0
        t = np.einsum("ij,ij->i", point - p, q - p) / np.maximum(((q - p) ** 2).sum(1), 1e-300)
        nearest = p + np.clip(t, 0, 1)[:, np.newaxis] * (q - p)
        least = np.minimum(least, np.linalg.norm(point - nearest, axis=1))
    return np.where(inside, np.minimum(np.abs(above), least), least)


class Walk(Case):
    @classmethod
    def setUpClass(cls):
        cls.character = creature()
        cls.model = cls.character.model
        cls.walk = cls.character.palettes("walk", frames=4)
        cls.triangles = triangles_of(cls.character, cls.walk)

    def check(self, solid, touches, inside, least=100):
        """Compares the answer with flags [F, T]; `least`: contacts at least."""
        found = pelt.collide_solid(self.model, self.walk, solid)
        expected = set(zip(*(axis.tolist() for axis in np.nonzero(touches))))
        self.assertEqual(pairs_of(found), expected)
        self.assertGreater(len(expected), least)
        self.assertEqual(found.inside.tolist(), inside[found.frame, found.triangle].tolist())
        self.assertEqual(found.per_frame().tolist(), touches.sum(axis=1).tolist())
        self.assertEqual(found.in_frame(1).tolist(), np.flatnonzero(touches[1]).tolist())
        apart = pelt.solid_distance(self.model, self.walk, solid)
        self.assertEqual((apart.distance == 0).tolist(), touches.any(axis=1).tolist())

    def test_half_space(self):
        heights = self.triangles[..., 1]
        for level in (0.05, 0.9):
            solid = pelt.HalfSpace([0, 1, 0], level)
            level = np.float32(level)
            self.check(solid, (heights <= level).any(axis=2), (heights <= level).all(axis=2))

    def test_moving_half_space(self):
        heights = self.triangles[..., 1]
        levels = np.array([0.05, 0.5, 0.1, 0.9], np.float32)
        for offsets in (levels, levels.astype(float)):
            self.check(pelt.HalfSpace([0, 1, 0], offsets),
                       (heights <= levels[:, None, None]).any(axis=2),
                       (heights <= levels[:, None, None]).all(axis=2))

    def test_sphere(self):
        centre, radius = np.array([0.125, 1.0, 0.0625]), 0.25
        distances = np.array([point_triangle(centre, triangles) for triangles in self.triangles])
        inside = (np.linalg.norm(self.triangles - centre, axis=3) <= radius).all(axis=2)
        self.check(pelt.Sphere(centre, radius), distances <= radius, inside)
        self.check(pelt.Capsule(centre, centre, radius), distances <= radius, inside)
        small = pelt.solid_distance(self.model, self.walk, pelt.Sphere(centre, 0.001))
        np.testing.assert_allclose(small.distance, distances.min(axis=1) - 0.001, atol=1e-6)
        ends = np.linalg.norm(small.solid - small.surface.position, axis=1)
        np.testing.assert_allclose(ends, small.distance, atol=1e-6)

    def test_capsule_contains_its_spheres(self):
        a, b = np.array([-0.5, 1, 0]), np.array([0.5, 1.25, 0])
        capsule = pairs_of(pelt.collide_solid(self.model, self.walk, pelt.Capsule(a, b, 0.125)))
        spheres = set()
        for t in np.linspace(0, 1, 60):
            spheres |= pairs_of(pelt.collide_solid(self.model, self.walk,
                                                   pelt.Sphere(a + t * (b - a), 0.124)))
        self.assertGreater(len(spheres), 500)
        self.assertLessEqual(spheres, capsule)
        self.assertLess(len(capsule - spheres), 0.1 * len(capsule))

    def box_flags(self, centre, rotation, half):
        """By the surface of the box, and the vertices inside it."""
        rest, faces = box()
        surface = pelt.Model((rest * half) @ rotation + centre, faces)
        touching = pelt.collide(self.model, self.walk, surface, np.eye(4)[np.newaxis, np.newaxis])
        local = (self.triangles - centre) @ rotation.T
        inside = (np.abs(local) <= half).all(axis=(2, 3))
        touches = inside.copy()
        touches[touching.frame, touching.triangle_a] = True
        return touches, inside

    def test_box(self):
        centre, half = np.array([0.125, 1, 0]), np.array([0.25, 0.125, 0.5])
        flags = self.box_flags(centre, np.eye(3), half)
        self.check(pelt.Box(centre - half, centre + half), *flags)
        self.check(pelt.OrientedBox(centre, half), *flags)

    def test_oriented_box(self):
        random = np.random.default_rng(4)
        centre, half, rotation = np.array([0.1, 1, 0]), np.array([0.3, 0.1, 0.5]), random_rotation(random)
        self.check(pelt.OrientedBox(centre, half, rotation), *self.box_flags(centre, rotation, half))

    def test_poses_of_one_frame(self):
        centres = [[0, 1, 0], [0, 1.5, 0], [9, 9, 9]]
        stand = self.character.palettes()
        found = pelt.collide_solid(self.model, stand, pelt.Sphere(centres, 0.3))
        single = [pelt.collide_solid(self.model, stand, pelt.Sphere(centre, 0.3)) for centre in centres]
        self.assertEqual(found.per_frame().tolist(), [len(one) for one in single])
        self.assertEqual(found.frames, 3)
        self.assertGreater(len(single[0]), 0)
        self.assertEqual(len(single[2]), 0)

    def test_threads(self):
        solid = pelt.HalfSpace([0, 1, 0], 0.5)
        one = pelt.collide_solid(self.model, self.walk, solid, threads=1)
        many = pelt.collide_solid(self.model, self.walk, solid, threads=4)
        for name in ("frame", "triangle", "inside"):
            np.testing.assert_array_equal(getattr(one, name), getattr(many, name))

    def test_max_distance(self):
        far = pelt.Sphere([100, 0, 0], 1)
        found = pelt.solid_distance(self.model, self.walk, far, max_distance=5)
        self.assertTrue(np.isinf(found.distance).all() and np.isnan(found.solid).all())
        self.assertEqual(found.surface.triangle.tolist(), [-1] * 4)


class Refused(Case):
    def test_solids(self):
        model, poses = box_model(), moved([0, 0, 0], [1, 0, 0])
        for message, solid in [
                (r"HalfSpace: normal: is zero", pelt.HalfSpace([0, 0, 0])),
                (r"HalfSpace, normal: expected \[3\] or \[F, 3\]", pelt.HalfSpace([0, 1])),
                (r"HalfSpace, offset: expected a number or \[F\]", pelt.HalfSpace([0, 1, 0], [[1]])),
                (r"Box: low: is above high", pelt.Box([1, 0, 0], [0, 1, 1])),
                (r"Box, frame 1: low: is above high", pelt.Box([0, 0, 0], [[1, 1, 1], [1, -1, 1]])),
                (r"Sphere: radius: expected 0 or more, found -1", pelt.Sphere([0, 0, 0], -1)),
                (r"Sphere: has a number that is not a finite", pelt.Sphere([0, 0, np.nan], 1)),
                (r"Sphere: has a number that is not a finite", pelt.Sphere([0, 0, 0], 1e300)),
                (r"Sphere, radius: expected float32", pelt.Sphere([0, 0, 0], "large")),
                (r"Capsule: its members have 2 and 3 frames",
                 pelt.Capsule(np.zeros((2, 3)), np.zeros((3, 3)), 1)),
                (r"poses has 2 frames, but the solid has 3", pelt.Sphere(np.zeros((3, 3)), 1)),
                (r"Sphere: there are no frames", pelt.Sphere(np.zeros((0, 3)), 1)),
                (r"OrientedBox: half: expected 0 or more", pelt.OrientedBox([0, 0, 0], [1, 1, -1])),
                (r"OrientedBox, axes: expected \[3, 3\] or", pelt.OrientedBox([0, 0, 0], [1, 1, 1],
                                                                            [1, 0, 0]))]:
            for function in (pelt.collide_solid, pelt.solid_distance):
                with self.subTest(message, function=function.__name__):
                    self.refuses(message, function, model, poses, solid)
        self.refuses("max_distance: expected 0 or more", pelt.solid_distance, model, poses,
                     pelt.Sphere([0, 0, 0], 1), max_distance=-1)
        with self.assertRaisesRegex(TypeError, "solid: expected one of HalfSpace, .*found tuple"):
            pelt.collide_solid(model, poses, ([0, 0, 0], 1))


if __name__ == "__main__":
    unittest.main()
