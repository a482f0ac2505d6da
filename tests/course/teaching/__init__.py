"""Tests of what teachers use: a lesson for each student, and the results of a class."""
