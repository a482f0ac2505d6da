"""Stochasticity (lesson 8)."""
