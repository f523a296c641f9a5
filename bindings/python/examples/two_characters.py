"""Which triangles of two characters touch while the first one walks through the second one?"""

import sys

import numpy as np

import pelt

if len(sys.argv) != 3:
    sys.exit("usage: two_characters.py WALKER.glb STANDER.glb")
walker, stander = pelt.load(sys.argv[1]), pelt.load(sys.argv[2])
placement = np.tile(np.eye(4), (60, 1, 1))
placement[:, 2, 3] = np.linspace(-1.5, 1.5, 60)
walk = walker.palettes(walker.clips[0].name, frames=60, placement=placement)
contacts = pelt.collide(walker.model, walk, stander.model, stander.palettes())
print(contacts)
print("most pairs in frame", contacts.per_frame().argmax())
