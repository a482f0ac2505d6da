"""Experiments: many runs over seeds, tables of results, intervals and claims, and figures."""
