"""Tests of games of two players."""
