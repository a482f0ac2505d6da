"""The course: lessons, exercises, grading, notebooks and the command `edugym`.

It imports the library `edugym`, never the other way round.
"""
