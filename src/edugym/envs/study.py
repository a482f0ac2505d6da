"""Study: the depth of credit assignment (lesson 3)."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.checks.parameters import between, whole_number
from edugym.mdp.protocol import Integers, Random, Reals
from edugym.rendering.icons import Mood, gauge, smiley
from edugym.rendering.palette import BLUE, GREEN, INK, ORANGE, RED, SHADE, WHITE, blend
from edugym.rendering.scene import Line, Rectangle, Scene, Shape, Text

STUDY, SLEEP, GO_OUT = 0, 1, 2
MOST_ENERGY = 4
MOST_DAYS, MOST_ACTIONS = 100_000, 1_000
EXAM_REWARD = 10.0
MOST_ROWS = 6
"""How much of a long calendar the picture shows."""


class Student(NamedTuple):
    """What the student has, which day it is, and whether the exam has been passed."""

    knowledge: int
    energy: int
    day: int
    passed: bool


class Study(NamedTuple):
    """Pass an exam on the last day: a few right days among many that do not matter.

    ## Description
    Challenge: the depth of credit assignment. Every day a student studies, sleeps, goes out or does something else.
    Studying helps only on the days of a lecture, and the exam at the end asks for knowledge and for energy. A few days
    decide; the others only blur the return. Deep back-ups (Monte Carlo) carry the exam's reward to the first day at
    once, together with all that chance did in between; one-step back-ups carry it slowly, and average chance out. At
    the defaults chance is almost only in the actions that the agent explores; the noise of the rewards adds little
    until `action_reward_noise_sigma` is raised.

    ## Observation space
    `MultiDiscrete([lecture_days + 1, 5, total_days + 1])`: knowledge, energy and day.

    ## Action space
    `Discrete(n_actions)`: 0 study, 1 sleep, 2 go out, 3 and more other things.

    ## State
    Knowledge, energy and day, all of them observed, and after the last day whether the exam has been passed.

    ## Dynamics
    Studying on a lecture day adds 1 to knowledge. Sleep adds 1 to energy, up to 4; going out takes 1 from it, down to
    0. Everything else changes nothing. Then it is the next day.

    ## Reward
    Every action a pays N(r_a, `action_reward_noise_sigma`), with r_a drawn once for each action. Studying on the last
    day, H - 1, pays 10 more if that morning knowledge >= `lectures_needed` and energy > `energy_needed`: the exam is
    passed. The best expected return at the defaults is about 8.98 (discount 1); for other parameters, plan on
    `env.unwrapped.finite_model`.

    ## Initial state
    Knowledge 0, energy 0, day 0.

    ## Episode end
    Terminated after the last day, so always after `total_days` steps; never truncated.

    ## Parameters
    - `total_days` (10): H, from 3 to 100 000.
    - `n_actions` (5): from 2 to 1000; with more, says the paper, returns vary more and deep back-ups suffer.
    - `lecture_days` (3): how many of the days before the exam have a lecture, from 1 to H - 1.
    - `lectures_needed` (2): from 1 to `lecture_days`.
    - `energy_needed` (1): from 0 to 3; the exam asks for more. The days before the exam must be enough:
      `lectures_needed` + `energy_needed` + 1 <= H - 1.
    - `action_reward_noise_mean` (0.5): the r_a are drawn uniformly from minus this to 0; from 0 to 1 000 000.
    - `action_reward_noise_sigma` (0.05): the standard deviation of the reward of an action, from 0 to 1 000 000.
    - `layout_seed` (0): from which the lecture days and the r_a are drawn; 0 or more.

    ## Info
    - `lecture`: whether there is a lecture today.
    - `passed`: whether the exam has been passed.

    ## Choices
    - The paper's state space has 5 levels of knowledge and of energy, its sets have 6 (0 to 5). Here knowledge goes
      from 0 to `lecture_days` and energy from 0 to 4, and there is one more day, since what follows the exam is
      observed.
    - The paper calls `energy_needed` a minimum, and its reward asks for more than that; so does the exam here.
    - The days are 0 to H - 1, the exam is on day H - 1, and the episode ends after it, at time H.
    - `n_actions` counts all actions; the paper's N counts, in one place, only those that do nothing.
    - The exam's reward comes on top of the reward that studying pays on any day.
    - The exam looks at knowledge and energy as they are that morning; there is no lecture that day.
    - With `n_actions` = 2 there is no going out.

    ## Algorithms
    The paper compares n-step SARSA, from one step to Monte Carlo.

    ## References
    Moerland et al. (2023), EduGym, section 4 c and appendix A.3.
    """

    total_days: int
    lectures: Integers  # shape (total_days,): 1 on the days that have a lecture, else 0
    lectures_needed: int
    energy_needed: int
    action_rewards: Reals  # shape (n_actions,): r_a, the mean reward of every action
    sigma: float  # the standard deviation of these rewards

    def initial(self, rng: Random) -> Student:
        """No knowledge, no energy, day 0."""
        return Student(0, 0, 0, False)

    def transition(self, state: Student, action: int, rng: Random) -> Student:
        """Studying helps on a lecture day; sleep gives energy, up to 4; going out takes it; all else does nothing."""
        knowledge, energy = state.knowledge, state.energy
        if action == STUDY and self.lectures[state.day] == 1:
            knowledge += 1
        elif action == SLEEP:
            energy = min(energy + 1, MOST_ENERGY)
        elif action == GO_OUT:
            energy = max(energy - 1, 0)
        return Student(knowledge, energy, state.day + 1, self.passes(state, action))

    def reward(self, state: Student, action: int, next_state: Student, rng: Random) -> float:
        """The noisy reward of the action, N(r_a, sigma), and 10 more for passing the exam."""
        reward: float = rng.normal(self.action_rewards[action], self.sigma)
        return reward + EXAM_REWARD if next_state.passed else reward

    def passes(self, state: Student, action: int) -> bool:
        """Whether this is the exam, passed: studying on the last day, with enough knowledge and energy that morning."""
        return action == STUDY and state.day == self.total_days - 1 and self.missing(state) == 0

    def missing(self, state: Student) -> int:
        """How much knowledge and energy is still missing for the exam."""
        return max(self.lectures_needed - state.knowledge, 0) + max(self.energy_needed + 1 - state.energy, 0)

    def terminal(self, state: Student) -> bool:
        """The end of the last day."""
        return state.day == self.total_days

    def observation(self, state: Student, rng: Random) -> tuple[int, ...]:
        """All there is to know."""
        return state.knowledge, state.energy, state.day

    @property
    def observation_space(self) -> spaces.MultiDiscrete:
        """Knowledge, energy and day."""
        return spaces.MultiDiscrete([int(self.lectures.sum()) + 1, MOST_ENERGY + 1, self.total_days + 1])

    @property
    def action_space(self) -> spaces.Discrete:
        """Study, sleep, go out, and others."""
        return spaces.Discrete(len(self.action_rewards))

    @classmethod
    def create(
        cls,
        total_days: int = 10,
        n_actions: int = 5,
        lecture_days: int = 3,
        lectures_needed: int = 2,
        energy_needed: int = 1,
        action_reward_noise_mean: float = 0.5,
        action_reward_noise_sigma: float = 0.05,
        layout_seed: int = 0,
    ) -> "Study":
        """Check the parameters (see the class) and make the task.

        Raises:
            ValueError: a parameter is not as the class says.
        """
        total_days = whole_number("total_days", total_days, 3, MOST_DAYS)
        n_actions = whole_number("n_actions", n_actions, 2, MOST_ACTIONS)
        lecture_days = whole_number("lecture_days", lecture_days, 1, total_days - 1)
        lectures_needed = whole_number("lectures_needed", lectures_needed, 1, lecture_days)
        energy_needed = whole_number("energy_needed", energy_needed, 0, MOST_ENERGY - 1)
        if lectures_needed + energy_needed + 1 > total_days - 1:
            raise ValueError(
                f"total_days must be {lectures_needed + energy_needed + 2} or more, for lectures_needed "
                f"{lectures_needed!r} and energy_needed {energy_needed!r}, but is {total_days!r}"
            )
        between("action_reward_noise_mean", action_reward_noise_mean, 0, 1_000_000)
        between("action_reward_noise_sigma", action_reward_noise_sigma, 0, 1_000_000)
        action_reward_noise_mean = float(action_reward_noise_mean)  # a small whole number of NumPy's has no minus
        whole_number("layout_seed", layout_seed, 0)
        rng = np.random.default_rng(layout_seed)
        lectures = np.zeros(total_days, np.int64)
        lectures[rng.permutation(total_days - 1)[:lecture_days]] = 1
        rewards = rng.uniform(-action_reward_noise_mean, 0.0, n_actions)
        sigma = float(action_reward_noise_sigma)
        return cls(total_days, lectures, lectures_needed, energy_needed, rewards, sigma)

    @property
    def reward_threshold(self) -> float:
        """The best expected return: of passing the exam, or of not trying, if that pays more.

        The days that the exam does not need go to the action that pays best (to going out before any sleep).
        """
        best, studying, sleeping = self.action_rewards.max(), self.action_rewards[STUDY], self.action_rewards[SLEEP]
        study_days, sleep_days = self.lectures_needed + 1, self.energy_needed + 1
        other_days = self.total_days - study_days - sleep_days
        passing = EXAM_REWARD + study_days * studying + sleep_days * sleeping + other_days * best
        return float(max(passing, self.total_days * best))

    @property
    def action_names(self) -> tuple[str, ...]:
        """Study, sleep, go out, and others."""
        n = len(self.action_rewards)
        return (*("study", "sleep", "go out")[:n], *(f"other {k}" for k in range(1, n - 2)))

    def info(self, state: Student) -> dict[str, Any]:
        """Whether there is a lecture today, and whether the exam has been passed."""
        lecture = state.day < self.total_days and self.lectures[state.day] == 1
        return {"lecture": bool(lecture), "passed": bool(state.passed)}

    def scene(self, state: Student, actions: Sequence[int] = ()) -> Scene:
        """A calendar, five days a row, with what the student did, and how far knowledge and energy have come.

        What was done is green where it brought the student closer to passing the exam (or passed it), red where it led
        away (or failed it), and grey where it did neither. Of a long time it shows the weeks around today.
        """
        study = self
        today, over = min(state.day, study.total_days - 1), bool(study.terminal(state))
        rows = (study.total_days + 4) // 5
        shown = min(rows, MOST_ROWS)
        first = 5 * min(max(0, today // 5 - shown // 2), rows - shown)
        days = range(first, min(first + 5 * shown, study.total_days))

        def corner(day: int) -> tuple[float, float]:
            return 0.6 + 2.0 * (day % 5), 2.65 + 2.0 * ((day - first) // 5)

        shapes = [
            *_bar(0.6, "Knowledge", state.knowledge, study.lectures_needed, int(study.lectures.sum()), BLUE),
            *_bar(6.0, "Energy", state.energy, study.energy_needed + 1, MOST_ENERGY, ORANGE),
        ]
        for day in days:
            kind = "Exam" if day == study.total_days - 1 else "Lecture" if study.lectures[day] == 1 else "Free"
            shapes += _page(*corner(day), day, kind)
        rng = np.random.default_rng(0)
        before, names = study.initial(rng), self.action_names
        for day, action in enumerate(actions):
            after = study.transition(before, action, rng)
            gain = study.missing(before) - study.missing(after)
            if day == study.total_days - 1:
                gain = 1 if study.passes(before, action) else -1
            if day in days:
                shapes += _done(*corner(day), names[action], GREEN if gain > 0 else RED if gain < 0 else SHADE)
            before = after
        mood: Mood = "flat" if not over else "happy" if state.passed else "sad"
        x, y = corner(today)
        shapes += smiley(x + 0.9, y + 0.9, 0.35, mood)
        title = f"Study: day {state.day} of {study.total_days}, knowledge {state.knowledge}, energy {state.energy}"
        return Scene(11.0, 3.0 + 2.0 * shown, shapes, title=title, columns=66)


def _bar(x: float, label: str, value: int, needed: int, most: int, colour: str) -> list[Shape]:
    """A gauge with a mark at what the exam asks for."""
    mark = x + 4.4 * needed / most
    return [
        *gauge(x, 1.35, 4.4, 0.45, f"{label} {value} (exam: {needed})", value / most, colour),
        Line(((mark, 1.35), (mark, 2.0)), glyph="|"),
    ]


def _page(x: float, y: float, day: int, kind: str) -> list[Shape]:
    """A page of the calendar, without what was done."""
    colour = {"Exam": RED, "Lecture": BLUE, "Free": SHADE}[kind]
    return [
        Rectangle(x, y, 1.8, 1.85, 0.1, fill=WHITE),
        Rectangle(x, y, 1.8, 0.5, 0.1, fill=colour),
        Text(x + 0.9, y + 0.25, kind, size=0.36, colour=INK if kind == "Free" else WHITE),
        Text(x + 0.12, y + 0.75, str(day), size=0.26, anchor="start"),
    ]


def _done(x: float, y: float, name: str, colour: str) -> list[Shape]:
    """What was done on a day, at the foot of its page."""
    return [
        Rectangle(x + 0.1, y + 1.29, 1.6, 0.46, 0.1, fill=blend(colour, WHITE, 0.3)),
        Text(x + 0.9, y + 1.52, name, size=0.34),
    ]
