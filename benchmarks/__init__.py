"""How fast EduGym is, next to what one would use instead, all measured in one run: `python -m benchmarks`."""
