"""The report on a profile: one HTML file without requests to other hosts, Markdown, CSV, and a picture."""

import html
import math
import os
import re
from pathlib import Path

from edugym.checks.parameters import a_path
from edugym.experiments.figures.panel import Panel
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.figures.style import save_figure, to_bytes
from edugym.experiments.profiles.ladders import EXACT, steps_of
from edugym.experiments.profiles.pictures import NAMED, Dots, Radar, Rungs, picture
from edugym.experiments.profiles.scores import NEARLY, Profile
from edugym.experiments.profiles.verdicts import (
    Said,
    best_agents,
    better_beside,
    listed,
    others_of,
    outcome,
    said,
)
from edugym.experiments.profiles.words import rounded, written
from edugym.experiments.results.statistics import Interval
from edugym.rendering.palette import INK
from edugym.system.extras import require
from edugym.system.files import write_whole

NAME = "report.html"
"""The report; the other files lie beside it."""
SMALLER = 0.8
"""How large a figure within the page is, beside one of a file."""
STYLE = """\
:root { color-scheme: light dark; --ink: #33313f; --paper: #ffffff; --line: #d8d5de; --soft: #6a6676; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #eceaf2; --paper: #1b1a21; --line: #45424f; --soft: #aaa6b6; }
}
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); max-width: 68rem;
  margin: 2rem auto; padding: 0 1rem; }
h1 { line-height: 1.2; }
h2 { margin-top: 2.5rem; }
h3 { margin-bottom: .3rem; }
.soft { color: var(--soft); }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .7rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 21rem), 1fr)); gap: 1.5rem; }
figure { margin: 0; }
figure svg { width: 100%; height: auto; max-width: 34rem; fill: currentColor; }
.ladders { grid-template-columns: repeat(auto-fit, minmax(min(100%, 26rem), 1fr)); }
.ladders > section { min-width: 0; }
.numbers td:first-child { position: sticky; left: 0; background: var(--paper); }
@media (max-width: 40rem) {
  .cards thead { display: none; }
  .cards tr { display: block; padding: .6rem 0; border-bottom: 1px solid var(--line); }
  .cards td { display: grid; grid-template-columns: 8.5rem 1fr; gap: .6rem; padding: .1rem 0; border: 0; }
  .cards td::before { content: attr(data-label); color: var(--soft); }
  .cards td:first-child { font-weight: 600; }
}
"""


def of_score(score: Interval) -> str:
    """A score with its interval, with two digits; a dash where there is none."""
    if score.n == 0:
        return "–"
    if not math.isfinite(score.low):
        return rounded(score.estimate)
    return f"{rounded(score.estimate)} [{rounded(score.low)},\N{NO-BREAK SPACE}{rounded(score.high)}]"


def score_or_reason(profile: Profile, agent: str, challenge: str) -> str:
    """A score with its interval; a question mark where it is not measured, a dash where the agent cannot enter."""
    score = profile.score(agent, challenge)
    return "?" if score.n == 0 and challenge not in profile.blank.get(agent, {}) else of_score(score)


def with_margin(score: Interval) -> str:
    """A score with the half of its interval, such as 0.37 ± 0.05, which no line break parts."""
    return f"{rounded(score.estimate)} ± {rounded(score.high - score.estimate)}".replace(" ", "\N{NO-BREAK SPACE}")


def take_table(profile: Profile, beside: Profile | None = None) -> tuple[list[str], list[list[str]]]:
    """The heading and the rows of the table that says which agent to take, and how far it gets.

    The agent to take is one of another profile where it is surely better.
    """
    rows = []
    for challenge in profile.challenges:
        about, problem = said(profile, challenge), profile.ladder(challenge).words.problem
        taken, best, of = about.take, best_agents(profile, challenge), profile
        if beside and (better := better_beside(profile, challenge, beside)):
            taken, best, of = f"{better} (one of the others)", [better], beside
        far = f"it {outcome(of, best[0], challenge).of_one}" if best else "–"
        if len(best) > 1:
            far = f"{best[0]} {far.removeprefix('it ')}"
        rows.append([problem or about.isolates, challenge, taken, far])
    return ["your problem has", "challenge", "take", "how far that gets"], rows


def score_table(profile: Profile, beside: Profile | None = None) -> tuple[list[str], list[list[str]]]:
    """The heading and the rows of the table of scores; the best agent of another profile stands beside them."""
    rows = []
    for challenge in profile.challenges:
        scores = [score_or_reason(profile, agent, challenge) for agent in profile.agents]
        others = others_of(profile, beside, challenge)
        best = max(others, key=lambda agent: others[agent]) if others else ""
        known = [f"{best} {rounded(others[best])}" if best else "–"] if beside else []
        rows.append([f"{challenge} ({profile.ladder(challenge).challenge})", *scores, *known])
    return ["challenge", *profile.agents, *(["best of the others"] if beside else [])], rows


def rung_table(profile: Profile, challenge: str) -> tuple[list[str], list[list[str]]]:
    """The heading and the rows of the table of a ladder."""
    strengths = [written(strength) for strength in profile.ladder(challenge).strengths]
    rows = []
    for agent in profile.agents:
        if profile.score(agent, challenge).n:
            steps = profile.steps(agent, challenge)
            reached = written(steps) if math.isfinite(steps) else "never"
            rungs = [rounded(rung.estimate) for rung in profile.rungs(agent, challenge)]
            rows.append([agent, *rungs, reached])
    return [profile.ladder(challenge).strength, *strengths, f"steps to {NEARLY} on the first rung"], rows


def reasons(profile: Profile) -> list[str]:
    """Why agents cannot enter challenges, a sentence for each."""
    return [f"{agent}, {name}: {why}" for agent, blank in profile.blank.items() for name, why in blank.items()]


def repetitions_of(profile: Profile, agent: str) -> int:
    """How often an agent was trained on each rung."""
    return max((profile.score(agent, challenge).n for challenge in profile.challenges), default=0)


def method(profile: Profile) -> list[str]:
    """How everything was measured, a sentence for each thing."""
    counts = {agent: repetitions_of(profile, agent) for agent in profile.agents}
    repetitions = max(counts.values(), default=0)
    fewer = {agent: count for agent, count in counts.items() if 0 < count < repetitions}
    fewer_said = [f"Fewer times: {listed([f'{agent} {count}' for agent, count in fewer.items()])}."] if fewer else []
    bests = [
        f"The best play in {ladder.name} is {ladder.source}." for ladder in profile.ladders if ladder.source != EXACT
    ]
    budgets = (
        "as many training steps as its strength says"
        if ladder.n_steps is None
        else f"{written(steps_of(ladder, ladder.strengths[0]))} training steps a rung"
        for ladder in profile.ladders
    )
    named = ", ".join(f"{ladder.name} {budget}" for ladder, budget in zip(profile.ladders, budgets, strict=True))
    return [
        f"Every agent trained {repetitions} times on every rung of every ladder, each time with another seed and"
        " layout, and was then evaluated without exploring.",
        *fewer_said,
        "A score of 0 is the mean return of random play, 1 that of the best play; below 0 is worse than random play.",
        "The score in a challenge is the mean over the rungs. The intervals are 95 % intervals over the"
        " repetitions. An agent breaks where its mean score first falls below 0.5, interpolated.",
        profile.settings,
        f"The budgets: {named}.",
        f"The best play is {EXACT}, unless said otherwise. {' '.join(bests)}".strip(),
    ]


INTRODUCTION = (
    "For every challenge there is a ladder of tasks, from easy to hopeless. A score of 1 means that an agent plays each"
    " of them as well as can be, 0 that it plays no better than at random. Where its score first falls below 0.5, half"
    " of the way from random to the best play, it breaks."
)
TAKE = (
    "Find the line that is most like your problem, and take an agent that stands there. The first has the highest"
    " score; that the others have less may be chance."
)
OF_OTHERS = "One of the others is not among the agents of this page: its marks are grey."
FURTHER = "Further down stands what the challenge is, and how far each agent gets."
MARKS = (
    "A number is a score with its 95 % interval; – says that an agent cannot enter a challenge, and ? that it was not"
    " measured there. A score a little above 1 is luck: the best play is known on average."
)
STEPS = (
    f"Steps to {NEARLY} are those after which a run first scores that much, the median over the runs; it may lose it"
    " again."
)
OTHER = (
    "Grey marks are other agents, at their defaults: those of EduGym, and those of Stable-Baselines3 (SB3) where they"
    " were measured."
)
GREY = (
    "At the end of grey lines stands the other agent with the highest score of those that end there; + 3 stands for"
    " three more. Rest on a line to see its name."
)


def paragraphs(profile: Profile, about: Said) -> list[str]:
    """What a challenge is, and how far the agents get, as lines of Markdown."""
    task = profile.ladder(about.challenge).words.about
    return [*([task, ""] if task else []), about.sentence, ""]


def markdown(profile: Profile, beside: Profile | None = None) -> str:
    """The report as Markdown; its picture is the file profile.svg beside it."""

    def escape(text: str) -> str:
        return text.replace("|", "\\|").replace("<", "&lt;")

    def table(heading: list[str], rows: list[list[str]]) -> list[str]:
        cells = [[*map(escape, row)] for row in [heading, *rows]]
        lines = ["| " + " | ".join(row) + " |" for row in cells]
        return [lines[0], "|" + "---|" * len(heading), *lines[1:], ""]

    guide = " ".join([TAKE, *([OF_OTHERS] if beside else []), FURTHER])
    lines = [
        "# What the agents master",
        "",
        INTRODUCTION,
        "",
        "## Which agent to take",
        "",
        guide,
        "",
        *table(*take_table(profile, beside)),
        "## Scores",
        "",
        "![Radar, scores with intervals, and ladders](profile.svg)",
        "",
        *table(*score_table(profile, beside)),
        MARKS,
        "",
        "## The challenges",
        "",
        STEPS,
        "",
    ]
    for challenge in profile.challenges:
        about, (heading, rows) = said(profile, challenge, beside), rung_table(profile, challenge)
        lines += [f"### {challenge}: {about.isolates}", "", *paragraphs(profile, about)]
        lines += table(heading, rows) if rows else []
    if reasons(profile):
        lines += ["## Who cannot enter", "", *(f"- {escape(reason)}" for reason in reasons(profile)), ""]
    return "\n".join([*lines, "## How it was measured", "", *(f"- {sentence}" for sentence in method(profile)), ""])


def as_html(profile: Profile, beside: Profile | None = None) -> str:
    """The report as one HTML file, which loads nothing from anywhere; light or dark as the reader's system is."""
    escape = html.escape

    def table(heading: list[str], rows: list[list[str]], kind: str = "cards") -> str:
        labels = [escape(text) for text in heading]
        head = "".join(f"<th>{label}</th>" for label in labels)
        lines = (zip(labels, map(escape, texts), strict=True) for texts in rows)
        cells = ("".join(f'<td data-label="{label}">{text}</td>' for label, text in line) for line in lines)
        body = "\n".join(f"<tr>{line}</tr>" for line in cells)
        return (
            f'<div class="wide"><table class="{kind}">\n<thead><tr>{head}</tr></thead>\n<tbody>\n{body}\n</tbody>'
            "</table></div>"
        )

    def items(texts: list[str]) -> str:
        return f"<ul>{''.join(f'<li>{escape(text)}</li>' for text in texts)}</ul>"

    challenges = []
    for challenge in profile.challenges:
        about, (heading, rows) = said(profile, challenge, beside), rung_table(profile, challenge)
        parts = [f"<h3>{escape(f'{challenge}: {about.isolates}')}</h3>"]
        parts += [f"<p>{escape(text)}</p>" for text in paragraphs(profile, about) if text]
        if rows or others_of(profile, beside, challenge):
            parts.append(figure(Rungs(profile, challenge, beside), about.sentence))
        if rows:
            parts.append(f"<details><summary>numbers</summary>{table(heading, rows, 'numbers')}</details>")
        challenges.append("<section>" + "\n".join(parts) + "</section>")
    other, grey = (f" {OTHER}", f" {GREY}") if beside else ("", "")
    guide = " ".join([TAKE, *([OF_OTHERS] if beside else []), FURTHER])
    blank = f"<h2>Who cannot enter</h2>\n{items(reasons(profile))}" if reasons(profile) else ""
    return f"""\
<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
<title>What the agents master</title>
<style>
{STYLE}</style>
</head>
<body>
<h1>What the agents master</h1>
<p>{escape(INTRODUCTION)}</p>
<h2>Which agent to take</h2>
<p>{escape(guide)}</p>
{table(*take_table(profile, beside))}
<h2>Scores</h2>
<div class="figures">
{figure(Radar(profile), "Radar of the scores; the table has the numbers")}
{figure(Dots(profile, beside), "Scores with intervals; the table has the numbers")}
</div>
<p class="soft">The radar is for a first look: its area depends on the order of the challenges. The dots can be
compared; a gap in a line, or no dot, means that the agent cannot enter the challenge, or was not measured.{other}</p>
{table(*score_table(profile, beside))}
<p class="soft">{escape(MARKS)}</p>
<h2>The challenges</h2>
<p class="soft">{escape(STEPS)}{grey}</p>
<div class="figures ladders">
{chr(10).join(challenges)}
</div>
{blank}
<h2>How it was measured</h2>
{items(method(profile))}
</body>
</html>
"""


def figure(panel: Panel, says: str) -> str:
    """A panel as SVG within the page, whose ink is that of the page."""
    sheet = Sheet("panel", [[panel]]).draw()
    sheet.set_size_inches(*(SMALLER * sheet.get_size_inches()))  # for larger text: pages fit it to their width
    drawn = to_bytes(sheet, "svg").decode()
    svg = re.sub(r"^.*?(?=<svg)", "", drawn, flags=re.DOTALL)
    svg = re.sub(r' (width|height)="[^"]*pt"', "", svg, count=2)
    svg = re.sub(r"<metadata>.*?</metadata>", "", svg, flags=re.DOTALL)
    svg = svg.replace(INK, "currentColor").replace("#ffffff", "none")
    svg = re.sub(rf'<g id="{NAMED}([^"]*)">', r"<g><title>\1</title>", svg)
    unique = re.sub(r"\W+", "", f"{type(panel).__name__}{panel.title}")
    svg = re.sub(r'(id="|href="#|url\(#)', rf"\g<1>{unique}-", svg)
    return f'<figure role="img" aria-label="{html.escape(says)}">{svg}</figure>'


def write(profile: Profile, folder: str | os.PathLike[str], beside: Profile | None = None) -> Path:
    """Write report.html, report.md, runs.csv, profile.png and profile.svg into a folder.

    Args:
        profile: the profile.
        folder: it is made where there is none.
        beside: the profile of other agents, to compare with.

    Returns:
        The path of report.html.

    Raises:
        ValueError: the path is none.
        OSError: a file cannot be written.
        gymnasium.error.DependencyNotInstalled: Matplotlib is missing.
    """
    require("plot", "matplotlib")
    folder = a_path("folder", folder)
    folder.mkdir(parents=True, exist_ok=True)
    save_figure(picture(profile, beside).draw(), folder / "profile.svg")
    write_whole(folder / "runs.csv", profile.runs.to_csv(index=False, lineterminator="\n").encode())
    write_whole(folder / "report.md", markdown(profile, beside).encode())
    return write_whole(folder / NAME, as_html(profile, beside).encode())
