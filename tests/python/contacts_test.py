"""Contacts of clips: hashes, columns, frames, and their geometry."""

import unittest

import numpy as np

from scene_poses import load_scene
import pelt
from support import DEMO, Case, box_model, creature, demo, moved, printed_hash, shared


class Hashes(Case):
    def same_as_command(self, scene):
        (model_a, poses_a), (model_b, poses_b) = load_scene(scene)
        contacts = pelt.collide(model_a, poses_a, model_b, poses_b)
        self.assertGreater(len(contacts), 1000)
        self.assertEqual(contacts.hash, printed_hash(scene))

    def test_demo(self):
        self.same_as_command(DEMO / "scene.json")

    def test_walk_through(self):
        self.same_as_command(shared("scenes/walk_through.json"))

    def test_duel(self):
        self.same_as_command(shared("scenes/duel.json"))

    def test_nothing_touches(self):
        box = box_model()
        self.assertEqual(pelt.collide(box, moved([0, 0, 0]), box, moved([9, 0, 0])).hash,
                         "cbf29ce484222325")


class Columns(Case):
    @classmethod
    def setUpClass(cls):
        (a, poses_a), (b, poses_b) = demo()
        cls.arguments = a, poses_a, b, poses_b
        cls.contacts = pelt.collide(*cls.arguments)

    def test_types(self):
        for column in (self.contacts.frame, self.contacts.triangle_a, self.contacts.triangle_b):
            self.assertEqual(column.dtype, np.int32)
            self.assertEqual(column.shape, (len(self.contacts),))
            self.assertTrue(column.flags.c_contiguous)
        self.assertEqual(self.contacts.cut_short.dtype, np.bool_)

    def test_order(self):
        rows = np.stack([self.contacts.frame, self.contacts.triangle_a, self.contacts.triangle_b])
        self.assertTrue(np.array_equal(np.lexsort(rows[::-1]), np.arange(len(self.contacts))))

    def test_frames(self):
        frames = list(self.contacts)
        self.assertEqual(len(frames), self.contacts.frames)
        self.assertEqual([len(pairs) for pairs in frames], self.contacts.per_frame().tolist())
        self.assertTrue(np.array_equal(np.concatenate(frames)[:, 0], self.contacts.triangle_a))
        worst = int(self.contacts.per_frame().argmax())
        alone = pelt.collide(self.arguments[0], self.arguments[1][worst:worst + 1],
                             self.arguments[2], self.arguments[3][worst:worst + 1])
        self.assertTrue(np.array_equal(alone.in_frame(0), self.contacts.in_frame(worst)))
        with self.assertRaises(IndexError):
            self.contacts.in_frame(self.contacts.frames)

    def test_intersects(self):
        self.assertTrue(np.array_equal(pelt.intersects(*self.arguments),
                                       self.contacts.per_frame() > 0))

    def test_max_contacts(self):
        some = pelt.collide(*self.arguments, max_contacts=3)
        self.assertTrue((some.per_frame() <= 3).all())
        self.assertTrue(some.cut_short.any())
        self.assertFalse(self.contacts.cut_short.any())
        self.assertIn("cut short", repr(some))
        none = pelt.collide(*self.arguments, max_contacts=0)
        self.assertEqual(len(none), 0)

    def test_clearance(self):
        near = pelt.clearance(*self.arguments, 0)
        self.assertEqual(near, self.contacts)
        self.assertGreater(len(pelt.clearance(*self.arguments, 0.01)), len(self.contacts))
        self.refuses("tolerance", pelt.clearance, *self.arguments, -1)
        self.refuses("tolerance", pelt.clearance, *self.arguments, float("nan"))

    def test_repr(self):
        self.assertRegex(repr(self.contacts),
                         r"^<pelt.Contacts: \d+ pairs of triangles in \d+ of \d+ frames>$")


class OneFrame(Case):
    def test_broadcasts(self):
        box = box_model()
        line = moved(*([x, 0, 0] for x in np.linspace(0, 4, 9)))
        standing = moved([0, 0, 0])
        there = pelt.collide(box, standing, box, line)
        back = pelt.collide(box, line, box, standing)
        self.assertEqual((there.frames, back.frames), (9, 9))
        self.assertEqual(there.per_frame().tolist(), back.per_frame().tolist())
        self.assertEqual((there.per_frame() > 0).tolist(), [True] * 5 + [False] * 4)

    def test_may_lack_its_axis(self):
        box = box_model()
        self.assertEqual(pelt.collide(box, np.eye(4)[None], box, np.eye(4)[None]).frames, 1)

    def test_other_numbers_are_refused(self):
        box = box_model()
        self.refuses("poses_a has 2 frames, but poses_b has 3", pelt.collide, box,
                     moved([0, 0, 0], [1, 0, 0]), box, moved(*np.zeros((3, 3))))


class GeometryCubes(Case):
    def test_curve(self):
        """A corner of one cube in a face of the other: a closed curve of four corners or more."""
        cube = box_model()
        poses = moved([1.5, 0.125, 0.25])
        contacts = pelt.collide(cube, moved([0, 0, 0]), cube, poses)
        found = pelt.contact_geometry(cube, moved([0, 0, 0]), cube, poses, contacts)
        self.assertEqual(len(found.kind), len(contacts))
        for index in range(len(found.curve_frame)):
            points = found.curve(index)
            begin, end = found.curve_begin[index:index + 2]
            self.assertEqual(len(points), end - begin + 1)
            if found.curve_closed[index]:
                self.assertTrue(np.array_equal(points[0], points[-1]))
        self.assertGreater(found.curve_closed.sum(), 0)
        with self.assertRaises(IndexError):
            found.curve(len(found.curve_frame))


class GeometryDemo(Case):
    @classmethod
    def setUpClass(cls):
        (a, poses_a), (b, poses_b) = demo()
        cls.arguments = a, poses_a[30:50], b, poses_b[30:50]
        cls.contacts = pelt.collide(*cls.arguments)
        cls.found = pelt.contact_geometry(*cls.arguments, cls.contacts)

    def test_columns(self):
        found = self.found
        self.assertEqual(found.start.shape, (len(self.contacts), 3))
        self.assertEqual(found.curve_begin[-1], len(found.curve_trace))
        self.assertEqual(found.patch_begin[-1], len(self.contacts))
        self.assertEqual(sorted(found.patch_trace.tolist()), list(range(len(self.contacts))))
        of_patch = np.repeat(found.patch_frame, np.diff(found.patch_begin))
        self.assertTrue(np.array_equal(self.contacts.frame[found.patch_trace], of_patch))
        of_curve = np.repeat(found.curve_frame, np.diff(found.curve_begin))
        self.assertTrue(np.array_equal(self.contacts.frame[found.curve_trace], of_curve))
        self.assertTrue(np.allclose(np.linalg.norm(found.normal, axis=1), 1, atol=1e-4))

    def test_curves_are_chains(self):
        closed = np.flatnonzero(self.found.curve_closed)
        self.assertGreater(len(closed), 5)
        for index in closed[:50]:
            points = self.found.curve(index)
            self.assertTrue(np.array_equal(points[0], points[-1]))

    def test_threads(self):
        one = pelt.contact_geometry(*self.arguments, self.contacts, threads=1)
        for name in ("start", "depth", "curve_trace", "patch_point", "patch_trace"):
            self.assertTrue(np.array_equal(getattr(one, name), getattr(self.found, name)), name)

    def test_foreign_contacts_are_refused(self):
        for row in (0, len(self.contacts) - 1):
            columns = [column.copy() for column in (
                self.contacts.frame, self.contacts.triangle_a, self.contacts.triangle_b)]
            for column, value in ((0, 99), (0, -1), (1, 10**9), (2, -5)):
                wrong = [c.copy() for c in columns]
                wrong[column][row] = value
                contacts = pelt.Contacts(*wrong, self.contacts.cut_short)
                self.refuses("contacts", pelt.contact_geometry, *self.arguments, contacts)
        backwards = pelt.Contacts(self.contacts.frame, self.contacts.triangle_a[::-1].copy(),
                                  self.contacts.triangle_b, self.contacts.cut_short)
        self.refuses("contacts", pelt.contact_geometry, *self.arguments, backwards)


class GeometrySelf(Case):
    def test_self(self):
        character = creature()
        poses = character.palettes("walk", frames=4)
        poses = np.concatenate([poses, poses])
        poses[:, 3, 0, 3] += 0.4
        contacts = pelt.self_collide(character.model, poses)
        self.assertGreater(len(contacts), 10)
        found = pelt.self_contact_geometry(character.model, poses, contacts)
        self.assertEqual(found.patch_begin[-1], len(contacts))
        swapped = pelt.SelfContacts(contacts.frame, contacts.triangle_b, contacts.triangle_a,
                                    contacts.cut_short, {})
        self.refuses("contacts", pelt.self_contact_geometry, character.model, poses, swapped)


if __name__ == "__main__":
    unittest.main()
