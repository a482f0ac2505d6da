# %% [markdown]
# # Your own problem: a morning, and whatever you like
#
# **The challenge.** In the other lessons somebody had already decided what a state, an action and a reward are. Here
# you decide, and the agent does exactly what your reward says, which is not always what you meant.
#
# **You will be able to** turn a wish into states, actions, dynamics and a reward; find the mistakes in a problem before
# an agent does; see from the best policy, computed exactly, what a reward teaches; shape a reward without changing which
# policy is best; and take a problem of your own through everything, up to a file that a friend can play.
#
# **Time.** {time} **Before you start.** You
# should know the definition of a Markov decision process and value iteration (Sutton and Barto, 2nd edition, chapter 3
# and section 4.4), and Q-learning (6.5). The lessons before this one help, but none is needed. All symbols are in the
# [table of notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).

# %%
import random
from typing import NamedTuple

import numpy as np
from gymnasium.spaces import Discrete, MultiDiscrete
from gymnasium.utils.env_checker import check_env

from edugym import (
    SARSA,
    CountBased,
    DynaQ,
    EpsilonGreedy,
    MDPEnv,
    NStepSARSA,
    QLearning,
    check_mdp,
    finite_model,
    policy_evaluation,
    read_mdp,
    repeat,
    share,
)
from edugym.experiments.figures import Sheet
from edugym_course.lessons.own_problem import exact, experiments, figures, methods, races
from edugym_course.lessons.own_problem.bedroom import bedroom
from edugym_course.lessons.own_problem.everything import take_through_everything
from edugym_course.lessons.own_problem.morning import WithPotential
from edugym_course.notebook import frames, play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: from a wish to forty lines
#
# Here is a wish: *"Wake me as late as you can, but I must be up at half past eight. And please do not ring, the walls
# are thin."* An alarm clock with a microphone should learn this. To state the problem, answer four questions.
#
# | question | here | |
# |---|---|---|
# | What can the agent **do**? | stay quiet, chime softly, ring loudly | the actions $\mathcal{A} = \{0, 1, 2\}$ |
# | What must it **know** to decide, and to say what comes next? | the time, and how deep she sleeps | the states $s = (t, d)$, where $s' = (t', d')$ comes next |
# | What **happens**? | a ring wakes her (probability 0.9) or makes her sleep one step lighter (0.1); a chime makes it one step lighter (0.7); in silence it gets one step deeper (0.5); otherwise the depth stays | the dynamics $p(s' \mid s, a)$ |
# | What is it **worth**? | sleep is good, a ring is bad, oversleeping is worse | the reward $r(s, a, s')$ |
#
# The episode begins at 7:10. Each step takes ten minutes, and $t$ counts the steps: at $t = T = 8$ it is 8:30, and the
# episode ends. The depth $d$ is 0 when she is awake, 1 when she is dozing, and 2 when she is fast asleep. Nobody tells
# us how many rings an hour of her sleep is worth, so we must choose numbers. A step is worth the depth of sleep at its
# end. A ring costs $c_{\text{ring}} = 4$, and oversleeping costs $c_{\text{late}} = 10$. With $1\{\cdot\}$, which is 1
# if the condition is true and 0 otherwise, the reward is
#
# $$
# r(s, a, s') = d' - c_{\text{ring}}\, 1\{a = \text{ring}\} - c_{\text{late}}\, 1\{t' = T,\ d' > 0\}
# $$
#
# In code this is an immutable value, a `NamedTuple`, with one short method for each of these parts, and two more for
# the beginning and the end. `rng` draws the random numbers, and an agent sees what `observation` returns. (The two
# spaces say which actions and observations there are; a `property` is read without parentheses.)


# %%
class Morning(NamedTuple):
    """Let her sleep as long as possible, and have her awake at half past eight."""

    length: int = 8  # T, the number of steps of ten minutes
    ring: float = 4.0  # what a ring costs
    late: float = 10.0  # what oversleeping costs

    action_names = ("stay quiet", "chime", "ring")
    action_space = property(lambda self: Discrete(3))
    # a property, since the size depends on `length`
    observation_space = property(lambda self: MultiDiscrete([self.length + 1, 3]))

    def initial(self, rng):
        """Where an episode begins."""
        return 0, 2

    def transition(self, state, action, rng):
        """What an action does."""
        time, depth = state
        luck = rng.random()
        if action == 2:  # a ring wakes her, or at worst makes her sleep lighter
            depth = 0 if luck < 0.9 else max(depth - 1, 0)
        elif action == 1:  # a chime may make her sleep lighter
            depth = max(depth - 1, 0) if luck < 0.7 else depth
        else:  # in silence her sleep may get deeper
            depth = min(depth + 1, 2) if luck < 0.5 else depth
        return time + 1, depth

    def reward(self, state, action, next_state, rng):
        """What a step is worth."""
        time, depth = next_state
        reward = float(depth)
        if action == 2:
            reward -= self.ring
        if time == self.length and depth > 0:
            reward -= self.late
        return reward

    def terminal(self, state):
        """Whether the episode is over."""
        return state[0] == self.length

    def observation(self, state, rng):
        """What the agent sees."""
        return state

    def scene(self, state, last_action=None):
        """The picture."""
        return bedroom(*state, self.length, last_action)


morning = Morning()
visited = check_mdp(morning)
print("checked; the first states on the way:", visited[:9])

# %% [markdown]
# `check_mdp` has played 200 random steps and looked at everything that the methods return. States should be numbers or
# tuples of numbers. Draw a picture for your problem too: it shows mistakes that no check finds. (`bedroom` returns a
# `Scene` of circles, rectangles and texts.)

# %%
MDPEnv(morning).scene()

# %% [markdown]
# **Play it yourself.** What is the best return that you get? What is your rule?

# %%
play(morning)

# %% [markdown]
# `MDPEnv` makes a Gymnasium environment of it, so that other people's tools can use it:

# %%
env = MDPEnv(morning)
check_env(env, skip_render_check=True)  # Gymnasium's own check
observation, info = env.reset(seed=1)
print("first observation:", observation)
print("after a chime:", env.step(1))

# %% [markdown]
# ### Six mistakes
# Here are six variants of `Morning`, each with one mistake. (`__slots__ = ()` keeps such a class immutable: without it
# one could write `self.x = 1`.)


# %%
class NoReturn(Morning):
    """Sleep pays, and a ring costs."""

    __slots__ = ()

    def reward(self, state, action, next_state, rng):
        """What a step is worth."""
        reward = float(next_state[1])
        if action == 2:
            reward -= self.ring


class OneTooFew(Morning):
    """The numbers that the agent may see."""

    __slots__ = ()
    observation_space = property(lambda self: MultiDiscrete([self.length, 3]))


class OwnDice(Morning):
    """Her sleep changes by chance."""

    __slots__ = ()

    def transition(self, state, action, rng):
        """What an action does."""
        return state[0] + 1, random.randrange(3)


class InPlace(Morning):
    """The time goes on."""

    __slots__ = ()

    def initial(self, rng):
        """Where an episode begins."""
        return [0, 2]

    def transition(self, state, action, rng):
        """What an action does."""
        state[0] += 1
        return state


class WrongSign(Morning):
    """Sleep pays, a ring and oversleeping cost."""

    __slots__ = ()

    def reward(self, state, action, next_state, rng):
        """What a step is worth."""
        late = self.terminal(next_state) and next_state[1] > 0
        return next_state[1] + self.ring * (action == 2) - self.late * late


class NeverEnds(Morning):
    """The night is short."""

    __slots__ = ()

    def terminal(self, state):
        """Whether the episode is over."""
        return state == self.length


# %% [markdown]
# **Predict.** Read them. The check finds five of the six mistakes. Which one does it not find?

# %%
mistakes = [NoReturn, OneTooFew, OwnDice, InPlace, WrongSign, NeverEnds]
not_found = predict("The check does not find the mistake in ...", [kind.__name__ for kind in mistakes])
not_found

# %%
accepted = []
for kind in mistakes:
    try:
        check_mdp(kind())
        accepted.append(kind.__name__)
    except ValueError as error:
        print(f"✗ {error}\n")
not_found.measured(*accepted)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** `WrongSign` passes: there a ring is *rewarded* with 4. That is a perfectly good decision problem, only
# not the one that was meant: a check cannot know what you want. The other five are caught. The sentence names the
# method where the mistake shows, which is not always the one to mend: for `OneTooFew` mend `observation_space`, for
# `NeverEnds` mend `terminal`. (There a tuple never equals a number, so the time runs on beyond 8:30.)
# </details>

# %% [markdown]
# ## The idea: an agent maximises what is paid, and nothing else
#
# The value of the best policy satisfies the Bellman optimality equation (Sutton and Barto, equation 3.19):
#
# $$
# v_*(s) = \max_a \sum_{s'} p(s' \mid s, a) \left[ r(s, a, s') + \gamma\, v_*(s') \right]
# $$
#
# Your wish is not in this equation. Only $p$ and $r$ are, and the best policy is best for them. (The book's example, in
# section 3.2: a chess player who is paid for taking pieces may take them and lose the game.) A problem with 25 states
# (at 7:10 there is only one) can be solved exactly, by computing the right side again and again for all states at once
# (value iteration, section 4.4).
#
# The discount is $\gamma = 1$ in the whole lesson: an episode has 8 steps, and sleep at eight is worth as much as sleep
# at half past seven. Here is the whole best policy. Can you say in words what it does? And at 8:00, why is it quiet
# when she is dozing, and chimes when she is fast asleep?

# %%
best = exact.solve(morning)
print(f"optimum: {best.start:.3f}; random actions: {exact.random_return(morning):.3f}")
Sheet("policy", [[figures.morning_map(morning, "the best policy")]])

# %% [markdown]
# Fast asleep, she is two good chimes away from being awake, and from 8:00 on there is time for three. Dozing, she is
# one away, and at 8:00 the clock can wait another ten minutes. It rings only when a chime cannot wake her in time.
# Awake, a chime keeps her awake, and in silence she dozes off with probability 0.5. So from 8:10 on it chimes even
# then. The map answers for every state, also for those that the clock never comes to. (The beige cells have no state:
# at 7:10 she is fast asleep.)
#
# **Predict.** Under this policy, the best one for our reward, how often is she *not* awake at 8:30?

# %%
oversleeps = predict("The best clock lets her oversleep with probability ...", unit="%")
oversleeps

# %%
night = exact.what_happens(morning, exact.best_policy(morning))
print(night)
oversleeps.measured(100 * night.late)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** 14 %, one morning in seven. "I *must* be up" was the wish, but the reward says that being late costs 10
# and a ring 4. A dozing sleeper at 8:20 gets a chime, which fails with probability 0.3. Then she dozes on, which is
# worth 1, and is late, which costs 10: that is $0.3 \cdot (10 - 1) = 2.7$ on average. A ring would cost 4, so by this
# reward the chime is right. The sliders below change it.
# </details>

# %% [markdown]
# Watch one morning under this policy:

# %%
frames(morning, exact.player(morning), seed=3)

# %% [markdown]
# ## The experiment: every agent learns it
#
# An exact solution needs the model. The agents of the earlier lessons do not: they only play, and Dyna learns a model
# from that. How well do they do on a problem that none was made for?
#
# | setting | value |
# |---|---|
# | all | table with one row for each $(t, d)$, $\gamma = 1$, $\alpha = 0.1$, ε-greedy with $\varepsilon = 0.1$ |
# | methods | Q-learning (lesson 1) and SARSA (2); 3-step SARSA, whose targets have three rewards (3); Dyna-10, which also makes 10 updates a step from its model (9) |
# | novelty reward | Q-learning with a bonus $\beta / \sqrt{n(s')}$, where $n(s')$ counts how often $s'$ was entered, $\beta = 1$ (lesson 1) |
# | training | 10 000 steps, which are 1 250 mornings |
# | left figure | mean return of 20 greedy episodes, every 500 steps |
# | right figure | the exact expected return of the greedy policy at the end |
# | repetitions | 20; bands and bars are 95 % intervals |
#
# (The code of your class is compiled for each agent first, which takes half a minute or more.)

# %%
settings = {"learning_rate": 0.1, "discount": 1.0, "exploration": EpsilonGreedy(0.1)}
agents = {
    "Q-learning": lambda task: QLearning.create(task, **settings),
    "SARSA": lambda task: SARSA.create(task, **settings),
    "Dyna-10": lambda task: DynaQ.create(task, planning_steps=10, **settings),
    "3-step SARSA": lambda task: NStepSARSA.create(task, n=3, **settings),
    "novelty reward": lambda task: CountBased.create(task, **settings),
}
learned = repeat(morning, agents, 10_000, repetitions=20, evaluate_every=500, evaluation_episodes=20)

# %% [markdown]
# That is the whole experiment. (From here on `methods.learn` makes this call.)

# %%
worth = {method: methods.true_returns(learned, method, morning) for method in learned.methods}
display(figures.race(learned, worth, best.start, exact.random_return(morning)))
for method, returns in worth.items():
    early = learned.curves(method).loc[1_000].mean()
    found = np.mean(returns > best.start - 1e-6)
    print(
        f"{method:14} played mean after 1 000 steps {early:5.2f}, "
        f"exact value at the end {returns.mean():5.2f}; best policy: {found:.0%}"
    )

# %% [markdown]
# All five learn a clock that is far better than random actions. Dyna is close to the optimum after 1 000 steps (125
# mornings), and finds the best policy in most runs. 3-step SARSA is the second early on; at the end it and the other three are level. The novelty reward is no
# help here: in 1 000 runs it was 0.7 behind Q-learning after 1 000 steps, and ended at the same value.
# (On the left the points are means of played episodes, which luck may lift above the optimum, 10.32; on the right the
# policies are evaluated exactly.)

# %% [markdown]
# ## Your turn
#
# The reward has two weights that nobody told us, and here is a third one: a bonus each time she wakes. Move a slider
# and release it: the problem is solved again, exactly. Before each question put the sliders back (4, 10, 0). Find (1) a cost of oversleeping at which she always oversleeps,
# (2) one at which she is late in less than 2 % of all mornings, (3) the lowest bonus from which on she wakes more than
# once on average.

# %%
sliders(figures.weights_sheet, ring=(0.0, 12.0, 0.5), late=(0.0, 30.0, 0.5), bonus=(0.0, 15.0, 1.0))

# %% [markdown]
# <details><summary>Answers</summary>
#
# (1) 3.5 or less. (2) 14.5 or more, where it is 1 %. (3) 6.
# </details>

# %% [markdown]
# The map does not change smoothly. There are finitely many deterministic policies, one of them is always best, and the
# return of each is a straight line in each weight. So for long stretches of a slider the same policy is best, and then
# a cell flips. If the clock never comes to that cell, only the map changes: raise `late` from 10 to 11, the others as at first, and look at the
# title. (The cell *dozing at 8:00* flips, and at 8:00 she is still fast asleep.) A small change of a reward may matter
# a lot or not at all.

# %% [markdown]
# ## See inside: what a careless reward teaches
#
# ### A runner who gives up
# The runner of lesson 2 must arrive exactly at the last of ten cells, before a cliff. It stands still at first. Each action changes
# its speed by $-1$, 0 or $+1$, and then it runs as many cells as its speed says. The step that arrives there has the
# reward $+1$. A step in which the runner falls or stalls has the reward $R$. Every other step has $-1$.
# To *stall* is to brake when standing still, and it ends the episode. The shortest run has four steps and returns $-1 -
# 1 - 1 + 1 = -2$.
#
# **Predict.** A careful designer finds $R = -100$ cruel, and sets $R = -1$. What does the best policy do?

# %%
mild = predict("With R = -1 the best runner ...", ["runs as before", "runs more slowly", "stalls at once", "jumps off"])
mild

# %%
for R in (-100.0, -1.0):
    optimum, change = experiments.first_stall(R)
    print(f"R = {R:g}: optimum {optimum:g}, first change of speed {change:+d}")
mild.measured("stalls at once" if change < 0 else "runs as before")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** It stalls in its first step, with return $-1$, since running returns $-2$. That is the optimum of this
# reward, by which giving up costs no more than one step.
# </details>

# %% [markdown]
# ### Two careless rewards for the clock
# These two rewards sound reasonable:
#
# 1. *"I want her awake, so I pay for that":* 2 for each step at the end of which she is awake, less the cost of rings.
#    (Sleep is not worth anything here.)
# 2. *"The penalty comes so late. I add a bonus for progress":* the reward as it was, and 10 each time she wakes.
#
# **Predict.** What will the best clock do with the second one?

# %%
progress = predict(
    "Paid 10 for each waking, the best clock ...",
    [
        "wakes her once, at the same time as before",
        "wakes her once, earlier",
        "wakes her and lets her doze off, again and again",
    ],
)
progress

# %%
careless = {label: task for label, task in experiments.TASKS.items() if label != exact.POTENTIAL}
nights = {}
for label, task in careless.items():
    nights[label] = exact.what_happens(experiments.TASKS[exact.MEANT], exact.best_policy(task))
    print(f"{label}:\n    {nights[label]}")
display(figures.policies(careless))
wakings = nights[exact.WAKINGS].wakings
earlier = nights[exact.WAKINGS].sleep < nights[exact.MEANT].sleep
progress.measured(progress.options[2 if wakings > 1.5 else 1 if earlier else 0])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Paid for being awake, the clock chimes from 7:10 on, and she sleeps 19 minutes instead of 66. Paid for
# waking, it chimes until she wakes, is quiet until she dozes off, and wakes her again: 2.4 times on average, and she
# sleeps 37 minutes. (At 8:20 it rings when she is dozing, too: a ring earns $10 - 4 = 6$, and a chime $0.7 \cdot 10 -
# 0.3 \cdot 9 = 4.3$ on average.) With either reward she hardly ever oversleeps. By the reward that was meant they
# return 2.3 and 2.4, less than a quarter of the optimum, 10.3. This is called *reward hacking*, but nobody is hacked:
# the agent does what it is paid for. (In the second map the cell with two letters has two best actions: at 8:20 neither
# quiet nor a chime can wake her, and a ring costs 4 and earns $0.9 \cdot 2 = 1.8$.)
# </details>

# %% [markdown]
# ### A bonus that changes no best policy
# Progress bonuses are useful, and there is a safe form. Choose any function of the state, the *potential* $\varphi(s)$,
# which is 0 in terminal states, and add to the reward what the potential gains (Ng, Harada and Russell, 1999):
#
# $$
# F(s, s') = \gamma\, \varphi(s') - \varphi(s)
# $$
#
# The sum of these additions over an episode from $S_0$ to its end $S_T$ telescopes:
#
# $$
# \sum_{t=0}^{T-1} \gamma^t \left[ \gamma\, \varphi(S_{t+1}) - \varphi(S_t) \right] = \gamma^T \varphi(S_T) - \varphi(S_0) =
# -\varphi(S_0)
# $$
#
# It is the same number *for every policy*. The same sum from any state $s$ on is $-\varphi(s)$. So the values of all
# policies fall by $\varphi(s)$ there, and which is best does not change. For the clock: let $\varphi(s) = 10$ while she
# is awake. Then 10 is paid when she wakes before 8:30, and taken back when she falls asleep again, or at the end.
# (`phi` holds 0 for every state at 8:30.)

# %%
source(WithPotential, "potential", "reward")

# %%
shaped_task = experiments.TASKS[exact.POTENTIAL]
shaped = exact.solve(shaped_task)
difference = [shaped.value(s) - (best.value(s) - shaped_task.potential(s)) for s in best.model.states]
print("same best actions everywhere:", np.array_equal(best.greedy_policy(), shaped.greedy_policy()))
print(f"largest difference from v*(s) − φ(s): {np.abs(difference).max():.0e}")

# %% [markdown]
# **Predict.** Q-learning now learns from five rewards: the three above, that with the potential, and one with $\varphi(s) = v_*(s)$, which nobody
# knows before learning. The settings are those of the experiment (20 runs), and we judge its greedy policy by the
# reward that was meant, exactly. Does the potential of 10 for being awake help: which is ahead after 800 steps (100
# mornings)? (Each budget of the figure is four times the one before, and the axis is logarithmic. Bands are 95 %
# intervals.)

# %%
helps = predict("Which is ahead after 800 steps?", ["with the potential", "without any shaping", "neither"])
helps

# %%
judged = methods.as_meant(experiments.REWARDS, experiments.TASKS[exact.MEANT], experiments.BUDGETS)
display(Sheet("as_meant", [[experiments.learning_lines(judged)]]))
print("mean return as meant, after", *experiments.BUDGETS, "steps")
for label, values in judged.items():
    print(f"{label:28}", *(f"{mean:7.2f}" for mean in values.mean(axis=1)))
lead = np.mean(judged[exact.POTENTIAL][1] - judged[exact.MEANT][1])
helps.measured("with the potential" if lead > 0.5 else "without any shaping" if lead < -0.5 else "neither")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** At 800 steps Q-learning with the potential of 10 is far *behind* Q-learning without shaping: $-2.4$
# against 6.7. After 12 800 steps both are at 9.8. With $\varphi = v_*$ Q-learning is close to
# the optimum after 200 steps already. So a potential cannot change which policy is best, but it can help learning or slow it
# down: to Q-learning it is the same as a table that starts at it (the aside says why). With the two careless rewards more
# training does not bring the agent to what was meant.
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: a potential is an initial value
# Why does this potential slow learning down, and $v_*$ not? Write $Q'$ for the table of Q-learning with the potential, which starts at 0.
# Its error is
#
# $$
# R + \gamma\, \varphi(S') - \varphi(S) + \gamma \max_a Q'(S', a) - Q'(S, A)
# = R + \gamma \max_a \left[ Q'(S', a) + \varphi(S') \right] - \left[ Q'(S, A) + \varphi(S) \right]
# $$
#
# That is the error of Q-learning *without* shaping, with a table $Q = Q' + \varphi$. So both move by the same amounts:
# to learn with a potential is to learn without one from a table that *starts* at $\varphi(s)$ (Wiewiora, 2003). ($\varphi(s)$
# adds the same to every action of a state, so the greedy actions are the same.) Let
# two agents learn from the same steps, and compare their tables:

# %%
phi = exact.awake_potential(8)  # by time and depth: 10 where she is awake
shaped_agent, started_agent = (QLearning.create((27, 3), learning_rate=0.1, discount=1.0) for _ in range(2))
started_agent.Q[:] = phi.reshape(27, 1)
rng = np.random.default_rng(0)
state = morning.initial(rng)
for _ in range(12_800):
    row = 3 * state[0] + state[1]
    action = started_agent.act(row, rng)
    after = morning.transition(state, action, rng)
    next_row, over = 3 * after[0] + after[1], morning.terminal(after)
    reward = morning.reward(state, action, after, rng)
    shaped_agent.learn(row, action, reward + phi[after] - phi[state], next_row, over)
    started_agent.learn(row, action, reward, next_row, over)
    state = morning.initial(rng) if over else after
print("the same tables, but for φ:", np.allclose(shaped_agent.Q + phi.reshape(27, 1), started_agent.Q))

# %% [markdown]
# So the potential of 10 is an old friend from lesson 1: optimistic initial values. Every action in every state in which
# she is awake looks as if it were worth 10, until it has been tried often enough; with $\alpha = 0.1$ that takes long.
# A table that starts at $v_*$ has the right value for every best
# action, so only the others must be learned. "Awake is worth 10 at any hour" is far too optimistic.

# %% [markdown]
# ## Predict, then check
#
# **The state must know enough.** A state has the *Markov property* if it includes all aspects of the past that make a
# difference for the future (Sutton and Barto, sections 3.1 and 17.3). What if you leave a variable out of what the
# agent observes? We take two cheaper clocks: one without a microphone, which sees $t$ only, and one that has
# stopped, which hears $d$ only.
#
# **Predict.** Which clock is worth more, when each follows the best rule for what it sees at the moment?

# %%
cheaper = predict("Which clock is worth more?", ["the clock that sees the time", "the clock that hears her sleep"])
cheaper

# %%
plans = {
    "the clock that sees the time": exact.best_blind(morning, lambda state: state[0]),
    "the clock that hears her sleep": exact.best_blind(morning, lambda state: state[1]),
}
print(f"the clock that sees both: {best.start:.2f}")
for clock, (value, actions) in plans.items():
    print(f"{clock}: {value:.2f}, by", ", ".join(morning.action_names[action] for action in actions))
cheaper.measured(max(plans, key=lambda clock: plans[clock][0]))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** The clock that sees the time loses only 0.34: quiet until 8:00 and then three chimes is nearly as good
# as to listen. The one that hears her sleep does best if it never makes a sound (its three actions are those for awake,
# dozing and fast asleep), and then she always oversleeps, perhaps because what it does at 8:20 when she is fast asleep,
# it would also do at 7:10, and a sound early in the morning costs sleep. (These are the best *deterministic* rules,
# found by trying them all.) It is hard to tell what a variable is worth by looking at it. Leave it out, and measure.
# Lesson 5 is about what an agent can do when it cannot see its state.
# </details>

# %% [markdown]
# This is how you leave a variable out of a problem of your own: write a variant that observes less. Here Q-learning
# learns with the time alone, 20 times, with the settings of the experiment.


# %%
class SeesTheTime(Morning):
    """A clock without a microphone."""

    __slots__ = ()
    observation_space = property(lambda self: Discrete(self.length + 1))

    def observation(self, state, rng):
        """What the agent sees."""
        return state[0]


method = {"Q-learning": methods.methods_with()["Q-learning"]}
deaf = methods.learn(SeesTheTime(), method)
returns = methods.true_returns(deaf, "Q-learning", SeesTheTime())
possible = plans["the clock that sees the time"][0]
print(f"Q-learning that sees the time: mean {returns.mean():.2f} of {possible:.2f} possible")

# %% [markdown]
# Q-learning falls short of 9.98, and more training does not help: after 1 000 000 steps 30 runs were at 9.1 on average.
# What it sees next is the next time, whatever it does, so no chime gets credit for what comes later. It learns to be quiet
# seven times and then to ring: $14 - 4 - 0.1 \cdot 9 = 9.1$. What you measure is the variable's worth *for this agent*.

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for your answer, and below it a cell that checks it. The check says what was expected, what
# came, and which mistake that looks like.

# %%
from edugym_course.grading import check
from edugym_course.lessons.own_problem.exercises import exercise_1, exercise_2, exercise_3, exercise_4

# %% [markdown]
# ### Exercise 1: where the behaviour flips
# With small `late`, the best clock does not ring even at 8:20 when she is fast asleep. It lets her oversleep. What is
# the lowest cost of oversleeping at which ringing is best there? (The cost of a ring stays 4.) Set `late` by a formula,
# or to a number rounded to two digits after the decimal point.
#
# <details><summary>Hint</summary>There is one step left, so each action is worth its expected reward, by the equation of the reward
# at the top: the depth at the end of the step, less 4 for a ring, less <code>late</code> unless she is awake. A ring
# leaves her awake with probability 0.9 and dozing otherwise; silence leaves her fast asleep. At which cost are the two
# equal?</details>

# %%
late = 10.0
### BEGIN SOLUTION
late = 5.9 / 0.9
# own: late = ({ring} + 1.9) / 0.9
### END SOLUTION

# %% tags=["check"]
check(exercise_1, late)

# %% [markdown]
# ### Exercise 2: shape a reward
# Write the function that adds potential-based shaping to a reward. Its arguments are the reward $r$ of a step, the
# function $\varphi$ (call it as `potential(state)`), the state $s$, the next state $s'$, whether $s'$ is terminal, and
# the discount $\gamma$. The given function may return anything for a terminal state, but the potential of a terminal
# state must count as 0. If the check finds it right, the cell draws a random potential for each state, solves the
# problem with your function, and shows both policies. Will the best one change?
#
# <details><summary>Hint</summary>It is the formula of F above, added to the reward, in one line or in three. What is
# left of F when <code>terminated</code> is True?</details>


# %%
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    """Return the reward of a step plus what the potential gains in it."""
    ### BEGIN SOLUTION
    after = 0.0 if terminated else discount * potential(next_state)
    return reward + after - potential(state)
    # own: return reward + {weight} * (after - potential(state))
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_2, shaped_reward)
### BEGIN HIDDEN TESTS
check(exercise_2, shaped_reward, seed=1, quiet=True)
### END HIDDEN TESTS
display(races.shaped_policies(shaped_reward))

# %% [markdown]
# ### Exercise 3: give the state what it needs
# A new sleeper gets used to the chime. She hears only the first two chimes of a morning. From the third one on, a chime
# is like silence: her sleep may get deeper, with the same probability. Rings work as before. Now what a chime does
# depends on how many came before it, so $(t, d)$ is no Markov state any more.
#
# Put their number into the state: `(time, depth, chimes)`, where `chimes` is the number of chimes so far, but at most
# 2. A chime counts also when she is awake. Complete `observation_space`, `initial` and `transition`. Before you run the
# check: below it Q-learning learns your problem twice, once with and once without a look at `chimes` (20 runs of 20 000
# steps each, with the settings of the experiment). What will be the difference?
#
# <details><summary>Hint</summary>Copy the method <code>transition</code> of <code>Morning</code>. Take three numbers
# out of the state instead of two. She hears a chime if <code>action == 1 and chimes < 2</code>; look at
# <code>chimes</code> before you count.</details>


# %%
class UsedToIt(NamedTuple):
    """A morning with a sleeper who hears only the first two chimes."""

    length: int = 8
    ring: float = 4.0
    late: float = 10.0

    action_names = ("stay quiet", "chime", "ring")
    action_space = property(lambda self: Discrete(3))

    @property
    def observation_space(self):
        """How many values each number of the state can take."""
        ### BEGIN SOLUTION
        return MultiDiscrete([self.length + 1, 3, 3])
        ### END SOLUTION

    def initial(self, rng):
        """Ten past seven: fast asleep, and no chime yet."""
        ### BEGIN SOLUTION
        return 0, 2, 0
        ### END SOLUTION

    def transition(self, state, action, rng):
        """The third chime and all later ones are like silence."""
        ### BEGIN SOLUTION
        time, depth, chimes = state
        luck = rng.random()
        if action == 2:
            depth = 0 if luck < 0.9 else max(depth - 1, 0)
            # own: depth = 0 if luck < {wakes} else max(depth - 1, 0)
        elif action == 1 and chimes < 2:
            depth = max(depth - 1, 0) if luck < 0.7 else depth
        else:
            depth = min(depth + 1, 2) if luck < 0.5 else depth
        if action == 1:
            chimes = min(chimes + 1, 2)
        return time + 1, depth, chimes
        ### END SOLUTION

    def reward(self, state, action, next_state, rng):
        """As before."""
        reward = float(next_state[1])
        if action == 2:
            reward -= self.ring
        if next_state[0] == self.length and next_state[1] > 0:
            reward -= self.late
        return reward

    def terminal(self, state):
        """At half past eight."""
        return state[0] == self.length

    def observation(self, state, rng):
        """The whole state."""
        return state


# %% tags=["check"] points=3
check(exercise_3, UsedToIt)
### BEGIN HIDDEN TESTS
check(exercise_3, UsedToIt, seed=1, quiet=True)
### END HIDDEN TESTS
display(races.count_matters(UsedToIt))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** "The old clock" is the policy that was best for a sleeper who hears every chime. With the new sleeper it is
# worth only 5.7, where the optimum is 9.9, since it was planned with wrong dynamics. But up to 20 000 steps Q-learning does
# no better with a look at `chimes`: in 200 runs it is even a little behind (8.8 against 9.0; both are about 1 below the
# optimum). With 100 000 steps it is ahead. The optimum needs no such look: one of the best rules sees only time and
# depth. It is quiet until 8:10, and then it chimes at most twice, or rings at 8:20 if she is fast asleep. Two questions
# must be kept apart. What must the *state* have, so that the dynamics are right? All that makes a difference for the
# future. What must the *agent see*? That is a matter of measuring. </details>

# %% [markdown]
# ### Exercise 4: your own problem
# Now yours. It should come from something that you know: a kitchen, a bus line, a game, a shop, a plant, a queue, your
# phone's battery. The cell below has a problem that runs, so that you can see the form: keep or sell an old bicycle,
# for which a random offer of 1, 2 or 3 comes each day. Keep the form, a class that inherits from `NamedTuple`, and
# replace it by one of your own, under another name. Set `my_problem` to a value of it. The check wants
#
# - two actions and four states or more, and chance in the dynamics;
# - an end: terminal states that are always reached (a deadline belongs in the state, like the time of the morning);
# - a decision: no single action that is best in every state.
#
# Keep it small, some hundred states, with whole numbers in states and observations: then it can be solved exactly.
# Every state that can be reached must fit `observation_space`, so a queue or a stock needs a largest value, for example
# `min(queue + 1, 5)`.
#
# <details><summary>Hint</summary>Answer the four questions at the top of this lesson in four sentences before you write code.
# If something important is missing in the state, the method <code>transition</code> will need it and not have it. Draw
# all random numbers from <code>rng</code>, for example <code>rng.random() &lt; 0.3</code> or <code>int(rng.random() *
# 3)</code>, and return new states instead of changing old ones.</details>


# %%
class Template(NamedTuple):
    """Sell a bicycle within five days: the state is (day, offer), and waiting brings another offer."""

    days: int = 5

    action_names = ("wait", "sell")
    action_space = property(lambda self: Discrete(2))
    observation_space = property(lambda self: MultiDiscrete([self.days + 1, 4]))

    def initial(self, rng):
        """The first offer, 1 to 3."""
        return 0, 1 + int(rng.random() * 3)

    def transition(self, state, action, rng):
        """Sold, which is an offer of 0; or a day later with a new offer."""
        day, _ = state
        return (day, 0) if action == 1 else (day + 1, 1 + int(rng.random() * 3))

    def reward(self, state, action, next_state, rng):
        """The offer that was taken."""
        return float(state[1]) if action == 1 else 0.0

    def terminal(self, state):
        """Sold, or too late."""
        return state[1] == 0 or state[0] == self.days

    def observation(self, state, rng):
        """The whole state."""
        return state


my_problem = Template()
### BEGIN SOLUTION


class Umbrella(NamedTuple):
    """Six walks between home and office, with one umbrella; the state is (walk, umbrella here, rain)."""

    walks: int = 6

    action_names = ("leave it", "take it")
    action_space = property(lambda self: Discrete(2))
    observation_space = property(lambda self: MultiDiscrete([self.walks + 1, 2, 2]))

    def initial(self, rng):
        """Where an episode begins."""
        return 0, 1, int(rng.random() < 0.3)

    def transition(self, state, action, rng):
        """What an action does."""
        walk, here, _ = state
        here = 1 if here == 0 or action == 1 else 0  # who left it at the other end finds it there
        return walk + 1, here, int(rng.random() < 0.3)

    def reward(self, state, action, next_state, rng):
        """What a step is worth."""
        carried = state[1] == 1 and action == 1
        return (-1.0 if carried else 0.0) - (5.0 if state[2] == 1 and not carried else 0.0)
        # own: return (-1.0 if carried else 0.0) - ({price} if state[2] == 1 and not carried else 0.0)

    def terminal(self, state):
        """Whether the episode is over."""
        return state[0] == self.walks

    def observation(self, state, rng):
        """What the agent sees."""
        return state


my_problem = Umbrella()
### END SOLUTION

# %% tags=["check"] points=4
check(exercise_4, my_problem)

# %% [markdown]
# ### The open challenge: take it through everything
# One call checks your problem, solves it, lets three agents learn it (10 000 steps, 10 runs), and compares them with
# the optimum and with random actions. If a state is one number or two, it also draws a map of the best policy. Until
# you have a problem of your own it shows the bicycle. (For a new class the agents are compiled first, which takes some
# twenty seconds.)

# %%
tour = take_through_everything(my_problem)
print(tour)

# %%
for sheet in tour.sheets:
    display(sheet)

# %% [markdown]
# If the list ends in "... and more", this prints the probabilities of the best policy in every state:
# `for s, p in zip(tour.values.model.states, tour.values.greedy_policy()): print(s, p)`.
#
# **A careless reward.** Solve your problem with another reward, and judge both policies by the one that you meant. This
# one pays 1 more for action 0; put a careless reward of yours in its place. (If your problem has not passed exercise 4, an episode may never end, so it is
# cut off after 1 000 steps. `what_happens` and `best_blind` are for the morning only.)


# %%
class Careless(type(my_problem)):
    """My problem with a careless reward."""

    __slots__ = ()
    max_steps = 1_000

    def reward(self, state, action, next_state, rng):
        """What I meant, and a bonus for action 0."""
        return super().reward(state, action, next_state, rng) + (1.0 if action == 0 else 0.0)


model = finite_model(my_problem)
for label, task in (("the reward that I meant", my_problem), ("the careless reward", Careless(*my_problem))):
    policy = exact.best_policy(task)
    meant = policy_evaluation(model, policy, 1.0, horizon=1_000).start
    print(f"{label} teaches a policy that returns {meant:.2f}, by the reward that I meant")

# %% [markdown]
# Play it until you can beat the agents, or know why you cannot. A picture helps. It is a method of the class, which may
# be as simple as the one below for the bicycle. The picture is 10 wide and 5 high; x counts to the right and y *down*
# from the top left. A circle has x, y and a radius; a text has x, y, the words and a size. Put this line at the top of
# the cell of your class:
#
# ```python
# from edugym.rendering.scene import Circle, Scene, Text
# ```
#
# Put the method into the class, below `observation` and indented like it. Then run from there again.
#
# ```python
#     def scene(self, state):
#         day, offer = state
#         return Scene(10, 5, (Circle(5, 2.8, 0.5 * offer), Text(5, 0.6, f"day {day}, offer {offer}", 0.7)))
# ```

# %%
play(my_problem)

# %% [markdown]
# **Share it.** One call writes the class, what it uses, and its settings into one file.

# %%
path = share(my_problem, "my_problem.py")
print(*path.read_text(encoding="utf-8").splitlines()[:8], "...", sep="\n")

# %% [markdown]
# A friend who has EduGym and the file can play it in a terminal, `edugym play my_problem.py`, or in a notebook,
# `play("my_problem.py")`, and can train on it. Opening such a file runs it, so open only files from people whom you
# trust.

# %%
friends_problem = read_mdp("my_problem.py")
print("the same optimum:", exact.solve(friends_problem).start == exact.solve(my_problem).start)
play("my_problem.py")

# %% [markdown]
# **Hand in** the file and a page with it. (1) The wish in one sentence, and the four answers. (2) The best policy in
# words: is it what you meant? (3) Change your reward in a careless way that sounds reasonable. Solve the problem again,
# as in `Careless`, and say in numbers what the new reward teaches. (4) Leave one variable out of `observation`, as in
# `SeesTheTime`, and measure what it was worth for an agent: compare with Q-learning in the tour. (It may be less than nothing.) (5) Which agent did best,
# and what may be a reason? Look at a friend's problem too: find a policy that earns a lot and that your friend did not
# mean.

# %% [markdown]
# ### From a blank file
# The form of `edugym` did much for you: it seeded chance and kept the state. Now write an environment without it, from
# an empty cell, with NumPy and Gymnasium only, so that anybody's agent can play it. Some 40 lines; take your problem of
# exercise 4, or a new one.
#
# **What it must do.** `MyEnvironment()` makes an environment, a class that inherits from `gymnasium.Env`:
#
# - `__init__` sets `self.observation_space`, and `self.action_space`, which is `Discrete(n)` with two actions or more.
# - `reset(self, *, seed=None, options=None)` begins with `super().reset(seed=seed)`, which makes the generator
#   `self.np_random`. Then `reset` sets everything anew. All that changes belongs to `self`, and nothing to the class. It returns the first observation and a dictionary.
# - `step(self, action)` returns the observation, the reward, *terminated* (it is over), *truncated* (it is only cut off, after a fixed number of steps larger than 1; both are True or False of Python) and a dictionary. Every episode ends within 10 000 steps,
#   also if one action is taken again and again: if in doubt, truncate it. An action may be a whole number of Python or of NumPy.
# - The same seed and the same actions give the same episode.
#
# The check plays many episodes and calls Gymnasium's own checker. It cannot know what you mean. If this is your problem
# of exercise 4, write `check(project_10, (MyEnvironment, my_problem))` instead: this compares which observation follows how often, with which reward, and when an episode ends.
# (Both must observe the same numbers, in the same order and form.) If you wrote
# the program of lesson 0, let it learn this; it needs a `Discrete` observation space, so number your states.

# %% tags=["project"]
MyEnvironment = ...  # your program
### BEGIN PROGRAM
import gymnasium


class MyEnvironment(gymnasium.Env):
    """A flower shop, from Monday to Saturday: how many bunches to order each morning; the state is (day, stock)."""

    def __init__(self):
        """Seven mornings with the last one, and up to 6 bunches; order 0 to 3."""
        self.observation_space = gymnasium.spaces.MultiDiscrete([7, 7])
        self.action_space = gymnasium.spaces.Discrete(4)

    def reset(self, *, seed=None, options=None):
        """Monday, and nothing in stock."""
        super().reset(seed=seed)
        self.day, self.stock = 0, 0
        return self.observation(), {}

    def step(self, action):
        """Order, sell what is asked for, and go home; half of what is left has withered."""
        there = min(self.stock + int(action), 6)
        sold = min(there, int(self.np_random.binomial(6, 0.4)))
        self.day, self.stock = self.day + 1, (there - sold) // 2
        return self.observation(), 3.0 * sold - 1.0 * int(action), self.day == 6, False, {}

    def observation(self):
        """The day and the stock."""
        return np.array([self.day, self.stock], dtype=np.int64)


### END PROGRAM

# %% tags=["project"]
from edugym_course.lessons.own_problem.project import project_10

check(project_10, MyEnvironment)

# %% [markdown]
# ## What you saw
#
# ### In one paragraph
# *Learn it by heart, or better, say it in your own words.* To state a problem is to choose states, actions, dynamics
# and a reward. The state must include everything about the past that makes a difference for the future. The reward is
# not a description of what I want but the only thing that is paid, and the best policy is best for what is paid. So I
# solve a small version exactly, look at what the best policy *does*, and count what I care about, before I train
# anything. If I want to help an agent with hints, I give them as a potential: it keeps the best policy, but may slow learning
# down.
#
# ### Limits
# All of this could be solved exactly, which real problems cannot. There a careless reward is found out late, by
# watching what the agent does. We chose the numbers 4 and 10 by feeling; lesson 14 learns a reward from what a
# teacher prefers.
#
# ### Further reading
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 3.2 (goals and rewards), 17.3 (observations and state), 17.4
#   (designing reward signals).
# - Ng, Harada and Russell (1999), *Policy invariance under reward transformations: theory and application to reward
#   shaping*.
# - Wiewiora (2003), *Potential-based shaping and Q-value initialization are equivalent*.
# - Randløv and Alstrøm (1998), *Learning to drive a bicycle using reinforcement learning and shaping*: a bonus for
#   progress that taught it to ride in circles.
# - Amodei, Olah, Steinhardt, Christiano, Schulman and Mané (2016), *Concrete problems in AI safety*: reward hacking.
# - Moerland et al. (2023), *EduGym: An environment and notebook suite for reinforcement learning education*: the paper.
