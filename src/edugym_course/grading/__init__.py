'''Checks of students' answers: one sentence says what was expected, what came, and which mistake it looks like.

The exercises of a lesson are functions in its `exercises.py`, or its folder `exercises`: `exercise_1`, `exercise_2`.
Each takes an answer and a `seed`. It raises `WrongAnswer` with one sentence, or returns one line that is worth knowing;
`check(exercise_1, answer)` in a notebook shows the one or the other. To add an exercise,

1. write the function. Require what the answer must be; call it inside `student_code`, which turns its errors into
   sentences and ends code that never does; compare what comes with what is right and with what mistakes would give:

       def exercise_1(answer: Any, seed: int) -> str:
           """Check the expected number of steps of a random climber."""
           require_function("steps", answer, "the height and the number of grips")
           for height, n_grips in ((3 + seed % 3, 2), (3, 3 + seed % 2)):  # other cases with another seed
               call = f"steps({height}, {n_grips})"
               with student_code(call):
                   found = answer(height, n_grips)
               mistakes = {"that is the number of climbs; each takes several steps": n_grips**height}
               compare(call, found, sum(n_grips**h for h in range(1, height + 1)), mistakes)
           return "Right: with two grips, each further level about doubles the steps."

2. put the question, the cell with its solution and the cell with `check(exercise_1, steps)` into the lesson's text;
3. write answers as students do, in the lesson's folder `answers`: right ones that differ, and for every sentence of the
   check a wrong one, with the sentence behind `# says:`. A test tries them all, and finds a sentence that none shows.

To check something else than a number, take

| the answer is | check it with | a mistake is |
|---|---|---|
| a number | `values.compare`; `mistakes.compare_all` for one that is called several times | the number that it gives |
| an agent's `learn` | `updates.Update`, or `one_step.Q_LEARNING` | the same rule with other arguments |
| an agent's `act` | `choices.check_choices`, or `check_all_choices` for several cases | other probabilities |
| what `repeat` returned | `results.check_results` | another setting |
| something of your own | `mistakes.mistake_in_cases` names the mistake | a rule that explains all cases, or most |
| a program from a blank file | `replay.Rule`, and `curves.Race` against ours | an agent of ours that makes it |
| an agent that learns well | `challenge.Challenge`, on tasks that belong to a name | none: it gets points |

`agents` makes the agent of a student's class, and `cases` draws cases in which no two mistakes look alike.
'''

from edugym_course.grading.challenge import Challenge, Score, seed_from_name
from edugym_course.grading.checking import check
from edugym_course.grading.errors import Unsolved, WrongAnswer

__all__ = ["Challenge", "Score", "Unsolved", "WrongAnswer", "check", "seed_from_name"]
