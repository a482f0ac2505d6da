"""Checks of students' answers: one sentence says what was expected, what came, and which mistake it looks like.

A lesson's exercises are functions that take an answer and a `seed`. They raise `WrongAnswer`, or return one line that
is worth knowing; `check(exercise_2, optimist)` in a notebook shows one or the other. They are written with

- `values`: a number against the one worked out by hand and those that mistakes would give;
- `updates`: an agent's `learn` against an update rule and its usual mistakes, on made-up tables and transitions;
- `choices`: an agent's `act` against the probability of each action;
- `results`: what `repeat` returned, against what was asked for;
- `cases`: made-up cases in which no two mistakes look alike;
- `agents`: an answer that should be a function, a class, or an agent with its fields;
- `student_code`: errors in an answer, which end at the student's own line.

`challenge` scores an agent of the student's own on tasks that belong to a name.
"""

from edugym_course.grading.challenge import Challenge, Score, seed_from_name
from edugym_course.grading.checking import Unsolved, WrongAnswer, check

__all__ = ["Challenge", "Score", "Unsolved", "WrongAnswer", "check", "seed_from_name"]
