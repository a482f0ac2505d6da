"""Tests of `edugym lab`."""
