"""The exercises of the lessons: how each answer is checked, one module a lesson, beside its experiments by name."""
