"""A learned memory in the corridor: recurrent PPO, a network that carries a state from step to step."""

from functools import partial
from typing import Any

from edugym.experiments.results.claims import Above, Claim
from edugym.experiments.results.tables import Results
from edugym_course.stored import Stored

N_STEPS = 150_000
RECURRENT = "recurrent PPO"


def trainer() -> Any:
    """Return the function that trains recurrent PPO.

    64 copies, rounds of 32 steps, batches of 512, learning rate 0.003, 4 epochs, discount 0.9, one LSTM of 64 units for
    policy and value.
    """
    from edugym.deep.baselines import stable_baselines3_run

    lstm = {"lstm_hidden_size": 64, "shared_lstm": True, "enable_critic_lstm": False, "net_arch": []}
    rounds: dict[str, Any] = {"n_steps": 32, "batch_size": 512, "n_epochs": 4}
    return partial(
        stable_baselines3_run,
        "MemoryCorridor",
        "RecurrentPPO",
        num_envs=64,
        learning_rate=3e-3,
        gamma=0.9,
        policy_kwargs=lstm,
        evaluate_every=N_STEPS // 10,
        **rounds,
    )


def learn_with_memory(**how: Any) -> Results:
    """Train recurrent PPO, which takes about half a minute a run.

    Args:
        **how: arguments of `edugym.deep.repeated.repeat_deep`, such as `repetitions`, `seed` and `jobs`.
    """
    from edugym.deep.repeated import repeat_deep

    return repeat_deep({RECURRENT: trainer()}, N_STEPS, **how)


STORED = Stored(
    "memory.recurrent",
    learn_with_memory,
    (
        "edugym.envs.memory_corridor",
        "edugym.deep.baselines",
        "edugym.deep.curves",
        "edugym.deep.vec_env",
        "edugym.deep.repeated",
    ),
)


def recurrent_claims(recurrent: Results) -> list[Claim]:
    """Return the claims on the learned memory."""
    return [
        Claim(
            "Recurrent PPO learns what to remember: it gets through corridor 4 and further without any window",
            "greedy return",
            recurrent.mean(RECURRENT),
            Above(10.0),
            remark="results of ten seeds, stored with the package",
        )
    ]
