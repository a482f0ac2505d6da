"""What 'final' makes of an episode, and what it makes with the usual mistakes (lesson 11, exercise 2)."""

from collections.abc import Mapping, Sequence
from itertools import combinations, permutations
from typing import Any

from edugym_course.grading.errors import nobody_asks_why

Step = tuple[int, int, int]
"""A step of an episode: state, action, next state. States are patterns, and so numbers."""
Transition = tuple[int, int, int, float, int, bool]
"""State, goal, action, reward, next state, and whether the step terminated."""
Settings = Mapping[str, Any]


def relabelled(
    steps: Sequence[Step],
    goal: str = "final",
    reward: str = "right",
    terminated: str = "right",
    kept: str = "all",
    alike: str = "equal",
    cost: float = 1.0,
) -> list[Transition]:
    """Return an episode as if its last pattern had been the goal, where a step that misses costs `cost`.

    Other arguments than the defaults are mistakes.
    """
    made = []
    last = len(steps) - 1
    first_end = next((t for t, step in enumerate(steps) if step[2] == steps[last][2]), last)
    for t, (state, action, next_state) in enumerate(steps):
        wanted = {
            "final": steps[last][2],
            "before": steps[last][0],
            "first": steps[0][2],
            "start": steps[0][0],
            "own": next_state,
        }[goal]
        reached = next_state is wanted if alike == "the same object" else next_state == wanted
        pays = {
            "right": 0.0 if reached else -cost,
            "old": -cost,
            "zero": 0.0,
            "one": 1.0 if reached else -cost,
            "one and zero": float(reached),
            "last": 0.0 if t == last else -cost,
            "state": 0.0 if state == wanted else -cost,
            "inverted": -cost if reached else 0.0,
            "cost": 0.0 if reached else cost,
            "distance": -cost * (next_state ^ wanted).bit_count(),
        }[reward]
        ends = {
            "right": reached,
            "never": False,
            "last": t == last,
            "first": t == first_end,
            "always": True,
            "state": state == wanted,
            "inverted": not reached,
        }[terminated]
        made.append((state, wanted, action, pays, next_state, ends))
    hits = [one for one in made if one[1] == one[4]]
    return {
        "all": made,
        "not the last": made[:-1],
        "only the last": made[-1:],
        "not the first": made[1:],
        "only the first": made[:1],
        "only those that reach it": hits,
        "up to the goal": made[: first_end + 1],
        "backwards": made[::-1],
    }[kept]


FINAL_MISTAKES: Mapping[str, Settings] = {
    "the rewards are the old ones, of a goal that was missed: ask for each step anew whether it reaches the *new*"
    " goal": {"reward": "old"},
    "every step is paid 0; only one that reaches the goal is": {"reward": "zero"},
    "a step that reaches its goal is paid 0, not 1: hindsight keeps the reward of the task": {"reward": "one"},
    "the task pays 0 at the goal and −1 elsewhere, not 1 and 0": {"reward": "one and zero"},
    "an earlier step may reach the same pattern: look for the reward at every next state, not at the last one only": {
        "reward": "last"
    },
    "the reward depends on the *next* state, not on the state before the step": {"reward": "state"},
    "the rewards are the wrong way round: −1 costs, 0 is for the goal": {"reward": "inverted"},
    "a step that misses costs 1: its reward is −1": {"reward": "cost"},
    "the reward counts the switches that are wrong; the task pays the same for every step that misses": {
        "reward": "distance"
    },
    "no step terminates; with the new goal the episode would have ended there, and nothing comes after it": {
        "terminated": "never"
    },
    "not only the last step terminates: an earlier one that reaches the same pattern does as well": {
        "terminated": "last"
    },
    "not only the first step that reaches the goal terminates: a later one that reaches it again does as well": {
        "terminated": "first"
    },
    "every step terminates; only one that reaches the goal does": {"terminated": "always"},
    "a step terminates when its *next* state is the goal, not its state": {"terminated": "state"},
    "`terminated` is the wrong way round: True where the goal is reached": {"terminated": "inverted"},
    "the goal is the last *next* state, not the state before the last step": {"goal": "before"},
    "the goal is what the *last* step achieved, not the first": {"goal": "first"},
    "the goal is the start of the episode; take what its last step achieved": {"goal": "start"},
    "each step has another goal, the one that it achieves itself; 'final' has one goal for the whole episode": {
        "goal": "own"
    },
    "the last step is missing": {"kept": "not the last"},
    "only the last step is there; the others are learned for the new goal too": {"kept": "only the last"},
    "the first step is missing; it has the index 0": {"kept": "not the first"},
    "only the steps that reach the goal are there; the others are learned for it too": {
        "kept": "only those that reach it"
    },
    "only the first step is there: is the `return` inside of the loop?": {"kept": "only the first"},
    "the steps after the first that reaches the goal are missing: learn all of them": {"kept": "up to the goal"},
    "the steps come in reverse order; keep the order of the episode": {"kept": "backwards"},
    "`is` asks whether two numbers are the same object, and large ones that are equal need not be: write `==`": {
        "alike": "the same object"
    },
}
ANOTHER_ORDER = "the entries stand in another order; it is (state, goal, action, reward, next_state, terminated)"
STEPS_IN_ANOTHER_ORDER = "the transitions are right, and do not stand in the order of the episode"
ENTRIES = ("state", "goal", "action", "reward", "next_state", "terminated")
NO_USUAL_EPISODE = "that is none of the usual mistakes, so go through the episode by hand, step by step"


def typed(entries: Sequence[Any]) -> Transition:
    """Return the six entries of a transition as numbers, however they were given."""
    state, goal, action, reward, next_state, terminated = entries
    return int(state), int(goal), int(action), float(reward), int(next_state), bool(terminated)


def why_relabelled(cases: Sequence[Sequence[Step]], found: Sequence[list[Transition]], cost: float) -> str:
    """Return the mistake that explains all episodes, or two mistakes together."""
    if nobody_asks_why():
        return NO_USUAL_EPISODE

    def fits(change: Settings) -> bool:
        return all(relabelled(steps, **change, cost=cost) == mine for steps, mine in zip(cases, found, strict=True))

    for sentence, change in FINAL_MISTAKES.items():
        if fits(change):
            return sentence
    for (one, first), (two, second) in combinations(FINAL_MISTAKES.items(), 2):
        if not first.keys() & second.keys() and fits({**first, **second}):
            return f"{one}; and {two}"
    right = [relabelled(steps, cost=cost) for steps in cases]
    for order in permutations(range(6)):
        if found == [[typed([one[k] for k in order]) for one in made] for made in right]:
            return ANOTHER_ORDER
    if [sorted(made) for made in right] == [*map(sorted, found)]:
        return STEPS_IN_ANOTHER_ORDER
    if [*map(len, right)] != [*map(len, found)]:
        return NO_USUAL_EPISODE
    pairs = [pair for one, other in zip(right, found, strict=True) for pair in zip(one, other, strict=True)]
    differ = [name for k, name in enumerate(ENTRIES) if any(one[k] != other[k] for one, other in pairs)]
    if len(differ) > len(ENTRIES) / 2:
        return NO_USUAL_EPISODE
    return f"{NO_USUAL_EPISODE}; over all episodes {' and '.join(differ)} {'differ' if differ[1:] else 'alone differs'}"
