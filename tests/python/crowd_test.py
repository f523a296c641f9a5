"""pelt.collide_crowd, compared with pelt.collide for each pair, and with the command."""

import itertools
import json
import unittest

import numpy as np

import pelt
from scene_poses import load_scene
from support import DEMO, Case, box, box_model, creature, moved, printed_hash


def by_pairs(characters, pairs=None):
    """Returns the rows frame, character a, character b, triangle a, triangle b of all pairs, sorted."""
    rows = []
    for a, b in itertools.combinations(range(len(characters)), 2) if pairs is None else pairs:
        found = pelt.collide(*characters[a], *characters[b])
        rows += [(frame, a, b, s, t) for frame, s, t in
                 zip(found.frame.tolist(), found.triangle_a.tolist(), found.triangle_b.tolist())]
    return sorted(rows)


def rows_of(found):
    return list(zip(*(column.tolist() for column in (found.frame, found.character_a, found.character_b,
                                                     found.triangle_a, found.triangle_b))))


def dancers(count, frames, seed):
    """Returns creatures that walk near each other, every third one of one frame."""
    random = np.random.default_rng(seed)
    print(f"seed {seed}")
    result = []
    for number in range(count):
        place = np.eye(4)
        place[:3, 3] = [0.25 * number, random.uniform(-0.1, 0.1), random.uniform(-0.2, 0.2)]
        own = 1 if number % 3 == 2 else frames
        result.append((creature().model, creature().palettes("walk", seconds=np.arange(own) / 9,
                                                             placement=place)))
    return result


class Crowds(Case):
    def test_is_collide_of_each_pair(self):
        crowd = dancers(7, 4, 5)
        found = pelt.collide_crowd(crowd)
        expected = by_pairs(crowd)
        self.assertEqual(rows_of(found), expected)
        self.assertGreater(len({row[1:3] for row in expected}), 5)
        self.assertEqual(found.per_frame().tolist(),
                         [sum(row[0] == frame for row in expected) for frame in range(4)])
        self.assertEqual(found.pairs().tolist(),
                         [list(pair) for pair in sorted({row[:3] for row in expected})])

    def test_threads(self):
        """Threads share frames, or the pairs of few frames."""
        for frames in (1, 5):
            crowd = dancers(6, frames, 6)
            one = rows_of(pelt.collide_crowd(crowd, threads=1))
            self.assertGreater(len(one), 50)
            for threads in (2, 4, 16):
                self.assertEqual(rows_of(pelt.collide_crowd(crowd, threads=threads)), one)

    def test_random_boxes(self):
        random = np.random.default_rng(7)
        touching = 0
        for _ in range(20):
            crowd = [(box_model(random.uniform(0.2, 0.6)), moved(*random.uniform(-1, 1, (3, 3))))
                     for _ in range(9)]
            expected = by_pairs(crowd)
            touching += len({row[:3] for row in expected})
            self.assertEqual(rows_of(pelt.collide_crowd(crowd)), expected)
        self.assertGreater(touching, 200)

    def test_vertices_and_morph_targets(self):
        rest = np.eye(4)[np.newaxis, np.newaxis].repeat(3, axis=0)
        corners = pelt.posed_vertices(box_model(), rest[:1])[0]
        targets = np.zeros((1, 8, 3))
        targets[0, :, 0] = 1
        morphing = pelt.Model(corners, [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5]], morph_targets=targets)
        crowd = [(morphing, pelt.Poses(rest, [[0], [0.5], [3]])),
                 (box_model(), pelt.Vertices(corners + [0.5, 0.25, 0.125])),
                 (box_model(), moved([0, 0.5, 0], [9, 9, 9], [3, 0.125, 0.25]))]
        expected = by_pairs(crowd)
        self.assertEqual(rows_of(pelt.collide_crowd(crowd)), expected)
        self.assertEqual({row[0] for row in expected}, {0, 1, 2})

    def test_offsets(self):
        random = np.random.default_rng(11)
        capped = pelt.Model(*box(), offset_caps=np.full(8, 0.5))
        touching = 0
        for _ in range(20):
            crowd = [(capped, pelt.Poses(moved(*random.uniform(-1, 1, (frames, 3))),
                                         offsets=random.uniform(-0.5, 0.5, (frames, 8, 3))))
                     for frames in (3, 1, 3, 3)]
            crowd.append((capped, moved(*random.uniform(-1, 1, (3, 3)))))
            expected = by_pairs(crowd)
            touching += len({row[:3] for row in expected})
            self.assertEqual(rows_of(pelt.collide_crowd(crowd)), expected)
        self.assertGreater(touching, 100)

    def test_pairs(self):
        crowd = dancers(6, 3, 8)
        pairs = [[1, 0], [2, 3], [0, 1], [0, 5]]
        expected = by_pairs(crowd, [(0, 1), (2, 3), (0, 5)])
        self.assertGreater(len(expected), 10)
        self.assertEqual(rows_of(pelt.collide_crowd(crowd, pairs=pairs)), expected)
        self.assertEqual(len(pelt.collide_crowd(crowd, pairs=[])), 0)

    def test_self_filters(self):
        crowd = dancers(3, 2, 9)
        rings = pelt.SelfFilter(creature().model, rings=1)
        found = pelt.collide_crowd(crowd, pairs=[], self_filters=[rings, None, rings])
        expected = []
        for number in (0, 2):
            own = pelt.self_collide(*crowd[number], rings)
            frames = own.frame.tolist() if len(crowd[number][1]) > 1 else None
            for frame in range(2):
                pairs = own.in_frame(frame if frames is not None else 0).tolist()
                expected += [(frame, number, number, s, t) for s, t in pairs]
        self.assertEqual(rows_of(found), sorted(expected))
        self.assertGreater(len(expected), 10)

    def test_max_contacts(self):
        crowd = dancers(4, 2, 10)
        whole, cut = pelt.collide_crowd(crowd), pelt.collide_crowd(crowd, max_contacts=1)
        self.assertEqual(cut.pairs().tolist(), whole.pairs().tolist())
        self.assertEqual(len(cut), len(whole.pairs()))

    def test_command(self):
        scene = json.loads((DEMO / "scene.json").read_text())
        scene["models"] = {name: f"{DEMO / name}.glb" for name in scene["models"]}
        scene["instances"].append({**scene["instances"][0], "translation": [0.2, 0, -1.2]})
        scene["frames"]["count"] = 60
        path = DEMO / "crowd.json"
        path.write_text(json.dumps(scene))
        crowd = load_scene(path)
        found = pelt.collide_crowd(crowd)
        self.assertEqual(found.hash, printed_hash(path))
        self.assertEqual({tuple(pair) for pair in found.pairs()[:, 1:].tolist()},
                         {(0, 1), (0, 2), (1, 2)})


class Refused(Case):
    def test_arguments(self):
        model, still = box_model(), moved([0, 0, 0])
        two = [(model, still), (model, moved([1, 0, 0], [2, 0, 0]))]
        bad = moved([0, 0, 0], [0, 0, 0])
        bad[1, 0, 0, 0] = np.nan
        for message, characters, options in [
                ("characters: there are none", [], {}),
                (r"characters\[1\], poses has 2 frames, but characters\[2\], poses has 3",
                 [*two, (model, moved(*np.zeros((3, 3))))], {}),
                (r"characters\[1\], poses, frame 1", [two[0], (model, bad)], {}),
                (r"characters\[0\], poses: expected", [(model, np.zeros((2, 5, 4, 4)))], {}),
                (r"pairs: expected the shape \[N, 2\]", two, {"pairs": [0, 1]}),
                ("pairs: element 1 is the index 2", two, {"pairs": [[0, 2]]}),
                ("pairs: row 1 is a character with itself", two, {"pairs": [[0, 1], [1, 1]]}),
                ("self_filters: expected one for each of the 2 characters, found 1", two,
                 {"self_filters": [None]}),
                ("self_filters: the filter was made for another model", two,
                 {"self_filters": [None, pelt.SelfFilter(box_model())]}),
                ("max_contacts", two, {"max_contacts": -1}), ("threads", two, {"threads": 0})]:
            with self.subTest(message):
                self.refuses(message, pelt.collide_crowd, characters, **options)
        capped = pelt.Model(*box(), offset_caps=np.ones(8))
        offset = pelt.Poses(still, offsets=np.full((1, 8, 3), 2))
        self.refuses(r"characters\[0\], poses: the offsets of 8 vertices .* beyond the caps",
                     pelt.collide_crowd, [(capped, offset)])
        for characters in ([model], [(model, still, 1)], [(still, model)], 3):
            with self.assertRaises(TypeError):
                pelt.collide_crowd(characters)
        with self.assertRaisesRegex(TypeError, "expected a pelt.SelfFilter"):
            pelt.collide_crowd(two, self_filters=[None, 5])


if __name__ == "__main__":
    unittest.main()
