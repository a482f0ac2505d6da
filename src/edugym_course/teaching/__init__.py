"""For teachers: a lesson for each student with numbers of her own, and the results of a class.

`assignment` makes the lessons (`edugym assign`). `grading` grades what comes back (`edugym grade`), in a process for
each student (`session`), and `page` shows the results of the class.
"""
