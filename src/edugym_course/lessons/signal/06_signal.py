# %% [markdown]
# # The amount of signal: Tamagotchi
#
# **The challenge.** An agent can only act on what it is told. When the message about the state is noisy, ambiguous or
# long, how much of it can the agent use, and what can it use instead?
#
# **You will be able to** measure in bits how much a message tells about the right action; say why the same number of
# bits can be worth a lot to one player and nothing to another; explain why longer messages carry more and are harder
# to learn from; and write a player that joins its message with its memory.
#
# **Time.** {time} **Before you start.** You should know what a value function and
# Q-learning are (Sutton and Barto, 2nd edition, sections 3.5 and 6.5), and ε-greedy action selection (section 2.2).
# All symbols are in the [table of notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).

# %%
import math
from typing import NamedTuple

import gymnasium as gym
import numpy as np

from edugym import EpsilonGreedy, QLearning, repeat
from edugym.envs.tamagotchi import happiness
from edugym.experiments.figures import Sheet
from edugym_course.lessons.signal import figures, methods, moody, pictures
from edugym_course.lessons.signal.players import Coin, RoundRobin, Voter
from edugym_course.lessons.signal.words import bits, information, joint_table
from edugym_course.notebook import frames, play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: a toy that says what it needs
#
# A toy has four needs: to play, to sleep, to be fed, and to be cleaned. At every step it *wants* the most urgent one.
# You press one of four buttons. If it is the wrong one, the toy suffers.

# %%
env = gym.make("edugym/Tamagotchi-v0", tau=0.1, max_msg_length=4).unwrapped
env.reset(seed=3)
for action in (0, 2):  # play, feed
    env.step(action)
env.scene()

# %% [markdown]
# You see the hit points (HP), and the words that the toy says. You do not see how the toy really is:
#
# - The **state** $s$ is how the toy really is. It decides what happens next.
# - The **observation** $o$ is what the agent is told about it: the hit points and the message.
#
# | | | in words |
# |---|---|---|
# | states | four variables $v_i$ from 0 to 100, the hit points, the wanted action, the message | hidden, except for the hit points and the message; all variables start at 100 |
# | observations | $o$ = (hit points, message) | a message has $L$ words, and there are $H$ different words |
# | actions | $\mathcal{A} = \{0, 1, 2, 3\}$ | play, sleep, feed, clean |
# | dynamics | $v_a$ grows by 30, each other $v_i$ falls by 5 | action $a$ meets need $a$; in the end all are cut off at 0 and 100 |
# | | all four fall by 10 more if $a$ is not the wanted action | so a wrong action costs every need 10, before the cut |
# | reward | $\sum_i (v_i - 50)\, u_i$ with the *urgency* $u_i = e^{-v_i/100}$ | with the variables *after* the action; what is low weighs most |
# | the toy wants | the action with the largest $u_i$ | ties are broken at random |
# | discount | $\gamma = 0.5$ | used by Q-learning; the returns in the figures are not discounted |
#
# In the code the number of words in a message, $L$, is `max_msg_length`, and the number of different words, $H$, is
# `vocab_size`.
#
# After each step a tenth of the reward is added to the hit points; the sum is rounded down, and kept between 0 and 100.
# They start at 100. An episode has 100 steps. It *terminates* earlier if the hit points fall to 0. The *return* is the
# sum of all rewards of an episode. The best possible return is 6 707 on average, and random actions return −676.
#
# These are the methods that run. (`rng` draws random numbers.)

# %%
source(type(env.mdp), "changed", "reward")

# %%
source(happiness)

# %% [markdown] tags=["aside"]
# ### Aside: one step by hand
# At the start all $v_i$ are 100. If the toy wants to sleep and is put to bed, they become 95, 100, 95 and 95, since 130 is
# cut off at 100. If it is fed instead, they become 85, 85, 100 and 85, since 120 is cut off as well.

# %% [markdown]
# ### What a word says
# Each word is drawn by itself. It is about need $i$ with a probability that grows with its urgency. The larger the
# **noise** $\tau$, the less it grows (a softmax, as in equation 2.11 of Sutton and Barto, but with a temperature):
#
# $$
# P(\text{a word is about need } i) = \frac{e^{u_i / \tau}}{\sum_j e^{u_j / \tau}}
# $$
#
# With $\tau \to 0$ all words name the wanted action. With $\tau = \infty$ all four needs are equally likely, and the
# words say nothing. In between a word names the wanted action *more often* than the others. In the code each
# $e^{u_i/\tau}$ is divided by that of the wanted need, which changes no probability. (`TIE_BREAK`, a millionth, makes
# the wanted need win ties as $\tau$ goes to 0.)

# %%
source(type(env.mdp), "named", "weight")

# %% [markdown]
# **Play it yourself.** The picture shows what an agent sees, and the button that was pressed last, in black. Here are
# 20 steps with a noise of 0.05 and eight words in each message. Do you follow the first word, or most of the words?
# (The best possible return is 1 345 in 20 steps, on average.) Is there anything besides the words that helps you?

# %%
play("Tamagotchi", tau=0.05, max_msg_length=8, steps_per_episode=20)

# %% [markdown]
# ## The idea: what is in a message, and who can use it?
#
# ### Learning from observations
# Q-learning needs a row of its table for everything that it can be told. It does not know the state, so the row
# belongs to the *observation*. After a step from observation $O$ by action $A$ to observation $O'$ with reward $R$ it
# does what it always does (Sutton and Barto, equation 6.8, with observations in the place of states):
#
# $$
# Q(O, A) \leftarrow Q(O, A) + \alpha \left[ R + \gamma \max_a Q(O', a) - Q(O, A) \right]
# $$
#
# After a terminal step $R$ stands alone in the place of $R + \gamma \max_a Q(O', a)$. The code is the same as in every
# lesson. What it calls `state` is the number of the row.

# %%
source(QLearning.learn)

# %% [markdown]
# Two states that look alike share a row. The agent must do the same in both, whatever it has learned. How many rows
# are there? There are 101 values of the hit points, and $H^L$ messages:
#
# $$
# \text{rows} = 101 \cdot H^L
# $$

# %%
for length in (1, 4, 28):
    print(f"{length:2} words out of 4: {101 * 4.0**length:.3g} rows")

# %% [markdown]
# ### Two players that do not learn
# We compare Q-learning with two players who know from the start what the words mean. One **obeys the first word**. The
# other takes a **majority vote**: it does what most words name. They differ in how many words are `heard`: the first
# one, or all. (If the *vocabulary* has more than four words, the words $i$, $i + 4$, $i + 8$, ... all mean need $i$.)

# %%
source(Voter.act)

# %% [markdown]
# Watch the vote, with eight words and the noise of your own game. Ties are broken at random.

# %%
frames(
    "Tamagotchi",
    Voter.create(None, heard=8),
    tau=0.05,
    max_msg_length=8,
    steps_per_episode=20,
)

# %% [markdown]
# ### How much does a message tell? Count it in bits
# Let $X$ be the need, that is, the wanted action, and $Y$ the message. (The hit points are left out of $Y$.) How much
# does $Y$ tell about $X$? Before the message, need $x$ has the probability $p(x)$. After message $y$ it has the
# probability $p(x \mid y) = p(x, y) / p(y)$. The **information** in the message is the mean of the logarithm of the
# factor by which it made the need more likely (Shannon, 1948; it is also called mutual information):
#
# $$
# I(X; Y) = \sum_{x, y} p(x, y) \log_2 \frac{p(x \mid y)}{p(x)} = \sum_{x, y} p(x, y) \log_2 \frac{p(x, y)}{p(x)\, p(y)}
# $$
#
# The unit is the *bit*: the answer to one question of yes or no, if both are equally likely. If the message has nothing
# to do with the need, $p(x, y) = p(x)\, p(y)$, all logarithms are 0, and so is the information. To tell which of four
# equally likely needs it is takes $\log_2 4 = 2$ bits.
#
# To compute it, all we need is a table of $p(x, y)$. It depends on the variables $v_i$ that occur. We take a toy *in
# perfect care*, which always gets what it wants. The code makes the table for messages of one word: `states_met` plays
# some episodes and counts the states. (Pass over `obeyed` and `kinds` for now.)
#
# For longer messages $y$ is how often each word occurs. (Given the state the words are drawn independently, so their order
# tells nothing.) The second word tells in part what the first one told: two words carry less than twice the bits of one.

# %%
source(joint_table)

# %% [markdown]
# **Predict.** At $\tau = 0.1$, in what share of the steps does a word name the wanted action? (By pure chance it would
# be 25 %. In perfect care the variables are mostly near 85, 90, 95 and 100, so that the urgencies are 0.43, 0.41, 0.39
# and 0.37.)

# %%
named = predict("At τ = 0.1 a word names the wanted action in ... of the steps.", unit="%")
named

# %%
display(figures.joint_tables())
for tau in (0.0, 0.02, 0.05, 0.1):
    share = np.trace(joint_table(tau))
    print(f"τ = {tau:4}: a word is right in {share:4.0%} of the steps, and carries {information(tau):.3f} bit")
named.measured(100 * np.trace(joint_table(0.1)))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** 33 %, only a little more than chance. In a table of pure noise all numbers would be 1/16, about 0.06;
# without noise all the weight is on the diagonal. The bits fall faster than the share of right words: at $\tau = 0.02$
# two words of three are right, and three quarters of the information are gone.
# </details>
#
# A player who obeys follows wrong words too, and leaves needs that differ more: the highest urgency is 0.04, 0.06 and
# 0.08 above the second ($\tau = 0.02$, 0.05 and 0.1), not 0.02 as in perfect care. So on *its* toy a word carries more. Move the noise, and
# see the bits of both toys.

# %%
sliders(pictures.bits_axis, tau=(0.0, 0.2, 0.01))

# %% [markdown]
# ## The experiment: more and more noise
#
# As in the paper (Moerland et al., 2023), Q-learning meets more and less noise.
#
# | setting | value |
# |---|---|
# | messages | one word out of four |
# | agent | tabular Q-learning, $\alpha = 0.02$, $\gamma = 0.5$, $\varepsilon = 0.1$, all values start at 0, ties broken at random |
# | training | 200 000 steps |
# | evaluation | the mean of 10 greedy episodes, every 10 000 steps |
# | repetitions | 20; bands are 95 % intervals |
#
# The dashed line is the optimum, 6 707, computed by planning with the whole state.
#
# **Predict.** At which noise does Q-learning first get less than half of the optimum?

# %%
half = predict("Less than half of the optimum first at ...", ["τ = 0.02", "τ = 0.05", "τ = 0.1", "τ = ∞"])
half

# %%
settings = {"learning_rate": 0.02, "discount": 0.5, "exploration": EpsilonGreedy(0.1)}
agents = {"Q-learning": lambda toy: QLearning.create(toy, **settings)}
curve = {"evaluate_every": 10_000, "evaluation_episodes": 10}
by_tau = {
    tau: repeat("Tamagotchi", agents, 200_000, parameters={"tau": tau}, repetitions=20, **curve)
    for tau in (0.0, 0.02, 0.05, 0.1, math.inf)
}
display(figures.noise_sheet(by_tau))
means = {tau: methods.late(results, "Q-learning").mean() for tau, results in by_tau.items()}
for tau, mean in means.items():
    carried = information(tau)
    print(
        f"{methods.noise_label(tau):8}: {abs(carried):.3f} bit, mean return {mean:5.0f} in the second half of training"
    )
print("on the toy of a player who obeys:")
for tau in (0.02, 0.05, 0.1):
    heard = joint_table(tau, obeyed=True)
    print(f"  τ = {tau:4}: {np.trace(heard):.0%} of the words are right, and one carries {bits(heard):.2f} bit")
first = next(tau for tau in sorted(means) if means[tau] < methods.OPTIMUM / 2)
half.measured(methods.noise_label(first))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** At $\tau = 0.05$ it gets 3 000, a little less than half. At 0.02 it still gets 6 000, nine tenths of the
# optimum. In perfect care 64 % of the words are right there, and a word carries half a bit. A player that obeys hears
# more, 76 % and 0.84 bit. At 0.1 the return is about 0, and at $\tau = \infty$ it is about that of random actions.
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: what has it learned?
# Each bar belongs to a word, and its colours show how often Q-learning answers it with each
# action, in greedy episodes of all 20 runs. An agent that knows what the words mean has one colour in each bar.

# %%
panels = [figures.answers(by_tau[tau], tau) for tau in (0.0, 0.05, 0.1, math.inf)]
Sheet("answers", [panels[:2], panels[2:]])

# %% [markdown]
# At $\tau = 0$ and at 0.05 it does what the toy says, nearly always, and at 0.1 in more than eight steps of ten. So the
# agent nearly obeys, and we know nothing better without memory.

# %% [markdown]
# ## Your turn
#
# With a smaller $\gamma$ Q-learning looks less far ahead: does it need to? (What more words in a message, $L$, and other
# vocabularies, $H$, change, you predict below.) The yellow and the green line show the two players who know the words (with one word they are
# the same player). (10 repetitions of 200 000 steps. With $H$ below 4 some words are *ambiguous*: they mean two
# needs or more. The two players then always take the first meaning.)


# %%
def one_toy(tau=0.05, L=1, H=4, alpha=0.02, gamma=0.5, epsilon=0.1):
    """Draw the learning curve of Q-learning on one toy, beside obeying and voting."""
    return figures.one_toy(tau, L, H, learning_rate=alpha, discount=gamma, epsilon=epsilon)


sliders(
    one_toy,
    tau=(0.0, 0.2, 0.01),
    L=(1, 4),
    H=[1, 2, 3, 4, 8],
    alpha=(0.01, 0.5, 0.01),
    gamma=(0.0, 0.95, 0.05),
    epsilon=(0.0, 0.5, 0.05),
)

# %% [markdown]
# <details><summary>What you may have found</summary>
#
# Mean returns in the second half of training, all else as at first:
#
# | change | return |
# |---|---|
# | none ($\tau = 0.05$, $L = 1$, $H = 4$, $\alpha = 0.02$, $\gamma = 0.5$) | 3 000 |
# | $\gamma = 0$; 0.9 | 3 140; 2 950 |
#
# It need not look ahead.
# </details>

# %% [markdown]
# ## See inside: information, and being able to use it
#
# A toy that is hard to understand can repeat itself. At $\tau = 0.1$ four words tell nearly four times as much as one.
# But the table of Q-learning is then 64 times larger, and each row is visited less often.
#
# **Predict.** Q-learning trains at $\tau = 0.1$ with four words in each message instead of one. What does it get after
# the same 200 000 steps, with the same $\alpha = 0.02$?

# %%
longer = predict(
    "After 200 000 steps with α = 0.02, four words instead of one give Q-learning ...",
    ["a higher return", "a lower return", "the same return, within 100"],
)
longer

# %%
one_word = methods.late(by_tau[0.1], "Q-learning")
labels = {f"four words, α = {rate}": rate for rate in (0.02, 0.05, 0.2)}
four = {label: methods.learn_long(4, rate, repetitions=8) for label, rate in labels.items()}
voted = methods.vote(0.1, 4, 4).mean()
display(figures.lengths_sheet({"one word, α = 0.02": methods.learn_long(1, repetitions=8), **four}, voted))
for name, length in (("one word", 1), ("four words", 4)):
    print(f"{name}: {information(0.1, length):.3f} bit, a table of {methods.rows_of_table(length)} rows")
print(f"mean return with one word: {one_word.mean():.0f} in the second half of 200 000 steps; with four words:")
for label, results in four.items():
    early, end = (methods.after(results, steps).mean() for steps in (200_000, 1_600_000))
    print(f"  {label[12:]:8}: {early:5.0f} after 200 000 steps, {end:5.0f} after 1 600 000")
print(f"majority vote over four words: mean return {voted:.0f}")
gain = methods.after(four["four words, α = 0.02"], 200_000).mean() - one_word.mean()
longer.measured(
    "the same return, within 100" if abs(gain) < 100 else "a higher return" if gain > 0 else "a lower return"
)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** A lower one, although the message tells nearly four times as much. The table has about 100 000 values,
# so 200 000 steps are two tries for each *on average*, and a value that is tried twice with $\alpha = 0.02$ has gone only
# 4 % of the way to its target. So a larger table needs a larger learning rate, or more time: with $\alpha = 0.2$ four
# words are ahead of one already. In the end $\alpha = 0.05$ is best. None gets as far as the vote. With $\alpha = 0.02$ the whole gap is the hit points: where they
# are hidden, Q-learning gets 1 830 after 1 600 000 steps (8 runs), as much as the vote.
# </details>

# %% [markdown]
# Now the picture of this lesson. The $x$ axis is the information in a message, the $y$ axis is the return. On the left
# the messages have one word, and the noise falls from $\infty$ (left) to 0 (right). On the right the noise stays at
# 0.1, and the numbers beside the points are the numbers of words, from 1 to 28. (The $x$ axes differ: the left one goes
# to 2 bits, the right one to half a bit.) One point shows Q-learning's longer training with $\alpha = 0.05$.

# %%
learned = {
    figures.LEARNED: {1: one_word, 4: methods.after(four["four words, α = 0.02"], 200_000)},
    figures.LONGER: {4: methods.after(four["four words, α = 0.05"], 1_600_000)},
}
lengths = (1, 2, 4, 8, 16, 28)
picture = figures.one_word_panel(by_tau), figures.messages_panel(lengths, learned)
display(Sheet("information", [picture]))
for tau, length in ((0.02, 1), (0.1, 28), (0.1, 2), (0.1, 1)):
    carried, mean = information(tau, length), methods.vote(tau, length, length).mean()
    print(f"τ = {tau:4}, {length:2} words: {carried:.3f} bit, mean return of the vote {mean:.0f}")

# %% [markdown]
# - **Left.** With one word Q-learning nearly equals obeying.
# - **Right.** The vote turns longer messages into return: 28 words at $\tau = 0.1$ are worth nearly as much as one word at
#   0.02. Whoever obeys the first word leaves the others unused.
# - Two words carry nearly twice as much as one, and the vote gets nothing out of it. If they disagree it can only guess.
# - After 200 000 steps with $\alpha = 0.02$ Q-learning stands at the lower left. At 28 words its table would have $7 \cdot 10^{18}$ rows.
#
# **Information, and being able to use it, are two things.** Information that is spread over 28 words is there, and a
# table cannot find it. (That is what features and networks are for. At the end, in "From a blank file", you write an
# agent that counts how often each word occurs.)

# %% [markdown]
# ## Predict, then check
#
# ### Is a bit a bit?
# Take the noise away, $\tau = 0$, but let the toy know only two words: "play or feed" and "sleep or clean". So a word
# carries exactly one bit. That is more than at $\tau = 0.02$ (0.49 bit, or 0.84 on the toy of a player who obeys),
# where Q-learning got nine tenths of the optimum.
#
# **Predict.** What does Q-learning get with a vocabulary of two words?

# %%
ambiguous = predict(
    "With one bit, from a vocabulary of two words without noise, Q-learning gets ...",
    ["more than 90 % of the optimum", "about half of it", "no more than random actions"],
)
ambiguous

# %%
two_words = methods.learn(parameters={"vocab_size": 2}, repetitions=20)
mean = methods.late(two_words, "Q-learning").mean()
coin = methods.play(Coin.create, parameters={"vocab_size": 2}).mean()
print(f"a word out of two carries {information(0.0, vocab_size=2):.2f} bit")
print(f"mean return of Q-learning {mean:.0f}, of random actions {methods.RANDOM_PLAY:.0f}")
print(f"mean return of a player who tosses a coin between the two meanings of the word {coin:.0f}")
lost = "no more than random actions" if mean < methods.RANDOM_PLAY / 2 else "about half of it"
ambiguous.measured("more than 90 % of the optimum" if mean > 0.9 * methods.OPTIMUM else lost)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** No more than random actions. Each row has one greedy answer. At 100 hit points, where the toy begins, "play
# or feed" is always answered with play, say. Then the toy is not fed, wants to be fed again, says "play or feed", and is
# played with, until its hit points fall. With other hit points the answers may be others, but they are fixed as well, and the toy soon
# dies. With a vocabulary of four words, and noise, the word is *sometimes* right about each need. Here it never tells the two needs of a word apart.
#
# Tossing a coin between the two meanings is better: each need is met now and then. Where the state is hidden and nothing
# is remembered, a random policy can be better than every deterministic one (Singh, Jaakkola and Jordan, 1994). With a
# known state that never happens. So bits alone do not say what a message is worth. What counts is which mistakes it
# leaves.
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: many words for one thing
# **Predict.** Now the opposite: 16 words, four for each need, without noise (*synonyms*). They carry the same two bits
# as four words. What does Q-learning do with them?

# %%
synonyms = predict(
    "With 16 words Q-learning ...",
    ["learns as fast", "learns more slowly, and reaches the optimum", "ends well below the optimum"],
)
synonyms

# %%
vocabularies = methods.compare_vocabularies([4, 16, 64], repetitions=10)
display(figures.vocabulary_sheet(vocabularies))
for size in (4, 16, 64):
    curve = vocabularies.curves(f"{size} words").mean(axis=1) / methods.OPTIMUM
    print(
        f"{size:2} words: after 20 000 steps {curve.loc[20_000]:4.0%} of the optimum, at the end {curve.iloc[-1]:4.0%}"
    )
curve = vocabularies.curves("16 words").mean(axis=1) / methods.OPTIMUM
slower = "learns more slowly, and reaches the optimum" if curve.loc[20_000] < 0.9 else "learns as fast"
synonyms.measured(slower if curve.iloc[-1] > 0.99 else "ends well below the optimum")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** It learns more slowly, and reaches the optimum. Every synonym has rows of its own, and must be learned
# from nothing. So the more words, the longer it takes: with 64 the 200 000 steps are not enough at $\alpha = 0.02$ (with 0.2, 100 000 are). The two kinds of
# bad vocabulary are different: synonyms slow learning down, and ambiguous words put a cap on it (without memory).
# </details>

# %% [markdown]
# ### Without any signal
# Now $\tau = \infty$: the words are pure noise. Here is a player who does not listen. It takes the four actions in
# turn.

# %%
source(RoundRobin.act)

# %% [markdown]
# **Predict.** What does it get, in percent of the optimum? (Random actions get −10 %.)

# %%
in_turn = predict("Taking the actions in turn gets ... of the optimum.", unit="%")
in_turn

# %%
blind = methods.play(RoundRobin.create, parameters={"tau": math.inf}).mean()
print(f"mean return {blind:.0f} of {methods.OPTIMUM:.0f}")
in_turn.measured(100 * blind / methods.OPTIMUM)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** 99 %. The toy needs all four things again and again, and what was done longest ago is the most urgent.
# So the player who remembers its last action knows what is wanted. It loses 1 % at the start, where the toy wants one
# at random.
#
# An agent can *remember* instead of listening, and its own actions are part of what it can remember. The true history
# contains all past observations *and actions* (Sutton and Barto, section 17.3). But memory can stand in for a signal
# only as far as the world is predictable: on a toy with *moods*, in an aside below, the same player gets a tenth of the
# optimum.
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: can Q-learning find that?
# Give the toy a single word, so that it always says the same. Then let the rows of the table
# belong to the last two observations *and the action between them*. This is a `FrameStack` of two.

# %%
source(methods.learn_with_memory)

# %% [markdown]
# **Predict.** How many of 10 runs get more than 90 % of the optimum in most evaluations of the second half of training,
# once they see their last action?

# %%
remembers = predict("With its last action, ... of 10 runs get more than 90 %.", unit="runs")
remembers

# %%
memory = {
    "with its last action": methods.learn_with_memory(repetitions=10),
    "without": methods.learn_with_memory(actions=False, repetitions=10),
}
display(figures.memory_sheet(memory))
counts = {label: int((methods.median_late(results) > 0.9 * methods.OPTIMUM).sum()) for label, results in memory.items()}
print("runs above 90 %, by the median of each run in the second half of training:", counts)
remembers.measured(counts["with its last action"])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** All ten with the last action, none without. It takes a while. Each run rises suddenly, but not
# all at one time, so that their mean rises slowly. Without the last action all it sees is its hit points, now and one step ago, and they do not
# say whose turn it is. (The bands are symmetrical, so they can reach above what is possible. Now and then a run loses
# the cycle, as the panel on the right shows. So we take the median of each run.)
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: how far does memory carry?
# A toy that always gets hungry on schedule is easy to remember. Let us give it *moods*. With probability 0.1 in each
# step, one of its four variables falls by 20, all of a sudden. What this class does not define stays as it was.

# %%
source(moody.Moody)

# %% [markdown]
# **Predict.** On the moody toy, one player takes the actions in turn and hears nothing. Another obeys a single noisy
# word, with $\tau = 0.05$, and remembers nothing. Who gets more?

# %%
moods = predict("On the moody toy ...", ["memory gets more", "the noisy word gets more", "both get about the same"])
moods

# %%
toy = moody.moody_toy(tau=0.05)
players = {"in turn": RoundRobin.create, "obey": Voter.create}
print(f"best possible, with the whole state: {moody.best_return(0.0, 20):.0f} without moods,", end=" ")
print(f"{moody.best_return(0.1, 20):.0f} with moods")
returns = {name: methods.play(make, environment=toy).mean() for name, make in players.items()}
for name, make in players.items():
    calm = methods.play(make, parameters={"tau": 0.05}).mean()
    print(f"{name:8} mean return {calm:5.0f} without moods, {returns[name]:5.0f} with moods")
more = "memory gets more" if returns["in turn"] > returns["obey"] else "the noisy word gets more"
moods.measured("both get about the same" if abs(returns["in turn"] - returns["obey"]) < 300 else more)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** The noisy word gets more. Taking turns falls from 99 % of the optimum to about a tenth of it: a mood
# changes the order of the needs, the player does not notice, and each wrong action costs all four. Obeying falls too,
# from about 3 290 to 2 040. Who should win here is a player that uses both: that is the challenge.
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: fog on a frozen lake
# FrozenLake of Gymnasium is a grid of 4 by 4. The agent sees its cell. Reaching the goal pays 1, and a fall into a hole
# ends the episode. Let there be *fog*: with some probability the agent is told a random cell instead of its own. Any
# Gymnasium environment can be wrapped like this; `Fog` is for observations that are whole numbers.


# %%
class Fog(gym.ObservationWrapper):
    """With probability `fog` the agent sees a random cell."""

    def __init__(self, env, fog):
        """Wrap an environment."""
        super().__init__(env)
        self.fog = fog

    def observation(self, observation):
        """Return the cell, or a random one."""
        if self.np_random.random() < self.fog:
            return int(self.np_random.integers(self.observation_space.n))
        return observation


# %% [markdown]
# On firm ice every step goes where you want. On slippery ice it goes there in one of three cases, and else to one
# side. Q-learning trains in the fog ($\alpha = 0.1$, $\gamma = 0.95$, $\varepsilon = 0.1$, 30 000 steps, 3 runs).
# Another player never looks: it repeats the six steps of the shortest way, from memory, until the episode ends.
#
# **Predict.** With 10 % of fog, where does the blind player do better?

# %%
lake = predict(
    "The blind player does better ...", ["on firm ice only", "on slippery ice only", "on both", "on neither"]
)
lake

# %%
better = []
for ice, slippery in (("firm ice", False), ("slippery ice", True)):
    foggy = Fog(gym.make("FrozenLake-v1", is_slippery=slippery), fog=0.1)
    q_learning = {"Q": lambda lake: QLearning.create(lake, learning_rate=0.1, discount=0.95)}
    runs = repeat(foggy, q_learning, 30_000, repetitions=3, evaluate_every=30_000, evaluation_episodes=200)
    blind = methods.walk(foggy, [1, 1, 2, 1, 2, 2] * 17, episodes=300)  # down, down, right, down, right, right
    print(f"{ice:12}: mean return of Q-learning {runs.final('Q').mean():.2f}, of the blind player {blind:.2f}")
    if blind > runs.final("Q").mean():
        better.append(ice)
lake.measured({0: "on neither", 2: "on both"}.get(len(better), f"on {''.join(better)} only"))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** On firm ice only. There the six steps are always right, and every look into the fog can mislead. On
# slippery ice the blind player does not know where it is after its first step, and a signal with this little fog is
# worth more than its plan.
# </details>

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for your answer, and below it a cell that checks it. The check does not only say whether an
# answer is right: it says what was expected, what came, and which mistake that looks like. It runs your code on cases
# that it makes up.

# %%
from edugym_course.grading import check
from edugym_course.lessons.signal.exercises import CHALLENGE, exercise_1, exercise_2, exercise_3

# %% [markdown]
# ### Exercise 1: change a parameter
# At $\tau = 0.1$ one word carries 0.022 bit. How many words must a message have, at least, to carry 0.4 bit or more?
# Set `words` to that number. Before you compute: what would it be if $L$ words carried exactly $L$ times as much as
# one?
#
# <details><summary>Hint</summary><code>information(0.1, 5)</code> is the information in a message of five words, in bits.
# Its first argument is τ, the second one is L. Try some numbers, or write a loop.</details>

# %%
words = 1  # put your number here
### BEGIN SOLUTION
while information(0.1, words) < 0.4:
    # own: while information(0.1, words) < {enough}:
    words += 1
### END SOLUTION

# %% tags=["check"]
check(exercise_1, words)

# %% [markdown]
# ### Exercise 2: the information in a table
# Write the function that gave all the bits of this lesson. It gets a table of $p(x, y)$ as an array of NumPy, with a
# row for every need $x$ and a column for every message $y$. All its entries add up to 1. It returns
#
# $$
# I(X; Y) = \sum_{x, y} p(x, y) \log_2 \frac{p(x, y)}{p(x)\, p(y)}
# $$
#
# where $p(x)$ is the sum of a row and $p(y)$ the sum of a column. Tables may have any size, and some entries may be 0.
# Such a pair never occurs, so it adds nothing. Below the check, your function computes what one word carries at four
# noises.
#
# <details><summary>Hint</summary><code>joint.shape</code> gives the numbers of rows and columns, <code>joint[x].sum()</code> is the
# sum of a row, <code>joint[:, y].sum()</code> that of a column. Two loops, and an <code>if</code> for the zeros, are
# enough.
# <code>math.log2</code> is the logarithm.</details>


# %%
def bits_in(joint):
    """Return the information I(X; Y) in bits, from a table of p(x, y)."""
    ### BEGIN SOLUTION
    total = 0.0
    for x in range(joint.shape[0]):
        for y in range(joint.shape[1]):
            if joint[x, y] > 0:
                total += joint[x, y] * math.log2(joint[x, y] / (joint[x].sum() * joint[:, y].sum()))
                # own: total += joint[x, y] * math.log(joint[x, y] / (joint[x].sum() * joint[:, y].sum()), {base})
    return total
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_2, bits_in)
### BEGIN HIDDEN TESTS
check(exercise_2, bits_in, seed=1, quiet=True)
### END HIDDEN TESTS
display({f"τ = {tau}": round(float(bits_in(joint_table(tau))), 3) for tau in (0.0, 0.02, 0.05, 0.1)})

# %% [markdown]
# ### Exercise 3: listen and remember
# The vote hears everything and remembers nothing. The player that takes turns remembers, and hears nothing. Join them: a need
# that was met in the last step is usually not the most urgent one now.
#
# Write the `act` of a player that
#
# - counts, for each need, how many words of the message name it, as the vote does;
# - never takes the action that it took last, `self.last[0]`, if there is one (−1 means that nothing was done yet);
# - takes the need with the most words among the others, ties broken at random: `pick(votes, rng)` does that;
# - and writes its action into `self.last[0]`, for the next time.
#
# Do not call `pick` again and again until it returns another action: where the last action alone has the most words, it
# never does.
#
# `observation[0]` are the hit points, and the words follow: `observation[1]`, `observation[2]`, ... A word $k$ names
# need `k % 4`. In the figure below the check it stands beside the vote, at $\tau = 0.1$. (Your player is compiled for
# each length of messages, which takes some 10 to 20 seconds. Functions that cannot be compiled, such as
# `np.bincount`, are right too; they take a minute.) Before you run it: with how many words will
# the gain in return be largest?
#
# <details><summary>Hint</summary>Start with <code>votes = np.zeros(4)</code>, and let a loop over
# <code>range(1, len(observation))</code> count. A vote of −100 is below all others, so give that to the last action
# before you pick, if there is one. (At the start <code>self.last[0]</code> is −1, and as an index that would be the last
# entry.) (<code>last</code> is kept from one episode to the
# next.)</details>


# %%
def pick(votes, rng):
    """Return the number of the largest entry; among equals, one at random."""
    best, equals = 0, 1
    for k in range(1, len(votes)):
        if votes[k] > votes[best]:
            best, equals = k, 1
        elif votes[k] == votes[best]:
            equals += 1
            if rng.random() * equals < 1.0:
                best = k
    return best


class Listener(NamedTuple):
    """Does what most words name, but never the same thing twice in a row."""

    last: np.ndarray  # shape (1,): the last action, or -1
    tabular: bool = False  # it reads the words themselves

    @classmethod
    def create(cls, environment):
        """Make a new player that has done nothing yet."""
        return cls(np.array([-1]))

    def act(self, observation, rng):
        """Choose the need with the most words, but not the last action."""
        ### BEGIN SOLUTION
        votes = np.zeros(4)
        for k in range(1, len(observation)):
            votes[observation[k] % 4] += 1.0
            # own: votes[observation[k] % 4] += {loud} if k == 1 else 1.0
        if self.last[0] >= 0:
            votes[self.last[0]] = -100.0
        action = pick(votes, rng)
        self.last[0] = action
        return action
        ### END SOLUTION

    def learn(self, reward):
        """Learn nothing."""


# %% tags=["check"] points=3
check(exercise_3, Listener)
### BEGIN HIDDEN TESTS
check(exercise_3, Listener, seed=1, quiet=True)
### END HIDDEN TESTS
display(figures.race({"my listener": Listener.create}))

# %% [markdown]
# <details><summary>What the race shows</summary>
#
# The listener is above the vote at every length. The gain is largest in the middle: with four words it gets some 1 000
# more. With one word its memory helps only when the word names what it has just done: then the word is probably wrong,
# and it guesses among the other three. With 28 words the gain is small. (On
# this calm toy taking turns beats both. On the moody toy taking turns fails.)
# </details>

# %% [markdown]
# ### The open challenge: a moody toy
# With probability 0.1 in each step one need, drawn at random, falls by 20 (*moods*). A message has four words, $\tau = 0.05$, and there are 20 000 steps, about 200 episodes.
# *All* training episodes count. Nobody who does not see the state can get the optimum, 6 595. The vote gets about two
# thirds of it, and taking turns a tenth. "Q-learning" in the table has a row for each observation, $\alpha = 0.1$,
# $\gamma = 0.5$ and $\varepsilon = 0.1$. (The return at the end, one episode, is noisy: look at the average.) How close
# can you come, with messages and memory together?
#
# Of the task your agent is told only its observation space and its action space. It needs `act(observation, rng)` and
# `learn`, which asks by name for what it needs: `state` (the observation), `action`, `reward`, `next_state`, `terminated`, `truncated`. An agent without `tabular = False` sees the number of its row instead of the
# words. It is tried ten times, with seeds that belong to your name. Everything is allowed that uses only what it sees,
# its own actions, and the rewards that `learn` is given.
#
# Write half a page about your agent. What does it remember, and how does it weigh that against the words? What would it
# get without the words, and what without its memory? Would it still be good if moods came five times as often?
# `methods.play(my_agent, environment=moody.moody_toy(0.5, tau=0.05, max_msg_length=4)).mean()` gives its return with
# five times as many moods. With `moody_toy(0.1, tau=math.inf, max_msg_length=4)` the words say nothing.


# %%
def my_agent(toy):
    """Make the agent for the challenge; put your own in its place."""
    return Voter.create(toy, heard=4)


CHALLENGE.score(my_agent, "Ada Lovelace")

# %% [markdown]
# ### From a blank file
# Now write it all yourself, from an empty cell, with NumPy and Gymnasium only: a listener that learns what the words
# mean, and its loop, some 30 lines. Your listener has a weight $\theta_{w,a}$
# for each word $w$ and each action $a$, and what it learns of a word it knows in every message. Of a message it keeps
# only $x_w(o)$, how often word $w$ occurs in it, divided by its length $L$. The value of an action is linear in these
# shares, and the weights of the action that was taken move along their gradient (Sutton and Barto, sections 9.3 and
# 9.4). The reward stands alone, as with $\gamma = 0$ (which did no harm in "Your turn"). So the last step of an episode is learned like the others.
#
# $$
# q(o, a) = \sum_w x_w(o)\, \theta_{w,a}
# \qquad\qquad
# \theta_{w,A} \leftarrow \theta_{w,A} + \alpha \left[ R - q(O, A) \right] x_w(O) \quad \text{for all } w
# $$
#
# **What it must do.** `my_program(environment, n_steps, seed)` takes `n_steps` steps in a Gymnasium environment, episode after
# episode, and learns from each of them. In the end it returns its *policy*: a function that takes an observation and returns
# the action with the highest value. All else is up to you: functions, classes, any names, and how ties are broken.
#
# - An observation is an array of whole numbers: the hit points, which the equation leaves out, and then the $L$ words.
#   `environment.observation_space.nvec[1]` says how many different words there are, and `environment.action_space.n` how
#   many actions. What a word means and how many words a message has differ from one environment to the next.
# - Take $\alpha = 0.01$, $\varepsilon = 0.1$ (a random action is any of all $n$) and first weights of 0.
# - Draw all random numbers from `np.random.default_rng(seed)`, and give the seed to the first `reset` alone.
#
# The check runs your program in small worlds of its own, and for 5 000 steps on a toy with $\tau = 0.05$ and eight words
# in a message; a table for these has more than six million rows. It sees the steps that your program takes, and no line
# of it. So the mistake that it names is only the likely one.

# %% tags=["project"]
my_program = ...  # your program
### BEGIN PROGRAM


def choose_action(values, epsilon, rng):
    """Return an action by ε-greedy, ties broken at random."""
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return rng.choice(np.flatnonzero(values == values.max()))


def my_program(environment, n_steps, seed):
    """Learn what words mean for `n_steps` steps, and return the greedy policy."""
    alpha, epsilon = 0.01, 0.1
    rng = np.random.default_rng(seed)
    n_words = environment.observation_space.nvec[1]
    theta = np.zeros((n_words, environment.action_space.n))

    def heard(observation):
        """Return the share of each word in the message."""
        words = observation[1:]
        return np.bincount(words, minlength=n_words) / len(words)

    observation, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        x = heard(observation)
        values = x @ theta
        action = choose_action(values, epsilon, rng)
        observation, reward, terminated, truncated, _ = environment.step(action)
        theta[:, action] += alpha * (reward - values[action]) * x
        if terminated or truncated:
            observation, _ = environment.reset()
    return lambda observation: choose_action(heard(observation) @ theta, 0.0, rng)


### END PROGRAM

# %% tags=["project"]
from edugym_course.lessons.signal.project import project_6

check(project_6, my_program)

# %% [markdown]
# ## What you saw
#
# ### In one paragraph
# *Learn it by heart, or better, say it in your own words.* An agent that does not see the state acts on a signal. How
# much the signal tells about the right action can be counted in bits, and noise takes bits away. But information and
# being able to use it are two things: a table needs a row for every message, so that long messages and synonyms must
# be learned one by one, and ambiguous words leave the same mistake for ever, without memory. And a signal is not the only source: what
# the agent did before tells it something too, as far as the world is predictable.
#
# ### Limits
# We counted the bits on a toy in perfect care. A neglected toy says clearer things: at $\tau = 0.1$ a player who obeys
# hears 0.28 bit in a word, not 0.02. The toy's words have a fixed meaning. In a real language they depend on each other
# and on their order, and an agent may know their meaning from other texts before it begins (Luketina et al., 2019). And
# the best use of all messages *and* actions so far is a belief: the probability of each state given the whole history.
# It is exact, and costly (Sutton and Barto, section 17.3).
#
# ### Further reading
# - Moerland et al. (2023), *EduGym: An environment and notebook suite for reinforcement learning education*: the
#   paper.
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 3.1 (what belongs to the state), 17.3 (observations and state).
# - Shannon (1948), *A mathematical theory of communication*: information, and the bit.
# - Singh, Jaakkola and Jordan (1994), *Learning without state-estimation in partially observable Markovian decision
#   processes*: why random policies can be better.
# - Kaelbling, Littman and Cassandra (1998), *Planning and acting in partially observable stochastic domains*: beliefs.
# - Luketina et al. (2019), *A survey of reinforcement learning informed by natural language*.
