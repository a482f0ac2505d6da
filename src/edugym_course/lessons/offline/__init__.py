"""Offline learning (lesson 16)."""
