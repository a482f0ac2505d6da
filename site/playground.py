"""Build the playground: a page in which agents learn at the speed of machine code, without any Python in it.

    python site/playground.py            build it, into site/build/playground
    python site/playground.py --serve    build it and show it at http://127.0.0.1:8000

What the page knows of tasks and agents is written here, from the package: pictures, places, defaults, random streams,
optima, questions and answers. JavaScript shows it.
"""

import argparse
import inspect
import json
import math
import re
import shutil
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import agent_pages
import editor
import kernels
import numpy as np
from offers import Agent, Race, View
from places import MAPS
from races import BOULDER, RACES
from scenery import scenery, table
from scipy import stats
from vectors import informed
from words import WORDS, Buttons, counted_from_one

import edugym
import edugym.objectives
from edugym.adapters.fitting import tabular
from edugym.adapters.registration import find
from edugym.mdp.protocol import Random
from edugym.mdp.task import task_of
from edugym.training.trainers import streams
from edugym.training.visits import record_visits
from edugym_course.lab.records import number_of

HERE = Path(__file__).parent
PAGE, BUILT = HERE / "playground", HERE / "build" / "playground"
LESSONS = HERE.parent / "src" / "edugym_course" / "lessons"
SEEDS = 40
SEVERAL = (1, 5, 10, 20)
"""How many seeds a reader may run at once."""
TEX = {
    r"\beta": "β",
    r"\pi": "π",
    r"\theta": "θ",
    r"\nabla": "∇",
    r"\ln": "ln",
    r"\mid": "|",
    r"\,": "",
    "$": "",
    "^H": "ᴴ",
    "^m": "ᵐ",
}


def main(arguments: list[str] | None = None) -> None:
    """Build the playground, and serve it if asked to."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--serve", action="store_true", help="show it in a browser on this machine")
    parser.add_argument("--port", type=int, default=8000, help="where to show it")
    parser.add_argument("--jobs", type=int, default=2, help="how many processes compile")
    options = parser.parse_args(arguments)
    build(BUILT, jobs=options.jobs)
    if options.serve:
        server = ThreadingHTTPServer(("127.0.0.1", options.port), partial(SimpleHTTPRequestHandler, directory=BUILT))
        print(f"The playground is at http://127.0.0.1:{server.server_port}/ (Ctrl-C ends it)")
        server.serve_forever()


def build(folder: Path, races: Sequence[Race] = RACES, jobs: int = 2) -> None:
    """Write the page, its data and its kernels into a folder."""
    made = kernels.build(needed(races), folder / "kernels", jobs)
    kernels.prune(folder / "kernels", made)
    shutil.copytree(PAGE, folder, dirs_exist_ok=True)
    data = folder / "data"
    data.mkdir(exist_ok=True)
    sizes = editor.build(folder / "python")
    whole = {"seeds": random_streams(), "several": intervals(), "races": list(map(menu, races)), "editor": sizes}
    _write(data / "playground.json", whole)
    _write(data / "sources.json", sources(races))
    page = (PAGE / "index.html").read_text(encoding="utf-8").replace("<!-- preloads -->", preloads())
    page = page.replace("<!-- first -->", f"{BOULDER.environment}-{BOULDER.strength.first}")
    (folder / "index.html").write_text(page, encoding="utf-8")
    for race in races:
        for k in range(len(race.strength.values)):
            _write(data / f"{race.environment}-{k}.json", task(race, k, made))


def needed(races: Sequence[Race]) -> list[kernels.Call]:
    """The calls whose kernels these races need."""
    return [call for race in races for call in calls(race, race.strength.first)]


def preloads(folder: str = "") -> str:
    """Links by which a browser asks at once for all scripts of the page, which import one another.

    Args:
        folder: of the playground, seen from the page that gets the links, such as "playground/".
    """
    names = ["page.js"]
    for name in names:  # which grows meanwhile
        imported = re.findall(r"^import .* from '\./(.*)'$", (PAGE / name).read_text(encoding="utf-8"), re.MULTILINE)
        names += [other for other in dict.fromkeys(imported) if other not in names]
    return "\n".join(f'<link rel="modulepreload" href="{folder}{name}">' for name in names)


def _write(file: Path, data: Any) -> None:
    file.write_text(json.dumps(data, separators=(",", ":"), ensure_ascii=False, allow_nan=False), encoding="utf-8")


def calls(race: Race, k: int) -> Iterator[kernels.Call]:
    """The calls of kernels: one for each agent, and one for a person."""
    mdp = race.mdp(k)
    for agent in race.agents:
        yield call_of(race, mdp, agent)
    seen = played(race, mdp)
    yield kernels.play_of(seen, edugym.QLearning.create(seen))


def played(race: Race, mdp: Any) -> Any:
    """The task that people play."""
    return tabular(race.measured(mdp) if race.measure else race.agents[0].view.places(mdp))


def call_of(race: Race, mdp: Any, agent: Agent) -> kernels.Call:
    """The call of an agent's kernel: its visits are counted on the way."""
    view, seen = agent.view, agent.view.seen(mdp)
    made, measured = informed(agent.make(seen), mdp), race.measured(mdp) if race.measure else None
    if view.clean:
        return kernels.noted_race_of(seen, mdp, view.clean(mdp), made, race.episodes, measured)
    return kernels.race_of(seen, record_visits(made, seen, 1, n_intervals=1), race.episodes, measured)


# What the page shows before a task is chosen


def menu(race: Race) -> dict[str, Any]:
    """What is the same at every strength: texts, and the agents with their kernels."""
    entry = find(race.environment)
    *lanes, play = [call.fingerprint for call in calls(race, race.strength.first)]
    return {
        "name": race.environment,
        "challenge": entry.challenge,
        "question": race.question,
        "rules": race.rules,
        "answer": race.answer,
        "plainly": WORDS[race.environment].why,
        "fields": WORDS[race.environment].fields,
        **lesson(entry.lesson),
        "steps": race.n_steps,
        "seeds": race.seeds,
        "code": race.trial._asdict(),
        "episodes": race.episodes,
        "measure": race.measure and {"says": race.measure.says, "code": race.measure.code},
        "numbers": race.numbers,
        "told": "In numbers" if race.agents[0].view.clean else "The agent sees",
        "keys": race.keys,
        "outcomes": race.outcomes,
        "strength": {
            "parameter": race.strength.parameter,
            "label": WORDS[race.environment].strength,
            "values": [f"{value:g}" for value in race.strength.values],
            "first": race.strength.first,
            "others": [f"{name}={value!r}" for name, value in race.parameters.items()],
        },
        "agents": [
            {
                "label": agent.label,
                "says": agent.says,
                "kernel": lane,
                "kind": agent.kind.__name__
                if hasattr(edugym, agent.kind.__name__)
                else f"objectives.{agent.kind.__name__}",
                "settings": [[name, _as_code(value)] for name, value in agent.settings.items()],
                "seen": agent.view.code,
                "page": agent_pages.place(agent.kind) if agent.kind in agent_pages.AGENTS.values() else "",
                "own": own_settings(agent),
                "noted": agent.view.clean is not None,
            }
            for agent, lane in zip(race.agents, lanes, strict=True)
        ],
        "play": play,
    }


def sources(races: Sequence[Race]) -> dict[str, str]:
    """The files of the agents, by their classes: what a reader may begin with."""
    kinds = {agent.kind for race in races for agent in race.agents}
    return {kind.__name__: Path(inspect.getfile(kind)).read_text(encoding="utf-8") for kind in kinds}


def own_settings(agent: Agent) -> dict[str, float]:
    """What the page's sliders set, as the agent has it in the lesson: learning rate, discount and ε."""
    given = {**agent.kind._field_defaults, **agent.settings}
    given["epsilon"] = getattr(given.get("exploration"), "epsilon", None)
    return {name: given[name] for name in agent.takes}


def _as_code(value: Any) -> str:
    return (
        f"edugym.{value!r}"
        if isinstance(value, edugym.EpsilonGreedy | edugym.Greedy | edugym.FinalGoal | edugym.FutureGoals)
        else "math.inf"
        if value == math.inf
        else repr(value)
    )


def lesson(number: str | None) -> dict[str, str]:
    """The title of a lesson, three sentences that answer "why?", and where it is."""
    (file,) = (path for path in LESSONS.glob("*/[0-9]*_*.py") if number_of(path.stem) == number)
    text = file.read_text(encoding="utf-8")
    (title,) = re.findall(r"^# # (.*)$", text, re.MULTILINE)[:1]
    paragraph = text.split("### In one paragraph\n")[1].split("\n#\n")[0].replace("\n# ", " ").removeprefix("# ")
    for sign, plain in TEX.items():
        paragraph = paragraph.replace(sign, plain)
    sentences = re.split(r"(?<=[.?])\s+", re.sub(r"^\*.*?\*\s*", "", paragraph))
    return {
        "lesson": title,
        "why": " ".join(sentences[:3]),
        "link": f"../lessons/{file.stem}.html",
    }


def random_streams() -> list[list[list[str]]]:
    """For each seed the streams of `edugym.train`: state and increment of PCG64, as two numbers of 64 bits each."""
    found = []
    for seed in range(SEEDS):
        states = [rng.bit_generator.state["state"] for rng in streams(seed)]
        words = [[state["state"], state["inc"]] for state in states]
        found.append([[f"{word >> shift & (2**64 - 1):x}" for word in pair for shift in (0, 64)] for pair in words])
    return found


def intervals() -> list[list[float]]:
    """Numbers of seeds, each with Student's t for an interval of 95 %."""
    return [[n, float(stats.t.ppf(0.975, n - 1)) if n > 1 else 0.0] for n in SEVERAL]


# A task at one strength


def task(race: Race, k: int, made: dict[str, kernels.Manifest]) -> dict[str, Any]:
    """What the page needs of a task at its k-th strength."""
    mdp = race.mdp(k)
    *lanes, play = [_described(race, call, made) for call in calls(race, k)]
    views = [View() if agent.view.clean else agent.view for agent in race.agents]
    found = {view: table(MAPS[race.environment], mdp, view.of(mdp)) for view in views}
    actions = race.actions or race.agents[0].view.seen(mdp).action_names
    tables = [one for k, one in enumerate(found.values()) if one not in list(found.values())[:k]]
    for lane, view in zip(lanes, views, strict=True):
        lane["table"] = tables.index(found[view])
    return {
        "actions": list(map(counted_from_one, actions)),
        "buttons": buttons(race, mdp),
        "codes": WORDS[race.environment].codes(mdp),
        "others": list(others(race, mdp)),
        "limit": task_of(played(race, mdp)).max_steps,
        "marks": MAPS[race.environment].marks(mdp),
        "look": MAPS[race.environment].look,
        "optimum": optimum(race.measured(mdp)) if race.is_finite else None,
        "scene": scenery(MAPS[race.environment], mdp),
        "tables": tables,
        "agents": lanes,
        "play": {**play, "table": 0},
    }


def _described(race: Race, call: kernels.Call, made: dict[str, kernels.Manifest]) -> dict[str, Any]:
    """How a kernel is begun, and which of its results decide the picture."""
    manifest = made[call.fingerprint]
    results = [name for name, _ in manifest.slots[manifest.results :]]
    inner = ".inner" if any(name.startswith("result.0.inner") for name in results) else ""
    look = ["result.1" if part == "observation" else f"result.0{inner}{part}" for part in MAPS[race.environment].look]
    return {**plan(call, manifest), "look": [results.index(name) for name in look]}


def plan(call: kernels.Call, manifest: kernels.Manifest) -> dict[str, Any]:
    """What the slots of a kernel hold at first.

    Returns:
        `slots` has, for each, a number, the index of an array as "@0", or that of a random stream as "#0"; `arrays` has
        the type, the shape and the contents of each array. An array that is reached in several ways is one array.
    """
    slots, arrays, known = list[Any](), list[Any](), dict[tuple[int, str], int]()
    order = iter(range(4))

    def add(value: Any) -> None:
        if isinstance(value, np.random.Generator):
            slots.append(f"#{next(order)}")
        elif isinstance(value, np.ndarray):
            key = value.ctypes.data, str(value.dtype)
            if key not in known:
                known[key] = len(arrays)
                alike = value.size == 0 or (value == value.flat[0]).all()
                numbers = value.flat[:1] if alike else value.ravel()
                arrays.append([str(value.dtype), value.size, [_number(number) for number in numbers.tolist()]])
            slots.append(f"@{known[key]}")
            slots.extend(value.shape)
        elif isinstance(value, tuple):
            for part in tuple.__iter__(value):
                add(part)
        elif value is not None:
            slots.append(_number(value))

    add(call.arguments)
    if len(slots) != manifest.results:
        raise ValueError(f"a kernel has {manifest.results} slots for arguments, but there are {len(slots)}")
    return {"slots": slots, "arrays": arrays}


def _number(value: Any) -> Any:
    """A number as JSON has it; infinity, which JSON does not have, as text."""
    if isinstance(value, bool):
        return int(value)
    return value if isinstance(value, int) or math.isfinite(value) else str(float(value)).replace("inf", "Infinity")


def optimum(mdp: Any) -> float:
    """The best expected return of an episode, from the exact model."""
    return edugym.value_iteration(edugym.finite_model(mdp), 1.0, horizon=task_of(mdp).max_steps).start


def random_return(mdp: Any) -> float:
    """The expected return of an episode of random actions, from the exact model."""
    model = edugym.finite_model(mdp)
    n_states, n_actions, _ = model.successors.shape
    policy = np.full((n_states, n_actions), 1 / n_actions)
    return edugym.policy_evaluation(model, policy, 1.0, horizon=task_of(mdp).max_steps).start


def buttons(race: Race, mdp: Any) -> Buttons:
    """What actions are called where somebody plays."""
    return [list(race.actions)] if race.actions else WORDS[race.environment].buttons(mdp)


def others(race: Race, mdp: Any) -> Iterator[tuple[str, float]]:
    """What simple players do, and what they get, for people to compare with."""
    task, rule = played(race, mdp), WORDS[race.environment].rule
    n_actions = int(task.action_space.n)
    if race.is_finite:  # what happens once in a thousand games is seldom seen in fewer
        at_random = random_return(race.measured(mdp))
    else:
        at_random = mean_return(task, lambda seen, rng: int(rng.integers(n_actions)))
    yield "moves at random", at_random
    if rule:
        what, choose = rule
        yield what, mean_return(task, lambda seen, rng: choose(seen))


def mean_return(mdp: Any, act: Callable[[Any, Random], int], n_steps: int = 10_000) -> float:
    """The mean return of somebody who acts so, over as many games as `n_steps` take."""
    limit, rng, total = task_of(mdp).max_steps or math.inf, np.random.default_rng(0), 0.0
    done = n_episodes = 0
    while done < n_steps:
        state, steps = mdp.initial(rng), 0
        while not mdp.terminal(state) and steps < limit:
            action = act(mdp.observation(state, rng), rng)
            state, last = mdp.transition(state, action, rng), state
            total += mdp.reward(last, action, state, rng)
            steps += 1
        done += steps
        n_episodes += 1
    return total / n_episodes


if __name__ == "__main__":
    main()
