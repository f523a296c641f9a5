"""pelt.near_joints and Character.self_filter: the filters of the command."""

import unittest

import numpy as np

import pelt
from support import DEMO, Case, box, creature, printed_hash, shared


class Command(Case):
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


class Arrays(Case):
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
