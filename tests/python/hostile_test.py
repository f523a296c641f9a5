"""Random shapes, types, strides and values: an answer or an exception, never a crash."""

import unittest

import numpy as np

import pelt
from support import Case, box, box_model, moved

TYPES = ["f4", "f8", ">f4", ">f8", "f2", "g", "i1", "i8", "u8", "?", "c8", "O", "U3", "M8[s]", "V4",
         [("x", "f4")]]
NUMBERS = [0, -0.0, 1, -1, 0.5, 1e-45, 1e38, -1e38, 1e300, np.nan, np.inf, -np.inf, 2.0**60, 255,
           65535, 65536, 2**31, 2**32, 2**63]
EXPECTED = (pelt.Error, TypeError, OverflowError)


class Random:
    """Random arguments."""

    def __init__(self, seed):
        self.random = np.random.default_rng(seed)

    def pick(self, choices):
        return choices[self.random.integers(len(choices))]

    def shape(self):
        sizes = [0, 1, 1, 2, 3, 3, 4, 4, 8, 12]
        return tuple(self.pick(sizes) for _ in range(self.random.integers(0, 6)))

    def array(self):
        """Returns an array of any type, shape and layout."""
        values = self.random.choice(NUMBERS, self.shape())
        with np.errstate(all="ignore"):
            try:
                array = np.asarray(values).astype(self.pick(TYPES))
            except (ValueError, TypeError, OverflowError):
                array = np.asarray(values)
        return self.layout(array)

    def layout(self, array):
        if array.ndim and self.random.integers(2):
            array = array[::self.pick([1, -1, 2])]
        if array.ndim > 1 and self.random.integers(2):
            array = array.swapaxes(0, -1)
        if array.ndim and array.shape[0] and self.random.integers(4) == 0:
            array = np.broadcast_to(array[:1], array.shape)
        return array

    def disturbed(self, array):
        """Returns a valid array with a wrong element, or none, in any layout."""
        array = np.array(array, self.pick(["f4", "f8"]))
        if array.size and self.random.integers(2):
            with np.errstate(all="ignore"):
                array.flat[self.random.integers(array.size)] = self.pick(NUMBERS)
        return self.layout(array)

    def argument(self, good):
        """Returns something for an argument."""
        kind = self.random.integers(8)
        if kind < 3:
            return self.disturbed(good)
        if kind < 6:
            return self.array()
        return self.pick([None, "text", b"x", 3, [], [[]], [[1], [1, 2]], {}, object, float("nan"),
                          pelt.Vertices(np.zeros((1, 8, 3))), np.zeros((10**6, 0, 4, 4))])


class Hostile(Case):
    def attempt(self, seed, call, *arguments, **options):
        """Counts the calls with an answer."""
        try:
            with np.errstate(all="ignore"):
                call(*arguments, **options)
        except EXPECTED:
            return 0
        except Exception as error:  # pylint: disable=broad-except
            self.fail(f"seed {seed}: {type(error).__name__}: {error}")
        return 1

    def check(self, rounds, one_round):
        answers = sum(one_round(seed, Random(seed)) for seed in range(rounds))
        self.assertGreater(answers, rounds // 50)
        self.assertLess(answers, rounds)

    def test_models(self):
        rest, faces = box()
        weights, joints = np.full((8, 2), 0.5), np.tile([0, 1], (8, 1))

        def one_round(seed, random):
            arguments = [rest, faces, weights, joints]
            arguments[random.random.integers(4)] = random.argument(rest)
            if random.random.integers(3) == 0:
                arguments[1] = random.disturbed(faces).astype("i8")
            return self.attempt(seed, pelt.Model, *arguments)

        with np.errstate(all="ignore"):
            self.check(1500, one_round)

    def test_poses(self):
        cube, good = box_model(), moved([0, 0, 0], [0.5, 0.25, 0.125])
        calls = [lambda x: pelt.collide(cube, x, cube, good), lambda x: pelt.self_collide(cube, x),
                 lambda x: pelt.collide_moving(cube, good, cube, x),
                 lambda x: pelt.distance(cube, x, cube, good), lambda x: pelt.bounds(cube, x),
                 lambda x: pelt.Poses(good, x) and pelt.posed_vertices(cube, pelt.Poses(x, x)),
                 lambda x: pelt.posed_vertices(cube, pelt.Vertices(x)),
                 lambda x: pelt.deepest_vertex(cube, x, cube, good)]
        self.check(3000, lambda seed, random: self.attempt(seed, random.pick(calls),
                                                           random.argument(good)))

    def test_points(self):
        cube, here = box_model(), moved([0, 0, 0])
        good = np.zeros((2, 3))
        calls = [lambda x: pelt.side_of(cube, here, x), lambda x: pelt.closest_points(cube, here, x),
                 lambda x: pelt.cast_rays(cube, here, x, good),
                 lambda x: pelt.cast_rays(cube, here, good, x),
                 lambda x: pelt.closest_points(cube, here, good, max_distance=x),
                 lambda x: pelt.clearance(cube, here, cube, here, x)]

        def one_round(seed, random):
            argument = random.argument(good)
            return self.attempt(seed, random.pick(calls), argument)

        self.check(2000, one_round)

    def test_filters(self):
        cube = box_model()
        names = ["takes_part", "at_rest", "always", "joint_parents", "joint_pairs", "joint_bodies",
                 "joint_pairs_in_zones", "zones", "groups", "group_pairs", "rings"]

        def one_round(seed, random):
            good = random.pick([[[0, 1]], np.zeros(12, int), [-1], [[11, 3], [0, 0]], 3])
            argument = good if random.random.integers(2) else random.argument(np.zeros(12))
            return self.attempt(seed, pelt.SelfFilter, cube, **{random.pick(names): argument})

        self.check(2000, one_round)

    def test_solids(self):
        cube, here = box_model(), moved([0, 0, 0], [1, 0, 0])
        kinds = {pelt.HalfSpace: [[0, 1, 0], 0], pelt.Box: [[0, 0, 0], [1, 1, 1]],
                 pelt.OrientedBox: [[0, 0, 0], [1, 1, 1], np.eye(3)], pelt.Sphere: [[0, 0, 0], 1],
                 pelt.Capsule: [[0, 0, 0], [1, 0, 0], 0.5]}

        def one_round(seed, random):
            kind = random.pick(list(kinds))
            members = list(kinds[kind])
            wrong = random.random.integers(len(members))
            members[wrong] = random.argument(np.array(members[wrong], float))
            call = random.pick([pelt.collide_solid, pelt.solid_distance])
            return self.attempt(seed, call, cube, here, kind(*members))

        self.check(3000, one_round)

    def test_height_fields(self):
        cube, here = box_model(), moved([0, 0, 0])

        def use(heights, **options):
            field = pelt.HeightField(heights, **options)
            pelt.collide_field(cube, here, field)
            pelt.field_distance(cube, here, field, max_distance=4)
            return field.triangles

        def one_round(seed, random):
            options = {"origin": (-1, 0, -1), "column_spacing": 0.5, "row_spacing": 0.5}
            heights = random.argument(np.zeros((4, 5)))
            if random.random.integers(2):
                heights = np.zeros((4, 5))
                name = random.pick(list(options))
                value = random.pick([*NUMBERS, "x", None])
                options[name] = (0, value, 0) if name == "origin" else value
            return self.attempt(seed, use, heights, **options)

        self.check(2000, one_round)

    def test_crowds(self):
        cube, here = box_model(), moved([0, 0, 0], [0.5, 0.25, 0.125])

        def one_round(seed, random):
            crowd = [(cube, here), (cube, here[:1]), (cube, here)]
            options = {"pairs": [[0, 1], [2, 1]]}
            if random.random.integers(2):
                crowd[random.random.integers(3)] = (cube, random.argument(here))
            else:
                options["pairs"] = random.argument(np.array([[0, 1], [1, 2]]))
            return self.attempt(seed, pelt.collide_crowd, crowd, **options)

        self.check(2000, one_round)

    def test_near_joints(self):
        cube = box_model()

        def one_round(seed, random):
            parents = [-1] if random.random.integers(2) else random.argument(np.array([-1]))
            options = {random.pick(["positions", "at_rest"]): random.argument(np.zeros((8, 3)))}
            return self.attempt(seed, pelt.near_joints, cube, parents,
                                **(options if random.random.integers(3) else {}))

        self.check(2000, one_round)

    def test_a_million_frames_of_nothing(self):
        cube = box_model()
        self.refuses("shape", pelt.posed_vertices, cube, np.zeros((10**6, 0, 4, 4)))
        many = np.broadcast_to(moved([0, 0, 0])[0], (10**5, 1, 4, 4))
        self.assertEqual(len(pelt.intersects(cube, many, cube, moved([5, 0, 0]))), 10**5)


if __name__ == "__main__":
    unittest.main()
