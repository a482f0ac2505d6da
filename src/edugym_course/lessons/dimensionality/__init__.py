"""Dimensionality (lesson 4)."""
