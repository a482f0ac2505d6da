"""How long an import takes, in processes that have imported nothing yet, in seconds of processor time."""

import statistics
import subprocess
import sys

from benchmarks.measure import Spread

TARGET = 0.15
"""Seconds that `import edugym` may take."""

MODULES = ("edugym", "gymnasium", "numpy")
TIMED = "import time; began = time.process_time(); import {}; print(time.process_time() - began)"


def import_times(rounds: int) -> dict[str, Spread]:
    """Seconds for each module, in turns, after one turn that brings the files into memory."""
    times: dict[str, list[float]] = {module: [] for module in MODULES}
    for turn in range(rounds + 1):
        for module in MODULES:
            command = [sys.executable, "-c", TIMED.format(module)]
            seconds = float(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
            if turn > 0:
                times[module].append(seconds)
    return {module: Spread(statistics.median(taken), min(taken), max(taken)) for module, taken in times.items()}
