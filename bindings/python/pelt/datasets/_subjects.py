"""Bodies and motions of a folder: what measurements of clips and of pairs share."""

from __future__ import annotations

import functools
import os
from typing import Dict, Iterable, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from pelt import body_models, metrics, motions
from pelt._model import Model
from pelt._npz import Path
from pelt._pelt import Error
from pelt._poses import Vertices
from pelt._self_collide import SelfFilter
from pelt.datasets._contents import contents_hash

Columns = Dict[str, npt.NDArray[np.float64]]
"""Values of metrics in each frame [F]; NaN if they are not defined."""

Row = Dict[str, Union[str, int, float]]
"""Values by the names of their columns."""

_OF_ANY_SURFACE = {"colliding", "filtered", "contact", "touching"}
"""Metrics that need no inside."""

AT_A_TIME = 128
"""Frames that are in memory at a time."""


class Subject(body_models.Subject):
    """A subject, and what its metrics need.

    body_hash:  `contents_hash` of the file of the body model.
    """

    def __init__(self, subject: body_models.Subject, body_hash: str) -> None:
        self.__dict__.update(subject.__dict__)
        self.body_hash = body_hash

    @functools.cached_property
    def filter(self) -> SelfFilter:
        return metrics.smplify_x_filter(self.model, self.body.parents)

    @functools.cached_property
    def geodesics(self) -> metrics.Geodesics:
        return metrics.Geodesics(self.rest, self.body.faces)

    @functools.cached_property
    def _parts(self) -> metrics.BodyParts:
        return metrics.BodyParts(self.rest, self.body.faces, np.zeros(len(self.rest), np.int64))

    def closed(self, poses: Vertices, close_holes: bool) -> Optional[Tuple[Model, Vertices]]:
        """Returns the body as a closed surface with its poses, or None if it has holes that remain."""
        if self.model.is_closed:
            return self.model, poses
        if not close_holes:
            return None
        return self._parts.model(0), self._parts.poses(0, poses.positions)


class Clip(NamedTuple):
    """The motion of a file, with its subject."""

    path: str
    body_model: str
    subject: Subject
    whole: motions.Motion
    """all frames of the file"""

    motion: motions.Motion
    """the frames that are measured"""

    hash: str
    """`contents_hash` of the file"""


class Folder:
    """How the motions of a folder are read. The arguments are those of `Measurement`."""

    def __init__(self, folder: Path, body_models: Union[Path, Mapping[str, Path]],
                 names: Sequence[str], known: Mapping[str, str], every: int, body_only: bool,
                 betas: Optional[int], close_holes: bool, fps: Optional[float],
                 threads: Optional[int]) -> None:
        given = body_models if isinstance(body_models, Mapping) else {"": body_models}
        self.folder = os.fspath(folder)
        self.body_models = {gender: os.fspath(path) for gender, path in given.items()}
        self._names = _distinct_ends(self.body_models.values())
        self.metrics = tuple(names)
        self.every = every
        self.body_only = body_only
        self.betas = betas
        self.close_holes = close_holes
        self.fps = fps
        self.threads = threads
        unknown = [name for name in self.metrics if name not in known]
        if unknown:
            raise Error(f"metrics: unknown {unknown[0]!r}, expected {', '.join(known)}")
        if every < 1:
            raise Error(f"every: expected 1 or more, found {every}")
        if betas is not None and betas < 0:
            raise Error(f"betas: expected 0 or more, found {betas}")
        if fps is not None and not 0 < fps < np.inf:
            raise Error(f"fps: expected a positive number, found {fps}")
        self._body_hashes: Dict[str, str] = {}
        for path in self.body_models.values():
            self._body_hashes[path], body = _body(path)  # rather one error now than one for each clip
            if "volume" in self.metrics and _faces_inwards(body):
                raise Error(f"{path}: f: the triangles face inwards, so that volumes would be those of a "
                            "body turned inside out: save f[:, ::-1] instead")

    def undefined_metrics(self) -> List[str]:
        """Returns the metrics that a body model with holes leaves empty."""
        inside = [name for name in self.metrics if name not in _OF_ANY_SURFACE]
        if self.close_holes or not inside:
            return []
        mean_shape = np.zeros(0)
        are_closed = [_subject(path, mean_shape).model.is_closed for path in self.body_models.values()]
        return [] if all(are_closed) else inside

    @property
    def options(self) -> str:
        """What else decides the values of a row, as the table states it."""
        return " ".join((["body-only"] if self.body_only else [])
                        + ([f"betas={self.betas}"] if self.betas is not None else [])
                        + (["close-holes"] if self.close_holes else []))

    def has_measured(self, gender: object, body_model: object, body_hash: Optional[object]) -> bool:
        """Returns whether the subjects of a gender are measured with a body model of this name and
        hash. Rows of early versions have no hash: None."""
        path = self._path_for(str(gender))
        return (path is not None and self.name_of(path) == body_model
                and body_hash in (None, self._body_hashes[path]))

    def clip_has_changed(self, clip: object, clip_hash: Optional[object]) -> bool:
        """Returns whether a clip has other arrays than when it had this hash. Clips that are not there
        have not changed; rows of early versions have no hash: None."""
        found = None if clip_hash is None else contents_hash(self.path_of(str(clip)))
        return found is not None and found != clip_hash

    def name_of(self, body_model: str) -> str:
        """Returns the name of a body model in the table: the end of its path."""
        return self._names[body_model]

    def path_of(self, clip: str) -> str:
        return os.path.join(self.folder, clip)

    def load(self, clip: str) -> Clip:
        """Returns a clip with the frames that are measured."""
        path = self.path_of(clip)
        # The hash comes first: if the file is replaced now, the row is measured again, not kept.
        clip_hash = contents_hash(path) or ""
        whole = motions.load(path, fps=self.fps)
        if len(whole.betas) == 0 and self.betas != 0:
            raise Error(f"{path}: betas: missing: measure with `--betas 0`, or betas=0, for the mean shape")
        body_model = self._body_model(path, whole.gender)
        subject = self._subject(path, body_model, whole.betas[:self.betas])
        motion = whole.body_only(subject.body.joint_count) if self.body_only else whole
        return Clip(path, body_model, subject, whole, motion[::self.every], clip_hash)

    def _body_model(self, path: str, gender: str) -> str:
        found = self._path_for(gender)
        if found is None:
            raise Error(f"{path}: gender: no body model for {gender!r}: add `--body-model "
                        f"{gender}=FILE`, or one for all others, `--body-model FILE`")
        return found

    def _path_for(self, gender: str) -> Optional[str]:
        return self.body_models.get(gender, self.body_models.get(""))

    def _subject(self, path: str, body_model: str, betas: npt.NDArray[np.float64]) -> Subject:
        most = _body(body_model)[1].shape_directions.shape[2]
        if len(betas) > most:
            raise Error(f"{path}: betas: {len(betas)} shape parameters, but {body_model} has {most}: "
                        f"measure with `--betas {most}`, or betas={most}")
        try:
            return _subject(body_model, betas)
        except Error as error:
            raise Error(f"{path}: {error}") from error

    def summary(self, name: str, values: npt.NDArray[np.float64]) -> Row:
        """Returns the mean of a metric, its maximum, and the frame of the maximum."""
        if np.isnan(values).any():
            return {f"{name}_mean": "", f"{name}_max": "", f"{name}_frame": ""}
        return {f"{name}_mean": float(values.mean()), f"{name}_max": float(values.max()),
                f"{name}_frame": int(values.argmax()) * self.every}

    def volume_error(self, values: Columns) -> Row:
        """Returns the bound of the error of all volumes, if there are volumes."""
        if "volume_error" not in values:
            return {}
        error = float(values["volume_error"].max())
        return {"volume_error": "" if np.isnan(error) else error}


def joined(chunks: Sequence[Columns]) -> Columns:
    """Returns the values of all frames."""
    return {name: np.concatenate([chunk[name] for chunk in chunks]) for name in chunks[0]}


def _distinct_ends(paths: Iterable[str]) -> Dict[str, str]:
    """Returns the ends of paths, with as many folders as tell the files apart: the body models of SMPL-H
    are male/model.npz and female/model.npz."""
    parts = {path: tuple(os.path.normpath(path).split(os.sep)) for path in paths}
    ends: Dict[str, str] = {}
    for length in range(1, max(map(len, parts.values()), default=0) + 1):
        ends = {path: "/".join(names[-length:]) for path, names in parts.items()}
        if len(set(ends.values())) == len(set(parts.values())):
            break
    return ends


def _body(path: str) -> Tuple[str, body_models.BodyModel]:
    """Returns the hash of a body model, and the body model."""
    return _loaded_body(path, _version(path))


def _version(path: str) -> Tuple[int, int]:
    """Returns what changes if the file does: notebooks replace a body model and measure again."""
    try:
        status = os.stat(path)
    except OSError as error:
        raise Error(f"{path}: {error.strerror}") from error
    return status.st_mtime_ns, status.st_size


@functools.lru_cache(maxsize=4)
def _loaded_body(path: str, version: Tuple[int, int]) -> Tuple[str, body_models.BodyModel]:
    return contents_hash(path) or "", body_models.load(path)


def _faces_inwards(body: body_models.BodyModel) -> bool:
    """Returns whether the mean shape has a negative volume. Holes are closed by cones to its middle."""
    corners = (body.template - body.template.mean(axis=0))[body.faces]
    return bool(np.linalg.det(corners).sum() < 0)


def _subject(path: str, betas: npt.NDArray[np.float64]) -> Subject:
    return _shaped_subject(path, _version(path), betas.tobytes())


@functools.lru_cache(maxsize=4)
def _shaped_subject(path: str, version: Tuple[int, int], betas: bytes) -> Subject:
    """Consecutive clips often are of the same one or two subjects."""
    body_hash, body = _loaded_body(path, version)
    try:
        return Subject(body.subject(np.frombuffer(betas)), body_hash)
    except Error as error:
        raise Error(f"{path}: {error}") from error
