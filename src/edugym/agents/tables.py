"""Tables of action values: how large they are, how to read them, and the target of a one-step update.

One loop over single entries finds the best action, counts its equals and draws among them, and makes no new array.
"""

from edugym.mdp.protocol import Random, Reals

ROUNDING = 1e-12
"""Values that differ by a smaller share than this count as equal: some thousand times the last digit of a float."""


def tied(value: float, best: float) -> bool:
    """Whether a value equals the best one but for rounding: they differ by less than 10⁻¹² of the best.

    One number, learned in two ways, may differ in its last digit: even with α = 1, Q + α (T - Q) is not always T. If
    that digit decided between actions that are equally good, the same one would win each time, and nothing would be
    left to chance. Only 0 equals 0.
    """
    return value == best or abs(float(value) - float(best)) < ROUNDING * abs(best)


def greedy_action(Q: Reals, state: int, rng: Random) -> int:
    """The action with the highest value in `state`: argmax_a Q(s, a). Among equals (see `tied`) it draws one."""
    best = 0
    ties = 1
    for action in range(1, Q.shape[1]):
        if tied(Q[state, action], Q[state, best]):
            ties += 1
            if replaces(ties, rng):
                best = action
        elif Q[state, action] > Q[state, best]:
            best = action
            ties = 1
    return best


def replaces(ties: int, rng: Random) -> bool:
    """Whether the last of `ties` equals replaces the one kept so far: with probability 1/ties, so all are as likely."""
    return rng.random() * ties < 1.0


def best_value(Q: Reals, state: int) -> float:
    """The highest action value in `state`: max_a Q(s, a)."""
    value = Q[state, 0]
    for action in range(1, Q.shape[1]):
        value = max(value, Q[state, action])
    return float(value)


def value_of_best(Q: Reals, other: Reals, state: int) -> float:
    """What `other` says of the best action of Q: other(s, argmax_a Q(s, a)); its mean over equally good ones."""
    highest = best_value(Q, state)
    total = 0.0
    ties = 0
    for action in range(Q.shape[1]):
        if tied(Q[state, action], highest):
            total += float(other[state, action])
            ties += 1
    return total / ties


def random_action(n_actions: int, rng: Random) -> int:
    """An action drawn uniformly."""
    return int(rng.random() * n_actions)


def epsilon_greedy_action(Q: Reals, state: int, epsilon: float, rng: Random) -> int:
    """A uniformly random action with probability ε, else the best one."""
    if rng.random() < epsilon:
        return random_action(Q.shape[1], rng)
    return greedy_action(Q, state, rng)


def epsilon_greedy_probability(Q: Reals, state: int, action: int, epsilon: float) -> float:
    """How likely `epsilon_greedy_action` is to choose an action: ε/n, and the best actions share 1 - ε."""
    share = epsilon / Q.shape[1]
    highest = best_value(Q, state)
    if not tied(Q[state, action], highest):
        return share
    ties = 0
    for other in range(Q.shape[1]):
        if tied(Q[state, other], highest):
            ties += 1
    return share + (1.0 - epsilon) / ties


def epsilon_greedy_value(Q: Reals, state: int, epsilon: float) -> float:
    """The mean action value under `epsilon_greedy_action`: ε mean_a Q(s, a) + (1 - ε) max_a Q(s, a)."""
    total = 0.0
    for action in range(Q.shape[1]):
        total += float(Q[state, action])
    return epsilon * total / Q.shape[1] + (1.0 - epsilon) * best_value(Q, state)


def one_step_target(reward: float, discount: float, next_value: float, terminated: bool) -> float:
    """What a one-step update moves towards: R + γ V(S'), or R alone when S' is terminal, since its value is 0.

    A truncated episode has not terminated: the value of its last state counts as in any other step.
    """
    return reward if terminated else reward + discount * next_value
