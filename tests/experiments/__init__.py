"""Tests of experiments: repetition, results, figures."""
