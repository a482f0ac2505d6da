"""A page for each agent, from its docstring, its code, the lessons that use it, and its stored profile."""

import ast
import inspect
import json
import re
import sys
from collections.abc import Iterator
from functools import cache
from typing import Any
from urllib.parse import urlencode

from docstrings import described, markdown, source, summary
from ladders import ladder
from lesson_pages import Lesson
from races import RACES
from repository import REF, REPOSITORY, ROOT

import edugym
from edugym import Profile
from edugym.experiments.profiles.tables import with_margin
from edugym.experiments.profiles.verdicts import good_agents, listed, outcome
from edugym_course import agent_profiles
from edugym_course.remedies import REMEDIES, when_to_take

PAGE = """\
# {name}

{equation}

## The code that runs

{code}

The whole file: [`{path}`]({repository}/blob/{ref}/{path}).

{details}

## What it is good at

{ladders} A score of 1 means that {name}, at its defaults, learns to play a task as well as can be, 0 that it plays no
better than at random. (A little above 1 is luck.) The number behind the name of an environment is the mean over its
ladder, with a 95 % interval. Grey lines are the other agents. [All agents side by side](index.md) says how this was
measured.

### When to take it

{take}

### Its ladders

::::{{container}} ladders

{profile}

::::

## In the playground

{races}

## In the lessons

{lessons}

## Reference

{reference}
"""
NO_RACE = "It is in no race of the playground."
NO_VALUES = " The pictures there show what an agent expects of each action, and this one has preferences instead."
WHY_NOT = {
    "GaussianActorCritic": " The pictures there show what an agent expects of each of a few actions. Those of this one"
    " are real numbers.",
    "HindsightDQN": " It is for more goals than a table holds, and the playground has no more than five switches.",
    "UCT": " It learns nothing that could be watched: it searches anew before each action.",
}
SHOWN = ("learn", "act")
"""The methods that are the algorithm."""

AGENTS: dict[str, Any] = {name: getattr(edugym, name) for name in agent_profiles.agents()}


def place(kind: Any) -> str:
    """Return the page of an agent, such as "agents/q_learning"."""
    return f"agents/{kind.__module__.rpartition('.')[2]}"


def pages(lessons: list[Lesson]) -> dict[str, str]:
    """Return the pages of all agents, in Markdown."""
    return {place(kind): page(name, kind, lessons) for name, kind in AGENTS.items()}


def page(name: str, kind: Any, lessons: list[Lesson]) -> str:
    """Return the page of an agent."""
    code = "\n\n\n".join([*map(source, (vars(kind)[method] for method in SHOWN)), *helpers(kind)])
    equation, attributes, details = markdown(kind).partition("**Attributes**")
    path = f"src/{kind.__module__.replace('.', '/')}.py"
    return PAGE.format(
        name=name,
        equation=equation,
        details=attributes + details,
        code=f"```python\n{code}\n```",
        path=path,
        repository=REPOSITORY,
        ref=REF,
        ladders=agent_profiles.with_ladders(),
        take=" ".join(_taken(name)),
        profile="\n\n".join(_fares(name)),
        races="\n".join(_raced(kind)) or NO_RACE + WHY_NOT.get(name, NO_VALUES * ("preferences" in kind._fields)),
        lessons="\n".join(_used(name, lessons))
        or "No lesson uses it. Try it in one of them, in place of another agent.",
        reference=described(name, kind, docstring=summary(kind)),
    )


def helpers(kind: Any) -> Iterator[str]:
    """Yield the source of what the algorithm calls: methods of the agent, and functions of the room of agents."""
    module, seen, todo = sys.modules[kind.__module__], set(SHOWN), [vars(kind)[method] for method in SHOWN]
    while todo:
        function = todo.pop(0)
        for node in ast.walk(ast.parse(source(function))):
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "self":
                label, found = node.attr, vars(kind).get(node.attr)
            elif isinstance(node, ast.Name):
                label, found = node.id, vars(module).get(node.id)
            else:
                continue
            if label not in seen and inspect.isfunction(found) and found.__module__.startswith("edugym.agents."):
                seen.add(label)
                todo.append(found)
                yield source(found)


def _fares(name: str) -> Iterator[str]:
    """How an agent fares in each environment: a sentence and a picture, or why it cannot enter."""
    stored = _stored()
    for challenge in stored.challenges:
        link = f"**[{challenge}](../environments/{challenge.lower()}.md)**"
        about, score = stored.ladder(challenge), stored.score(name, challenge)
        if score.n == 0:
            why = stored.blank[name].get(challenge)
            says = f"it cannot enter: {why}." if why else "it is not measured."
            yield f":::{{container}} ladder\n{link}, {about.challenge}: {says}\n:::"
            continue
        words = f"it {outcome(stored, name, challenge).of_one}."
        beside = _beside(name, challenge)
        picture = ladder(stored, name, challenge, f"{challenge}: {words} {beside}")
        sentence = f"{link}, {about.challenge}: {with_margin(score)}; {words} {beside}"
        yield f":::{{container}} ladder\n{sentence}\n\n{picture}\n:::"


def _beside(name: str, challenge: str) -> str:
    """Say who does better in a challenge; nobody is named where nobody is good."""
    best = _best(challenge)
    if not best:
        return "No agent is good here."
    return "No agent does surely better." if name in best else f"The best is {best[0]}."


def _taken(name: str) -> Iterator[str]:
    """Say where to take an agent: where nobody does surely better, and what it gains as a remedy."""
    where = [challenge for challenge in _stored().challenges if name in _best(challenge)]
    yield (
        f"In {listed(where)} no agent does surely better."
        if where
        else "Where some agent is good, another one does surely better."
    )
    if remedy := [*when_to_take(name, json.loads((ROOT / "docs/isolation.json").read_text(encoding="utf-8")))]:
        yield from remedy
        yield "([How this was measured](../guides/isolation.md).)"
    for text in (other_measure(each.own) for each in REMEDIES if each.agent == name):
        yield text and f"\n\nThe score does not show it all. {text}"


def other_measure(environment: str) -> str:
    """The paragraph on an environment in which the score is not what the challenge is about; "" where there is none."""
    text = (ROOT / "docs/isolation.md").read_text(encoding="utf-8")
    found = re.search(rf"^\*\*{environment}\*\* .*?(?=\n\n)", text, re.MULTILINE | re.DOTALL)
    return found[0] if found else ""


@cache
def _stored() -> Profile:
    """The stored profiles; the website needs them."""
    found = agent_profiles.load()
    assert found is not None
    return found


@cache
def _best(challenge: str) -> list[str]:
    """The agents to take for a challenge: none where not even the best is good."""
    return good_agents(_stored(), challenge)


def _raced(kind: Any) -> Iterator[str]:
    """The races in which an agent can run: it is one of the first three there, or takes the place of one."""
    for race in RACES:
        found = [k for k, agent in enumerate(race.agents) if agent.kind is kind]
        if found:
            racing = "0.1.2" if found[0] < 3 else f"{found[0]}.0.1"
            where = urlencode({"task": race.environment, "agents": racing})
            called = " and ".join(f"“{race.agents[k].label}”" for k in found)
            other = " There it gets other observations or actions than on the ladder, which it cannot enter."
            link = f'<a href="../playground/index.html#{where}">{race.environment}</a>'
            yield f"- {link}, where it is called {called}.{other * _cannot_enter(kind.__name__, race.environment)}"


def _cannot_enter(name: str, environment: str) -> bool:
    """Whether there is a ladder in an environment that an agent cannot enter."""
    return environment in _stored().blank.get(name, {})


def _used(name: str, lessons: list[Lesson]) -> Iterator[str]:
    """The lessons that name an agent, or train it in a function of their own."""
    for lesson in lessons:
        if re.search(rf"\b{name}\b", lesson.text + _functions(lesson.name)):
            yield f"- [{lesson.title}](../lessons/{lesson.name}.md)"


@cache
def _functions(lesson: str) -> str:
    """The code in the folder of a lesson, without that of exercises."""
    [text] = (ROOT / "src/edugym_course/lessons").glob(f"*/{lesson}.py")
    files = [path for path in text.parent.glob("*.py") if path.name not in ("exercises.py", "project.py")]
    return "\n".join(path.read_text(encoding="utf-8") for path in sorted(files))
