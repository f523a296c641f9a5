"""Models."""

from __future__ import annotations

import re
from typing import Dict, Optional, Tuple

from pelt import _pelt
from pelt._arrays import Array, floats, integer, integers


def _in_python(message: str) -> str:
    """Returns a message of the library with the names of the arguments of `Model`."""
    for pattern, name in ((r"\brest_positions\b", "rest"), (r"\btriangles(?=\[| is )", "faces"),
                          (r"off_weights = OffWeights::renormalise", "renormalise=True")):
        message = re.sub(pattern, name, message)
    return message


class Model:
    """A skinned mesh with V vertices, T triangles and J joints, prepared for queries.

    rest:           [V, 3] rest positions, in model units.
    faces:          [T, 3] indices of vertices. Degenerate triangles are allowed.
    weights:        [V, J] weight of each joint; each row sums to 1. With `joints`: [V, K] weights of
                    K joints of each vertex. None: a mesh that moves as one piece, with one joint.
    joints:         [V, K] indices of the joints that `weights` belong to.
    joint_count:    J, only with `joints`; default: the largest index plus one.
    morph_targets:  [M, V, 3] displacements of the vertices at weight 1.
    offset_caps:    [V] largest offset of each vertex along each axis, in model units, for models that
                    are posed with `Poses(palettes, offsets=...)`. Small caps keep queries fast.
    renormalise:    divide weights by their sums, instead of raising an error if a sum differs from 1
                    by more than 2^-7.
    weld:           merge vertices that are equal in every bit, which makes queries faster. Pass False
                    if `Vertices` will move such vertices apart, as cloth may at its seams.
    sample_palettes:  [S, J, 4, 4] palettes of typical poses. With six, queries are up to 20 % faster,
                    and building takes three times as long. Answers do not depend on them.

    Numbers are rounded to float32. Triangles and vertices keep their indices. Building takes
    O(T log T). A model is immutable and can be used by several threads at once. It can be pickled.

    Raises `pelt.Error` that names the array and the element.
    """

    _empty_filter: Optional[_pelt.SelfFilter] = None
    _neighbours: Optional[object] = None
    """a SelfFilter, see `pelt._self_collide`"""

    def __init__(self, rest: Array, faces: Array, weights: Optional[Array] = None,
                 joints: Optional[Array] = None, *, joint_count: Optional[int] = None,
                 morph_targets: Optional[Array] = None, offset_caps: Optional[Array] = None,
                 renormalise: bool = False, weld: bool = True,
                 sample_palettes: Optional[Array] = None) -> None:
        if joints is not None and weights is None:
            raise _pelt.Error("joints: need weights")
        if joint_count is not None and joints is None:
            raise _pelt.Error("joint_count: needs joints")
        arguments = (
            floats("rest", rest), integers("faces", faces),
            None if weights is None else floats("weights", weights),
            None if joints is None else integers("joints", joints),
            None if joint_count is None else integer("joint_count", joint_count, 1, 65535),
            None if morph_targets is None else floats("morph_targets", morph_targets),
            None if offset_caps is None else floats("offset_caps", offset_caps),
            bool(renormalise), bool(weld),
            None if sample_palettes is None else floats("sample_palettes", sample_palettes))
        try:
            self._model = _pelt.Model(*arguments)
        except _pelt.Error as error:
            raise _pelt.Error(_in_python(str(error))) from None

    @classmethod
    def _of(cls, model: _pelt.Model) -> "Model":
        made = cls.__new__(cls)
        made._model = model
        return made

    @classmethod
    def from_bytes(cls, data: bytes) -> "Model":
        """Returns the model that `to_bytes` has saved, ten times as fast as building it."""
        return cls._of(_pelt.Model.from_bytes(bytes(data)))

    def to_bytes(self) -> bytes:
        """Returns the prepared model as bytes, as `pelt prepare` writes it. Later versions of Pelt
        may refuse them."""
        return self._model.to_bytes()

    def __reduce__(self) -> Tuple[object, Tuple[bytes]]:
        return Model.from_bytes, (self.to_bytes(),)

    @property
    def vertex_count(self) -> int:
        """V"""
        return self._model.vertex_count

    @property
    def triangle_count(self) -> int:
        """T"""
        return self._model.triangle_count

    @property
    def joint_count(self) -> int:
        """J, the number of matrices of a palette."""
        return self._model.joint_count

    @property
    def morph_target_count(self) -> int:
        """M"""
        return self._model.morph_target_count

    @property
    def memory_bytes(self) -> int:
        """Bytes of memory of the model."""
        return self._model.memory_bytes

    @property
    def report(self) -> Dict[str, int]:
        """Counts of defects of the mesh: `renormalised_vertices`, whose weights did not sum to 1;
        `merged_influences`, several weights of one joint at a vertex; `degenerate_triangles`."""
        return self._model.report

    @property
    def is_closed(self) -> bool:
        """Whether the surface is closed: each edge belongs to two triangles, which traverse it in
        opposite directions. Only closed surfaces have an inside."""
        return self._model.is_closed

    def __repr__(self) -> str:
        morphs = f", {self.morph_target_count} morph targets" if self.morph_target_count else ""
        return (f"<pelt.Model: {self.vertex_count} vertices, {self.triangle_count} triangles, "
                f"{self.joint_count} joints{morphs}>")
