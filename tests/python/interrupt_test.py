"""Ctrl-C, progress and the interpreter lock."""

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
from support import Case, box_model, demo, moved


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
