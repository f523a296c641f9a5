"""`python -m pelt metrics`: a table of metrics of all clips of a folder."""

import argparse
import csv
import os
import sys
import time
from typing import Dict, List, Optional, TextIO, Tuple

from pelt._pelt import Error, __version__
from pelt.datasets import METRICS, Measurement, Table, find_clips

_SECONDS_BETWEEN_LINES = 60

_HELP = """Pelt finds which triangles of skinned characters touch.

commands:
  metrics   a table of metrics, with one row for each clip of a folder

`python -m pelt metrics --help` explains the options. `python -c "import pelt; help(pelt)"` explains
the functions of the package.
"""

_METRICS_HELP = """Measures how the bodies in motion files touch themselves, and writes a table with one
row for each clip.

example:
  python -m pelt metrics AMASS --body-model male=SMPLH_MALE.npz \\
      --body-model female=SMPLH_FEMALE.npz --out table.csv

The folder contains motions of AMASS (.npz), in subfolders of any depth. Body models are .npz files of the
SMPL family; those of SMPL-H fit motions with 52 joints, those of SMPL-X motions with 55.

A run that is stopped goes on where it ended if it is started again: rows that are in the table are not
measured again. Files that cannot be read are listed at the end, with the reason, and are tried again by
the next run.

metrics:
"""

_AFTER_HELP = """
columns: clip, body_model, options, every, frames, seconds, fps, gender; for each metric its mean over the frames,
its max, and the frame of the max; volume_error, a bound of the error of each volume. `volume` takes
about ten times as long as the other metrics together.

exit status: 0 if all clips are in the table, 1 if some could not be measured, 2 for invalid arguments.
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
    names = "\n".join(f"  {name:10} {what}" for name, what in METRICS.items())
    parser = commands.add_parser("metrics", description=_METRICS_HELP + names, epilog=_AFTER_HELP,
                                 formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    add("folder", metavar="DIR", help="folder with motions")
    add("--body-model", metavar="[GENDER=]FILE", action="append", required=True,
        help="body model of all subjects, or of those of a gender; may be given several times")
    add("--out", metavar="FILE", required=True, help="the table, a CSV file")
    add("--failed", metavar="FILE",
        help="writes the clips that this run could not measure, and the reasons, to a CSV file")
    add("--metrics", metavar="NAMES", default=",".join(METRICS),
        help="metrics to measure, with commas between them (default: all)")
    add("--every", metavar="N", type=int, default=1, help="measure every Nth frame (default: 1)")
    add("--body-only", action="store_true",
        help="ignore the rotations of hands and face; motions then fit body models of all kinds")
    add("--betas", metavar="N", type=int, default=None,
        help="use only the first N shape parameters of each motion, for body models that have fewer "
             "than the motions; 0 is the mean shape")
    add("--shard", metavar="I/N", type=_shard, default=(1, 1),
        help="measure only the I-th of N parts of the clips, for N processes or machines, each with "
             "its own table")
    add("--threads", metavar="N", type=int, default=None, help="threads (default: all processors)")


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


def _measure_folder(options: argparse.Namespace) -> int:
    part, count = options.shard
    clips = find_clips(options.folder)[part - 1::count]
    measure = Measurement(options.folder, _body_models(options.body_model),
                          [name for name in options.metrics.split(",") if name],
                          every=options.every, body_only=options.body_only, betas=options.betas,
                          threads=options.threads)
    with Table(options.out, measure) as table, _Failures(options.failed) as failed:
        before = len(table.done)
        progress = _Progress(len(clips))
        for number, clip in enumerate(clips):
            progress.show(number, len(failed), clip)
            if clip in table.done:
                continue
            try:
                table.append(measure(clip))
            except (Error, OSError, MemoryError) as error:
                failed.append(clip, f"{error}" if isinstance(error, Error) else f"{clip}: {error!r}")
        progress.show(len(clips), len(failed), "")
        _print_summary(options.out, len(table.done) - before, before, failed.reasons)
    return 1 if failed.reasons else 0


class _Failures:
    """Clips that could not be measured. Each row of the file is written at once."""

    def __init__(self, path: Optional[str]) -> None:
        self.reasons: List[str] = []
        self._file: Optional[TextIO] = None
        if path is None:
            return
        try:
            self._file = open(path, "w", newline="", encoding="utf-8", errors="surrogateescape")
        except OSError as error:
            raise Error(f"{path}: {error.strerror}") from error
        self._write("clip", "reason")

    def append(self, clip: str, reason: str) -> None:
        self.reasons.append(reason)
        self._write(clip, reason)

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

    def __init__(self, count: int) -> None:
        self._count = count
        self._last = time.monotonic()

    def show(self, done: int, failed: int, clip: str) -> None:
        text = f"{done} of {self._count} clips, {failed} failed  {clip}"
        if sys.stderr.isatty():
            end = "" if done < self._count else "\n"
            print(f"\r{text[:99]:99}", end=end, file=sys.stderr, flush=True)
        elif time.monotonic() >= self._last + _SECONDS_BETWEEN_LINES:
            self._last = time.monotonic()
            print(text, file=sys.stderr, flush=True)


def _print_summary(path: str, measured: int, before: int, failed: List[str]) -> None:
    earlier = f", {before} were there before" if before else ""
    print(f"{path}: {measured} clips measured{earlier}, {len(failed)} failed")
    for reason in failed:
        print(f"failed: {reason}", file=sys.stderr)
