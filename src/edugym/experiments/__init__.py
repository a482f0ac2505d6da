"""Experiments: training, its results as tables, what these show, and those behind the figures of the paper."""

from edugym.experiments.claims import Above, Below, Claim, Within
from edugym.experiments.repeat import repeat
from edugym.experiments.results import Results
from edugym.experiments.statistics import Interval, mean_interval, paired_difference, proportion_interval
from edugym.experiments.training import Run, train
from edugym.experiments.visits import record_visits

__all__ = [
    "Above",
    "Below",
    "Claim",
    "Interval",
    "Results",
    "Run",
    "Within",
    "mean_interval",
    "paired_difference",
    "proportion_interval",
    "record_visits",
    "repeat",
    "train",
]
