"""Arrays of `.npz` files from strangers: nothing is unpickled, and sizes are checked before reading."""

from __future__ import annotations

import math
import os
import tokenize
import zipfile
import zlib
from types import TracebackType
from typing import IO, Any, Dict, List, Optional, Tuple, Type, Union

import numpy as np
import numpy.typing as npt

from pelt._pelt import Error

Path = Union[str, "os.PathLike[str]"]
Axis = Union[int, str]
"""The size of an axis, or a name for any size."""

_MAX_ENTRIES = 1000
_MAX_BYTES = 2**30
LARGEST = 2.0**60
"""Largest coordinate that Pelt accepts. Its numbers are float32, whose products must not overflow."""

_UNREADABLE = (OSError, EOFError, ValueError, SyntaxError, KeyError, TypeError, OverflowError,
               MemoryError, RecursionError, NotImplementedError, RuntimeError, tokenize.TokenError,
               zipfile.BadZipFile, zlib.error)


class Npz:
    """An open `.npz` file. Every error names the file, and the key that is at fault."""

    def __init__(self, path: Path) -> None:
        self.path = os.fspath(path)
        self._bytes_read = 0
        try:
            self._zip = zipfile.ZipFile(self.path)
        except OSError as error:
            raise Error(f"{self.path}: cannot be opened: {error.strerror or error}") from error
        except _UNREADABLE as error:
            raise Error(f"{self.path}: not a complete .npz file: {error}") from error
        names = self._zip.namelist()
        if len(names) > _MAX_ENTRIES:
            self._zip.close()
            raise Error(f"{self.path}: has {len(names)} arrays (at most {_MAX_ENTRIES})")
        self.keys: List[str] = [name[:-4] for name in names if name.endswith(".npy")]

    def __enter__(self) -> "Npz":
        return self

    def __exit__(self, kind: Optional[Type[BaseException]], error: Optional[BaseException],
                 trace: Optional[TracebackType]) -> None:
        self._zip.close()

    def error(self, key: str, what: str) -> Error:
        """Returns an error that names the file and the key."""
        return Error(f"{self.path}: {key}: {what}")

    def floats(self, key: str, shape: Tuple[Axis, ...],
               sizes: Optional[Dict[str, int]] = None) -> npt.NDArray[np.float64]:
        """Returns an array of finite numbers, at most `LARGEST` in magnitude.

        shape:  expected sizes; names stand for sizes in `sizes`, or for any size, which is then
                added to `sizes`.
        """
        array = self._array(key, "iuf", shape, sizes)
        result = array.astype(np.float64)
        # The comparison is false for NaN, too.
        if result.size and not (-LARGEST <= result.min() and result.max() <= LARGEST):
            first = np.argwhere(~(np.abs(result) <= LARGEST))[0]
            value = result[tuple(first)]
            what = f"{value:g}, expected within 2^60" if np.isfinite(value) else "not a finite number"
            raise self.error(key, f"the element {first.tolist()} is {what}: save the file again with "
                                  "correct numbers")
        return result

    def integers(self, key: str, shape: Tuple[Axis, ...],
                 sizes: Optional[Dict[str, int]] = None) -> npt.NDArray[np.int64]:
        """Returns an array of integers. Arguments: see `floats`."""
        return self._array(key, "iu", shape, sizes).astype(np.int64)

    def text(self, key: str) -> Optional[str]:
        """Returns a text, or None if the key is absent or no text."""
        if key not in self.keys:
            return None
        with self._open(key) as stream:
            _, _, dtype = self._header(key, stream)
        if dtype.kind not in "US" or dtype.itemsize > 1024:
            return None
        value = self._read(key).reshape(-1)[:1].tolist()
        return (value[0].decode("latin1") if isinstance(value[0], bytes) else value[0]) if value else None

    def axes(self, key: str) -> int:
        """Returns the number of axes of an array."""
        with self._open(key) as stream:
            return len(self._header(key, stream)[0])

    def _array(self, key: str, kinds: str, shape: Tuple[Axis, ...],
               sizes: Optional[Dict[str, int]]) -> npt.NDArray[Any]:
        if key not in self.keys:
            raise self.error(key, f"missing (the file has {', '.join(sorted(self.keys)) or 'no arrays'})")
        with self._open(key) as stream:
            found, _, dtype = self._header(key, stream)
        if dtype.kind == "O":
            raise self.error(key, "holds pickled Python objects, which are never loaded. "
                                  "Save it again as an array of numbers")
        self._check_shape(key, found, shape, {} if sizes is None else sizes)
        if dtype.kind not in kinds:
            raise self.error(key, f"expected {'integers' if kinds == 'iu' else 'numbers'}, found {dtype}")
        return self._read(key)

    def _check_shape(self, key: str, found: Tuple[int, ...], shape: Tuple[Axis, ...],
                     sizes: Dict[str, int]) -> None:
        expected = [sizes.get(axis, axis) if isinstance(axis, str) else axis for axis in shape]
        fits = len(found) == len(shape) and all(
            isinstance(axis, str) or axis == size for axis, size in zip(expected, found))
        if not fits:
            text = ", ".join(str(axis) for axis in expected)
            raise self.error(key, f"expected the shape [{text}], found {list(found)}")
        sizes.update((axis, size) for axis, size in zip(expected, found) if isinstance(axis, str))

    def _open(self, key: str) -> IO[bytes]:
        try:
            return self._zip.open(key + ".npy")
        except _UNREADABLE as error:
            raise self.error(key, f"cannot be read: {error}") from error

    def _header(self, key: str,
                stream: IO[bytes]) -> Tuple[Tuple[int, ...], bool, "np.dtype[Any]"]:
        """Reads the header of an array: shape, whether in Fortran's order, type."""
        try:
            header: Tuple[Tuple[int, ...], bool, "np.dtype[Any]"]
            version = np.lib.format.read_magic(stream)
            if version == (1, 0):
                header = np.lib.format.read_array_header_1_0(stream)
            elif version == (2, 0):
                header = np.lib.format.read_array_header_2_0(stream)
            else:
                raise ValueError(f"version {version} of the format")
            if min(header[0], default=0) < 0:
                raise ValueError(f"the shape is {list(header[0])}")
        except _UNREADABLE as error:
            raise self.error(key, f"not an array of NumPy: {error}") from error
        return header

    def _read(self, key: str) -> npt.NDArray[Any]:
        with self._open(key) as stream:
            shape, fortran, dtype = self._header(key, stream)
            size = math.prod(shape) * dtype.itemsize
            self._check_size(key, size, math.prod(shape) * max(dtype.itemsize, 8))
            try:
                data = stream.read(size)
            except _UNREADABLE as error:
                raise self.error(key, f"cannot be read: {error}") from error
        if len(data) != size:
            raise self.error(key, f"is cut off: {size} bytes expected, {len(data)} found")
        return np.frombuffer(data, dtype).reshape(shape, order="F" if fortran else "C")

    def _check_size(self, key: str, size: int, converted: int) -> None:
        """Numbers become float64 or int64, so few bytes of small numbers can need much memory."""
        stored = self._zip.getinfo(key + ".npy").file_size
        if size > stored:
            raise self.error(key, f"is cut off: {size} bytes expected, {stored} stored")
        self._bytes_read += converted
        if self._bytes_read > _MAX_BYTES:
            raise self.error(key, f"the arrays need more than {_MAX_BYTES} bytes of memory")


def refuse_pickle(path: Path, keys: str) -> None:
    """Raises an error that says how to convert a `.pkl` file."""
    name = os.fspath(path)
    if not name.lower().endswith((".pkl", ".pickle")):
        return
    target = os.path.splitext(name)[0] + ".npz"
    raise Error(
        f"{name}: pickled files can run any code, so Pelt does not read them. Convert it once, where "
        f"you trust it (the files of SMPL need the package chumpy):\n"
        f"import pickle, numpy\n"
        f"data = pickle.load(open({name!r}, 'rb'), encoding='latin1')\n"
        f"dense = lambda value: value.toarray() if hasattr(value, 'toarray') else numpy.array(value)\n"
        f"numpy.savez({target!r}, **{{key: dense(data[key]) for key in {keys!r}.split()}})")
