"""Markov decision processes as small values: what one is, its wrappers, and the gate for what users give."""
