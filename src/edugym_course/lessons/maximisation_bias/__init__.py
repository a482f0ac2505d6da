"""Maximisation bias (lesson 17)."""
