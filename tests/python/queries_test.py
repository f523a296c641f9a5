"""pelt.bounds, cast_rays, distance, closest_points, inside, collide_moving and height fields."""

import unittest

import numpy as np

import pelt
from support import Case, box, box_model, creature, demo, moved


class Bounds(Case):
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


class Rays(Case):
    def test_hits(self):
        cube = box_model()
        hits = pelt.cast_rays(cube, moved([0, 0, 0], [1, 0, 0]), [[-5, 0.25, 0.5], [0, 9, 0]],
                              [[2, 0, 0], [1, 0, 0]])
        self.assertEqual(hits.t.tolist(), [[2, np.inf], [2.5, np.inf]])
        self.assertEqual(hits.hit.tolist(), [[True, False], [True, False]])
        self.assertEqual(hits.normal[0, 0].tolist(), [-1, 0, 0])
        vertices = pelt.posed_vertices(cube, moved([0, 0, 0]))[0]
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


class DistanceCubes(Case):
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


class DistanceDemo(Case):
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


class InsideCubes(Case):
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


class InsideDemo(Case):
    def test_deepest_is_inside(self):
        (a, poses_a), (b, poses_b) = demo()
        few = slice(30, 50)
        deepest = pelt.deepest_vertex(a, poses_a[few], b, poses_b[few])
        inside = pelt.vertices_inside(a, poses_a[few], b, poses_b[few])
        self.assertTrue(np.array_equal(inside.any(axis=1), deepest.vertex >= 0))
        frames = np.flatnonzero(deepest.vertex >= 0)
        self.assertGreater(len(frames), 3)
        self.assertTrue(inside[frames, deepest.vertex[frames]].all())


class MotionCubes(Case):
    def test_time(self):
        """A cube moves 8 units, and touches the other one after 3."""
        cube = box_model()
        line = moved([5, 0, 0], [-3, 0, 0], [-9, 0, 0])
        found = pelt.collide_moving(cube, line, cube, moved([0, 0, 0]))
        self.assertEqual(found.steps, 2)
        self.assertEqual((found.per_step() > 0).tolist(), [True, False])
        self.assertEqual(found.time.min(), np.float32(3 / 8))
        self.assertFalse(found.at_start.any())
        first = pelt.first_contact(cube, line, cube, moved([0, 0, 0]))
        self.assertEqual((len(first), first.step[0], first.time[0]), (1, 0, np.float32(3 / 8)))
        without = pelt.collide_moving(cube, line, cube, moved([0, 0, 0]), times=False)
        self.assertTrue(np.array_equal(without.triangle_b, found.triangle_b))
        self.assertEqual(without.time.max(), 0)
        few = pelt.collide_moving(cube, line, cube, moved([0, 0, 0]), max_contacts=2)
        self.assertEqual(len(few), 2)

    def test_self(self):
        rest, faces = box()
        model = pelt.Model(np.concatenate([rest, rest + [5, 0, 0]]),
                           np.concatenate([faces, faces + 8]), np.repeat(np.eye(2), 8, axis=0))
        poses = np.tile(np.eye(4), (2, 2, 1, 1))
        poses[1, 1, 0, 3] = -8
        found = pelt.self_collide_moving(model, poses)
        self.assertEqual(found.time.min(), np.float32(3 / 8))
        none = pelt.self_collide_moving(model, poses, pelt.SelfFilter(model, joint_pairs=[[0, 1]]))
        self.assertEqual((len(none), none.left_out["joints"]), (0, len(found)))

    def test_one_frame_is_no_motion(self):
        cube = box_model()
        self.refuses("two frames", pelt.collide_moving, cube, moved([0, 0, 0]), cube,
                     moved([0, 0, 0]))
        self.refuses("two frames", pelt.self_collide_moving, cube, moved([0, 0, 0]))


class MotionDemo(Case):
    def test_frames_are_contained(self):
        """What intersects in a frame intersects in the steps before and after it."""
        (a, poses_a), (b, poses_b) = demo()
        few = slice(36, 42)
        arguments = a, poses_a[few], b, poses_b[few]
        contacts, moving = pelt.collide(*arguments), pelt.collide_moving(*arguments)
        self.assertGreater(len(contacts), 100)
        pairs = {row for row in zip(moving.step.tolist(), moving.triangle_a.tolist(),
                                    moving.triangle_b.tolist())}
        for frame, s, t in zip(contacts.frame.tolist(), contacts.triangle_a.tolist(),
                               contacts.triangle_b.tolist()):
            self.assertTrue(frame == 5 or (frame, s, t) in pairs)
            self.assertTrue(frame == 0 or (frame - 1, s, t) in pairs)
        self.assertEqual(np.count_nonzero(moving.at_start),
                         np.count_nonzero(contacts.frame < contacts.frames - 1))
        first = pelt.first_contact(*arguments)
        self.assertTrue((first.per_step() == (moving.per_step() > 0)).all())


def hills(random, rows=20, columns=30):
    return random.uniform(0, 0.4, (rows, columns))


class HeightField(Case):
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
