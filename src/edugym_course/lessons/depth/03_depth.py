# %% [markdown]
# # Depth of credit assignment: Study
#
# **The challenge.** A reward often comes long after the actions that earned it. An agent can hand the reward back one
# step at a time, which is slow, or to all earlier steps at once, which also hands back everything else that happened.
#
# **You will be able to** write down the $n$-step target and say what it becomes for $n = 1$ and for $n = \infty$;
# explain how far one episode carries a reward; say where the variance of a deep target comes from; and write an agent
# that looks deep without paying for its own exploration.
#
# **Time.** {time} **Before you start.** You should know the return and what an
# action value is (Sutton and Barto, 2nd edition, sections 3.3 and 3.5), SARSA (section 6.4) and ε-greedy action
# selection (section 2.2). All symbols are in the [table of
# notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).

# %%
import math
from typing import NamedTuple

import gymnasium as gym
import numpy as np

from edugym import EpsilonGreedy, NStepSARSA, TabularObservation, TreeBackup, make_mdp, repeat
from edugym.experiments.figures import Sheet
from edugym_course.lessons.depth import credit, experiments, figures, methods, off_policy, pictures, targets, traces
from edugym_course.notebook import frames, play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: ten days until the exam
#
# A student has $H = 10$ days. On each day the student does one thing: study, sleep, go out, or something else. On the
# last day there is an exam, and whoever studies on that day and is prepared passes it. Studying gives knowledge on
# three days only, the days with a lecture, and two of those are needed. Sleep gives energy, on any day, and two nights
# are needed. Going out takes energy. Days with neither lecture nor exam are *free days*. Everything has a small price,
# also on a free day. In the picture, what brought the student closer to passing is green, what led away from it is red,
# and what did neither is grey.

# %%
study = make_mdp("Study", layout_seed=5, action_reward_noise_sigma=0.2)
print("mean reward of each action:", dict(zip(study.action_names, study.action_rewards.round(2).tolist(), strict=True)))
frames(study, ["go out", "study", "study", "sleep", "other 1", "sleep", "study", "other 2", "sleep", "study"])

# %% [markdown]
# As a Markov decision process: $s$ is the state, $a$ the action, $s'$ the next state.
#
# | | | in words |
# |---|---|---|
# | states | $s = (\text{knowledge}, \text{energy}, \text{day})$ | all of it is observed; days count from 0 |
# | actions | $\mathcal{A} = \{0, \dots, N-1\}$, $N = 5$ | study, sleep, go out, and $N - 3$ others without any effect |
# | dynamics | deterministic | study on a lecture day: knowledge + 1; sleep: energy + 1 (up to 4); go out: energy − 1 (down to 0) |
# | reward | drawn from $\mathcal{N}(r_a, \sigma)$ | each action $a$ has a mean reward $r_a$ from −0.5 to 0; $\sigma$ is its noise |
# | | $+10$ | for studying on day $H - 1$, the exam, with knowledge ≥ 2 and energy ≥ 2 |
# | discount | $\gamma = 1$ | |
#
# $\mathcal{N}(r_a, \sigma)$ is the normal distribution with mean $r_a$ and standard deviation $\sigma$. An episode
# *terminates* after the last day, so every episode has ten steps. The lecture days and the prices $r_a$ are the
# *layout* of the task. They are drawn once, and the agent is not told.
#
# These methods are the environment. (`Student` is the state $s$, with one more field, `passed`, for the reward and the
# picture. `missing` counts what the exam still asks for.)

# %%
source(type(study), "transition", "reward", "passes", "missing", "terminal", "observation")

# %% [markdown]
# **Play it yourself, blind.** You see what the agent sees: three numbers and a reward. This is a short semester: six
# days, two lectures, both needed, and one night of sleep is enough. (The exam asks for *more* energy than
# `energy_needed`.) How many episodes until you pass? And when you pass for the first time: *which of your six actions
# earned it?*

# %%
play(
    "Study",
    total_days=6,
    n_actions=3,
    lecture_days=2,
    energy_needed=0,
    layout_seed=3,
    action_reward_noise_sigma=0.2,
    blind=True,
)

# %% [markdown]
# That question is the *credit assignment problem*: of all the actions before a reward, which ones deserve the credit?

# %% [markdown]
# ## The idea: how many rewards belong in the target?
#
# All agents of this lesson keep a table of action values $Q(s, a)$ and act ε-greedily: they take a random action with
# probability $\varepsilon$, and otherwise the one with the largest value. They move values towards a
# *target*. Those of the experiment differ in one number, $n$: how many real rewards the target contains before it ends
# with a learned value.
#
# SARSA uses one reward. The **$n$-step target** uses $n$ of them (Sutton and Barto, equation 7.4):
#
# $$
# G_{t:t+n} = R_{t+1} + \gamma R_{t+2} + \dots + \gamma^{n-1} R_{t+n} + \gamma^n Q(S_{t+n}, A_{t+n})
# $$
#
# If the episode is over by step $t + n$, the target is the sum of the rewards that there are, and no learned value
# follows. The update is the same for every $n$ (equation 7.5):
#
# $$
# Q(S_t, A_t) \leftarrow Q(S_t, A_t) + \alpha \left[ G_{t:t+n} - Q(S_t, A_t) \right]
# $$
#
# | $n$ | target of step $t$ | name |
# |---|---|---|
# | 1 | $R_{t+1} + \gamma Q(S_{t+1}, A_{t+1})$ | SARSA (section 6.4) |
# | 3 | $R_{t+1} + \gamma R_{t+2} + \gamma^2 R_{t+3} + \gamma^3 Q(S_{t+3}, A_{t+3})$ | 3-step SARSA |
# | $\infty$ | $R_{t+1} + \gamma R_{t+2} + \dots$ to the end of the episode | Monte Carlo (section 5.4) |
#
# To use a learned value in the target is called *bootstrapping*. Monte Carlo does not.
#
# Written down from the definition, the target of step $t$ is a few lines. `rewards` has the rewards of a whole episode:
# `rewards[t]` is $R_{t+1}$. `values` has the values of the actions taken: `values[t]` is $Q(S_t, A_t)$.


# %%
def n_step_target(t, n, rewards, values, gamma=1.0):
    """Return the target of step t: up to n rewards, and then a learned value if the episode goes on."""
    end = min(t + n, len(rewards))
    G = sum(gamma ** (k - t) * rewards[k] for k in range(t, end))
    return G + (gamma**n * values[end] if end < len(rewards) else 0.0)


for n in (1, 3, 10):
    print(f"n = {n:2}: target of the first step {n_step_target(0, n, [-1, -2, -3, 10], [5, 6, 7, 8]):g}")

# %% [markdown]
# Work these three out by hand: $-1 + 6$, then $-1 - 2 - 3 + 8$, and $-1 - 2 - 3 + 10$.
#
# With that an agent can learn when an episode is over, from the lists of all that happened:


# %%
def learn_from_lists(Q, states, actions, rewards, n, alpha):
    """Move the value of every step of an episode towards its n-step target."""
    for t in range(len(rewards)):
        values = [Q[s, a] for s, a in zip(states, actions, strict=True)]
        Q[states[t], actions[t]] += alpha * (n_step_target(t, n, rewards, values) - values[t])


semester, rng = TabularObservation(gym.make("edugym/Study-v0")), np.random.default_rng(0)
agent = NStepSARSA.create(semester, n=3, learning_rate=0.1, discount=1.0)
Q = agent.Q.copy()
for _ in range(100):
    states, actions, rewards, over = [], [], [], False
    state, info = semester.reset()
    action = agent.act(state, rng)
    while not over:
        next_state, reward, terminated, truncated, info = semester.step(action)
        next_action = agent.act(next_state, rng)  # as SARSA: before it learns
        agent.learn(state, action, reward, next_state, next_action, terminated, truncated)
        states, actions, rewards = [*states, state], [*actions, action], [*rewards, reward]
        state, action, over = next_state, next_action, terminated or truncated
    learn_from_lists(Q, states, actions, rewards, n=3, alpha=0.1)
print("after 100 episodes both tables are the same but for rounding:", np.allclose(agent.Q, Q))

# %% [markdown] tags=["aside"]
# ### Aside: the same without lists
# The agent of the package learns the same, although its code looks different. It does not wait for the end of the
# episode (which makes a difference only where a state comes twice in an episode) and needs no lists that grow. It keeps
# only the last $n$ rewards and actions, and the last $n + 1$ states, in places that are used again and again: hence
# `% n` and `% (n + 1)`. After each step, `first` is the step whose $n$ rewards are now complete. The first loop makes
# its target, backwards, and the second one is the update. When the episode ends, all steps that are left learn. (For
# $n = \infty$ the agent keeps as many rewards as the longest episode has.) In the picture orange is the step that learns,
# blue is what is new, and what is grey has been written over.

# %%
pictures.buffer(n=3, t=5)

# %%
source(NStepSARSA.learn)

# %% [markdown]
# ### How far does one episode carry a reward?
# Imagine the simplest case: the same episode of ten days again and again, and only its last step pays, 10. All values
# start at 0, and $\alpha = 0.1$. Monte Carlo moves the values of *all* days towards 10 in every episode. One-step SARSA
# moves only the value of the last day at first, because the next value is still 0 for every other day.
#
# **Predict.** After 7 such episodes the value of the first day has come half of its way with Monte Carlo
# ($0.9^7 < 0.5$). How many episodes does one-step SARSA need?

# %%
half_way = predict(
    "The same episode again and again, α = 0.1: with one-step SARSA the value of the first day is half of 10 after ...",
    unit="episodes",
)
half_way

# %%
for n in (1, 3, 5, math.inf):
    print(f"{methods.label(n):12} {figures.episodes_until(credit.handed_back(n)):3.0f} episodes")
display(credit.credit_maps())
half_way.measured(figures.episodes_until(credit.handed_back(1)))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** 97 episodes with $n = 1$, 37 with $n = 3$, 17 with $n = 5$, and 7 with Monte Carlo. Each map shows the
# values of the ten days (upwards) in the course of the episodes (to the right); dark means close to 10. With $n = 1$
# the reward climbs down a staircase with ten steps, one for each day. With $n = 3$ it has four, since three days learn
# together: $\lceil H/n \rceil = \lceil 10/3 \rceil = 4$. With Monte Carlo there is one step only.
#
# A rule to remember: the reward needs about $\lceil H/n \rceil / \alpha$ episodes to the first day. Here that is 100,
# 40, 20 and 10.
# </details>

# %% [markdown]
# ### Watch them
# Here are one-step SARSA and Monte Carlo after 60 episodes on the layout above, both without exploring.


# %%
def watch(n, episodes):
    """Show one episode of an agent without exploring, after so many episodes of training."""
    return frames(study, methods.pupil(n, study, episodes))


watch(1, episodes=60)

# %%
watch(math.inf, episodes=60)

# %% [markdown]
# Monte Carlo passes, and one-step SARSA does not yet. Both after 4 000 episodes: look at the free days.

# %%
watch(1, episodes=4_000)

# %%
watch(math.inf, episodes=4_000)

# %%
for n in (1, math.inf):
    learned = methods.greedy_return(study, methods.pupil(n, study, 4_000))
    print(f"{methods.label(n):12} return without noise: {learned:.2f}")
print(f"optimum      {study.reward_threshold:.2f}")

# %% [markdown]
# Both pass now. Here going out and sleeping are cheap. One-step SARSA has mostly found that out. Monte Carlo still spends free
# days on expensive things. Is that so in general?

# %% [markdown]
# ## The experiment: early and late
#
# The paper (Moerland et al., 2023) says: Monte Carlo learns fast after its first success and then has trouble with
# details; one-step methods learn slowly and end better; and Monte Carlo suffers more when rewards are noisier, or when
# there are more actions that do not matter. We test all of this. Here are three amounts of noise (an aside says whether
# more noise hurts Monte Carlo); more actions follow below.
#
# | setting | value |
# |---|---|
# | all | $n$-step SARSA, $\alpha = 0.1$, $\gamma = 1$, $\varepsilon = 0.1$, all values 0 at first, ties broken at random |
# | depths | $n = 1, 3, 5$ and $\infty$ (Monte Carlo) |
# | training | 40 000 steps, which are 4 000 episodes |
# | evaluation | the mean return of 3 episodes without exploring, every 1 250 steps |
# | repetitions | 60, each on its own layout, the same layouts for all methods; bands are 95 % intervals |
#
# The dashed line is the *optimum*, the dotted one the return of the best *ε-soft* policy, which takes a random action
# with probability $\varepsilon$ on every day. Both are exact. An evaluation does not explore, and can rise above
# the dotted line.
#
# The cell after the next is the whole experiment. (`methods.counted` counts how often an agent passes the exam while it
# trains. Further down `methods.compare` does all this, with other settings.)
#
# **Predict.** With the noisiest rewards, $\sigma = 1$: who is ahead after 250 episodes (2 500 steps), and who at the
# end?

# %%
ahead = predict(
    "One-step SARSA and Monte Carlo, at σ = 1:",
    [
        "Monte Carlo is ahead early and late",
        "Monte Carlo is ahead early, n = 1 late",
        "n = 1 is ahead early, Monte Carlo late",
        "n = 1 is ahead early and late",
    ],
)
ahead

# %%
settings = {"learning_rate": 0.1, "discount": 1.0, "exploration": EpsilonGreedy(0.1)}
settings["longest"] = 10  # the steps of an episode, for Monte Carlo
agents = {
    "n = 1": methods.counted(lambda study: NStepSARSA.create(study, n=1, **settings)),
    "n = 3": methods.counted(lambda study: NStepSARSA.create(study, n=3, **settings)),
    "n = 5": methods.counted(lambda study: NStepSARSA.create(study, n=5, **settings)),
    "Monte Carlo": methods.counted(lambda study: NStepSARSA.create(study, n=math.inf, **settings)),
}
how = {"repetitions": 60, "evaluate_every": 1_250, "evaluation_episodes": 3}
by_sigma = {
    sigma: repeat("Study", agents, 40_000, parameters={"action_reward_noise_sigma": sigma}, **how)
    for sigma in (0.0, 0.2, 1.0)
}
panels = [figures.curves(results, f"σ = {sigma:g}") for sigma, results in by_sigma.items()]
display(Sheet("depth", [panels[:2], panels[2:]]))
early = experiments.early_difference(by_sigma[1.0], "Monte Carlo", "n = 1").estimate > 0
late = experiments.final_difference(by_sigma[1.0], "Monte Carlo", "n = 1").estimate > 0
first, last = ("Monte Carlo" if first else "n = 1" for first in (early, late))
ahead.measured(f"{first} is ahead early and late" if early == late else f"{first} is ahead early, {last} late")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Monte Carlo is ahead early, by far, and $n = 1$ is ahead at the end, by a little. Early on, $n = 3$ and
# $n = 5$ lie between; with less noise a middle $n$ can even be the best. Late, all lines are close together and partly
# hide each other. (The small waves at $\sigma = 1$ are noise of the evaluation, which draws the same random numbers for
# all methods.)
# </details>

# %% [markdown]
# Early, depth helps at every $\sigma$, and the staircase gives one reason. Late, some runs do not pass the exam, and return
# about 10 less, which hides small differences in the mean. So which share of the runs passes in the end? And how much
# better is one method *on the layouts on which both pass*? These returns are computed without noise.

# %%
for sigma, results in by_sigma.items():
    one, deep = (methods.passes(results, method).mean() for method in ("n = 1", "Monte Carlo"))
    gap = experiments.difference_where_both_pass(results, "Monte Carlo", "n = 1")
    print(f"σ = {sigma:3g}: n = 1 passes in {one:4.0%} of runs, Monte Carlo in {deep:4.0%};", end=" ")
    print(f"where both pass, Monte Carlo less n = 1: {gap.estimate:+.2f} (95 %: {gap.low:+.2f} to {gap.high:+.2f})")

# %% [markdown]
# Among the runs that pass, Monte Carlo ends behind at each of these $\sigma$, even without any noise. (In the mean over all runs it need not.) So noise of the
# rewards cannot be the only reason. "See inside" gives one reason.

# %% [markdown] tags=["aside"]
# ### Aside: does noise make Monte Carlo end worse?
# **Predict.** The paper says that more noise makes Monte Carlo suffer more. Compare the mean final return of Monte
# Carlo at $\sigma = 1$ and at $\sigma = 0$, over all layouts and computed without noise.

# %%
noisy = predict("With more noise in its rewards, Monte Carlo ends ...", ["better", "the same, within 0.3", "worse"])
noisy

# %%
quiet_end, noisy_end = (methods.expected_returns(by_sigma[sigma], "Monte Carlo").mean() for sigma in (0.0, 1.0))
print(f"Monte Carlo ends with {quiet_end:.2f} at σ = 0, and with {noisy_end:.2f} at σ = 1")
met, passed = methods.met_exam(by_sigma[0.0], "Monte Carlo"), methods.passes(by_sigma[0.0], "Monte Carlo")
print(f"at σ = 0 it passed at least once in {met.mean():.0%} of runs; {passed[met == 1].mean():.0%} of these pass now")
change = noisy_end - quiet_end
noisy.measured("the same, within 0.3" if abs(change) < 0.3 else "better" if change > 0 else "worse")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Better, by more than one (in other draws by 0.4 to 2). At $\sigma = 0$ one run in five does not pass in the end, and these runs never
# passed at all. With $\sigma = 1$ all runs pass. The likely reason is that *noise also explores*: it changes again and
# again which action looks best. So Monte Carlo, taken by itself, does not suffer here: noise brings it more than it costs.
#
# *Compared with $n = 1$* it does, as the paper says, for $n = 1$ gains more. Over 300 other layouts $n = 1$ ends with 6.2
# at $\sigma = 0$ and with 7.8 at $\sigma = 1$, and Monte Carlo with 6.5 and 7.5.
# </details>

# %% [markdown]
# ## Your turn
#
# (10 repetitions of 1 000 episodes; the slider for $n$ adds a line for one more $n$.) What does a longer semester
# change, and for which $n$? Who feels $\varepsilon$, and who $\alpha$? With which settings is $n = 1$ the best?
# (Returns in the figures are not discounted, whatever $\gamma$ is.)


# %%
def one_study(sigma=0.2, n_actions=5, total_days=10, n=2, alpha=0.1, epsilon=0.1, gamma=1.0):
    """Draw the learning curves of the four depths, and of one more n."""
    settings = {"learning_rate": alpha, "epsilon": epsilon, "discount": gamma, "total_days": total_days}
    own = {} if n in methods.BY_DEPTH else {methods.label(n): methods.maker(n, **settings)}
    results = methods.compare(
        depths=methods.BY_DEPTH,
        own=own,
        sigma=sigma,
        n_actions=n_actions,
        n_steps=1_000 * total_days,
        repetitions=10,
        **settings,
    )
    title = f"σ = {sigma:g}, N = {n_actions}, H = {total_days}, α = {alpha:g}, ε = {epsilon:g}, γ = {gamma:g}"
    return Sheet("one study", [[figures.curves(results, title, epsilon)]])


sliders(
    one_study,
    sigma=(0.0, 2.0, 0.1),
    n_actions=(3, 12),
    total_days=(5, 20),
    n=(1, 20),
    alpha=(0.01, 1.0, 0.01),
    epsilon=(0.0, 1.0, 0.05),
    gamma=(0.8, 1.0, 0.01),
)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** With 150 repetitions, since 10 show only the large differences:
#
# - **total_days.** With 20 days instead of 10 $n = 1$ loses most, perhaps because its staircase has more steps. Its
#   mean return in these 1 000 episodes falls from 2.9 to 0.0, and that of Monte Carlo from 4.3 to 3.7.
# - **epsilon.** With 0.5 instead of 0.1 the mean return of $n = 1$ falls to 1.2, and that of Monte Carlo rises to 5.4.
# - **alpha.** With 0.01 Monte Carlo passes in 98 % of the runs, and $n = 1$ in 17 %. With 0.5 it is 85 % and 93 %.
# - $n = 1$ is the best by far with many actions and a large learning rate: with ten actions and $\alpha = 0.5$ it passes in
#   71 % of the runs, $n = 3$ in 37 %, and Monte Carlo in 9 %.
# </details>

# %% [markdown]
# ## See inside: bias and variance of the target
#
# A target is a random number. Its *bias* is how far its mean is from the true value $q_\pi$ of the policy $\pi$ that
# acts. Its *variance* says how much it scatters around its mean. The model gives both exactly. We take the target of
# the first day, for the best ε-soft policy, on the layout with number 0.
#
# ### Bias: early it is large, late it is zero

# %%
Sheet("bias", [[figures.bias_series()]])

# %% [markdown]
# - *Early*, while all values are 0, every target that bootstraps misses the exam: for this good policy it is 8 to 9 too low. Only $n = 10$,
#   Monte Carlo, sees the exam.
# - *Late*, once the values are true, bootstrapping adds exactly what it leaves out, so every $n$ has the right mean.
#
# So late only the variance is left of these two.
#
# ### Variance: where does it come from?
# A deep target is a sum of many random rewards. The noise of each adds $\sigma^2$ to the variance, so $n$ of them add
# $n \sigma^2$. "Larger $n$ means more noise from the environment", one often reads.
#
# **Predict.** At $\sigma = 0.2$, how much of the variance of the Monte Carlo target comes from the noise of the
# rewards?

# %%
noise = predict("The share of reward noise in the variance of the Monte Carlo target at σ = 0.2:", unit="%")
noise

# %%
display(figures.variance_sheet(sigmas=(0.2, 1.0)))
for sigma in (0.05, 0.2, 1.0):
    print(
        f"σ = {sigma:4g}: {targets.noise_share(sigma):6.1%} of the variance of the Monte Carlo target is reward noise"
    )
noise.measured(100 * targets.noise_share(0.2))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** 4 %. At the default of the environment, $\sigma = 0.05$, it is 0.3 %. All the rest comes from *the
# agent's own exploration*. With $\varepsilon = 0.1$ two of three episodes contain at least one random action
# ($1 - 0.9^{10} = 0.65$), and some of these miss the exam, which costs 10. That goes into the
# target of the first day, although the first day is not to blame. Only at $\sigma = 1$ is half of the variance noise of
# the rewards.
# </details>

# %% [markdown]
# Where rewards are not very noisy, *the agent makes most of the noise itself:* a deep target hands back its own random
# actions. A target with $n < 10$ rewards contains the actions $A_0$ to $A_n$; the last one enters through $Q(S_n, A_n)$.
# The exam is $A_9$, so only the last two targets contain it. A random action there costs 10: their bars are so high.
#
# With the learning rate of the experiment a Monte Carlo value of the first day scatters by ± 0.69 (computed in the
# aside), while on a free day two actions of this layout differ by 0.1 on average. That seems to be one reason why Monte Carlo passes the exam and wastes its free
# days, even without noise of the rewards. It is not the only one: with $\varepsilon = 0$ and $\sigma = 0$ nothing scatters, and Monte Carlo wastes them too (see the aside).

# %% [markdown] tags=["aside"]
# ### Aside: is this scatter the reason?
# Take it away, and let Monte Carlo learn a step only if all later actions were greedy: at $\sigma = 0$ the policies that pass then end 0.34 below the optimum, and not 0.64 (one-step SARSA: 0.28; 200 runs). So it seems to be *a* reason.
#
# But with $\varepsilon = 0$ and $\sigma = 0$ nothing scatters, and still Monte Carlo ends 0.73 below, $n = 5$ 0.63, $n = 3$ 0.45 and $n = 1$ 0.13. Our guess: one-step targets hand on
# the 0 of what was never tried, so $n = 1$ tries other things on its free days, and deep targets do not.

# %% [markdown] tags=["aside"]
# ### Aside: how much a value scatters
# (In the figure above, the smaller rises at $n = 2$, 4 and 5 come from the lectures, which are on the days 2, 4 and 5 of
# this layout: a random action may miss one.)
#
# With a constant $\alpha$ a value never comes to rest. Let $v$ be the variance of its
# targets, and $x$ the variance of the value itself after many updates. One more update,
# $Q \leftarrow (1 - \alpha) Q + \alpha G$, must leave $x$ as it is. If the policy stays and each target is independent
# of those before, as with Monte Carlo, this means
#
# $$
# x = (1 - \alpha)^2 x + \alpha^2 v \quad\Rightarrow\quad x = \frac{\alpha}{2 - \alpha}\, v .
# $$

# %%
for n in (1, 3, 5, 10):
    v = sum(part[n - 1] for part in figures.split(sigma=0.2).values())
    print(
        f"n = {n:2}: the value of the first day scatters by {'at least ' if n < 10 else ''}±"
        f" {math.sqrt(0.1 / (2 - 0.1) * v):.2f} (σ = 0.2, α = 0.1)"
    )
print("from one action to the next, by their prices:", np.diff(np.sort(-make_mdp("Study").action_rewards)).round(2))

# %% [markdown]
# The last line compares this with the task, action by action in the order of their prices. (On all days before the exam the value scatters hardly less: most of it comes from the
# exam. For smaller $n$ the numbers are lower bounds: the values from which these targets bootstrap scatter too.
# Simulated with the best policy held, from its true values on, the values scatter by 0.18, 0.31, 0.45 and 0.69, and the *difference*
# between the best action and another one by 0.2 with $n = 1$ and by about 1 with Monte Carlo.)

# %% [markdown]
# ### Each depth has its own learning rate
# A value scatters less with a smaller $\alpha$, since it averages more targets. But then the staircase, which takes
# $\lceil H/n \rceil / \alpha$ episodes, is longer.
#
# **Predict.** With which $n$ is the best learning rate for the first 500 episodes the *smallest*?

# %%
smallest = predict("The smallest best learning rate is that of ...", ["n = 1", "n = 3", "n = 5", "Monte Carlo"])
smallest

# %%
by_rate = figures.through_rates(repetitions=40, count_passes=True)
display(Sheet("rates", [[figures.rate_series(by_rate)]]))
best = figures.best_rates(by_rate)
print("best learning rate:", {methods.label(n): rate for n, rate in best.items()})
smallest.measured(methods.label(min(best, key=best.get)))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Monte Carlo. Of these six rates, the three smallest are best for Monte Carlo (with little between them),
# 0.1 for $n = 5$, and 0.3 for $n = 3$ and $n = 1$. One-step targets probably need a large rate to get down the staircase
# in time. Monte Carlo explores more with a small one (see “why a small rate suits Monte Carlo”).
#
# In Sutton and Barto's figure 7.2, for another task, a middle $n$ is best. *Never compare two values of $n$ at one
# learning rate only.*
# </details>

# %% [markdown]
# With a small rate Monte Carlo keeps its early lead over $n = 1$. In the details $n = 1$ stays ahead, at the same small rate too (see “each depth with its best
# learning rate”).

# %% [markdown] tags=["aside"]
# ### Aside: why a small rate suits Monte Carlo
# "Its targets vary most, so it must average most of them", one would say. So take its runs apart: how many have met the
# exam in these 500 episodes, and what do these runs return while they learn?

# %%
for rate, results in by_rate.items():
    met, returns = methods.met_exam(results, "Monte Carlo") == 1, results.average("Monte Carlo")
    print(f"α = {rate:5}: has passed in {met.mean():4.0%} of runs, which return {returns[met].mean():4.1f} in the mean")

# %% [markdown]
# Up to the rate 0.3 the runs that meet the exam do about equally well. And with all noise taken away ($\varepsilon = 0$, $\sigma = 0$)
# still 97 % of the runs meet it with 0.01, and a quarter with 0.3 (200 runs). So the variance of targets is not the reason. The rate decides *how many* runs meet the exam. With a small one
# each bad return lowers a value only a little, so that the action that was tried least looks best, and the agent takes
# one after another: it explores. With a large one the last return decides. With start values of −5 untried
# actions look bad, and this advantage is gone: then Monte Carlo does better with 0.3 than with 0.01 (over 80 runs). Only at the
# rate 1, which keeps nothing but the last target, do most runs that met the exam lose it again.

# %% [markdown] tags=["aside"]
# ### Aside: each depth with its best learning rate
# Here is the main figure once more, at $\sigma = 0.2$, with the best of these rates for each $n$.

# %%
own = {methods.label(n): methods.maker(n, learning_rate=rate) for n, rate in best.items()}
tuned = methods.compare(depths=(), own=own, repetitions=60, points=32)
display(Sheet("tuned", [[figures.curves(tuned, "σ = 0.2, each with its best learning rate")]]))
for method in tuned.methods:
    print(f"{method:12} passes in {methods.passes(tuned, method).mean():4.0%} of runs")
gap = experiments.difference_where_both_pass(tuned, "Monte Carlo", "n = 1")
print(f"where both pass, Monte Carlo less n = 1: {gap.estimate:+.2f} (95 %: {gap.low:+.2f} to {gap.high:+.2f})")

# %% [markdown]
# Monte Carlo passes in all runs. But where both pass, $n = 1$ is still
# better in the details. Does that contradict $\alpha / (2 - \alpha)$, by which a small rate averages the noise away? No: with a small rate the details take time. Here is Monte
# Carlo without any noise of the rewards, after 4 000 episodes and after ten times as many: how far below the optimum
# are the policies that pass? (We take the rate 0.01, since 0.003 takes longer still.)

# %%
for episodes in (4_000, 40_000):
    own = {f"Monte Carlo, α = {rate}": methods.maker(math.inf, learning_rate=rate) for rate in (0.1, 0.01)}
    own |= {f"n = 1, α = {rate}": methods.maker(1, learning_rate=rate) for rate in (0.1, 0.01)}
    longer = methods.compare(depths=(), own=own, sigma=0.0, n_steps=10 * episodes, repetitions=40)
    for method in longer.methods:
        short, share = methods.shortfall(longer, method), methods.passes(longer, method).mean()
        print(f"{episodes:6} episodes, {method:21}: {share:4.0%} pass, {short:.2f} below the optimum")

# %% [markdown]
# With $\alpha = 0.1$ and ten times the training, more runs of Monte Carlo pass, but these are hardly closer to the
# optimum. With $\alpha = 0.01$ the longer training pays: Monte Carlo comes much closer to the optimum. But with this rate $n = 1$ stays closer still, in fewer runs.

# %% [markdown] tags=["aside"]
# ### Aside: all depths at once
# Why choose one $n$? The *λ-return* averages the targets of all depths. A deeper target counts less than the one before
# it, by the factor $\lambda$:
#
# $$G_t^\lambda = (1 - \lambda) \sum_{n=1}^{H-t-1} \lambda^{n-1} G_{t:t+n} + \lambda^{H-t-1} G_t .$$
#
# The last term is the return, which stands for all depths beyond the end of the episode. These are the weights of the
# ten targets of the first day:

# %%
for trace_decay in (0.0, 0.5, 0.8, 1.0):
    print(f"λ = {trace_decay:<3g}", *(f"{share:5.2f}" for share in traces.weights(trace_decay, days=10)))

# %% [markdown]
# So $\lambda = 0$ is $n = 1$, and $\lambda = 1$ is Monte Carlo. *SARSA(λ)* learns by this target, and it need not wait
# for the end of the episode. Every pair of a state and an action has an *eligibility trace*. It is set to 1 when the
# pair is visited, and shrinks by the factor $\gamma \lambda$ with each step. Each one-step error moves *all* pairs, each
# as far as its trace says. (In Study no state comes twice in an episode, so the sum of these moves is exactly one step
# towards the λ-return. Where states come back, their values change on the way, and it is only nearly so.)
#
# **Predict.** Over the first 500 episodes, averaged over the learning rates 0.03, 0.1 and 0.3: which has the highest
# return?

# %%
all_at_once = predict("The highest return has ...", ["n = 1", "n = 3", "n = 5", "Monte Carlo", "λ = 0.8"])
all_at_once

# %%
traced = traces.through_rates(repetitions=80, count_passes=True)
display(Sheet("traces", [[figures.rate_series(traced)]]))
returns = {method: float(traces.over_rates(traced, method).mean()) for method in traced[0.1].methods}
print(", ".join(f"{method}: {value:.1f}" for method, value in returns.items()))
for method in ("n = 3", "Monte Carlo", "λ = 0.8"):
    met, passed = (
        np.concatenate([ask(results, method) for results in traced.values()])
        for ask in (methods.met_exam, methods.passes)
    )
    print(f"{method:12} has passed in {met.mean():4.0%} of runs; of these {passed[met == 1].mean():4.0%} pass now")
highest = max(returns, key=returns.get)
all_at_once.measured(highest)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** λ = 0.8. The line of $\lambda = 0$ lies exactly on that of $n = 1$, and the line of $\lambda = 1$ on
# that of Monte Carlo, but for ties that rounding breaks. With a single rate some $n$ may do as well as $\lambda = 0.8$.
# But $n = 1$ and $n = 3$ need a large rate and Monte Carlo a small one, $n = 5$ is steady but lower, and
# $\lambda = 0.8$ does well with all three rates. The runs, taken apart, show that it has some of both: it meets the exam about as
# often as $n = 3$, and where it has met it, it passes in the end, as Monte Carlo does. With the noisier rewards of
# $\sigma = 1$ its lead over Monte Carlo is smaller.
# </details>
#
# Here $\lambda$ is a slider beside $n$:


# %%
def depth_or_traces(n=3, trace_decay=0.8, alpha=0.1, sigma=0.2, n_actions=5):
    """Draw the learning curves of n-step SARSA with one n and of SARSA(λ) with one λ."""
    own = {
        methods.label(n): methods.maker(n, learning_rate=alpha),
        traces.trace_label(trace_decay): traces.tracer(trace_decay, learning_rate=alpha),
    }
    how = {"sigma": sigma, "n_actions": n_actions, "n_steps": methods.SHORT, "repetitions": 20}
    results = methods.compare(depths=(), own=own, **how)
    return Sheet("depth or traces", [[figures.curves(results, f"α = {alpha:g}, σ = {sigma:g}, N = {n_actions}")]])


sliders(
    depth_or_traces,
    n=(1, 10),
    trace_decay=(0.0, 1.0, 0.05),
    alpha=(0.01, 1.0, 0.01),
    sigma=(0.0, 2.0, 0.1),
    n_actions=(3, 12),
)

# %% [markdown]
# ### Why not look deep with Q-learning?
# Where rewards are not very noisy, most of the variance comes from exploring actions. Q-learning learns about the greedy policy, which never explores. So why not
# take $n$ rewards and then the largest value, $\max_a Q(S_{t+n}, a)$?
#
# For $n = 1$ that *is* Q-learning (equation 6.8). For $n > 1$ the rewards on the way were earned by the policy that
# acted, with its random actions, and not by the greedy one. The next figure shows what that does to the target of the
# first day, when all values are already the optimal ones $q_*$, rewards have no noise, and the first action is the
# best.

# %%
off_policy.off_policy_sheet()

# %% [markdown]
# The *uncorrected* target has a bias: with $n = 10$ its mean is 1.2 below the optimum. There are two remedies.
#
# - **Importance sampling**, in its simplest form, weights each target by a ratio that makes its mean right again. The price is a standard
#   deviation that at $n = 10$ is even larger than the optimum itself (exercise 2). In the left panel its line lies on that
#   of cutting, at 0.
# - **Cutting** the target at the first exploring action, with the best value of that state at its end, keeps the mean
#   right and adds no variance here, where the values are right (exercise 3).

# %% [markdown]
# ## Predict, then check
#
# **Predict.** Two of the five actions have no effect. Let us add five more such actions, so that $N = 10$, at
# $\sigma = 0.2$ and $\alpha = 0.1$. Who loses most?

# %%
suffers = predict(
    "With ten actions, the largest loss of final return has ...", ["n = 1", "n = 3", "n = 5", "Monte Carlo"]
)
suffers

# %%
many = methods.compare(depths=methods.BY_DEPTH, n_actions=10, repetitions=60, points=32, count_passes=True)
display(Sheet("ten_actions", [[figures.curves(many, "ten actions, σ = 0.2")]]))
loss = {}
for method in many.methods:
    few_end, many_end = (methods.expected_returns(results, method).mean() for results in (by_sigma[0.2], many))
    loss[method] = few_end - many_end
    print(f"{method:12} {few_end:5.2f} with five actions, {many_end:5.2f} with ten")
suffers.measured(max(loss, key=loss.get))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Monte Carlo and $n = 5$ lose most, and $n = 1$ least. As the paper says, actions without effect make deep methods
# suffer, at this $\alpha$. But Monte Carlo does not lose the exam: in four runs of five it *never found it*. (The first
# aside below takes the runs apart.)
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: is that the variance again?
# If variance were the reason, Monte Carlo would pass the exam now and then in training, and lose it again. So we ask two
# questions. In which share of the runs did the agent pass *at least once* in training? And how many of those runs pass in
# the end?
#
# **Predict.** Of the runs of Monte Carlo that passed at least once, how many pass in the end?

# %%
kept = predict("Of the Monte Carlo runs that ever passed, this share passes in the end:", unit="%")
kept

# %%
for method in many.methods:
    met, passed = methods.met_exam(many, method), methods.passes(many, method)
    print(
        f"{method:12} has passed in {met.mean():4.0%} of runs; of these {passed[met == 1].mean():4.0%} pass now", end=""
    )
    few = methods.passes_in_training(many, method)[(met == 1) & (passed == 0)]
    print(f" (passes of a typical run that does not: {np.median(few):.0f})" if len(few) else "")
kept.measured(100 * passed[met == 1].mean())  # of the last method, Monte Carlo

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** All of them (in other draws nearly all). From these start values Monte Carlo keeps what it found. The others lose some. A run that lost the
# exam had often passed it only once or twice (in brackets the median), and one pass moves the values of $n$ days only.
# (For $n = 1$ that is not the whole story: in other draws many such runs had passed it often.)
#
# Why does one-step SARSA meet the exam in more runs? All values start at 0, and every action has a price, so what was
# not tried looks better. Our guess: one-step SARSA hands the 0 of an untried action back, too, so states from which untried actions are left look good, and it goes there (optimistic values, Sutton and
# Barto, section 2.6). Monte Carlo learns only from returns that it got, and those were all bad. (The next aside tests a part of this.)
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: a test of this guess
# If it is right, one-step SARSA needs untried actions that look good. So we take these away. In
# the task with five actions, where all methods passed often, we let all values start at −5: now untried actions look
# *bad*.
#
# **Predict.** Who passes in more runs now? And is that because it meets the exam more often, or because it keeps it?

# %%
wary = predict(
    "With start values of −5, compared with n = 1, Monte Carlo ...",
    ["meets the exam more often", "meets it about as often, and keeps it more often", "passes in fewer runs"],
)
wary

# %%
pessimists = methods.compare(depths=methods.BY_DEPTH, initial_value=-5.0, repetitions=60, points=32, count_passes=True)
shares = {}
for start, runs in ((0, by_sigma[0.2]), (-5, pessimists)):
    for method in runs.methods:
        met, passed = methods.met_exam(runs, method), methods.passes(runs, method)
        shares[start, method] = met.mean(), passed[met == 1].mean(), passed.mean()
        print(f"start values {start:2}: {method:12} has passed in {met.mean():4.0%} of runs;", end=" ")
        print(f"of these {passed[met == 1].mean():4.0%} pass now")
(one_met, _, one_passes), (deep_met, _, deep_passes) = shares[-5, "n = 1"], shares[-5, "Monte Carlo"]
more = "meets it about as often, and keeps it more often"
if deep_passes < one_passes:
    more = "passes in fewer runs"
elif deep_met - one_met > 0.2:
    more = "meets the exam more often"
wary.measured(more)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** It meets the exam about as often, and keeps it more often. Without untried
# actions that look good $n = 1$ meets the exam in less than half of the runs, instead of in nearly all. So it needs
# them, as the guess says. But Monte Carlo, too, now meets it in about half: with start values of 0 it also tried what was untried in the
# states that it visited. That $n = 1$ gains more from them with ten actions, because it hands them *back*, is still our guess.
#
# But optimism does not explain who is ahead *here*, from −5. Monte Carlo meets the exam a little more often (in 52 % and 41 % of 400 runs). Most of the difference comes after
# that: Monte Carlo hands a pass to all days at once. Our guess: with $n = 1$ it goes back one day at a time, through values that
# start far too low.
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: the same agents play Blackjack
# **Predict.** The same agents learn in any Gymnasium environment with whole numbers for observations and actions.
# Blackjack is the classic example of Monte Carlo methods (Sutton and Barto, section 5.1). The reward, 1, 0 or −1, comes
# at the end of the game. How much does $n$ matter there?

# %%
cards = predict(
    "In Blackjack, the mean return in training:", ["Monte Carlo is ahead", "no difference above 0.05", "n = 1 is ahead"]
)
cards

# %%
most_steps = 30  # more than any game has; in Blackjack, `total_days` stands for the longest game
agents = {methods.label(n): methods.maker(n, learning_rate=0.02, total_days=most_steps) for n in (1, math.inf)}
blackjack = repeat(gym.make("Blackjack-v1"), agents, 10_000, repetitions=3)
for method in agents:
    print(f"{method:12} mean return of all games {blackjack.average(method, 'training_return').mean():.3f}")
games = blackjack.curves("Monte Carlo", "episodes").sum().mean()
print(f"a game takes {10_000 / games:.2f} actions on average")
gap = blackjack.difference("Monte Carlo", "n = 1", "training_return", over="training")
print(f"Monte Carlo less n = 1: {gap.estimate:+.3f} (95 %: {gap.low:+.3f} to {gap.high:+.3f})")
lead = gap.estimate
cards.measured(
    "no difference above 0.05" if abs(lead) < 0.05 else "Monte Carlo is ahead" if lead > 0 else "n = 1 is ahead"
)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Hardly at all. These three runs cannot tell the difference from 0; with 20 runs $n = 1$ is ahead, by 0.02
# (95 %: 0.01 to 0.03). A game takes 1.4 actions on average, so that most one-step targets *are* the return: the staircase
# has one step. And the cards are drawn at random, whatever $n$ is. Depth matters where the way from an action to its
# reward is long.
# </details>

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for your answer, and below it a cell that checks it. The check does not only say whether an
# answer is right: it says what was expected, what came, and which mistake that looks like. It runs your code on cases
# that it makes up.

# %%
from edugym_course.grading import check
from edugym_course.lessons.depth.exercises import CHALLENGE, exercise_1, exercise_2, exercise_3

# %% [markdown]
# ### Exercise 1: Monte Carlo without exploration
# Nearly all the variance of Monte Carlo (here $\sigma = 0.2$) comes from its own exploration. So switch it off. Write the function that makes
# a Monte Carlo agent with $\varepsilon = 0$, and otherwise with the settings of the experiment: $\alpha = 0.1$,
# $\gamma = 1$, all values 0 at first. Before you run the check: will it pass the exam in more runs than the Monte Carlo agent of the experiment, or in fewer?
#
# <details><summary>Hint</summary>One call of <code>NStepSARSA.create</code> is enough. Its settings are <code>n</code>,
# <code>learning_rate</code>, <code>discount</code> and <code>exploration</code>. Infinity is <code>math.inf</code>, and
# <code>EpsilonGreedy(0.0)</code> never explores.</details>


# %%
def quiet(study):
    """Make a Monte Carlo agent that never explores."""
    ### BEGIN SOLUTION
    return NStepSARSA.create(study, n=math.inf, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))
    # own: return NStepSARSA.create(study, n=math.inf, learning_rate={rate}, discount=1.0, exploration=EpsilonGreedy(0.0))
    ### END SOLUTION


# %% tags=["check"]
check(exercise_1, quiet)
### BEGIN HIDDEN TESTS
check(exercise_1, quiet, seed=1, quiet=True)
### END HIDDEN TESTS
display(figures.race({"quiet": quiet}, repetitions=30))

# %% [markdown]
# At this learning rate it passes in about 70 % of the runs, and with $\varepsilon = 0.1$ in about 90 % (200 runs). On many layouts it never passes. Where it passes, it is no closer to the optimum. With $\alpha = 0.01$ it passes in some 97 %: each bad return then lowers
# a value only a little, so it takes one action after another. Better: explore, and do not learn from exploring actions as if they were
# its policy.
#
# ### Exercise 2: the importance-sampling ratio
# An agent acts by a policy $b$ and wants to learn about another policy $\pi$. The return after $(S_t, A_t)$ was earned
# by $b$. To make it count for $\pi$, we multiply it by a ratio: how much more likely $\pi$ takes the *later* actions
# than $b$ does (Sutton and Barto, equation 7.10). Let $A_{T-1}$ be the last action of the episode. The ratio is
#
# $$
# \rho = \prod_{k=t+1}^{T-1} \frac{\pi(A_k \mid S_k)}{b(A_k \mid S_k)}
# $$
#
# The action $A_t$ is not in the product: we learn *its* value, whoever chose it. Here $\pi$ is greedy, $b$ is ε-greedy,
# there are $N$ actions, and one of them is the best in each state. Write the function. Its argument `greedy` is a list
# that says for each of the actions $A_t, A_{t+1}, \dots, A_{T-1}$ whether it was the best one, `True` or `False`. Its
# first entry is that of $A_t$, which is not in the product.
#
# <details><summary>Hint</summary>A random action is the best one with probability 1/N. So an ε-greedy policy takes the
# best action with probability 1 − ε + ε/N. What is the ratio for an action that the greedy policy never
# takes?</details>


# %%
def importance_ratio(greedy: list[bool], epsilon: float, n_actions: int) -> float:
    """Return how much more likely the greedy policy takes the later actions than the ε-greedy one."""
    ### BEGIN SOLUTION
    ratio = 1.0
    for is_greedy in greedy[1:]:
        ratio *= 1 / (1 - epsilon + epsilon / n_actions) if is_greedy else 0.0
        # own: ratio *= min(1 / (1 - epsilon + epsilon / n_actions), {most}) if is_greedy else 0.0
    return ratio
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_2, importance_ratio)
### BEGIN HIDDEN TESTS
check(exercise_2, importance_ratio, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# After the first day there are nine more actions. With $\varepsilon = 0.1$ and $N = 5$ all nine are greedy in
# $0.92^9 = 47$ % of the episodes. These count 2.1 times, and the other 53 % count nothing. The mean is right, and the
# variance is huge.
#
# ### Exercise 3: pass the reward back through greedy actions
# There is a better way. Let the reward travel back through greedy actions, and no further. What came after an exploring
# action is not what the greedy policy would have got. So *cut* there, and go on with the best value of that state.
#
# The agent below stores its episode and learns at the end. Complete `hand_back`. It goes backwards through the steps
# $k = T-1, \dots, 1, 0$ of the episode. After the end there is no future, so $G$ starts at 0. At each step:
#
# $$
# \begin{aligned}
# G &\leftarrow R_{k+1} + \gamma\, G \\
# Q(S_k, A_k) &\leftarrow Q(S_k, A_k) + \alpha \left[ G - Q(S_k, A_k) \right] \\
# G &\leftarrow \max_a Q(S_k, a) \quad \text{if } Q(S_k, A_k) < \max_a Q(S_k, a), \text{ after the update}
# \end{aligned}
# $$
#
# An action is greedy if no other has a *higher* value. Where several tie, all of them are, and not only the first, which
# `argmax` finds.
#
# Without the third line this is Monte Carlo. With it, $G$ passes through actions that are greedy *after* their update, and is cut at the others. You
# write plain Python, and it runs as machine code. Predict: can this line beat all four depths at this $\alpha$?
#
# <details><summary>Hint</summary><code>for k in range(length - 1, -1, -1)</code> goes backwards. The largest value in a
# row is <code>max(self.Q[s])</code>. The fields <code>self.learning_rate</code> and <code>self.discount</code> are α
# and γ.</details>


# %%
class MyAgent(NamedTuple):
    """Learns at the end of an episode, as deep as its actions were greedy."""

    Q: np.ndarray  # shape (n_states, n_actions)
    states: np.ndarray  # shape (longest,): the state of each step of this episode
    actions: np.ndarray  # shape (longest,): the action
    rewards: np.ndarray  # shape (longest,): the reward after it
    length: np.ndarray  # shape (1,): how many steps this episode has so far
    learning_rate: float = 0.1
    discount: float = 1.0
    exploration: EpsilonGreedy = EpsilonGreedy(0.1)

    @classmethod
    def create(cls, study, longest=100):
        """Make a new agent for a task."""
        n_states, n_actions = int(np.prod(study.observation_space.nvec)), int(study.action_space.n)
        steps = np.zeros(longest, np.int64), np.zeros(longest, np.int64), np.zeros(longest)
        return cls(np.zeros((n_states, n_actions)), *steps, np.zeros(1, np.int64))

    def act(self, state, rng):
        """Explore ε-greedily."""
        return self.exploration.choose(self.Q, state, rng)

    def greedy(self, state, rng):
        """The best action, for evaluation."""
        return EpsilonGreedy(0.0).choose(self.Q, state, rng)

    def learn(self, state, action, reward, next_state, terminated):
        """Store the step; at the end of the episode, hand the rewards back and begin anew."""
        k = self.length[0]
        self.states[k], self.actions[k], self.rewards[k] = state, action, reward
        self.length[0] = k + 1
        if terminated:
            self.hand_back(k + 1)
            self.length[0] = 0

    def hand_back(self, length):
        """Learn from an episode of so many steps, from its last step to its first."""
        ### BEGIN SOLUTION
        G = 0.0
        for k in range(length - 1, -1, -1):
            s, a = self.states[k], self.actions[k]
            G = self.rewards[k] + self.discount * G
            # own: G = self.rewards[k] - {cost} + self.discount * G
            self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
            best = max(self.Q[s])
            if self.Q[s, a] < best:
                G = best
        ### END SOLUTION


# %% tags=["check"] points=3
check(exercise_3, MyAgent)
### BEGIN HIDDEN TESTS
check(exercise_3, MyAgent, seed=1, quiet=True)
### END HIDDEN TESTS
race = figures.race({"my agent": MyAgent.create}, repetitions=40)
display(race)
for panel in race.rows[0]:
    for method in panel.results.methods:
        passing, below = methods.passes(panel.results, method).mean(), methods.shortfall(panel.results, method)
        print(f"{panel.title:10}  {method:12} passes in {passing:4.0%} of runs, there {below:.2f} below the optimum")

# %% [markdown]
# With five actions it is early about as fast as Monte Carlo, probably since its rewards, too, pass through many actions
# at once. In the end its mean is above all others, in both panels. With five actions it is *precise*: where it passes, it ends 0.1 to 0.2 below the optimum, and the others 0.3 to 0.8 at this $\alpha$. A guess: exploring actions do not blur its
# targets. With ten actions it also *passes* in far more runs than the deep methods, and at this noise in no fewer than $n = 1$.
# This comes from the cuts at actions that were greedy when taken and are not after their update: if you ask whether the action was the best one *when it was taken*, only exploring actions are cut,
# and it passes in 15 to 20 % of the runs, not in 70 to 80 % (draws of 60). A guess: at the other cuts it hands back what untried actions are worth, as one-step targets do.
#
# The idea is old. Watkins cut the targets of his Q(λ) at exploring actions in 1989. The **tree backup** algorithm
# (Sutton and Barto, section 7.5) does nearly the same for any policy; in the package it is `TreeBackup`.
#
# It has a limit. Your rule asks *after* the update, by value, whether an action is the best. With noisy rewards luck decides
# that too: a lucky return is handed on, and an unlucky one is replaced by the largest value. So values become too high. At $\sigma = 2$ the agent expected 1.2 more at the
# start than its policy gets, with $\alpha = 0.3$ about 2.5, and at $\sigma = 0.2$ only 0.06 (means of 80 runs). If it asks
# what was best *when it acted*, the 1.2 become about 0.3. This is called
# *maximisation bias* (Sutton and Barto, section 6.7). At $\sigma = 2$ it is no more precise than $n = 1$.
#
# ### The open challenge: 1 000 episodes with eight actions
# Eight actions, five of them useless, and 10 000 steps in all. In this challenge actions are free ($r_a = 0$ but for noise, $\sigma = 0.2$), so the
# optimum is 10 on every layout. Write an agent of your own. It is tried on ten layouts that belong to your name, and
# nobody else has the same ones. It is told only its observation space and its action space. It needs `act(state, rng)` and `learn`, which asks by name for what it needs, as in exercise 3. Its points are its average
# return (of evaluation episodes) over training, in percent of 10. For 100 points an agent would have to know the task before it starts; clearly
# more than the best of the three baselines is good, and 80 is very good.
#
# Everything is allowed that learns from its own steps. Half a page with it: how does your agent find the exam for the
# first time, how does it hand the reward back, and where would it fail?


# %%
def my_agent(study):
    """Make the agent for the challenge; put your own in its place."""
    return TreeBackup.create(study, n=10, learning_rate=0.2, discount=1.0, exploration=EpsilonGreedy(0.1))


CHALLENGE.score(my_agent, "Ada Lovelace")

# %% [markdown]
# ### From a blank file
# Now write it all yourself, from an empty cell, with NumPy and Gymnasium only: $n$-step SARSA with $n = 3$ and its
# loop, some 40 lines. You need no buffer of a fixed size: keep lists of the states, actions and rewards of the
# episode. After step $t$ the pair $S_\tau, A_\tau$ with $\tau = t - n + 1$ has its $n$ rewards. Draw $A_{t+1}$, the action that you take next: it is $A_{\tau+n}$, so
# the target is complete, and the pair learns. When the episode has ended (by `terminated` or by `truncated`), all pairs that are left learn from the rewards
# that there are, the oldest first. (Where it was only truncated, the last state has a value as well: after $k$ rewards
# you may add $\gamma^k$ times it, say that of an action drawn there.)
#
# **What it must do.** `my_program(environment, n_steps, seed)` takes `n_steps` steps in a Gymnasium environment, episode after
# episode, and learns from them. In the end it returns its *policy*: a function that takes a state and returns the
# action with the highest value. All else is up to you: functions, classes, any names.
#
# - States and actions are whole numbers from 0. `environment.observation_space.n` and `environment.action_space.n` say how
#   many there are. They differ from one environment to the next.
# - Take $n = 3$, $\alpha = 0.5$, $\gamma = 0.8$, $\varepsilon = 0.1$ and first values of 0.
# - Draw all random numbers from `np.random.default_rng(seed)`, and give the seed to the first `reset` alone.
#
# The check runs your program in small worlds of its own and in Study with eight days and numbered states
# (`TabularObservation(gym.make("edugym/Study-v0", total_days=8))`; the class is in `edugym`). It sees the
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
    """Learn by n-step SARSA for `n_steps` steps, and return the greedy policy."""
    n, alpha, gamma, epsilon = 3, 0.5, 0.8, 0.1
    rng = np.random.default_rng(seed)
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))

    def learn(tau):
        """Update the pair of step τ, from the definition of the n-step return."""
        G = sum(gamma**k * reward for k, reward in enumerate(rewards[tau : tau + n]))
        if tau + n < len(states):
            G += gamma**n * Q[states[tau + n], actions[tau + n]]
        Q[states[tau], actions[tau]] += alpha * (G - Q[states[tau], actions[tau]])

    steps, first = 0, True
    while steps < n_steps:
        state, _ = environment.reset(seed=seed if first else None)
        first, over = False, False
        states, actions, rewards = [state], [choose_action(Q[state], epsilon, rng)], []
        while not over and steps < n_steps:
            state, reward, terminated, truncated, _ = environment.step(actions[-1])
            rewards.append(reward)
            steps, over = steps + 1, terminated or truncated
            if not terminated:
                states.append(state)
                actions.append(choose_action(Q[state], epsilon, rng))
            if len(rewards) >= n:
                learn(len(rewards) - n)
        for tau in range(max(len(rewards) - n + 1, 0), len(rewards)):
            learn(tau)
    return lambda state: choose_action(Q[state], 0.0, rng)


### END PROGRAM

# %% tags=["project"]
from edugym_course.lessons.depth.project import project_3

check(project_3, my_program)

# %% [markdown]
# ## What you saw
#
# ### In one paragraph
# *Learn it by heart, or better, say it in your own words.* The number $n$ says how many real rewards a target contains
# before it trusts a learned value. With small $n$ a reward comes back step by step, through values that are wrong at
# first: slow and biased early, and with a small learning rate precise late. With large $n$ it comes back at once, together with everything else that
# happened, some of which the agent did itself when it explored: fast early, where the reward is soon met, and blurred late. A smaller learning rate
# slowly averages a part of the blur away. A target that is cut where an action is not the best one after its update seems to avoid it, unless rewards are very noisy.
#
# ### Limits
# The dynamics of this task are deterministic, an episode has ten steps, and the agent sees the whole state. Where the
# environment itself is random, cutting at exploring actions removes the agent's part of the variance only.
#
# ### Further reading
# - Moerland et al. (2023), *EduGym: An environment and notebook suite for reinforcement learning education*: the paper.
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 6.2–6.3 (why bootstrapping works), 7.1–7.3 ($n$-step
#   methods and importance sampling; figure 7.2), 7.5 (tree backup), 12.1 (all $n$ at once: λ).
# - Watkins (1989), *Learning from delayed rewards*: Q-learning, and cutting at exploring actions.
# - Precup, Sutton and Singh (2000), *Eligibility traces for off-policy policy evaluation*: tree backup and importance
#   sampling.
# - Kearns and Singh (2000), *Bias-variance error bounds for temporal difference updates*: early and late, proved.
# - Arjona-Medina et al. (2019), *RUDDER: Return decomposition for delayed rewards*: learning which step earned it.
