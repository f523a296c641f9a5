"""Metrics of single clips."""

from __future__ import annotations

from typing import Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from pelt import metrics
from pelt._npz import Path
from pelt._pelt import Error
from pelt._poses import Vertices
from pelt._self_collide import neighbours, self_collide
from pelt.datasets._subjects import AT_A_TIME, Clip, Columns, Folder, Row, Subject, joined
from pelt.metrics._collisions import collisions_of

METRICS: Mapping[str, str] = {
    "colliding": "metrics.colliding_triangles, in percent",
    "filtered": "pairs of triangles that are left after metrics.smplify_x_filter",
    "contact": "metrics.self_contact: vertices in contact, in percent",
    "volume": "metrics.self_intersection_volume, in cubic metres; empty if the body is not closed",
}
"""Names of metrics, with what they are."""

_CLIP_COLUMNS = ("clip", "body_model", "options", "every", "frames", "seconds", "fps", "gender")


class Measurement(Folder):
    """How to measure the clips of a folder. Call it with a clip to get its row.

    folder:        where the clips are.
    body_models:   path of a body model for each gender; "" is for all others. Or one path.
    metrics:       names of `METRICS`.
    every:         measure every n-th frame only.
    body_only:     ignore the joints beyond the body, such as those of the hands, see
                   `motions.Motion.body_only`.
    betas:         use only the first n shape parameters of each clip; 0 is the mean shape. Default: all.
    close_holes:   close the holes of open bodies, such as the mouth of SMPL-X, by fans, see
                   `metrics.BodyParts`. Only volumes use them.
    fps:           frames per second of clips whose files state none. If a file states two rates, `fps`
                   must be one of them. Other clips keep their own.
    threads:       of each clip; default: all processors. The row is the same for any number.
    """

    def __init__(self, folder: Path, body_models: Union[Path, Mapping[str, Path]],
                 metrics: Sequence[str] = tuple(METRICS), *, every: int = 1,
                 body_only: bool = False, betas: Optional[int] = None, close_holes: bool = False,
                 fps: Optional[float] = None, threads: Optional[int] = None) -> None:
        super().__init__(folder, body_models, metrics, METRICS, every, body_only, betas, close_holes,
                         fps, threads)

    hash_columns = ("clip_hash", "body_model_hash")

    @property
    def columns(self) -> Tuple[str, ...]:
        """Names of the columns of a row."""
        measured = tuple(f"{name}_{kind}" for name in self.metrics for kind in ("mean", "max", "frame"))
        return (_CLIP_COLUMNS + measured + (("volume_error",) if "volume" in self.metrics else ())
                + self.hash_columns)

    def item_of(self, row: Mapping[str, object]) -> str:
        """Returns the clip of a row."""
        return str(row["clip"])

    def has_made(self, row: Mapping[str, object]) -> bool:
        """Returns whether a row may be of this measurement: of its body models, options and frames."""
        return (self.has_measured(row["gender"], row["body_model"], row.get("body_model_hash"))
                and (row["options"], row["every"]) == (self.options, str(self.every)))

    def has_changed(self, row: Mapping[str, object]) -> bool:
        """Returns whether the file of the clip has other arrays than when the row was measured."""
        return self.clip_has_changed(row["clip"], row.get("clip_hash"))

    def __call__(self, clip: str) -> Row:
        """Returns the row of a clip: for each metric its mean over all frames, its maximum, and the
        frame of the maximum, counted in the frames of the file. `volume_error` bounds the difference
        of each volume from the exact one.

        Raises `pelt.Error` that names the file and the reason.
        """
        read = self.load(clip)
        row: Row = {"clip": clip, "body_model": self.name_of(read.body_model),
                    "options": self.options, "every": self.every, "frames": len(read.motion),
                    "seconds": read.whole.seconds, "fps": read.whole.fps,
                    "gender": read.motion.gender}
        values = self._values(read)
        for name in self.metrics:
            row.update(self.summary(name, values[name]))
        row.update(self.volume_error(values))
        row.update(clip_hash=read.hash, body_model_hash=read.subject.body_hash)
        return row

    def _values(self, clip: Clip) -> Columns:
        try:
            return joined([self._measure(clip.subject, poses) for _, poses in
                           clip.subject.chunks(clip.motion, AT_A_TIME, threads=self.threads)])
        except Error as error:
            raise Error(f"{clip.path}: {error}") from error

    def _measure(self, subject: Subject, poses: Vertices) -> Columns:
        """Returns the values of metrics in each frame, and `volume_error` with the volume."""
        columns = self._collisions(subject, poses)
        if "contact" in self.metrics:
            columns["contact"] = metrics.self_contact(subject.model, poses, subject.geodesics,
                                                      threads=self.threads, progress=False).percent
        if "volume" in self.metrics:
            closed = subject.closed(poses, self.close_holes)
            columns["volume"], columns["volume_error"] = (
                (np.full(len(poses), np.nan),) * 2 if closed is None else
                metrics.self_intersection_volume(*closed, threads=self.threads, progress=False))
        return columns

    def _collisions(self, subject: Subject, poses: Vertices) -> Columns:
        """One query answers for both metrics of colliding triangles."""
        columns: Columns = {}
        if "colliding" in self.metrics:
            contacts = self_collide(subject.model, poses, neighbours(subject.model),
                                    threads=self.threads, progress=False)
            columns["colliding"] = collisions_of(contacts, subject.model.triangle_count).percent
        if "filtered" in self.metrics:
            left = (subject.filter.leave_out(contacts) if "colliding" in self.metrics else
                    self_collide(subject.model, poses, subject.filter, threads=self.threads,
                                 progress=False))
            columns["filtered"] = left.per_frame().astype(np.float64)
        return columns
