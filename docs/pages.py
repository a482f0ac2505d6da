"""Write the pages of the environments, `docs/environments/`, from the code; the game Soccer has one, too.

The text of a page is the docstring of the environment's class, its first line comes from the table of environments, and
its parameters from the constructor, so that nothing is written twice. The environment draws the picture and a short
animation.

    python docs/pages.py            write everything
    python docs/pages.py --check    write nothing; fail if a page is out of date
"""

import argparse
import inspect
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from gymnasium.spaces import Box, Discrete
from PIL import Image, ImageDraw, ImageFont

from edugym import EpsilonGreedy, QLearning, finite_model, games, train
from edugym.adapters.playing.films import play_episode, record
from edugym.adapters.playing.game import Frame
from edugym.adapters.registration import ENVIRONMENTS, Entry, in_course_order
from edugym.envs.trashbot.planning import ScriptedController
from edugym.exact.game_model import GameModel
from edugym.exact.shapley import GameValues
from edugym.rendering.palette import INK
from edugym.rendering.pixels import to_pixels
from edugym.rendering.scene import Scene
from edugym.rendering.svg import to_svg
from edugym_course.lab.records import number_of, without_number

PAGES = Path(__file__).parent / "environments"
LESSONS = Path(__file__).parents[1] / "src/edugym_course/lessons"
ORIGINAL = "../coming-from-the-original-edugym.md"
FRAMES = 31
GAME_LESSON, GAME_DISCOUNT, MATCH = "13", 0.9, 7
"""The lesson on games, the discount of their values, and the seed of the match that is shown."""
MOST_STATES = 5_000
"""How many states the exact model looks at before it gives up."""

rng = np.random.default_rng(0)
# The players of the animations in which Q-learning on the observations would not show the task.
ACTORS: dict[str, Callable[[Any], Any]] = {
    "Bandit": lambda env: lambda observation: env.state if rng.random() < 0.4 else int(rng.integers(10)),
    "Casino": lambda env: lambda observation: 6 if observation else 0,
    "Catch": lambda env: (
        lambda observation: 1 + (env.state.ball_x > env.state.paddle_x) - (env.state.ball_x < env.state.paddle_x)
    ),
    "Golf": lambda env: lambda observation: 2 if env.state.hits == 0 else 1,
    "MemoryCorridor": lambda env: lambda observation: env.info()["right_door"],
    "Switches": lambda env: lambda seen: int((seen["achieved_goal"] != seen["desired_goal"]).argmax()),
    "Tamagotchi": lambda env: lambda observation: env.state.wanted,
    "Trashbot": lambda env: ScriptedController(env.mdp.action_scale),
}


def parameters(create: Callable[..., Any]) -> str:
    """Return the parameters of an environment or game with their defaults, as in a call."""
    signature = inspect.signature(create)
    return ", ".join(f"{name}={p.default!r}" for name, p in signature.parameters.items() if name != "render_mode")


def lesson_link(lesson: str | None) -> str:
    """Return a link to the lesson with a number, or nothing if there is none."""
    sources = [source for source in LESSONS.glob("*/[0-9]*_*.py") if number_of(source.stem) == lesson]
    names = [(without_number(source.stem).replace("_", " "), source.stem) for source in sources]
    links = [f" · lesson: [{said}](../../notebooks/{stem}.ipynb)" for said, stem in names]
    return "".join(links)


def mdp_table(entry: Entry) -> list[str]:
    """Return a table of the MDP at its defaults: the sizes and limits of its parts, counted by the exact model."""
    mdp = entry.load_mdp().create()
    try:
        model = finite_model(mdp, MOST_STATES)
    except ValueError as error:
        why = str(error).partition("no finite model: ")[2].removesuffix(" (max_states can be raised)")
        rows = {"States": f"not counted: {why}"}
    else:
        ends, begins = int(model.terminal.sum()), int((model.initial > 0).sum())
        low, high = (f"{end:.4g}" for end in (model.rewards.min(), model.rewards.max()))
        most = int((model.probabilities > 0).sum(axis=2).max())
        rows = {
            "States": f"{len(model.states)} can be reached, {ends or 'none'} of them terminal",
            "Start": "always the same state" if begins == 1 else f"one of {begins} states",
            "Next states": f"{'one' if most == 1 else f'up to {most}'} for each state and action",
            "Reward of a step": f"from {low} to {high} on average",
        }
    if hasattr(mdp, "reward_space"):
        rows["Reward of a step"] = f"a vector of {mdp.reward_space.shape[0]} numbers"
    actions, seen, limit = mdp.action_space, mdp.observation_space, getattr(mdp, "max_steps", None)
    kind = "real" if isinstance(seen, Box) else "whole"
    rows |= {
        "Actions": f"{actions.n}" if isinstance(actions, Discrete) else f"{actions.shape[0]} real numbers",
        "Observation": f"{kind} numbers, shape {seen.shape}" if seen.shape else "one whole number",
        "Step limit": "none" if limit is None else f"{limit} steps",
    }
    return table("The MDP", rows)


def table(of: str, rows: dict[str, str]) -> list[str]:
    """Return a table of what is so at the defaults."""
    return [f"| {of} | at the defaults |", "|---|---|", *(f"| {name} | {text} |" for name, text in rows.items())]


def page(entry: Entry) -> str:
    """Return the page of one environment."""
    name = entry.name.lower()
    return "\n".join(
        [
            f"# {entry.name}",
            "",
            f"**{entry.challenge}** · `{entry.id}`{lesson_link(entry.lesson)}",
            "",
            f"![The picture of {entry.name}]({name}.svg) ![An episode of {entry.name}]({name}.gif)",
            "",
            "```python",
            f'gymnasium.make("{entry.id}", {parameters(entry.load())})',
            "```",
            "",
            *mdp_table(entry),
            "",
            inspect.cleandoc(entry.load_mdp().__doc__ or ""),
            "",
        ]
    )


@cache
def solution(game: games.Soccer) -> tuple[GameModel, GameValues]:
    """Return the exact model of a game, and its solution."""
    model = games.game_model(game)
    return model, games.minimax_value_iteration(model, GAME_DISCOUNT)


def game_table(game: games.Soccer) -> list[str]:
    """Return a table of a zero-sum game at its defaults: its sizes, counted by the exact model, and its value."""
    both, solved = solution(game)
    model = both.joint[0]
    begins = [state for state, probability in zip(model.states, model.initial, strict=True) if probability > 0]
    values = " or ".join(f"{solved.value(state):.3f}" for state in begins)
    rows = {
        "States": f"{len(model.states)} can be reached, {int(model.terminal.sum())} of them terminal",
        "Start": f"one of {len(begins)} states",
        "Next states": f"up to {int((model.probabilities > 0).sum(axis=-1).max())} for each state and pair of actions",
        "Rewards of a step": "one for each player, together 0",
        "Value": f"{values} for player 0, by the state at the start, with discount {GAME_DISCOUNT}",
        "Actions": " and ".join(str(game.action_space(player).n) for player in (0, 1)),
        "Observation": "one whole number, the same for both",
        "Step limit": f"{game.max_steps} steps",
    }
    return table("The game", rows)


def game_challenge(kind: type[Any]) -> str:
    """Return the challenge of a game, as its docstring says it."""
    return (kind.__doc__ or "").partition("Challenge: ")[2].partition(".")[0]


def game_page(game: games.Soccer) -> str:
    """Return the page of a game."""
    kind = type(game)
    name = kind.__name__
    guide = "[more games](../several-agents.md)"
    return "\n".join(
        [
            f"# {name}",
            "",
            f"**{game_challenge(kind)}** · `edugym.games.{name}`{lesson_link(GAME_LESSON)} · {guide}",
            "",
            f"![The picture of {name}]({name.lower()}.svg) ![A match of {name}]({name.lower()}.gif)",
            "",
            "```python",
            f"games.{name}.create({parameters(kind.create)})",
            "```",
            "",
            *game_table(game),
            "",
            inspect.cleandoc(kind.__doc__ or ""),
            "",
        ]
    )


def match(game: games.Soccer) -> tuple[Scene, list[Frame]]:
    """Return a picture from the middle of a match between optimal players, and all frames of the match."""
    policies = solution(game)[1].policies
    chance = np.random.default_rng(MATCH)

    def actor(observation: int) -> int:
        return int(chance.choice(len(policies[0][observation]), p=policies[0][observation]))

    frames = play_episode(games.against(game, 0, policies[1]), actor, seed=MATCH, max_steps=FRAMES)
    picture = frames[len(frames) // 2].picture
    assert isinstance(picture, Scene), "the game has a scene"
    return picture, frames


def row(name: str, challenge: str, called: str) -> str:
    """Return a row of the table of all environments."""
    page = f"{name.lower()}.md"
    return f"| [![{name}]({name.lower()}.svg)]({page}) | [{name}]({page}) | {challenge} | `{called}` |"


def index() -> str:
    """Return the page with the table of all environments."""
    rows = [row(e.name, e.challenge, parameters(e.load())) for e in in_course_order()]
    rows.append(row("Soccer", game_challenge(games.Soccer), parameters(games.Soccer.create)))
    head = ["| | environment | its one challenge | parameters and defaults |", "|---|---|---|---|"]
    new = (
        "Nine are those of the paper. Four are new: Switches for goals, Diver for several objectives, Casino for"
        " maximisation bias, and Bandit, the simplest of all, for the beginning of exploration. Below is a game of two"
        " players, Soccer; more games are on the page on [several agents](../several-agents.md)."
    )
    more = f"For users of the original code: [what has changed]({ORIGINAL})."
    return "\n".join(["# The environments", "", new, "", *head, *rows, "", more, ""])


def pages() -> dict[Path, str]:
    """Return the text of every page."""
    return {
        PAGES / "README.md": index(),
        **{PAGES / f"{e.name.lower()}.md": page(e) for e in ENVIRONMENTS},
        PAGES / "soccer.md": game_page(games.Soccer.create()),
    }


def episode(entry: Entry) -> tuple[Scene, list[Frame]]:
    """Return a picture from the middle of an episode, and all frames of the episode."""
    env = entry.load()()
    if entry.name in ACTORS:
        actor = ACTORS[entry.name](env)
    else:
        actor = QLearning.create(env, learning_rate=0.1, discount=0.99, exploration=EpsilonGreedy(0.3))
        train(env, actor, 1_000_000, seed=1)
    frames = play_episode(env, actor, seed=3, max_steps=FRAMES)
    picture = frames[len(frames) // 2].picture
    assert isinstance(picture, Scene), "every environment of the course has a scene"
    return picture, frames


def montage(
    pictures: dict[str, Scene], columns: int = 7, side: int = 240, gap: int = 16, text: int = 26
) -> Image.Image:
    """Arrange all pictures in rows, each scaled to fit a square, with its name below."""
    rows = -(-len(pictures) // columns)
    sheet = Image.new("RGB", (columns * (side + gap) + gap, rows * (side + text + gap) + gap), "white")
    for k, (name, picture) in enumerate(pictures.items()):
        image = Image.fromarray(to_pixels(picture))
        image.thumbnail((side, side))
        x, y = gap + k % columns * (side + gap), gap + k // columns * (side + text + gap)
        sheet.paste(image, (x + (side - image.width) // 2, y + (side - image.height) // 2))
        font = ImageFont.load_default(15)
        ImageDraw.Draw(sheet).text((x + side / 2, y + side + text / 2), name, INK, font, anchor="mm")
    return sheet


def main() -> int:
    """Run the command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing, and fail if a page is out of date")
    check = parser.parse_args().check
    shown = {entry.name: episode(entry) for entry in in_course_order()} | {"Soccer": match(games.Soccer.create())}
    pictures = {PAGES / f"{name.lower()}.svg": to_svg(picture, 240) for name, (picture, _) in shown.items()}
    texts = {**pages(), **pictures}
    if check:
        films = [PAGES / f"{name.lower()}.gif" for name in shown]
        stale = [path for path, text in texts.items() if not path.exists() or path.read_text(encoding="utf-8") != text]
        stale += [path for path in (*films, PAGES / "all.png") if not path.exists()]  # pixels differ between machines
        for path in stale:
            print(f"{path} is out of date: run python docs/pages.py", file=sys.stderr)
        return 1 if stale else 0
    PAGES.mkdir(exist_ok=True)
    for path, text in texts.items():
        path.write_text(text, encoding="utf-8")
    for name, (_, frames) in shown.items():
        record(frames, PAGES / f"{name.lower()}.gif", frames_per_second=3.0)
    montage({name: picture for name, (picture, _) in shown.items()}).save(PAGES / "all.png", optimize=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
