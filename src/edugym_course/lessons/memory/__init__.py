"""Partial observability (lesson 5)."""
