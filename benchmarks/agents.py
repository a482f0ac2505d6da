"""Every agent of the package against its own run in the interpreter, and the networks against Stable-Baselines3."""

from functools import partial
from typing import Any

import numpy as np

import edugym
from benchmarks.measure import Comparison, Contender, Work
from edugym import make_mdp, train
from edugym.adapters.double_buffer import DoubleBuffer
from edugym.adapters.fitting import tabular
from edugym.checks.contract import is_on_policy, learner
from edugym.compiled.execution import COMPILE_FROM
from edugym.training import loops
from edugym.training.machine_agent import MachineAgent
from edugym.training.trainers import new_log

ONE_STEP = ("SARSA", "ExpectedSARSA", "DoubleQLearning", "RiskSensitiveQLearning", "CountBased", "ActorCritic")
SEVERAL_STEPS = ("NStepSARSA", "TreeBackup", "SARSALambda", "QLambda", "DynaQ", "PrioritisedSweeping", "REINFORCE")
LIMIT = 100  # steps an episode in the interpreter; a test of speed, not of learning
SIMULATIONS = 100  # of one search
LINEAR = ("LinearQLearning", "SemiGradientSARSA")


def comparisons(quick: bool) -> list[Comparison]:
    """One for each agent; a few of them if it should be quick."""
    wanted = [*((name, 100.0) for name in ONE_STEP), *((name, 50.0) for name in (*SEVERAL_STEPS, *LINEAR))]
    made = [comparison(name, ratio) for name, ratio in (wanted[::7] if quick else wanted)]
    elsewhere = ("SampleAverage", "Bandit"), ("MaxminQLearning", "Casino"), ("HindsightQLearning", "Switches")
    others = [*(comparison(name, 50.0, environment) for name, environment in elsewhere), searches()]
    return made if quick else [*made, *others, networks(), real_actions(), *policy_gradients()]


def comparison(name: str, ratio: float, environment: str = "Boulder") -> Comparison:
    """An agent of the package at its defaults, in one of its environments."""
    create = getattr(edugym, name).create
    return Comparison(
        f"{name} on {environment}",
        "training steps",
        Contender("EduGym", partial(compiled, environment, create)),
        [Contender("the same in the interpreter", partial(interpreted, environment, create))],
        ratio_target=ratio,
    )


def searches() -> Comparison:
    """UCT before the first step in Supermarket, with simulations of 20 steps."""
    others = [Contender("the same in the interpreter", partial(searched, machine_code=False))]
    ours = Contender("EduGym", partial(searched, machine_code=True))
    return Comparison("UCT on Supermarket", "simulations", ours, others, ratio_target=50)


def networks() -> Comparison:
    """DQN on Catch, with one update in four steps."""
    others = [Contender("Stable-Baselines3's DQN, as many updates", baselines_dqn)]
    ours = Contender("EduGym", partial(compiled, "Catch", edugym.DQN.create))
    return Comparison("DQN on Catch", "training steps", ours, others, rate_target=60e3, ratio_target=12)


def real_actions() -> Comparison:
    """The Gaussian actor-critic on Trashbot."""

    def create(mdp: Any) -> Any:
        return edugym.GaussianActorCritic.create(
            mdp, features=edugym.TileCoding.create(mdp, tiles=[1, 1, 9, 9, 1, 1, 2])
        )

    others = [Contender("the same in the interpreter", partial(interpreted, "Trashbot", create))]
    ours = Contender("EduGym", partial(compiled, "Trashbot", create))
    return Comparison("GaussianActorCritic on Trashbot", "training steps", ours, others, rate_target=1e6)


def policy_gradients() -> list[Comparison]:
    """PPO with the same networks, copies, batches and epochs."""
    return [
        Comparison(
            f"PPO on {name}",
            "training steps",
            Contender("EduGym", partial(ppo, name)),
            [Contender("Stable-Baselines3's PPO, as many updates", partial(baselines_ppo, name))],
            ratio_target=3,
            turn_length=5.0,  # ours makes new copies and networks in each turn, Stable-Baselines3 goes on with its own
        )
        for name in ("Catch", "Trashbot")
    ]


def compiled(name: str, create: Any) -> Work:
    """Training as machine code, without evaluation but at the ends."""
    mdp = make_mdp(name)
    train(mdp, create(mdp), 10_000)  # compiled now

    def work(n: int) -> int:
        train(mdp, create(mdp), n, evaluate_every=n)
        return n

    return work


def interpreted(name: str, create: Any) -> Work:
    """The same loop in Python. Who has a table sees the rows of it."""
    mdp = make_mdp(name)
    mdp = tabular(mdp) if hasattr(create(mdp), "Q") else mdp

    def work(n: int) -> int:
        agent = create(mdp)
        view = DoubleBuffer(mdp, agent, is_on_policy(agent))
        learning = view.of(learner(agent))
        rngs = np.random.default_rng(0), np.random.default_rng(1)
        if is_on_policy(agent):
            moment: Any = loops.start_on_policy(view.mdp, learning, *rngs)
            loops.on_policy(n, view.mdp, learning, LIMIT, *rngs, new_log(), moment)
        else:
            moment = loops.start_off_policy(view.mdp, rngs[0])
            loops.off_policy(n, view.mdp, learning, LIMIT, *rngs, new_log(), moment)
        return n

    return work


def searched(machine_code: bool) -> Work:
    """Searches of `SIMULATIONS` each, as machine code or interpreted."""
    mdp, rng = make_mdp("Supermarket"), np.random.default_rng(0)
    state = mdp.initial(rng)
    agent = edugym.UCT.create(mdp, model=edugym.finite_model(mdp), simulations=SIMULATIONS, c=10.0)
    searching: Any = MachineAgent(agent, rng, state, COMPILE_FROM) if machine_code else agent

    def work(n: int) -> int:
        n = max(n // SIMULATIONS, 1)
        for _ in range(n):
            searching.act(state, rng)
        return n * SIMULATIONS

    return work


def ppo(name: str) -> Work:
    """Our PPO at its defaults, without evaluation but at the ends."""
    from edugym.deep import PPO

    algorithm = PPO.create(name)
    round_of_steps = algorithm.num_envs * algorithm.length

    def work(n: int) -> int:
        n = max(n // round_of_steps, 1) * round_of_steps
        algorithm.train(n, evaluate_every=n, evaluation_episodes=1)
        return n

    return work


def settings_for_baselines(ours: Any) -> dict[str, Any]:
    """The settings of our PPO by their names in Stable-Baselines3. Those that are not here are equal by default."""
    return {
        "n_steps": ours.length,
        "batch_size": ours.num_envs * ours.length // ours.minibatches,
        "n_epochs": ours.epochs,
        "gamma": ours.discount,
        "gae_lambda": ours.trace_decay,
        "clip_range": ours.clip,
        "ent_coef": ours.entropy_bonus,
        "policy_kwargs": {"net_arch": {"pi": [ours.hidden] * 2, "vf": [ours.hidden] * 2}},
    }


def baselines_ppo(name: str) -> Work:
    """Stable-Baselines3's PPO with the settings of ours."""
    from stable_baselines3 import PPO as BaselinesPPO

    from edugym.deep import PPO, stable_baselines3_env
    from edugym.deep.curves import one_thread

    ours = PPO.create(name)
    agent = BaselinesPPO(
        "MlpPolicy",
        stable_baselines3_env(name, ours.num_envs),
        learning_rate=ours.learning_rate,
        device="cpu",
        **settings_for_baselines(ours),
    )

    def work(n: int) -> int:
        before = agent.num_timesteps
        with one_thread():
            agent.learn(n, reset_num_timesteps=False)
        return int(agent.num_timesteps - before)

    return work


def baselines_dqn() -> Work:
    """Stable-Baselines3's DQN with the same network, batch and number of updates."""
    from stable_baselines3 import DQN

    from edugym.deep import stable_baselines3_env

    ours = edugym.DQN.create(make_mdp("Catch"))
    agent = DQN(
        "MlpPolicy",
        stable_baselines3_env("Catch", 1),
        learning_starts=ours.learn_from,
        train_freq=ours.learn_every,
        batch_size=len(ours.batch),
        target_update_interval=ours.learn_every * ours.copy_every,
        policy_kwargs={"net_arch": [len(ours.h)]},
        device="cpu",
    )

    def work(n: int) -> int:
        before = agent.num_timesteps
        agent.learn(n, reset_num_timesteps=False)
        return int(agent.num_timesteps - before)

    return work
