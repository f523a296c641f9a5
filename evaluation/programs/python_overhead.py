#!/usr/bin/env python3
"""Compares one call of the Python package with the same loop in C++.

    PYTHONPATH=build/release/python /usr/bin/python3 evaluation/programs/python_overhead.py \\
        build/release/evaluation/programs/clip_loop SCENE.json [ROUNDS]

Both find the contacts of the two characters of a scene in all frames, on one thread, with poses
made anew. They take turns; each turn is the best of five runs. Prints the medians over the turns and
their ratio, unless the answers differ.
"""

import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

import pelt

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests" / "python"))
from scene_poses import load_scene  # noqa: E402

RUNS = 5


def write_inputs(folder, bodies):
    """Writes models and palettes for the loop in C++. Returns its arguments."""
    arguments = []
    for number, (model, poses) in enumerate(bodies):
        columns = np.ascontiguousarray(np.swapaxes(poses.palettes, 2, 3), np.float32)
        for name, data in (("model", model.to_bytes()), ("palettes", columns.tobytes())):
            file = folder / f"{name}_{number}"
            file.write_bytes(data)
            arguments.append(file)
    return arguments


def time_of_cpp(program, arguments, frames):
    """Returns the milliseconds of the best run, and the number of contacts."""
    output = subprocess.run([program, *arguments, str(frames), str(RUNS)], check=True,
                            capture_output=True, text=True).stdout.split()
    return min(map(float, output[:-1])), int(output[-1])


def time_of_python(bodies):
    """Returns the milliseconds of the best run, and the number of contacts."""
    (model_a, poses_a), (model_b, poses_b) = bodies
    times = []
    for _ in range(RUNS):
        begin = time.perf_counter()
        contacts = pelt.collide(model_a, poses_a, model_b, poses_b, threads=1)
        times.append((time.perf_counter() - begin) * 1e3)
    return min(times), len(contacts)


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    bodies = load_scene(sys.argv[2])
    frames = len(bodies[0][1])
    cpp, python = [], []
    with tempfile.TemporaryDirectory() as folder:
        arguments = write_inputs(pathlib.Path(folder), bodies)
        for _ in range(int(sys.argv[3]) if len(sys.argv) > 3 else 9):
            for times, (milliseconds, contacts) in (
                    (cpp, time_of_cpp(sys.argv[1], arguments, frames)),
                    (python, time_of_python(bodies))):
                times.append(milliseconds)
                if times is cpp:
                    expected = contacts
                elif contacts != expected:
                    sys.exit(f"the answers differ: {expected} and {contacts} contacts")
    print(f"{frames} frames, {expected} contacts: C++ {statistics.median(cpp):.3f} ms, "
          f"Python {statistics.median(python):.3f} ms, "
          f"ratio {statistics.median(python) / statistics.median(cpp):.3f}")


if __name__ == "__main__":
    main()
