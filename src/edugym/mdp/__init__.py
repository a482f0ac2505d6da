"""Markov decision processes as small values, and the four ways to run them."""
