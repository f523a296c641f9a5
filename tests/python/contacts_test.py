"""pelt.collide: the hashes of the command, and the columns of the answer."""

import unittest

import numpy as np

import pelt
from scene_poses import load_scene
from support import DEMO, Case, box_model, demo, moved, printed_hash, shared


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


if __name__ == "__main__":
    unittest.main()
