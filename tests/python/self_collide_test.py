"""pelt.self_collide and pelt.near_joints."""

import unittest

import numpy as np

import pelt
from support import DEMO, Case, box, creature, moved, printed_hash, shared


class Hashes(Case):
    def same_as_command(self, file, clip, rings):
        character = pelt.load(file)
        contacts = pelt.self_collide(character.model, character.poses(clip),
                                     pelt.SelfFilter(character.model, rings=rings))
        self.assertEqual(contacts.hash,
                         printed_hash(file, "--clip", clip, "--self-rings", rings,
                                      "--self-at-rest", "keep", "--self-near-joints", "keep"))
        return contacts

    def test_demo(self):
        for rings in (0, 1, 5):
            self.same_as_command(DEMO / "azure.glb", "walk", rings)

    def test_knight(self):
        found = self.same_as_command(shared("models/knight.glb"), "Walking_A", 5)
        self.assertGreater(len(found), 1000)
        self.assertGreater(found.left_out["rings"], 0)


class Filters(Case):
    @classmethod
    def setUpClass(cls):
        """Two cubes of one model, each with its own joint; the second one moves."""
        rest, faces = box()
        cls.model = pelt.Model(np.concatenate([rest, rest]), np.concatenate([faces, faces + 8]),
                               np.repeat(np.eye(2), 8, axis=0))
        cls.poses = np.tile(np.eye(4), (3, 2, 1, 1))
        cls.poses[:, 1, :3, 3] = [[0.5, 0.25, 0.125], [1.5, 0.25, 0.125], [5, 0, 0]]
        cls.all = pelt.self_collide(cls.model, cls.poses)

    def left_out_by(self, name, **options):
        found = pelt.self_collide(self.model, self.poses, pelt.SelfFilter(self.model, **options))
        self.assertEqual(len(found) + found.left_out[name], len(self.all))
        self.assertEqual(sum(found.left_out.values()), found.left_out[name])
        return found

    def test_leave_out(self):
        """Filters give the same for contacts that are known."""
        first = self.all.in_frame(0)
        for options in ({}, {"rings": 5}, {"at_rest": first}, {"joint_parents": [-1, 0]},
                        {"takes_part": np.arange(24) % 5 > 0},
                        {"groups": np.arange(24) % 3, "group_pairs": [[0, 1]]}):
            ignore = pelt.SelfFilter(self.model, **options)
            found, expected = ignore.leave_out(self.all), pelt.self_collide(self.model, self.poses, ignore)
            self.assertEqual(found, expected)
            self.assertEqual(found.left_out, expected.left_out)
        swapped = pelt.Contacts(self.all.frame, self.all.triangle_b, self.all.triangle_a,
                                self.all.cut_short)
        self.assertEqual(pelt.SelfFilter(self.model).leave_out(swapped), self.all)
        wrong = pelt.Contacts(*np.array([[0], [3], [3]], np.int32), np.zeros(1, bool))
        self.refuses("contacts: pair 0 is a triangle with itself", ignore.leave_out, wrong)
        wrong.triangle_b[0] = 24
        self.refuses("contacts: element 1 is the index 24", ignore.leave_out, wrong)

    def test_none(self):
        self.assertEqual((self.all.per_frame() > 0).tolist(), [True, True, False])
        self.assertTrue((self.all.triangle_a < self.all.triangle_b).all())
        self.assertEqual(sum(self.all.left_out.values()), 0)

    def test_at_rest_and_always(self):
        first = self.all.in_frame(0)
        for name in ("at_rest", "always"):
            self.assertEqual(self.left_out_by(name, **{name: first}).per_frame()[0], 0)

    def test_takes_part(self):
        flags = np.arange(24) < 12
        self.assertEqual(len(self.left_out_by("takes_part", takes_part=flags)), 0)

    def test_joints(self):
        self.assertEqual(len(self.left_out_by("joints", joint_parents=[-1, 0])), 0)
        self.assertEqual(len(self.left_out_by("joints", joint_pairs=[[1, 0]])), 0)
        self.assertEqual(len(self.left_out_by("joints", joint_parents=[-1, -1])), len(self.all))
        zones = [[triangle, 7] for triangle in range(24)]
        self.assertEqual(len(self.left_out_by("joints", joint_pairs_in_zones=[[0, 1]],
                                              zones=zones)), 0)

    def test_groups(self):
        groups = np.arange(24) // 12
        self.assertEqual(len(self.left_out_by("groups", groups=groups, group_pairs=[[0, 1]])), 0)

    def test_rings(self):
        character = creature()
        bent = character.palettes("walk", frames=3)
        found = pelt.self_collide(character.model, bent)
        near = pelt.self_collide(character.model, bent, pelt.SelfFilter(character.model, rings=9))
        self.assertEqual(len(near) + near.left_out["rings"], len(found))

    def test_refusals(self):
        self.refuses("rings", pelt.SelfFilter, self.model, rings=65)
        self.refuses("at_rest: element 1 is the index 24", pelt.SelfFilter, self.model,
                     at_rest=[[0, 24]])
        self.refuses("joint_parents", pelt.SelfFilter, self.model, joint_parents=[-2, 0])
        self.refuses("groups", pelt.SelfFilter, self.model, group_pairs=[[0, 1]])
        self.refuses("another model", pelt.self_collide, pelt.Model(*box()), moved([0, 0, 0]),
                     pelt.SelfFilter(self.model))
        with self.assertRaisesRegex(TypeError, "expected a pelt.SelfFilter"):
            pelt.self_collide(self.model, self.poses, {"rings": 1})


class NearJointsCommand(Case):
    def same_as_command(self, file, clip, **options):
        character = pelt.load(file)
        found = pelt.self_collide(character.model, character.poses(clip),
                                  character.self_filter(**options))
        names = {"at_rest": "--self-at-rest", "near_joints": "--self-near-joints"}
        flags = [word for name, flag in names.items()
                 for word in (flag, "drop" if options.get(name, True) else "keep")]
        rings = ("--self-rings", options.get("rings", 5))
        self.assertEqual(found.hash, printed_hash(file, "--clip", clip, *rings, *flags))
        return found

    def test_demo(self):
        found = self.same_as_command(DEMO / "azure.glb", "walk", rings=1)
        self.assertGreater(found.left_out["joints"], 0)
        for options in ({}, {"at_rest": False, "rings": 1}, {"near_joints": False, "rings": 1}):
            self.same_as_command(DEMO / "azure.glb", "walk", **options)

    def test_knight(self):
        """Parts that are attached to bones are one body with them."""
        found = self.same_as_command(shared("models/knight.glb"), "Walking_A")
        for name in ("rings", "at_rest", "joints"):
            self.assertGreater(found.left_out[name], 0, name)
        bodies = pelt.load(shared("models/knight.glb")).near_joints().bodies
        self.assertLess(len(np.unique(bodies)), len(bodies))

    def test_morph_targets(self):
        self.same_as_command(shared("models/human.glb"), "walk")


class NearJointsArrays(Case):
    def test_zones_are_at_joints(self):
        """Without clips, the joints of a file are those of its hierarchy."""
        character = creature()
        near = pelt.near_joints(character.model, character.joint_parents,
                                positions=pelt.posed_vertices(character.model, character.palettes())[0])
        self.assertEqual(near.bodies.tolist(), list(range(character.model.joint_count)))
        self.assertGreater(len(near.joint_pairs_in_zones), 10)
        self.assertGreater(len(near.zones), 100)
        self.assertLessEqual(set(near.zones[:, 1]), set(near.joint_pairs_in_zones[:, 0]))
        walk = character.palettes("walk")
        kept = pelt.self_collide(character.model, walk, pelt.SelfFilter(character.model, rings=1))
        left = pelt.self_collide(character.model, walk,
                                 pelt.SelfFilter(character.model, rings=1, near_joints=near))
        self.assertEqual(len(left) + left.left_out["joints"], len(kept))
        self.assertGreater(left.left_out["joints"], 0)

    def test_at_rest(self):
        rest, faces = box()
        model = pelt.Model(np.concatenate([rest, rest + 5]), np.concatenate([faces, faces + 8]),
                           np.repeat(np.eye(2), 8, axis=0))
        pairs = pelt.near_joints(model, [-1, -1]).joint_pairs.tolist()
        self.assertEqual(pairs, [[0, 0], [1, 1]])
        pairs = pelt.near_joints(model, [-1, -1], at_rest=[[3, 15]]).joint_pairs.tolist()
        self.assertEqual(pairs, [[0, 0], [0, 1], [1, 1]])
        pairs = pelt.near_joints(model, [-1, 0]).joint_pairs.tolist()
        self.assertEqual(pairs, [[0, 0], [1, 0], [1, 1]])

    def test_refused(self):
        model = pelt.Model(*box())
        for message, arguments, options in [
                ("the bodies are of 2 and 2 joints, but the model has 1", ([-1, 0],), {}),
                ("body 0 is above itself", ([0],), {}),
                ("above.0. is 1, expected a body", ([1],), {}),
                ("joint_parents: joint 0 has the parent -2", ([-2],), {}),
                (r"joint_parents: expected the shape \[J\], found \[1, 1\]", ([[-1]],), {}),
                ("joint_parents: expected integers", ([0.5],), {}),
                (r"positions: expected the shape \[8, 3\]", ([-1],), {"positions": [[0, 0, 0]]}),
                (r"positions.5. is not finite", ([-1],),
                 {"positions": np.where(np.arange(24) == 15, np.nan, 0).reshape(8, 3)}),
                ("at_rest: element 1 is the index 12", ([-1],), {"at_rest": [[0, 12]]}),
                (r"at_rest: expected the shape \[N, 2\]", ([-1],), {"at_rest": [0, 1]})]:
            with self.subTest(message):
                self.refuses(message, pelt.near_joints, model, *arguments, **options)
        near = pelt.near_joints(model, [-1])
        self.refuses("near_joints: cannot be combined with", pelt.SelfFilter, model, near_joints=near,
                     joint_bodies=[0])


if __name__ == "__main__":
    unittest.main()
