#!/usr/bin/env python3
"""crowd_growth_test.py CROWD_SCALING PLOT: measures small crowds and plots their growth.

Exits with 77, like PLOT, if gnuplot is missing and everything else passes.
"""

import csv
import pathlib
import subprocess
import sys
import tempfile

crowd_scaling, plot = sys.argv[1:]


def run(*words):
    return subprocess.run(words, capture_output=True, text=True)


def check_table(printed, rows):
    assert [(r["instances"], r["threads"]) for r in rows] == [
        ("100", "1"), ("100", "2"), ("300", "1"), ("300", "2")], rows
    assert printed.splitlines()[1:] == [",".join(row.values()) for row in rows], printed
    for one, two in zip(rows[::2], rows[1::2]):
        for column in ("triangles", "candidate_pairs", "touching_pairs", "contacts"):
            assert one[column] == two[column], f"{column} depends on threads"
        assert 0 < int(one["touching_pairs"]) < int(one["candidate_pairs"])
        assert int(one["contacts"]) > int(one["touching_pairs"])
    for row in rows:
        assert 0 < float(row["palettes_ms"]) < float(row["frame_ms"])
        assert 0 < float(row["crowd_mb"]) < float(row["process_mb"])


def check_picture(table, picture):
    drawn = run(plot, table, picture)
    if drawn.returncode == 77:
        assert "gnuplot is missing" in drawn.stderr
        sys.exit(77)
    assert drawn.returncode == 0, drawn.stderr
    text = picture.read_text()
    for words in ("<svg", "instances", "milliseconds a frame", "megabytes", "2 threads"):
        assert words in text, words
    assert run(plot, picture, picture).returncode == 2, "a picture is no table"
    assert run(plot, table.with_name("none"), picture).returncode == 2


with tempfile.TemporaryDirectory() as folder:
    table = pathlib.Path(folder) / "table.csv"
    measured = run(crowd_scaling, "--most", "300", "--runs", "1", "--csv", table)
    assert measured.returncode == 0, measured.stderr
    with table.open() as file:
        check_table(measured.stdout, list(csv.DictReader(file)))
    refused = run(crowd_scaling, "none.glb")
    assert refused.returncode == 1 and "none.glb" in refused.stderr, refused.stderr
    check_picture(table, pathlib.Path(folder) / "picture.svg")
