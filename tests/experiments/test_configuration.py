"""What is written down of a setting, to the letter, and what the runs of a task are recognised by."""

import hashlib
import importlib
import sys
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.wrappers import PassiveEnvChecker

from edugym.experiments.configuration import plain, task
from edugym.experiments.fingerprints import fingerprint

MIXED = np.arange(33).reshape(3, 11)


@pytest.mark.parametrize(
    ("value", "written"),
    [
        (True, True), (3, 3), (0.5, 0.5), (np.int8(3), 3), (np.True_, True), (np.str_("8x8"), "8x8"),
        ((1, 2.5), "[1, 2.5]"), (np.array([[1, 2], [3, 4]]), "[[1, 2], [3, 4]]"),
        (np.zeros((4, 8), int), str([[0] * 8] * 4)), (np.full((3, 11), 0.5), '{"shape": [3, 11], "filled_with": 0.5}'),
        (MIXED, f'{{"shape": [3, 11], "sha256": "{hashlib.sha256(MIXED.tobytes()).hexdigest()[:16]}"}}'),
        ({"goal": [None, object()]}, '{"goal": [null, "object"]}'),
    ],
)  # fmt: skip
def test_how_a_setting_is_written(value: Any, written: Any) -> None:
    """As a number or a text; an array up to 32 entries whole, and a longer one in short."""
    found = plain(value)
    assert found == written
    assert type(found) is type(written)


def test_a_registered_environment_is_known_by_its_code(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Also where it is registered by the name of its class: whoever changes the file gets other runs."""
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setitem(gymnasium.registry, "Drop-v0", gymnasium.envs.registration.EnvSpec("Drop-v0", "dropped:Drop"))
    path, found = tmp_path / "dropped.py", []
    for height in (1, 1, 100):
        path.write_text(
            f"import gymnasium\n\n\nclass Drop(gymnasium.Env):\n    def height(self):\n        return {height}\n"
        )
        monkeypatch.delitem(sys.modules, "dropped", raising=False)
        importlib.invalidate_caches()
        found.append(fingerprint(task("Drop-v0").origin))
    assert found[0] == found[1] != found[2]


def test_how_an_environment_is_made(monkeypatch: pytest.MonkeyPatch) -> None:
    """Also where it is registered as a class; without Gymnasium's own checks, which would take a part of each step."""
    kind: Any = type(gymnasium.make("CliffWalking-v1").unwrapped)
    spec = gymnasium.envs.registration.EnvSpec("Local-v0", kind)
    monkeypatch.setitem(gymnasium.registry, "Local-v0", spec)
    assert fingerprint(task("Local-v0").origin)
    env = task("Local-v0").make(0)
    assert env.spec.id == "Local-v0"
    while env is not env.unwrapped:
        assert not isinstance(env, PassiveEnvChecker)
        env = env.env
