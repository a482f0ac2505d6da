"""`python -m benchmarks`: measure everything, and print a table."""

import argparse
import json
import os
import platform
from collections.abc import Iterator
from importlib.metadata import version
from pathlib import Path
from typing import Any

from benchmarks.catch import absent
from benchmarks.comparisons import comparisons
from benchmarks.imports import MODULES, TARGET, import_times
from benchmarks.measure import Measured, Spread, measure, number
from benchmarks.solving import OURS, SEEDS, TASKS, Solved, times_to_solve

LINE = "{:45} {:>8} {:>19} {:>10} {:>15}   {}"


def main(arguments: list[str] | None = None) -> None:
    """Measure what is asked for, and print it."""
    options = parser().parse_args(arguments)
    rounds, seconds = (1, 0.001) if options.quick else (options.rounds, options.seconds)
    about = machine()
    print("   ".join(f"{name} {value}" for name, value in about.items()))
    print(f"{rounds} rounds in turns, each about {seconds} s of processor time on one core; medians\n")
    if absent():
        print(f"Not installed, and so not compared with: {', '.join(absent())}.\n")
    if options.json:
        options.json.touch()  # better to fail now than in the end
    print(LINE.format("", "a second", "lowest - highest", "EduGym is", "", "wanted"))
    results = []
    for comparison in comparisons(options.quick):
        if options.only in comparison.name:
            measured = measure(comparison, rounds, seconds)
            print("\n".join(table(measured)), flush=True)
            results.append(measured)
    solved = []
    for task in () if "stable_baselines3" in absent() else TASKS:
        if options.only in task.name:
            short = task._replace(n_steps=1) if options.quick else task
            solved.append(times_to_solve(short, 1 if options.quick else SEEDS))
            print("\n".join(solving_table(solved[-1])), flush=True)
    imports = import_times(rounds) if options.only in "import" else {}
    print("\n".join(import_table(imports)))
    if options.json:
        data = as_data(about, results, solved, imports)
        options.json.write_text(json.dumps(data, indent=2, ensure_ascii=False) + "\n")


def parser() -> argparse.ArgumentParser:
    """What can be asked for."""
    parser = argparse.ArgumentParser("python -m benchmarks", description=__doc__)
    parser.add_argument("--json", type=Path, metavar="PATH", help="write the results there as well")
    parser.add_argument("--only", default="", metavar="TEXT", help="measure only what has this in its name")
    parser.add_argument("--rounds", type=int, default=7, help="turns for each contender (%(default)s)")
    parser.add_argument("--seconds", type=float, default=0.3, help="length of a turn (%(default)s)")
    parser.add_argument("--quick", action="store_true", help="hardly measure anything: only see whether it runs")
    return parser


def machine() -> dict[str, str]:
    """Where this was measured, and with which versions."""
    names = [line.split(":")[1].strip() for line in _cpu_lines() if line.startswith("model name")]
    cpu = names[0] if names else platform.machine()
    packages = {name: version(name) for name in ("edugym", "gymnasium", "numba", "numpy")}
    load = f"{os.getloadavg()[0]:.1f}" if hasattr(os, "getloadavg") else "?"
    return {
        "cpu": f"{cpu} x {os.cpu_count()}",
        "load": load,
        "python": platform.python_version(),
        **packages,
    }


def _cpu_lines() -> list[str]:
    path = Path("/proc/cpuinfo")
    return path.read_text().splitlines() if path.exists() else []


def table(measured: Measured) -> Iterator[str]:
    """The lines for one comparison."""
    ours = measured.comparison.ours.name
    aims = ", ".join(f"{aim} {'met' if met else 'MISSED'}" for aim, met in measured.targets().items())
    yield f"{measured.comparison.name} ({measured.comparison.unit} a second)"
    for name, rate in measured.rates.items():
        ratio = measured.ratios.get(name)
        times = ("", "") if ratio is None else (f"{ratio.median:.3g} x", f"{ratio.low:.3g} - {ratio.high:.3g}")
        range_of_rates = f"{number(rate.low)} - {number(rate.high)}"
        yield LINE.format(
            f"  {name}", number(rate.median), range_of_rates, *times, aims if name == ours else ""
        ).rstrip()


def solving_table(solved: Solved) -> Iterator[str]:
    """The lines for the time until a task is solved."""
    yield f"{solved.task.name} (seconds)"
    for name, seconds in solved.seconds.items():
        taken, shown = solved.times.get(name), None if name == OURS else solved.ratio
        columns = ("", "") if taken is None else (f"{taken.median:.3g}", f"{taken.low:.3g} - {taken.high:.3g}")
        times = ("", "") if shown is None else (f"{shown.median:.3g} x", f"{shown.low:.3g} - {shown.high:.3g}")
        unsolved = ", ".join(map(str, solved.unsolved(name)))
        remark = f"not solved: {unsolved} of seeds 0 to {len(seconds) - 1}" if unsolved else ""
        yield LINE.format(f"  {name}", *columns, *times, remark).rstrip()


def import_table(imports: dict[str, Spread]) -> Iterator[str]:
    """The lines for imports."""
    if imports:
        yield "import (seconds of processor time)"
    for module, taken in imports.items():
        met = "" if module != MODULES[0] else f"<= {TARGET} s {'met' if taken.median <= TARGET else 'MISSED'}"
        yield LINE.format(f"  {module}", f"{taken.median:.3f}", f"{taken.low:.3f} - {taken.high:.3f}", "", "", met)


def as_data(
    about: dict[str, str], results: list[Measured], solved: list[Solved], imports: dict[str, Spread]
) -> dict[str, Any]:
    """Everything, for a file."""
    return {
        "machine": about,
        "comparisons": [
            {
                "name": measured.comparison.name,
                "unit": measured.comparison.unit,
                "per_second": {name: rate._asdict() for name, rate in measured.rates.items()},
                "edugym_is_times_as_fast_as": {name: ratio._asdict() for name, ratio in measured.ratios.items()},
                "targets": measured.targets(),
            }
            for measured in results
        ],
        "times_to_solve": [
            {
                "name": one.task.name,
                "seconds_by_seed": one.seconds,
                "edugym_is_times_as_fast": one.ratio and one.ratio._asdict(),
            }
            for one in solved
        ],
        "import_seconds": {module: taken._asdict() for module, taken in imports.items()},
    }


if __name__ == "__main__":
    main()
