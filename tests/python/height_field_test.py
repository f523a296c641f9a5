"""pelt.HeightField, collide_field and field_distance, compared with the mesh of the field."""

import unittest

import numpy as np

import pelt
from support import Case, box_model, creature, moved


def hills(random, rows=20, columns=30):
    return random.uniform(0, 0.4, (rows, columns))


class Field(Case):
    def test_triangles(self):
        heights = np.arange(6.0).reshape(2, 3)
        field = pelt.HeightField(heights, origin=(10, 20, 30), column_spacing=0.5, row_spacing=2)
        self.assertEqual((field.rows, field.columns, field.triangle_count), (2, 3, 4))
        corners = {tuple(corner) for corner in field.triangles.reshape(-1, 3).tolist()}
        self.assertEqual(corners, {(10 + 0.5 * c, 20 + heights[r, c], 30 + 2 * r)
                                   for r in range(2) for c in range(3)})
        normals = np.cross(*(field.triangles[:, k] - field.triangles[:, 0] for k in (1, 2)))
        self.assertTrue((normals[:, 1] > 0).all())

    def test_is_its_mesh(self):
        random = np.random.default_rng(2)
        character = creature()
        walk = character.palettes("walk", frames=4)
        field = pelt.HeightField(hills(random), origin=(-1.5, -0.2, -1), column_spacing=0.1,
                                 row_spacing=0.1)
        corners = field.triangles
        mesh = pelt.Model(corners.reshape(-1, 3), np.arange(corners.size // 3).reshape(-1, 3))
        still = np.eye(4)[np.newaxis, np.newaxis]
        found = pelt.collide_field(character.model, walk, field)
        self.assertEqual(found, pelt.collide(character.model, walk, mesh, still))
        self.assertGreater(len(found), 100)
        self.assertEqual(found, pelt.collide_field(character.model, walk, field, threads=3))
        above = walk.copy()
        above[..., 1, 3] += 0.75
        apart = pelt.field_distance(character.model, above, field)
        expected = pelt.distance(character.model, above, mesh, still)
        np.testing.assert_array_equal(apart.distance, expected.distance)
        self.assertGreater(apart.distance.min(), 0)
        self.assertEqual(apart.b.triangle.tolist(), expected.b.triangle.tolist())

    def test_holes(self):
        heights = np.zeros((3, 3))
        heights[1, 1] = np.nan
        field = pelt.HeightField(heights, origin=(-1, 0, -1))
        self.assertEqual(np.isnan(field.triangles).any(axis=(1, 2)).sum(), 6)
        found = pelt.collide_field(box_model(0.25), moved([0, 0, 0], [0.75, 0, -0.75]), field)
        self.assertEqual((found.per_frame() > 0).tolist(), [False, True])

    def test_max_contacts(self):
        field = pelt.HeightField(np.zeros((5, 5)), origin=(-2, 0, -2))
        found = pelt.collide_field(box_model(), moved([0, 0, 0]), field, max_contacts=3)
        self.assertEqual((len(found), found.cut_short.tolist()), (3, [True]))

    def test_refused(self):
        flat = np.zeros((3, 3))
        for message, heights, options in [
                (r"heights: expected the shape \[rows, columns\]", np.zeros(4), {}),
                ("HeightField: ", np.zeros((1, 4)), {}),
                ("HeightField: ", np.full((2, 2), np.inf), {}),
                ("HeightField: ", np.full((2, 2), 1e30), {}),
                ("HeightField: ", flat, {"column_spacing": 0}),
                ("HeightField: ", flat, {"row_spacing": np.nan}),
                ("HeightField: ", flat, {"column_spacing": 1e-30, "origin": (1, 0, 0)}),
                ("HeightField: ", np.zeros((0, 0)), {}),
                ("origin: expected three numbers", flat, {"origin": (0, 0)}),
                ("origin: expected a number", flat, {"origin": (0, 0, "x")}),
                ("heights: expected float32", [["high"]], {})]:
            with self.subTest(message):
                self.refuses(message, pelt.HeightField, heights, **options)
        field = pelt.HeightField(flat)
        self.refuses("max_distance: expected 0 or more", pelt.field_distance, box_model(),
                     moved([0, 0, 0]), field, max_distance=np.nan)
        with self.assertRaisesRegex(TypeError, "field: expected a pelt.HeightField"):
            pelt.collide_field(box_model(), moved([0, 0, 0]), flat)


if __name__ == "__main__":
    unittest.main()
