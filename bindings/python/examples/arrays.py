"""A model from plain arrays: the upper half of a strip bends, and passes through a second strip."""

import numpy as np

import pelt

rest = np.array([[x, y, 0] for y in np.linspace(-1, 1, 21) for x in (0, 0.1)])
faces = np.concatenate([[[i, i + 1, i + 3], [i, i + 3, i + 2]] for i in range(0, 40, 2)])
upper = np.clip((rest[:, 1] + 0.15) / 0.3, 0, 1)
strip = pelt.Model(rest, faces, np.stack([1 - upper, upper], axis=1))
bend, straight = np.tile(np.eye(4), (7, 2, 1, 1)), np.tile(np.eye(4), (2, 1, 1))
straight[:, 2, 3] = 0.5
for frame, angle in enumerate(np.linspace(0, 3, 7)):
    bend[frame, 1, 1:3, 1:3] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
for frame, pairs in enumerate(pelt.collide(strip, bend, strip, straight)):
    print(f"frame {frame}: {len(pairs)} pairs of triangles touch")
