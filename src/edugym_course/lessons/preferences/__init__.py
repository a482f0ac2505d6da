"""Preferences (lesson 14)."""
