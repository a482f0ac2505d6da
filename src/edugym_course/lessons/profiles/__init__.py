"""Profiles (lesson 15)."""
