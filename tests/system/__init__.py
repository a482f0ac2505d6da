"""Tests of files, interrupts, memory and optional libraries."""
