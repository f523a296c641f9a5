"""Contacts between frames."""

from __future__ import annotations

from typing import Dict, Optional

import numpy as np
import numpy.typing as npt

from pelt import _pelt
from pelt._contacts import Flags, Indices, limit
from pelt._model import Model
from pelt._poses import PosesLike, clip_poses
from pelt._run import Progress, run
from pelt._self_collide import SelfFilter, filter_of


class MovingContacts:
    """N pairs of triangles that intersect during a step from one frame to the next.

    step:        [N] int32, ascending: step s leads from frame s to frame s + 1.
    triangle_a, triangle_b:  [N] int32, ascending within a step.
    time:        [N] float32, 0 to 1: the first time at which the triangles intersect, as a part of
                 the step. They are apart at all earlier times.
    at_start:    [N] bool, whether the triangles intersect at the start of the step.
    feature_a, feature_b:  [N, 2] uint8, which parts meet first: (0, corner), (1, edge) or (2, 0) for
                 the whole triangle. Edge i leads from corner i to the next. Without meaning if
                 `at_start`.
    steps:       number of steps, F - 1.

    `len` is N.
    """

    def __init__(self, step: Indices, triangle_a: Indices, triangle_b: Indices,
                 time: npt.NDArray[np.float32], at_start: Flags,
                 features: npt.NDArray[np.uint8], steps: int) -> None:
        self.step = step
        self.triangle_a = triangle_a
        self.triangle_b = triangle_b
        self.time = time
        self.at_start = at_start
        self.feature_a = features[:, 0]
        self.feature_b = features[:, 1]
        self.steps = steps

    def per_step(self) -> npt.NDArray[np.int64]:
        """Returns the number of pairs in each step [steps]."""
        return np.bincount(self.step, minlength=self.steps).astype(np.int64, copy=False)

    def __len__(self) -> int:
        return len(self.step)

    def __repr__(self) -> str:
        touched = int(np.count_nonzero(self.per_step()))
        return (f"<pelt.{type(self).__name__}: {len(self)} pairs of triangles in {touched} of "
                f"{self.steps} steps>")


class SelfMovingContacts(MovingContacts):
    """Contacts of a model with itself during steps: triangle_a < triangle_b in each pair.

    left_out:  number of pairs that each filter has left out, by the name of the filter.
    """

    def __init__(self, step: Indices, triangle_a: Indices, triangle_b: Indices,
                 time: npt.NDArray[np.float32], at_start: Flags,
                 features: npt.NDArray[np.uint8], steps: int, left_out: Dict[str, int]) -> None:
        super().__init__(step, triangle_a, triangle_b, time, at_start, features, steps)
        self.left_out = left_out


def collide_moving(model_a: Model, poses_a: PosesLike, model_b: Model, poses_b: PosesLike, *,
                   times: bool = True, leave_out_start: bool = False,
                   max_contacts: Optional[int] = None, threads: Optional[int] = None,
                   progress: Progress = None) -> MovingContacts:
    """Returns every pair of triangles that intersect at any time between two frames.

    poses_a, poses_b:  as for `collide`, with at least two frames.
    times:             False computes neither times nor features, which is faster: `time` is 0.
    leave_out_start:   leave out pairs that intersect at the start of the step.
    max_contacts:      stop the query of a step after this number of pairs.

    In a step, each vertex moves in a straight line, at constant speed, from its position in one
    frame to that in the next. The answer is exact with respect to the posed vertices of both frames.

    Raises `pelt.Error` for invalid arguments.
    """
    a, b = clip_poses("poses_a", model_a, poses_a), clip_poses("poses_b", model_b, poses_b)
    steps = max(a.frame_count, b.frame_count) - 1
    with run("collide_moving", steps, threads, progress) as how:
        return MovingContacts(*_pelt.collide_moving(a, b, bool(leave_out_start), bool(times),
                                                    limit("max_contacts", max_contacts), how),
                              steps)


def first_contact(model_a: Model, poses_a: PosesLike, model_b: Model, poses_b: PosesLike, *,
                  leave_out_start: bool = False, threads: Optional[int] = None,
                  progress: Progress = None) -> MovingContacts:
    """Returns the first contact of each step: at most one pair of triangles for each.

    Of pairs with the same time, the lowest pair is returned. A step without contact has no row.

    Arguments and errors: see `collide_moving`.
    """
    a, b = clip_poses("poses_a", model_a, poses_a), clip_poses("poses_b", model_b, poses_b)
    steps = max(a.frame_count, b.frame_count) - 1
    with run("first_contact", steps, threads, progress) as how:
        return MovingContacts(*_pelt.first_contact(a, b, bool(leave_out_start), how), steps)


def self_collide_moving(model: Model, poses: PosesLike, ignore: Optional[SelfFilter] = None, *,
                        times: bool = True, leave_out_start: bool = False,
                        max_contacts: Optional[int] = None, threads: Optional[int] = None,
                        progress: Progress = None) -> SelfMovingContacts:
    """Returns every pair of triangles of one model that intersect each other between two frames.

    Arguments: see `collide_moving` and `self_collide`.
    """
    clip = clip_poses("poses", model, poses)
    steps = clip.frame_count - 1
    with run("self_collide_moving", steps, threads, progress) as how:
        columns, left_out = _pelt.self_collide_moving(
            clip, filter_of(model, ignore), bool(leave_out_start), bool(times),
            limit("max_contacts", max_contacts), how)
        return SelfMovingContacts(*columns, steps, left_out)
