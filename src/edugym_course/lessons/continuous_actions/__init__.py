"""Discrete and continuous actions (lesson 7)."""
