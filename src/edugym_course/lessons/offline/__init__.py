"""Offline learning (lesson 15)."""
