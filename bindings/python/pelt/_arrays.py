"""Arguments as NumPy arrays."""

from __future__ import annotations

import operator
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from pelt._pelt import Error

Array = Union[npt.ArrayLike, Any]
"""A NumPy array, nested lists, or an object with `__dlpack__` in the memory of the CPU."""

Floats = npt.NDArray[np.floating[Any]]
Integers = npt.NDArray[np.int64]


def _array(name: str, value: Array) -> npt.NDArray[Any]:
    """Returns the value as an array, without a copy if possible."""
    if isinstance(value, np.ma.MaskedArray) and np.ma.is_masked(value):
        raise Error(f"{name}: has masked elements, which would be read as if they were not masked")
    try:
        if hasattr(value, "__dlpack__") and not isinstance(value, np.ndarray):
            array: npt.NDArray[Any] = np.from_dlpack(value)  # type: ignore[arg-type]
            return array
        return np.asarray(value)
    except MemoryError:
        raise
    except Exception as error:
        raise Error(f"{name}: cannot be read as an array: {error}") from error


def floats(name: str, value: Array) -> Floats:
    """Returns the value as float32 or float64. Other numbers are converted to float64."""
    array = _array(name, value)
    if array.dtype == np.float32 or array.dtype == np.float64:
        return array if array.dtype.isnative else array.astype(array.dtype.newbyteorder("="))
    if array.dtype.kind in "iuf":
        return array.astype(np.float64)
    raise Error(f"{name}: expected float32 or float64, found {array.dtype}")


def integers(name: str, value: Array) -> Integers:
    """Returns the value as int64, without gaps. Numbers that do not fit become negative."""
    array = _array(name, value)
    if array.size == 0:
        return np.zeros(array.shape, np.int64)
    if array.dtype.kind in "iub":
        return np.ascontiguousarray(array, dtype=np.int64)
    raise Error(f"{name}: expected integers, found {array.dtype}")


def number(name: str, value: Any) -> float:
    """Returns the value as a float, which may be NaN."""
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError) as error:
        raise Error(f"{name}: expected a number, found {value!r}") from error


def integer(name: str, value: Any, least: int, most: int) -> int:
    """Returns the value as an integer in this range."""
    try:
        found = operator.index(value)
    except TypeError as error:
        raise Error(f"{name}: expected an integer, found {value!r}") from error
    if isinstance(value, bool) or not least <= found <= most:
        raise Error(f"{name}: expected {least} to {most}, found {value!r}")
    return found


def with_axes(name: str, array: Floats, axes: int) -> Floats:
    """Returns the array with a first axis of one frame if that axis is absent."""
    if array.ndim == axes - 1:
        return array[np.newaxis]
    if array.ndim == axes:
        return array
    raise Error(f"{name}: expected {axes} axes, or {axes - 1} for one frame, "
                f"found the shape {list(array.shape)}")
