"""Tests of the exercises of the lessons."""
