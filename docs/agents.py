"""Write the page of the agents, `docs/agents.md`: which agent works with which environment.

It also writes the ranking into the page of the challenge for a class, `docs/class-challenge.md`.

The figures are those of the stored profiles, which `edugym profile --all` makes again where their code has changed.

    python docs/agents.py            write both
    python docs/agents.py --check    write nothing; fail if one is out of date
"""

import argparse
import json
import re
import sys
from dataclasses import replace
from pathlib import Path
from textwrap import fill

from edugym import Profile
from edugym.adapters.registration import find, in_course_order
from edugym.experiments.profiles.report import NO_LINE, TAKE
from edugym.experiments.profiles.tables import (
    NO_MATTER,
    absent,
    method,
    reasons,
    repetitions_of,
    take_table,
    with_margin,
)
from edugym.experiments.profiles.verdicts import broken_between, good_agents, listed
from edugym.experiments.profiles.words import WITHOUT_LADDER, written
from edugym_course import agent_profiles, one_table
from edugym_course.lab.records import number_of
from edugym_course.remedies import what_helps

CHALLENGE = Path(__file__).parent / "class-challenge.md"
RANKING = re.compile(r"(<!-- ranking: [^\n]* -->\n).*?(<!-- end of ranking -->)", re.DOTALL)
"""What is between two lines of that page."""
PAGE = Path(__file__).parent / "agents.md"
NOTEBOOKS = Path(__file__).parents[1] / "notebooks"
MEASURED = Path(__file__).parent / "isolation.json"
"""What every remedy gains, as `isolation.py` has measured it."""

SETTING = """Each agent trains on each rung of the ladder, with the same number of steps as all others. A score of 1
means that it then plays each of them as well as can be, 0 that it plays no better than at random. All agents have
their default settings: nothing is tuned, so a low score does not mean that the agent cannot learn the task. (One
exception: on Trashbot, `GaussianActorCritic` has tiles over the wrist and what it holds only.) Agents with features
or a network see an observation as a vector, the others as a row of their table. SB3 stands for Stable-Baselines3 and
sb3-contrib: their agents are made as `PPO("MlpPolicy", env)` is, play one copy, and take as many steps as the others
and no more."""
YOURS = """`edugym profile my_agent.py:MyAgent` measures the same for an agent of yours, and shows it beside these
([how to read a profile](profiles.md)); `edugym profile "QLearning + FrameStack(4) + Hashed(100000)"` does it for an
agent with wrappers. Where no agent does well, a wrapper may be missing: see [what every remedy gains](isolation.md)."""
SCORES = """The score, and how far its 95 % interval reaches to both sides; *runs* says how often each rung was climbed.
**Bold** are the highest score of a challenge, and those that are not surely worse. A score a little above 1 is
luck: the best play is known on average, and an agent plays a limited number of episodes. Three runs tell little, so
their intervals are wide. A dash: the agent cannot enter; the reasons are below. A question mark: it is not measured."""
MORE = "Where a line says “and 7 more”, the table of scores below has the names of all, in bold."
SAME = """Older versions can stand here, since only agents whose code has changed are measured again. A hash of the
code of agent, task and training says so; what was made from other code is listed at the end.""".replace("\n", " ")
BREAKS = """How strong a challenge may become for an agent: the two rungs between which its mean score first falls below
0.5. *At once*: it is below 0.5 on the easiest rung. *Never*: on none."""
COUNTS_THERE = {
    "Bandit": """What counts is the regret, what learning has cost until then, and a score after the training does not
show it.""",
    "Casino": """What counts is how often an agent goes in while it learns ([its page](environments/casino.md)).""",
    "Diver": """No single return says how good an agent is there. What counts is how
many of the nine treasures it can find. Agents that learn a weighted sum can find 9, 8, 6, 4 and 2 of them at the
concavities 0, 0.25, 0.5, 0.75 and 1, whatever the weights; Chebyshev and Pareto Q-learning find all nine ([several
objectives](several-objectives.md)).""",
}
"""What counts in an environment that has none."""


def page(profile: Profile, stale: dict[str, list[str]], libraries: str = "") -> str:
    """Return the page.

    Args:
        profile: the stored one.
        stale: for each agent, the challenges that were not measured with the present code.
        libraries: the versions of libraries with which their agents were measured.
    """
    names = profile.challenges
    links = {name: f"[{name}](environments/{name.lower()}.md)" for name in names}
    heading, take = take_table(replace(profile, agents=()), profile)  # all names would make rows of many lines
    take = [[problem, links[name], *rest, remedy(name, rest) or far] for problem, name, *rest, far in take]
    scores = [
        [agent, str(repetitions_of(profile, agent)), *(score(profile, agent, name) for name in names)]
        for agent in profile.agents
    ]
    breaks = [[agent, *(breaking(profile, agent, name) for name in names)] for agent in profile.agents]
    rungs = [f"{each.name}: {each.strength}, from {written(each.strengths[0])}" for each in profile.ladders]
    rungs = [f"{text} to {written(each.strengths[-1])}" for text, each in zip(rungs, profile.ladders, strict=True)]
    missing = [entry.name for entry in in_course_order() if entry.name not in names]
    everywhere = [agent for agent, challenges in stale.items() if set(challenges) >= set(names)]
    old = [f"{agent}: {', '.join(stale[agent])}" for agent in stale if agent not in everywhere]
    old += [f"{listed(everywhere)}: everywhere"] if everywhere else []
    return "\n".join(
        [
            "# Which agent works with which environment",
            "",
            fill(f"{agent_profiles.with_ladders()} {SETTING}", 120),
            "",
            fill(YOURS, 120),
            "",
            "## Which agent to take",
            "",
            fill(f"{TAKE} {MORE} {NO_LINE}", 120),
            "",
            *table(heading, take),
            "",
            "## Scores",
            "",
            fill(SCORES, 120),
            "",
            *table(["", "runs", *names], scores),
            "",
            "## Where they break",
            "",
            fill(BREAKS, 120),
            "",
            fill(f"{'; '.join(rungs)}.", 120),
            "",
            *table(["", *names], breaks),
            "",
            "## Who cannot enter",
            "",
            *(f"- {sentence}" for sentence in reasons(profile)),
            "",
            "## How it was measured",
            "",
            *(f"- {sentence}" for sentence in method(profile)),
            f"- Measured with {agent_profiles.made_with()}, by `edugym profile --all`. {SAME}",
            *([f"- SB3 agents: measured with {libraries}, by `edugym profile --libraries`."] if libraries else []),
            *(fill(f"- {name} has no ladder{why_none(name)}", 120) for name in missing),
            *([f"- Missing, or made from earlier code: {'; '.join(old)}."] if old else []),
            "",
        ]
    )


def remedy(challenge: str, cells: list[str]) -> str:
    """Return what helps in a challenge in which no agent is good, with where this was measured; else ""."""
    helps = what_helps(challenge, json.loads(MEASURED.read_text(encoding="utf-8"))) if NO_MATTER in cells else ""
    if not helps:
        return ""
    number = find(challenge).lesson
    [lesson] = [path.name for path in NOTEBOOKS.glob("*.ipynb") if number_of(path.stem) == number]
    return f"{helps} ([measured](isolation.md), [lesson {number}](../notebooks/{lesson}))"


def why_none(environment: str) -> str:
    """Return why an environment has no ladder, and what counts there, after its name."""
    why = WITHOUT_LADDER.get(environment)
    return f": {why}. {COUNTS_THERE[environment]}" if why else " yet."


def table(heading: list[str], rows: list[list[str]]) -> list[str]:
    """Return the lines of a table."""
    lines = ["| " + " | ".join(row) + " |" for row in [heading, *rows]]
    return [lines[0], "|---" * len(heading) + "|", *lines[1:]]


def with_ranking(text: str, profile: Profile) -> str:
    """The page of the challenge for a class, with the ranking of the package's agents."""
    places = one_table.of_package(profile, [ladder.name for ladder in one_table.ladders()])
    lines = "\n".join(table(*one_table.ranking_table(places)))
    return RANKING.sub(rf"\g<1>{lines}\n\g<2>", text)


def score(profile: Profile, agent: str, challenge: str) -> str:
    """Return a score as it is shown."""
    found = profile.score(agent, challenge)
    if not found.n:
        return absent(profile, agent, challenge)
    text = with_margin(found)
    return f"**{text}**" if agent in good_agents(profile, challenge) else text


def breaking(profile: Profile, agent: str, challenge: str) -> str:
    """Return where an agent breaks as it is shown."""
    found = profile.breaks(agent, challenge)
    if found is None:
        return absent(profile, agent, challenge)
    rungs = broken_between(profile, agent, challenge)
    return "–".join(map(written, rungs)) if rungs else found.where


def main() -> int:
    """Run the command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing, and fail if a page is out of date")
    options = parser.parse_args()
    profile = agent_profiles.load()
    if profile is None:
        print(f"{agent_profiles.PATH} is missing: run edugym profile --all", file=sys.stderr)
        return 1
    parts = agent_profiles.stale() | agent_profiles.stale_of_libraries(installed=False)
    stale = {agent: [ladder.name for ladder in ladders] for agent, ladders in parts.items()}
    challenge = CHALLENGE.read_text(encoding="utf-8")
    texts = {PAGE: page(profile, stale, agent_profiles.libraries_with()), CHALLENGE: with_ranking(challenge, profile)}
    if not options.check:
        for path, text in texts.items():
            path.write_text(text, encoding="utf-8")
        return 0
    old = [path.name for path, text in texts.items() if path.read_text(encoding="utf-8") != text]
    if old:
        print(
            f"{listed(old)} is out of date: run edugym profile --all if code has changed, then python docs/agents.py",
            file=sys.stderr,
        )
    return 1 if old else 0


if __name__ == "__main__":
    sys.exit(main())
