# %% [markdown]
# # On- and off-policy: Roadrunner
#
# **The challenge.** An agent that learns must also explore, and exploring near a cliff is dangerous. Should it learn what
# is best for an agent that never slips, or what is best for itself, slips included?
#
# **You will be able to** say in one sentence what makes a method on-policy or off-policy; write Q-learning, SARSA and
# expected SARSA as one update with three targets; predict which of them earns more when it explores rarely, and which when
# it explores often; and compute on the exact model where that changes.
#
# **Time.** {time} **Before you start.** You should know what
# a value function and Q-learning are (Sutton and Barto, 2nd edition, sections 3.5 and 6.5), and ε-greedy action selection
# (section 2.2). All symbols are in the
# [table of notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).

# %%
from typing import NamedTuple

import gymnasium as gym
import numpy as np

from edugym import (
    SARSA,
    EpsilonGreedy,
    ExpectedSARSA,
    QLearning,
    TabularObservation,
    finite_model,
    make_mdp,
    policy_evaluation,
    repeat,
    table_size,
    value_iteration,
)
from edugym.agents.tables import epsilon_greedy_value, greedy_action, one_step_target
from edugym.experiments.figures import Sheet
from edugym.training import loops
from edugym_course.lessons.on_off_policy import exact, figures, methods
from edugym_course.notebook import frames, play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: a road that ends at a cliff
#
# A runner stands at the beginning of a road of $W = 10$ cells. At every step it chooses its next speed: one cell a step
# slower than now, the same, or one faster. Then it moves by that speed. It must arrive *exactly* at the last cell. One
# cell further is the cliff.

# %%
env = gym.make("edugym/Roadrunner-v0").unwrapped
env.reset(seed=0)
for action in (2, 2):  # faster, faster
    env.step(action)
env.scene()

# %% [markdown]
# As a Markov decision process: $s$ is the state, $a$ the action, $s'$ the next state.
#
# | | | in words |
# |---|---|---|
# | states | $s = (x, \mathit{dx})$ | the position $x$, from 0 to $W - 1$, and the speed $\mathit{dx}$ |
# | actions | $\mathcal{A} = \{0, 1, 2\}$ | slower, same speed, faster |
# | dynamics | $\mathit{dx}' = \mathit{dx} + a - 1$, then $x' = x + \mathit{dx}'$ | nothing is random; the top speed is 10 |
# | reward | $+1$ at the last cell | the target, $x' = W - 1$ |
# | | $-100$ for a fall or a stall | a fall: $x' > W - 1$; a stall: $\mathit{dx}' < 0$ |
# | | $-1$ for every other step | so a fast run is better than a slow one |
# | discount | $\gamma = 1$ | future rewards count in full |
#
# An episode *terminates* at the target, by a fall, and by a stall. After 50 steps it is *truncated*. The *return* is
# the sum of the rewards.
#
# These methods are the environment. (`rng` draws random numbers, which the road does not need. `stop_zone` is 0,
# except in the last aside.)

# %%
source(type(env.mdp), "transition", "reward", "terminal", "has_failed")

# %% [markdown]
# **Play it yourself.** What is the best return that you can get? Then play that run again with a handicap: before each
# step throw a die. If it shows a one, press a button at random. Would you still take that run if a fall really hurt?

# %%
play("Roadrunner")

# %% [markdown]
# ## The idea: which policy do the values belong to?
#
# Two policies are at work in an agent that learns. The **behaviour policy** chooses the actions. Here it is ε-greedy:
# with probability $\varepsilon$ it *slips*, that is, it takes an action at random (which may happen to be the best one), and otherwise it takes the action with the largest value. The **target
# policy** $\pi$ is the one whose values are learned.
#
# - A method is **on-policy** if both are the same: it learns what its own behaviour is worth, slips included.
# - A method is **off-policy** if they differ: it learns about another policy than the one that it follows.
#
# The value $q_\pi(s, a)$ is the expected return of an agent that takes action $a$ in state $s$ and follows the policy
# $\pi$ from then on. So it is the next reward, and what the policy earns from the next state on: there it takes action
# $a'$ with the probability $\pi(a' \mid s')$. On the road, where the next state is certain, that is (Sutton and Barto,
# equation 4.6, with $v_\pi$ written out):
#
# $$
# q_\pi(s, a) = r(s, a, s') + \gamma \sum_{a'} \pi(a' \mid s')\, q_\pi(s', a')
# $$
#
# A learning agent does not know $q_\pi$. It keeps a table $Q(s, a)$, and after each step from $S$ by $A$ to $S'$ with
# reward $R$ it moves one value a little, by the learning rate $\alpha$, towards a target $R + \gamma\, V(S')$ that
# looks like the right side:
#
# $$
# Q(S, A) \leftarrow Q(S, A) + \alpha \left[ R + \gamma\, V(S') - Q(S, A) \right]
# $$
#
# The three methods of this lesson differ in one thing only: what they take for $V(S')$, the value of the next state.
# $A'$ is the action that the agent has chosen to take there.
#
# | method | $V(S')$ | equation in the book | target policy |
# |---|---|---|---|
# | SARSA | $Q(S', A')$ | 6.7 | the ε-greedy policy that it follows: $A'$ may be a slip |
# | expected SARSA | $\sum_a \pi(a \mid S')\, Q(S', a)$ | 6.9 | the same, but with the mean over all $A'$ instead of one |
# | Q-learning | $\max_a Q(S', a)$ | 6.8 | the greedy policy, which never slips |
#
# So SARSA and expected SARSA are on-policy, Q-learning off-policy. After a terminal state there is no future, and the
# target is $R$ alone.
#
# ### SARSA: the action that comes next
# It needs $S, A, R, S', A'$ for one update, and that is its name. So the loop must choose $A'$ *before* the agent learns,
# and then really take it. (The loop of Q-learning and expected SARSA is that of lesson 0.) The road shows a position and a
# speed, and a table has numbered rows: `TabularObservation` turns the one into the other, as in lesson 0. `train` and
# `repeat` do so by themselves.

# %%
road, rng = TabularObservation(gym.make("edugym/Roadrunner-v0")), np.random.default_rng(0)
agent = SARSA.create(road, learning_rate=0.1, discount=1.0)
for _ in range(500):
    (state, info), total, terminated, truncated = road.reset(), 0, False, False
    action = agent.act(state, rng)
    while not (terminated or truncated):
        next_state, reward, terminated, truncated, info = road.step(action)
        next_action = agent.act(next_state, rng)
        agent.learn(state, action, reward, next_state, next_action, terminated)
        state, action, total = next_state, next_action, total + reward
print("return of the last episode, slips included:", total)

# %% [markdown]
# And this is the loop that really runs when you call `train` or `repeat`. It asks the rules of the road themselves, `mdp`,
# and not an environment of Gymnasium. Look for the line in which $A'$ is chosen: it stands before `agent.learn`. (`log` adds
# up the returns of the training episodes, and `carry` is where the loop goes on when it is called again. `truncated`
# is dropped for a `learn` without it, as that of SARSA.)

# %%
source(loops.on_policy)

# %%
source(SARSA.learn)

# %%
source(one_step_target)

# %% [markdown]
# ### Expected SARSA: the mean over the next actions
# $A'$ is drawn at random, so the target of SARSA is noisy. Its mean can be computed. With probability $1 - \varepsilon$ an
# ε-greedy policy takes the best action. Otherwise it draws one of all $n$ actions, each with the same probability, so that
#
# $$
# \sum_a \pi(a \mid S')\, Q(S', a) = (1 - \varepsilon) \max_a Q(S', a) + \varepsilon \, \frac{1}{n} \sum_a Q(S', a)
# $$

# %%
source(ExpectedSARSA.learn)

# %% [markdown]
# The exploration strategy knows its own probabilities. For ε-greedy, `expected_value` is this function:

# %%
source(epsilon_greedy_value)

# %% [markdown]
# ### Q-learning: as if it never slipped
# Set $\varepsilon = 0$ in the equation above, and only the maximum is left. Q-learning still *behaves* ε-greedily; it just
# does not count on its slips.

# %%
source(QLearning.learn)

# %% [markdown]
# ## The experiment: who learns the better run?
#
# All three methods learn on the same road with the same settings. The *greedy* return is that of an episode without
# slips, played with the values learned so far. The return *while exploring*, or *online* return, is that of the
# training episodes, slips included.
#
# | setting | value |
# |---|---|
# | all | tabular, $\alpha = 0.03$, $\gamma = 1$, $\varepsilon = 0.1$, all values start at 0, ties broken at random |
# | training | 200 000 steps |
# | evaluation | one greedy episode every 10 000 steps |
# | repetitions | 30; bands are 95 % intervals |
#
# Two black lines show what is possible, computed from the exact model: the optimum (dashed), and the return of the best
# *ε-soft* policy (dotted): the best policy among those that take a random action with probability $\varepsilon = 0.1$ in
# every state. No agent that explores with this $\varepsilon$ can earn more in the long run.
#
# The cell after the next is the whole experiment. (Further down `methods.compare` makes this call, with other
# settings.)
#
# **Predict.** Who is ahead at the end?

# %%
ahead = predict(
    "At the end of training ...",
    [
        "Q-learning is ahead in both returns",
        "SARSA is ahead in both returns",
        "Q-learning is ahead when greedy, SARSA while exploring",
        "SARSA is ahead when greedy, Q-learning while exploring",
    ],
)
ahead

# %%
settings = {"learning_rate": 0.03, "discount": 1.0, "exploration": EpsilonGreedy(0.1)}
agents = {
    "Q-learning": lambda road: QLearning.create(road, **settings),
    "SARSA": lambda road: SARSA.create(road, **settings),
    "expected SARSA": lambda road: ExpectedSARSA.create(road, **settings),
}
edge = repeat("Roadrunner", agents, n_steps=200_000, repetitions=30, evaluate_every=10_000)
display(figures.learning_curves(edge))
greedy = {method: edge.final(method).mean() for method in edge.methods}
exploring = {method: methods.online(edge, method).mean() for method in edge.methods}
for method in edge.methods:
    print(f"{method:14}: greedy {greedy[method]:.2f}, exploring {exploring[method]:.2f} (second half of training)")
leaders = [max(("Q-learning", "SARSA"), key=returns.get) for returns in (greedy, exploring)]
if leaders[0] == leaders[1]:
    seen = f"{leaders[0]} is ahead in both returns"
else:
    seen = f"{leaders[0]} is ahead when greedy, {leaders[1]} while exploring"
ahead.measured(seen)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Each wins one of the two. Without slips Q-learning reaches the optimum, −2, and SARSA takes one step more,
# −3. While they explore, SARSA earns about −7.3 a run, as much as the best ε-soft policy, and Q-learning only −9. Q-learning
# has the values of a runner that never slips, and the other two those of one that does.
# </details>

# %% [markdown]
# Watch what they have learned: one greedy episode of Q-learning, and one of SARSA.

# %%
frames("Roadrunner", edge.agents["Q-learning"][0])

# %%
frames("Roadrunner", edge.agents["SARSA"][0])

# %% [markdown]
# And this is Q-learning while it explores: the first episode after training in which a slip takes it over the edge.

# %%
actions, episodes = methods.first_fall(edge.agents["Q-learning"][0])
print(f"episode {episodes} after training, ε = 0.1")
frames("Roadrunner", actions)

# %% [markdown]
# ## Your turn
#
# What makes the gap (what SARSA earns more than Q-learning while exploring) wider, and what closes it? Try the reward of a `fall`, and $\varepsilon$.
# Find a road, by its length $W$, on which both learn the same run. What does a large learning rate do, and to which method?
# Move a slider and release it: the experiment is computed again, with 10 repetitions of 50 000 steps. (Some lines lie on
# each other, and a line that is missing lies below the panel. On some roads, as with $W = 8$, a safe run is as short as the
# fast one.)


# %%
def one_road(epsilon=0.1, alpha=0.03, gamma=1.0, fall=-100, W=10):
    """Draw the greedy and the online returns of the three methods on one road."""
    parameters = {"size": W, "negative_reward": fall}
    results = methods.compare(
        epsilon=epsilon, learning_rate=alpha, discount=gamma, parameters=parameters, n_steps=50_000, repetitions=10
    )
    return figures.learning_curves(results, make_mdp("Roadrunner", **parameters), epsilon, f"W = {W}, fall {fall}")


sliders(
    one_road,
    epsilon=(0.0, 0.5, 0.01),
    alpha=(0.01, 1.0, 0.01),
    gamma=(0.5, 1.0, 0.01),
    fall=(-200, -1),
    W=(5, 15),
)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.**
#
# - **fall.** The gap is 3.9 at −200, 1.5 at −100 (1.7 above, with 200 000 steps) and 0.3 at −50. At −30
#   Q-learning is ahead.
# - **ε.** The gap is about 3 from $\varepsilon = 0.2$ to 0.4, and 2.3 at 0.5.
# - **W.** On $W = 7$ all three learn the same run.
# - **γ.** It hardly changes the gap.
# - **α.** With $\alpha = 1$ most runs of SARSA do not even reach the target.
# </details>

# %% [markdown]
# ## See inside: the last step
#
# A runner has a position and a speed, so the whole task fits into one picture. Each cell is a state. The number in it says
# how many of the three actions are deadly there: they end in a fall, or, at speed 0, in a stall. The lines are the best
# run of a runner that never slips (fast), the best run of one that slips with $\varepsilon = 0.1$ (safe), and a second
# safe run, which is nearly as good. Only the dots are states; between two of them the runner jumps over cells. (Empty
# cells cannot be reached, or are the target.)

# %%
Sheet("plane", [[figures.in_the_plane()]])

# %% [markdown]
# Look at the last state before the target. The fast run gets there with speed 3, and one of the three actions is
# deadly. The safe runs get there with speed 2, and *no* action is deadly: faster takes them to the target, and the other
# two still leave them time to brake. One step more buys the last step without risk. (All can stall in their first step,
# so even a safe run is not quite safe. The second safe run follows the fast run to position 3, and slows down there.)
#
# When is that worth it? In the last step of the fast run the agent takes the deadly action with probability
# $\varepsilon / 3$: it slips, and one of three random actions is deadly. A fall costs about 100. The safe run costs 1,
# for its additional step. The two are equally good where
#
# $$
# 100 \cdot \frac{\varepsilon}{3} \approx 1 \quad\Rightarrow\quad \varepsilon \approx 0.03
# $$
#
# This looks at the last step only. The exact model can tell.
#
# **Predict.** From which $\varepsilon$ on is the safe run the better one, exactly?

# %%
change = predict("The safe run is better from ε = ... on", unit="(from 0 to 1)")
change

# %%
model = finite_model(make_mdp("Roadrunner"))
lines = figures.switch_lines(model)
display(Sheet("switch", [[lines]]))
for epsilon in (0.01, 0.1):
    fast, safe = (exact.share_lost(model, epsilon, planned_for) for planned_for in (0.01, 0.1))
    print(f"ε = {epsilon}: falls and stalls in {fast:.1%} of the fast runs, in {safe:.1%} of the safe ones")
change.measured(lines.change)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** 0.032, so the estimate was close. In this figure the upper one of the two lines is the best ε-soft policy:
# the fast run up to there, and from there on a safe run (the two safe runs differ by 0.001 at most where the second is better). At $\varepsilon = 0.1$ the fast run ends badly in 6.8 % of all
# episodes, and the safe run in 4.1 %: a slip in the first step stalls in $\varepsilon / 3$ = 3.3 % of all episodes.
# </details>

# %% [markdown]
# ## Predict, then check
#
# ### "SARSA is safe"?
# **Predict.** With $\varepsilon = 0.01$ the fast run is the best, also for an agent that slips. Who earns more *while
# exploring*?

# %%
rarely = predict(
    "While exploring with ε = 0.01 ...",
    ["Q-learning earns more than SARSA", "SARSA earns more than Q-learning", "both earn the same, up to 0.1"],
)
rarely

# %%
shortfall = figures.shortfall_against_epsilon(repetitions=10)
display(Sheet("shortfall", [[shortfall]]))
at = shortfall.x.index(0.01)
lead = np.mean(shortfall.measured["SARSA"][at] - shortfall.measured["Q-learning"][at])
print(f"at ε = 0.01 SARSA earns {lead:+.2f} a run compared with Q-learning")
more, less = ("SARSA", "Q-learning") if lead > 0 else ("Q-learning", "SARSA")
rarely.measured("both earn the same, up to 0.1" if abs(lead) < 0.1 else f"{more} earns more than {less}")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Q-learning earns more, by about 0.6. The figure shows how much each method loses against the best
# ε-soft policy. Q-learning loses nothing for small $\varepsilon$, and more and more above 0.03, since it runs as if it
# never slipped. SARSA is the other way round: good for large $\varepsilon$, too careful for small ones. Expected SARSA is
# close to the best everywhere. (Where a line is above 0, that is chance.)
# </details>

# %% [markdown]
# Why is SARSA too careful there? The safe run does not pay with so few slips. Here is what it believes about the fast run.

# %%
rare = methods.compare(epsilon=0.01, repetitions=10)
print("ε = 0.01, at position 3 with speed 2, the values of")
for method in rare.methods:
    slower, _, faster = methods.mean_values(rare, method, x=3, dx=2)
    print(f"{method:14}: slower (to the second safe run) {slower:z.2f}, faster (the fast run) {faster:z.2f}")
slipped = methods.mean_values(rare, "SARSA", x=6, dx=3)[2]
print(f"at position 6 with speed 3, the last state of the fast run, SARSA's value of faster is {slipped:.0f}")

# %% [markdown]
# SARSA believes that from there the fast run is worth about −1.3. For an agent that slips with $\varepsilon = 0.01$ it
# is worth −0.34 from there, as expected SARSA has found. (The 0 of Q-learning is that of an agent that never slips.) We
# think that SARSA was unlucky, and takes long to get over it. Where a deadly slip is drawn in the last state of the fast run, SARSA
# has $A'$ = faster in its target, and $Q(S', A')$ is far below 0, here −48. So the value of the action that leads
# into this state drops at once by $\alpha \cdot 48$, about 1.4. The two runs differ by less than 1, so from
# now on the safe run looks better. The agent then tries the fast run only when it slips into it, and each such try
# repairs only 3 % of the damage. Expected SARSA has the same slip in its target *at every visit*, with its true weight
# $\varepsilon/3$, so no single one can scare it.
#
# If that is so, a much smaller learning rate helps: with $\alpha = 0.001$ a slip takes
# off no more than 0.1.

# %%
for rate in (0.03, 0.001):
    runs = methods.compare(epsilon=0.01, learning_rate=rate, n_steps=3_000_000, repetitions=10)
    print(
        f"α = {rate}: SARSA ends with the fast run in {runs.share('SARSA', at_least=-2.0).estimate:.0%} of its agents"
    )

# %% [markdown]
# It does.
#
# ### Does it get over it?
# **Predict.** Let $\varepsilon$ fall evenly from 0.1 to 0.001 during training, here in two
# million steps. At the end the fast run is the best: it saves a step, and a
# fall is rare. Who has learned it?

# %%
decay = predict(
    "With a falling ε, most runs end with the fast run for ...",
    ["all three methods", "Q-learning and expected SARSA", "Q-learning and SARSA", "Q-learning only"],
)
decay

# %%
decayed = methods.let_epsilon_decay(repetitions=10)
display(figures.learning_curves(decayed, epsilon=None, title="ε falls"))
shares = {method: decayed.share(method, at_least=-2.0).estimate for method in decayed.methods}
print("runs that end with the fast run:", ", ".join(f"{method} {share:.0%}" for method, share in shares.items()))
learned = (decayed.curves("expected SARSA") >= -2.0).mean(axis=1) > 0.5  # at each evaluation
before, after = (0.1 - 0.099 * step / 2_000_000 for step in (learned.idxmax() - 100_000, learned.idxmax()))
print(f"expected SARSA changes to it between ε = {before:.3f} and {after:.3f}")
freed = tuple(method for method in ("SARSA", "expected SARSA") if shares[method] > 0.5)
decay.measured(
    {
        (): "Q-learning only",
        ("SARSA",): "Q-learning and SARSA",
        ("expected SARSA",): "Q-learning and expected SARSA",
        ("SARSA", "expected SARSA"): "all three methods",
    }[freed]
)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Q-learning and expected SARSA. The target of expected SARSA contains $\varepsilon$ itself: when
# $\varepsilon$ falls, the danger falls with it in every state that is still visited. Its agents change to the fast
# run between two evaluations, at $\varepsilon = 0.036$ and at 0.031, and the exact model says 0.032. SARSA, put off by drawn slips
# as above, keeps to the safe run, we think: it tries the fast run too seldom to correct that.
#
# (SARSA converges to the optimum if it tries every action infinitely often while $\varepsilon$ and $\alpha$ go to 0 at the
# right pace; Sutton and Barto, section 6.4 and equation 2.7. None of that is so here.)
# </details>

# %% [markdown]
# SARSA's ten agents go on in two ways, for 20 000 steps with $\varepsilon = 0.001$: as they are, and with the fast run on purpose in 10 %
# of the episodes. With these tries most change.

# %%
for forced in (0.0, 0.1):
    later = [methods.go_on(agent, forced, seed=k) for k, agent in decayed.complete_agents("SARSA").items()]
    fast = np.mean([len(methods.greedy_run(agent)) == 5 for agent in later])
    print(f"fast run on purpose in {forced:.0%} of the episodes: then {fast:.0%} of the agents have learned it")

# %% [markdown]
# ### Somebody else slips
# Is Q-learning blind to danger? Let the *road* slip. On an icy road, with probability 0.1, a random action takes the
# place of the one that the runner chose.

# %%
icy_road = methods.Icy(make_mdp("Roadrunner"), ice=0.1)
source(methods.Icy)

# %% [markdown]
# **Predict.** Q-learning explores with $\varepsilon = 0.1$ as before, now on the icy road. Which run does it learn?

# %%
on_ice = predict("On ice Q-learning learns ...", ["the fast run, as before", "the safe run", "neither, in most runs"])
on_ice

# %%
slippery = methods.compare(environment=icy_road, repetitions=10)
steps = [len(methods.greedy_run(agent)) - 1 for agent in slippery.complete_agents("Q-learning").values()]
print("steps of its greedy run, on the dry road:", steps)
print(f"the optimum on ice {value_iteration(finite_model(icy_road), horizon=50).start:.3f}")
print(f"the best ε-soft policy on the dry road, ε = 0.1: {exact.best_soft_return(model, 0.1):.3f}")
often = {name: np.mean(np.array(steps) == n) for name, n in (("the fast run, as before", 4), ("the safe run", 5))}
likely = max(often, key=often.get)
on_ice.measured(likely if often[likely] > 0.5 else "neither, in most runs")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** The safe run, in all ten runs. Q-learning leaves out its *own* slips, those of the behaviour policy. The
# slips of the road are part of the task: they are in every reward and every next state that it sees. The last two
# lines are equal, since a value does not care who slips. But an agent's slips end when it stops exploring, and
# the ice stays.
# </details>

# %% [markdown]
# ### The learning rate
# **Predict.** Raise the learning rate from 0.03 to 0.5. The online return of which method suffers most?

# %%
rough = predict("With α = 0.5 instead of 0.03, who loses most?", ["Q-learning", "SARSA", "expected SARSA"])
rough

# %%
rates = figures.online_against_rate(repetitions=10)
display(Sheet("rates", [[rates]]))
low, high = rates.x.index(0.03), rates.x.index(0.5)
losses = {method: np.mean(rows[low]) - np.mean(rows[high]) for method, rows in rates.measured.items()}
print("loss:", ", ".join(f"{method} {loss:.2f}" for method, loss in losses.items()))
rough.measured(max(losses, key=losses.get))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** SARSA. In the figure its line crosses that of Q-learning near $\alpha = 0.3$, and at 0.5 it lies below.
# Its targets draw $A'$ at random. Expected SARSA is the same method without the draw, and like Q-learning it does not
# mind even $\alpha = 0.7$. So it is the draw: with a large learning rate the values of SARSA follow, we think, the last
# few actions $A'$, slips or not. Compare Figure 6.3 of Sutton and Barto, on another cliff.
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: the same on another cliff
# CliffWalking is an environment of Gymnasium (Example 6.6 of Sutton and Barto). The agent walks on a grid of 4 by 12,
# from the lower left corner to the lower right one. Between them is a cliff (red): a step into it costs 100 and leads
# back to the start. Every other step costs 1. An environment is swapped in by its name. (The settings: $\varepsilon =
# 0.1$, $\alpha = 0.1$, $\gamma = 1$, 20 000 steps, episodes truncated after 500 steps, 5 repetitions. The optimum is
# −13, for 13 steps.)
#
# **Predict.** Which of the methods walk along the edge when they are greedy, in most runs?

# %%
edge_walkers = predict("Along the edge walk ...", ["all three", "Q-learning only", "SARSA and expected SARSA", "none"])
edge_walkers

# %%
cliff = methods.compare_on_cliff(n_steps=20_000, repetitions=5)
display(figures.cliff_figure(cliff))
for method in cliff.methods:
    earned = methods.online(cliff, method).mean()
    print(f"{method:14}: greedy {cliff.final(method).astype(int).tolist()}, while exploring {earned:.1f} (second half)")
walkers = [method for method in cliff.methods if cliff.share(method, at_least=-13.0).estimate > 0.5]
names = {(): "none", ("Q-learning",): "Q-learning only", ("SARSA", "expected SARSA"): "SARSA and expected SARSA"}
edge_walkers.measured(names.get(tuple(walkers), "all three"))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Q-learning only, with the optimal 13 steps. The other two keep one row of distance, which costs them
# two steps. While exploring they earn about −25 a walk, and Q-learning about −49. The left panel shows the walk that
# most of the five runs end with.
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: stopping before the edge
# In the paper (Moerland et al., 2023) the agent may also stop *close* to the edge. With
# `stop_zone = 2` an episode ends well in one of the last three cells, 7, 8 and 9, and each cell short of the last costs 1.
#
# **Predict.** With $\varepsilon = 0.2$ and $\alpha = 0.1$, in which cell does SARSA stop, without slips and on average
# over 30 runs?

# %%
stop = predict("SARSA stops in cell ...", unit="(7 to 9)")
stop

# %%
zone = methods.compare(epsilon=0.2, learning_rate=0.1, parameters={"stop_zone": 2}, repetitions=30)
for method in zone.methods:
    places = methods.stopping_places(zone, method, stop_zone=2)
    print(f"{method:14} stops in cell", ", ".join(f"{cell}: {places.count(cell)} times" for cell in (7, 8, 9)))
gentle = methods.compare(epsilon=0.2, learning_rate=0.003, parameters={"stop_zone": 2}, repetitions=30)
places = methods.stopping_places(gentle, "SARSA", stop_zone=2)
print("SARSA, α = 0.003, stops in cell", ", ".join(f"{cell}: {places.count(cell)} times" for cell in (7, 8, 9)))
stop.measured(np.mean(methods.stopping_places(zone, "SARSA", stop_zone=2)))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Between 8 and 9. Q-learning always stops at the edge, and SARSA before it, in cell 8, in more than half of
# its runs. This is the paper's picture of the two. Expected SARSA stops in cell 8 in all its runs, which
# is the best for $\varepsilon = 0.2$. The other runs of SARSA were unlucky again, we think. With $\alpha = 0.003$ all but one stop in cell 8.
# </details>

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for your answer, and below it a cell that checks it. The check says what was
# expected, what came, and which mistake that looks like. It runs your code on cases that it makes up.

# %%
from edugym_course.grading import check
from edugym_course.lessons.on_off_policy.exercises import CHALLENGE, exercise_1, exercise_2, exercise_3

# %% [markdown]
# ### Exercise 1: change a parameter
# With $\varepsilon = 0.1$ the safe run is the best, since the reward of a fall or a stall is −100. Make it milder. What
# is the *lowest* (most negative) reward of a fall for which the fast run is still the best at $\varepsilon = 0.1$? Set
# `negative_reward` to that number, with one digit after the decimal point. Before you compute: what does the estimate
# of the section "See inside" say?
#
# <details><summary>Hint</summary><code>exact.best_run(0.1, negative_reward=-100)</code> gives the states of the best run,
# planned on the exact model and played without slips. The fast run has 4 steps, so 5 states. Try some values, or write a
# loop.</details>

# %%
negative_reward = -100.0
### BEGIN SOLUTION
while len(exact.best_run(0.1, negative_reward=negative_reward)) > 5:
    # own: while len(exact.best_run({epsilon}, negative_reward=negative_reward)) > 5:
    negative_reward += 0.1
### END SOLUTION

# %% tags=["check"]
check(exercise_1, negative_reward)

# %% [markdown]
# ### Exercise 2: compute the change on the exact model
# Write a function that finds the smallest $\varepsilon$, to 0.001, at which the best ε-soft policy no longer takes the
# fastest run. It is given the exact model of a road; the roads of the check have other lengths and other rewards for a
# fall. The change is below 0.2 on all of them.
#
# The two functions that you need are imported. `value_iteration(model, epsilon=ε, horizon=50)` plans for an agent that
# slips with probability ε: it computes the best values with one step left, from them those with two steps left, and so
# on up to 50 (Sutton and Barto, section 4.4). The method `.greedy_policy()` of what it
# returns is the greedy policy of that agent. And `policy_evaluation(model, policy, horizon=50).start` is the return of
# a policy from the start, played as it is: a greedy policy does not slip there.
#
# <details><summary>Hint</summary>A greedy policy that is evaluated as it is never slips, so its return says how many steps
# it takes. Compare it with the return of the best policy for ε = 0. A loop over <code>np.arange(0, 0.2, 0.001)</code>
# is good enough; halving an interval is faster.</details>


# %%
def switch(model):
    """Return the smallest ε at which the best ε-soft policy no longer takes the fastest run."""
    ### BEGIN SOLUTION
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.001):
        # own: for epsilon in np.arange(0.0, 0.35, 0.001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        # own: policy = value_iteration(model, epsilon=epsilon / {calm}, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return epsilon
    return 0.2
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_2, switch)
### BEGIN HIDDEN TESTS
check(exercise_2, switch, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 3: an agent with two policies
# Q-learning counts on no slips, and expected SARSA counts on its own. Why not count on *any* number of slips? Think of a
# robot: in the laboratory it may explore wildly, and later it will slip rarely, but not never.
#
# Write the `learn` of an agent with two numbers. It *acts* with `epsilon`, $\varepsilon$, and it *learns* the values of a
# target policy that slips with probability `target_epsilon`, which we call $\varepsilon_\pi$. Its target is
#
# $$
# R + \gamma \left[ (1 - \varepsilon_\pi) \max_a Q(S', a) + \varepsilon_\pi \, \frac{1}{n} \sum_a Q(S', a) \right]
# $$
#
# where $n$ is the number of actions, and the bracket is 0 after a terminal state. Read the numbers from `self`:
# `self.learning_rate` is $\alpha$, `self.discount` is $\gamma$. (`state` is the number of a row of `Q`; for a loop of
# your own, `TabularObservation` makes it one, as above.)
#
# The race below shows three of your agents on the lesson's road. One acts with $\varepsilon = 0.1$ and plans for
# $\varepsilon_\pi = 0.02$, one plans for 0.1, and one plans for 0.1 as well but acts *wholly at random*, $\varepsilon
# = 1$. Before you run the check: which run does each of them learn?
#
# <details><summary>Hint</summary><code>self.Q[next_state]</code> is the row of the next state. Its largest value is
# <code>max(self.Q[next_state])</code>, and its mean <code>np.mean(self.Q[next_state])</code>.</details>


# %%
class TwoPolicies(NamedTuple):
    """Acts ε-greedily with one ε, and learns the values of the policy with another one."""

    Q: np.ndarray  # shape (n_states, n_actions)
    learning_rate: float = 0.03
    discount: float = 1.0
    epsilon: float = 0.1
    target_epsilon: float = 0.1

    @classmethod
    def create(cls, environment, **settings):
        """Make a new agent for an environment: all values are 0."""
        return cls(np.zeros(table_size(environment)), **settings)

    def greedy(self, state, rng):
        """Choose the action with the highest value; among equals, one at random."""
        return greedy_action(self.Q, state, rng)

    def act(self, state, rng):
        """Choose a random action with probability ε, else the best one."""
        if rng.random() < self.epsilon:
            return int(rng.random() * self.Q.shape[1])
        return self.greedy(state, rng)

    def learn(self, state, action, reward, next_state, terminated):
        """Learn from one transition."""
        ### BEGIN SOLUTION
        value = 0.0
        if not terminated:
            best, mean = max(self.Q[next_state]), np.mean(self.Q[next_state])
            value = (1 - self.target_epsilon) * best + self.target_epsilon * mean
        target = reward + self.discount * value
        # own: target = reward - {cost} + self.discount * value
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])
        ### END SOLUTION


# %% tags=["check"] points=3
check(exercise_3, TwoPolicies)
### BEGIN HIDDEN TESTS
check(exercise_3, TwoPolicies, seed=1, quiet=True)
### END HIDDEN TESTS
display(
    figures.race(
        {
            "ε_π = 0.02": lambda road: TwoPolicies.create(road, target_epsilon=0.02),
            "ε_π = 0.1": lambda road: TwoPolicies.create(road, target_epsilon=0.1),
            "ε_π = 0.1, ε = 1": lambda road: TwoPolicies.create(road, target_epsilon=0.1, epsilon=1.0),
        }
    )
)

# %% [markdown]
# <details><summary>What the race shows</summary>
#
# The agent that plans for 0.02 learns the fast run, and its greedy line lies on that of Q-learning: 0.02 is below the change
# at 0.032. The one that plans for 0.1 is expected SARSA, line for line. The third one learns the safe run too,
# although it hardly ever made a careful run; while it acts at random it earns about −89 a run, far below the panel. So
# what an agent learns need not depend on how it behaves. (In a large task the behaviour decides *where* it learns
# something.)
# </details>

# %% [markdown]
# ### The open challenge: every fall counts
# The same road, and 5 000 steps in all, about a thousand runs. This time *all* training episodes count, with every fall and
# every stall: how much does your agent earn while it learns? Of the task it is told only its observation space and its
# action space. It needs `act` and `learn`, like yours of exercise 3 (`table_size(road)` is the shape of its table),
# and it may explore as it likes. It is trained ten times, with seeds that belong to your name.
#
# No run is better than −2. Your points are that number divided by the mean return of your agent, in percent: an agent
# that earns −4 a run gets 50. The agent below is ahead of the three methods of
# the lesson with $\varepsilon = 0.1$ and $\alpha = 0.1$: beat it.
#
# Half a page with it: which policy does your agent follow, and which one does it evaluate? How does it find out where the
# edge is, and how often does it have to fall? Would it still be good if the road were icy, so that the *road* made it slip?


# %%
def my_agent(road):
    """Make the agent for the challenge; put your own in its place."""
    return ExpectedSARSA.create(road, learning_rate=0.5, discount=1.0, exploration=EpsilonGreedy(0.05))


CHALLENGE.score(my_agent, "Ada Lovelace")

# %% [markdown]
# ### From a blank file
# Now write it all yourself, from an empty cell, with NumPy and Gymnasium only: SARSA and its loop, some 35 lines. It
# chooses $A'$ before it learns, and then really takes it. (After a reset it draws a new first action, in the new state.)
#
# **What it must do.** `my_program(environment, n_steps, seed)` takes `n_steps` steps in a Gymnasium environment, episode after
# episode, and learns from them at once. In the end it returns its *policy*: a function that takes a state and returns the
# action with the highest value. All else is up to you: functions, classes, any names, and how ties are broken.
#
# - States and actions are whole numbers from 0. `environment.observation_space.n` and `environment.action_space.n` say how
#   many there are. They differ from one environment to the next.
# - Take $\alpha = 0.5$, $\gamma = 1$, $\varepsilon = 0.1$ (a random action is any of all $n$) and first values of 0.
# - Only `terminated` means that nothing follows. Where a step is truncated, either do not learn from it, or
#   draw an $A'$ that is used in its target only, $R + \gamma Q(S', A')$, and never taken.
# - Draw all random numbers from `np.random.default_rng(seed)`, and give the seed to the first `reset` alone.
#
# The check runs your program in small worlds of its own and on the cliff of Gymnasium, `CliffWalking-v1`. It sees the
# steps that your program takes, and no line of it. So the mistake that it names is only the likely one.

# %% tags=["project"]
my_program = ...  # your program
### BEGIN PROGRAM


def choose_action(values, epsilon, rng):
    """Return an action by ε-greedy, ties broken at random."""
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return rng.choice(np.flatnonzero(values == values.max()))


def my_program(environment, n_steps, seed):
    """Learn by SARSA for `n_steps` steps, and return the greedy policy."""
    alpha, gamma, epsilon = 0.5, 1.0, 0.1
    rng = np.random.default_rng(seed)
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    state, _ = environment.reset(seed=seed)
    action = choose_action(Q[state], epsilon, rng)
    for _ in range(n_steps):
        next_state, reward, terminated, truncated, _ = environment.step(action)
        next_action = choose_action(Q[next_state], epsilon, rng)
        target = reward if terminated else reward + gamma * Q[next_state, next_action]
        Q[state, action] += alpha * (target - Q[state, action])
        if terminated or truncated:
            next_state, _ = environment.reset()
            next_action = choose_action(Q[next_state], epsilon, rng)
        state, action = next_state, next_action
    return lambda state: choose_action(Q[state], 0.0, rng)


### END PROGRAM

# %% tags=["project"]
from edugym_course.lessons.on_off_policy.project import project_2

check(project_2, my_program)

# %% [markdown]
# ## What you saw
#
# ### In one paragraph
# *Learn it by heart, or better, say it in your own words.* A learning agent follows one policy, its behaviour policy,
# and learns the values of one, its target policy. If they are the same, the method is on-policy: SARSA and expected
# SARSA learn what their own exploring costs, and stay away from the edge if they slip often. If they differ, it is
# off-policy: Q-learning learns the best run for an agent that never slips, and pays for it while it slips often. What
# is best depends on how often the agent will slip when it matters. SARSA draws its next action at random, which adds
# noise; expected SARSA takes the mean, and can evaluate any policy.
#
# ### Limits
# The mean over all actions needs few actions and known probabilities. With function approximation off-policy learning can
# diverge, even with the mean (the "deadly triad", Sutton and Barto, section 11.3), while on-policy learning is more
# stable. And nothing here makes *learning* safe: all three methods fall many times before they know where the edge is.
#
# ### Further reading
# - Moerland et al. (2023), *EduGym: An environment and notebook suite for reinforcement learning education*: the
#   paper.
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 5.4 and 5.5 (on-policy, off-policy, target and behaviour
#   policies), 6.4 to 6.6 (the three methods, the cliff, Figure 6.3), 7.3 (why longer off-policy targets need corrections).
# - Rummery and Niranjan (1994), *On-line Q-learning using connectionist systems*: SARSA, before it had the name.
# - Watkins and Dayan (1992), *Q-learning*.
# - Van Seijen, van Hasselt, Whiteson and Wiering (2009), *A theoretical and empirical analysis of expected Sarsa*.
# - Singh, Jaakkola, Littman and Szepesvári (2000), *Convergence results for single-step on-policy
#   reinforcement-learning algorithms*: when SARSA with a falling ε does converge.
# - Denrell and March (2001), *Adaptation as information restriction: the hot stove effect*: whoever was burned once does
#   not come back to find out better.
