"""An engine for translations, for tests: Node.js, to which memory is copied before each call, and back after it."""

import base64
import json
import shutil
import struct
import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import draws
import numpy as np

from edugym.compiled.javascript.libraries import LIBM
from edugym.compiled.javascript.program import Doubt

NODE = shutil.which("node")
SCRIPT = Path(__file__).with_name("engine.mjs")
DRAWING = Path(draws.__file__).parent / "playground" / "draws.js"
FIRST = 2 * 65536
"""Where the memory begins that is not the WebAssembly's own."""


class Node:
    """A process of Node.js.

    Args:
        module: the file with the WebAssembly that draws.
        libm: the functions of mathematics that it lends; their last digit may be another than Python's.
    """

    def __init__(self, module: Path, libm: frozenset[str] = frozenset()) -> None:
        """Starts it."""
        self.libm = libm & LIBM
        self._process = subprocess.Popen(
            [str(NODE), str(SCRIPT)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        self._regions: dict[int, tuple[int, Any, int]] = {}
        self._free = FIRST
        self._ask(kind="begin", module=str(DRAWING), draws=str(module), tables=draws.tables())

    def close(self) -> None:
        """Ends it."""
        assert self._process.stdin
        assert self._process.stdout
        self._process.stdin.close()
        self._process.wait()
        self._process.stdout.close()

    def _ask(self, **asked: Any) -> Any:
        assert self._process.stdin
        assert self._process.stdout
        self._process.stdin.write(json.dumps(asked) + "\n")
        self._process.stdin.flush()
        answer = json.loads(self._process.stdout.readline())
        if "error" in answer:
            self._regions, self._free = {}, FIRST
            if answer["error"] == "Doubt":
                raise Doubt(answer["message"])
            raise AssertionError(f"{answer['error']}: {answer['message']}\n{asked.get('source', '')}")
        return answer

    def load(self, text: str) -> Callable[[Sequence[float]], Sequence[float]]:
        """See `edugym.compiled.javascript.program.Engine`."""
        program = self._ask(kind="load", source=text)["program"]

        def run(numbers: Sequence[float]) -> Sequence[float]:
            held = list(self._regions.values())
            answer = self._ask(kind="run", program=program, numbers=list(map(repr, numbers)), regions=self._sent())
            self._regions, self._free = {}, FIRST
            for (_, owner, _), content in zip(held, answer["regions"], strict=True):
                _put_back(owner, base64.b64decode(content))
            return list(map(float, answer["result"]))

        return run

    def _sent(self) -> list[tuple[int, str]]:
        return [(at, base64.b64encode(_content(owner, at)).decode()) for at, owner, _ in self._regions.values()]

    def address(self, array: Any) -> int:
        """See `edugym.compiled.javascript.program.Engine`."""
        owner = array
        while isinstance(owner.base, np.ndarray):
            owner = owner.base
        begin = owner.ctypes.data
        if begin not in self._regions:
            self._add(begin, owner, owner.nbytes)
        offset: int = self._regions[begin][0] + array.ctypes.data - begin
        return offset

    def stream(self, rng: np.random.Generator) -> int:
        """See `edugym.compiled.javascript.program.Engine`."""
        if id(rng) not in self._regions:
            self._add(id(rng), rng, 64)
        return self._regions[id(rng)][0]

    def _add(self, key: int, owner: Any, size: int) -> None:
        self._regions[key] = self._free, owner, size
        self._free += (size + 31) & ~15


def _content(owner: Any, at: int) -> bytes:
    """The bytes of an array, or of a random stream as NumPy keeps it on 32 bits."""
    if isinstance(owner, np.ndarray):
        return np.ndarray(owner.nbytes, np.uint8, owner.ravel(order="K").data).tobytes()
    state: Any = owner.bit_generator.state
    numbers = state["state"]["state"], state["state"]["inc"]
    words = [part for number in numbers for part in (number & 2**64 - 1, number >> 64)]
    return struct.pack("<4I4Q", at + 16, state["has_uint32"], state["uinteger"], 0, *words)


def _put_back(owner: Any, content: bytes) -> None:
    if isinstance(owner, np.ndarray):
        np.ndarray(owner.nbytes, np.uint8, owner.ravel(order="K").data)[:] = np.frombuffer(content, np.uint8)
        return
    _, has, kept, _, low, high, more_low, more_high = struct.unpack("<4I4Q", content)
    state: Any = owner.bit_generator.state
    state["state"] = {"state": low | high << 64, "inc": more_low | more_high << 64}
    state["has_uint32"], state["uinteger"] = has, kept
    owner.bit_generator.state = state
