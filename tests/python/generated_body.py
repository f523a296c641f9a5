"""A humanoid of boxes with the keys of SMPL-H, and motions with the keys of AMASS. No licensed data."""

import functools
import itertools

import numpy as np

CELL = 0.1
PARENTS = ([-1, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 12, 13, 14, 16, 17, 18, 19]
           + [20, 22, 23, 20, 25, 26, 20, 28, 29, 20, 31, 32, 20, 34, 35]
           + [21, 37, 38, 21, 40, 41, 21, 43, 44, 21, 46, 47, 21, 49, 50])
JOINTS = [(0, 9), (1.5, 8.5), (-1.5, 8.5), (0, 10.5), (1.5, 4.5), (-1.5, 4.5), (0, 12), (1.5, 1),
          (-1.5, 1), (0, 13.5), (1.5, 0.2), (-1.5, 0.2), (0, 15.5), (1, 14), (-1, 14), (0, 17), (2, 14),
          (-2, 14), (5, 14), (-5, 14), (7.5, 14), (-7.5, 14)]
L_SHOULDER, R_SHOULDER, L_ELBOW, R_ELBOW = 16, 17, 18, 19


def _cells():
    """The humanoid in T-pose: x to its left, y up, in cells."""
    boxes = [((-2, 9, 0), (2, 15, 2)), ((1, 0, 0), (2, 9, 2)), ((-2, 0, 0), (-1, 9, 2)),
             ((2, 13, 0), (8, 15, 2)), ((-8, 13, 0), (-2, 15, 2)), ((-1, 15, 0), (1, 18, 2))]
    return {cell for low, high in boxes
            for cell in itertools.product(*(range(a, b) for a, b in zip(low, high)))}


def _surface(cells):
    """Returns vertices and outward triangles of the boundary of the cells."""
    numbers, faces = {}, []
    for cell in sorted(cells):
        for axis, side in itertools.product(range(3), (0, 1)):
            beside = list(cell)
            beside[axis] += 2 * side - 1
            if tuple(beside) in cells:
                continue
            u, v = (axis + 1) % 3, (axis + 2) % 3
            corners = []
            for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                corner = list(cell)
                corner[axis] += side
                corner[u] += du
                corner[v] += dv
                corners.append(numbers.setdefault(tuple(corner), len(numbers)))
            a, b, c, d = corners if side else corners[::-1]
            faces += [[a, b, c], [a, c, d]]
    return np.array(list(numbers), float), np.array(faces)


@functools.lru_cache(None)
def arrays():
    """Returns the arrays of a body model with 52 joints, by their keys."""
    random = np.random.default_rng(3)
    positions, faces = _surface(_cells())
    positions = (positions - [0, 0, 1]) * CELL + random.normal(size=positions.shape) * 0.002
    count = len(PARENTS)
    joints = np.array([(x, y, 0) for x, y in JOINTS], float)
    hands = [joints[20] + [0.3, 0, 0]] * 15 + [joints[21] - [0.3, 0, 0]] * 15
    joints = np.concatenate([joints, hands]) * CELL
    distances = np.linalg.norm(positions[:, np.newaxis] - joints, axis=2)
    weights = np.exp(-(distances / 0.08) ** 2) + 1e-9
    weights[weights < 0.02 * weights.max(axis=1, keepdims=True)] = 0
    regressor = np.exp(-(distances.T / 0.15) ** 2)
    return {
        "v_template": positions,
        "shapedirs": random.normal(size=(len(positions), 3, 16)) * 0.001,
        "posedirs": random.normal(size=(len(positions), 3, 9 * (count - 1))) * 0.0005,
        "J_regressor": regressor / regressor.sum(axis=1, keepdims=True),
        "weights": weights / weights.sum(axis=1, keepdims=True),
        "kintree_table": np.array([[2**32 - 1] + PARENTS[1:], range(count)], np.uint32),
        "f": faces.astype(np.uint32),
    }


def save_body(path, **changes):
    """Writes the body model. Changes of None leave a key out."""
    keys = {**arrays(), **changes}
    np.savez(path, **{key: value for key, value in keys.items() if value is not None})
    return path


def motion_keys(frames=6, bend=1.9, seed=1, gender="male"):
    """Returns the arrays of a motion of SMPL-H, which swings the arms in front of the chest."""
    random = np.random.default_rng(seed)
    poses = random.normal(size=(frames, 3 * len(PARENTS))) * 0.03
    swing = np.linspace(0, bend, frames)
    poses[:, 3 * L_SHOULDER + 1] -= swing
    poses[:, 3 * R_SHOULDER + 1] += swing
    poses[:, 3 * L_ELBOW + 1] -= swing / 2
    poses[:, 3 * R_ELBOW + 1] += swing / 2
    poses[:, 0] += np.pi / 2
    return {"trans": random.normal(size=(frames, 3)), "gender": np.array(gender),
            "mocap_framerate": np.array(120.0), "betas": random.normal(size=16),
            "dmpls": np.zeros((frames, 8)), "poses": poses}


def save_motion(path, keys=None, **changes):
    """Writes a motion. Changes of None leave a key out."""
    path.parent.mkdir(parents=True, exist_ok=True)
    keys = {**(motion_keys() if keys is None else keys), **changes}
    np.savez(path, **{key: value for key, value in keys.items() if value is not None})
    return path


def reference_vertices(keys, betas, pose, translation):
    """Returns posed vertices [V, 3] by loops, in the order of smplx.lbs."""
    v_shaped = keys["v_template"] + np.einsum("vab,b->va", keys["shapedirs"][:, :, :len(betas)], betas)
    joints = keys["J_regressor"] @ v_shaped
    turns = [_rotation(vector) for vector in pose.reshape(-1, 3)]
    feature = np.concatenate([(turn - np.eye(3)).ravel() for turn in turns[1:]])
    v_posed = v_shaped + keys["posedirs"] @ feature
    world = []
    for joint, turn in enumerate(turns):
        local = np.eye(4)
        local[:3, :3] = turn
        local[:3, 3] = joints[joint] - (joints[PARENTS[joint]] if joint else 0)
        world.append(world[PARENTS[joint]] @ local if joint else local)
    result = np.zeros_like(v_posed)
    for joint, matrix in enumerate(world):
        moved = (v_posed - joints[joint]) @ matrix[:3, :3].T + matrix[:3, 3]
        result += keys["weights"][:, joint:joint + 1] * moved
    return result + translation


def _rotation(vector):
    """The exponential of a skew-symmetric matrix, by its series."""
    x, y, z = vector
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    result, term = np.eye(3), np.eye(3)
    for order in range(1, 40):
        term = term @ skew / order
        result = result + term
    return result
