"""pelt.bounds."""

import unittest

import numpy as np

import pelt
from support import Case, creature


class Creature(Case):
    def test_boxes(self):
        character = creature()
        poses = character.poses("walk")
        vertices = pelt.posed_vertices(character.model, poses)
        exact = pelt.bounds(character.model, poses)
        self.assertTrue(np.array_equal(exact.low, vertices.min(axis=1)))
        self.assertTrue(np.array_equal(exact.high, vertices.max(axis=1)))
        for levels in (0, 3):
            loose = pelt.bounds(character.model, poses, exact=False, levels=levels)
            self.assertTrue((loose.low <= exact.low).all() and (loose.high >= exact.high).all())
            self.assertTrue((loose.high - loose.low <= 2 * (exact.high - exact.low)).all())
        reach = np.linalg.norm(vertices - exact.centre[:, np.newaxis], axis=2).max(axis=1)
        self.assertTrue((reach <= exact.radius * (1 + 1e-6)).all())
        self.assertEqual(len(exact), len(poses))


if __name__ == "__main__":
    unittest.main()
