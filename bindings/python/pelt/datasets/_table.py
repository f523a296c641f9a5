"""Tables of measurements that survive their process."""

from __future__ import annotations

import csv
import io
import os
from typing import Sequence, Set, Union

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

    Only one process at a time can write a table.
    """

    def __init__(self, path: Path, measure: Union[Measurement, PairMeasurement]) -> None:
        self.path = os.fspath(path)
        self.done: Set[Union[str, Pair]] = set()
        self._measure = measure
        self._columns = measure.columns
        try:
            self._file = open(self.path, "a+b", buffering=0)
        except OSError as error:
            raise Error(f"{self.path}: {error.strerror}") from error
        try:
            self._lock()
            self._resume()
        except BaseException:
            self._file.close()
            raise

    def append(self, row: Row) -> None:
        """Writes a row. Raises `pelt.Error` if it is of another measurement."""
        if not self._measure.has_made({column: str(value) for column, value in row.items()}):
            raise Error(f"{self.path}: the row of {self._measure.item_of(row)} is of another measurement "
                        "(other body models, options or frames)")
        self._write([row[column] for column in self._columns])
        self.done.add(self._measure.item_of(row))

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

    def _resume(self) -> None:
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
        for number, values in enumerate(rows[1:], 2):
            row = dict(zip(self._columns, values))
            if len(values) != len(self._columns) or not self._measure.has_made(row):
                raise Error(f"{self.path}: row {number} is of another measurement (other body models, "
                            f"options or frames): choose another file")
            self.done.add(self._measure.item_of(row))

    def _write(self, values: Sequence[object]) -> None:
        text = io.StringIO(newline="")
        csv.writer(text, lineterminator="\n").writerow(values)
        data = text.getvalue().encode("utf-8", "surrogateescape")
        self._file.write(data)
        os.fsync(self._file.fileno())
