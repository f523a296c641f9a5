"""Geometry of contacts."""

from __future__ import annotations

from typing import Any, Dict, Optional

import numpy as np
import numpy.typing as npt

from pelt import _pelt
from pelt._contacts import Contacts, Flags, Indices, SelfContacts
from pelt._model import Model
from pelt._poses import PosesLike, clip_poses
from pelt._run import Progress, run

_Floats = npt.NDArray[np.float32]
_Longs = npt.NDArray[np.int64]


class ContactGeometry:
    """Traces, curves and patches of N contacts, over all frames.

    A trace is the intersection of the two triangles of a contact. Trace i is that of row i of
    `contacts`:
        contacts:          the contacts.
        kind:              [N] uint8: 0 segment, 1 point, 2 coplanar triangles, 3 collapsed triangle.
        start, end:        [N, 3] float32, ends of the segment. A point if `kind` is 1, and for 2 and
                           3 the midpoint between the centres of the triangles.
        normal:            [N, 3] float32, unit vector in which a should move to leave b.
        depth:             [N] float32, overlap of the two triangles along the normal.
        joint_a, joint_b:  [N] int32, joints that the triangles follow.

    A curve is a chain of segments. Curve c consists of the traces `curve_trace[begin:end]`, where
    begin and end are `curve_begin[c]` and `curve_begin[c + 1]`:
        curve_frame:       [C] int32, ascending.
        curve_begin:       [C + 1] int64.
        curve_closed:      [C] bool, whether the last segment ends where the first one starts.
        curve_trace:       [S] int64, indices of traces.
        curve_reversed:    [S] bool, whether the trace is traversed from `end` to `start`.

    A patch is a connected set of contacts. Patch p consists of the traces
    `patch_trace[patch_begin[p]:patch_begin[p + 1]]`:
        patch_frame:       [P] int32, ascending; in a frame, patches with most contacts come first.
        patch_begin:       [P + 1] int64.
        patch_trace:       [N] int64, indices of traces.
        patch_length:      [P] float32, length of the line in which the surfaces intersect.
        patch_point:       [P, 3] float32, mean of the midpoints.
        patch_normal:      [P, 3] float32, mean direction in which a should move to leave b.
        patch_depth:       [P] float32, largest depth of a trace.
        patch_joint_a, patch_joint_b:  [P] int32, most frequent joints.
    """

    def __init__(self, contacts: Contacts, columns: Dict[str, npt.NDArray[Any]]) -> None:
        self.contacts = contacts
        self.kind: npt.NDArray[np.uint8] = columns["kind"]
        self.start: _Floats = columns["start"]
        self.end: _Floats = columns["end"]
        self.normal: _Floats = columns["normal"]
        self.depth: _Floats = columns["depth"]
        self.joint_a: Indices = columns["joint_a"]
        self.joint_b: Indices = columns["joint_b"]
        self.curve_frame: Indices = columns["curve_frame"]
        self.curve_begin: _Longs = columns["curve_begin"]
        self.curve_closed: Flags = columns["curve_closed"]
        self.curve_trace: _Longs = columns["curve_trace"]
        self.curve_reversed: Flags = columns["curve_reversed"]
        self.patch_frame: Indices = columns["patch_frame"]
        self.patch_begin: _Longs = columns["patch_begin"]
        self.patch_trace: _Longs = columns["patch_trace"]
        self.patch_length: _Floats = columns["patch_length"]
        self.patch_point: _Floats = columns["patch_point"]
        self.patch_normal: _Floats = columns["patch_normal"]
        self.patch_depth: _Floats = columns["patch_depth"]
        self.patch_joint_a: Indices = columns["patch_joint_a"]
        self.patch_joint_b: Indices = columns["patch_joint_b"]

    def curve(self, index: int) -> _Floats:
        """Returns the points of a curve [n + 1, 3]. A closed curve ends at its first point."""
        if not 0 <= index < len(self.curve_frame):
            raise IndexError(f"curve {index} of {len(self.curve_frame)}")
        steps = slice(self.curve_begin[index], self.curve_begin[index + 1])
        traces, is_reversed = self.curve_trace[steps], self.curve_reversed[steps, np.newaxis]
        first = np.where(is_reversed, self.end[traces], self.start[traces])
        last = np.where(is_reversed, self.start[traces], self.end[traces])
        return np.concatenate([first, last[-1:]])

    def __repr__(self) -> str:
        return (f"<pelt.ContactGeometry: {len(self.kind)} traces, {len(self.curve_frame)} curves, "
                f"{len(self.patch_frame)} patches>")


def contact_geometry(model_a: Model, poses_a: PosesLike, model_b: Model, poses_b: PosesLike,
                     contacts: Contacts, *, threads: Optional[int] = None,
                     progress: Progress = None) -> ContactGeometry:
    """Returns positions, normals, depths, curves and patches of contacts.

    contacts:  what `collide` has returned for the same models and poses.

    Raises `pelt.Error` for invalid arguments.
    """
    a, b = clip_poses("poses_a", model_a, poses_a), clip_poses("poses_b", model_b, poses_b)
    with run("contact_geometry", contacts.frames, threads, progress) as how:
        return ContactGeometry(contacts, _pelt.contact_geometry(
            a, b, contacts.frame, contacts.triangle_a, contacts.triangle_b, how))


def self_contact_geometry(model: Model, poses: PosesLike, contacts: SelfContacts, *,
                          threads: Optional[int] = None,
                          progress: Progress = None) -> ContactGeometry:
    """Returns positions, normals, depths, curves and patches of contacts of a model with itself.

    contacts:  what `self_collide` has returned for the same model and poses.

    Raises `pelt.Error` for invalid arguments.
    """
    clip = clip_poses("poses", model, poses)
    with run("self_contact_geometry", contacts.frames, threads, progress) as how:
        return ContactGeometry(contacts, _pelt.self_contact_geometry(
            clip, contacts.frame, contacts.triangle_a, contacts.triangle_b, how))
