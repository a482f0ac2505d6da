"""Machine code of loops, MDPs and agents by Numba: what may be compiled, compiling, the disk cache, and running it."""
