"""Draws how often a character touches itself in the frames of its first clip."""

import sys

import matplotlib.pyplot as plt

import pelt

if len(sys.argv) != 2:
    sys.exit("usage: picture.py CHARACTER.glb")
character = pelt.load(sys.argv[1])
clip = character.clips[0]
contacts = pelt.self_collide(character.model, character.poses(clip.name, fps=60),
                             pelt.SelfFilter(character.model, rings=2))
plt.plot([frame / 60 for frame in range(contacts.frames)], contacts.per_frame())
plt.xlabel(f"seconds of {clip.name}")
plt.ylabel("pairs of triangles that intersect")
plt.savefig("self_contacts.png")
print("wrote self_contacts.png")
