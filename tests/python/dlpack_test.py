"""Tensors of PyTorch, by `__dlpack__`."""

import unittest

from support import Case, box, demo, moved, skip_program

try:
    import torch
except ImportError:
    skip_program("no PyTorch (package python3-torch)")

import numpy as np

import pelt


class Tensors(Case):
    def test_palettes(self):
        (a, poses_a), (b, poses_b) = demo()
        few = slice(30, 50)
        of_a, of_b = poses_a.palettes[few], poses_b.palettes[few]
        expected = pelt.collide(a, of_a, b, of_b)
        self.assertGreater(len(expected), 100)
        tensor = torch.from_numpy(of_a.copy())
        swapped = torch.from_numpy(np.ascontiguousarray(np.swapaxes(of_a, 1, 2))).transpose(1, 2)
        for given in (tensor, tensor.double(), swapped, tensor[:, :, :3], tensor.clone()):
            self.assertEqual(pelt.collide(a, given, b, of_b), expected)

    def test_model(self):
        rest, faces = box()
        model = pelt.Model(torch.from_numpy(rest), torch.from_numpy(faces),
                           torch.ones(8, 1, dtype=torch.float64))
        self.assertEqual(model.to_bytes(), pelt.Model(rest, faces, np.ones((8, 1))).to_bytes())

    def test_answers_become_tensors(self):
        cube = pelt.Model(*box())
        found = pelt.collide(cube, moved([0, 0, 0]), cube, moved([1, 0, 0]))
        self.assertEqual(torch.from_numpy(found.triangle_a).dtype, torch.int32)

    def test_refusals(self):
        cube = pelt.Model(*box())
        attached = torch.from_numpy(moved([0, 0, 0])).requires_grad_()
        self.refuses("poses: .*grad", pelt.posed_vertices, cube, attached)
        self.refuses("poses: ", pelt.posed_vertices, cube, torch.zeros(1, 1, 4, 4).bfloat16())


if __name__ == "__main__":
    unittest.main()
