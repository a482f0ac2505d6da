"""Fast code of loops, MDPs and agents: what may be compiled, machine code by Numba, and JavaScript in a browser."""
