"""The same answers for any number of threads, and from several threads of Python."""

import concurrent.futures
import unittest

import numpy as np

import pelt
from support import Case, creature, demo


class Threads(Case):
    def test_equal_answers(self):
        (a, poses_a), (b, poses_b) = demo()
        calls = {
            "collide": lambda n: pelt.collide(a, poses_a, b, poses_b, threads=n),
            "self": lambda n: pelt.self_collide(a, poses_a[:20], threads=n),
            "moving": lambda n: pelt.collide_moving(a, poses_a[30:50], b, poses_b[30:50], threads=n),
            "distance": lambda n: pelt.distance(a, poses_a[:40], b, poses_b[:40], threads=n),
            "deepest": lambda n: pelt.deepest_vertex(a, poses_a[30:50], b, poses_b[30:50], threads=n),
        }
        for name, call in calls.items():
            one = columns(call(1))
            for threads in (2, 3, 64):
                for found, expected in zip(columns(call(threads)), one):
                    self.assertTrue(np.array_equal(found, expected, equal_nan=True), name)

    def test_calls_at_once(self):
        (a, poses_a), (b, poses_b) = demo()
        expected = pelt.collide(a, poses_a, b, poses_b)
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            calls = [pool.submit(pelt.collide, a, poses_a, b, poses_b, threads=2) for _ in range(8)]
            calls.append(pool.submit(lambda: creature().model.is_closed))
            calls.append(pool.submit(lambda: creature().model.is_closed))
            for call in calls[:8]:
                self.assertEqual(call.result(), expected)
            self.assertEqual(calls[8].result(), calls[9].result())

    def test_the_lowest_error_wins(self):
        (a, poses_a), (b, poses_b) = demo()
        palettes = poses_a.palettes.copy()
        palettes[[7, 20, 21, 60], 0, 0, 0] = np.inf
        for threads in (1, 2, 5):
            self.refuses("poses_a, frame 7:", pelt.collide, a, palettes, b, poses_b, threads=threads)

    def test_refusals(self):
        (a, poses_a), _ = demo()
        for threads in (0, -1, 2.5, "two", True, 10**9):
            self.refuses("threads", pelt.posed_vertices, a, poses_a, threads=threads)


def columns(answer):
    """Returns all arrays of an answer."""
    found = []
    for value in vars(answer).values():
        if isinstance(value, np.ndarray):
            found.append(value)
        elif hasattr(value, "__dict__"):
            found.extend(columns(value))
    return found


if __name__ == "__main__":
    unittest.main()
