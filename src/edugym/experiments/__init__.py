"""Experiments: repetition over seeds, tables of results, and figures."""
