"""Exploration (lesson 1)."""
