"""The experiments, claims and figures of each lesson, one module a lesson."""
