"""Tests of the checks of what users write."""
