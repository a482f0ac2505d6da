# ruff: noqa
# Right and wrong answers to the exercises of lesson 9; tests/lessons/test_answers.py tries them all.
# An answer stands in the place of the exercise's cell. Methods without their class replace those of the solution.

# %% setup
# Exercise 4 needs what came out of the student's method: it trains, and is evaluated at three points only, to save
# time. Where the experiment is another one, any agent will do: the check does not get as far as what came out.
import math
from fractions import Fraction
import edugym.training.repeat
from edugym import SARSA
from edugym.agents.strategies import ScheduledEpsilonGreedy
from edugym.training.train import Run, train


def with_few_points(environment, agent, n_steps, *, seed, **how):
    if isinstance(getattr(agent, "exploration", None), ScheduledEpsilonGreedy):  # those of the lesson
        return Run(np.array([0, n_steps]), np.zeros(2), np.zeros(2), np.zeros(2, int), agent, seed, 0.0, True)
    few = {"evaluate_every": n_steps // 2, "evaluation_episodes": 10}
    return train(environment, agent, n_steps, seed=seed, **{**how, **few})


edugym.training.repeat.train = with_few_points
lake = gym.make("FrozenLake-v1", map_name="4x4", is_slippery=True)
methods = {label: model_based.LEARNED[label] for label in ("Q-learning", "Dyna-10")}


# %% exercise 1, right: expanded
# says: Right: the larger γ is, the smaller an error is enough, since a far-sighted plan adds up more bumps.
def smallest_error(v, gamma):
    return 1 + v - gamma * v


# %% exercise 1, right: a lambda
smallest_error = lambda v, gamma: (1 - gamma) * v + 1


# %% exercise 1, right: other names
def smallest_error(value, discount):
    return value * (1 - discount) + 1.0


# %% exercise 1, right: by bisection
def smallest_error(v, gamma):
    low, high = 0.0, 1000.0
    for _ in range(100):
        e = (low + high) / 2
        if (e - 1) / (1 - gamma) > v:
            high = e
        else:
            low = e
    return high


# %% exercise 1, right: a NumPy number
def smallest_error(v, gamma):
    return np.float64(1) + (1 - gamma) * np.array(v)


# %% exercise 1, right: a fraction
def smallest_error(v, gamma):
    return Fraction(1) + (1 - Fraction(gamma)) * Fraction(v)


# %% exercise 1, right: in steps
def smallest_error(v, gamma):
    reward_that_breaks_even = v * (1 - gamma)
    cost = -1
    return reward_that_breaks_even - cost


# %% exercise 1, wrong: nothing
# says: Not solved yet
def smallest_error(v, gamma):
    raise NotImplementedError


# %% exercise 1, wrong: the placeholder
# says: Not solved yet
smallest_error = ...

# %% exercise 1, wrong: a number
# says: should be a function
# says: v and gamma
smallest_error = 3.0


# %% exercise 1, wrong: without the cost
# says: the step costs 1, which the error has to pay first: the reward of a bump seems to be e − 1
def smallest_error(v, gamma):
    return (1 - gamma) * v


# %% exercise 1, wrong: the cost with the wrong sign
# says: the cost of the step is −1, so solve e − 1 = (1 − γ) v for e: it adds 1
def smallest_error(v, gamma):
    return (1 - gamma) * v - 1


# %% exercise 1, wrong: divided
# says: bumping for ever is worth the reward *divided* by 1 − γ
def smallest_error(v, gamma):
    return 1 + v / (1 - gamma)


# %% exercise 1, wrong: the value at once
# says: that leaves the future out: one bump alone need not be worth v, for it is followed by more
def smallest_error(v, gamma):
    return 1 + v


# %% exercise 1, wrong: gamma v
# says: that compares with γ v; compare with v, what the best way is worth from here
def smallest_error(v, gamma):
    return 1 + gamma * v


# %% exercise 1, wrong: 1
# says: that is 1, the error from which a bump pays at all; it must pay more than leaving
def smallest_error(v, gamma):
    return 1


# %% exercise 1, wrong: v
# says: that is v itself
def smallest_error(v, gamma):
    return v


# %% exercise 1, wrong: without an error
# says: that is what bumping is worth without an error, −1/(1 − γ)
def smallest_error(v, gamma):
    return -1 / (1 - gamma)


# %% exercise 1, wrong: the cost comes once
# says: that solves e/(1 − γ) − 1 = v: the cost of 1 comes with every bump
def smallest_error(v, gamma):
    return (1 - gamma) * (v + 1)


# %% exercise 1, wrong: plus gamma
# says: the sign of γ is wrong: the sum 1 + γ + γ² + ... is 1/(1 − γ)
def smallest_error(v, gamma):
    return 1 + (1 + gamma) * v


# %% exercise 1, wrong: minus
# says: that is 1 − (1 − γ) v: the two terms add up
def smallest_error(v, gamma):
    return 1 - (1 - gamma) * v


# %% exercise 1, wrong: the cost twice
# says: the cost is subtracted twice
def smallest_error(v, gamma):
    return 2 + (1 - gamma) * v - gamma


# %% exercise 1, wrong: three bumps
# says: only the first three bumps are counted, and there is no end to them
def smallest_error(v, gamma):
    return 1 + v / (1 + gamma + gamma**2)


# %% exercise 1, wrong: no return
# says: is a `return` missing
def smallest_error(v, gamma):
    1 + (1 - gamma) * v


# %% exercise 1, wrong: divided by zero
# says: ZeroDivisionError
def smallest_error(v, gamma):
    return 1 + v / (gamma - gamma)


# %% exercise 1, wrong: one parameter
# says: its parameters are not those of the exercise
def smallest_error(v):
    return 1 + v


# %% exercise 1, wrong: a text
# says: leave the quotes out
def smallest_error(v, gamma):
    return "1 + (1 - gamma) * v"


# %% exercise 1, wrong: half of it
# says: solve (e − 1)/(1 − γ) = v for e
def smallest_error(v, gamma):
    return 1 + (1 - gamma) * v / 2


# %% exercise 2, right: two branches
# says: Right: what was not tried for a long time looks better and better, until the agent goes and sees. See its race:
def imagine(self, s, a):
    tau = self.clock[0] - self.last[s, a]
    bonus = self.kappa * np.sqrt(tau)
    if self.last[s, a] == 0:
        return bonus + self.discount * np.max(self.Q[s])
    if self.ends[s, a]:
        return self.rewards[s, a] + bonus
    return self.rewards[s, a] + bonus + self.discount * np.max(self.Q[self.next_states[s, a]])


# %% exercise 2, right: 1 less the end
def imagine(self, s, a):
    if self.last[s, a] > 0:
        future = (1 - self.ends[s, a]) * self.Q[self.next_states[s, a]].max()
    else:
        future = self.Q[s].max()
    return self.rewards[s, a] + self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5 + self.discount * future


# %% exercise 2, right: a loop for the maximum
def imagine(self, s, a):
    n = s
    if self.last[s, a] > 0:
        n = self.next_states[s, a]
    best = self.Q[n, 0]
    for b in range(1, self.Q.shape[1]):
        if self.Q[n, b] > best:
            best = self.Q[n, b]
    target = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    if self.last[s, a] > 0:
        target += self.rewards[s, a]
    if self.last[s, a] == 0 or self.ends[s, a] == 0:
        target += self.discount * best
    return target


# %% exercise 2, right: math.sqrt
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * math.sqrt(self.clock[0] - self.last[s, a])
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, right: argmax and entry
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else self.Q[next_state, np.argmax(self.Q[next_state])]
    return reward + bonus + self.discount * value


# %% exercise 2, right: other parameter names
def imagine(self, state, action):
    reward, next_state, ended = (
        self.rewards[state, action],
        self.next_states[state, action],
        self.ends[state, action] == 1,
    )
    if self.last[state, action] == 0:
        reward, next_state, ended = 0.0, state, False
    bonus = self.kappa * (self.clock[0] - self.last[state, action]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, right: the clock first
def imagine(self, s, a):
    now = self.clock[0]
    known = self.last[s, a] != 0
    r = self.rewards[s, a] if known else 0.0
    r = r + self.kappa * (now - self.last[s, a]) ** (1 / 2)
    if known and self.ends[s, a] == 1:
        return r
    return r + self.discount * max(self.Q[self.next_states[s, a] if known else s])


# %% exercise 2, wrong: no bonus
# says: the bonus is missing
# says: ), where γ = 0.75, κ = 2,
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + self.discount * value


# %% exercise 2, wrong: no root
# says: the root is missing: the bonus is κ√τ
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a])
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: kappa under the root
# says: κ belongs before the root: κ√τ, not √(κτ)
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = (self.kappa * (self.clock[0] - self.last[s, a])) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: the bonus subtracted
# says: the bonus is subtracted
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward - bonus + self.discount * value


# %% exercise 2, wrong: no bonus for what was never tried
# says: only actions that were tried get a bonus, and those that were never tried need it most
# says: , the action was never tried and Q[
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = (self.last[s, a] > 0) * self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: a bonus for what was never tried only
# says: only actions that were never tried get a bonus; every action does
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = (self.last[s, a] == 0) * self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: the time of the last try
# says: τ is the time *since* the last try, `now − last`, and that is the time of the last try
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * self.last[s, a] ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: the clock
# says: τ is the time since the last try; subtract `last` from the clock
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * self.clock[0] ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: one more
# says: τ is one too large
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a] + 1) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: the end ignored
# says: after a terminal state there is no future: leave γ max_a Q(S', a) out where `ends` is 1
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: what was never tried is the bonus alone
# says: an action that was never tried is imagined to lead back to its own state, so γ max_a Q(s, a) belongs to its
#   target
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, True
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: what was never tried is 0
# says: an action that was never tried has a target too: reward 0, back to its own state, and the bonus
def imagine(self, s, a):
    if self.last[s, a] == 0:
        return 0.0
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: reads the empty tables
# says: an action that was never tried has nothing in the tables yet, so do not read `next_states` there: it leads back
#   to its own state
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward = 0.0
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: the mean
# says: the mean over the actions stands where the maximum should
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else self.Q[next_state].mean()
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: the own state
# says: the maximum is taken over Q(s, a) of the state itself instead of the next state
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[s])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: the same action
# says: the value of the *same* action stands where the maximum over all actions should
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else self.Q[next_state, a]
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: no future
# says: the value of the next state is missing
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus


# %% exercise 2, wrong: no discount
# says: the value of the next state is not discounted
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + value


# %% exercise 2, wrong: the bonus discounted
# says: the bonus is discounted; γ belongs to the value of the next state only
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + self.discount * (bonus + value)


# %% exercise 2, wrong: no reward
# says: the reward is missing
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return bonus + self.discount * value


# %% exercise 2, wrong: the TD error
# says: that is the TD error: return the whole target, which `act` puts into Q
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value - self.Q[s, a]


# %% exercise 2, wrong: no bonus at the end
# says: at the end of an episode the bonus is lost: only the value of the next state is 0 there
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + (0.0 if ended else bonus) + self.discount * value


# %% exercise 2, wrong: does the update itself
# says: changes a table: it should only return the target, and `act` puts that into Q
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    self.Q[s, a] = reward + bonus + self.discount * value


# %% exercise 2, wrong: does the update and returns it
# says: `act` puts that into Q
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    self.Q[s, a] = reward + bonus + self.discount * value
    return self.Q[s, a]


# %% exercise 2, wrong: no return
# says: is a `return` missing
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    total = reward + bonus + self.discount * value


# %% exercise 2, wrong: self forgotten
# says: NameError
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: not solved
# says: Not solved yet
def imagine(self, s, a):
    raise NotImplementedError


# %% exercise 2, wrong: the clock as an array
# says: take an entry
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: any action of the state asked
# says: that asks whether any action of the state was tried; ask whether this *pair* was tried: `self.last[s, a] == 0`
# says: this *pair*
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if max(self.last[s]) == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: the list of states asked
# says: whether any action of the state was tried
# says: this *pair*
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if s not in self.seen[: self.n_seen[0]]:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: the value of the action that was never tried
# says: for an action that was never tried the target has the *largest* value of the state, max_a Q(s, a), and not the
#   value of that action
def imagine(self, s, a):
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    if self.last[s, a] == 0:
        return bonus + self.discount * self.Q[s, a]
    value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
    return self.rewards[s, a] + bonus + self.discount * value


# %% exercise 2, wrong: by the reward asked
# says: a reward may be 0, so it does not say that nothing was tried; ask whether this *pair* was tried: `self.last[s,
#   a] == 0`
# says: this *pair*
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.rewards[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: by the next state asked
# says: the next state may be 0, so it does not say that nothing was tried; ask whether this *pair* was tried:
#   `self.last[s, a] == 0`
# says: this *pair*
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.next_states[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: the discount as a number
# says: everything fits a discount of 0.99: use self.discount
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + 0.99 * value


# %% exercise 2, wrong: kappa as a number
# says: everything fits a κ of 0.03: use self.kappa
def imagine(self, s, a):
    reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
    if self.last[s, a] == 0:
        reward, next_state, ended = 0.0, s, False
    bonus = 0.03 * (self.clock[0] - self.last[s, a]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value


# %% exercise 2, wrong: another class
# says: DynaPlus should have the method `imagine`
class DynaPlus(NamedTuple):
    Q: np.ndarray
    discount: float = 0.99
    kappa: float = 0.03

    def act(self, state, rng):
        return 0

    def learn(self, state):
        pass

    @classmethod
    def create(cls, environment):
        return cls(np.zeros((6, 3)))


# %% exercise 2, wrong: one more, another way
# says: that is none of the usual mistakes, so compare your code with the equation, term by term
def imagine(self, s, a):
    return self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5 + self.discount * self.Q[s].max() + 1.0


# %% exercise 3, right: return early
# says: Right: the unknown is worth U, so the way to it is planned like any other way. In the race its policy goes on
#   exploring, since it has one table only, until all that matters is known; then it jumps to the optimum:
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action]:
        return
    self.known[state, action] += 1
    self.rewards[state, action] = reward
    self.next_states[state, action] = next_state
    self.ends[state, action] = terminated
    self.plan()


# %% exercise 3, right: continue
def sweep(self):
    largest = 0.0
    n_states, n_actions = self.Q.shape
    for s in range(n_states):
        for a in range(n_actions):
            if self.known[s, a] == 0:
                continue
            old = self.Q[s, a]
            target = self.rewards[s, a]
            if not self.ends[s, a]:
                target += self.discount * self.Q[self.next_states[s, a]].max()
            self.Q[s, a] = target
            if abs(target - old) > largest:
                largest = abs(target - old)
    return largest


# %% exercise 3, right: from a copy
def sweep(self):
    old = self.Q.copy()
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(old[self.next_states[s, a]])
                self.Q[s, a] = self.rewards[s, a] + self.discount * value
    return np.max(np.abs(self.Q - old))


# %% exercise 3, right: 1 less the end
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = (1 - self.ends[s, a]) * max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% exercise 3, right: backwards
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0] - 1, -1, -1):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% exercise 3, right: int
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = int(terminated)
        self.plan()


# %% exercise 3, right: both methods
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] < 1:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()


def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% exercise 3, right: all at once
def sweep(self):
    V = self.Q.max(axis=1)
    new = self.rewards + self.discount * np.where(self.ends == 1, 0.0, V[self.next_states])
    new = np.where(self.known == 1, new, self.Q)
    largest = np.abs(new - self.Q).max()
    self.Q[:] = new
    return largest


# %% exercise 3, wrong: unknown pairs too
# says: pairs that are not known change as well; leave them at U, which is what makes the agent curious
# says: after many sweeps with γ = 0.5, Q[
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if True:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% exercise 3, wrong: unknown pairs are 0
# says: pairs that are not known are set to 0; leave them at U, which is what makes the agent curious
# says: ], a pair that is
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
            else:
                self.Q[s, a] = 0.0
    return largest


# %% exercise 3, wrong: the test the wrong way round
# says: the test of `known` is the wrong way round
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 0:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% exercise 3, wrong: the end ignored
# says: after a terminal state there is no future: leave γ max_a Q(s', a) out where `ends` is 1
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% exercise 3, wrong: the mean
# says: the mean over the actions
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else self.Q[self.next_states[s, a]].mean()
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% exercise 3, wrong: the own state
# says: the maximum is taken over the state itself instead of the next state
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[s])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% exercise 3, wrong: the same action
# says: *same* action
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else self.Q[self.next_states[s, a], a]
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% exercise 3, wrong: no future
# says: the value of the next state is missing
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a]
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% exercise 3, wrong: all discounted
# says: the whole target is discounted; γ belongs to the value of the next state only
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.discount * (self.rewards[s, a] + value)
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% exercise 3, wrong: no reward
# says: the reward is missing
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% exercise 3, wrong: minus
# says: the value of the next state is subtracted
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] - self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% exercise 3, wrong: plus equals
# says: the old value is still in the sum: Q(s, a) *becomes* the target, `=` and not `+=`
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] += new
    return largest


# %% exercise 3, wrong: returns nothing
# says: sweep() gives None: it should return the largest change of a value
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new


# %% exercise 3, wrong: returns the sum so far of values
# says: once nothing changes any more, sweep() should return 0, the largest change, but returns
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return self.Q.sum()


# %% exercise 3, wrong: returns 0
# says: compare the new value with the old one before you store it, and keep the largest change
# says: the largest change of the first sweep(), without its sign, is
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return 0.0


# %% exercise 3, wrong: compares after the change
# says: before you store it
# says: , but it returns
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                self.Q[s, a] = new
                largest = max(largest, abs(new - self.Q[s, a]))
    return largest


# %% exercise 3, wrong: self forgotten
# says: NameError
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% exercise 3, wrong: does not plan
# says: a new pair is known now, so `learn` should call self.plan(), which sweeps until nothing changes
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0


# %% exercise 3, wrong: plans once
# says: should call self.plan()
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.sweep()


# %% exercise 3, wrong: overwrites what is known
# says: that pair was known already, and then nothing should change
# says: the pair that was tried
def learn(self, state, action, reward, next_state, terminated):
    if True:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()


# %% exercise 3, wrong: forgets known
# says: a pair is known, 1, as soon as it was tried once
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()


# %% exercise 3, wrong: known of the next state
# says: known
# says: it is remembered for next_state; what followed belongs to the pair that was tried, [state, action]
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[next_state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()


# %% exercise 3, wrong: everything for the next state
# says: rewards[
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.rewards[next_state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()


# %% exercise 3, wrong: no reward kept
# says: [state, action]` keeps what followed
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()


# %% exercise 3, wrong: the best reward kept
# says: keeps what followed
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.rewards[state, action] = max(reward, self.rewards[state, action])
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()


# %% exercise 3, wrong: no next state kept
# says: keeps what followed
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.ends[state, action] = 1 if terminated else 0
        self.plan()


# %% exercise 3, wrong: never an end
# says: `ends` should be 1 if `terminated`, else 0
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 0
        self.plan()


# %% exercise 3, wrong: ends the wrong way round
# says: `ends` should be 1
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 0 if terminated else 1
        self.plan()


# %% exercise 3, wrong: state in place of next state
# says: next_states[
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()


# %% exercise 3, wrong: the test the wrong way round in learn
# says: known[
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 1:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()


# %% exercise 3, wrong: not solved
# says: Not solved yet
def learn(self, state, action, reward, next_state, terminated):
    raise NotImplementedError


# %% exercise 3, wrong: no abs
# says: values fall as well as rise, and a fall counts too: `abs(new - old)`
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, new - self.Q[s, a])
                self.Q[s, a] = new
    return largest


# %% exercise 3, wrong: return in the outer loop
# says: only state 0 is swept
# says: is swept. `return` ends the loops: write it below both, as far to the left as the first `for`
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
        return largest


# %% exercise 3, wrong: return in the inner loop
# says: only state 0 and action 0 is swept
# says: and action 0
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
            return largest


# %% exercise 3, wrong: never stores
# says: sweep() changes no value: set Q[s, a] to the target
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
    return largest


# %% exercise 3, wrong: largest of the last state
# says: that is a change of the last state: keep the largest of all, and set it to 0.0 above both loops
def sweep(self):
    for s in range(self.Q.shape[0]):
        largest = 0.0
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% exercise 3, wrong: the sum
# says: that is the sum of all changes
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest += abs(new - self.Q[s, a])
                self.Q[s, a] = new
    return largest


# %% exercise 3, wrong: the last change
# says: a change of the last state
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = abs(new - self.Q[s, a])
                self.Q[s, a] = new
    return largest


# %% exercise 3, wrong: known after the plan
# says: `known` is set only after self.plan()
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()
        self.known[state, action] = 1


# %% exercise 3, wrong: plans first
# says: ` is set only after self.plan(), which cannot use it then: remember first, and plan last
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.plan()
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0


# %% exercise 3, wrong: rewards after the plan
# says: `rewards` is set only after self.plan()
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()
        self.rewards[state, action] = reward


# %% exercise 3, wrong: an instance
# says: should be the class
MyRMax = RMax.create((6, 3))

# %% exercise 3, wrong: the package's
# says: known
# says: the agent should have a table `
MyRMax = RMax


# %% exercise 3, right: the parameters of learn in another order
def learn(self, action, state, terminated, next_state, reward):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()


# %% exercise 3, right: learn is told whether the episode was cut off
def learn(self, state, action, reward, next_state, terminated, truncated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()


# %% exercise 3, wrong: the discount as a number
# says: a discount of 0.99: use self.discount
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + 0.99 * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% exercise 3, wrong: remembered for the next state
# says: it is remembered for next_state; what followed belongs to the pair that was tried, [state, action]
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[next_state, action] = 1
        self.rewards[next_state, action] = reward
        self.next_states[next_state, action] = next_state
        self.ends[next_state, action] = terminated
        self.plan()


# %% exercise 3, wrong: all actions of the state
# says: a pair that was not tried
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = terminated
        self.plan()


# %% exercise 3, wrong: rewards for the unknown
# says: sweep() changes the table `
# says: `: planning changes Q only
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
            else:
                self.rewards[s, a] = 100.0
    return largest


# %% exercise 4, right: a smaller rate
# says: Right. Share of evaluation episodes that reach the goal, in the second half of training: Q-learning 0.00,
#   Dyna-10 0.00, mine 0.50. A learning rate of 1 with sampled updates fails on slippery ice: each value keeps only the
#   last outcome. Expected updates, or a lower rate, average over all of them.
lake_results = repeat(
    lake,
    {**methods, "mine": partial(DynaQ.create, learning_rate=0.1, planning_steps=10)},
    3_000,
    repetitions=5,
    evaluation_episodes=10,
)

# %% exercise 4, right: prioritised sweeping
lake_results = repeat(
    lake,
    {**methods, "mine": partial(PrioritisedSweeping.create, learning_rate=1.0)},
    3_000,
    repetitions=5,
    evaluation_episodes=10,
)

# %% exercise 4, right: a lambda
lake_results = repeat(
    lake,
    {**methods, "mine": lambda e: DynaQ.create(e, learning_rate=0.5, expected_updates=True)},
    3_000,
    repetitions=5,
    evaluation_episodes=10,
)

# %% exercise 4, right: R-max with many tries
lake_results = repeat(
    lake,
    {**methods, "mine": partial(RMax.create, known_after=20, highest_return=1.0, lowest_return=0.0)},
    3_000,
    repetitions=5,
    evaluation_episodes=10,
)

# %% exercise 4, right: two of one's own
lake_results = repeat(
    lake,
    {
        **methods,
        "one": partial(DynaQ.create, learning_rate=0.1, planning_steps=5),
        "two": partial(QLearning.create, learning_rate=0.1),
    },
    3_000,
    repetitions=5,
)

# %% exercise 4, right: another seed
lake_results = repeat(
    lake,
    {**methods, "mine": partial(DynaQ.create, learning_rate=1.0, planning_steps=10, expected_updates=True)},
    3_000,
    repetitions=5,
    seed=7,
)

# %% exercise 4, right: the id and its parameters
lake_results = repeat(
    "FrozenLake-v1",
    {**methods, "mine": partial(DynaQ.create, learning_rate=1.0, planning_steps=10, expected_updates=True)},
    3_000,
    repetitions=5,
    parameters={"map_name": "4x4", "is_slippery": True},
)

# %% exercise 4, right: written out
others = dict(methods)
others["expected"] = partial(DynaQ.create, learning_rate=1.0, planning_steps=10, expected_updates=True)
lake_results = repeat(environment=lake, agents=others, n_steps=3000, repetitions=5, jobs=1)

# %% exercise 4, wrong: more sampled updates
# says: it has a learning rate of 1 and sampled updates, so that a value is whatever the last outcome said, however many
#   updates it makes
# says: Share of evaluation episodes that reach the goal, in the second half of training:
lake_results = repeat(
    lake,
    {**methods, "mine": partial(DynaQ.create, planning_steps=20, learning_rate=1.0)},
    3_000,
    repetitions=5,
    evaluation_episodes=10,
)

# %% exercise 4, wrong: fewer sampled updates
# says: however many updates it makes
lake_results = repeat(
    lake,
    {**methods, "mine": partial(DynaQ.create, planning_steps=2, learning_rate=1.0)},
    3_000,
    repetitions=5,
    evaluation_episodes=10,
)

# %% exercise 4, wrong: no model
# says: should plan, and 'mine' learns from real steps alone
# says: the third method should plan, and
lake_results = repeat(
    lake,
    {**methods, "mine": partial(QLearning.create, learning_rate=0.5)},
    3_000,
    repetitions=5,
    evaluation_episodes=10,
)

# %% exercise 4, wrong: no planning steps
# says: learns from real steps alone: make it with DynaQ, PrioritisedSweeping or RMax, and let `planning_steps` be above
#   0
lake_results = repeat(
    lake,
    {**methods, "mine": partial(DynaQ.create, learning_rate=0.5, planning_steps=0)},
    3_000,
    repetitions=5,
    evaluation_episodes=10,
)

# %% exercise 4, wrong: a rate of nearly 1
# says: let each value average over many outcomes, by expected updates or by a learning rate such as 0.1
lake_results = repeat(
    lake,
    {**methods, "mine": partial(DynaQ.create, learning_rate=0.95)},
    3_000,
    repetitions=5,
    evaluation_episodes=10,
)

# %% exercise 4, wrong: nothing
# says: Not solved yet
lake_results = None

# %% exercise 4, wrong: the placeholder
# says: Not solved yet
lake_results = ...

# %% exercise 4, wrong: two methods
# says: lake_results should have a third method, your own, beside the two of the lesson
lake_results = repeat(lake, methods, 3_000, repetitions=5)

# %% exercise 4, wrong: one of the two again
# says: are the same agent
lake_results = repeat(lake, {**methods, "mine": methods["Dyna-10"]}, 3_000, repetitions=5, evaluation_episodes=10)

# %% exercise 4, wrong: only one's own
# says: keep the labels
lake_results = repeat(
    lake,
    {"mine": SARSA.create},
    3_000,
    repetitions=5,
)

# %% exercise 4, wrong: Dyna under another label
# says: keep the labels
lake_results = repeat(
    lake,
    {
        "Q-learning": methods["Q-learning"],
        "Dyna": methods["Dyna-10"],
        "mine": SARSA.create,
    },
    3_000,
    repetitions=5,
)

# %% exercise 4, wrong: other settings under the label
# says: for 'Q-learning' the learning_rate 1.0
lake_results = repeat(
    lake,
    {
        **methods,
        "Q-learning": QLearning.create,
        "mine": SARSA.create,
    },
    3_000,
    repetitions=5,
)

# %% exercise 4, wrong: 300 steps
# says: n_steps 3000, but it has n_steps 300
lake_results = repeat(
    lake,
    {**methods, "mine": SARSA.create},
    300,
    repetitions=5,
)

# %% exercise 4, wrong: ten repetitions
# says: repetitions 5, but it has repetitions 10
lake_results = repeat(lake, {**methods, "mine": SARSA.create}, 3_000)

# %% exercise 4, wrong: the shop
# says: environment FrozenLake-v1
lake_results = repeat(
    "Supermarket",
    {**methods, "mine": SARSA.create},
    3_000,
    repetitions=5,
)

# %% exercise 4, wrong: not slippery
# says: is_slippery True, but it has is_slippery False
lake = gym.make("FrozenLake-v1", map_name="4x4", is_slippery=False)
lake_results = repeat(
    lake,
    {**methods, "mine": SARSA.create},
    3_000,
    repetitions=5,
)

# %% exercise 4, wrong: the large lake
# says: map_name 4x4, but it has map_name 8x8
lake = gym.make("FrozenLake-v1", map_name="8x8", is_slippery=True)
lake_results = repeat(
    lake,
    {**methods, "mine": SARSA.create},
    3_000,
    repetitions=5,
)

# %% exercise 4, wrong: the final returns
# says: is of the type ndarray
lake_results = repeat(
    lake,
    {**methods, "mine": SARSA.create},
    3_000,
    repetitions=5,
).final("mine")

# %% exercise 4, wrong: the table
# says: is of the type DataFrame
lake_results = repeat(
    lake,
    {**methods, "mine": SARSA.create},
    3_000,
    repetitions=5,
).table

# %% exercise 4, wrong: the function
# says: call it
lake_results = repeat

# %% exercise 4, wrong: the methods
# says: is of the type dict
lake_results = methods
