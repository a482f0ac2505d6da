"""NumPy's PCG64 as a kilobyte of WebAssembly, on NumPy's own state: what students' translated agents draw from."""

import importlib
from typing import Any

import wasm
from linker import linked

EXPORTED = ("next_double", "next_uint64", "bounded")
SOURCE = """
define double @next_double(i32 %stream) {
  %address = zext i32 %stream to i64
  %drawn = call double @pcg64_next_double(i64 %address)
  ret double %drawn
}

define i64 @next_uint64(i32 %stream) {
  %address = zext i32 %stream to i64
  %drawn = call i64 @pcg64_next_uint64(i64 %address)
  ret i64 %drawn
}

; A whole number from 0 to %last, which is below 2^32 - 1: Lemire's way, as in numpy/random/src/distributions.
define i32 @bounded(i32 %stream, i32 %last) {
  %address = zext i32 %stream to i64
  %n = add i32 %last, 1
  %wide = zext i32 %n to i64
  %left = sub i32 4294967295, %last
  %threshold = urem i32 %left, %n
  br label %again
again:
  %bits = call i32 @pcg64_next_uint32(i64 %address)
  %wide_bits = zext i32 %bits to i64
  %product = mul i64 %wide_bits, %wide
  %low = trunc i64 %product to i32
  %unfair = icmp ult i32 %low, %threshold
  br i1 %unfair, label %again, label %done
done:
  %high = lshr i64 %product, 32
  %drawn = trunc i64 %high to i32
  ret i32 %drawn
}
"""


def module() -> bytes:
    """The module: it imports its memory, and exports the functions that draw."""
    return linked(wasm.optimised(SOURCE, EXPORTED), EXPORTED, {})


def tables() -> dict[str, Any]:
    """NumPy's tables for normal and exponential numbers, of which Numba has a copy; `draws.js` uses them."""
    numbers: Any = importlib.import_module("numba.np.random._constants")
    arrays = {name: getattr(numbers, f"{name}_double").tolist() for name in ("wi", "ki", "fi", "we", "ke", "fe")}
    return {
        **arrays,
        "normal_tail": numbers.ziggurat_nor_r,
        "normal_inverse_tail": numbers.ziggurat_nor_inv_r,
        "exponential_tail": numbers.ziggurat_exp_r,
    }
