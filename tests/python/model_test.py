"""pelt.Model and pelt.load."""

import pickle
import unittest

import numpy as np

import pelt
from support import DEMO, Case, box, box_model, creature, moved


class FromArrays(Case):
    def test_dense_and_sparse_weights_are_equal(self):
        random = np.random.default_rng(1)
        rest, faces = box()
        joints = np.array([[0, 2], [1, 2], [2, 0], [3, 1], [0, 1], [2, 3], [1, 0], [3, 0]])
        share = random.uniform(0.1, 0.9, (8, 1))
        weights = np.concatenate([share, 1 - share], axis=1)
        dense = np.zeros((8, 4))
        np.put_along_axis(dense, joints, weights, axis=1)
        sparse = pelt.Model(rest, faces, weights, joints)
        self.assertEqual(sparse.joint_count, 4)
        self.assertEqual(pelt.Model(rest, faces, dense).to_bytes(), sparse.to_bytes())
        self.assertEqual(pelt.Model(rest, faces, weights, joints, joint_count=9).joint_count, 9)

    def test_without_weights(self):
        model = box_model()
        self.assertEqual((model.vertex_count, model.triangle_count, model.joint_count), (8, 12, 1))
        self.assertEqual(repr(model), "<pelt.Model: 8 vertices, 12 triangles, 1 joints>")
        self.assertTrue(model.is_closed)
        self.assertFalse(pelt.Model(box()[0], box()[1][1:]).is_closed)
        self.assertGreater(model.memory_bytes, 0)

    def test_report(self):
        rest, faces = box()
        faces[0] = [1, 1, 2]
        report = pelt.Model(rest, faces, np.full((8, 1), 1.001)).report
        self.assertEqual(report, {"renormalised_vertices": 8, "merged_influences": 0,
                                  "degenerate_triangles": 1})

    def test_morph_targets(self):
        rest, faces = box()
        targets = np.zeros((2, 8, 3))
        targets[1, 7] = [0, 0, 5]
        model = pelt.Model(rest, faces, morph_targets=targets)
        self.assertEqual(model.morph_target_count, 2)
        poses = pelt.Poses(moved([0, 0, 0], [0, 0, 1]), [[0, 0], [1, 0.5]])
        vertices = pelt.posed_vertices(model, poses)
        self.assertTrue(np.array_equal(vertices[0], rest))
        self.assertEqual(vertices[1, 7].tolist(), [1, 1, 1 + 2.5 + 1])

    def test_off_weights(self):
        rest, faces = box()
        weights = np.full((8, 1), 0.5)
        self.refuses(r"0.5, expected 1 \(renormalise=True divides", pelt.Model, rest, faces, weights)
        self.assertEqual(pelt.Model(rest, faces, weights, renormalise=True)
                         .report["renormalised_vertices"], 8)

    def test_messages_have_the_names_of_arguments(self):
        rest, faces = box()
        self.assertEqual(f"{pelt.Error.__module__}.{pelt.Error.__name__}", "pelt.Error")
        self.refuses("Model: faces is empty", pelt.Model, rest, faces[:0])
        rest[3, 1] = np.inf
        self.refuses(r"Model: rest\[3\] has the coordinate inf", pelt.Model, rest, faces)

    def test_sample_palettes(self):
        character = creature()
        weights = np.ones((len(character.rest), 1))
        plain = pelt.Model(character.rest, character.faces, weights)
        palettes = moved([0, 0, 0], [1, 0, 0])
        for samples in (palettes, palettes[:, :, :3]):
            sampled = pelt.Model(character.rest, character.faces, weights, sample_palettes=samples)
            self.assertEqual(pelt.self_collide(sampled, palettes), pelt.self_collide(plain, palettes))
        self.refuses("sample_palettes", pelt.Model, *box(), sample_palettes=np.zeros((2, 3, 4, 4)))
        self.refuses("Model: sample", pelt.Model, *box(), sample_palettes=palettes * np.nan)

    def test_pickles(self):
        model = creature().model
        copy = pickle.loads(pickle.dumps(model))
        self.assertEqual(copy.to_bytes(), model.to_bytes())
        self.refuses("from_bytes", pelt.Model.from_bytes, b"nonsense")
        self.refuses("from_bytes", pelt.Model.from_bytes, model.to_bytes()[:-1])


class FromFiles(Case):
    def test_attributes(self):
        character = creature()
        self.assertEqual([clip.name for clip in character.clips], ["walk", "idle"])
        self.assertEqual(len(character.joint_names), character.model.joint_count)
        self.assertEqual(character.joint_parents.shape, (character.model.joint_count,))
        self.assertEqual(character.joint_parents.min(), -1)
        self.assertEqual(character.rest.shape, (character.model.vertex_count, 3))
        self.assertEqual(character.faces.shape, (character.model.triangle_count, 3))
        self.assertEqual(sum(part.triangle_count for part in character.parts),
                         character.model.triangle_count)
        self.assertIn("'walk'", repr(character))

    def test_rest_and_faces_are_those_of_the_model(self):
        character = creature()
        identity = np.tile(np.eye(4), (character.model.joint_count, 1, 1))
        self.assertTrue(np.allclose(pelt.posed_vertices(character.model, identity)[0],
                                    character.rest, atol=1e-6))

    def test_palettes(self):
        character = creature()
        duration = character.clips[0].duration
        palettes = character.palettes("walk", fps=30)
        self.assertEqual(palettes.shape, (int(np.ceil(duration * 30)), character.model.joint_count,
                                          4, 4))
        self.assertTrue(np.array_equal(character.palettes("walk", fps=10, frames=4),
                                       character.palettes("walk", seconds=[0, .1, .2, .3])))
        self.assertTrue(np.array_equal(character.palettes("walk", seconds=[0.25 + duration]),
                                       character.palettes("walk", seconds=[0.25])))
        self.assertEqual(character.palettes().shape[0], 1)
        placed = np.eye(4)
        placed[:3, 3] = [1, 2, 3]
        self.assertTrue(np.allclose(character.palettes(placement=placed)[0, :, :3, 3]
                                    - character.palettes()[0, :, :3, 3], [1, 2, 3], atol=1e-6))

    def test_refusals(self):
        character = creature()
        self.refuses("no clip 'wlak'", character.palettes, "wlak")
        self.refuses("fps", character.palettes, "walk", fps=0)
        self.refuses("fps", character.palettes, "walk", fps=float("nan"))
        self.refuses("frames", character.palettes, "walk", frames=0)
        self.refuses("seconds", character.palettes, "walk", seconds=[np.nan])
        self.refuses("placement", character.palettes, "walk", frames=2, placement=np.zeros((3, 4, 4)))
        self.refuses("absent.glb", pelt.load, DEMO / "absent.glb")
        self.refuses("scene.json", pelt.load, DEMO / "scene.json")
        self.refuses("exclude_nodes", pelt.load, DEMO / "azure.glb", exclude_nodes="body")
        self.refuses("no_such_node", pelt.load, DEMO / "azure.glb", exclude_nodes=["no_such_node"])


if __name__ == "__main__":
    unittest.main()
