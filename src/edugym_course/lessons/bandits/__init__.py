"""Bandits (lesson 0b)."""
