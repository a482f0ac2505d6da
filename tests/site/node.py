"""Runs a kernel in Node, with the JavaScript of the page, and in Python, to compare them."""

import json
import shutil
import struct
import subprocess
from pathlib import Path
from typing import Any, NamedTuple

import kernels
import numpy as np
import playground

from edugym.training.trainers import streams

NODE = shutil.which("node")
RUN = Path(__file__).with_name("run.mjs")
KERNELS = playground.BUILT / "kernels"
"""Where `make site` keeps kernels: what has been compiled is not compiled again."""


class Outcome(NamedTuple):
    """What came of a run.

    Attributes:
        arrays: the bytes of every array, in hexadecimal digits.
        generators: the states of the random streams.
        curve: steps, return, and return while it explored (None where no episode ended).
        borrowed: the functions of mathematics that came from Node.
    """

    arrays: list[str]
    generators: list[int]
    curve: list[list[float | None]]
    borrowed: list[str]


def in_node(call: kernels.Call, seed: int, steps: int, every: int, **how: Any) -> Outcome:
    """Train in Node."""
    made = kernels.build([call], KERNELS)
    asked = {
        "page": str(playground.PAGE),
        "file": str(KERNELS / f"{call.fingerprint}.wasm"),
        "fingerprint": call.fingerprint,
        "plan": playground.plan(call, made[call.fingerprint]),
        "streams": playground.random_streams()[seed],
        "steps": steps,
        "every": every,
        **how,
    }
    done = subprocess.run([str(NODE), RUN], input=json.dumps(asked), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    came = json.loads(done.stdout)
    states = [struct.unpack("<2Q", bytes.fromhex(generator)[16:32]) for generator in came["generators"]]
    return Outcome(came["arrays"], [low | high << 64 for low, high in states], came["curve"], came["imports"])


def in_python(call: kernels.Call, seed: int, steps: int, every: int) -> Outcome:
    """Train with the very call that was compiled, interpreted."""
    rngs = streams(seed)
    training, evaluation, *values = call.arguments[2:-1]
    training = training._replace(environment_rng=rngs[0], agent_rng=rngs[1])
    evaluation = evaluation._replace(environment_rng=rngs[2], actor_rng=rngs[3])
    arguments = (training, evaluation, *values)
    log, returns, curve = training.log, evaluation.returns, list[list[float | None]]()
    carry = call.loop(kernels.BEGIN, 0, *arguments, call.arguments[-1])
    for done in range(0, steps + 1, every):
        if done:
            carry = call.loop(every, 0, *arguments, carry)
        carry = call.loop(0, len(returns), *arguments, carry)
        episodes = int(log.episodes[0])
        curve.append([done, float(np.mean(returns)), float(log.returns[0] / episodes) if episodes else None])
        log.returns[0] = log.episodes[0] = 0
    if call.loop in kernels.NOTED:
        carry = call.loop(kernels.SHOW, 0, *arguments, carry)
    states = [rng.bit_generator.state["state"]["state"] for rng in rngs]
    return Outcome(arrays_of((*arguments, carry)), states, curve, [])


def arrays_of(value: Any) -> list[str]:
    """The bytes of the arrays in a value, each once, in the order in which a plan has them."""
    found: dict[tuple[int, str], str] = {}

    def visit(part: Any) -> None:
        if isinstance(part, np.ndarray):
            found.setdefault((part.ctypes.data, str(part.dtype)), part.tobytes().hex())
        elif isinstance(part, tuple):
            for inner in tuple.__iter__(part):
                visit(inner)

    visit(value)
    return list(found.values())
