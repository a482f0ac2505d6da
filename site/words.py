"""What the website says of each environment to somebody who knows nothing of the field.

The field's own words stand beside these: the challenge in the registry, and the answer to "why?" in the lesson.
"""

import re
from collections.abc import Callable
from typing import Any, NamedTuple

Buttons = list[list[str]]
"""What the actions are called where somebody plays: a list for each observation, or one list for all. An action with
the name "" is of no use there."""


def named(*names: str) -> Callable[[Any], Buttons]:
    """The same names at every strength, and for every observation."""
    return lambda mdp: [list(names)]


def counted_from_one(name: str) -> str:
    """The name of an action as the pictures of the page have it: arm 0 is the first, so it is "arm 1".

    Doors keep their numbers, as the lesson and the pictures of the task have them.
    """
    return re.sub(r"^(arm|grip|switch) (\d+)$", lambda found: f"{found[1]} {int(found[2]) + 1}", name)


def by_name(mdp: Any) -> Buttons:
    """The names that the task gives them, counted from 1."""
    return [[counted_from_one(name) for name in mdp.action_names]]


def _in_the_casino(mdp: Any) -> Buttons:
    """In the street one goes in or home, and one button is enough to go home; at home nothing is left to do."""
    n = len(mdp.action_names)
    machines = [f"machine {k + 1}" if k < mdp.n_machines else "" for k in range(n)]
    return [["go in", "go home", *[""] * (n - 2)], machines, [""] * n]


def _letters(name: str, n: int, *more: str) -> Callable[[Any], dict[str, list[str]]]:
    return lambda mdp: {name: [*(chr(ord("A") + k) for k in range(n)), *more]}


def _marks(mdp: Any) -> dict[str, list[str]]:
    return {"mark": [*(chr(ord("A") + k) for k in range(mdp.num_doors)), "none"]}


def _as_numbers(mdp: Any) -> dict[str, list[str]]:
    return {}


class Words(NamedTuple):
    """The words for one environment.

    Attributes:
        challenge: what makes it hard, in a few words.
        why: what the race shows, and why, without any word of the field.
        strength: what the slider of the strength is called.
        fields: what the coloured fields in the picture are, where that is not plain to see.
        buttons: from the task, what its actions are called where somebody plays.
        codes: from the task, letters for numbers of an observation that count nothing, so that nobody takes them for
            the numbers of actions: for the name of such a number, a letter for each value.
        rule: where the best possible return is not known, a simple way to play, to compare with: what somebody does who
            plays so, and the action by the number of the observation.
    """

    challenge: str
    why: str = ""
    strength: str = ""
    fields: str = ""
    buttons: Callable[[Any], Buttons] = by_name
    codes: Callable[[Any], dict[str, list[str]]] = _as_numbers
    rule: tuple[str, Callable[[int], int]] | None = None


WORDS = {
    "Boulder": Words(
        "To find the one place that pays, among very many that do not.",
        "Below the top nothing tells a climber that it is on the right way. Somebody who only tries at random must "
        "guess every grip of a climb right. On a wall of fifteen, with two grips at each height, that happens in one "
        "of 32 768 climbs. To try what may not be best, in order to find out more, is called exploration. The others "
        "explore on purpose, where they have rarely been or what they have not tried, and need far fewer climbs.",
        "height of the wall",
        buttons=lambda mdp: [["left grip", "right grip"]] if mdp.n_grips == 2 else by_name(mdp),
    ),
    "Roadrunner": Words(
        "To run fast beside a cliff, when you still stumble now and then.",
        "While they learn, all runners sometimes make a move at random. SARSA counts in that it may stumble, and "
        "learns to run with care. Q-learning learns the fastest run for somebody who never stumbles. The games "
        "that count here are played without random moves, so the fastest run is the best.",
        "length of the road",
        "Each column is a place on the road. The higher a field lies, the faster the runner is there.",
    ),
    "Study": Words(
        "To find out which of many days earned the reward at the end.",
        "The mark comes only after the exam, and says nothing of the days before. Who hands the news back by one day "
        "at a time needs many terms until the first day hears of it; who hands it to all days at once learns sooner. "
        "But then the news also holds what was tried only at random, so in the end the slow way may do better.",
        "days until the exam",
        "In each day of the calendar: to the right more energy, upwards more knowledge.",
        named("study", "sleep", "go out", "something else", "another thing"),
    ),
    "Catch": Words(
        "To recognise what you see, when it never looks the same twice.",
        "The light is new at every step, so no picture comes twice. Who keeps a list of pictures never finds the one "
        "that it sees. Who works with the brightness of single dots can use what it has learned in other light.",
        "width of the board",
    ),
    "MemoryCorridor": Words(
        "To remember what you can no longer see.",
        "On the way back to the end no door is marked any more, so who sees only what is there now must guess. Who "
        "also remembers the last few things that it saw and did gets some doors farther, as far as its memory "
        "reaches.",
        "doors at each place",
        "On each door: the door that it would open when this one is marked. On the floor: when none is marked.",
        codes=_marks,
    ),
    "Tamagotchi": Words(
        "To do the right thing when you are told only half of the truth.",
        "The agents know the toy only by what it says, and a wrong word leads everybody astray who obeys. Who "
        "remembers what it has just done has a second hint: who was fed just now is hardly hungry. But it has far "
        "more to learn, so it is slower.",
        "noise of its words (τ)",
        "On the screen each field is something that the agent can hear: downwards another word, to the right more hit "
        "points.",
        codes=_letters("word", 4),
        rule=("always does what the word says", lambda seen: seen % 4),  # the word changes fastest
    ),
    "Trashbot": Words(
        "To move an arm, which can turn by any angle.",
        "The arm can turn by any angle, and an agent that keeps a list has to choose a few of them. With few angles "
        "there is little to try, but the best of a few may not be good enough. With many there is much more to try: "
        "nine angles for each of the two joints make 81 moves.",
        "width of the container",
        "Each field is a place of the hand.",
    ),
    "Golf": Words(
        "To choose when the same hit ends in another place each time.",
        "The harder the hit, the less one knows where the ball comes down. The three differ in how much a bad "
        "surprise counts for them. Who fears it keeps away from risks, also where the risk would pay off on average.",
        "how far a hit may miss",
        buttons=named("putt (short)", "chip", "drive (far)"),
    ),
    "Supermarket": Words(
        "To learn from few tries, by thinking about what was tried.",
        "Q-learning uses each step once, when it happens. The others remember what their steps did, and go through "
        "them again in thought between two real ones. So they shop well after far fewer real steps. "
        "With many more steps Q-learning gets there, too, and may then be the best.",
        "most steps of a visit",
    ),
    "Switches": Words(
        "To learn from a miss: you did reach something, if not what you wanted.",
        "Most tries end with the wrong switches, and teach nothing to who looks only at the goal that was set. Two of "
        "these agents say afterwards: what I have reached could have been the goal, and this is how one gets there. "
        "So they have more to learn from. With few switches, where luck often hits the goal anyway, it hardly helps.",
        "number of switches",
        "The fields below the switches: how many are wrong, from the left none, one, two, and so on.",
    ),
    "Diver": Words(
        "To want two things at once, a treasure and enough air.",
        "Two agents pay a fixed price for each step. Where the treasures in the middle are poor, none of them is ever "
        "the best bargain, whatever the price: a deeper one or the first is. Who looks at treasure and time one by "
        "one can choose one.",
        "how poor the middle is (concavity)",
    ),
    "Casino": Words(
        "Not to take luck for skill.",
        "Of ten machines that were tried a few times, some have paid well by luck. Q-learning believes the one that "
        "looks best, so the casino seems to pay, and it goes in. The others doubt what looks best, so luck fools them "
        "less.",
        "number of machines",
        buttons=_in_the_casino,
        codes=_letters("place", 3),
    ),
    "Bandit": Words(
        "To choose between trying something new and what was good so far.",
        "A machine that has paid a few times may only have been lucky. Who plays the best so far and nothing else may "
        "never find the best of all. So the first three agents here also try others: now and then at random, or "
        "because they hope for much from each machine until they know it.",
        "lead of the best machine",
    ),
}
"""By the names of the environments."""
