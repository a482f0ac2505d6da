"""Data instead of interaction: steps that some policy took before, and the episodes that they belong to."""

from typing import Any, NamedTuple

import numpy as np

from edugym.checks.parameters import an_array, between, flags, in_short, whole_number
from edugym.exact.policy_evaluation import as_probabilities
from edugym.exact.tables import FiniteModel
from edugym.exact.values import require_model
from edugym.mdp.protocol import Integers, Random, Reals

MOST_STEPS = 10_000_000
"""Of a dataset that is collected: so many take a gigabyte and ten seconds."""
LONGEST = 20_000
"""The most steps of an episode in a task without a step limit: one that is longer may never end."""

Flags = np.ndarray[tuple[int, ...], np.dtype[np.bool_]]


class Dataset(NamedTuple):
    """Steps that a behaviour policy b took, episode after episode, each in the order of time.

    States are rows of a model (`model.row(state)` gives the row of a state), so that all tables of values and all
    policies go by the same rows. Make one with `Dataset.create`, which checks it, or with `collect`.

    Attributes:
        states: shape (n,): S, the row of the state in which the step began.
        actions: shape (n,): A.
        rewards: shape (n,): R.
        next_states: shape (n,): S', the row of the state in which the step ended.
        terminated: shape (n,): whether the task ended there, so that nothing more could be gathered.
        truncated: shape (n,): whether the episode was cut off there, though more would have come.
        probabilities: shape (n,): b(A|S), with which the behaviour policy took the action.
        n_states: how many rows there are.
        n_actions: how many actions there are.
    """

    states: Integers
    actions: Integers
    rewards: Reals
    next_states: Integers
    terminated: Flags
    truncated: Flags
    probabilities: Reals
    n_states: int
    n_actions: int

    def __repr__(self) -> str:
        """Its sizes."""
        sizes = f"{self.n_states} states, {self.n_actions} actions"
        return f"<dataset: {len(self.states)} steps in {self.n_episodes} episodes; {sizes}>"

    @property
    def ends(self) -> Integers:
        """Shape (n_episodes,): the place of the last step of each episode."""
        return np.flatnonzero(self.terminated | self.truncated)

    @property
    def starts(self) -> Integers:
        """Shape (n_episodes,): the place of the first step of each episode."""
        return np.append(0, self.ends[:-1] + 1)

    @property
    def n_episodes(self) -> int:
        """How many episodes there are."""
        return len(self.ends)

    @property
    def visits(self) -> Integers:
        """Shape (n_states, n_actions): how often each action was taken in each state."""
        pairs = self.states * self.n_actions + self.actions
        return np.bincount(pairs, minlength=self.n_states * self.n_actions).reshape(self.n_states, self.n_actions)

    def returns(self, discount: float = 1.0) -> Reals:
        """What each episode gathered: G = Σ_t γ^t R_t+1, shape (n_episodes,).

        Args:
            discount: γ, from 0 to 1.

        Raises:
            ValueError: the discount is not as above.
        """
        between("discount", discount, 0, 1)
        lengths = self.ends - self.starts + 1
        times = np.arange(len(self.states)) - np.repeat(self.starts, lengths)
        gathered: Reals = np.add.reduceat(self.rewards * float(discount) ** times, self.starts)
        return gathered

    @classmethod
    def create(
        cls,
        states: Any,
        actions: Any,
        rewards: Any,
        next_states: Any,
        terminated: Any,
        truncated: Any,
        probabilities: Any,
        n_states: int,
        n_actions: int,
    ) -> "Dataset":
        """A dataset of steps, which are checked.

        Args:
            states: shape (n,): whole numbers from 0 to n_states - 1; there is one step or more.
            actions: shape (n,): whole numbers from 0 to n_actions - 1.
            rewards: shape (n,): finite numbers.
            next_states: shape (n,): like `states`. Within an episode each is the state of the step that follows.
            terminated: shape (n,): True or False.
            truncated: shape (n,): True or False; never True where `terminated` is. One of the two is True at the
                last step of each episode, and so at the last step of all.
            probabilities: shape (n,): greater than 0 and up to 1.
            n_states: from 1 to 10 million.
            n_actions: from 1 to 10 000.

        Raises:
            ValueError: something is not as above.
        """
        n_states = whole_number("n_states", n_states, 1, 10_000_000)
        n_actions = whole_number("n_actions", n_actions, 1, 10_000)
        rows = _whole_numbers("states", states, n_states)
        n = len(rows)
        if n == 0:
            raise ValueError(f"states must hold one step or more, but is {in_short(states)}")
        ended, cut = flags("terminated", terminated, n, "steps"), flags("truncated", truncated, n, "steps")
        paid = an_array("rewards", rewards, (n,))
        taken = an_array("probabilities", probabilities, (n,))
        if not np.isfinite(paid).all():
            raise ValueError(f"rewards must be finite numbers, but one is {paid[~np.isfinite(paid)][0]}")
        if not ((taken > 0) & (taken <= 1)).all():
            wrong = taken[~((taken > 0) & (taken <= 1))][0]
            raise ValueError(f"probabilities must be greater than 0 and at most 1, but one is {wrong}")
        after = _whole_numbers("next_states", next_states, n_states, n)
        if (ended & cut).any():
            raise ValueError("truncated must be False where terminated is True: an episode ends in one way")
        over = ended | cut
        if not over[-1]:
            raise ValueError("terminated or truncated must be True at the last step: where does the last episode end?")
        torn = np.flatnonzero(~over[:-1] & (after[:-1] != rows[1:]))
        if len(torn):
            raise ValueError(
                f"next_states must hold the state of the step that follows, but step {torn[0]} ends in"
                f" {after[torn[0]]}, and the next one begins in {rows[torn[0] + 1]}: where an episode ends, terminated"
                " or truncated must be True"
            )
        chosen = _whole_numbers("actions", actions, n_actions, n)
        return cls(rows, chosen, paid, after, ended, cut, taken, n_states, n_actions)


def collect(
    model: FiniteModel, policy: Any, n_episodes: int, *, max_steps: int | None = None, seed: int | None = None
) -> Dataset:
    """Let a policy play episodes, and write down each step: data for learning without interaction.

    All episodes are played at once, on the exact model, so that a million steps take about a second. Rewards are
    the means r(s, a, s') of the model.

    Args:
        model: the exact model, by whose rows the dataset goes.
        policy: b, the behaviour policy: shape (S, A), the probability of every action in every state, or shape (S,),
            an action for every state. `policy_of(agent, model)` gives that of an agent.
        n_episodes: how many, from 1 to 10 million.
        max_steps: after how many steps an episode is cut off, from 1 to 10 million; None for the step limit of the
            task, `model.mdp.max_steps`, if it has one.
        seed: with a seed, the same call gives the same data.

    Raises:
        ValueError: a parameter is not as above, an episode would begin at its end, there would be more than 10 million
            steps, or, without a limit, an episode of more than 20 000.
    """
    require_model(model)
    taken = as_probabilities(policy, model)
    n_episodes = whole_number("n_episodes", n_episodes, 1, MOST_STEPS)
    limit = getattr(model.mdp, "max_steps", None) if max_steps is None else max_steps
    limit = None if limit is None else whole_number("max_steps", limit, 1, 10_000_000)
    if seed is not None:
        seed = whole_number("seed", seed, 0)
    if (model.terminal & (model.initial > 0)).any():
        raise ValueError("model must begin episodes in states that are not terminal: else there is no step to write")
    rng = np.random.default_rng(seed)
    playing = np.arange(n_episodes)  # the numbers of the episodes that go on
    states = rng.choice(len(model.states), n_episodes, p=model.initial / model.initial.sum())
    columns: list[tuple[Any, ...]] = []
    n_steps = 0
    while len(playing):
        n_steps += len(playing)
        if n_steps > MOST_STEPS or (limit is None and len(columns) == LONGEST):
            raise ValueError(
                f"max_steps must keep the dataset below {MOST_STEPS} steps, but after {len(columns)} steps"
                f" {len(playing)} of {n_episodes} episodes go on: max_steps=100 cuts each off after so many"
            )
        actions = drawn(taken[states], rng)
        ways = drawn(model.probabilities[states, actions], rng)
        after, paid = model.successors[states, actions, ways], model.rewards[states, actions, ways]
        ended = model.terminal[after]
        cut = ~ended & (len(columns) + 1 == limit)
        columns.append((playing, states, actions, paid, after, ended, cut, taken[states, actions]))
        playing, states = playing[~(ended | cut)], after[~(ended | cut)]
    episodes, *rest = (np.concatenate(parts) for parts in zip(*columns, strict=True))
    order = np.argsort(episodes, kind="stable")  # by episode, and within it by time
    before, actions, paid, after, ended, cut, taken_with = (part[order] for part in rest)
    return Dataset(before, actions, paid, after, ended, cut, taken_with, len(model.states), taken.shape[1])


def require_dataset(dataset: Any) -> None:
    """Check that something is a dataset.

    Raises:
        ValueError: it is not.
    """
    if not isinstance(dataset, Dataset):
        raise ValueError(
            f"dataset must be a Dataset, as collect(model, policy, 100) makes it, but is {in_short(dataset)}"
        )


def policy_for(dataset: Dataset, policy: Any) -> Reals:
    """The policy to be evaluated, as the probability of every action in every state.

    Raises:
        ValueError: it has another shape, actions that are not there, or probabilities that are none.
    """
    return as_probabilities(policy, (dataset.n_states, dataset.n_actions))


def drawn(probabilities: Reals, rng: Random) -> Integers:
    """A number drawn for each row of a table, by the probabilities in it."""
    up_to = probabilities.cumsum(axis=1)
    below: Integers = (rng.random((len(up_to), 1)) * up_to[:, -1:] >= up_to).sum(axis=1)
    return below


def _whole_numbers(name: str, values: Any, n: int, length: int | None = None) -> Integers:
    """Whole numbers from 0 to n - 1, in an array of one axis.

    Raises:
        ValueError: they are something else.
    """
    numbers = an_array(name, values, ("n",) if length is None else (length,))
    wrong = ~((numbers >= 0) & (numbers < n) & (numbers == np.floor(numbers)))
    if wrong.any():
        raise ValueError(f"{name} must be whole numbers from 0 to {n - 1}, but one is {numbers[wrong][0]:g}")
    return numbers.astype(np.int64)
