"""The report on a profile: one HTML file without requests to other hosts, Markdown, CSV, and a picture."""

import html
import os
import re
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType

from edugym.checks.parameters import a_path
from edugym.experiments.figures.panel import Panel
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.figures.style import DEEP_BLUE, GREY, save_figure, to_bytes
from edugym.experiments.profiles.pictures import NAMED, Dots, Radar, Rungs, picture
from edugym.experiments.profiles.scores import HALF, NEARLY, Profile
from edugym.experiments.profiles.tables import (
    method,
    not_measured,
    reasons,
    rung_table,
    score_table,
    sure_differences,
    table_of_all,
    take_table,
    without_ladder,
)
from edugym.experiments.profiles.verdicts import Said, others_of, said
from edugym.rendering.palette import INK
from edugym.system.extras import require
from edugym.system.files import write_whole

NAME = "report.html"
"""The report; the other files lie beside it."""
NOTHING: Mapping[str, str] = MappingProxyType({})
SMALLER = 0.8
"""How large a figure within the page is, beside one of a file."""
ON_PAGE = {INK: "currentColor", "#ffffff": "none", DEEP_BLUE: "var(--blue)", GREY: "var(--grey)"}
"""What stands in a page for colours of a figure, since some can hardly be seen in the dark."""
STYLE = (
    f"""\
:root {{ color-scheme: light dark; --ink: #33313f; --paper: #ffffff; --line: #d8d5de; --soft: #6a6676;
  --blue: {DEEP_BLUE}; --grey: {GREY}; --shade: #33313f55; }}
@media (prefers-color-scheme: dark) {{
  :root {{ --ink: #eceaf2; --paper: #1b1a21; --line: #45424f; --soft: #aaa6b6; --blue: #3d97dc; --grey: #a5a2b0;
    --shade: #eceaf266; }}
}}
"""
    + """\
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); max-width: 68rem;
  margin: 2rem auto; padding: 0 1rem; }
h1 { line-height: 1.2; }
h2 { margin-top: 2.5rem; }
h3 { margin-bottom: .3rem; }
.soft { color: var(--soft); }
/* A shade at the side on which a table goes on. */
.wide { overflow-x: auto; background: linear-gradient(to right, var(--paper) 40%, transparent) 0 0 / 3rem 100% local,
  linear-gradient(to left, var(--paper) 40%, transparent) 100% 0 / 3rem 100% local,
  linear-gradient(to right, var(--shade), transparent) 0 0 / .8rem 100%,
  linear-gradient(to left, var(--shade), transparent) 100% 0 / .8rem 100%; background-repeat: no-repeat; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .7rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 21rem), 1fr)); gap: 1.5rem; }
figure { margin: 0; }
figure svg { width: 100%; height: auto; max-width: 34rem; fill: currentColor; }
.ladders { grid-template-columns: repeat(auto-fit, minmax(min(100%, 26rem), 1fr)); }
.cards td:first-child { min-width: 12rem; }
.ladders > section { min-width: 0; }
.numbers { font-size: .9rem; margin: .5rem 0; }
.numbers th, .numbers td { padding: .2rem .4rem; }
.numbers :is(th, td):first-child { position: sticky; left: 0; background: var(--paper); max-width: 11rem; }
summary { cursor: pointer; margin: .5rem 0; }
@media (max-width: 40rem) {
  .numbers :is(th, td) { padding: .2rem .3rem; }
  .ladders .numbers :is(th, td):first-child { max-width: 6.5rem; }
  .cards thead { display: none; }
  .cards tr { display: block; padding: .6rem 0; border-bottom: 1px solid var(--line); }
  .cards td { display: grid; grid-template-columns: 8.5rem 1fr; gap: .6rem; padding: .1rem 0; border: 0; }
  .cards td::before { content: attr(data-label); color: var(--soft); }
  .cards td:first-child { font-weight: 600; }
}
"""
)


INTRODUCTION = (
    "Every challenge is a ladder of tasks, from easy to hopeless. On each rung an agent trains anew, and then plays"
    " without exploring: 0 stands for random play, 1 for the best play. The mean over the rungs is its score in the"
    f" challenge. An agent fails if it is below {HALF} on the first rung already; it breaks between the two rungs where"
    f" it first falls below {HALF}. It masters a challenge if it never does, and still has {NEARLY} or more on the last"
    " rung. Who breaks later may have the lower score, since"
    " the rungs after the break count too."
)
TAKE = (
    "Find the line that is most like your problem. “Highest score” names the agent with the highest score of all that"
    f" were tried there, where it is {HALF} or more. “Not surely worse” names the agents whose score is lower, but"
    " perhaps only by chance. “Weakest in” names the challenge in which the agent with the highest score falls"
    " furthest behind the best agent there, and its score there."
)
MORE = "If the table only says how many more agents there are, look for the stars in the table of all scores below."
NO_LINE = (
    "Three problems are not in the table, since no score shows them: rewards in which noise hides the differences,"
    " rewards that are lost while the agent still learns, and risk, where the worst return counts and not the mean. A"
    " score is a mean, and counts only how an agent plays after the training."
)
OTHERS = (
    "Agents that you did not give are called the other agents, and are grey. They are EduGym's and those of"
    " Stable-Baselines3 (SB3), with their own default settings (but GaussianActorCritic with tiles for Trashbot's arm)."
    " DQN is EduGym's, SB3 DQN is not. Those of Stable-Baselines3 are not measured everywhere, since a ladder of"
    " theirs can take hours."
)
MARKS = (
    "A number is a score with its 95 % interval; – says that an agent cannot enter a challenge, or fails there by an"
    " error, and ? that it was not measured there. A score a little above 1 is luck: the best play is known on average."
)
SURE = "A difference between two agents is called sure where it can hardly be chance (see How it was measured)."
ALL = f"The score of every agent (* is the highest, or not surely worse, where the highest is {HALF} or more)"
EACH = "What each agent is"
BANDS = "A coloured band is the 95 % interval on each rung."
GREY_LINES = (
    "Where grey lines end, the one with the highest score has its name; + 3 says that three more end there. Point at a"
    " line to see its name; the scores of all are above."
)


def paragraphs(profile: Profile, about: Said, everybody: Profile) -> list[str]:
    """What a challenge is, how far the agents get, and who is not measured."""
    task, missing = profile.ladder(about.challenge).words.about, not_measured(everybody, about.challenge)
    return [text for text in (task, f"{about.sentence} {missing}".strip()) if text]


def guide(everybody: Profile | None) -> list[str]:
    """How to read the table of whom to take, in paragraphs."""
    return [f"{TAKE} {MORE}", f"{NO_LINE} {OTHERS}"] if everybody else [TAKE, NO_LINE]


def whoever(everybody: Profile, abouts: Mapping[str, str]) -> list[str]:
    """What each agent is, a line for each of which it is known."""
    return [f"{agent}: {abouts[agent]}" for agent in everybody.agents if agent in abouts]


def markdown(profile: Profile, everybody: Profile | None = None, abouts: Mapping[str, str] = NOTHING) -> str:
    """The report as Markdown; its picture is the file profile.svg beside it. Arguments as in `write`."""

    def escape(text: str) -> str:
        return text.replace("|", "\\|").replace("<", "&lt;")

    def table(heading: list[str], rows: list[list[str]]) -> list[str]:
        cells = [[*map(escape, row)] for row in [heading, *rows]]
        lines = ["| " + " | ".join(row) + " |" for row in cells]
        return [lines[0], "|" + "---|" * len(heading), *lines[1:], ""]

    def items(texts: list[str]) -> list[str]:
        return [*(f"- {escape(text)}" for text in texts), ""]

    lines = ["# What the agents master", "", INTRODUCTION, "", "## Which agent to take", ""]
    lines += [line for text in guide(everybody) for line in (text, "")]
    lines += table(*take_table(profile, everybody))
    lines += ["## Scores", "", "![Radar, scores with intervals, and ladders](profile.svg)", ""]
    lines += [*table(*score_table(profile, everybody)), MARKS, ""]
    if sure := sure_differences(profile):
        lines += [SURE, "", *items(sure)]
    if everybody:
        lines += [f"### {ALL}", "", *table(*table_of_all(everybody))]
    if who := whoever(everybody or profile, abouts):
        lines += [f"### {EACH}", "", *items(who)]
    lines += ["## The challenges", ""]
    for challenge in profile.challenges:
        about, (heading, rows) = said(profile, challenge, everybody), rung_table(profile, challenge)
        lines += [f"### {challenge}: {about.isolates}", ""]
        lines += [line for text in paragraphs(profile, about, everybody or profile) for line in (text, "")]
        lines += table(heading, rows) if rows else []
    if reasons(profile):
        lines += ["## Who cannot enter", "", *items(reasons(profile))]
    return "\n".join([*lines, "## How it was measured", "", *items([*method(everybody or profile), without_ladder()])])


def as_html(profile: Profile, everybody: Profile | None = None, abouts: Mapping[str, str] = NOTHING) -> str:
    """The report as one HTML file, which loads nothing from anywhere; light or dark as the reader's system is.

    Arguments are those of `write`.
    """
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

    def fold(title: str, contents: str) -> str:
        return f"<details><summary>{title}</summary>{contents}</details>"

    challenges = []
    for challenge in profile.challenges:
        about, (heading, rows) = said(profile, challenge, everybody), rung_table(profile, challenge)
        parts = [f"<h3>{escape(f'{challenge}: {about.isolates}')}</h3>"]
        parts += [f"<p>{escape(text)}</p>" for text in paragraphs(profile, about, everybody or profile)]
        if rows or others_of(profile, everybody, challenge):
            parts.append(figure(Rungs(profile, challenge, everybody), about.sentence))
        if rows:
            parts.append(fold("numbers", table(heading, rows, "numbers")))
        challenges.append("<section>" + "\n".join(parts) + "</section>")
    sure, who = sure_differences(profile), whoever(everybody or profile, abouts)
    folds = [fold(ALL, table(*table_of_all(everybody), "numbers"))] if everybody else []
    folds += [fold(EACH, items(who))] if who else []
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
{"".join(f"<p>{escape(text)}</p>" for text in guide(everybody))}
{table(*take_table(profile, everybody))}
<h2>Scores</h2>
<div class="figures">
{figure(Radar(profile), "Radar of the scores; the table has the numbers")}
{figure(Dots(profile, everybody), "Scores with intervals; the table has the numbers")}
</div>
<p class="soft">The radar is for a first look: its area depends on the order of the challenges. The dots can be
compared; a gap in a line, or no dot, means that the agent cannot enter the challenge, or was not measured.</p>
{table(*score_table(profile, everybody))}
<p class="soft">{escape(MARKS)}</p>
{f"<p>{SURE}</p>{items(sure)}" if sure else ""}
{chr(10).join(folds)}
<h2>The challenges</h2>
<p class="soft">{BANDS}{f" {escape(GREY_LINES)}" if everybody else ""}</p>
<div class="figures ladders">
{chr(10).join(challenges)}
</div>
{blank}
<h2>How it was measured</h2>
{items([*method(everybody or profile), without_ladder()])}
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
    for color, shown in ON_PAGE.items():
        svg = svg.replace(color, shown)
    svg = re.sub(rf'<g id="{NAMED}([^"]*)">', r"<g><title>\1</title>", svg)
    unique = re.sub(r"\W+", "", f"{type(panel).__name__}{panel.title}")
    svg = re.sub(r'(id="|href="#|url\(#)', rf"\g<1>{unique}-", svg)
    return f'<figure role="img" aria-label="{html.escape(says)}">{svg}</figure>'


def write(
    profile: Profile,
    folder: str | os.PathLike[str],
    everybody: Profile | None = None,
    abouts: Mapping[str, str] = NOTHING,
) -> Path:
    """Write report.html, report.md, runs.csv, profile.png and profile.svg into a folder.

    Args:
        profile: the profile.
        folder: it is made where there is none.
        everybody: a profile that has other agents too, to compare with, as `pooled` gives it; None for no others.
        abouts: what an agent is, in a line, by its label.

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
    save_figure(picture(profile, everybody).draw(), folder / "profile.svg")
    write_whole(folder / "runs.csv", profile.runs.to_csv(index=False, lineterminator="\n").encode())
    write_whole(folder / "report.md", markdown(profile, everybody, abouts).encode())
    return write_whole(folder / NAME, as_html(profile, everybody, abouts).encode())
