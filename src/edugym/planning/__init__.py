"""Exact planning, on the exact model."""
