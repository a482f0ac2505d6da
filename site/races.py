"""What the playground offers: for each environment its question, its strengths, and the agents that race in it.

Names and parameters are the package's, and the settings of agents those of the lessons.
"""

import math
from collections.abc import Mapping
from typing import Any

from offers import NONE, Agent, Measure, Race, Strength, Trial
from views import ASKED, CHANGING, LISTED, PIXELS, STEADY, bins, priced, window, within_the_air

import edugym
import edugym.objectives
from edugym_course.lessons.bandits import methods as bandits
from edugym_course.lessons.depth import methods as depth
from edugym_course.lessons.depth import targets
from edugym_course.lessons.dimensionality import methods as dimensionality
from edugym_course.lessons.exploration import methods as exploration
from edugym_course.lessons.goals import methods as goals
from edugym_course.lessons.maximisation_bias import methods as maximisation_bias
from edugym_course.lessons.memory import players as memory
from edugym_course.lessons.model_based import methods as model_based
from edugym_course.lessons.objectives import methods as objectives
from edugym_course.lessons.on_off_policy import methods as on_off_policy
from edugym_course.lessons.signal import methods as signal
from edugym_course.lessons.stochasticity import methods as stochasticity


def learning(module: Any) -> dict[str, Any]:
    """The settings that a lesson shares among its agents."""
    slips = edugym.EpsilonGreedy(module.EPSILON)
    return {"learning_rate": module.LEARNING_RATE, "discount": module.DISCOUNT, "exploration": slips}


USUAL = {
    edugym.QLearning: ("Q-learning", "learns what is best for somebody who never slips"),
    edugym.SARSA: ("SARSA", "learns what its own slips cost"),
    edugym.ExpectedSARSA: ("expected SARSA", "as SARSA, but with the mean of all that it might do next"),
    edugym.DoubleQLearning: ("double Q-learning", "keeps two lists, and lets one check the other"),
    edugym.NStepSARSA: ("n-step SARSA", "looks four rewards ahead"),
    edugym.TreeBackup: ("tree backup", "looks four steps ahead, without its slips"),
    edugym.QLambda: ("Q(λ)", "hands rewards back over many steps"),
    edugym.SARSALambda: ("SARSA(λ)", "hands rewards back over many steps, slips included"),
    edugym.DynaQ: ("Dyna-Q", "replays ten old steps after each new one"),
    edugym.PrioritisedSweeping: ("prioritised sweeping", "replays old steps, those first that change most"),
    edugym.RMax: ("R-max", "expects wonders of all that it does not know"),
}
"""What agents are called, and what they do, where nothing else is said."""


def usual(settings: Mapping[str, Any], *kinds: Any) -> tuple[Agent, ...]:
    """Agents of several kinds with the same settings."""
    return tuple(Agent(*USUAL[kind], kind, settings) for kind in kinds)


PULLING = learning(bandits)
HOPING = {**PULLING, "exploration": edugym.Greedy(), "initial_value": 1.0}
BANDIT = Race(
    "Bandit",
    "One of ten machines pays best. Who finds it?",
    "Pull an arm. The best one pays more often than the others, and nobody tells you which one it is.",
    (
        Agent("constant rate", "the best so far, or any; old rewards fade", edugym.QLearning, PULLING),
        Agent("optimism", "believes at first that every arm always pays", edugym.QLearning, HOPING),
        Agent(
            "sample average",
            "the best so far, or any; rewards count alike",
            edugym.SampleAverage,
            {"exploration": edugym.EpsilonGreedy(bandits.EPSILON)},
        ),
        Agent("greedy", "always the best average so far", edugym.SampleAverage, {"exploration": edugym.Greedy()}),
    ),
    2_000,
    Strength("gap", (0.05, 0.1, 0.2, 0.5, 1.0), 2),
    Trial(2, 10_000, 5),
    (),
    parameters={"max_steps": 100},
    seeds=20,
)
CLIMBING = learning(exploration)
RETURNING = {"learning_rate": exploration.LEARNING_RATE, "discount": exploration.DISCOUNT}
GREEDY = {**RETURNING, "learning_rate": 1.0, "exploration": edugym.EpsilonGreedy(0.0), "initial_value": 1.0}
UP_TO_ONE = {"discount": exploration.DISCOUNT, "highest_return": 1.0, "lowest_return": 0.0}
NOVELTY = {**CLIMBING, "bonus": exploration.BONUS}
EXPLORING = {**RETURNING, "explore_steps": exploration.EXPLORE_STEPS}
BOULDER = Race(
    "Boulder",
    "Only the top gives a reward. Who finds it?",
    "At every height one grip holds. Any other sends the climber back to the ground.",
    (
        Agent("Q-learning", "the best-known grip, sometimes a random one", edugym.QLearning, CLIMBING),
        Agent("novelty", "is rewarded for places that it has rarely visited", edugym.CountBased, NOVELTY),
        Agent("Go-Explore", "returns to a rarely visited place, then explores", edugym.GoExplore, EXPLORING),
        Agent("optimism", "greedy: what it has not tried looks best", edugym.QLearning, GREEDY),
        *usual(UP_TO_ONE, edugym.RMax),
        *usual(CLIMBING, edugym.SARSA, edugym.QLambda),
    ),
    exploration.N_STEPS,
    Strength("height", (4, 6, 8, 10, 12, 15, 20, 25, 30), 5),
    Trial(3, 20_000, 5),
    ("position",),
    ("ArrowLeft", "ArrowRight"),
    outcomes=("it holds", "it does not hold, back to the ground"),
    answer="Before the first reward all values are equal, so greedy play is random too, and a larger ε changes "
    "nothing: exploration must be directed. Novelty takes random grips on its way back up, too, and may fall; "
    "Go-Explore takes none there. A low wall is climbed by chance: at height 10 Q-learning gets up, too.",
)
RUNNING = learning(on_off_policy)
ROADRUNNER = Race(
    "Roadrunner",
    "One step too far is the drop. Who runs best at the end?",
    "Arrive exactly at the last cell before the cliff, which pays 1. Each step before costs 1. A fall costs 100. "
    "So does a stall, a speed below 0 (agents see it as 0).",
    usual(RUNNING, edugym.QLearning, edugym.SARSA, edugym.ExpectedSARSA, edugym.DoubleQLearning, edugym.NStepSARSA),
    on_off_policy.N_STEPS,
    Strength("size", (6, 8, 10, 12, 15, 20), 2),
    Trial(2, 5_000, 5),
    ("position", "speed"),
    ("ArrowLeft", "ArrowUp", "ArrowRight"),
    seeds=5,
)
STUDYING = {"learning_rate": depth.LEARNING_RATE, "discount": targets.DISCOUNT}
STUDY = Race(
    "Study",
    "A reward at the very end. Who finds out which days mattered?",
    "Study on the days of a lecture, sleep enough, and study on the day of the exam: 10 points.",
    (
        Agent("one step", "hands a reward back one day at a time", edugym.NStepSARSA, {**STUDYING, "n": 1}),
        Agent("five steps", "hands it back five days at once", edugym.NStepSARSA, {**STUDYING, "n": 5}),
        Agent("Monte Carlo", "hands it back to the first day at once", edugym.NStepSARSA, {**STUDYING, "n": math.inf}),
        *usual(STUDYING, edugym.QLearning, edugym.QLambda, edugym.TreeBackup, edugym.SARSALambda),
    ),
    depth.N_STEPS,
    Strength("total_days", (6, 8, 10, 15, 20, 30), 2),
    Trial(1, 5_000, 5),
    ("knowledge", "energy", "day"),
    seeds=20,
)
OF_LESSON: Any = dimensionality.network()
NETWORK = OF_LESSON.keywords
CATCHING = learning(dimensionality)
ADDING = {**CATCHING, "learning_rate": dimensionality.LINEAR_RATE}
CATCH = Race(
    "Catch",
    "The light changes at every step. Who still learns to catch?",
    "Be under the ball: 1 for a catch, −1 for a miss. The agents see pixels, brighter or darker each time.",
    (
        Agent("table", "a list: one line for each picture that it met", edugym.QLearning, CATCHING, LISTED),
        Agent("weighted sum", "gives each dot points, and adds them up", edugym.LinearQLearning, ADDING, CHANGING),
        Agent("network", "finds out by itself what to look for (DQN)", edugym.DQN, NETWORK, CHANGING),
        Agent("sum with slips", "the weighted sum, as SARSA learns it", edugym.SemiGradientSARSA, ADDING, CHANGING),
        Agent("table, steady light", "the list, where the light stays the same", edugym.QLearning, CATCHING, STEADY),
        Agent("network, steady light", "where the light stays the same", edugym.DQN, NETWORK, PIXELS),
        Agent("table of places", "is told where ball and paddle are", edugym.QLearning, CATCHING),
        Agent("Q(λ), places", "the same, with rewards handed back at once", edugym.QLambda, CATCHING),
        Agent("Dyna-Q, places", "the same, replaying ten old steps each time", edugym.DynaQ, CATCHING),
    ),
    dimensionality.N_STEPS,
    Strength("columns", (3, 5, 7, 9, 11), 1),
    Trial(1, 2_000, 10),
    ("ball's column", "ball's row", "paddle's column"),
    ("ArrowLeft", "ArrowDown", "ArrowRight"),
    {"observation_type": "vectorised"},
    answer="At every step the light is new, so no picture comes a second time, and the table finds an empty row each "
    "time. The network computes its values from the pixels.",
)
DOORS = learning(memory)
MEMORY_CORRIDOR = Race(
    "MemoryCorridor",
    "Only the last door is marked. How far does a memory reach?",
    "Each time you get through, the corridor grows by one place, and the same doors come again.",
    (
        Agent("no memory", "sees only what is there now", edugym.QLearning, DOORS),
        Agent("two sights", "also remembers the sight before", edugym.QLearning, DOORS, window(2, False)),
        Agent("three and actions", "three sights, and what it did", edugym.QLearning, DOORS, window(3, True)),
        Agent("two and actions", "two sights, and what it did", edugym.QLearning, DOORS, window(2, True)),
        Agent("SARSA, two", "two sights, and what it did", edugym.SARSA, DOORS, window(2, True)),
        Agent("SARSA, three", "three sights, and what it did", edugym.SARSA, DOORS, window(3, True)),
    ),
    memory.N_STEPS,
    Strength("num_doors", (2, 3, 4, 5), 1),
    Trial(1, 5_000, 10),
    ("mark",),
    is_finite=False,
)
CARING = learning(signal)
TAMAGOTCHI = Race(
    "Tamagotchi",
    "The toy says what it needs, more or less clearly. Who keeps it happy?",
    "The agent sees hit points and one word. The higher τ, the more often the word is wrong.",
    (
        Agent("Q-learning", "goes by the word that it hears now", edugym.QLearning, CARING),
        Agent("with memory", "also by the word before, and what it did", edugym.QLearning, CARING, window(2, True)),
        *usual(CARING, edugym.SARSA, edugym.ExpectedSARSA, edugym.DoubleQLearning),
    ),
    signal.N_STEPS,
    Strength("tau", (0.0, 0.02, 0.05, 0.1, math.inf), 1),
    Trial(0, 20_000, 5),
    ("hit points", "word"),
    is_finite=False,
    seeds=20,
)
TRASHBOT = Race(
    "Trashbot",
    "Real joints, a few choices. How many bring the box home best?",
    "Turn two joints: pick up the box at the left, and drop it into the container at the right, near its middle.",
    (
        Agent("3 bins", "each joint left, still or right: 9 actions", edugym.QLearning, NONE, bins(3)),
        Agent("5 bins", "five angles a joint: 25 actions", edugym.QLearning, NONE, bins(5)),
        Agent("9 bins", "nine angles a joint: 81 actions", edugym.QLearning, NONE, bins(9)),
        Agent("Q(λ), 3 bins", "hands rewards back over many steps", edugym.QLambda, NONE, bins(3)),
        Agent("Q(λ), 5 bins", "hands rewards back over many steps", edugym.QLambda, NONE, bins(5)),
    ),
    1_000_000,
    Strength("container_width", (0.3, 0.35, 0.4, 0.45, 0.6), 3),
    Trial(3, 20_000, 5),
    ("elbow x", "elbow y", "wrist x", "wrist y", "magnet x", "magnet y", "holding"),
    is_finite=False,
    seeds=5,
    actions=tuple(f"arm {upper} hand {fore}" for upper in "↻·↺" for fore in "↻·↺"),
    answer="The lesson also has an agent that names the angle itself. It does not race: the pictures here show what an "
    "agent expects of each choice, and it has no choices.",
)
GOLFING = learning(stochasticity)
GOLF = Race(
    "Golf",
    "A drive is fast and risky, putts are slow and safe. Who gets round best?",
    "Reach the green in few hits. The harder the hit, the farther the ball may miss. Around is water.",
    (
        Agent("neutral", "Q-learning: only the average counts", edugym.QLearning, GOLFING),
        Agent("careful", "bad surprises count more", edugym.RiskSensitiveQLearning, {**GOLFING, "risk": -2.0}),
        Agent("daring", "good surprises count more", edugym.RiskSensitiveQLearning, {**GOLFING, "risk": 2.0}),
        *usual(GOLFING, edugym.SARSA, edugym.DoubleQLearning),
    ),
    stochasticity.N_STEPS,
    Strength("stochasticity_level", (0.0, 0.005, 0.01, 0.015, 0.03, 0.06), 3),
    Trial(5, 500, 10),
    ("column", "row"),
    is_finite=False,
    seeds=20,
)
SHOPPING = learning(model_based)
SUPERMARKET = Race(
    "Supermarket",
    "Steps are dear. Who shops well after the fewest?",
    "Collect three items (25 each), and leave by the exit (50). Every step costs 1.",
    usual(SHOPPING, edugym.QLearning, edugym.DynaQ, edugym.PrioritisedSweeping)
    + usual({"discount": model_based.DISCOUNT}, edugym.RMax)
    + usual(SHOPPING, edugym.QLambda, edugym.SARSA),
    2_000,  # a fifth of the lesson's: later Q-learning has caught up
    Strength("max_steps", (100, 200, 500, 1000), 2),
    Trial(0, 5_000, 5),
    ("place and items",),
    ("ArrowUp", "ArrowDown", "ArrowLeft", "ArrowRight"),
    seeds=20,
    answer="A model lets an agent learn without taking steps. With "
    f"{model_based.N_STEPS // 1000} k steps (Settings) Q-learning has caught up, and shops better than Dyna-Q and "
    "prioritised sweeping: these stay with the way that they know.",
)

FLIPPING = {"learning_rate": goals.LEARNING_RATE, "discount": goals.DISCOUNT}
SWITCHES = Race(
    "Switches",
    "Another goal in each episode. Who learns from what it has missed?",
    "Flip the switches until they are as the cards say. Below, colours count: none wrong, one, two, ...",
    (
        Agent("no hindsight", "learns only for the goal that was set", edugym.QLearning, FLIPPING),
        Agent(
            "final",
            "afterwards: as if it had wanted what it got",
            edugym.HindsightQLearning,
            {**FLIPPING, "hindsight": edugym.FinalGoal()},
        ),
        Agent(
            "future",
            "the same, for four things that it got later",
            edugym.HindsightQLearning,
            {**FLIPPING, "hindsight": edugym.FutureGoals(4)},
        ),
        *usual(FLIPPING, edugym.SARSA, edugym.DynaQ),
    ),
    goals.N_STEPS,
    Strength("n_switches", (2, 3, 4, 5), 3),
    Trial(2, 5_000, 5),
    (),
    episodes=20,
    seeds=20,
)
DIVING = {"learning_rate": 1.0, "discount": 1.0, "exploration": objectives.AT_RANDOM}


def distance(weight: float, whole: bool = True) -> dict[str, Any]:
    """The settings of an agent that goes by the Chebyshev distance."""
    return {**DIVING, "weights": (1.0, weight), "whole_returns": whole}


LIMITED = {
    "learning_rate": 1.0,
    "discount": 1.0,
    "limits": (-float(objectives.LIMIT),),
    "initial_values": (100.0, 0.0),
    "multiplier_rate": objectives.PRICE_RATE,
    "exploration": edugym.Greedy(),
}
CHEBYSHEV = edugym.objectives.ChebyshevQLearning
DIVER = Race(
    "Diver",
    "The air lasts for seven steps. Who brings up the most?",
    "Deeper treasures are worth more, but too deep ones count for nothing. Concavity makes the middle ones poorer.",
    (
        Agent("price 4", "Q-learning: a step costs 4 of the value", edugym.QLearning, DIVING, priced(4.0)),
        Agent("price 6", "the same: a step costs 6 of the value", edugym.QLearning, DIVING, priced(6.0)),
        Agent("distance", "lets neither value nor time fall far behind", CHEBYSHEV, distance(8.0), ASKED),
        *(
            Agent(f"price {price:g}", f"a step costs {price:g} of the value", edugym.QLearning, DIVING, priced(price))
            for price in (1.0, 2.0, 5.0, 5.5, 5.75, 7.0)
        ),
        Agent(
            "learned price",
            "steps get dearer after a long dive, else cheaper",
            edugym.objectives.LagrangianQLearning,
            LIMITED,
            ASKED,
        ),
        Agent("distance, rest only", "forgets the steps already taken", CHEBYSHEV, distance(8.0, False), ASKED),
    ),
    objectives.N_STEPS,
    Strength("concavity", (0.0, 0.25, 0.5, 0.75, 1.0), 2),
    Trial(2, 500, 10),
    ("cell",),
    ("ArrowDown", "ArrowRight"),
    measure=Measure(
        within_the_air,
        f"The value that a dive without exploring brings up within {objectives.LIMIT} steps",
        f"run.returns[:, 0] * (run.returns[:, 1] >= -{objectives.LIMIT})",
    ),
    episodes=1,
    answer="A price makes one number of value and steps. From a concavity of 0.5 on, no price prefers the "
    "treasure that takes seven steps: with every price a deeper one or the first is worth more. The distance looks "
    "at value and steps one by one. A learned price keeps to seven steps on average only: it dives too deep, then not "
    "deep enough. Pareto Q-learning does not race: its sets of vectors grow and shrink, which this page's machine "
    "code cannot do.",
)
PASSING = learning(maximisation_bias)
TWO_TABLES, EIGHT_TABLES = ({**PASSING, "n_tables": n} for n in (2, 8))
CASINO = Race(
    "Casino",
    "Every machine loses. Who stays out?",
    "Go home for nothing, or go in and play a machine. It pays 0.9 or takes 1.1, with equal chances.",
    (
        Agent("Q-learning", "believes the machine that looks best", edugym.QLearning, PASSING),
        Agent("double", "asks a second list what that one is worth", edugym.DoubleQLearning, PASSING),
        Agent("maxmin", "makes two guesses, believes the smaller", edugym.MaxminQLearning, TWO_TABLES),
        Agent("maxmin, eight", "makes eight guesses, believes the smallest", edugym.MaxminQLearning, EIGHT_TABLES),
        *usual(PASSING, edugym.ExpectedSARSA, edugym.SARSA),
    ),
    100,  # some 60 episodes: later the machines have been found out, by Q-learning too
    Strength("n_machines", (1, 2, 5, 10, 15), 3),
    Trial(3, 100, 5),
    ("place",),
    episodes=50,
    seeds=20,
)
RACES = (
    BANDIT,
    BOULDER,
    ROADRUNNER,
    STUDY,
    CATCH,
    MEMORY_CORRIDOR,
    TAMAGOTCHI,
    TRASHBOT,
    GOLF,
    SUPERMARKET,
    SWITCHES,
    DIVER,
    CASINO,
)
"""One for each environment that has a lesson, in the order of the lessons."""
