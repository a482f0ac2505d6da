"""Random generators that are passed to machine code by their address, which is ten times as fast as Numba's way.

Whenever a `numpy.random.Generator` is passed, Numba asks it for the addresses of its state and functions. That takes
5 µs, more than a step of five hundred copies of a small environment, and in builds without reference counts it keeps a
reference to the generator for ever. But a generator never moves. Here it is asked once, and machine code reads the
answer (0.5 µs). The numbers drawn, and the state that they leave behind, are those of the generator itself.

This depends on how Numba lays out a generator. Importing this file raises `ImportError` where that is not as expected;
then `edugym.compiled.compiler`, its only user, passes generators as they are.
"""

import ctypes
from functools import lru_cache
from typing import Any

import numpy as np
from numba import extending
from numba.core import cgutils, types
from numba.core.datamodel import default_manager
from numba.np.random.generator_core import NumPyRandomGeneratorTypeModel

from edugym.mdp.protocol import Random

WORDS = ("state_address", "state", "fnptr_next_uint64", "fnptr_next_uint32", "fnptr_next_double")
"""The fields of Numba's bit generator, in the order of `LocatedGenerator.words`."""


LocatedGeneratorType: Any = type("LocatedGeneratorType", (types.NumPyRandomGeneratorType,), {"__module__": __name__})
"""Numba's type of a generator that is passed by its address: like its own but for how it is passed.

Its module is named because the disk cache finds a type by module and name; without it no build would be found again.
"""


class LocatedGenerator:
    """A generator and its addresses.

    Attributes:
        rng: the generator, which must not go away.
        words: shape (5,): the addresses of its state and functions.
        address: where `words` begin.
    """

    _numba_type_ = LocatedGeneratorType("generator")

    def __init__(self, rng: Random) -> None:
        """Asks the generator for its addresses."""
        asked = rng.bit_generator.ctypes
        functions = (asked.next_uint64, asked.next_uint32, asked.next_double)
        self.rng = rng
        self.words = np.array(
            [asked.state_address, asked.state.value, *(ctypes.cast(f, ctypes.c_void_p).value for f in functions)],
            np.uintp,
        )
        self.address = self.words.ctypes.data


@lru_cache(maxsize=64)
def located(rng: Random) -> LocatedGenerator:
    """The generator with its addresses; the latest ones are remembered."""
    return LocatedGenerator(rng)


def _teach_numba() -> None:
    """Tells Numba how a located generator is laid out (as any other) and unboxed (from its five words).

    Raises:
        ImportError: Numba is not as expected.
    """
    bits_of_it: Any = types.NumPyRandomBitGeneratorType("bit_generator")
    extending.register_model(LocatedGeneratorType)(NumPyRandomGeneratorTypeModel)
    parts = default_manager[LocatedGenerator._numba_type_]._fields, {*default_manager[bits_of_it]._fields}
    if parts != (("bit_generator", "meminfo", "parent"), {"parent", "bit_generator", *WORDS}):
        raise ImportError(f"this version of Numba makes random generators of other parts: {parts}")

    def made(kind: Any, located: Any, c: Any) -> Any:
        address = c.pyapi.object_getattr_string(located, "address")
        words = c.builder.inttoptr(c.pyapi.long_as_ulonglong(address), cgutils.intp_t.as_pointer())
        c.pyapi.decref(address)
        bits = cgutils.create_struct_proxy(bits_of_it)(c.context, c.builder)
        for k, name in enumerate(WORDS):
            setattr(bits, name, c.builder.load(cgutils.gep(c.builder, words, k)))
        generator = cgutils.create_struct_proxy(kind)(c.context, c.builder)
        generator.bit_generator = bits._getvalue()
        return extending.NativeValue(generator._getvalue())

    extending.unbox(LocatedGeneratorType)(made)


_teach_numba()
