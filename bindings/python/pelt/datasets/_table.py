"""Metrics of many clips: a table with one row for each clip.

    from pelt import datasets

    measure = datasets.Measurement("AMASS", {"male": "SMPLH_MALE.npz", "female": "SMPLH_FEMALE.npz"})
    with datasets.Table("table.csv", measure) as table:
        for clip in datasets.find_clips("AMASS"):
            if clip not in table.done:
                table.append(measure(clip))

`python -m pelt metrics` does this, goes on after files that cannot be read, and lists them.
`Measurement` can be pickled, so that other processes and machines can measure clips.
"""

import csv
import functools
import io
import os
from typing import Dict, List, Mapping, Sequence, Set, Tuple, Union

import numpy as np
import numpy.typing as npt

from pelt import body_models, metrics, motions
from pelt._npz import Path
from pelt._pelt import Error
from pelt._poses import Vertices
from pelt._self_collide import SelfFilter, neighbours, self_collide
from pelt.metrics._collisions import collisions_of

try:
    import fcntl
except ImportError:  # not on Windows: there, tables are not locked
    fcntl = None  # type: ignore[assignment]

Row = Dict[str, Union[str, int, float]]

__all__ = ["METRICS", "Measurement", "Row", "Table", "find_clips"]

METRICS: Mapping[str, str] = {
    "colliding": "metrics.colliding_triangles, in percent",
    "filtered": "pairs of triangles that are left after metrics.smplify_x_filter",
    "contact": "metrics.self_contact: vertices in contact, in percent",
    "volume": "metrics.self_intersection_volume, in cubic metres; empty if the body is not closed",
}
"""Names of metrics, with what they are."""

Columns = Dict[str, npt.NDArray[np.float64]]
"""Values of metrics in each frame [F]; NaN if they are not defined."""

_CLIP_COLUMNS = ("clip", "body_model", "options", "every", "frames", "seconds", "fps", "gender")
_AT_A_TIME = 128


def find_clips(folder: Path) -> List[str]:
    """Returns the motion files of a folder and its subfolders, sorted, relative to the folder.

    These are all `.npz` and `.pkl` files, apart from the shapes that AMASS keeps beside its motions:
    `shape.npz` and `*_stagei.npz`.
    """
    root = os.fspath(folder)
    if not os.path.isdir(root):
        raise Error(f"{root}: not a folder")
    found = []
    for where, _, names in os.walk(root):
        found += [os.path.relpath(os.path.join(where, name), root) for name in names
                  if name.endswith((".npz", ".pkl"))
                  and name != "shape.npz" and not name.endswith("_stagei.npz")]
    return sorted(found)


class Measurement:
    """How to measure the clips of a folder. Call it with a clip to get its row.

    folder:        where the clips are.
    body_models:   path of a body model for each gender; "" is for all others. Or one path.
    metrics:       names of `METRICS`.
    every:         measure every n-th frame only.
    body_only:     ignore the joints beyond the body, such as those of the hands, see
                   `motions.Motion.body_only`.
    betas:         use only the first n shape parameters of each clip; 0 is the mean shape. Default: all.
    threads:       of each clip; default: all processors. The row is the same for any number.
    """

    def __init__(self, folder: Path, body_models: Union[Path, Mapping[str, Path]],
                 metrics: Sequence[str] = tuple(METRICS), *, every: int = 1,
                 body_only: bool = False, betas: Union[int, None] = None,
                 threads: Union[int, None] = None) -> None:
        given = body_models if isinstance(body_models, Mapping) else {"": body_models}
        self.folder = os.fspath(folder)
        self.body_models = {gender: os.fspath(path) for gender, path in given.items()}
        self.metrics = tuple(metrics)
        self.every = every
        self.body_only = body_only
        self.betas = betas
        self.threads = threads
        unknown = [name for name in self.metrics if name not in METRICS]
        if unknown:
            raise Error(f"metrics: unknown {unknown[0]!r}, expected {', '.join(METRICS)}")
        if every < 1:
            raise Error(f"every: expected 1 or more, found {every}")
        if betas is not None and betas < 0:
            raise Error(f"betas: expected 0 or more, found {betas}")
        for path in self.body_models.values():
            _body(path)  # rather one error now than one for each clip

    @property
    def options(self) -> str:
        """What else decides the values of a row, as the table states it."""
        return " ".join((["body-only"] if self.body_only else [])
                        + ([f"betas={self.betas}"] if self.betas is not None else []))

    @property
    def columns(self) -> Tuple[str, ...]:
        """Names of the columns of a row."""
        measured = tuple(f"{name}_{kind}" for name in self.metrics for kind in ("mean", "max", "frame"))
        return _CLIP_COLUMNS + measured + (("volume_error",) if "volume" in self.metrics else ())

    def __call__(self, clip: str) -> Row:
        """Returns the row of a clip: for each metric its mean over all frames, its maximum, and the
        frame of the maximum, counted in the frames of the file. `volume_error` bounds the difference
        of each volume from the exact one.

        Raises `pelt.Error` that names the file and the reason.
        """
        whole = motions.load(os.path.join(self.folder, clip))
        path = self._body_model(clip, whole.gender)
        subject = self._subject(clip, path, whole.betas[:self.betas])
        motion = whole.body_only(subject.body.joint_count) if self.body_only else whole
        motion = motion[::self.every]
        row: Row = {"clip": clip, "body_model": os.path.basename(path), "options": self.options,
                    "every": self.every, "frames": len(motion), "seconds": whole.seconds,
                    "fps": whole.fps, "gender": whole.gender}
        values = self._values(clip, subject, motion)
        for name in self.metrics:
            row.update(self._summary(name, values[name]))
        if "volume" in self.metrics:
            error = float(values["volume_error"].max())
            row["volume_error"] = "" if np.isnan(error) else error
        return row

    def _body_model(self, clip: str, gender: str) -> str:
        path = self.body_models.get(gender, self.body_models.get(""))
        if path is None:
            raise Error(f"{os.path.join(self.folder, clip)}: gender: no body model for {gender!r}")
        return path

    def _subject(self, clip: str, path: str,
                 betas: npt.NDArray[np.float64]) -> "_MeasuredSubject":
        most = _body(path).shape_directions.shape[2]
        if len(betas) > most:
            raise Error(f"{os.path.join(self.folder, clip)}: betas: {len(betas)} shape parameters, but "
                        f"{path} has {most}: measure with `--betas {most}`, or betas={most}")
        return _subject(path, betas.tobytes())

    def _values(self, clip: str, subject: "_MeasuredSubject",
                motion: motions.Motion) -> Columns:
        try:
            chunks = [subject.measure(self.metrics, poses, self.threads)
                      for _, poses in subject.chunks(motion, _AT_A_TIME, threads=self.threads)]
        except Error as error:
            raise Error(f"{os.path.join(self.folder, clip)}: {error}") from error
        return {name: np.concatenate([chunk[name] for chunk in chunks]) for name in chunks[0]}

    def _summary(self, name: str, values: npt.NDArray[np.float64]) -> Row:
        if np.isnan(values).any():
            return {f"{name}_mean": "", f"{name}_max": "", f"{name}_frame": ""}
        return {f"{name}_mean": float(values.mean()), f"{name}_max": float(values.max()),
                f"{name}_frame": int(values.argmax()) * self.every}


class _MeasuredSubject(body_models.Subject):
    """A subject, and what its metrics need."""

    def __init__(self, subject: body_models.Subject) -> None:
        self.__dict__.update(subject.__dict__)

    @functools.cached_property
    def filter(self) -> SelfFilter:
        return metrics.smplify_x_filter(self.model, self.body.parents)

    @functools.cached_property
    def geodesics(self) -> metrics.Geodesics:
        return metrics.Geodesics(self.rest, self.body.faces)

    def measure(self, names: Sequence[str], poses: Vertices, threads: Union[int, None]) -> Columns:
        """Returns the values of metrics in each frame, and `volume_error` with the volume."""
        columns = self._collisions(names, poses, threads)
        if "contact" in names:
            columns["contact"] = metrics.self_contact(self.model, poses, self.geodesics,
                                                      threads=threads, progress=False).percent
        if "volume" in names and self.model.is_closed:
            columns["volume"], columns["volume_error"] = metrics.self_intersection_volume(
                self.model, poses, threads=threads, progress=False)
        elif "volume" in names:
            columns["volume"] = columns["volume_error"] = np.full(len(poses), np.nan)
        return columns

    def _collisions(self, names: Sequence[str], poses: Vertices, threads: Union[int, None]) -> Columns:
        """One query answers for both metrics of colliding triangles."""
        columns: Columns = {}
        if "colliding" in names:
            contacts = self_collide(self.model, poses, neighbours(self.model), threads=threads,
                                    progress=False)
            columns["colliding"] = collisions_of(contacts, self.model.triangle_count).percent
        if "filtered" in names:
            left = (self.filter.leave_out(contacts) if "colliding" in names else
                    self_collide(self.model, poses, self.filter, threads=threads, progress=False))
            columns["filtered"] = left.per_frame().astype(np.float64)
        return columns


@functools.lru_cache(maxsize=4)
def _body(path: str) -> body_models.BodyModel:
    return body_models.load(path)


@functools.lru_cache(maxsize=2)
def _subject(path: str, betas: bytes) -> _MeasuredSubject:
    """Consecutive clips often are of one subject."""
    return _MeasuredSubject(_body(path).subject(np.frombuffer(betas)))


class Table:
    """A CSV file that grows by one row for each clip. Each row is written at once, so a process that is
    killed loses at most the clip that it was measuring.

    path:     of the file. If it exists, the table goes on where it ended.
    measure:  what the rows contain. Raises `pelt.Error` if the file has rows of another measurement.

    done:     clips that the table has.

    Only one process at a time can write a table.
    """

    def __init__(self, path: Path, measure: Measurement) -> None:
        self.path = os.fspath(path)
        self.done: Set[str] = set()
        self._columns = measure.columns
        try:
            self._file = open(self.path, "a+b", buffering=0)
        except OSError as error:
            raise Error(f"{self.path}: {error.strerror}") from error
        try:
            self._lock()
            self._resume(measure)
        except BaseException:
            self._file.close()
            raise

    def append(self, row: Row) -> None:
        """Writes the row of a clip."""
        self._write([row[column] for column in self._columns])
        self.done.add(str(row["clip"]))

    def __enter__(self) -> "Table":
        return self

    def __exit__(self, *_: object) -> None:
        self._file.close()

    def _lock(self) -> None:
        if fcntl is None:
            return
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            raise Error(f"{self.path}: another process is writing this table") from error

    def _resume(self, measure: Measurement) -> None:
        self._file.seek(0)
        content = self._file.read()
        whole = content.rfind(b"\n") + 1  # what follows is a row of a process that was killed
        self._file.truncate(whole)
        rows = list(csv.reader(io.StringIO(content[:whole].decode("utf-8", "replace"), newline="")))
        if not rows:
            self._write(self._columns)
            return
        if rows[0] != list(self._columns):
            raise Error(f"{self.path}: has other columns than this measurement: choose another file")
        names = {os.path.basename(path) for path in measure.body_models.values()}
        for number, row in enumerate(rows[1:], 2):
            made_by = (measure.options, str(measure.every))
            if len(row) != len(self._columns) or row[1] not in names or tuple(row[2:4]) != made_by:
                raise Error(f"{self.path}: row {number} is of another measurement (other body models, "
                            f"options or frames): choose another file")
            self.done.add(row[0])

    def _write(self, values: Sequence[object]) -> None:
        text = io.StringIO(newline="")
        csv.writer(text, lineterminator="\n").writerow(values)
        data = text.getvalue().encode("utf-8", "surrogateescape")
        self._file.write(data)
        os.fsync(self._file.fileno())
