"""Libraries that only parts of the package need: each part says what to install before it fails."""

import ast
import re
import subprocess
import sys
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from gymnasium.error import DependencyNotInstalled

from edugym import (
    Dataset,
    FiniteModel,
    QLearning,
    Results,
    collect,
    finite_model,
    make_mdp,
    read_minari,
    repeat,
    write_minari,
)
from edugym.adapters.playing.keyboard import play
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.figures.style import axes_or_new
from edugym.experiments.results.statistics import mean_interval, proportion_interval
from edugym.games import MatchingPennies, parallel_env
from edugym.rendering.gif import to_gif
from edugym.system.packages import own_folders
from edugym_course.lab.server import require_jupyterlab
from edugym_course.lessons.stochasticity.exact import from_the_tee

pytest.importorskip("torch")

from edugym.deep.baselines import class_of
from edugym.deep.repeated import repeat_deep

LIBRARIES = ["matplotlib", "pandas", "scipy", "joblib", "PIL", "pygame", "numba", "torch", "IPython", "ipywidgets"]
LOADING = f"""
import importlib, pkgutil, sys
sys.modules |= dict.fromkeys({LIBRARIES})
import edugym, edugym_course
for package in (edugym, edugym_course):
    for module in pkgutil.walk_packages(package.__path__, package.__name__ + ".", onerror=lambda name: None):
        last = module.name.rpartition(".")[2]
        try:
            last == "__main__" or last[0].isdigit() or importlib.import_module(module.name)
        except Exception:
            print(module.name)
"""
NEED_ONE = {
    *(f"edugym.compiled.{name}" for name in ("arithmetic", "checked_values", "compiler_pipelines", "draws")),
    *(f"edugym.compiled.{name}" for name in ("finite", "insertions", "interrupt_polling", "mixed_numbers")),
    *(f"edugym.compiled.{name}" for name in ("number_kinds", "operations", "random_generators")),
    *(f"edugym.compiled.{name}" for name in ("typed_checks", "untyped_checks")),
    *(f"edugym.deep.{name}" for name in ("actor_critic", "baselines", "curves", "library", "ppo", "vec_env")),
    *("edugym_course.lessons.dimensionality.layers", "edugym_course.notebook"),
}
"""The modules that are about a library, and are imported where that is there."""
ROOT = Path(__file__).parents[2]
PACKAGES = {"PIL": "matplotlib", "IPython": "ipywidgets", "sb3_contrib": "sb3-contrib"}
"""What brings a library whose name is another one."""


def steps_of_a_model() -> tuple[Dataset, FiniteModel]:
    """A dataset, and its model."""
    model = finite_model(make_mdp("Boulder", height=2))
    return collect(model, [0] * len(model.states), 1), model


def packages_of(extra: str) -> set[str]:
    """The packages that an extra installs, those of the extras in it included."""
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    found = set[str]()
    for line in extras[extra]:
        inside = re.match(r"edugym\[(.*)\]", line)
        found |= set().union(*map(packages_of, inside[1].split(","))) if inside else {re.split("[>=<]", line)[0]}
    return found


def test_modules_load_where_no_extra_is_installed() -> None:
    """Plotting, results and lessons ask for a library when they need it, so that the sentence can be said."""
    done = subprocess.run([sys.executable, "-c", LOADING], capture_output=True, text=True, check=True)
    assert set(done.stdout.split()) == NEED_ONE


def test_an_extra_brings_what_it_is_named_for() -> None:
    """Wherever the package asks for a library."""
    asked = [
        [ast.literal_eval(argument) for argument in node.args]
        for folder in own_folders()
        for path in folder.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "require"
        if all(isinstance(argument, ast.Constant) for argument in node.args)
    ]
    assert len(asked) >= 12
    for extra, *libraries in asked:
        assert {PACKAGES.get(library, library) for library in libraries} <= packages_of(extra), extra


@pytest.mark.parametrize(
    ("library", "extra", "use"),
    [
        ("pandas", "experiments", lambda path: Results.load(path)),
        ("pandas", "experiments", lambda path: repeat("Boulder", {"Q": QLearning.create}, 100).table),
        ("pandas", "experiments", lambda path: repeat("Boulder", {"Q": QLearning.create}, 100, save_to=path)),
        ("joblib", "experiments", lambda path: repeat("Boulder", {"Q": QLearning.create}, 100)),
        ("joblib", "experiments", lambda path: repeat_deep({}, 100)),
        ("scipy", "experiments", lambda path: mean_interval([1, 2])),
        ("scipy", "experiments", lambda path: proportion_interval(1, 2)),
        ("scipy", "experiments", lambda path: from_the_tee(0.0123)),  # which nobody else asks, for it is kept
        ("matplotlib", "plot", lambda path: Sheet("empty", []).draw()),
        ("matplotlib", "plot", lambda path: axes_or_new(None)),
        ("PIL", "plot", lambda path: to_gif([np.zeros((2, 2, 3), np.uint8)], path)),
        ("PIL", "plot", lambda path: play("Boulder", gif=path)),
        ("pettingzoo", "games", lambda path: parallel_env(MatchingPennies.create())),
        ("minari", "data", lambda path: write_minari(*steps_of_a_model(), name="a-v0")),
        ("h5py", "data", lambda path: read_minari(None, steps_of_a_model()[1])),
        ("sb3_contrib", "deep", lambda path: class_of("RecurrentPPO")),
        ("jupyterlab", "lab", lambda path: require_jupyterlab()),
        ("ipywidgets", "lab", lambda path: require_jupyterlab()),
        ("matplotlib", "lab", lambda path: require_jupyterlab()),
    ],
)
def test_a_missing_library_is_named(
    library: str, extra: str, use: Callable[[Path], Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With what installs it, and before anything is written."""
    monkeypatch.setattr("edugym.system.extras.find_spec", lambda name: None if name == library else name)
    says = rf'^{library} is .*"edugym\[{extra}\] @ git\+https://.* checkout .*pip install "\.\[{extra}\]"'
    with pytest.raises(DependencyNotInstalled, match=says):
        use(tmp_path / "new")
    assert [*tmp_path.iterdir()] == []
