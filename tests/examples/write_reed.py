"""Writes reed.gltf: a ribbon of three rungs in the plane x = 0, two joints, two clips.

The lowest rung follows joint `root`, the highest joint `tip`, and the middle one both. Clip `lean`
moves the tip by 1 along x within 4 seconds; clip `stand` does not move it.
"""

import base64
import json
import struct
import sys

FLOAT, UNSIGNED_BYTE, UNSIGNED_SHORT = 5126, 5121, 5123

buffer, views, accessors = bytearray(), [], []


def accessor(kind, component, letter, rows, **bounds):
    """Appends an array of rows to the buffer. Returns the index of its accessor."""
    data = b"".join(struct.pack(f"<{len(row)}{letter}", *row) for row in rows)
    views.append({"buffer": 0, "byteOffset": len(buffer), "byteLength": len(data)})
    buffer.extend(data + b"\0" * (-len(data) % 4))
    accessors.append({"bufferView": len(views) - 1, "componentType": component, "type": kind,
                      "count": len(rows), **bounds})
    return len(accessors) - 1


def clip(name, tip_at_end):
    times = accessor("SCALAR", FLOAT, "f", [[0], [4]], min=[0], max=[4])
    tips = accessor("VEC3", FLOAT, "f", [[0, 2, 0], tip_at_end])
    return {"name": name,
            "samplers": [{"input": times, "output": tips}],
            "channels": [{"sampler": 0, "target": {"node": 2, "path": "translation"}}]}


primitive = {
    "attributes": {
        "POSITION": accessor("VEC3", FLOAT, "f",
                             [[0, y, z] for y in (0, 1, 2) for z in (0, 1)],
                             min=[0, 0, 0], max=[0, 2, 1]),
        "JOINTS_0": accessor("VEC4", UNSIGNED_BYTE, "B", [[0, 1, 0, 0]] * 6),
        "WEIGHTS_0": accessor("VEC4", FLOAT, "f", [[1 - tip, tip, 0, 0]
                                                   for tip in (0, 0.5, 1) for _ in range(2)]),
    },
    "indices": accessor("SCALAR", UNSIGNED_SHORT, "H",
                        [[i] for i in (0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4)]),
}
identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
from_tip = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -2, 0, 1]
inverse_binds = accessor("MAT4", FLOAT, "f", [identity, from_tip])
animations = [clip("lean", [1, 2, 0]), clip("stand", [0, 2, 0])]

document = {
    "asset": {"version": "2.0"},
    "scene": 0,
    "scenes": [{"nodes": [0, 1]}],
    "nodes": [{"name": "reed", "mesh": 0, "skin": 0},
              {"name": "root", "children": [2]},
              {"name": "tip", "translation": [0, 2, 0]}],
    "meshes": [{"primitives": [primitive]}],
    "skins": [{"joints": [1, 2], "inverseBindMatrices": inverse_binds}],
    "animations": animations,
    "accessors": accessors,
    "bufferViews": views,
    "buffers": [{"byteLength": len(buffer),
                 "uri": "data:application/octet-stream;base64," +
                        base64.b64encode(buffer).decode()}],
}
with open(sys.argv[1], "w") as file:
    json.dump(document, file)
