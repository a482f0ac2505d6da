# %% [markdown]
# # Bandits: what it costs to find the best arm
#
# **The challenge.** Ten slot machines, and one of them pays best. Only a pull shows how well a machine pays, and every pull of a worse
# one costs.
#
# **You will be able to** say what regret is, and compute it exactly; say what each of seven agents pays while it learns, and why; and
# write upper confidence bounds and the gradient bandit.
#
# **Time.** {time} **Before you start.** You need means, logarithms and the normal distribution, and a little Python. This goes with chapter 2 of Sutton and
# Barto, 2nd edition. All symbols are in the [table of
# notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).

# %%
import numpy as np

from edugym import (
    UCB,
    GradientBandit,
    SampleAverage,
    ThompsonSampling,
    action_gaps,
    finite_model,
    make_mdp,
    regret,
    train,
)
from edugym.envs.bandit import Bandit
from edugym_course.lessons.bandits import figures, methods
from edugym_course.notebook import play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: ten arms
#
# A slot machine is called a one-armed bandit, and a row of them a bandit with several arms. There is one situation, so there is nothing to see: an agent only decides which
# arm to pull.
#
# | | | in words |
# |---|---|---|
# | states | one | nothing changes from pull to pull: an agent always sees the state 0. In the code below `state` is the number of the best arm, which no agent sees |
# | actions | $a \in \{0, \dots, n - 1\}$ | the arm to pull; $n = 10$ |
# | reward | $R \in \{0, 1\}$ | the best arm pays 1 with probability $(1 + \Delta)/2$, every other one with $(1 - \Delta)/2$ |
# | gap | $\Delta = 0.2$ | so the best arm pays in 60 % of the pulls, and the others in 40 % |

# %%
source(Bandit, "payoff", "reward")

# %% [markdown]
# **Play it yourself.** Five arms, and the best one pays in 70 % of the pulls. Which one is it, and after how many pulls are you sure?

# %%
play(make_mdp("Bandit", n_arms=5, gap=0.4))

# %% [markdown]
# What counts is the *regret*: what you would have earned on average by pulling the best arm only, less what your arms pay on average. Every pull of a worse
# arm adds $\Delta$ to it. It follows from the arms alone, whatever they happened to pay, so luck with the rewards does not count, and it never falls.
# `action_gaps` and `regret` compute it from the exact model of the bandit, which has one state (its row is `[0]`); here the best arm is arm 8:

# %%
mdp = make_mdp("Bandit")
model = finite_model(mdp)
print("what one pull of each arm costs:", action_gaps(model)[0].round(2))
print("regret after each of ten pulls, of arm 0 to arm 9:", regret(model, range(10)).round(2))

# %% [markdown]
# ## The idea: a pull earns, and a pull teaches
#
# ### The mean of each arm
# The value $Q(a)$ of an arm is the mean of the rewards that it has brought. It needs no list of them. If arm $A$ was pulled, and paid $R$, with $N(A)$ the number of its pulls,
#
# $$
# N(A) \leftarrow N(A) + 1, \qquad
# Q(A) \leftarrow Q(A) + \frac{1}{N(A)} \left[ R - Q(A) \right]
# $$

# %%
source(SampleAverage, "learn")

# %% [markdown]
# The more pulls, the closer a mean comes to the truth. So why not simply take the arm with the largest mean? That is the *greedy* agent. All means are 0 at first, and ties are broken at random.
#
# **Predict.** In how many of a hundred runs does greedy end with the best of the ten arms?

# %%
finds = predict("Greedy ends with the best arm in ...", unit="% of the runs")
finds

# %%
settled = methods.pulls("greedy", methods.SHORT, repetitions=1000).settled().mean()
print(f"measured {settled:.1%} of 1000 runs, exact {methods.stuck():.1%}")
informed = methods.pulls(methods.tries_first(30)).settled().mean()
print(f"after 30 tries of each arm: {informed:.0%} of 100 runs")
finds.measured(100 * settled)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** 15 %; a blind choice finds a tenth. The first arm that pays has a mean above 0, for ever; the other means stay 0: those arms did not pay, or were never pulled, and nobody pulls them any more. So greedy stays with the first arm that pays. That is the best one with the probability $0.6 / (0.6 + 9 \cdot 0.4)$,
# or 1/7. If each arm was tried 30 times first, greedy finds the best one in 98 %.
# </details>

# %% [markdown]
# ### Six ways to go on looking
# - **ε-greedy**: with probability $\varepsilon$ pull a random arm, else the one with the largest mean.
# - **A falling ε**: the same with $\varepsilon_t = \min(1, 200/t)$ at pull $t$.
# - **Optimistic values**: be greedy, but begin with $Q(a) = 1$, as if every arm always paid, and learn with a constant rate $\alpha$. (With $1/N(A)$,
#   which is 1 at the first pull, nothing of the first value would be left.) Each arm must be tried several times before its value has come down to what it pays.
# - **Upper confidence bounds** (UCB): take the largest value that an arm may plausibly have. It is above the mean, the more so the fewer pulls the arm has had. At pull $t$, with a constant $c$ that says how much this counts:
#
# $$
# A = \arg\max_a \left[ Q(a) + c \sqrt{\frac{\ln t}{N(a)}} \right]
# $$
#
# An arm that was never pulled comes first.
#
# - **Thompson sampling**: draw a plausible value $\theta(a)$ of each arm, from a normal distribution around $Q(a)$ that gets narrower with $N(a)$, and take the largest. $\sigma$ is how much
#   the rewards of an arm spread; an arm that was never pulled comes first here too:
#
# $$
# \theta(a) \sim \mathcal{N}\left(Q(a), \frac{\sigma^2}{N(a)}\right), \qquad A = \arg\max_a \theta(a)
# $$
#
# - **The gradient bandit** has no values. It has preferences $H(a)$, which make probabilities $\pi(a) \propto e^{H(a)}$. A reward above the mean $m$ of all rewards before it makes the
#   arm likelier, and one below makes it rarer (the first pull changes nothing). $1\{a = A\}$ is 1 for the arm that was pulled, and 0 for the others:
#
# $$
# H(a) \leftarrow H(a) + \alpha \left( R - m \right) \left( 1\{a = A\} - \pi(a) \right) \quad \text{for all } a
# $$

# %%
source(UCB, "choose")

# %%
source(ThompsonSampling, "choose")

# %%
source(GradientBandit, "learn")

# %% [markdown]
# `baseline` is $m$, and `follow_log_gradient` adds `size` $\cdot\, (1\{a = A\} - \pi(a))$ to each $H(a)$.

# %% [markdown]
# ## The experiment: regret over time
#
# | setting | value |
# |---|---|
# | bandit | $n = 10$ arms, gap $\Delta = 0.2$ |
# | methods | $\varepsilon = 0.1$; UCB $c = 0.7$; Thompson sampling $\sigma = 0.5$; $\alpha = 0.1$ for optimistic values and the gradient bandit |
# | repetitions | 100, of 10 000 pulls, each with a best arm of its own; bands are 95 % intervals |
# | not in the figure | greedy, which pays far more; it is printed below |
# | "best arm in" | the share of runs in which it gets more than half of the last tenth of the pulls |
#
# How little regret is possible? Lai and Robbins proved that a strategy which is good on *every* bandit (its regret grows more slowly than any power of $t$) cannot do better, in the long run, than $C \ln t$ with
#
# $$
# C = \sum_{a\,:\,p_a < p_*} \frac{p_* - p_a}{p_a \ln \frac{p_a}{p_*} + (1 - p_a) \ln \frac{1 - p_a}{1 - p_*}}
# $$
#
# where arm $a$ pays with probability $p_a$, and the best one with $p_*$. That is the thin dashed line.
#
# **Predict.** After some thousand pulls ε-greedy knows the best arm. What does its regret do from then on?

# %%
later = predict(
    "From then on ε-greedy's regret ...",
    ["stops growing", "grows ever more slowly, as a logarithm does", "goes on growing evenly"],
)
later

# %%
found = {method: methods.pulls(method) for method in methods.IN_THE_FIGURE}
display(figures.regrets({method: one for method, one in found.items() if method != "greedy"}))
print("regret after                    1000      10 000 pulls")
for method, one in found.items():
    early, late = one.regret(1000).mean(), one.regret().mean()
    print(f"{method:25} {early:10.0f} {late:11.0f}   best arm in {one.settled().mean():.0%}")
half, whole = methods.N_PULLS // 2, methods.N_PULLS
first, second = (found["ε-greedy"].between(*pulls).mean() for pulls in ((0, half), (half, whole)))
print(
    f"a pull of ε-greedy costs {second:.3f} in the second half; ε Δ (n - 1)/n is {methods.slope(methods.EPSILON):.3f}"
)
print(f"with a falling ε it costs {found['falling ε'].between(half, whole).mean():.3f}")
bound, random = figures.constant_of() * np.log(100), 100 * methods.slope(1.0)
print(f"after 100 pulls C ln t is {bound:.0f}, and random pulls cost {random:.0f}")
later.measured(later.options[2 if second > 0.9 * methods.slope(methods.EPSILON) else 1 if second > 0.001 else 0])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** It goes on growing evenly: each pull of the second half costs 0.018. That is $\varepsilon \Delta (n - 1)/n$, the price of pulling a random arm in a share
# $\varepsilon$ of the pulls. Whoever goes on trying at the same rate goes on paying at the same rate. If $\varepsilon$ falls as $200/t$, a pull costs 0.005 instead; it pays more at first (98 against 67 after 1000 pulls), and less in the end (181 against 240).
# </details>

# %% [markdown]
# On the right, pulls are on a logarithmic axis: what becomes a straight line there, as $C \ln t$ is, grows as a logarithm. On the left one sees that UCB (160), Thompson sampling (108) and the gradient bandit (162) pay less and less for a pull.
# These three and the falling ε end *below* the bound, which is no contradiction: it speaks of the long run, and only of strategies that are good on every bandit. After 100 pulls $C \ln t$ is 102, and even random pulls cost only 18.
#
# Optimism tries all arms in the beginning, until its first values have come down. Its regret goes on growing after that. A third of it is paid by the 6 % of the runs that do not pull the best arm in the end. In the others the values, with a constant $\alpha$, never come to rest, so now and then a worse arm looks best.

# %% [markdown] tags=["aside"]
# ### Aside: a softmax of the means
# `Softmax` draws every arm with a probability that grows with its mean, $\pi(a) \propto e^{Q(a)/\tau}$ (Boltzmann exploration). The temperature $\tau$ says which differences count: much larger ones decide, much smaller ones hardly matter.

# %%
print("temperature   regret   a late pull costs   with the true means   best arm in")
for temperature in (0.02, 0.05, 0.1, 0.2):
    one = methods.pulls(methods.softmax_of_means(temperature))
    cost, known = one.between(half, whole).mean(), methods.softmax_slope(temperature)
    print(f"{temperature:11} {one.regret().mean():8.0f} {cost:19.3f} {known:21.3f} {one.settled().mean():13.0%}")

# %% [markdown]
# Cold ($\tau = 0.02$) it mostly stays with a worse arm, as greedy does, and with $\tau = 0.05$ it misses the best arm in some four of ten runs. Warm (0.1) it finds the means, and goes on paying for ever, as ε-greedy does: a late pull costs about what it would cost with the true means. (These, too, would give the best arm only 45 % of the pulls, and "best arm in" asks for more than half.) With each of these temperatures
# it pays more than ε-greedy (240). The formula asks how far two means differ, and not how well they are known. UCB and Thompson sampling ask both.

# %% [markdown]
# ## Your turn
#
# How many arms, which gap? And what if another arm becomes the best one now and then, with probability `drift` at each pull? (20 runs of 2000 pulls. The bound is drawn where nothing drifts.)


# %%
def one_setting(n_arms=10, gap=0.2, drift=0.0):
    """Draw the regret of four methods."""
    return figures.one_setting(n_arms, gap, drift)


sliders(one_setting, n_arms=[2, 5, 10, 20], gap=[0.1, 0.2, 0.5, 1.0], drift=[0.0, 0.001, 0.01])

# %% [markdown]
# <details><summary>What to look for</summary>
#
# In short runs UCB can still be behind ε-greedy. With a large gap the regret of UCB and of Thompson sampling soon
# rises slowly (UCB's in steps with a gap of 1, where it tests all worse arms again at about the same time), and ε-greedy's is a straight line once it knows the best arm. With drift, all curves go on rising: whoever has found the best arm must find the next one.
# </details>

# %% [markdown]
# ## See inside: who gets the pulls?
#
# "Fair" would be 1000 pulls for each arm. The agents are not fair. The worse arms are sorted in each run: 2 is the one that was pulled most, and 10 the one that was pulled least.
# The axis is logarithmic:

# %%
shown = {method: found[method] for method in ("ε-greedy", "UCB", "Thompson sampling")}
display(figures.by_arm(shown))
for method, one in shown.items():
    worse = one.by_rank()[:, 1:]
    share, least = worse.sum(axis=1).mean() / whole, worse[:, -1].mean()
    print(f"{method:18} gives the nine worse arms {share:.1%} of its pulls, and the last of them {least:.0f} pulls")

# %% [markdown]
# ε-greedy's random pulls go to all arms alike: even the worse arm that it pulls least gets 89. UCB gives it 39, and Thompson sampling 23. This is how UCB decides; one run, after 10 000 pulls:

# %%
agent = methods.agent_of("UCB", mdp)
train(mdp, agent, methods.N_PULLS, seed=1)
N, Q = agent.counts[0], agent.Q[0]
bonus = methods.BONUS * np.sqrt(np.log(1 + N.sum()) / N)
print("arm   pulls   mean   bonus   upper bound")
for arm in np.argsort(-N):
    print(f"{arm:3} {N[arm]:7} {Q[arm]:6.2f} {bonus[arm]:7.2f} {Q[arm] + bonus[arm]:10.2f}")

# %% [markdown]
# The means differ, and the upper bounds are nearly the same. An arm with a low mean has had few pulls, so its bonus is large. As soon as its bound is the highest, it gets a pull. If the pull pays nothing,
# the bound sinks; if it pays, the bound mostly rises, and the arm gets the next pull as well. As $t$ grows, the bounds of all other arms rise slowly, and every arm gets its turn again, ever more seldom.

# %% [markdown]
# ## Predict, then check
#
# ### Which gap costs most?
# The smaller the gap, the more pulls it takes to tell two arms apart: about $1/\Delta^2$. A gap of 0.01 is the hardest problem.
#
# **Predict.** At which of these gaps is the regret after 10 000 pulls largest?

# %%
dearest = predict("UCB pays most at a gap of ...", ["0.01", "0.05", "0.2", "1"])
dearest

# %%
by_gap = figures.measure_gaps()
display(figures.over_gaps(by_gap))
paid = {f"{gap:g}": one.mean() for gap, one in zip(figures.GAPS, by_gap["UCB"], strict=True)}
print(", ".join(f"Δ = {gap}: {cost:.0f}" for gap, cost in paid.items()))
print(f"random pulls at a gap of 0.01: {whole * methods.slope(1.0, gap=0.01):.0f}")
dearest.measured(max(dearest.options, key=paid.get))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** 0.05: UCB's regret first rises with the gap, and then falls. With a gap of 0.01 UCB cannot find the best arm in 10 000 pulls, but no pull costs more than 0.01: random pulls cost 90 in all, and UCB pays 86. With a large gap every mistake is dear, and
# seen at once. In between, mistakes are dear enough to hurt and small enough to hide.
# </details>

# %% [markdown]
# ### First try all, then choose?
# A fair test: pull each arm 100 times, together a tenth of all pulls. Then be greedy.
#
# **Predict.** Thompson sampling had a regret of 108. What is it for this fair test?

# %%
fair = predict("The regret of 100 tries each, and then the best, is ...")
fair

# %%
print("tries of each arm   gap 0.1   gap 0.2   gap 0.4")
for tries in (10, 30, 100, 300):
    paid = [methods.pulls(methods.tries_first(tries), gap=gap).regret().mean() for gap in (0.1, 0.2, 0.4)]
    print(f"{tries:17}" + "".join(f"{cost:10.0f}" for cost in paid))
paid = [methods.pulls("Thompson sampling", gap=gap).regret().mean() for gap in (0.1, 0.2, 0.4)]
print("Thompson sampling" + "".join(f"{cost:10.0f}" for cost in paid))
few = methods.pulls(methods.tries_first(10)).settled().mean()
print(f"with 10 tries of each arm, at a gap of 0.2, {1 - few:.0%} of the runs end with a worse arm")
fair.measured(methods.pulls(methods.tries_first(100)).regret().mean())

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** 180: nine worse arms, 100 pulls of each, 0.2 a pull. After that it makes hardly a mistake, but the test alone cost more than all that Thompson sampling paid. Ten tries are
# too few (332): 15 % of the runs end with a worse arm. Thirty would have been right here (97), but not for a gap of 0.1, where a hundred are better, and not for one of 0.4, where ten are. With the right number the fair
# test costs about as much as Thompson sampling, or less, at any of these gaps. But the right number depends on the gap, and nobody tells you the gap. Thompson sampling need not know it: each arm is tried the less, the less likely it is the best.
# </details>

# %% [markdown]
# ### What if the arms drift?
# Now another arm becomes the best one with probability 0.001 at each pull, so about ten times in a run. Two ε-greedy agents: one has sample averages, the other learns with a constant rate $\alpha = 0.1$,
# $Q(A) \leftarrow Q(A) + \alpha [R - Q(A)]$, so that old rewards fade.
#
# **Predict.** Which one has less regret?

# %%
follows = predict(
    "Less regret has ...", ["the sample average", "the constant rate", "neither: they differ by less than a tenth"]
)
follows

# %%
movers = ("ε-greedy", "ε-greedy, constant α", "UCB", "Thompson sampling", "UCB, bonus at first")
still, moving = ({method: methods.pulls(method, drift=drift) for method in movers} for drift in (0.0, 0.001))
display(figures.drifting(still, moving))
for method in movers:
    print(f"{method:21} no drift {still[method].regret().mean():5.0f}   drift {moving[method].regret().mean():5.0f}")
mean, constant = (moving[method].regret().mean() for method in movers[:2])
follows.measured(follows.options[2 if abs(mean / constant - 1) < 0.1 else 1 if constant < mean else 0])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** The constant rate: 905 against 1397. After thousands of pulls $1/N(A)$ is tiny, and the mean of an arm that was once the best hardly moves. The sample average forgets nothing,
# and here what it remembers is no longer true. Without drift it is the other way round, 240 against 730: a value that forgets never becomes exact. Each agent is right about
# one world. UCB does best here, though it has sample averages too. Without its bonus from pull 1000 on ("bonus at first") it pays 1465 where arms drift, and only 82 where they do not. Thompson sampling, which paid least of the seven agents above, is worse than the constant rate here.
# </details>

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for your answer, and below it a cell that checks it: it says what was expected, what came, and
# which mistake that looks like.

# %%
from edugym_course.grading import check
from edugym_course.lessons.bandits.exercises import exercise_1, exercise_2, exercise_3

# %% [markdown]
# ### Exercise 1: regret
# `p` is a list with the probability of each arm to pay 1, and `arms` is the list of the arms that were pulled. Return the regret of all these pulls together.
#
# <details><summary>Hint</summary>What does one pull of arm a cost? The best arm is that with the largest entry of <code>p</code>, whether
# it was pulled or not.</details>


# %%
def total_regret(p, arms):
    """Return what these pulls have cost on average."""
    ### BEGIN SOLUTION
    cost = 0.0
    # own: cost = {cost} * sum(arm != before for before, arm in zip(arms, arms[1:]))
    for arm in arms:
        cost += max(p) - p[arm]
    return cost
    ### END SOLUTION


# %% tags=["check"]
check(exercise_1, total_regret)
### BEGIN HIDDEN TESTS
check(exercise_1, total_regret, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 2: upper confidence bounds
# `Q` and `N` are arrays with the mean and the number of pulls of each arm. Return an array with the upper bound of each, $Q(a) + c \sqrt{\ln t / N(a)}$. The pull that is to be chosen counts too, so
# $t = 1 + \sum_a N(a)$. An arm that was never pulled has the bound `np.inf`, so that it comes first.
#
# <details><summary>Hint</summary>Begin with <code>np.full(len(Q), np.inf)</code>, and fill in the arms with N(a) &gt; 0.</details>


# %%
def upper_bounds(Q, N, c):
    """Return the upper confidence bound of each arm."""
    ### BEGIN SOLUTION
    t = 1 + sum(N)
    # own: t = 1 + sum(N) + {before}
    bounds = np.full(len(Q), np.inf)
    for arm in range(len(Q)):
        if N[arm] > 0:
            bounds[arm] = Q[arm] + c * np.sqrt(np.log(t) / N[arm])
    return bounds
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_2, upper_bounds)
### BEGIN HIDDEN TESTS
check(exercise_2, upper_bounds, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 3: the gradient bandit
# `H` is an array with the preferences, `arm` was pulled and paid `reward`, and `mean` is the mean reward so far, $m$. Change all preferences, in place, by the equation of the gradient bandit. Return nothing.
#
# <details><summary>Hint</summary>First compute all probabilities, before anything changes: <code>np.exp(H)</code>, divided by its sum. An array
# changes for everybody who holds it.</details>


# %%
def gradient_update(H, arm, reward, mean, learning_rate):
    """Learn from one pull by the gradient bandit."""
    ### BEGIN SOLUTION
    pi = np.exp(H) / np.exp(H).sum()
    step = learning_rate * (reward - mean)
    # own: step = learning_rate * (reward - {cost} - mean)
    H -= step * pi
    H[arm] += step
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_3, gradient_update)
### BEGIN HIDDEN TESTS
check(exercise_3, gradient_update, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### From a blank file
# Now write ε-greedy with sample averages from an empty cell, with NumPy alone: some 15 lines.
#
# **What it must do.** `my_program(environment, n_steps, seed)` takes `n_steps` steps in a Gymnasium environment, episode after episode, and returns its policy, a function from a state to the best arm. There
# is a single state, the number 0. Arms are whole numbers, from 0 to `environment.action_space.n - 1`.
#
# - $\varepsilon = 0.1$, and the first values are 0. A random arm may be any of them, the best one too.
# - Among equally good arms draw one at random, anew in each step: in the beginning all are equal.
# - Every reward counts equally in the mean of its arm. What was learned stays when an episode ends. (An episode is a series of pulls.)
# - Random numbers come from `rng = np.random.default_rng(seed)`.
# - An episode begins with `state, info = environment.reset()`, the very first one with `reset(seed=seed)`. A pull is `state, reward, terminated, truncated, info = environment.step(arm)`; the episode is over if `terminated`
#   or `truncated` is True.
#
# The check looks at your pulls, and at the policy that you return: are they the arms that look best by the rewards that your program got? Then it compares what it earns with ours, in episodes of 100 pulls.
# <details><summary>A plan</summary>Reset. In each step: choose the arm, step, count the pull, move the mean, and reset if the episode is over.</details>

# %% tags=["project"]
my_program = ...  # your program


### BEGIN PROGRAM
def my_program(environment, n_steps, seed):
    """Learn by ε-greedy with sample averages."""
    rng = np.random.default_rng(seed)
    n_arms = environment.action_space.n
    Q, N = np.zeros(n_arms), np.zeros(n_arms)

    def best(state):
        return rng.choice(np.flatnonzero(Q.max() == Q))

    state, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        arm = rng.integers(n_arms) if rng.random() < 0.1 else best(state)
        state, reward, terminated, truncated, _ = environment.step(arm)
        N[arm] += 1
        Q[arm] += (reward - Q[arm]) / N[arm]
        if terminated or truncated:
            state, _ = environment.reset()
    return best


### END PROGRAM

# %% tags=["project"]
from edugym_course.lessons.bandits.project import project_0b

check(project_0b, my_program)

# %% [markdown]
# ## What you saw
#
# - Greedy finds the best of ten arms in 15 % of the runs: it stays with the first arm that pays.
# - ε-greedy's regret goes on growing evenly, by 0.018 a pull. With a falling $\varepsilon$, UCB, Thompson sampling and the gradient bandit it grows ever more slowly.
# - After 10 000 pulls ε-greedy has paid 240, a falling $\varepsilon$ 181, UCB 160, Thompson sampling 108. To try each arm 100 times first costs 180.
# - In 10 000 pulls the regret of UCB and of Thompson sampling first rises with the gap and then falls: what is hardest to find out is not what costs most.
# - Where arms drift about ten times in a run, ε-greedy pays less with a constant learning rate of 0.1 than with sample averages; where they do not, it pays more. There UCB paid least, and without its bonus more than twice as much.
#
# ### In one paragraph
# *Learn it by heart, or better, say it in your own words.* Only a pull shows how well an arm pays, and a pull of a worse arm costs. Nobody tells an agent when it may stop looking, so it must go on, but less and less. Greedy looks too little and stays with an arm that was lucky first, ε-greedy looks
# and pays at the same rate for ever. UCB and Thompson sampling try an arm the less, the less likely it is the best one: UCB by a bonus that shrinks with the number of pulls (optimism in the face of uncertainty), Thompson sampling
# by a draw from what it believes. No agent that is good on every bandit pays less, in the long run, than a logarithm of time (unless a single pull can give a worse arm away). If the arms change, old means mislead.
#
# ### Limits
# There is one state, and an arm changes nothing of what comes. In the next lessons an action also leads somewhere, and what is to be explored may be a hundred steps away: lesson 1
# shows that the random actions of $\varepsilon$-greedy do not get there. All worse arms are equal here. Settings were not tuned for each method: another $c$, $\sigma$, $\varepsilon$ or $\alpha$ moves the numbers, and may change who is ahead of whom. The bound
# of Lai and Robbins holds for long runs.
#
# ### Further reading
# - Lai and Robbins (1985), *Asymptotically efficient adaptive allocation rules*: the bound.
# - Auer, Cesa-Bianchi and Fischer (2002), *Finite-time analysis of the multiarmed bandit problem*: UCB, and an ε that falls as $1/t$.
# - Thompson (1933), *On the likelihood that one unknown probability exceeds another in view of the evidence of two samples*.
# - Lattimore and Szepesvári (2020), *Bandit algorithms*: most of this, with proofs.
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 2.2 and 2.4 (ε-greedy, sample averages), 2.5 (arms that drift), 2.6 (optimism), 2.7 (UCB), 2.8 (gradient bandit).
