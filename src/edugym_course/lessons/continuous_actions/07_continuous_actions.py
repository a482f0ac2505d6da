# %% [markdown]
# # Discrete and continuous actions: Trashbot
#
# **The challenge.** A robot arm can turn its joints by any angle. Should an agent choose among a few angles, or learn
# to name the angle itself?
#
# **You will be able to** say what bins of actions cost and what they buy; derive the policy gradient in three lines,
# and the update of a Gaussian policy from it; check a gradient by finite differences; explain what a baseline does;
# and name a task and a start from which bins beat a Gaussian policy.
#
# **Time.** {time} **Before you start.** You should know what a return, a policy
# and a value function are (Sutton and Barto, 2nd edition, sections 3.3 and 3.5), and the TD error (section 6.1). You
# need the derivative of a logarithm and the normal distribution. All symbols are in the
# [table of notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).

# %%
from typing import NamedTuple

import gymnasium as gym
import numpy as np

from edugym import REINFORCE, GaussianActorCritic, TileCoding, make_mdp, paired_difference, repeat, train
from edugym.agents.softmax import draw_action, follow_log_gradient, softmax
from edugym.agents.tables import greedy_action
from edugym.deep.ppo import advantages_of, clipped_gain
from edugym.envs.trashbot.task import TrashbotInBins
from edugym.experiments.figures import Sheet
from edugym.experiments.results.tables import joined
from edugym_course.lessons.continuous_actions import exact, figures, methods, pictures, ppo, release
from edugym_course.notebook import frames, play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: an arm, a box and a container
#
# An arm with a shoulder and an elbow stands between a red box and a green container. From its end, the *wrist*, hangs a
# magnet. It takes the box if it comes down on it, and lets it fall between the walls of the container: the closer to
# the middle the better. (The magnet works by itself; the actions only move the arm.)

# %%
env = gym.make("edugym/Trashbot-v0", n_bins=5).unwrapped
env.reset(seed=0)
env.step((2, 3))  # bins 2 and 3 of 0, 1, 2, 3, 4: the shoulder rests, the elbow turns half as far as it can
env.scene()

# %% [markdown]
# The dots show where the magnet can be after the next step (unless it takes the box), if each joint has five *bins*:
# values from which the agent chooses. Without bins, both joints turn by any real number from −1 to 1, times 12 degrees.
#
# | | | in words |
# |---|---|---|
# | states | two angles, whether the box is held, the step | |
# | observations | seven numbers from −1 to 1 | elbow $x, y$; wrist $x, y$; magnet $x, y$; 1 if the box is held |
# | actions | $\mathcal{A} = [-1, 1]^2$, or $n \times n$ bins | how far shoulder and elbow turn, as a share of 12 degrees |
# | dynamics | both angles change by the action times 12 degrees; in the step that picks up the box the arm does not turn | deterministic |
# | | the episode *terminates* | if the box is delivered, if the arm hits something, or after 150 steps |
# | reward | 1 for picking up the box | |
# | | 2 for delivering it, and up to 2 more | 2 in the middle of the container, 0 where the box only just fits |
# | | −2 for a collision, −1 if time runs out | |
# | discount | $\gamma = 0.99$ | used by the agents of this lesson, but PPO has 0.999; returns in the figures are not discounted |
#
# The best possible return is 5. An agent that picks up the box and does nothing more gets $1 - 1 = 0$, and one that
# never picks it up and hits nothing gets −1. (One that picks it up and then crashes gets −1.) You will meet
# these numbers again.
#
# These are the reward and what an action means. The last of the next two cells belongs to the arm with $n$ bins, which
# lie in equal steps from −1 to 1.

# %%
source(type(make_mdp("Trashbot")), "reward", "centring", "turns")

# %%
source(TrashbotInBins, "turns")

# %% [markdown]
# **Play it yourself.** There are three bins for each joint, and the buttons turn one joint at a time. How close to the
# middle of the container do you bring the box?

# %%
play("Trashbot", n_bins=3)

# %% [markdown]
# ### What bins cost: try everything
# With bins both angles stay on a lattice, since each turn is a multiple of one small angle. So a computer can try
# *everything*: at which places in the container can the box be let go? (The unit of length is the upper arm. The
# container is 0.45 wide and the box 0.25, so the box fits if it is at most $(0.45 - 0.25) / 2 = 0.1$ off the middle.)
#
# **Predict.** Four bins have no 0: neither joint can rest. Five bins have one. With which of them can the box be
# placed more exactly?

# %%
finer = predict("The best possible return is higher with ...", ["4 bins", "5 bins", "the same, up to 0.005"])
finer

# %%
display(figures.exact_figure())
best = {n: exact.best_return(n) for n in figures.SHOWN_BINS}
for n, value in best.items():
    print(f"{n} bins: {len(exact.deliveries(n).places):3} places, best return {value:.2f}")
gap = best[5] - best[4]
finer.measured("the same, up to 0.005" if abs(gap) <= 0.005 else "5 bins" if gap > 0 else "4 bins")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Four bins, by a little. On the left every dot is a place where the box can be let go, and the ring is
# the one nearest to the middle. (The box only just fits at the green lines.) By and large more bins mean more places.
# But five bins turn a joint by 0, 6 or 12 degrees, so its angles are 6 degrees apart. Four turn it by 4 or 12: 4
# degrees apart (but neither joint can rest, so half of the pairs of angles never occur).
#
# With two bins there are four places, all more than half of the way from the middle to the edge. No learning can mend
# that.
# </details>

# %% [markdown]
# ## The idea: learn the policy itself
#
# Q-learning chooses the action with the largest value. With real actions that is a search among infinitely many values
# at every step. **Bins** make the actions few. Or the agent learns the policy itself: it draws its actions from a
# **stochastic policy** $\pi(a \mid s, \theta)$ with parameters $\theta$, and learns which of them did well. All agents
# of this lesson do that; bins only change what they choose from.
#
# ### The policy gradient, in three lines
# Take one decision first: the agent draws an action $A$ from $\pi(a \mid \theta)$ and gets the reward $R$, whose mean
# is $r(a)$. Its aim is the expected reward $J(\theta)$, so it wants the gradient of $J$. It knows neither $r$ nor its
# derivative. But it knows $\pi$:
#
# $$
# \begin{aligned}
# \nabla J(\theta) &= \nabla \sum_a \pi(a \mid \theta)\, r(a) = \sum_a r(a)\, \nabla \pi(a \mid \theta) \\
# &= \sum_a \pi(a \mid \theta)\, r(a)\, \frac{\nabla \pi(a \mid \theta)}{\pi(a \mid \theta)}
# = \sum_a \pi(a \mid \theta)\, r(a)\, \nabla \ln \pi(a \mid \theta) \\
# &= \mathrm{E}\left[ R\, \nabla \ln \pi(A \mid \theta) \right]
# \end{aligned}
# $$
#
# (For real actions the sums are integrals.) This is the *likelihood-ratio* or *log-derivative trick*. The last line is an expectation over
# actions that the agent draws itself. So each single action gives an estimate that is right on average: $R\, \nabla \ln
# \pi(A \mid \theta)$. The vector $\nabla \ln \pi$ is called the *score*. It points to where the action would be more
# likely.
#
# **A baseline.** The mean score is zero, since $\sum_a \pi \nabla \ln \pi = \sum_a \nabla \pi = \nabla 1 = 0$. So any
# number $b$ that does not depend on the action can be subtracted from $R$, and the mean of the estimate stays the
# same: $(R - b)\, \nabla \ln \pi(A \mid \theta)$. What changes is its *noise*: how far the single estimates lie apart.
#
# **Many decisions.** In an episode the return $G_t$ from step $t$ takes the place of $R$, and a learned value $V(s)$
# that of $b$. The policy gradient theorem says that this works (sections 13.2 to 13.4; exercise 3 shows a catch). The algorithm is **REINFORCE** with a
# baseline. For each step $t$ of an episode:
#
# $$
# \begin{aligned}
# \delta &= G_t - V(S_t) \\
# V(S_t) &\leftarrow V(S_t) + \alpha^w\, \delta \\
# \theta &\leftarrow \theta + \alpha^\theta\, \gamma^t\, \delta\, \nabla \ln \pi(A_t \mid S_t, \theta)
# \end{aligned}
# $$
#
# The learning rates are $\alpha^\theta$ for the policy and $\alpha^w$ for the values. The factor $\gamma^t$ discounts
# later steps, as the aim is the return from the start. In the code `last_value` is 0 here, since every episode of
# Trashbot terminates:

# %%
source(REINFORCE.learn_from_episode)

# %% [markdown]
# ### Bins: a softmax policy
# A table has a *preference* $\theta(s, a)$ for every state and action, and the policy is the softmax of its row
# (equation 13.2):
#
# $$
# \pi(a \mid s, \theta) = \frac{e^{\theta(s, a)}}{\sum_{a'} e^{\theta(s, a')}}
# \qquad\qquad
# \frac{\partial \ln \pi(A \mid s, \theta)}{\partial \theta(s, a)} = 1\{a = A\} - \pi(a \mid s, \theta)
# $$
#
# The score on the right follows from
# $\ln \pi(A \mid s, \theta) = \theta(s, A) - \ln \sum_{a'} e^{\theta(s, a')}$. The action that was taken gets
# $1 - \pi$, and all others $-\pi$:

# %%
source(follow_log_gradient)

# %% [markdown]
# The table needs *states* cut up as well: both coordinates of the wrist into 30 cells, and whether the box is held.

# %% [markdown] tags=["aside"]
# ### Aside: cutting the observation into cells
# The last line below says into how many cells each of the seven numbers of the observation is cut; 1 cell leaves a
# number out. (The last number is 0 or 1, but its range goes from −1 to 1. With two cells both 0 and 1 would lie in the
# upper one, so it has three.) Two bends of the elbow can give the same wrist; the table cannot tell them apart.

# %%
source(methods.in_a_table)

# %% [markdown]
# ### Real numbers: a Gaussian policy
# For real actions the agent draws from a normal distribution with mean $\mu$ and standard deviation $\sigma$:
#
# $$
# \pi(a) = \frac{1}{\sigma \sqrt{2 \pi}}\, e^{-(a - \mu)^2 / (2 \sigma^2)}
# \qquad\text{so}\qquad
# \ln \pi(a) = -\frac{(a - \mu)^2}{2 \sigma^2} - \ln \sigma - \ln \sqrt{2 \pi}
# $$
#
# (Under the root, $\pi$ is the number.) Its scores are the derivatives of the right side (exercise 13.4 of the book):
#
# $$
# \frac{\partial \ln \pi(a)}{\partial \mu} = \frac{a - \mu}{\sigma^2}
# \qquad\qquad
# \frac{\partial \ln \pi(a)}{\partial \ln \sigma} = \frac{(a - \mu)^2}{\sigma^2} - 1
# $$
#
# The second one is taken with respect to $\ln \sigma$, so that $\sigma$ stays above 0 whatever is added. If an action
# was better than the baseline, $\mu$ moves towards it, and $\sigma$ grows if the action was farther from $\mu$ than
# $\sigma$, and shrinks if it was nearer. If the action was worse, all of this is the other way round.
#
# **Are these scores right?** Check them on one decision of our robot: where to let go of the box. The action $a = 0$ is
# the middle of the container, and at $a = -1$ and $a = 1$ the box only just fits. An action pays $4 - 2|a|$ if $|a| \le
# 1$, and −2 (the wall) if not. This reward has jumps and a kink; the policy gradient needs no derivative of it.

# %%
source(release.estimates)

# %% [markdown]
# Let $J$ be the expected reward of this policy. Each of 100 000 actions gives an estimate of the slope of $J$ in $\mu$,
# and one in $\ln \sigma$ (with $b = 0$). To check their means, we compute $J$ as a sum over a fine grid of actions, and
# take *finite differences*: $(J(\mu + h) - J(\mu - h)) / 2h$ with a small $h$, and the same with $\ln \sigma$. (± is
# the 95 % interval.)
#
# The figure has 1 000 actions. The line in its left panel is the reward, the filled curve the density of
# the policy.

# %%
for mu, sigma in ((0.6, 0.5), (-0.8, 1.0), (0.1, 0.1)):
    found = release.estimates(mu, sigma, 100_000)
    for of, slope, each in zip(("μ", "ln σ"), release.slopes(mu, sigma), found, strict=True):
        error = 1.96 * each.std() / len(each) ** 0.5
        by_actions = f"from actions {each.mean():5.2f} ± {error:.2f}"
        print(f"μ = {mu:4}, σ = {sigma}, slope in {of + ':':5} finite differences {slope:5.2f}, {by_actions}")
display(figures.gradient_figure())

# %% [markdown]
# They agree. Move the sliders: when is the estimate good, and when is it wild? (The next aside measures it.)


# %%
def gradient(mu=0.6, sigma=0.5, actions=1_000, b=0.0):
    """Draw a Gaussian policy, and the slope of J beside its estimate."""
    return figures.gradient_figure(mu, sigma, actions, b)


sliders(gradient, mu=(-2.0, 2.0, 0.1), sigma=(0.1, 1.5, 0.1), actions=[10, 100, 1_000, 10_000], b=(-2.0, 6.0, 0.5))

# %% [markdown] tags=["aside"]
# ### Aside: what a baseline does to a gradient
# **Predict.** A policy has nearly learned it: $\mu = 0.1$, $\sigma = 0.1$. Nearly all of its rewards lie between 3.4
# and 4. How noisy is one estimate of the slope in $\mu$ with the baseline $b = J$, compared with $b = 0$?

# %%
noise = predict(
    "With the baseline J, the standard deviation of an estimate is ...",
    ["the same", "half as large", "less than a tenth"],
)
noise

# %%
policies = {"early: μ = 0.6, σ = 0.5": (0.6, 0.5), "late: μ = 0.1, σ = 0.1": (0.1, 0.1)}
display(figures.noise_figure(policies))
ratios = []
for label, (mu, sigma) in policies.items():
    J = release.value(mu, sigma)
    without, with_it = (release.estimates(mu, sigma, 100_000, baseline=b)[0].std() for b in (0.0, J))
    ratios.append(with_it / without)
    print(f"{label}: J = {J:.2f}, standard deviation {without:.1f} without a baseline, {with_it:.1f} with b = J")
noise.measured("less than a tenth" if ratios[1] < 0.1 else "half as large" if ratios[1] < 0.75 else "the same")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Less than a tenth, for the late policy. Without a baseline every action gets a reward near 4 and pulls
# $\mu$ towards itself with full force, to the left as often as to the right, and the small difference between them
# drowns. With $b = J$ only the difference is left. For the early policy it makes hardly any difference; $J$ is a good
# baseline and not always the best one. What a baseline never changes is the mean.
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: what a baseline does to learning
# One hundred policies begin at $\mu = -0.8$, $\sigma = 1$, and learn both in 2 000 updates, with one action each
# ($\alpha$ is the same for $\mu$ and for $\ln \sigma$; the baseline is the mean of all rewards so far, the present one included). The code keeps
# $\mu$ between −6 and 6, and $\sigma$ between 0.02 and 2.7. What if it keeps $\sigma$ at 0.2 or above? And what if the
# steps are larger? (The figure has $\alpha = 0.01$.)

# %%
display(figures.baseline_figure())
for alpha in (0.01, 0.03, 0.1):
    for baseline, smallest in ((True, 0.02), (True, 0.2), (False, 0.02), (False, 0.2)):
        outside = abs(release.climb(rate=alpha, baseline=baseline, smallest=smallest).means) > 1
        left, end = outside.any(axis=0).sum(), outside[-1].sum()
        kind = f"α = {alpha:4}, {'a' if baseline else 'no'} baseline, σ at least {smallest}"
        print(f"{kind:39}: {left:3} of 100 means leave the container, {end:2} are outside in the end")

# %% [markdown]
# Look at $\alpha = 0.01$ first. Without a baseline they begin well. But when $\sigma$ has shrunk to about 0.1, they are
# thrown out of the container, sooner or later all of them. Some are inside again in the end. The scores
# $(a - \mu) / \sigma^2$ are about $1 / \sigma$ in size, and the noise grows with them. While $\sigma$ stays at 0.2 or
# above, none leaves in 2 000 updates.
#
# With $\alpha = 0.03$ a baseline and a larger $\sigma$ both help. Without either 88 of 100 are outside in the end. Either alone
# leaves only about ten outside, but nearly all leave at some time. With both only 23 leave in this time.
#
# With $\alpha = 0.1$ most are outside in the end in all four rows. So a baseline allows larger steps, and not any step.

# %% [markdown]
# ### The picture to remember
# In the left panel of the next figure one policy learns, with the mean of all rewards so far as baseline. It starts wide, moves to the middle, and
# becomes narrow. So a Gaussian policy turns from exploring into placing exactly. (That of the arm, below, keeps its $\sigma$.)


# %%
def learn_to_release(mu=-0.8, sigma=1.0, alpha=0.01, baseline=True):
    """Draw a Gaussian policy while it learns."""
    return figures.narrowing(mu, sigma, alpha, baseline)


sliders(learn_to_release, mu=(-2.0, 2.0, 0.1), sigma=(0.1, 2.0, 0.1), alpha=(0.005, 0.1, 0.005), baseline=True)

# %% [markdown]
# ### From one decision to the arm
# In the arm the mean depends on the state: $\mu_k(s)$ for joint $k$. It is linear in *features* $x_i(s)$, with weights
# $\theta_{ik}$. And so is the value:
#
# $$
# \mu_k(s) = \sum_i x_i(s)\, \theta_{ik}
# \qquad\qquad
# V(s) = \sum_i x_i(s)\, w_i
# $$
#
# The features come from **tile coding** (section 9.5.4): eight grids of 20 by 20 tiles, each a little displaced, lie
# over the places of the wrist, once for an arm with the box and once for one without it. A feature is a tile: 1 if the
# wrist is in it, else 0. So eight features are 1 at a time. Near places share most of their tiles, so what is learned
# carries over to neighbours.  (The picture has two grids.)

# %%
pictures.tile_coding()

# %% [markdown] tags=["aside"]
# ### Aside: tile coding in code
# The code finds the tile of each grid `k`. `shift` displaces the grid, in most grids by a different share of a tile in each coordinate;
# so a place near the upper edge may be in one tile more, hence `+ 1`. The number of a tile is put together from its
# places in all coordinates, as 352 is from its digits: $(3 \cdot 10 + 5) \cdot 10 + 2$.

# %%
source(TileCoding.see)

# %% [markdown]
# ### The actor-critic
# The chain rule gives the score of a weight: $\frac{\partial \ln \pi}{\partial \theta_{ik}} =
# \frac{a_k - \mu_k(s)}{\sigma^2}\, x_i(s)$. Instead of waiting for the return, the **actor-critic** judges each step by
# the TD error, $\delta = R + \gamma V(S') - V(S)$ (the box "One-step Actor-Critic" of section 13.5):
#
# $$
# w \leftarrow w + \alpha^w\, \delta\, x(S)
# \qquad\qquad
# \theta_k \leftarrow \theta_k + \alpha^\theta\, \delta\, \frac{A_k - \mu_k(S)}{\sigma^2}\, x(S)
# $$
#
# $\gamma V(S')$ is 0 if $S'$ is terminal. The updates leave out the factor $\gamma^t$ of REINFORCE, as is usual, and
# an update of $\sigma$, which is fixed here. (PPO, in an aside, learns it.) Two things to know of the code:
#
# - It divides both rates by the number of grids, `at_once`, since so many features are 1 at a time.
# - The arm gets, outside `learn`, a drawn action beyond ±1 as ±1; the agent learns from what it drew.

# %%
source(GaussianActorCritic.learn)

# %% [markdown]
# ## The experiment: three tables and a Gaussian
#
# | setting | value |
# |---|---|
# | 3, 5, 9 bins | REINFORCE with a baseline on a table, 30 by 30 cells, $\alpha^\theta = \alpha^w = 0.4$ |
# | continuous | Gaussian actor-critic on tile coding, $\sigma = 0.5$, $\alpha^\theta = 0.02$, $\alpha^w = 0.4$; all values start at 1 (optimistic: more than a state is worth at first; 0 did as well, −1 did not) |
# | all | $\gamma = 0.99$, 100 000 steps |
# | evaluation | one greedy episode every 4 000 steps: the likeliest bin, or the mean $\mu$ |
# | repetitions | 20; bands are 95 % intervals |
#
# The dotted lines are the best possible returns. (9 bins *can* do almost as well as real numbers.) Methods and features
# differ as well, so this compares four agents; the aside on PPO compares only the actions.
#
# The cell after the next is the experiment (later: `methods.learn_all`).
#
# **Predict.** Which of the four needs the fewest steps to its *first* greedy episode of 3.5, on average?

# %%
first = predict("The first to reach a return of 3.5:", ["3 bins", "5 bins", "9 bins", "continuous"])
first

# %%
how = {"n_steps": 100_000, "repetitions": 20, "evaluate_every": 4_000, "jobs": 2}
rates = {"learning_rate": 0.4, "value_learning_rate": 0.4}
runs = []
for n in (3, 5, 9):
    agents = {f"{n} bins": lambda task: REINFORCE.create(task, discount=0.99, longest=200, **rates)}
    runs.append(repeat(methods.in_a_table(n), agents, **how))

arm = make_mdp("Trashbot", container_width=0.45)
tiles = TileCoding.create(arm, tiles=[1, 1, 20, 20, 1, 1, 2], tilings=8)
rates = {"learning_rate": 0.02, "value_learning_rate": 0.4, "initial_value": 1.0}
agents = {
    "continuous": lambda task: GaussianActorCritic.create(task, features=tiles, spread=0.5, discount=0.99, **rates)
}
runs.append(repeat(arm, agents, **how))
learned = joined(runs)
display(Sheet("learning", [[figures.curves(learned, "table and tiles")]]))
soon = {label: methods.steps_to(learned, label, 3.5).mean() for label in learned.methods}
for label in learned.methods:
    end = learned.late(label).mean()
    print(f"{label:10}: {soon[label]:6.0f} steps to 3.5 (mean), return {end:.2f} (mean of the last five points)")
first.measured(min(soon, key=soon.get))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Three bins are first by far, and the more bins, the later. (A guess why: three bins for two joints make 9 actions,
# nine make 81.) But three bins cannot get more than 4.31: twelve of the 20 runs
# reach it, and eight stop at 4.07. Five and nine end higher on average.
#
# The continuous agent needs about as many steps as 5 bins. (Without the baseline 5 bins need fewer; exercise 3 shows
# why.) </details>

# %% [markdown]
# Watch both at work: three bins, and the continuous agent.

# %%
frames(methods.in_a_table(3), learned.agents["3 bins"][0], max_steps=40)

# %%
frames("Trashbot", learned.agents["continuous"][0], max_steps=40)

# %% [markdown]
# ## Your turn
#
# (4 runs of 40 000 steps; thin lines are single runs. `alpha` is that of REINFORCE, `actor_rate` is $\alpha^\theta$
# of the actor-critic.) Find settings with which the Gaussian agent stays at −1 (it mostly does not pick up the box),
# and others with which it stays at 0 (it never delivers it). What is too small a $\sigma$?


# %%
def one_setting(bins=5, cells=30, alpha=0.4, sigma=0.5, actor_rate=0.02, gamma=0.99, width=0.45):
    """Draw learning curves with these settings."""
    return figures.one_setting(bins, cells, alpha=alpha, sigma=sigma, actor_rate=actor_rate, gamma=gamma, width=width)


sliders(
    one_setting,
    bins=(2, 9),
    cells=(5, 40, 5),
    alpha=(0.05, 1.0, 0.05),
    sigma=(0.1, 1.0, 0.1),
    actor_rate=[0.002, 0.005, 0.01, 0.02, 0.05, 0.1],
    gamma=(0.9, 1.0, 0.01),
    width=(0.3, 0.8, 0.05),
)

# %% [markdown]
# <details><summary>What we found</summary>
#
# $\sigma = 0.1$ is too small: all four runs end at 0 or −1. With $\sigma = 0.2$ three of four end at 0. With $\sigma = 1$
# three of four deliver the box, but the box is placed less exactly. With $\sigma = 1$ and `actor_rate` 0.002 together, all four stay at −1.
# </details>

# %% [markdown]
# ## See inside: what the agents know of the places
#
# This is the learned value of each place of the wrist *while the box is held*: dark is 0 or less, bright up to 4. The
# orange line is the way of the wrist in a greedy episode, from the box to the container.

# %%
figures.maps(learned.agents["5 bins"][0], learned.agents["continuous"][0])

# %% [markdown]
# Both have learned a corridor of good places. Of a cell where it has never been the table knows nothing; tile coding
# guesses the value of a place from its neighbours. (On the right, blue is the first value 1, and dark was learned to be bad. On the left, dark is both: never updated, or bad.)

# %% [markdown]
# ## Predict, then check

# %% [markdown] tags=["aside"]
# ### Aside: PPO, where only the actions differ
# PPO is a policy gradient as above, with two networks in the place of tables. Many copies of the task play for a while
# with the policy $\pi_{\text{old}}$. Then it takes several gradient steps on what they played. So that the policy does
# not run away in these steps, an action drops out of the gradient once its probability has changed by 20 % in the
# direction that pays:

# %%
source(clipped_gain)

# %% [markdown]
# (`ratio` is $\pi(A \mid S) / \pi_{\text{old}}(A \mid S)$, `clip` is 0.2, and `advantage` is what stands for $\delta$.) One step of look-ahead or many? Here
# is a mean of all depths: later errors of the critic count too, each $\gamma \lambda$ times as much as the one before it (generalised advantage estimation, GAE; $\lambda = 0.95$):
#
# $$
# \hat A_t = \delta_t + \gamma \lambda\, \delta_{t+1} + (\gamma \lambda)^2\, \delta_{t+2} + \dots
# $$
#
# $\lambda = 0$ is the one-step error of the actor-critic above, and $\lambda = 1$ the return of the rest of the round, with $V$ of the state where it is cut, less the baseline, much as in REINFORCE.

# %%
source(advantages_of)

# %% [markdown]
# With bins the network puts out a softmax for each joint, without bins the mean of a Gaussian, and $\sigma$ is learned
# too. *All the rest is the same*: networks, learning rate 0.001 (falling to 0), $\gamma = 0.999$, 128 copies, rounds of
# 64 steps, 6 epochs of 8 minibatches (all of a round is learned from six times, in eight parts), 393 216 steps. A run takes several seconds, so these are stored results of ten
# seeds.
#
# While it learns, PPO draws its actions. These returns are in the left panel of the next figure. The right panel shows
# the same policies when they always take the likeliest bins, or the mean of the Gaussian.
#
# **Predict.** The paper of EduGym (Moerland et al., 2023) expects that fewer actions are learned sooner. Compare the
# steps to a return of 3 with drawn actions: do real numbers take more of them than 5 bins?

# %%
slower = predict(
    "Real numbers take ...",
    [
        "more steps than 5 bins",
        "fewer steps than 5 bins",
        "not decided: the 95 % interval of the difference contains 0",
    ],
)
slower

# %%
stored = ppo.STORED.load()
display(figures.ppo_figure(stored))
steps = {label: methods.steps_to(stored, label, 3.0, "training_return") for label in stored.methods}
for label in stored.methods:
    drawn, likeliest = stored.late(label, column="training_return"), stored.final(label)
    print(f"{label:10}: {steps[label].mean():6.0f} steps to 3, return at the end {drawn.mean():.2f} (means, drawn)")
    lost = likeliest < 1
    print(f"{'':10}  {lost.sum()} of 10 runs end below 1 with the likeliest actions;", end=" ")
    print(f"{(lost & (drawn > 3)).sum()} of these are above 3 with drawn ones")
pairs = [("3 bins", other) for other in ("5 bins", "9 bins", "continuous")]
for one, other in [*pairs, ("5 bins", "9 bins"), ("continuous", "5 bins")]:
    print(f"steps to 3, {one} minus {other}: {paired_difference(steps[one], steps[other])} (95 % interval)")
difference = paired_difference(steps["continuous"], steps["5 bins"])
more, fewer, unclear = slower.options
slower.measured(more if difference.low > 0 else fewer if difference.high < 0 else unclear)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** The interval contains 0: ten runs do not show which of the two learns faster, real numbers or 5 bins.
# (A run that never reaches 3 counts with all its steps.) Three bins are sooner than 5 and than 9, and these intervals
# exclude 0. Against real numbers the interval just contains 0. So "fewer actions are learned sooner" is shown for 3
# bins against more bins here, and for nothing else.
#
# With drawn actions 3 bins end highest on average, but no interval of these differences (which the cell does not print) excludes 0. One continuous run and one with 9 bins never learn to deliver (we
# looked at the single runs), and they pull the means down. Drawing actions costs exactness, too: each of the seven continuous runs that
# deliver with the mean ends higher with it than with drawn actions.
#
# In the right panel all runs with 3 bins end at 4.31, and the others spread widely. Three of the ten continuous policies end at 0 there: the arm holds the box
# until time is up. One run with 5 bins and four with 9 fail there too, at −1. Nothing in this
# world is random, so with the likeliest actions every episode is the same. Two of the three, and some of those with
# bins, deliver the box when they draw their actions. PPO improves the policy that draws. Nobody promised anything for
# its likeliest actions.
# </details>
#
# One seed live, with real numbers and 262 144 steps, in some seconds. Then a film in which it draws its actions.

# %%
run = ppo.trainer("continuous", 262_144)(262_144, seed=3)
print("return with drawn actions:", ", ".join(f"{value:.1f}" for value in run.training_returns[1::4]))
spread = run.agent.log_std.exp().tolist()
print(f"σ of the shoulder {spread[0]:.2f}, of the elbow {spread[1]:.2f}; both were {np.exp(-0.5):.2f} at first")
frames("Trashbot", methods.Drawing(run.agent), max_steps=40)

# %% [markdown] tags=["aside"]
# ### Aside: a narrower container
# **Predict.** In a container 0.4 wide instead of 0.45 the box has three quarters of the room ($0.4 - 0.25$ instead of
# $0.45 - 0.25$). The best possible return with 3 bins falls a little, from 4.31 to 4.08, and with real numbers it stays
# 5. Which of the two agents of the experiment loses more of its return?

# %%
narrow = predict("In the narrower container more return is lost by ...", ["3 bins", "continuous", "neither, up to 0.2"])
narrow

# %%
tight = methods.learn_all((3,), width=0.4, repetitions=20, jobs=2)
display(Sheet("narrow", [[figures.curves(tight, "a container 0.4 wide", width=0.4)]]))
loss = {}
for label in tight.methods:
    wide, small = learned.late(label).mean(), tight.late(label).mean()
    loss[label] = wide - small
    print(
        f"{label:10}: return {wide:.2f} in the wide container, {small:.2f} in the narrow one (means, last five points)"
    )
    print(f"{'':10}  {(tight.final(label) == 0).sum()} of 20 runs in the narrow one end at 0")
apart = abs(loss["3 bins"] - loss["continuous"]) > 0.2
narrow.measured(max(loss, key=loss.get) if apart else "neither, up to 0.2")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** The continuous agent, by far. Some 40 % of these runs end at 0 (here 9 of 20): the arm picks up the box, and then stays
# away from the container until time is up. The best possible return of real numbers is still 5, and some runs come
# close to it. A collision costs 2, and the agent learns to stay away from walls before it learns to deliver: at a cost of 1 only 8 of 100 runs ended at 0. That drawn actions are
# never exact ($\sigma$ is fixed) is not the reason: agents that had learned in the wide container went on learning in the narrow one, and went on delivering, with the same $\sigma$ (all of 40).
#
# Three bins lose little more than what is no longer possible for them.
# </details>
#
# Move the slider until three bins cannot deliver the box at all. (The best return is then 0, for holding the box until
# time is up.)


# %%
def container(width=0.45):
    """Draw where the box can be let go in a container of this width."""
    return figures.exact_figure(width, bins=(2, 3, 4, 5))


sliders(container, width=(0.28, 0.6, 0.02))

# %% [markdown]
# ### "Continuous is always better"
# Back to one decision, but with *two* containers. A poor one around −1 pays 2 at best. A rich one around 2 pays 4. One
# hundred Gaussian policies start over the poor one, with $\sigma = 0.5$ and $\alpha = 0.01$. One hundred softmax policies ($\alpha = 0.1$) choose among 10
# bins from −3 to 3, none of them in the middle of the rich container.
#
# **Predict.** How many of the 100 Gaussian policies end at the rich container?

# %%
rich = predict("Gaussian policies at the rich container, of 100:", ["fewer than 10", "10 to 90", "more than 90"])
rich

# %%
figure, found = figures.peaks()
display(figure)
for label, share in found.items():
    print(f"{label}: {share:.0%} at the rich container")
share = found["Gaussian"]
rich.measured("fewer than 10" if share < 0.1 else "10 to 90" if share <= 0.9 else "more than 90")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** None. They start narrow: hardly any action reaches the rich container. So they place the box exactly, in the wrong container. The bins start everywhere, and all of them find the rich
# container. But they cannot reach its middle, so they stop below 4. </details>
#
# Does a wider start help the Gaussian? Does another first $\mu$?


# %%
def two_containers(mu=-1.0, sigma=0.5, bins=10):
    """Draw policies of both kinds where there are two containers."""
    return figures.peaks(mu, sigma, bins)[0]


sliders(two_containers, mu=(-2.0, 3.0, 0.25), sigma=(0.25, 2.5, 0.25), bins=(3, 25))

# %% [markdown]
# <details><summary>What we found</summary>
#
# From $\mu = -1$ even $\sigma = 2.5$ brings only 32 of 100 to the rich container. From $\mu = 0$ and $\sigma = 2$, 98
# of 100 arrive.
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: what a policy gradient learns from failures, on a frozen lake
# REINFORCE can be trained in any Gymnasium environment whose observations and actions are numbered 0, 1, 2 and so on. FrozenLake is a lake
# of 4 by 4 fields with four holes. Here it is not slippery. The only reward is 1 at the goal; a hole ends the episode
# with 0.
#
# **Predict.** REINFORCE with a baseline starts with $\theta = 0$ and $V = 0$. It falls into holes in some episodes
# before it first reaches the goal. What has it learned from these episodes?

# %%
holes = predict(
    "Before the first success, REINFORCE has learned ...", ["to avoid the holes, a little", "nothing at all"]
)
holes

# %%
lake = gym.make("FrozenLake-v1", is_slippery=False)
beginner = REINFORCE.create(lake, learning_rate=0.2, value_learning_rate=0.2, discount=0.95)
before = train(lake, beginner, 200, seed=1)
print(
    f"{before.episodes.sum()} episodes, {np.nansum(before.training_returns * before.episodes):.0f} of them at the goal"
)
print("largest preference:", np.abs(beginner.preferences).max())
display(figures.lake_figure(methods.frozen_lake(6_000, repetitions=5)))
holes.measured("nothing at all" if not beginner.preferences.any() else "to avoid the holes, a little")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Nothing at all. Its return was 0 and its baseline was 0, so $\delta = 0$ at every step. A policy
# gradient learns from differences between the return and the baseline. Only after its first success can it learn. The
# figure goes on to 6 000 steps. There all five runs reach the goal, with a baseline and without. Five do not show which
# is faster. (Each point averages three evaluations.) </details>

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for your answer, and below it a cell that checks it. The check does not only say whether an
# answer is right: it says what was expected, what came, and which mistake that looks like. It runs your code on cases
# that it makes up.

# %%
from edugym_course.grading import check
from edugym_course.lessons.continuous_actions.exercises import CHALLENGE, exercise_1, exercise_2, exercise_3

# %% [markdown]
# ### Exercise 1: what bins cost
# Our arm has two joints. Let an arm have $m$ joints. Its table has a row for every state and a column for every
# action. A state is: the angle of each joint, cut into $c$ cells, and whether the box is held (yes or no). An action
# chooses one of $n$ bins for each joint. (The table of the lesson has the two coordinates of the wrist instead of the
# angles.) How many preferences $\theta(s, a)$ does the table have? Write the function,
# with Python's whole numbers, which are exact at any size.
#
# <details><summary>Hint</summary>First the number of rows, then the number of columns. How many ways are there to
# choose one of n bins for two joints, and for three?</details>


# %%
def preferences(joints, bins, cells):
    """Return the number of preferences of an arm with so many joints, bins for each, and cells for each angle."""
    ### BEGIN SOLUTION
    rows = 2 * cells**joints
    # own: rows = {held} * cells**joints
    columns = bins**joints
    return rows * columns
    ### END SOLUTION


# %% tags=["check"]
check(exercise_1, preferences)
### BEGIN HIDDEN TESTS
check(exercise_1, preferences, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 2: the scores of a Gaussian
# Write both scores yourself. `my_scores` gets an action `a`, the mean `mu` and the standard deviation `sigma`, and
# returns two numbers: how fast $\ln \pi(a)$ grows with $\mu$, and how fast it grows with $\ln \sigma$. It must also
# work for arrays of actions, so use only `+ - * / **`. The race puts your scores into the hundred policies that learn
# where to let go.
#
# <details><summary>Hint</summary>Close the lesson and derive them from ln π(a) = −(a − μ)² / (2σ²) − ln σ − constant.
# For the second, the chain rule says: the derivative with respect to ln σ is σ times the derivative with respect to
# σ.</details>


# %%
def my_scores(a, mu, sigma):
    """Return the derivatives of ln π(a) with respect to μ and to ln σ."""
    ### BEGIN SOLUTION
    of_mu = (a - mu) / sigma**2
    of_log_sigma = (a - mu) ** 2 / sigma**2 - 1
    # own: of_log_sigma = {scale} * ((a - mu) ** 2 / sigma**2 - 1)
    return of_mu, of_log_sigma
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_2, my_scores)
### BEGIN HIDDEN TESTS
check(exercise_2, my_scores, seed=1, quiet=True)
### END HIDDEN TESTS
display(figures.climb_race(my_scores))

# %% [markdown]
# ### Exercise 3: REINFORCE with a baseline, in ten lines
# The class below acts, and it notes each step of an episode: `self.states[t]`, `self.actions[t]`, and in
# `self.rewards[t]` the reward $R_{t+1}$ that followed. At the end of the episode it calls `update(n)`, where `n` is
# the number of its steps. Write `update`. First compute the returns, from the last step backwards:
# $G_t = R_{t+1} + \gamma G_{t+1}$ with $G_n = 0$. Then, for each step $t$ in order (the check accepts the reverse order
# too; the race shows the difference):
#
# - $\delta = G_t - V(S_t)$, with $V(S_t)$ as it is when the turn of step $t$ comes (the steps before it have changed
#   $V$);
# - move $V(S_t)$ by $\alpha^w \delta$;
# - move every preference of the state by $\alpha^\theta \gamma^t \delta\, (1\{a = A_t\} - \pi(a \mid S_t))$.
#
# `self.look(state)` writes $\pi(\cdot \mid s)$ into `self.probabilities`. The fields `learning_rate` and
# `value_learning_rate` are $\alpha^\theta$ and $\alpha^w$. You write plain Python, with loops over numbers, and it
# runs as machine code. (If a warning says that it cannot be compiled, as with `reversed`, the race takes a minute or two.)
# The race is on Trashbot with 5 bins, 40 000 steps and 8 repetitions, beside REINFORCE of the package with a baseline
# and without.
#
# <details><summary>Hint</summary><code>for t in range(n - 1, -1, -1):</code> counts backwards. You may write the return
# into <code>self.rewards[t]</code>. <code>self.discount**t</code> is γ to the power of t. Call
# <code>self.look(state)</code> before you use the probabilities. The last lines are a loop over
# <code>range(len(self.probabilities))</code>.</details>


# %%
class MyREINFORCE(NamedTuple):
    """REINFORCE with a baseline, on a table."""

    preferences: np.ndarray  # shape (n_states, n_actions): θ
    V: np.ndarray  # shape (n_states,): the baseline
    probabilities: np.ndarray  # shape (n_actions,): π of the state that was looked at last
    states: np.ndarray  # of the episode under way
    actions: np.ndarray
    rewards: np.ndarray
    length: np.ndarray  # shape (1,): its steps so far
    learning_rate: float = 0.4
    value_learning_rate: float = 0.4
    discount: float = 0.99

    @classmethod
    def create(cls, task):
        """Make a new agent for a task."""
        n_states, n_actions = int(np.prod(task.observation_space.nvec)), int(task.action_space.n)
        episode = np.zeros(200, np.int64), np.zeros(200, np.int64), np.zeros(200), np.zeros(1, np.int64)
        return cls(np.zeros((n_states, n_actions)), np.zeros(n_states), np.zeros(n_actions), *episode)

    def look(self, state):
        """Write the probability of each action in a state into `probabilities`."""
        softmax(self.preferences, state, self.probabilities)

    def act(self, state, rng):
        """Draw an action."""
        self.look(state)
        return draw_action(self.probabilities, rng)

    def greedy(self, state, rng):
        """Choose the likeliest action, one of them at random if there are several."""
        return greedy_action(self.preferences, state, rng)

    def learn(self, state, action, reward, terminated, truncated):
        """Note the step; learn at the end of the episode."""
        t = self.length[0]
        self.states[t], self.actions[t], self.rewards[t] = state, action, reward
        self.length[0] = t + 1
        if terminated or truncated:
            self.update(self.length[0])
            self.length[0] = 0

    def update(self, n):
        """Learn from the n steps of the episode."""
        ### BEGIN SOLUTION
        G = 0.0
        for t in range(n - 1, -1, -1):
            G = self.rewards[t] + self.discount * G
            # own: G = self.rewards[t] - {cost} + self.discount * G
            self.rewards[t] = G  # from here on: the return from step t
        for t in range(n):
            state = self.states[t]
            delta = self.rewards[t] - self.V[state]
            self.V[state] += self.value_learning_rate * delta
            self.look(state)
            for a in range(len(self.probabilities)):
                score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
                self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
        ### END SOLUTION


# %% tags=["check"] points=3
check(exercise_3, MyREINFORCE)
### BEGIN HIDDEN TESTS
check(exercise_3, MyREINFORCE, seed=1, quiet=True)
### END HIDDEN TESTS
display(figures.race({"mine": MyREINFORCE.create}))

# %% [markdown]
# <details><summary>What the race shows</summary>
#
# Your line lies on that of REINFORCE with a baseline if you went through the steps in order. (If you updated from the
# last step backwards, you have another line, an earlier one: the arm comes to some cells several times in an episode, and then the
# order matters.) Without a baseline the mean line is earlier here, and in 60 more runs it is, too.
#
# The baseline itself is not to blame, but the order is. Each visit to a cell moves $V$ by 40 % of the way to the return, so in the book's order a later visit to the same cell in the episode has a much smaller $\delta$. The test: $V$ moves only after all steps of the policy, and we multiply $\delta$ by 0.6 for each earlier visit to the cell, or for each later one. Steps to 3.5 (mean of 120 runs, set up as in the race):
#
# | | steps |
# |---|---|
# | the book's order | 23 000 |
# | $V$ moves after all steps | 14 000 |
# | and $\delta$ shrinks with each visit *before* it | 23 000 |
# | and $\delta$ shrinks with each visit *after* it | 9 000 |
# | no baseline | 14 000 |
#
# So the last visit matters most; likely since it is the one that leaves the cell.
#
# A baseline makes each estimate less noisy where all returns are far from 0. It does not promise faster learning in every task.
# </details>

# %% [markdown]
# ### The open challenge: your own container
# Trashbot with continuous actions, and ten containers whose widths belong to your name: from 0.4 to 0.6. Your agent has
# 50 000 steps in each. It is told only the two spaces: seven numbers in, two numbers out. Its points are the mean
# return of its greedy episodes over training, in percent of 5. So it should learn *soon*. No agent can get all 100,
# since hardly anybody delivers the box before they have learned to.
#
# Everything is allowed that learns from its own steps: other features, a $\sigma$ that shrinks, bins inside of the
# agent, an agent of your own (with `act`, `greedy` and `learn` as in exercise 3, and `tabular = False`; `learn` gets its arguments by their
# names, and may have `next_state` as well; plain Python takes minutes). Half a page with it: what did you change, why should it help, and what did you measure?


# %%
def my_agent(task):
    """Make the agent for the challenge; put your own in its place."""
    return methods.gaussian(task, spread=0.4)


CHALLENGE.score(my_agent, "Ada Lovelace")

# %% [markdown]
# ### From a blank file
# Now write it all yourself, from an empty cell, with NumPy and Gymnasium only: REINFORCE with a baseline and a Gaussian
# policy that learns its $\sigma$ too, and its loop, some 40 lines. Each state has a mean $\mu(s)$, a $\ln \sigma(s)$
# and a value $V(s)$ of its own, in three arrays. At the end of an episode, for each of its steps $t$:
#
# $$
# \begin{aligned}
# \delta &= G_t - V(S_t) \\
# V(S_t) &\leftarrow V(S_t) + \alpha^w\, \delta \\
# \mu(S_t) &\leftarrow \mu(S_t) + \alpha^\theta\, \gamma^t\, \delta\, \frac{A_t - \mu(S_t)}{\sigma(S_t)^2} \\
# \ln \sigma(S_t) &\leftarrow \ln \sigma(S_t) + \alpha^\theta\, \gamma^t\, \delta
# \left[ \frac{(A_t - \mu(S_t))^2}{\sigma(S_t)^2} - 1 \right]
# \end{aligned}
# $$
#
# On the right are the $\mu$ and the $\sigma$ from which $A_t$ was drawn. After each of these updates keep $\sigma$ between 0.2
# and 2.
#
# **What it must do.** `my_program(environment, n_steps, seed)` takes `n_steps` steps in a Gymnasium environment,
# episode after episode, and learns from each episode that ends (drop the last one if time cuts it off). Some are
# truncated; their returns stop at the last reward as well. In the end it returns its *policy*: a function that takes a
# state and returns its mean $\mu$. All else is up to you: functions, classes, any names.
#
# - States are whole numbers from 0, and `environment.observation_space.n` says how many there are. An action is one
#   real number, as large or small as you like.
# - Take $\alpha^\theta = 0.005$, $\alpha^w = 0.1$, $\gamma = 0.8$, and begin with $\mu = 0$, $\sigma = 1$ and $V = 0$.
# - Draw all random numbers from `np.random.default_rng(seed)`, and give the seed to the first `reset` alone.
#
# In the check an arm lets go of three or six boxes, one after another, each over a container whose middle it does not know. A
# box pays as in "Are these scores right?", so the best return is 4 for each box. No state comes twice in an episode. (In a second
# task the farthest actions pay most, so $\sigma$ grows.) Your program draws its actions, so none of them is right or
# wrong. But its own steps tell, by the equations, which $\mu$ it should return, and from which Gaussians it should have
# drawn its actions. The check compares both. It sees no line of your program, so the mistake that it names is only the likely one.

# %% tags=["project"]
my_program = ...  # your program
### BEGIN PROGRAM


def my_program(environment, n_steps, seed):
    """Learn by REINFORCE for `n_steps` steps, and return the means of the policy."""
    alpha, alpha_value, gamma = 0.005, 0.1, 0.8
    rng = np.random.default_rng(seed)
    mu, log_sigma, V = np.zeros((3, environment.observation_space.n))

    def learn(episode):
        """Update all that the episode tells about, from its last step to its first."""
        G = 0.0
        for t in reversed(range(len(episode))):
            state, action, reward = episode[t]
            G = reward + gamma * G
            delta = G - V[state]
            V[state] += alpha_value * delta
            sigma = np.exp(log_sigma[state])
            off = action - mu[state]
            step = alpha * gamma**t * delta
            mu[state] += step * off / sigma**2
            log_sigma[state] += step * (off**2 / sigma**2 - 1)
            log_sigma[state] = np.clip(log_sigma[state], np.log(0.2), np.log(2))

    state, _ = environment.reset(seed=seed)
    episode = []
    for _ in range(n_steps):
        action = rng.normal(mu[state], np.exp(log_sigma[state]))
        next_state, reward, terminated, truncated, _ = environment.step(action)
        episode.append((state, action, reward))
        state = next_state
        if terminated or truncated:
            learn(episode)
            state, _ = environment.reset()
            episode = []
    return lambda state: mu[state]


### END PROGRAM

# %% tags=["project"]
from edugym_course.lessons.continuous_actions.project import project_7

check(project_7, my_program)

# %% [markdown]
# ## What you saw
#
# ### In one paragraph
# *Learn it by heart, or better, say it in your own words.* With continuous actions no agent can try them all. We can
# choose a few: then the best of these few is the most that we can get, and with $m$ joints there are $n^m$ of them. Or
# we learn a stochastic policy itself: draw an action from $\pi(a \mid s, \theta)$, and move $\theta$ along $(G - b)\,
# \nabla \ln \pi$, towards actions that did better than expected. For a Gaussian this moves the mean towards good
# actions, and makes the policy narrow when good ones are near. It is not limited to a few actions, but it has one peak and sees only
# what is near it.
#
# ### Limits
# There are more ways out, which we did not try: search among drawn actions for the largest $Q$ (QT-Opt), give $Q$ a
# form whose largest value is known (NAF), follow its slope with a deterministic policy (DDPG, TD3). Trashbot has two
# joints; the growth of $n^m$ was computed and not felt. (Bins need not be crossed: PPO has a softmax for each joint,
# $nm$ outputs instead of $n^m$.) The agents were tuned by trials of a few settings, so the main experiment ranks these
# agents and not all. And the clock is not in the observation, and cells and tiles leave out the bend of the elbow: the task
# is not quite Markov.
#
# ### Further reading
# - Moerland et al. (2023), *EduGym: An environment and notebook suite for reinforcement learning education*: the paper.
#   There PPO is compared with bins and without.
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 9.4–9.5 (features, tile coding), 13.1–13.5 (policy
#   gradient, REINFORCE, baselines, actor-critic), 13.7 (policies for continuous actions).
# - Williams (1992), *Simple statistical gradient-following algorithms for connectionist reinforcement learning*:
#   REINFORCE.
# - Silver, Lever, Heess, Degris, Wierstra and Riedmiller (2014), *Deterministic policy gradient algorithms*; Lillicrap
#   et al. (2016), *Continuous control with deep reinforcement learning*: DDPG.
# - Gu, Lillicrap, Sutskever and Levine (2016), *Continuous deep Q-learning with model-based acceleration*: NAF;
#   Kalashnikov et al. (2018), *QT-Opt*: the search for the largest $Q$ by the cross-entropy method.
# - Schulman, Wolski, Dhariwal, Radford and Klimov (2017), *Proximal policy optimization algorithms*.
# - Greensmith, Bartlett and Baxter (2004), *Variance reduction techniques for gradient estimates in reinforcement
#   learning*: the best baseline.
# - Tang and Agrawal (2020), *Discretizing continuous action space for on-policy optimization*: where bins win.
