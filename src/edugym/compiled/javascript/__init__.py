"""A second back end for the same subset of Python: JavaScript, for students' code in a web browser."""
