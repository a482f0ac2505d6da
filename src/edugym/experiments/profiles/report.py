"""The report on a profile: one HTML file without requests to other hosts, Markdown, CSV, and a picture."""

import html
import math
import os
import re
from pathlib import Path
from typing import NamedTuple

from edugym.checks.parameters import a_path
from edugym.experiments.figures.panel import Panel
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.figures.style import save_figure, to_bytes
from edugym.experiments.profiles.ladders import EXACT, steps_of
from edugym.experiments.profiles.pictures import Dots, Radar, Rungs, picture, scores_of, written
from edugym.experiments.profiles.scores import HALF, NEARLY, Profile
from edugym.experiments.results.statistics import Interval, paired_difference
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
.ladders > section { min-width: 0; }
"""


class Said(NamedTuple):
    """What the report says about a challenge.

    Attributes:
        challenge: the name.
        isolates: what the challenge is.
        take: the agents to take: the best, and those that cannot be told from it.
        sentence: what stands out.
    """

    challenge: str
    isolates: str
    take: str
    sentence: str


def listed(texts: list[str]) -> str:
    """Texts as a list in a sentence."""
    return texts[0] if len(texts) == 1 else f"{', '.join(texts[:-1])} and {texts[-1]}"


class Outcome(NamedTuple):
    """How one agent, or several, fare on a ladder, in a few words."""

    of_one: str
    of_several: str


def outcome(profile: Profile, agent: str, challenge: str) -> Outcome:
    """How an agent fares on a ladder."""
    ladder, broken = profile.ladder(challenge), profile.breaks(agent, challenge)
    if broken is None:
        if challenge in profile.blank.get(agent, {}):
            return Outcome("cannot enter", "cannot enter")
        return Outcome("is not measured", "are not measured")
    first, last = written(ladder.strengths[0]), written(ladder.strengths[-1])
    if broken.where == "at once":
        return Outcome(f"fails already at {first}", f"fail already at {first}")
    if broken.where == "between":
        at = written(float(f"{broken.strength:.2g}"))  # interpolated: more digits would say too much
        return Outcome(f"breaks at {at}", f"break at {at}")
    if profile.rungs(agent, challenge)[-1].estimate >= NEARLY:
        return Outcome(f"masters {last}", f"master {last}")
    return Outcome(f"does not break up to {last}", f"do not break up to {last}")


def said(profile: Profile, challenge: str) -> Said:
    """What the report says about a challenge."""
    ladder = profile.ladder(challenge)
    outcomes: dict[Outcome, list[str]] = {}
    for agent in profile.agents:
        outcomes.setdefault(outcome(profile, agent, challenge), []).append(agent)
    parts = [
        f"{listed(agents)} {words.of_one if len(agents) == 1 else words.of_several}"
        for words, agents in outcomes.items()
    ]
    best = best_agents(profile, challenge)
    entered = any(profile.score(agent, challenge).n for agent in profile.agents)
    take = listed(best) if best else "nobody" if entered else "nobody can enter"
    if best and (score := profile.score(best[0], challenge).estimate) < HALF:
        take = f"nobody is good; the best score is {rounded(score)}, of {best[0]}"
    sentence = f"{ladder.strength[:1].upper()}{ladder.strength[1:]}: {'; '.join(parts)}."
    return Said(challenge, ladder.challenge, take, sentence)


def best_agents(profile: Profile, challenge: str) -> list[str]:
    """The agent with the highest score, and those whose difference from it may be chance; none where none enters.

    An agent that is not better than random play is none of them. One with fewer repetitions than others is one of them
    only if it is surely better: its interval lies above that of the best of the others.
    """
    scores = {agent: profile.score(agent, challenge) for agent in profile.agents}
    entered = {agent: score for agent, score in scores.items() if score.n and score.estimate > 0}
    if not entered:
        return []
    most = max(score.n for score in entered.values())
    often = [agent for agent, score in entered.items() if score.n == most]
    best = max(often, key=lambda agent: entered[agent].estimate)
    surely = [agent for agent in entered if agent not in often and entered[agent].low > entered[best].high]
    if surely:
        return sorted(surely, key=lambda agent: -entered[agent].estimate)
    runs = {agent: profile.scores(agent, challenge).mean(axis=0) for agent in often}
    return [best, *(a for a in often if a != best and paired_difference(runs[best], runs[a]).low <= 0)]


def others_of(profile: Profile, beside: Profile | None, challenge: str) -> dict[str, float]:
    """The scores of the agents of another profile that have none in this one."""
    here = scores_of(profile, challenge)
    return {agent: score for agent, score in scores_of(beside, challenge).items() if agent not in here}


def better_beside(profile: Profile, challenge: str, beside: Profile | None) -> str | None:
    """The best agent of another profile, if it is good and surely better than all here: their intervals lie apart."""
    others = others_of(profile, beside, challenge)
    if beside is None or not others:
        return None
    best = max(others, key=lambda agent: others[agent])
    here = [profile.score(agent, challenge) for agent in profile.agents]
    highest = max((score.high for score in here if score.n), default=-math.inf)
    return best if others[best] >= HALF and beside.score(best, challenge).low > highest else None


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


def rounded(number: float) -> str:
    """A number with two digits, where 0 has no sign."""
    return f"{round(number, 2) + 0.0:.2f}"


def score_table(profile: Profile, beside: Profile | None = None) -> tuple[list[str], list[list[str]]]:
    """The heading and the rows of the table of scores; the best agent of another profile stands beside them.

    The agent to take is one of the other profile where it is surely better.
    """
    rows = []
    for challenge in profile.challenges:
        about = said(profile, challenge)
        scores = [score_or_reason(profile, agent, challenge) for agent in profile.agents]
        others = others_of(profile, beside, challenge)
        best = max(others, key=lambda agent: others[agent]) if others else ""
        known = [f"{best} {rounded(others[best])}" if best else "–"] if beside else []
        better = better_beside(profile, challenge, beside)
        take = f"{better} (one of the others)" if better else about.take
        rows.append([f"{challenge} ({about.isolates})", take, *scores, *known])
    return ["challenge", "take", *profile.agents, *(["best of the others"] if beside else [])], rows


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
    " of them as well as can be, 0 that it plays no better than at random."
)


TAKE = (
    "Find the challenge that is most like your problem, and take an agent that stands beside it: the one with the"
    " highest score, or one whose difference from it may be chance."
)


MARKS = (
    "In the table, – says that an agent cannot enter a challenge, and ? that it was not measured there."
    f" A score a little above 1 is luck: the best play is known on average. Steps to {NEARLY} are those after which a"
    " run first scores that much, the median over the runs; it may lose it again."
)


GREY = (
    "Grey marks are other agents, at their defaults: those of EduGym, and those of Stable-Baselines3 (SB3) where they"
    " were measured."
)


def markdown(profile: Profile, beside: Profile | None = None) -> str:
    """The report as Markdown; its picture is the file profile.svg beside it."""

    def escape(text: str) -> str:
        return text.replace("|", "\\|").replace("<", "&lt;")

    def table(heading: list[str], rows: list[list[str]]) -> list[str]:
        cells = [[*map(escape, row)] for row in [heading, *rows]]
        lines = ["| " + " | ".join(row) + " |" for row in cells]
        return [lines[0], "|" + "---|" * len(heading), *lines[1:], ""]

    lines = [
        "# What the agents master",
        "",
        INTRODUCTION,
        "",
        TAKE,
        "",
        *table(*score_table(profile, beside)),
        MARKS,
        "",
    ]
    lines += ["![Radar, scores with intervals, and ladders](profile.svg)", "", "## The challenges", ""]
    for challenge in profile.challenges:
        about = said(profile, challenge)
        heading, rows = rung_table(profile, challenge)
        lines += [f"### {challenge}: {about.isolates}", "", about.sentence, "", *(table(heading, rows) if rows else [])]
    if reasons(profile):
        lines += ["## Who cannot enter", "", *(f"- {escape(reason)}" for reason in reasons(profile)), ""]
    return "\n".join([*lines, "## How it was measured", "", *(f"- {sentence}" for sentence in method(profile)), ""])


def as_html(profile: Profile, beside: Profile | None = None) -> str:
    """The report as one HTML file, which loads nothing from anywhere; light or dark as the reader's system is."""
    escape = html.escape

    def row(texts: list[str], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{escape(text)}</{tag}>" for text in texts) + "</tr>"

    def table(heading: list[str], rows: list[list[str]]) -> str:
        body = "\n".join(row(texts, "td") for texts in rows)
        return (
            f'<div class="wide"><table>\n<thead>{row(heading, "th")}</thead>\n<tbody>\n{body}\n</tbody></table></div>'
        )

    def items(texts: list[str]) -> str:
        return f"<ul>{''.join(f'<li>{escape(text)}</li>' for text in texts)}</ul>"

    challenges = []
    for challenge in profile.challenges:
        about, (heading, rows) = said(profile, challenge), rung_table(profile, challenge)
        parts = [f"<h3>{escape(f'{challenge}: {about.isolates}')}</h3>", f"<p>{escape(about.sentence)}</p>"]
        if rows:
            numbers = f"<details><summary>numbers</summary>{table(heading, rows)}</details>"
            parts += [figure(Rungs(profile, challenge, beside), about.sentence), numbers]
        challenges.append("<section>" + "\n".join(parts) + "</section>")
    grey = f" {GREY}" if beside else ""
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
<div class="figures">
{figure(Radar(profile), "Radar of the scores; the table has the numbers")}
{figure(Dots(profile, beside), "Scores with intervals; the table has the numbers")}
</div>
<p class="soft">The radar is for a first look: its area depends on the order of the challenges. The dots can be
compared; a gap in a line, or no dot, means that the agent cannot enter the challenge, or was not measured.{grey}</p>
<h2>Which agent to take</h2>
<p>{escape(TAKE)} The ladders below say up to which strength of the challenge it is good.</p>
{table(*score_table(profile, beside))}
<p class="soft">{escape(MARKS)}</p>
<h2>The challenges</h2>
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
