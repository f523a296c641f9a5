"""Threads, Ctrl+C, the lock of the interpreter, and progress."""

import concurrent.futures
import io
import os
import signal
import sys
import threading
import time
import unittest
from unittest import mock

import numpy as np

import pelt
from support import Case, box_model, creature, demo, moved


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


def endless():
    """Arguments of a call that would take minutes."""
    (a, poses_a), (b, poses_b) = demo()
    many = np.broadcast_to(poses_a.palettes[40], (10**7, *poses_a.palettes.shape[1:]))
    return a, many, b, poses_b.palettes[40]


class CtrlC(Case):
    def test_ends_a_call(self):
        for threads in (1, 2):
            timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                pelt.intersects(*endless(), threads=threads)
            timer.join()

    def test_an_error_of_progress_ends_a_call(self):
        def stop(done):
            raise RuntimeError(f"enough after {done}")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            pelt.intersects(*endless(), progress=stop)


class Lock(Case):
    def test_is_released(self):
        """Another thread of Python runs during a call."""
        counts = []
        stop = threading.Event()

        def count():
            while not stop.is_set():
                counts.append(1)
                time.sleep(0.001)

        def enough(_):
            if len(counts) > 20:
                raise StopIteration

        thread = threading.Thread(target=count)
        thread.start()
        try:
            with self.assertRaises(StopIteration):
                pelt.intersects(*endless(), progress=enough)
        finally:
            stop.set()
            thread.join()


class Progress(Case):
    def test_function(self):
        seen = []
        cube = box_model()
        pelt.intersects(cube, moved(*np.zeros((50, 3))), cube, moved([0, 0, 0]), progress=seen.append)
        self.assertEqual(seen[-1], 50)
        self.assertEqual(seen, sorted(seen))

    def test_bar(self):
        cube = box_model()
        for hidden in ({}, {"tqdm": None}):
            text = io.StringIO()
            with mock.patch.dict(sys.modules, hidden), mock.patch.object(sys, "stderr", text):
                pelt.intersects(cube, moved(*np.zeros((50, 3))), cube, moved([0, 0, 0]),
                                progress=True)
                pelt.intersects(cube, moved([0, 0, 0]), cube, moved([0, 0, 0]))
            self.assertIn("intersects", text.getvalue())
            self.assertIn("50", text.getvalue())

    def test_no_bar_without_a_terminal(self):
        text = io.StringIO()
        cube = box_model()
        with mock.patch.object(sys, "stderr", text):
            pelt.intersects(cube, moved([0, 0, 0]), cube, moved([0, 0, 0]))
        self.assertEqual(text.getvalue(), "")


if __name__ == "__main__":
    unittest.main()
