"""Everything that knows Numba: what may be compiled, its fingerprint, the compiler, random generators, execution."""
