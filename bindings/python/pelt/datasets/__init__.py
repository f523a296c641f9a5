"""Metrics of many clips: a table with one row for each clip, or for each pair of clips.

    from pelt import datasets

    measure = datasets.Measurement("AMASS", {"male": "SMPLH_MALE.npz", "female": "SMPLH_FEMALE.npz"})
    with datasets.Table("table.csv", measure) as table:
        for clip in datasets.find_clips("AMASS"):
            if clip not in table.done:
                table.append(measure(clip))

Two people whose motions are in one frame of reference are a pair:

    measure = datasets.PairMeasurement("Inter-X", "SMPLX_NEUTRAL.npz", close_holes=True, fps=120)
    with datasets.Table("pairs.csv", measure) as table:
        for pair in datasets.find_pairs("Inter-X", "P1", "P2"):
            if pair not in table.done:
                table.append(measure(pair))

`python -m pelt metrics` does this, goes on after files that cannot be read, and lists them.
Measurements can be pickled, so that other processes and machines can measure clips.
"""

from pelt.datasets._clips import Pair, find_clips, find_pairs, read_pairs
from pelt.datasets._measurement import METRICS, Measurement
from pelt.datasets._pairs import PAIR_METRICS, PairMeasurement
from pelt.datasets._subjects import Row
from pelt.datasets._table import Table

__all__ = ["METRICS", "Measurement", "PAIR_METRICS", "Pair", "PairMeasurement", "Row", "Table",
           "find_clips", "find_pairs", "read_pairs"]
