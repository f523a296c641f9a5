"""Tables of measurements that survive their process."""

from __future__ import annotations

import contextlib
import csv
import io
import itertools
import os
import shutil
from typing import Iterable, List, Sequence, Set, Union

from pelt._npz import Path
from pelt._pelt import Error
from pelt.datasets._clips import Pair
from pelt.datasets._measurement import Measurement
from pelt.datasets._pairs import PairMeasurement
from pelt.datasets._subjects import Row

try:
    import fcntl
except ImportError:  # not on Windows: there, tables are not locked
    fcntl = None  # type: ignore[assignment]


class Table:
    """A CSV file that grows by one row for each clip or pair of clips. Each row is written at once, so a
    process that is killed loses at most the one that it was measuring.

    path:     of the file. If it exists, the table goes on where it ended.
    measure:  what the rows contain. Raises `pelt.Error` if the file has rows of another measurement.

    done:     clips or pairs that the table has.
    changed:  clips or pairs whose files have other arrays than when their rows were written. Their rows
              are no longer in the table.
    copy:     path of a copy of the table before the rows of `changed` were removed; "" if nothing has
              changed.
    hashes:   whether the rows have hashes of files. Tables of early versions do not, so changes of their
              clips go unnoticed.

    Only one process at a time can write a table.
    """

    def __init__(self, path: Path, measure: Union[Measurement, PairMeasurement]) -> None:
        self.path = os.fspath(path)
        self.done: Set[Union[str, Pair]] = set()
        self.changed: List[Union[str, Pair]] = []
        self.copy = ""
        self.hashes = True
        self._measure = measure
        self._columns = measure.columns
        self._open()
        try:
            self._resume()
        except BaseException:
            self._file.close()
            raise

    def append(self, row: Row) -> None:
        """Writes a row. Raises `pelt.Error` if it is of another measurement."""
        if not self._measure.has_made({column: str(value) for column, value in row.items()}):
            raise Error(f"{self.path}: the row of {self._measure.item_of(row)} is of another measurement "
                        "(other body models, options or frames, or a body model whose file has changed)")
        self._write([row[column] for column in self._columns])
        self.done.add(self._measure.item_of(row))

    def __enter__(self) -> "Table":
        return self

    def __exit__(self, *_: object) -> None:
        self._file.close()

    def _open(self) -> None:
        try:
            self._file = open(self.path, "a+b", buffering=0)
        except OSError as error:
            raise Error(f"{self.path}: {error.strerror}") from error
        try:
            self._lock()
        except BaseException:
            self._file.close()
            raise

    def _lock(self) -> None:
        if fcntl is None:
            return
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            # Another process may have replaced the table since it was opened.
            is_table = os.path.samestat(os.fstat(self._file.fileno()), os.stat(self.path))
        except (BlockingIOError, FileNotFoundError):
            is_table = False
        if not is_table:
            raise Error(f"{self.path}: another process is writing this table")

    def _resume(self) -> None:
        self._file.seek(0)
        content = self._file.read()
        whole = content.rfind(b"\n") + 1  # what follows is a row of a process that was killed
        self._file.truncate(whole)
        text = content[:whole].decode("utf-8", "surrogateescape")
        rows = list(csv.reader(io.StringIO(text, newline="")))
        if not rows:
            self._write(self._columns)
            return
        self._read_header(rows[0])
        current = [values for number, values in enumerate(rows[1:], 2) if self._is_current(number, values)]
        if self.changed:
            self._replace(content[:whole], [self._columns, *current])

    def _read_header(self, names: List[str]) -> None:
        columns = list(self._columns)
        if names == [name for name in columns if name not in self._measure.hash_columns]:
            self.hashes = False
            self._columns = tuple(names)
        elif names != columns:
            raise Error(f"{self.path}: has other columns than this measurement: choose another file")

    def _is_current(self, number: int, values: List[str]) -> bool:
        """Adds a row to what is done, or to what has changed."""
        row = dict(zip(self._columns, values))
        if len(values) != len(self._columns) or not self._measure.has_made(row):
            raise Error(f"{self.path}: row {number} is of another measurement (other body models, "
                        "options or frames, or a body model whose file has changed): choose another file")
        item = self._measure.item_of(row)
        if self._measure.has_changed(row):
            self.changed.append(item)
            return False
        self.done.add(item)
        return True

    def _replace(self, content: bytes, rows: Iterable[Sequence[object]]) -> None:
        """Replaces the table at once, so that a process that is killed loses no rows.

        content:  of the table so far, for `copy`.
        """
        path = os.path.realpath(self.path)
        copy, new = _unused_name(path + ".old"), _unused_name(path + ".new")
        made: List[str] = []
        try:
            for name, data in ((copy, content), (new, b"".join(map(_line, rows)))):
                with open(name, "xb") as file:
                    made.append(name)
                    shutil.copymode(path, name)
                    file.write(data)
                    file.flush()
                    os.fsync(file.fileno())
            old = self._file
            if fcntl is None:
                old.close()  # Windows replaces no file that is open
            os.replace(new, path)
        except OSError as error:
            for name in made:
                with contextlib.suppress(OSError):
                    os.remove(name)
            raise Error(f"{self.path}: the rows of changed clips cannot be removed: {error.strerror}: make "
                        "room in its folder, allow writing there, or choose another file") from error
        self.copy = copy
        try:
            self._open()
        finally:
            old.close()

    def _write(self, values: Sequence[object]) -> None:
        self._file.write(_line(values))
        os.fsync(self._file.fileno())


def _unused_name(start: str) -> str:
    names = (f"{start}-{number}" for number in itertools.count(1))
    return next(name for name in names if not os.path.lexists(name))


def _line(values: Sequence[object]) -> bytes:
    text = io.StringIO(newline="")
    csv.writer(text, lineterminator="\n").writerow(values)
    return text.getvalue().encode("utf-8", "surrogateescape")
