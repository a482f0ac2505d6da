# %% [markdown]
# # Stochasticity: Golf
#
# **The challenge.** The same action does not always lead to the same result. An agent must learn from results that
# differ by chance, and decide how much risk it takes: is a good mean worth a bad day now and then?
#
# **You will be able to** say what Q-learning learns where results are random; change one line so that an agent avoids
# risk or seeks it; compute what such an agent learns; and find by hand, and then exactly, where a risk stops being
# worth it.
#
# **Time.** {time} **Before you start.** You should know what a value function and
# Q-learning are (Sutton and Barto, 2nd edition, sections 3.5 and 6.5), ε-greedy action selection (section 2.2), and
# what a normal distribution is. All symbols are in the [table of
# notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).

# %%
from typing import NamedTuple

import gymnasium as gym
import numpy as np

from edugym import EpsilonGreedy, QLearning, RiskSensitiveQLearning, repeat, table_size
from edugym.experiments.figures import Sheet
from edugym_course.lessons.stochasticity import drive, exact, figures, methods
from edugym_course.notebook import frames, play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: the harder the hit, the less it goes where it should
#
# A ball on the tee must get onto the green around the flag, in few hits. There are three swings: a putt goes 1 cell, a
# chip 4, a drive 10. Every hit aims at the flag and misses by chance: a little with a putt, a lot with a drive. Around
# the course is water.

# %%
env = gym.make("edugym/Golf-v0", observe_hits=True).unwrapped
env.reset(seed=10)
env.step(2)  # a drive
env.scene()

# %% [markdown]
# (The circle shows two standard deviations around the aim.) The flag is 13.5 cells from the tee, and the green has a
# radius of 2.1 cells. As a Markov decision process:
#
# | | | in words |
# |---|---|---|
# | states | the place of the ball, and the number of hits | the agent sees the hits, but only the *cell* of the ball |
# | actions | $\mathcal{A} = \{0, 1, 2\}$ | putt, chip, drive: $d$ = 1, 4, 10 cells |
# | dynamics | the ball flies $d$ cells towards the flag | to both coordinates normal noise is added, with the standard deviation $\ell d^2$ |
# | reward | $1 - (\text{hits} - 1)/10$ | on the green: 0.9 with two hits, 0.8 with three, ... |
# | | $-1$ | for a *lost ball*: it is in the water, or 10 hits were not enough |
# | | $0$ | for every other hit |
# | discount | $\gamma = 1$ | a game is short |
#
# The number $\ell$ is the *stochasticity level* (`stochasticity_level`), 0.015 in most of this lesson. A game
# *terminates* on the green, in the water, or after 10 hits. Its *return* is the sum of its rewards. These methods are
# the environment:

# %%
source(type(env.mdp), "aim", "transition", "reward", "terminal")

# %% [markdown]
# Here are a thousand balls of each swing from the tee. (The mark of their aim hides the putts.) The drive has a
# standard deviation of $0.015 \cdot 10^2 = 1.5$ cells, and the water is 3.5 cells to the left and right: 3.5/1.5 = 2.33
# standard deviations on each side. A normally distributed ball flies farther with probability 2.0 %.

# %%
display(figures.landings_figure())
for swing, name in enumerate(env.mdp.action_names):
    balls, _ = methods.landings(swing)
    _, lost = methods.landings(swing, balls=20_000)
    cells = {tuple(cell) for cell in np.floor(balls).astype(int) if 0 <= cell[0] < 7 and 0 <= cell[1] < 17}
    print(f"{name:5}: {lost:.1%} of 20 000 lost; on the course a thousand balls lie in {len(cells)} different cells")

# %% [markdown]
# **Play it yourself.** There are two plans. The fast one is a drive and a chip in either order: return 0.9, if all goes
# well. The safe one is three chips: 0.8. Play five games of each. Which do you like better?

# %%
play("Golf", observe_hits=True)

# %% [markdown]
# ## The idea: a value is a mean, and a mean hides the risk
#
# **Q-learning** keeps a table with a value $Q(s, a)$ for each action in each state. After every step from $S$ by $A$ to
# $S'$ with reward $R$ it computes the *TD error* $\delta$, which says how much better the step was than expected, and
# moves the value by the learning rate $\alpha$ (Sutton and Barto, equation 6.8):
#
# $$
# \delta = R + \gamma \max_a Q(S', a) - Q(S, A)
# \qquad\qquad
# Q(S, A) \leftarrow Q(S, A) + \alpha\, \delta
# $$
#
# After a terminal state there is no future, and $R$ stands alone in the place of $R + \gamma \max_a Q(S', a)$.

# %%
source(QLearning.learn)

# %% [markdown]
# What does this learn where the results differ by chance? The value rests where good and bad surprises balance: where
# the mean of $\delta$ is 0. There the value is the **mean** of the target $R + \gamma \max_a Q(S', a)$. With a fixed
# learning rate it is a mean in which recent results count more (equation 2.6): roughly the last $1/\alpha$ of them.
#
# So two plans with the same mean have the same value, even if only one of them sometimes loses the ball. The
# *spread* of the return is not in the table. In this lesson we call the standard deviation of the return its spread,
# and **risk** stands for results that are uncertain.
#
# ### Bad surprises may weigh more
# Multiply the TD error by a weight that depends on it (Delétang et al., 2021):
#
# $$
# Q(S, A) \leftarrow Q(S, A) + \alpha \cdot 2\sigma(\beta \delta) \cdot \delta,
# \qquad \sigma(x) = \frac{1}{1 + e^{-x}}
# $$
#
# This is **risk-sensitive Q-learning**, and $\beta$ is the attitude to risk. The function $\sigma$ grows from 0 to 1,
# and $\sigma(0)$ is 1/2. So the weight $2\sigma(\beta\delta)$ is between 0 and 2.
#
# | | a bad surprise, $\delta < 0$, weighs | a good surprise, $\delta > 0$, weighs | the agent |
# |---|---|---|---|
# | $\beta < 0$ | more than 1 | less than 1 | avoids risk: *averse* |
# | $\beta = 0$ | 1 | 1 | is Q-learning: *neutral* |
# | $\beta > 0$ | less than 1 | more than 1 | seeks risk: *seeking* |
#
# In the code $\beta$ is `self.risk`, and `one_step_target` is $R + \gamma \max_a Q(S', a)$, or $R$ after a terminal state.

# %%
source(RiskSensitiveQLearning.learn)

# %%
figures.weights_figure()

# %% [markdown]
# The weighted error on the right, times $\alpha$, is how far the value moves. Look at
# the averse agent: a good surprise of 2 moves its value less than one of 0.6. It hardly believes in great luck.
#
# ### What does it learn?
# Take a single step that ends, with a reward $R$ that is normally distributed. Then the value that is learned is
#
# $$
# \mathrm{E}[R] + \frac{\beta}{2}\, \mathrm{Var}[R]
# $$
#
# the mean, and for $\beta < 0$ a fine for the variance. (The aside below proves it.) Try it, with the mean 0.8 and the
# standard deviation 0.3:

# %%
for label, beta in methods.RISKS.items():
    learned = methods.learned_value(beta, lambda rng: rng.normal(0.8, 0.3))
    print(f"{label:15}: learned {learned:.3f}, by the formula {0.8 + beta / 2 * 0.3**2:.3f}")

# %% [markdown] tags=["aside"]
# ### Aside: why it is the mean and a share of the variance
# The value rests where $2\sigma(\beta\delta)\,\delta$ is 0 on average. We try the value above. Then $\delta$, which is
# $R$ less this value, is normal. Its mean is $-\frac{\beta}{2}\mathrm{Var}[R]$ and its variance $\mathrm{Var}[R]$, so
# its density is proportional to $e^{-(\delta + \beta \mathrm{Var}[R] / 2)^2 / (2 \mathrm{Var}[R])}$. Multiply the
# square out, and leave out the factor without $\delta$: the density is proportional to
# $e^{-\delta^2 / (2 \mathrm{Var}[R])} \cdot e^{-\beta\delta/2}$. Multiply it by the *weighted error*
# $2\sigma(\beta\delta)\delta$, and use
# $\sigma(\beta\delta)\, e^{-\beta\delta/2} = 1 / (e^{\beta\delta/2} + e^{-\beta\delta/2})$:
#
# $$
# \text{weighted error} \cdot \text{density} \;\propto\;
# \delta \cdot \frac{e^{-\delta^2 / (2 \mathrm{Var}[R])}}{e^{\beta\delta/2} + e^{-\beta\delta/2}}
# $$
#
# The fraction is the same for $\delta$ and $-\delta$. So each bad surprise cancels a good one, and the mean is 0.

# %% [markdown]
# ## The experiment: three players
#
# Three players learn the same game. They differ in $\beta$ only.
#
# | setting | value |
# |---|---|
# | all | tabular, $\alpha = 0.02$, $\gamma = 1$, $\varepsilon = 0.1$, all values start at 0, ties broken at random |
# | the game | $\ell = 0.015$; the agent sees the cell of the ball and the number of hits |
# | training | 300 000 steps, about 100 000 games |
# | evaluation | 20 greedy games every 30 000 steps; at the end every player plays 10 000 greedy steps |
# | repetitions | 30; bands, and the lines at the dots, are 95 % intervals |
#
# Two black lines, from the exact dynamics, show what is possible for a player who sees exactly where the ball lies: the
# optimum (dashed), and in the right panel the best *ε-soft* policy (dotted), which takes a random swing with
# probability $\varepsilon$.
#
# The cell below your prediction is the whole experiment. (Later cells call `methods.learn`, which does the same with
# other settings.)
#
# **Predict.** Which player has the highest *mean* return in the end, without exploring?

# %%
highest = predict(
    "The highest mean return has ...",
    ["the averse player", "the neutral player", "the seeking player", "neutral and seeking are level, within 0.02"],
)
highest

# %%
settings = {"learning_rate": 0.02, "discount": 1.0, "exploration": EpsilonGreedy(0.1)}
agents = {
    "averse, β = -2": lambda golf: RiskSensitiveQLearning.create(golf, risk=-2.0, **settings),
    "neutral, β = 0": lambda golf: RiskSensitiveQLearning.create(golf, risk=0.0, **settings),
    "seeking, β = 2": lambda golf: RiskSensitiveQLearning.create(golf, risk=2.0, **settings),
}
game = {"stochasticity_level": 0.015, "observe_hits": True}
curve = {"evaluate_every": 30_000, "evaluation_episodes": 20}
results = repeat("Golf", agents, 300_000, parameters=game, repetitions=30, **curve)
played = methods.play(results)
display(figures.learning_curves(results))
display(figures.outcomes(played))
for label, one in played.items():
    print(f"{label:15}: mean {one.mean.mean():.3f}, spread {one.spread.mean():.3f}, lost {one.lost.mean():.2%}")
for label, swings in methods.by_first_swing(results, played).items():
    for swing, (runs, mean, lost) in swings.items():
        print(f"{label:15}: {runs:2} of 30 runs start with a {swing:5}: mean {mean:.3f}, lost {lost:.1%}")
means = {label.split(",")[0]: one.mean.mean() for label, one in played.items()}
lead = means["seeking"] - means["neutral"]
if means["averse"] > max(means["neutral"], means["seeking"]):
    seen = "the averse player"
elif abs(lead) < 0.02:
    seen = "neutral and seeking are level, within 0.02"
else:
    seen = "the seeking player" if lead > 0 else "the neutral player"
highest.measured(seen)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Neutral and seeking are level, near 0.82, and the averse player earns about 0.06 less. The other two panels
# differ more: the averse player loses hardly a ball, the neutral one about 1 in 100, and the
# seeking one about 3 in 100; the spread grows from less than 0.05 to more than 0.3. So $\beta = 2$ did not pay here.
#
# *Seeking.* The order of the swings matters. Runs that drive first earn 0.86. But half of the runs chip first and
# drive then, from closer to the far edge. They lose more than twice as many balls, and earn 0.78.
#
# *Averse.* Of its runs, 8 of 30 have learned to start with a putt, which wastes a hit: 0.70. The others earn 0.78, and
# a player who follows a rule and never drives earns 0.79 (exercise 2).
#
# *Neutral.* Played without a mistake, the fast plan earns 0.87. But only 11 of the 30 neutral runs start with a drive;
# most of the others play the safe plan. So the neutral mean is 0.82, only 0.06 more than that of the averse player. The section
# "What noise does to learning" asks why.
# </details>

# %% [markdown]
# Watch one game of the averse player, and one of the seeking player.

# %%
frames("Golf", results.agents[methods.AVERSE][0], seed=1, observe_hits=True)

# %%
frames("Golf", results.agents[methods.SEEKING][0], seed=1, observe_hits=True)

# %% [markdown]
# ## Your turn
#
# Move a slider and release it: the experiment is computed again, with 10 repetitions of 100 000 steps. The three players
# have $-\beta$, 0 and $\beta$. Up to which level $\ell$ do all three play alike? What does a larger $\beta$ do to the two
# outer players?


# %%
def three_players(beta=2.0, level=0.015, epsilon=0.1, alpha=0.02, gamma=1.0):
    """Draw how an averse, a neutral and a seeking player learn and play one game."""
    trained = methods.learn(
        level=level,
        risks=methods.attitudes(beta),
        epsilon=epsilon,
        learning_rate=alpha,
        discount=gamma,
        n_steps=100_000,
        repetitions=10,
    )
    return figures.slider_figure(trained, methods.play(trained, level=level), level, epsilon)


sliders(
    three_players,
    beta=(0.5, 5.0, 0.5),
    level=(0.0, 0.03, 0.0025),
    epsilon=(0.0, 0.5, 0.01),
    alpha=(0.01, 1.0, 0.01),
    gamma=(0.5, 1.0, 0.01),
)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# Up to about 0.0075 all three play alike. With $\beta = 5$ the averse player falls to 0.66, and the seeking player
# gains nothing.
# </details>

# %% [markdown]
# ## See inside: where a risk stops being worth it
#
# ### By hand
# When is the drive worth its risk, on average? It saves one hit: the fast plan returns 0.9, and the safe plan 0.8. With
# some probability $p$ it loses the ball, which returns −1 and so costs 1.9. The two are equal where
#
# $$
# 0.9 - 1.9 \cdot p = 0.8 \quad\Rightarrow\quad p \approx 0.053
# $$
#
# Both sides together have the probability 0.053 if 3.5 cells are 1.94 standard deviations, by a table of the normal
# distribution. The standard deviation of a drive is $\ell \cdot 10^2$:
#
# $$
# \frac{3.5}{100\, \ell} \approx 1.94 \quad\Rightarrow\quad \ell \approx 0.0180
# $$
#
# That takes for granted that both plans do what they should. The exact dynamics can tell.
#
# **Predict.** From which level on is a chip from the tee worth more than a drive, exactly, on average?

# %%
change = predict("The chip is worth more from level ... on", unit="(from 0.005 to 0.025)")
change

# %%
lines = figures.crossing_lines()
display(Sheet("crossing", [[lines]]))
worth = exact.from_the_tee(0.015)
print("at level 0.015:", ", ".join(f"{swing} {worth[swing]:.3f}" for swing in ("drive", "chip")))
change.measured(lines.change)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** 0.0187, so the estimate was close. Both lines are computed for a player who sees where the ball lies and
# plays as well as possible after the first swing. (The computation knows places an eighth of a cell apart; its errors
# are below 0.002.) Below the crossing the risk of the drive pays on average; above it, it does not. At 0.015 the drive
# is ahead by 0.07. (With very little noise both are worth 0.9, since a chip and *then* a drive also takes two hits.
# With a little noise the drive is worth more than 0.9, since some drives land on the green at once.)
# </details>

# %% [markdown]
# ### The attitude moves the crossing
# The same computation can be done for risk-sensitive Q-learning. The value of a swing is then not the mean of what
# follows, but the number at which good and bad surprises balance after they are weighted. The figure shows how much more
# the drive is worth than the chip. Above 0 a player should drive.

# %%
attitudes = figures.crossing_by_attitude()
display(Sheet("attitudes", [[attitudes]]))
between = {
    methods.AVERSE: (0.015, 0.018),
    methods.NEUTRAL: (0.018, 0.02),
    methods.SEEKING: (0.04, 0.06),
}
for label, (low, high) in between.items():
    last = exact.crossing(low, high, cell=0.25, risk=methods.RISKS[label])  # places a quarter of a cell apart
    print(f"{label:15}: drives up to about level {last:.3f}")

# %% [markdown]
# Risk sensitivity *moves the level* at which a player stops taking the risk. The averse one stops near 0.016, the
# neutral one near 0.019, and the seeking one only near 0.051, far to the right of the figure. (On the left, where
# there is little noise, the averse player drives too. There a chip first would be no safer: the best way to go on is then a drive, which
# ends closer to the far edge.)
#
# At level 0.015, by this figure, even the averse player should drive, and in the experiment it did not. "What noise does
# to learning" comes back to that.

# %% [markdown]
# ## Predict, then check
#
# ### Too much noise
# The experiment again, at six levels, with 10 repetitions. (So the dots at 0.015 differ a little.)
#
# **Predict.** Raise the level to 0.02. Which of the three players differ there in the share of lost balls?

# %%
noisy = predict(
    "At level 0.02 ...",
    [
        "all three differ, as before",
        "averse and neutral lose equally few, seeking loses more",
        "neutral and seeking lose equally many, averse loses fewer",
        "all three lose the same",
    ],
)
noisy

# %%
earned, lost = figures.against_level(repetitions=10)
display(Sheet("levels", [[earned, lost]]))
at = lost.x.index(0.02)
shares = {label.split(",")[0]: float(np.mean(rows[at])) for label, rows in lost.measured.items()}
print("lost at level 0.02:", ", ".join(f"{label} {share:.2%}" for label, share in shares.items()))
print("mean at level 0.02:", ", ".join(f"{label} {np.mean(rows[at]):.3f}" for label, rows in earned.measured.items()))
low = shares["neutral"] - shares["averse"] < 0.005
high = shares["seeking"] - shares["neutral"] < 0.005
if low and high:
    seen = "all three lose the same"
elif low:
    seen = "averse and neutral lose equally few, seeking loses more"
elif high:
    seen = "neutral and seeking lose equally many, averse loses fewer"
else:
    seen = "all three differ, as before"
noisy.measured(seen)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Averse and neutral lose hardly a ball, and seeking loses about one in ten. Beyond the crossing at 0.0187
# the safe plan is also the best one on average. (Just below it, too, the neutral player seldom takes the risk.) At 0.02
# seeking earns least of the three, 0.68, and neutral most, 0.76. (Averse is between them, with wide bands.)
# </details>

# %% [markdown]
# ### What noise does to learning
# The paper (Moerland et al., 2023) says that noise slows learning. The mean return shows it only in part, as the first 1 000 steps bring most of the
# way to the optimum, with noise and without. So we also ask how many runs are *near* the optimum, within 0.01.

# %%
for level in (0.0, 0.015):
    for n_steps in (1_000, 30_000, 300_000):
        runs = methods.learn(level=level, risks=methods.NEUTRAL_ONLY, n_steps=n_steps)
        mean = methods.play(runs, level=level)[methods.NEUTRAL].mean.mean()
        print(
            f"level {level:5g}, after {n_steps:6} steps: mean return {mean:.2f} of {exact.optimum(level):.2f},"
            f" {drive.near_optimum(runs, level).mean():4.0%} of 30 runs are near"
        )

# %% [markdown]
# So noise slows learning: with it fewer runs are near the optimum after 300 000 steps than without it after 1 000.
#
# **Predict.** After 300 000 steps the neutral player earns about 0.82, and the optimum is 0.868. What keeps it from the
# optimum?

# %%
obstacle = predict(
    "The neutral player falls short since ...",
    [
        "it sees the cell of the ball only, not the exact place",
        "it believes that a drive is worth less than it is",
        "it fears a lost ball more than it costs",
    ],
)
obstacle

# %%
by_rule = methods.play_by_rules()["drive from 8 to 20 cells, chip beyond 2.8"]
print(f"a player with a rule, who also sees the cell only: mean return {by_rule[0]:.3f}")
believed = methods.values_on_the_tee(results)
for label in methods.RISKS:
    print(f"{label:15}: believes on the tee: chip {believed[label][1]:.3f}, drive {believed[label][2]:.3f}")
print(f"{'exact, averse':15}: drive {exact.from_the_tee(0.015, 0.25, risk=-2.0)['drive']:.3f}")
print(f"{'exact, neutral':15}: chip {worth['chip']:.3f}, drive {worth['drive']:.3f}")
too_low = worth["drive"] - believed[methods.NEUTRAL][2]
unseen = worth["drive"] - by_rule[0]
obstacle.measured(
    "it believes that a drive is worth less than it is"
    if too_low > 0.05 > unseen
    else "it sees the cell of the ball only, not the exact place"
)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** It believes that a drive is worth less than it is: about 0.75 instead of 0.87. A player that follows a
# simple rule sees the cell only, and gets 0.865, nearly the optimum, so that is not the obstacle. Nor does it
# fear lost balls more than it should: with $\beta = 0$ all errors weigh 1, and a lost ball counts for what it costs.
# </details>

# %% [markdown]
# Why is the value too low? There are two suspects.
#
# - *Bad luck.* Exactly, the drive is ahead by 0.07 only. A lost ball moves its value by $\alpha \cdot 1.9 \approx 0.04$,
#   so after two of them, close to each other, the chip looks better. From then on the drive is tried in 3 % of the
#   games, when the agent explores.
# - *The rest of the game.* After a chip from the tee the ball lies in one of 6 cells, and after a drive in one of more
#   than 50 (they were counted at the start). Each of those is visited rarely, and its values started at 0, far below
#   what they are worth.
#
# To find out, we take each of them away. Against bad luck the steps are a quarter as large, $\alpha = 0.005$. For the
# rest of the game the agent chooses the *first swing only*, and then a rule chips and putts.
#
# **Predict.** As it is, about a third of the runs start with a drive. Which change brings more runs to the drive?

# %%
cause = predict(
    "More runs start with a drive ...",
    ["with smaller steps, so with less bad luck", "with the rest of the game known", "both changes bring as many"],
)
cause

# %%
starts = {label: runs.mean() for label, runs in drive.without_causes().items()}
for label, share in starts.items():
    print(f"{label:26}: {share:.0%} of 30 runs start with a drive")
more = starts[drive.REST_KNOWN] - starts[drive.NO_BAD_LUCK]
larger = "with the rest of the game known" if more > 0 else "with smaller steps, so with less bad luck"
cause.measured("both changes bring as many" if abs(more) < 0.1 else larger)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** With the rest of the game known, by far. Smaller steps alone bring few (with them rare cells rise from 0 more slowly, too); once the rest is known, they
# bring the last runs too.
#
# The averse player is farther off still: it believes 0.33, where 0.83 would be right for it.
# </details>

# %% [markdown]
# What can an agent do that has nobody to play the rest of the game? Its values can start at 1, so that what was not
# tried looks good; it can take smaller steps, $\alpha = 0.005$, and train ten times as long. We call this neutral
# player *patient* (10 repetitions here). A run *takes the risk* if it loses more than 1 ball in 100, wherever it drives from.

# %%
patient = methods.play(methods.patient())[methods.NEUTRAL]
not_longer = methods.play(methods.patient(n_steps=300_000))[methods.NEUTRAL]
players = {"as in the experiment": played[methods.NEUTRAL], "patient": patient, "patient, but not longer": not_longer}
for label, one in players.items():
    drivers = methods.share_of_drivers(one)
    print(f"neutral, {label:23}: mean return {one.mean.mean():.3f}, {drivers:.0%} of the runs take the risk")

# %% [markdown]
# All patient runs take the risk, and their mean is nearly the optimum. Without the longer training it is lower.

# %% [markdown] tags=["aside"]
# ### Aside: "Risk-seeking pays"?
# In the paper's game (Moerland et al., 2023) the agent does not see its hits: the same row of the table serves for the
# first hit and the ninth. (We take 100 repetitions here, since a few runs are far from the others.)
#
# **Predict.** Hide the hits. Is the mean return of the seeking player higher than that of the neutral one?

# %%
pays = predict(
    "Where the hits are hidden, the seeking player earns ...",
    ["more than the neutral one", "less than the neutral one", "the same, within 0.01"],
)
pays

# %%
two = {label: methods.RISKS[label] for label in (methods.NEUTRAL, methods.SEEKING)}
hidden = methods.play(methods.learn(observe_hits=False, risks=two, repetitions=100), observe_hits=False)
lead = methods.lead(hidden[methods.SEEKING], over=hidden[methods.NEUTRAL])
print(
    f"mean return, seeking less neutral, hits hidden: {lead.estimate:+.3f} (95 %: {lead.low:+.3f} to {lead.high:+.3f})"
)
more = "more than the neutral one" if lead.estimate > 0 else "less than the neutral one"
pays.measured("the same, within 0.01" if abs(lead.estimate) < 0.01 else more)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** More: about 0.05.
# </details>

# %% [markdown]
# So does risk-seeking pay? Before we believe it, we compare the two where the hits are seen, at a level at which the
# drive is *not* the best swing, and, at 0.015, against the patient player (3 000 000 steps, 10 repetitions).

# %%
noisier = methods.play(methods.learn(level=0.02, risks=two), level=0.02)
long = methods.play(methods.learn(n_steps=3_000_000, repetitions=10, risks=two))
for condition, players in {
    "hits hidden": hidden,
    "hits seen": played,
    "hits seen, level 0.02": noisier,
    "hits seen, ten times as long": long,
    "the same, against the patient": {**long, methods.NEUTRAL: patient},
}.items():
    lead = methods.lead(players[methods.SEEKING], over=players[methods.NEUTRAL])
    drivers = methods.share_of_drivers(players[methods.NEUTRAL])
    print(f"{condition:29}: seeking less neutral {lead.estimate:+.3f} ({lead.low:+.3f} to {lead.high:+.3f}),", end=" ")
    print(f"{drivers:4.0%} of the neutral runs take the risk")

# %% [markdown]
# - At level 0.015 the drive *is* the best swing on average, and many neutral learners avoid it. With $\beta = 2$ an agent is
#   pushed towards the drive.
# - Where the hits are seen the seeking player leads only after ten times the training, by 0.03. Against the patient player, who is neutral and drives, the lead is gone.
# - At level 0.02, where the drive is not the best swing, the same $\beta = 2$ costs dearly.
#
# So risk-seeking does not pay as such: a player who knew the true values could never gain by it. We think that it
# can make up for another fault.

# %% [markdown] tags=["aside"]
# ### Aside: is risk the variance?
# The formula of the section "The idea" has the variance in it. Now take two lotteries with the same mean, 0, and the
# same variance, 0.36. The first mostly wins a little and rarely loses much. The second is its mirror image.
#
# | | with probability 0.9 | with probability 0.1 |
# |---|---|---|
# | a rare loss | +0.2 | −1.8 |
# | a rare win | −0.2 | +1.8 |
#
# **Predict.** Which of them has the higher value for an averse agent, $\beta = -2$?

# %%
lotteries = predict(
    "The averse agent values ...", ["the rare loss higher", "the rare win higher", "both equally, within 0.02"]
)
lotteries

# %%
values = {}
for name, sign in (("the rare loss", 1), ("the rare win", -1)):
    rewards, chances = [sign * 0.2, sign * -1.8], [0.9, 0.1]
    values[name] = exact.certain_value(rewards, chances, risk=-2.0)
    learned = methods.learned_value(-2.0, lambda rng, r=rewards, p=chances: rng.choice(r, p=p))
    print(f"{name:13}: exact {values[name]:.3f}, learned {learned:.3f}")
print(f"the formula for normal rewards gives both: {-2.0 / 2 * 0.36:.3f}")
difference = values["the rare win"] - values["the rare loss"]
higher = "the rare win higher" if difference > 0 else "the rare loss higher"
lotteries.measured("both equally, within 0.02" if abs(difference) < 0.02 else higher)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** The rare win higher: −0.19, and the rare loss −0.46. The formula would give both −0.36. A large loss has
# a weight of nearly 2, and a large win a weight of nearly 0, so this agent fears rare disasters more than it minds a
# spread. The formula is exact for normal rewards only. (What was learned for the rare loss is a little lower than the
# exact number: a value that jumps with every loss does not rest at one place. With a smaller learning rate it comes
# closer: over 400 learners the mean was −0.52 at $\alpha = 0.02$ and −0.46 at $\alpha = 0.001$.)
#
# There is a second difference. $\beta$ weighs every *single TD error* as it comes, and no one looks at the return of the
# whole game. So "risk" here means surprises, one by one, and not the variance of the return.
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: the learning rate, on another slippery ground
# FrozenLake is an environment of Gymnasium. The agent walks over a frozen lake of 4 by 4 cells to a goal, which pays 1.
# In some cells the ice has a hole, and a fall ends the episode without a reward. If the lake is *slippery*, the agent
# goes where it wants with probability 1/3 only, and else to one of the two sides. (The settings: Q-learning, $\gamma =
# 0.99$, $\varepsilon = 0.1$, values start at 1, 10 000 steps, 5 000 on the lake that is not slippery, 6 repetitions.
# The dashed line on the right is the best probability to arrive within the 100 steps of an episode. The colours stand
# for learning rates here.)
#
# **Predict.** On the lake that is not slippery, no learning rate is faster than $\alpha = 1$. What about the slippery
# lake?

# %%
rate = predict(
    "On the slippery lake, α = 1 ...",
    ["is the best again", "is as good as the smaller rates", "hardly ever arrives"],
)
rate

# %%
dry = methods.compare_on_lake(slippery=False, n_steps=5_000)
icy = methods.compare_on_lake(slippery=True)
display(figures.lake_figure(dry, icy, methods.lake_optimum()))
late = {method: float(icy.curves(method).iloc[-5:].to_numpy(float).mean()) for method in icy.methods}
print("slippery, mean return of the last five evaluations:", ", ".join(f"{m}: {r:.2f}" for m, r in late.items()))
others = [late[method] for method in ("α = 0.3", "α = 0.05")]
if late["α = 1"] < 0.2:
    seen = "hardly ever arrives"
else:
    seen = "is the best again" if late["α = 1"] > max(others) else "is as good as the smaller rates"
rate.measured(seen)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** It hardly ever arrives. (The bands are wide, as there are 6 runs only.) With $\alpha = 1$ a value is the
# *last* target, and not a mean. Where nothing is random, the last target is the best one. On slippery ice it is one
# draw of a lottery. A learning rate below 1 takes a mean, and that takes
# time: on the lake that is not slippery the curve of $\alpha = 0.05$ rises last.
# </details>

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for your answer, and below it a cell that checks it. The check does not only say whether an
# answer is right: it says what was expected, what came, and which mistake that looks like. It runs your code on cases
# that it makes up.

# %%
from edugym_course.grading import check
from edugym_course.lessons.stochasticity.exercises import CHALLENGE, exercise_1, exercise_2, exercise_3

# %% [markdown]
# ### Exercise 1: change a parameter
# Allow 5 hits instead of 10 (`max_hits=5`). Then each hit more costs 0.2 instead of 0.1: the fast plan returns 0.8, and the safe plan
# 0.6. Up to which level is the drive from the tee worth at least as much as the chip now? Set `level` to that number,
# rounded to four decimals. Before you compute: what does the estimate by hand say?
# (`from statistics import NormalDist`; `-NormalDist().inv_cdf(p / 2)` gives the number of standard deviations; each
# side has half of the probability.)
#
# <details><summary>Hint</summary><code>exact.from_the_tee(0.015, max_hits=5)</code> gives the exact worth of each
# swing from the tee at level 0.015, as a dictionary: <code>["drive"]</code> and <code>["chip"]</code> are its entries.
# Leave out the <code>cell=0.25</code> of "The attitude moves the crossing", which is faster but too coarse for four decimals. Try some
# levels, or write a loop that starts at 0.01 (a level of 0 is not allowed).</details>

# %%
level = 0.0187  # with 10 hits
### BEGIN SOLUTION
highest_level = 0.03
# own: highest_level = 0.05
while highest_level - level > 0.00001:
    middle = (level + highest_level) / 2
    swings = exact.from_the_tee(middle, max_hits=5)
    # own: swings = exact.from_the_tee(middle, max_hits=5, epsilon={careless})
    if swings["drive"] > swings["chip"]:
        level = middle
    else:
        highest_level = middle
level = round(level, 4)
### END SOLUTION

# %% tags=["check"]
check(exercise_1, level)

# %% [markdown]
# ### Exercise 2: which players are worth choosing?
# How much risk is right? That is a matter of taste, but some players are wrong for every taste. Say that one player
# *beats* another if its mean return is not lower, its spread is not larger, and at least one of the two is really
# better. The players that nobody beats are the *frontier*: to choose between them you need a taste.
#
# Write a function that is given some players, a dictionary from a name to a pair (mean, spread), and returns a list of
# the names on the frontier, in any order. Two players with the same two numbers do not beat each other.
#
# Below the check your function runs on players that follow simple rules ("drive if the flag is farther away than ..."),
# and the players of the experiment are drawn beside its frontier.
#
# <details><summary>Hint</summary>Two loops, one in the other: for each player, look for another one that beats it.
# <code>for name, (mean, spread) in players.items()</code> gives the three.</details>


# %%
def frontier(players):
    """Return the names of the players that no other one beats; `players` maps names to (mean, spread)."""
    ### BEGIN SOLUTION
    best = []
    for name, (mean, spread) in players.items():
        beaten = any(
            other_mean >= mean and other_spread <= spread and (other_mean > mean or other_spread < spread)
            for other_mean, other_spread in players.values()
        )
        if not beaten:
            # own: if not beaten and mean >= {least}:
            best.append(name)
    return best
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_2, frontier)
### BEGIN HIDDEN TESTS
check(exercise_2, frontier, seed=1, quiet=True)
### END HIDDEN TESTS
rules = methods.play_by_rules()
display(Sheet("frontier", [[figures.frontier_figure(rules, frontier(rules), played)]]))
for name in frontier(rules):
    print(f"{name}: mean {rules[name][0]:.4f}, spread {rules[name][1]:.4f}")
for name in ("drive from 5 to 20 cells, chip beyond 2.8", "no drive, chip beyond 6"):
    print(f"beaten: {name}: mean {rules[name][0]:.4f}, spread {rules[name][1]:.4f}")

# %% [markdown]
# <details><summary>What the figure shows</summary>
#
# The frontier leads from the safe plan, without drives, to the fast plan. Between them are players that throw a coin
# before each game and play the one or the other. (Two of the rules with drives are nearly the same: they differ by less
# than the error of the simulation.) The last two lines print two rules that are far off: one still drives when the flag
# is 5 cells away, the other putts when it could chip. (The first of them lies outside the panel, to the right.) One
# player on the frontier lies below the panel: the one that only putts. It loses every game, as 10 putts are not enough,
# and so its spread is 0: a small spread alone is not safety.
#
# The averse player of the experiment is close to the safe end, but below it, as 8 of its 30 runs start with a putt. The
# seeking one is beaten by the fast plan, in both numbers. The neutral one is near the frontier, between the ends, like
# a player with a coin: some of its 30 runs drive and others do not. (It is a little above the line, since its spread is
# a mean over runs, and not the spread of a mixture.)
# </details>

# %% [markdown]
# ### Exercise 3: two weights
# An older rule has two weights only (Mihatsch and Neuneier, 2002). Good surprises
# weigh $1 - \kappa$ and bad ones $1 + \kappa$, whatever their size, with a number $\kappa$ between −1 and 1:
#
# $$
# Q(S, A) \leftarrow Q(S, A) + \alpha\, w\, \delta,
# \qquad w = \begin{cases} 1 - \kappa & \text{if } \delta > 0 \\ 1 + \kappa & \text{otherwise} \end{cases}
# $$
#
# Mind the sign: $\kappa > 0$ avoids risk, as $\beta < 0$ does. Write the `learn` of this agent. The TD error $\delta$ is
# that of Q-learning, with no future after a terminal state. Read the numbers from `self`: `self.learning_rate` is
# $\alpha$, `self.discount` is $\gamma$, `self.kappa` is $\kappa$.
#
# The race below shows your agent with $\kappa = 0.5$ and with $\kappa = -0.5$, beside the three players of the
# experiment. Before you run the check: which of the three will each of them be like?
#
# <details><summary>Hint</summary>Compute <code>delta</code> first, then the weight, and then change
# <code>self.Q[state, action]</code>. The largest value of the next state is <code>max(self.Q[next_state])</code>.
# </details>


# %%
class TwoWeights(NamedTuple):
    """Q-learning in which good surprises weigh 1 - κ and bad ones 1 + κ."""

    Q: np.ndarray  # shape (n_states, n_actions)
    learning_rate: float = 0.02
    discount: float = 1.0
    epsilon: float = 0.1
    kappa: float = 0.5

    @classmethod
    def create(cls, environment, **settings):
        """Make a new agent for an environment: all values are 0."""
        return cls(np.zeros(table_size(environment)), **settings)

    def greedy(self, state, rng):
        """Choose the action with the highest value; among equals, one at random."""
        best, equals = 0, 1
        for action in range(1, self.Q.shape[1]):
            if self.Q[state, action] > self.Q[state, best]:
                best, equals = action, 1
            elif self.Q[state, action] == self.Q[state, best]:
                equals += 1
                if rng.random() * equals < 1.0:
                    best = action
        return best

    def act(self, state, rng):
        """Choose a random action with probability ε, else the best one."""
        if rng.random() < self.epsilon:
            return int(rng.random() * self.Q.shape[1])
        return self.greedy(state, rng)

    def learn(self, state, action, reward, next_state, terminated):
        """Learn from one transition."""
        ### BEGIN SOLUTION
        value = 0.0 if terminated else max(self.Q[next_state])
        delta = reward + self.discount * value - self.Q[state, action]
        # own: delta = reward - {cost} + self.discount * value - self.Q[state, action]
        weight = 1.0 - self.kappa if delta > 0.0 else 1.0 + self.kappa
        self.Q[state, action] += self.learning_rate * weight * delta
        ### END SOLUTION


# %% tags=["check"] points=3
check(exercise_3, TwoWeights)
### BEGIN HIDDEN TESTS
check(exercise_3, TwoWeights, seed=1, quiet=True)
### END HIDDEN TESTS
display(
    figures.race(
        {
            "κ = 0.5": lambda game: TwoWeights.create(game, kappa=0.5),
            "κ = -0.5": lambda game: TwoWeights.create(game, kappa=-0.5),
        },
        played,
    )
)

# %% [markdown]
# <details><summary>What the race shows</summary>
#
# With $\kappa = 0.5$ your agent plays much like the averse player, and with $\kappa = -0.5$ it takes more
# risk than the neutral one: other weights, the same idea. $\kappa = -0.5$ also has the highest mean of the five. Many
# neutral learners are too careful at this level, so a push can help. $\beta = 2$ leaves half of its runs at the worse
# order. With $\kappa = -0.5$, 23 of 30 runs drive first.
#
# Try it where the drive is not the best swing: give `race` an empty dictionary instead of `played`, and `level=0.02`,
# and add agents with $\kappa = 0$ (Q-learning) and $\kappa = -0.9$. In our 30 runs $\kappa = -0.5$ earned no more than
# $\kappa = 0$ there, 0.76, and lost 2 % of its balls for nothing. $\kappa = -0.9$ lost 9 %, and earned only 0.72: a
# lost ball weighs so little with it that it drives all the same.
# </details>

# %% [markdown]
# ### The open challenge: every game counts
# The same game, $\ell = 0.015$, and 5 000 steps in all, about 1 600 games. This time *all* training games count, with
# every lost ball: how much does your agent earn while it learns? Of the task it is told only its observation space and
# its action space. It needs `act` and `learn`, like yours of exercise 3, and it may explore as it likes. It is trained
# ten times, with seeds that belong to your name.
#
# The best expected return is 0.868. Your points are your mean return divided by that, in percent. The agent below is the
# one to beat. (The "return at the end" is a mean over few games, so by luck it can be above 0.868.)
#
# Write half a page about your agent. What does it do about rare places, about chance, and about exploring? What would you change for a level of 0.02?


# %%
def my_agent(game):
    """Make the agent for the challenge; put your own in its place."""
    return QLearning.create(game, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.02))


CHALLENGE.score(my_agent, "Ada Lovelace")

# %% [markdown]
# ### From a blank file
# Now write it all yourself, from an empty cell, with NumPy and Gymnasium only: a learner that avoids risk, and its
# loop, some 35 lines. It moves $Q(S, A)$ by $\alpha \, 2\sigma(\beta \delta) \, \delta$, with the TD error $\delta =
# R + \gamma \max_a Q(S', a) - Q(S, A)$ and $\sigma(x) = 1 / (1 + e^{-x})$. Where `terminated` is True, the target is $R$
# alone; the target of a truncated step has the value of $S'$, as that of any other.
#
# **What it must do.** `my_program(environment, n_steps, seed)` takes `n_steps` steps in a Gymnasium environment, episode after
# episode, and learns from each of them at once. In the end it returns its *policy*: a function that takes a state and returns the
# action with the highest value. All else is up to you: functions, classes, any names, and how ties are broken.
#
# - States and actions are whole numbers from 0. `environment.observation_space.n` and `environment.action_space.n` say how
#   many there are. They differ from one environment to the next.
# - Take $\alpha = 0.4$, $\beta = -0.5$, $\gamma = 0.9$, $\varepsilon = 0.1$ (a random action is any of all $n$) and first values of 0.
# - Draw all random numbers from `np.random.default_rng(seed)`, and give the seed to the first `reset` alone.
#
# The check runs your program in small worlds of its own and at a fork, where one way pays a sure 1 and the other
# throws a coin for 5 or −2. It sees the steps that your program takes, and no line of it. So the mistake that it names
# is only the likely one.

# %% tags=["project"]
my_program = ...  # your program
### BEGIN PROGRAM


def choose_action(values, epsilon, rng):
    """Return an action by ε-greedy, ties broken at random."""
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return rng.choice(np.flatnonzero(values == values.max()))


def my_program(environment, n_steps, seed):
    """Learn by risk-sensitive Q-learning for `n_steps` steps, and return the greedy policy."""
    alpha, beta, gamma, epsilon = 0.4, -0.5, 0.9, 0.1
    rng = np.random.default_rng(seed)
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    state, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        action = choose_action(Q[state], epsilon, rng)
        next_state, reward, terminated, truncated, _ = environment.step(action)
        target = reward if terminated else reward + gamma * Q[next_state].max()
        delta = target - Q[state, action]
        weight = 2 / (1 + np.exp(-beta * delta))
        Q[state, action] += alpha * weight * delta
        state = next_state
        if terminated or truncated:
            state, _ = environment.reset()
    return lambda state: choose_action(Q[state], 0.0, rng)


### END PROGRAM

# %% tags=["project"]
from edugym_course.lessons.stochasticity.project import project_8

check(project_8, my_program)

# %% [markdown]
# ## What you saw
#
# ### In one paragraph
# *Learn it by heart, or better, say it in your own words.* Where results differ by chance, a value is a mean over many
# of them, and so to get it right takes many visits, and small steps. A mean does not tell how far
# the results lie apart. Risk-sensitive Q-learning weighs bad surprises more (or less) than good ones, which for normal
# rewards adds $\beta/2$ times the variance to the mean. So it moves the point at which a risk stops being worth taking.
# Safety can have a price in the mean. No risk-seeker earns more on average than the best neutral player; it can
# beat a neutral *learner* that has another fault.
#
# ### Limits
# $\beta$ weighs single TD errors, not returns: for rewards that are not normal its value is not mean and variance, and
# there is no simple formula for it. What it means depends on the size of the rewards: double them, and $\beta$ must be
# halved. Learning to avoid risk does not make *learning* safe. And
# a mean and a spread are not the whole distribution: distributional methods learn all of it.
#
# ### Further reading
# - Moerland et al. (2023), *EduGym: An environment and notebook suite for reinforcement learning education*: the
#   paper.
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 2.4 and 2.5 (means, and fixed learning rates), 2.6
#   (optimistic initial values), 6.7 (why the largest of noisy values is too large, a question this lesson leaves out).
# - Delétang et al. (2021), *Model-free risk-sensitive reinforcement learning*: the rule of this lesson.
# - Mihatsch and Neuneier (2002), *Risk-sensitive reinforcement learning*: the rule of exercise 3.
# - García and Fernández (2015), *A comprehensive survey on safe reinforcement learning*.
# - Bellemare, Dabney and Munos (2017), *A distributional perspective on reinforcement learning*.
# - Denrell and March (2001), *Adaptation as information restriction: the hot stove effect*: why learners who avoid
#   what went badly once are too careful.
