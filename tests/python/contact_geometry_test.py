"""pelt.contact_geometry and pelt.self_contact_geometry."""

import unittest

import numpy as np

import pelt
from support import Case, box_model, creature, demo, moved


class Cubes(Case):
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


class Demo(Case):
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


class Self(Case):
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
