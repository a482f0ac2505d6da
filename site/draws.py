"""NumPy's PCG64 as a kilobyte of WebAssembly, on NumPy's own state: what students' translated agents draw from."""

import wasm
from linker import linked

EXPORTED = ("next_double", "bounded")
SOURCE = """
define double @next_double(i32 %stream) {
  %address = zext i32 %stream to i64
  %drawn = call double @pcg64_next_double(i64 %address)
  ret double %drawn
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
