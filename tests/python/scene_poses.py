"""Poses of the instances of a scene file, as `pelt check` computes them."""

import json
import pathlib

import numpy as np

import pelt


def placements(instance, seconds):
    """Returns the world matrices [F, 4, 4]: translation x rotation x scale."""
    x, y, z, w = np.array(instance.get("rotation", [0, 0, 0, 1]), float) / np.linalg.norm(
        instance.get("rotation", [0, 0, 0, 1]))
    rotation = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                         [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                         [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
    matrices = np.zeros((len(seconds), 4, 4))
    matrices[:, :3, :3] = rotation * instance.get("scale", 1)
    matrices[:, :3, 3] = (np.array(instance.get("translation", [0, 0, 0]), float)
                          + np.outer(seconds, instance.get("velocity", [0, 0, 0])))
    matrices[:, 3, 3] = 1
    return matrices


def poses_of(character, instance, seconds):
    """Returns the poses of an instance at these times of the scene."""
    times = instance.get("start", 0) + instance.get("speed", 1) * seconds
    return character.poses(instance.get("clip"), seconds=times,
                           placement=placements(instance, seconds))


def file_of(name, model):
    """Returns the file of a model. `pelt demo` writes generated characters to files of their names."""
    return model if isinstance(model, str) else f"{name}.glb"


def load_scene(path):
    """Returns a list of (model, poses), one for each instance."""
    path = pathlib.Path(path)
    scene = json.loads(path.read_text())
    characters = {name: pelt.load(path.parent / file_of(name, model))
                  for name, model in scene["models"].items()}
    frames = scene.get("frames", {"count": 1, "fps": 30})
    seconds = np.arange(frames["count"]) / frames["fps"]
    return [(characters[instance["model"]].model,
             poses_of(characters[instance["model"]], instance, seconds))
            for instance in scene["instances"]]
