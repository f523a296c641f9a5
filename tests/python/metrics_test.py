"""pelt.metrics on shapes with known answers."""

import inspect
import itertools
import pydoc
import unittest

import numpy as np

import generated_body
import pelt
from metric_shapes import (HERE, apart, boxes, boxes_at, brute_winding, ends_apart, sphere,
                           two_boxes)
from pelt import body_models, datasets, metrics, motions
from support import Case, box, box_model, moved


class Help(Case):
    def test_states_source_shapes_and_units(self):
        functions = [name for name in metrics.__all__ if inspect.isfunction(getattr(metrics, name))]
        self.assertGreater(len(functions), 12)
        units = "percent|model units|units: see|without unit|number of vertices|pairs of triangles|how many"
        for name in functions:
            text = inspect.getdoc(getattr(metrics, name))
            with self.subTest(name):
                self.assertIn(name, metrics.__doc__)
                for part in ("Definition: ", "Source: ", units, r"[\[ ][FT][,\] ]|Arguments: see"):
                    self.assertRegex(text, part)
        for name in set(metrics.__all__) - set(functions):
            text = inspect.getdoc(getattr(metrics, name))
            self.assertTrue(text, name)
            for field in getattr(getattr(metrics, name), "_fields", ()):
                self.assertRegex(text, rf"(?m)^{field}: +\S", name)

    def test_signatures_are_short(self):
        """Types are shown by their names, not as unions of the types that NumPy makes arrays of."""
        for module in (metrics, body_models, datasets, motions):
            self.assertNotIn("numpy._typing", pydoc.plain(pydoc.render_doc(module)))
        self.assertIn("poses: 'PosesLike'", pydoc.plain(pydoc.render_doc(metrics.colliding_triangles)))


class Collisions(Case):
    def test_colliding_triangles(self):
        rest, faces, weights = two_boxes()
        model = pelt.Model(rest, faces, weights)
        poses = apart([1.5, 0.3, 0.2], [5, 0, 0])
        share = metrics.colliding_triangles(model, poses)
        pairs = pelt.self_collide(model, poses)
        self.assertEqual(share.pairs.tolist(), [len(pairs), 0])
        self.assertGreater(len(pairs), 4)
        self.assertEqual(share.percent.tolist(), [100 * len(pairs) / 24, 0])
        touched = set(pairs.triangle_a) | set(pairs.triangle_b)
        self.assertEqual(share.triangles.tolist(), [len(touched), 0])
        self.assertEqual(share.triangle_percent[0], 100 * len(touched) / 24)

    def test_pairs_that_share_a_corner(self):
        # Two triangles at one edge, folded flat, and two with one common corner, crossing each other.
        rest = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [1, 1, 1],
                [8, 0, 0], [12, -2, 0], [12, 2, 0], [9, 0, -1], [9, 0, 1]]
        faces = [[0, 1, 2], [1, 0, 3], [4, 5, 6], [4, 7, 8]]
        model = pelt.Model(rest, faces)
        flat = np.array(rest, float)
        flat[3] = [0.5, 0.5, 0]
        poses = pelt.Vertices([flat])
        self.assertEqual(metrics.colliding_triangles(model, poses).pairs.tolist(), [0])
        all_pairs = metrics.colliding_triangles(model, poses, pelt.SelfFilter(model)).pairs
        self.assertEqual(all_pairs.tolist(), [2])
        unrelated = metrics.smplify_x_filter(model, segments=[3, 5, 3, 5], segment_parents=[-1] * 4)
        self.assertEqual(metrics.colliding_triangles(model, poses, unrelated).pairs.tolist(), [0])
        self.assertEqual(metrics.capped_colliding_triangles(model, poses, faces).pairs.tolist(), [0])

    def test_cap(self):
        rest, faces, weights = two_boxes()
        random = np.random.default_rng(4)
        poses = apart([9, 0, 0], *random.uniform(0.1, 1.9, (12, 3)))
        model = pelt.Model(rest, faces, weights)
        pairs = metrics.colliding_triangles(model, poses).pairs
        lost = last = 0
        for cap in (0, 1, 2, 3, 4, 12):
            capped = metrics.capped_colliding_triangles(model, poses, faces, cap=cap)
            for frame in range(13):
                kept, hits, is_last = self.by_brute_force(model, poses[frame:frame + 1], faces, cap)
                self.assertEqual((capped.pairs[frame], capped.box_hits[frame]), (kept, hits))
                self.assertEqual(capped.percent[frame], kept * (100 / 24))
                self.assertEqual(capped.pairs[frame] + capped.lost[frame], pairs[frame])
                if hits <= cap * 24:
                    self.assertEqual(capped.lost[frame], 0)
                last += is_last
            lost += np.count_nonzero(capped.lost)
        self.assertGreater(lost, 20)
        self.assertGreater(last, 5)
        self.assertEqual(capped.lost.tolist(), [0] * 13)
        self.refuses("faces: expected the shape", metrics.capped_colliding_triangles, model, poses,
                     faces[1:])

    def by_brute_force(self, model, poses, faces, cap):
        """Returns the number of pairs among the first cap x T box hits, the number of all box hits, and
        whether the first one beyond the cap is a pair."""
        triangles = pelt.posed_vertices(model, poses)[0][faces]
        pairs = set(zip(*pelt.self_collide(model, poses, pelt.SelfFilter(model, rings=1))
                        .in_frame(0).T))
        hits = [(a, b) for a in range(len(faces)) for b in range(a + 1, len(faces))
                if all(triangles[a][:, k].min() <= triangles[b][:, k].max()
                       and triangles[b][:, k].min() <= triangles[a][:, k].max() for k in range(3))]
        most = cap * len(faces)
        return (sum(hit in pairs for hit in hits[:most]), len(hits),
                any(hit in pairs for hit in hits[most:most + 1]))

    def test_box_hits_of_a_body(self):
        keys = generated_body.arrays()
        rest, faces = keys["v_template"], keys["f"].astype(int)
        model = pelt.Model(rest, faces)
        pushed = rest.copy()
        pushed[rest[:, 0] > 0.25, 0] -= 0.4
        poses = pelt.Vertices(np.stack([rest, pushed]))
        capped = metrics.capped_colliding_triangles(model, poses, faces, cap=100)
        triangles = np.stack([rest, pushed]).astype(np.float32)[:, faces]
        for frame, (low, high) in enumerate(zip(triangles.min(2), triangles.max(2))):
            meets = ((low[:, np.newaxis] <= high) & (low <= high[:, np.newaxis])).all(2)
            self.assertEqual(capped.box_hits[frame], np.triu(meets, 1).sum())
        self.assertGreater(capped.pairs[1], 0)
        self.assertEqual(capped.lost.tolist(), [0, 0])

    def test_smplify_x_filter(self):
        model = pelt.Model(*boxes(4))
        poses = boxes_at(*([[0.1 * j, 0.2 * j, 0.05 * j]] for j in range(4)))
        pairs = pelt.self_collide(model, poses).in_frame(0) // 12
        parts = {tuple(pair) for pair in pairs.tolist()}
        self.assertEqual(parts, {(a, b) for a in range(4) for b in range(a + 1, 4)})
        parents = [-1, 0, 0, 1]  # (0, 1), (0, 2), (1, 3) are parent and child; (1, 2) is ignored
        expected = sum(tuple(pair) in {(0, 3), (2, 3)} for pair in pairs.tolist())
        by_joints = metrics.smplify_x_filter(model, parents)
        by_segments = metrics.smplify_x_filter(
            model, segments=np.repeat(range(4), 12), segment_parents=np.repeat(parents, 12))
        for ignore in by_joints, by_segments:
            self.assertEqual(metrics.colliding_triangles(model, poses, ignore).pairs[0], expected)
        self.refuses("expected joint_parents, or segments", metrics.smplify_x_filter, model)

    def test_smplify_x_filter_of_neck_and_left_hand(self):
        """The hands of SMPL, 22 and 23, are both in the neck, 12."""
        at = {12: 0.0, 22: 1.5, 23: -1.5}
        model = pelt.Model(*boxes(24))
        poses = boxes_at(*([[at.get(joint, 16.0 * joint), 0.1, 0]] for joint in range(24)))
        parents = [-1] + [0] * 23
        shares = [metrics.colliding_triangles(model, poses, metrics.smplify_x_filter(
            model, parents, ignored_pairs=ignored)).pairs[0]
            for ignored in (metrics.SMPLIFY_X_IGNORED, metrics.SMPLIFY_X_IGNORED[:-1])]
        self.assertGreater(shares[0], 0)
        self.assertGreater(shares[1], shares[0])


class Penetration(Case):
    def test_vertices_inside(self):
        inside = metrics.vertices_inside(box_model(), moved([0, 0, 0], [1.5, 1.5, 1.5], [9, 0, 0]),
                                         box_model(1.25), moved([0, 0, 0]))
        self.assertEqual(inside.count_a.tolist(), [8, 1, 0])
        self.assertEqual(inside.count_b.tolist(), [0, 1, 0])
        self.assertEqual(inside.fraction_b.tolist(), [0, 1 / 8, 0])

    def test_frames(self):
        found = metrics.penetration_frames(
            box_model(), moved([0, 0, 0], [1.5, 1.5, 1.5], [9, 0, 0], [8, 0, 0]), box_model(1.25),
            moved([0, 0, 0]))
        self.assertEqual(found.collides.tolist(), [True, True, False, False])
        self.assertEqual((found.frame_percent, found.penetration), (50, (1 / 2 + 1 / 8) / 2))
        none = metrics.penetration_frames(box_model(), moved([9, 0, 0]), box_model(), moved([0, 0, 0]))
        self.assertEqual((none.frame_percent, none.penetration), (0, 0))

    def test_depth(self):
        found = metrics.depth(box_model(), moved([1.5, 1.25, 1.5], [9, 0, 0]), box_model(),
                              moved([0, 0, 0]))
        self.assertEqual((found.per_frame.tolist(), found.deepest, found.mean), ([0.5, 0], 0.5, 0.25))

    def test_summed_depth(self):
        # One corner of each box is inside the other one, 0.75 deep.
        arguments = (box_model(), moved([1.5, 1.25, 1.25], [9, 0, 0]), box_model(1.25),
                     moved([0, 0, 0]))
        found = metrics.summed_depth(*arguments)
        self.assertEqual((found.per_frame.tolist(), found.mean, found.frame_percent),
                         ([1.5, 0], 0.75, 50))
        found = metrics.summed_depth(*arguments, counted_a=np.zeros(8, bool))
        self.assertEqual(found.per_frame.tolist(), [0.75, 0])
        found = metrics.summed_depth(*arguments, counted_b=np.zeros(8, int))
        self.assertEqual(found.per_frame.tolist(), [0.75, 0])
        self.refuses("counted_b: expected the shape", metrics.summed_depth, *arguments, counted_b=[1])

    def test_summed_depth_against_distances(self):
        rest, faces = sphere(rings=8)
        model = pelt.Model(rest, faces)
        here, there = moved(*HERE * 3), moved([1.2, 0.1, 0.3], [3, 0, 0], [0.4, 0.2, -0.9])
        found = metrics.summed_depth(model, here, model, there)
        posed = [pelt.posed_vertices(model, poses) for poses in (here, there)]
        for frame in range(3):
            expected = 0.0
            for a, b in ((0, 1), (1, 0)):
                triangles = posed[b][frame][faces]
                for vertex in posed[a][frame].astype(float):
                    if brute_winding(vertex, triangles)[0]:
                        points = pelt.closest_points(model, (here, there)[b][frame], [vertex])
                        expected += points.distance[0, 0]
            self.assertAlmostEqual(found.per_frame[frame], expected, 9)
        self.assertEqual((found.per_frame > 0).tolist(), [True, False, True])


def strip(length=100, step=0.0101):
    """A ribbon of this many squares along x, one square wide; joints at both ends."""
    rest = np.array([[step * i, y, 0] for i in range(length + 1) for y in (0, step)])
    faces = [[2 * i + a for a in triangle] for i in range(length)
             for triangle in ([0, 2, 3], [0, 3, 1])]
    end = rest[:, 0] > step * length / 2
    return rest, np.array(faces), np.stack([~end, end], axis=1).astype(float)


class SelfContact(Case):
    def setUp(self):
        self.rest, self.faces, weights = strip()
        self.model = pelt.Model(self.rest, self.faces, weights)
        self.geodesics = metrics.Geodesics(self.rest, self.faces)

    def test_rest_is_free(self):
        found = metrics.self_contact(self.model, ends_apart([0, 0, 0]), self.geodesics)
        self.assertEqual(found.percent.tolist(), [0])
        self.assertTrue(np.isinf(found.distance).all())

    def test_against_brute_force(self):
        # Moves the second half over the first one, 1.5 cm above.
        offsets = [[-0.5, 0, 0.015], [-0.3, 0.004, 0.015], [-0.2, 0, 0.015], [0, 0, 0.5]]
        poses = ends_apart(*offsets)
        found = metrics.self_contact(self.model, poses, self.geodesics)
        posed = pelt.posed_vertices(self.model, poses).astype(float)
        along = self.floyd()
        hits = 0
        for frame in range(len(offsets)):
            apart_by = np.linalg.norm(posed[frame][:, np.newaxis] - posed[frame], axis=2)
            apart_by[along < 0.3] = np.inf
            least = apart_by.min(axis=1)
            least[least > 0.02] = np.inf
            hits += int(np.isfinite(least).sum())
            self.assertTrue(np.array_equal(np.isfinite(least), found.touching[frame]))
            self.assertTrue(np.allclose(least, found.distance[frame], rtol=1e-6))
        self.assertGreater(hits, 100)
        self.assertEqual(found.percent[3], 0)

    def floyd(self):
        """Distances along edges of all pairs, by the algorithm of Floyd and Warshall."""
        rest = self.rest.astype(np.float32).astype(float)
        along = np.full((len(rest), len(rest)), np.inf)
        for face in self.faces:
            for a, b in itertools.permutations(face, 2):
                along[a, b] = np.linalg.norm(rest[a] - rest[b])
        np.fill_diagonal(along, 0)
        for k in range(len(rest)):
            along = np.minimum(along, along[:, k:k + 1] + along[k])
        return along

    def test_refused(self):
        self.refuses("limit: expected a positive number", metrics.Geodesics, self.rest, self.faces, 0)
        self.refuses("rest: vertex 3 is not finite", metrics.Geodesics,
                     np.where(np.arange(len(self.rest))[:, np.newaxis] == 3, np.nan, self.rest),
                     self.faces)
        self.refuses("faces: element 2", metrics.Geodesics, self.rest[:3], self.faces)
        self.refuses("geodesics: made for 8 vertices", metrics.self_contact, self.model,
                     ends_apart([0, 0, 0]), metrics.Geodesics(*box()))


class Parts(Case):
    def setUp(self):
        keys = generated_body.arrays()
        self.weights = keys["weights"]
        self.rest, self.faces = keys["v_template"], keys["f"].astype(int)

    def test_parts_of_a_body(self):
        # Left and right arm, and the remaining body.
        arm = 0.25
        parts = np.where(self.rest[:, 0] > arm, 1, np.where(self.rest[:, 0] < -arm, 2, 0))
        body = metrics.BodyParts(self.rest, self.faces, parts)
        self.assertEqual(body.numbers, [0, 1, 2])
        self.assertTrue(all(body.model(number).is_closed for number in body.numbers))
        model = pelt.Model(self.rest, self.faces)
        pushed = np.stack([self.rest, self.rest]).astype(np.float32)
        pushed[1, parts == 1] -= [0.45, 0.2, 0]
        inside = body.vertices_inside(model, pelt.Vertices(pushed))
        self.assertFalse(inside[0].any())
        self.assertGreater(inside[1, parts == 1].sum(), 10)
        bodies = [(body.model(n), body.poses(n, pushed)) for n in body.numbers]
        volume = metrics.voxel_intersection_volume(bodies).volume
        self.assertEqual(volume[0], 0)
        self.assertGreater(volume[1], 0)

    def test_ragged_parts(self):
        """Parts of the largest weight, as of SMPL, and random ones, whose boundaries touch each other."""
        touching = 0
        for seed in range(8):
            random = np.random.default_rng(seed)
            parts = self.weights.argmax(axis=1)
            noisy = random.random(len(parts)) < 0.08 * seed
            parts[noisy] = random.integers(0, 4, noisy.sum())
            body = metrics.BodyParts(self.rest, self.faces, parts)
            for number in body.numbers:
                own = self.faces[(parts[self.faces] == number).all(axis=1)]
                edges = {(a, b) for face in own.tolist() for a, b in zip(face, face[1:] + face[:1])}
                starts = [a for a, b in edges if (b, a) not in edges]
                touching += len(starts) > len(set(starts))
                model = body.model(number)
                self.assertTrue(model.is_closed, seed)
                self.assertEqual(model.triangle_count, len(own) + len(starts), seed)
            inside = body.vertices_inside(pelt.Model(self.rest, self.faces), pelt.Vertices(self.rest))
            self.assertEqual(inside.shape, (1, len(self.rest)))
        self.assertGreater(touching, 10)

    def test_holes_of_a_body_are_closed(self):
        holes = [5, 6, 100, 300]  # two neighbours and two others
        opened = np.delete(self.faces, holes, axis=0)
        model = pelt.Model(self.rest, opened)
        self.assertFalse(model.is_closed)
        whole = metrics.BodyParts(self.rest, opened, np.zeros(len(self.rest), int))
        self.assertTrue(whole.model(0).is_closed)
        corners = whole.poses(0, self.rest[np.newaxis]).positions[0][whole.faces(0)].astype(float)
        self.assertTrue((whole.faces(0)[:len(opened)] == opened).all())
        self.assertAlmostEqual(np.linalg.det(corners).sum() / 6, metrics.volume(
            whole.model(0), whole.poses(0, self.rest[np.newaxis])).value[0], 6)
        pushed = self.rest.copy()
        pushed[self.rest[:, 0] > 0.25] -= [0.45, 0.2, 0]
        poses = np.stack([self.rest, pushed])
        expected = metrics.self_intersection_volume(pelt.Model(self.rest, self.faces),
                                                    pelt.Vertices(poses)).value
        found = metrics.self_intersection_volume(whole.model(0), whole.poses(0, poses)).value
        self.assertGreater(expected[1], 0.001)
        self.assertLess(np.abs(found - expected).max(), 1e-5)

    def test_refused(self):
        self.refuses("parts: expected the shape", metrics.BodyParts, self.rest, self.faces, [0])
        whole = metrics.BodyParts(self.rest, self.faces, np.zeros(len(self.rest), int))
        self.refuses(r"part: no part 3, expected one of \[0\]", whole.model, 3)
        self.refuses(r"positions: expected the shape \[F, 318, 3\] of the whole body, found \[1, 5, 3\]",
                     whole.poses, 0, self.rest[np.newaxis, :5])
        wings = [[0, 1, 2], [1, 0, 3], [0, 1, 4]]
        self.refuses("part 7 cannot be closed: more than two", metrics.BodyParts,
                     np.eye(5, 3) + [[1, 2, 3]], wings, [7] * 5)


class Subject(Case):
    def test_all_metrics_of_a_motion(self):
        body = body_models.BodyModel(*(generated_body.arrays()[key] for key in (
            "v_template", "shapedirs", "posedirs", "J_regressor", "weights")),
            np.array(generated_body.PARENTS), generated_body.arrays()["f"].astype(int))
        from pelt import motions
        keys = generated_body.motion_keys()
        motion = motions.Motion(keys["poses"], keys["trans"], keys["betas"], 120.0)
        subject = body.subject(motion.betas)
        poses = subject.poses(motion)
        kept = metrics.smplify_x_filter(subject.model, body.parents)
        filtered = metrics.colliding_triangles(subject.model, poses, kept).pairs
        uncapped = metrics.colliding_triangles(subject.model, poses).pairs
        self.assertTrue((filtered <= uncapped).all())
        self.assertEqual((uncapped[0], filtered[0]), (0, 0))
        self.assertGreater(filtered[-1], 0)
        contact = metrics.self_contact(subject.model, poses,
                                       metrics.Geodesics(subject.rest, body.faces), distance=0.05)
        self.assertGreater(contact.percent[-1], contact.percent[0])


if __name__ == "__main__":
    unittest.main()
