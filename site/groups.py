"""Headings within the long lists of pages in the sidebar, and the order of the agents' pages."""

import posixpath
import re
from collections.abc import Mapping
from typing import Any

import agent_pages
import guides
from agent_pages import AGENTS

AGENT_GROUPS = {
    "One-step values": (
        "QLearning",
        "SARSA",
        "ExpectedSARSA",
        "DoubleQLearning",
        "MaxminQLearning",
        "RiskSensitiveQLearning",
    ),
    "Several steps and traces": ("NStepSARSA", "TreeBackup", "SARSALambda", "QLambda"),
    "Exploration": ("CountBased", "GoExplore"),
    "Models and planning": ("DynaQ", "PrioritisedSweeping", "RMax", "UCT"),
    "Policies": ("REINFORCE", "ActorCritic", "GaussianActorCritic"),
    "Features and networks": ("LinearQLearning", "SemiGradientSARSA", "DQN"),
    "Hindsight": ("HindsightQLearning", "HindsightDQN"),
    "Bandits": ("SampleAverage", "GradientBandit"),
}
ORDER = [agent_pages.place(AGENTS[name]) for names in AGENT_GROUPS.values() for name in names if name in AGENTS]
_COURSE = {"00_loop": "To begin", "01_exploration": "The paper's nine challenges", "10_own_problem": "Beyond the paper"}
FIRST: Mapping[str, str] = {
    **{f"{folder}/{name}": heading for folder in ("lessons", "project") for name, heading in _COURSE.items()},
    "environments/bandit": "To begin",
    "environments/boulder": "The paper's nine",
    "environments/switches": "Beyond the paper",
    **{agent_pages.place(AGENTS[names[0]]): heading for heading, names in AGENT_GROUPS.items()},
    **{f"guides/{names[0]}": heading for heading, names in guides.GROUPS.items()},
}
"""The first page below each heading."""
_ENTRY = re.compile(r'<li class="toctree-l2[^"]*"><a class="[^"]*" href="([^"#]*)#?[^"]*">')


def add(app: Any, page: str, template: str, context: dict[str, Any], doctree: Any) -> None:
    """Add the headings to the tree of pages in a sidebar."""

    def headed(entry: re.Match[str]) -> str:
        there = posixpath.normpath(posixpath.join(posixpath.dirname(page), entry[1].removesuffix(".html")))
        heading = FIRST.get(there if entry[1] else page)
        return f'<li class="group">{heading}</li>\n{entry[0]}' if heading else entry[0]

    context["furo_navigation_tree"] = _ENTRY.sub(headed, context["furo_navigation_tree"])
