"""`python -m pelt metrics`: a table of metrics of all clips of a folder."""

from __future__ import annotations

import argparse
import csv
import os
import sys
import time
from typing import Dict, List, Mapping, Optional, Sequence, TextIO, Tuple, Type, Union

from pelt._pelt import Error, __version__
from pelt.datasets import (METRICS, PAIR_METRICS, Measurement, Pair, PairMeasurement, Table,
                           find_clips, find_pairs, read_pairs)

Item = Union[str, Pair]
"""What a row is about: a clip, or a pair of clips."""

_SECONDS_BETWEEN_LINES = 60

_HELP = """Pelt finds which triangles of skinned characters touch.

commands:
  metrics   a table of metrics, with one row for each clip of a folder

`python -m pelt metrics --help` explains the options. `python -c "import pelt; help(pelt)"` explains
the functions of the package.
"""

_METRICS_HELP = """Measures how the bodies in motion files touch themselves, or how two bodies touch each
other, and writes a table with one row for each clip or pair of clips.

examples:
  python -m pelt metrics AMASS --body-model male=SMPLH_MALE.npz \\
      --body-model female=SMPLH_FEMALE.npz --out table.csv
  python -m pelt metrics Inter-X --pair-words P1,P2 --fps 120 --close-holes \\
      --body-model SMPLX_NEUTRAL.npz --out pairs.csv

The folder contains motions of AMASS or Inter-X (.npz), in subfolders of any depth. Body models are .npz
files of the SMPL family; those of SMPL-H fit motions with 52 joints, those of SMPL-X motions with 55.

A run that is stopped goes on where it ended if it is started again: rows that are in the table are not
measured again, unless the arrays in the file of the clip have changed since. Files that cannot be read are
listed at the end, with the reason, and are tried again by the next run.

"""

_AFTER_HELP = """
columns: clip, body_model, options, every, frames (that were measured), seconds and fps (of the file),
gender; for each metric its mean over the measured frames, its max, and the frame of the max, counted in the
frames of the file from 0; volume_error, a bound of the error of each volume; clip_hash and body_model_hash,
which identify the arrays in the files. `contact` takes longer than the other metrics of a clip together.
Tables of pairs have the columns clip_a, clip_b, body_model_a, body_model_b, gender_a, gender_b and four
hashes, and for each metric also the percentage of frames in which it is not 0.

exit status: 0 if all rows are in the table, 1 if some could not be measured, 2 for invalid arguments.
"""


def main(arguments: Optional[List[str]] = None) -> int:
    """Runs the command, and returns its exit status."""
    parser = argparse.ArgumentParser(prog="python -m pelt", description=_HELP,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--version", action="version", version=f"pelt {__version__}")
    _add_metrics(parser.add_subparsers(dest="command", metavar="COMMAND", help=argparse.SUPPRESS))
    options = parser.parse_args(arguments)
    if options.command is None:
        parser.print_help()
        return 2
    try:
        return _measure_folder(options)
    except Error as error:
        print(f"pelt metrics: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("\nstopped; the same command goes on where this run has ended", file=sys.stderr)
        return 130


def _add_metrics(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    names = _list_of("metrics of a clip", METRICS) + _list_of("\nmetrics of a pair", PAIR_METRICS)
    parser = commands.add_parser("metrics", description=_METRICS_HELP + names, epilog=_AFTER_HELP,
                                 formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    add("folder", metavar="DIR", help="folder with motions")
    add("--body-model", metavar="[GENDER=]FILE", action="append", required=True,
        help="body model of all subjects, or of those of a gender; may be given several times")
    pairs = parser.add_mutually_exclusive_group()
    pairs.add_argument("--pairs", metavar="FILE",
                       help="measure the pairs of clips that a CSV file lists, in the columns clip_a and "
                            "clip_b or in its only two columns, relative to the folder")
    pairs.add_argument("--pair-words", metavar="A,B", type=_words,
                       help="measure the pairs of clips whose paths differ in one word: P1,P2 for "
                            "a/P1.npz and a/P2.npz")
    add("--out", metavar="FILE", required=True, help="the table, a CSV file")
    add("--failed", metavar="FILE",
        help="writes the clips or pairs that this run could not measure, and the reasons, to a CSV file")
    add("--metrics", metavar="NAMES", default=None,
        help="metrics to measure, with commas between them (default: all)")
    add("--every", metavar="N", type=int, default=1, help="measure every Nth frame (default: 1)")
    add("--body-only", action="store_true",
        help="ignore the rotations of hands and face; motions then fit body models of all kinds")
    add("--betas", metavar="N", type=int, default=None,
        help="use only the first N shape parameters of each motion, for body models that have fewer "
             "than the motions; 0 is the mean shape")
    add("--close-holes", action="store_true",
        help="close the holes of open bodies such as SMPL-X by fans; without, metrics that need an inside "
             "are empty for them")
    add("--fps", metavar="N", type=float, default=None,
        help="frames per second of motions whose files state none; one of the two if a file states two")
    add("--shard", metavar="I/N", type=_shard, default=(1, 1),
        help="measure only the I-th of N parts of the clips, for N processes or machines, each with "
             "its own table")
    add("--threads", metavar="N", type=int, default=None, help="threads (default: all processors)")


def _list_of(title: str, names: Mapping[str, str]) -> str:
    return f"{title}:\n" + "".join(f"  {name:12} {what}\n" for name, what in names.items())


def _words(text: str) -> Tuple[str, str]:
    first, comma, second = text.partition(",")
    if not (comma and first and second) or first == second or "," in second:
        raise argparse.ArgumentTypeError(f"expected two words, such as P1,P2, found {text!r}")
    return first, second


def _shard(text: str) -> Tuple[int, int]:
    part, slash, count = text.partition("/")
    if not (slash and part.isdecimal() and count.isdecimal() and 1 <= int(part) <= int(count)):
        raise argparse.ArgumentTypeError(f"expected I/N with I from 1 to N, such as 1/4, found {text!r}")
    return int(part), int(count)


def _body_models(given: List[str]) -> Dict[str, str]:
    paths: Dict[str, str] = {}
    for text in given:
        gender, equals, path = text.partition("=")
        if not equals or os.path.exists(text):
            gender, path = "", text
        if gender in paths:
            raise Error(f"--body-model: given twice for {gender or 'all subjects'}")
        if not os.path.isfile(path):
            raise Error(f"--body-model: no file {path}")
        paths[gender] = path
    return paths


def _items(options: argparse.Namespace) -> Sequence[Item]:
    """Returns the clips or the pairs of clips of the folder."""
    if options.pairs is not None:
        return read_pairs(options.pairs)
    if options.pair_words is not None:
        return find_pairs(options.folder, *options.pair_words)
    return find_clips(options.folder)


def _measurement(options: argparse.Namespace) -> Union[Measurement, PairMeasurement]:
    is_of_pairs = options.pairs is not None or options.pair_words is not None
    kind: Union[Type[Measurement], Type[PairMeasurement]] = (
        PairMeasurement if is_of_pairs else Measurement)
    names = list(PAIR_METRICS if is_of_pairs else METRICS)
    if options.metrics is not None:
        names = [name for name in options.metrics.split(",") if name]
    return kind(options.folder, _body_models(options.body_model), names, every=options.every,
                body_only=options.body_only, betas=options.betas, close_holes=options.close_holes,
                fps=options.fps, threads=options.threads)


def _measure_folder(options: argparse.Namespace) -> int:
    if not os.path.isdir(options.folder):
        raise Error(f"{options.folder}: not a folder")
    part, count = options.shard
    items = _items(options)[part - 1::count]
    measure = _measurement(options)
    noun = "clips" if isinstance(measure, Measurement) else "pairs"
    undefined = measure.undefined_metrics()
    if undefined:
        print(f"a body model has holes, so its columns of {', '.join(undefined)} stay empty: close them "
              "with `--close-holes`", file=sys.stderr, flush=True)
    with Table(options.out, measure) as table:
        _warn_of_changes(table)  # before anything can fail: the next run finds no changed rows
        with _Failures(options.failed, noun) as failed:
            _measure_items(items, measure, table, failed)
    return 1 if failed.reasons else 0


def _measure_items(items: Sequence[Item], measure: Union[Measurement, PairMeasurement], table: Table,
                   failed: "_Failures") -> None:
    before = len(table.done)
    progress = _Progress(len(items), failed.noun)
    for number, item in enumerate(items):
        progress.show(number, len(failed), _name_of(item))
        if item in table.done:
            continue
        try:
            table.append(measure(item))  # type: ignore[arg-type]
        except (Error, OSError, MemoryError) as error:
            failed.append(item, f"{error}" if isinstance(error, Error)
                          else f"{_name_of(item)}: {error!r}")
    progress.show(len(items), len(failed), "")
    _print_summary(table.path, failed.noun, len(table.done) - before, before, failed.reasons)


def _warn_of_changes(table: Table) -> None:
    """Says which clips have changed, or that it is unknown."""
    if table.changed:
        more = f" and {len(table.changed) - 1} more" if len(table.changed) > 1 else ""
        print(f"warning: {_name_of(table.changed[0])}{more}: changed since measured, so the rows are "
              f"removed, and those of this run are measured again. {table.copy} has the earlier rows",
              file=sys.stderr, flush=True)
    if not table.hashes:
        print(f"warning: {table.path}: of an earlier version, without hashes of files, so clips and body "
              "models that have changed since go unnoticed. If any have, measure into another table",
              file=sys.stderr, flush=True)


def _name_of(item: Item) -> str:
    return item if isinstance(item, str) else " and ".join(item)


class _Failures:
    """Clips or pairs that could not be measured. Each row of the file is written at once."""

    def __init__(self, path: Optional[str], noun: str) -> None:
        self.noun = noun
        self.reasons: List[str] = []
        self._file: Optional[TextIO] = None
        if path is None:
            return
        try:
            self._file = open(path, "w", newline="", encoding="utf-8", errors="surrogateescape")
        except OSError as error:
            raise Error(f"{path}: {error.strerror}") from error
        self._write(*(("clip",) if noun == "clips" else ("clip_a", "clip_b")), "reason")

    def append(self, item: Item, reason: str) -> None:
        self.reasons.append(reason)
        self._write(*((item,) if isinstance(item, str) else item), reason)

    def _write(self, *values: str) -> None:
        if self._file is not None:
            csv.writer(self._file, lineterminator="\n").writerow(values)
            self._file.flush()

    def __len__(self) -> int:
        return len(self.reasons)

    def __enter__(self) -> "_Failures":
        return self

    def __exit__(self, *_: object) -> None:
        if self._file is not None:
            self._file.close()


class _Progress:
    """A line that is overwritten on a terminal; in the log of a cluster, one more line each minute."""

    def __init__(self, count: int, noun: str) -> None:
        self._count = count
        self._noun = noun
        self._last = time.monotonic()

    def show(self, done: int, failed: int, name: str) -> None:
        text = f"{done} of {self._count} {self._noun}, {failed} failed  {name}"
        if sys.stderr.isatty():
            end = "" if done < self._count else "\n"
            print(f"\r{text[:99]:99}", end=end, file=sys.stderr, flush=True)
        elif time.monotonic() >= self._last + _SECONDS_BETWEEN_LINES:
            self._last = time.monotonic()
            print(text, file=sys.stderr, flush=True)


def _print_summary(path: str, noun: str, measured: int, before: int, failed: List[str]) -> None:
    earlier = f", {before} were there before" if before else ""
    print(f"{path}: {measured} {noun} measured{earlier}, {len(failed)} failed")
    for reason in failed:
        print(f"failed: {reason}", file=sys.stderr)
