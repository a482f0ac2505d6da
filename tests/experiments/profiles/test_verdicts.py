"""What a profile says in words, from scores that are given by hand."""

from collections.abc import Mapping
from typing import Any

import pandas
import pytest

from edugym import Ladder, Profile
from edugym.experiments.profiles import report, tables
from edugym.experiments.profiles.ladders import LADDERS, checked, rung_in_words
from edugym.experiments.profiles.pictures import named_ends
from edugym.experiments.profiles.scores import COLUMNS, pooled
from edugym.experiments.profiles.verdicts import best_agents, said
from edugym.experiments.profiles.words import Words

WALL = next(ladder for ladder in LADDERS if ladder.name == "Boulder")._replace(strengths=(10, 20, 40))
FEW_STEPS = next(ladder for ladder in LADDERS if ladder.name == "Supermarket")._replace(strengths=(400, 200, 100))


def profiled(
    scores: Mapping[str, tuple[float, ...]], ladder: Ladder = WALL, blank: dict[str, dict[str, str]] | None = None
) -> Profile:
    """A profile in which each agent has these scores on the three rungs, in both of its runs."""
    rows = [
        {"agent": agent, "challenge": ladder.name, "strength": strength, "repetition": number, "score": score}
        for agent, found in scores.items()
        for strength, score in zip(ladder.strengths, found, strict=True)
        for number in range(2)
    ]
    names = (*scores, *(name for name in blank or {} if name not in scores))
    return Profile(pandas.DataFrame(rows, columns=list(COLUMNS)), (ladder,), names, blank or {})


FAR, MIDDLE, NEARER, LOW = (1.0, 1.0, 1.0), (1.0, 0.5, 0.0), (0.9, 0.1, 0.0), (0.1, 0.0, 0.0)


@pytest.mark.parametrize(
    ("scores", "sentence"),
    [
        ({"A": MIDDLE}, "A breaks at a wall of height between 20 and 40."),
        (
            {"C": NEARER, "D": LOW, "A": FAR, "B": MIDDLE},
            "A gets furthest: it masters even a wall of height 40. B breaks at a wall of height between 20 and 40 and C"
            " between 10 and 20. D fails even at a wall of height 10.",
        ),
        ({"A": FAR, "B": FAR}, "A and B master even a wall of height 40."),
        ({"A": (1.0, 0.9, 0.6), "B": LOW}, "A gets furthest: it does not break even at a wall of height 40. B fails"),
        (
            {"B": MIDDLE, "A": (1.0, 0.4, 1.0)},
            "A breaks at a wall of height between 10 and 20 and B between 20 and 40.",  # A has the higher score
        ),
    ],
)
def test_how_far_each_agent_gets(scores: dict[str, Any], sentence: str) -> None:
    """The one with the highest score comes first, and is said to get furthest only if it surely does."""
    assert said(profiled(scores), "Boulder").sentence.startswith(sentence)


def test_fewer_steps_do_not_break_an_agent() -> None:
    """Where the strength is the number of steps, an agent needs some."""
    scores = {"A": FAR, "B": MIDDLE, "C": NEARER, "D": LOW, "E": (1.0, 0.8, 0.6)}
    assert said(profiled(scores, FEW_STEPS), "Supermarket").sentence == (
        "A gets furthest: it masters it even with 100 training steps. E does not break even with 100 training steps. B"
        " needs between 100 and 200 training steps to score 0.5 and C between 200 and 400. D fails even with"
        " 400 training steps."
    )


def test_who_cannot_enter_and_who_is_not_measured() -> None:
    """Neither is ahead of anybody, so nobody gets furthest beside them."""
    found = profiled({"A": FAR}, blank={"B": {"Boulder": "no hands"}, "C": {}})
    sentence = "A masters even a wall of height 40. B cannot enter. C is not measured."
    assert said(found, "Boulder").sentence == sentence


def test_reasons_that_differ_only_in_numbers_share_a_sentence() -> None:
    """It has the numbers of the first challenge, and says so."""
    blank = {"B": {"Boulder": "needs 9 hands", "Study": "needs 13 hands", "Golf": "no arm"}, "C": {"Golf": "no arm"}}
    alike, other = tables.reasons(profiled({"A": FAR}, blank=blank))
    assert alike == "B in Boulder and Study: needs 9 hands. These are the numbers of Boulder."
    assert other == "B and C in Golf: no arm."


def test_a_better_agent_beside_is_named_with_how_far_it_gets() -> None:
    """In the sentence and in the table of whom to take; where nobody here enters too."""
    beside = profiled({"A": FAR, "B": MIDDLE})
    better = "is better: it masters even a wall of height 40."
    assert said(profiled({"B": MIDDLE}), "Boulder", beside).sentence.endswith(f"A, one of the other agents, {better}")
    assert "other" not in said(profiled({"B": FAR}), "Boulder", beside).sentence
    blank = {"D": {"Boulder": "no hands"}}
    two = profiled({"F": FAR, "B": MIDDLE})
    assert said(two, "Boulder", beside).sentence.startswith("Of those that you gave, F gets furthest")
    nobody = said(profiled({}, blank=blank), "Boulder", beside).sentence
    assert nobody == "D cannot enter. A, one of the other agents, masters even a wall of height 40."
    problem, far = "a reward that random play hardly ever finds", "masters even a wall of height 40"
    here = profiled({"B": MIDDLE})
    row = tables.take_table(here, pooled(here, beside))[1][0]
    assert row == [problem, "Boulder", "A 1.00 (of 2 tried)", "nobody", far]
    six = dict.fromkeys("ABCDEF", FAR)
    assert tables.take_table(profiled(six))[1][0][3] == "B, C, D, E and F"
    here = profiled({"F": FAR})
    assert tables.take_table(here, pooled(here, profiled(six)))[1][0][2:4] == [
        "F 1.00 (of 6 tried)",
        "A, B, C and 2 more",
    ]
    assert tables.take_table(profiled({}, blank=blank))[1][0][2:] == ["nobody can enter", "–", "–"]
    rows = tables.table_of_all(profiled(six | {"G": LOW}))[1]
    assert [(agent, "*" in score) for agent, score in rows] == [*((agent, True) for agent in six), ("G", False)]


def test_the_report_says_what_each_challenge_is() -> None:
    """In its page and in Markdown; the page names every line, and labels the cells for narrow screens."""
    found = profiled({"B & C": MIDDLE})
    everybody, abouts = pooled(found, profiled({"A": FAR})), {"A": "It climbs.", "D": "It does not."}
    for text in (report.markdown(found, everybody, abouts), report.as_html(found, everybody, abouts)):
        assert "A: It climbs." in text
        assert "It does not." not in text
        assert WALL.words.about in text
        assert WALL.words.problem in text
    page = report.as_html(found, everybody)
    assert "<title>A</title>" in page
    assert "<title>B &amp; C</title>" in page
    assert '<td data-label="highest score">A 1.00 (of 2 tried)</td>' in page


def test_every_ladder_has_words() -> None:
    """A problem, sentences, and a rung with a place for its strength."""
    for ladder in LADDERS:
        words = ladder.words
        assert words.problem
        assert words.about.endswith(".")
        assert words.rung.count("{}") == 1, ladder.name
    assert len({ladder.words.problem for ladder in LADDERS}) == len(LADDERS)


def test_a_ladder_of_ones_own_needs_no_words() -> None:
    """Then its rungs have their strength, and what it is; words that are none are refused."""
    own = WALL._replace(words=Words())
    assert rung_in_words(own, 14.0) == "the rung 14 (height of the wall)"
    assert tables.take_table(profiled({"A": FAR}, own))[1][0][0] == "exploration"
    checked(own)
    for wrong, says in (("a wall", "words must be Words"), (Words(about=3), r"words\.about must be a text")):  # type: ignore[arg-type]
        with pytest.raises(ValueError, match=says):
            checked(own._replace(words=wrong))  # type: ignore[arg-type]


def test_which_differences_are_sure() -> None:
    """Those that are hardly chance; of each pair what one is better and worse in, in one sentence."""
    both = [
        profiled({"A": scores, "B": MIDDLE, "C": MIDDLE}, ladder) for ladder, scores in ((WALL, FAR), (FEW_STEPS, LOW))
    ]
    runs = pandas.concat([found.runs for found in both])
    assert tables.sure_differences(Profile(runs, (WALL, FEW_STEPS), ("A", "B"))) == [
        "A is surely better than B in Boulder, and surely worse in Supermarket.",
        "All other differences between these agents may be chance.",
    ]
    chance = ["All differences between these agents may be chance."]
    assert tables.sure_differences(Profile(runs, (WALL, FEW_STEPS), ("B", "C"))) == chance
    assert tables.sure_differences(profiled({"A": FAR})) == []
    near = profiled({"A": (0.6, 0.6, 0.6), "B": MIDDLE})
    assert best_agents(near, "Boulder") == ["A"]
    luck = near.runs.score + (near.runs.agent == "A") * (near.runs.repetition - 0.5)  # 0.1 and 1.1
    assert best_agents(Profile(near.runs.assign(score=luck), (WALL,), ("A", "B")), "Boulder") == ["A", "B"]


def test_an_agent_to_take_has_its_weakest_challenge_beside_it() -> None:
    """Where it lies furthest behind the best; none where it is the best everywhere."""
    both = [profiled({"A": a, "B": b}, ladder) for ladder, a, b in ((WALL, FAR, LOW), (FEW_STEPS, LOW, FAR))]
    found = Profile(pandas.concat([one.runs for one in both]), (WALL, FEW_STEPS), ("A", "B"))
    assert [row[-1].partition("; ")[2] for row in tables.take_table(found)[1]] == [
        "weakest in Supermarket (0.03)",
        "weakest in Boulder (0.03)",
    ]


def test_only_agents_on_the_same_rungs_are_pooled() -> None:
    """One with a label that is there already is not taken."""
    here = profiled({"A": FAR})
    assert pooled(here, profiled({"A": LOW, "B": LOW})).scores("A", "Boulder").tolist() == [[1.0, 1.0]] * 3
    assert pooled(here, profiled({"B": LOW})).score("B", "Boulder").n == 2
    for other in ({"strengths": (10, 20, 30)}, {"n_steps": 10}):
        assert pooled(here, profiled({"B": LOW}, WALL._replace(**other))).score("B", "Boulder").n == 0


def test_the_ends_of_grey_lines_that_lie_together_have_one_name() -> None:
    """The first one, and how many more; at most three ends are named."""
    ends = {"A": 1.0, "B": 0.5, "C": 0.95, "D": 0.98, "E": 0.2, "F": -3.0}
    assert named_ends(ends) == [("A + 2", 1.0), ("B", 0.5), ("E", 0.2)]
