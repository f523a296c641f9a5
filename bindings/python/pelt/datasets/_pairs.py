"""Metrics of pairs of clips: two bodies in one scene."""

from __future__ import annotations

from typing import Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from pelt import metrics
from pelt._collide import collide
from pelt._model import Model
from pelt._npz import Path
from pelt._pelt import Error
from pelt._poses import Vertices
from pelt.datasets._clips import Pair
from pelt.datasets._subjects import AT_A_TIME, Clip, Columns, Folder, Row, joined

PAIR_METRICS: Mapping[str, str] = {
    "touching": "pairs of triangles of both bodies that intersect, see pelt.collide",
    "inside": "metrics.vertices_inside: mean of the shares of both bodies, in percent",
    "depth": "metrics.depth: deepest vertex of either body in the other, in metres",
    "summed_depth": "metrics.summed_depth: depths of all vertices, summed, in metres",
    "volume": "metrics.intersection_volume, in cubic metres",
}
"""Names of metrics of two bodies, with what they are. All but `touching` need closed bodies."""

_PAIR_COLUMNS = ("clip_a", "clip_b", "body_model_a", "body_model_b", "options", "every", "frames",
                 "seconds", "fps", "gender_a", "gender_b")
_KINDS = ("mean", "max", "frame", "percent")


class PairMeasurement(Folder):
    """How to measure pairs of clips of a folder. Call it with a pair of clips to get its row.

    metrics:       names of `PAIR_METRICS`.
    close_holes:   close the holes of open bodies, such as the mouth of SMPL-X, by fans, see
                   `metrics.BodyParts`. All metrics but `touching` use them; without, they are empty
                   for open bodies. The middle of each fan counts as a vertex.

    Other arguments: see `Measurement`. The two clips of a pair are in one frame of reference, and have
    the same frames.
    """

    def __init__(self, folder: Path, body_models: Union[Path, Mapping[str, Path]],
                 metrics: Sequence[str] = tuple(PAIR_METRICS), *, every: int = 1,
                 body_only: bool = False, betas: Optional[int] = None, close_holes: bool = False,
                 fps: Optional[float] = None, threads: Optional[int] = None) -> None:
        super().__init__(folder, body_models, metrics, PAIR_METRICS, every, body_only, betas,
                         close_holes, fps, threads)

    hash_columns = ("clip_hash_a", "clip_hash_b", "body_model_hash_a", "body_model_hash_b")

    @property
    def columns(self) -> Tuple[str, ...]:
        """Names of the columns of a row."""
        measured = tuple(f"{name}_{kind}" for name in self.metrics for kind in _KINDS)
        return (_PAIR_COLUMNS + measured + (("volume_error",) if "volume" in self.metrics else ())
                + self.hash_columns)

    def item_of(self, row: Mapping[str, object]) -> Pair:
        """Returns the pair of a row."""
        return str(row["clip_a"]), str(row["clip_b"])

    def has_made(self, row: Mapping[str, object]) -> bool:
        """Returns whether a row may be of this measurement: of its body models, options and frames."""
        return (all(self.has_measured(row[f"gender_{one}"], row[f"body_model_{one}"],
                                      row.get(f"body_model_hash_{one}")) for one in "ab")
                and (row["options"], row["every"]) == (self.options, str(self.every)))

    def has_changed(self, row: Mapping[str, object]) -> bool:
        """Returns whether the file of a clip has other arrays than when the row was measured."""
        return any(self.clip_has_changed(row[f"clip_{one}"], row.get(f"clip_hash_{one}")) for one in "ab")

    def __call__(self, pair: Pair) -> Row:
        """Returns the row of a pair of clips: for each metric its mean over all frames, its maximum, the
        frame of the maximum, counted in the frames of the files, and the percentage of frames in which
        it is not 0. `volume_error` bounds the difference of each volume from the exact one; a frame has
        a volume if it exceeds this bound.

        Raises `pelt.Error` that names the file and the reason.
        """
        a, b = self.load(pair[0]), self.load(pair[1])
        _check_frames(a, b)
        row: Row = {"clip_a": pair[0], "clip_b": pair[1],
                    "body_model_a": self.name_of(a.body_model),
                    "body_model_b": self.name_of(b.body_model), "options": self.options,
                    "every": self.every, "frames": len(a.motion), "seconds": a.whole.seconds,
                    "fps": a.whole.fps, "gender_a": a.motion.gender,
                    "gender_b": b.motion.gender}
        values = self._values(a, b)
        for name in self.metrics:
            row.update(self.summary(name, values[name]))
            row[f"{name}_percent"] = _percent_of_frames(name, values)
        row.update(self.volume_error(values))
        row.update(clip_hash_a=a.hash, clip_hash_b=b.hash, body_model_hash_a=a.subject.body_hash,
                   body_model_hash_b=b.subject.body_hash)
        return row

    def _values(self, a: Clip, b: Clip) -> Columns:
        chunks = []
        try:
            for first in range(0, len(a.motion), AT_A_TIME):
                poses_a, poses_b = (
                    clip.subject.poses(clip.motion[first:first + AT_A_TIME], threads=self.threads)
                    for clip in (a, b))
                chunks.append(self._measure(a, poses_a, b, poses_b))
        except Error as error:
            raise Error(f"{a.path} and {b.path}: {error}") from error
        return joined(chunks)

    def _measure(self, a: Clip, poses_a: Vertices, b: Clip, poses_b: Vertices) -> Columns:
        """Returns the values of metrics in each frame, and `volume_error` with the volume."""
        columns: Columns = {}
        if "touching" in self.metrics:
            contacts = collide(a.subject.model, poses_a, b.subject.model, poses_b,
                               threads=self.threads, progress=False)
            columns["touching"] = contacts.per_frame().astype(np.float64)
        closed_a = a.subject.closed(poses_a, self.close_holes)
        closed_b = b.subject.closed(poses_b, self.close_holes)
        if closed_a is None or closed_b is None:
            undefined = np.full(len(poses_a), np.nan)
            columns.update({name: undefined for name in (*self.metrics, "volume_error")
                            if name != "touching"})
        else:
            columns.update(self._insides((*closed_a, *closed_b)))
        return {name: values for name, values in columns.items()
                if name in self.metrics or (name == "volume_error" and "volume" in self.metrics)}

    def _insides(self, bodies: Tuple[Model, Vertices, Model, Vertices]) -> Columns:
        """Returns the values of the metrics that need closed bodies."""
        columns: Columns = {}
        if "inside" in self.metrics:
            inside = metrics.vertices_inside(*bodies, threads=self.threads)
            columns["inside"] = 100 * (inside.fraction_a + inside.fraction_b) / 2
        if "depth" in self.metrics:
            columns["depth"] = metrics.depth(*bodies, threads=self.threads).per_frame
        if "summed_depth" in self.metrics:
            columns["summed_depth"] = metrics.summed_depth(*bodies, threads=self.threads).per_frame
        if "volume" in self.metrics:
            columns["volume"], columns["volume_error"] = metrics.intersection_volume(
                *bodies, threads=self.threads, progress=False)
        return columns


def _percent_of_frames(name: str, values: Columns) -> Union[str, float]:
    """Returns the percentage of frames in which a metric is not 0."""
    if np.isnan(values[name]).any():
        return ""
    least = values["volume_error"] if name == "volume" else 0
    return 100 * float((np.abs(values[name]) > least).mean())


def _check_frames(a: Clip, b: Clip) -> None:
    """The clips of a pair must show the same moments."""
    if len(a.whole) != len(b.whole):
        raise Error(f"{a.path} has {len(a.whole)} frames, but {b.path} has {len(b.whole)}")
    if a.whole.fps != b.whole.fps:
        raise Error(f"{a.path} has {a.whole.fps:g} frames per second, but {b.path} has "
                    f"{b.whole.fps:g}")
