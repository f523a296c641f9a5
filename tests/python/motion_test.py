"""pelt.collide_moving, pelt.first_contact and pelt.self_collide_moving."""

import unittest

import numpy as np

import pelt
from support import Case, box, box_model, demo, moved


class Cubes(Case):
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


class Demo(Case):
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


if __name__ == "__main__":
    unittest.main()
