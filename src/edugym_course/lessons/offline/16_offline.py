# %% [markdown]
# # Offline: data instead of interaction
#
# **The challenge.** Somebody has acted before, and written down what happened. Nothing may be tried out. What would another policy
# have been worth, and which policy can be learned from the data alone?
#
# **You will be able to** judge a policy that never acted, by importance sampling and by a doubly robust estimate; say how many
# episodes such an estimate rests on; explain why Q-learning from data promises what it does not keep; and write the
# pessimistic remedy, and say what it costs.
#
# **Time.** {time} **Before you start.** You should know Q-learning and value iteration (Sutton and
# Barto, 2nd edition, sections 6.5 and 4.4). Importance sampling (section 5.5) is explained here. All symbols
# are in the [table of notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).

# %%
import numpy as np

from edugym import (
    collect,
    finite_model,
    fitted_q_iteration,
    policy_evaluation,
    value_iteration,
)
from edugym_course.lessons.offline import figures, methods
from edugym_course.lessons.own_problem.morning import Morning
from edugym_course.notebook import play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: the morning, and its log-book
#
# The environment is the alarm clock of lesson 10, which should let a sleeper sleep, wake her in time, and ring seldom. Every ten minutes from 7:10 on it stays quiet, chimes or rings. At 8:30 the
# episode ends; here an episode is called a night.
#
# | | | in words |
# |---|---|---|
# | states | $s = (t, d)$ | the steps that have passed, and the depth of sleep: 0 awake, 1 dozing, 2 fast asleep |
# | actions | $\mathcal{A} = \{0, 1, 2\}$ | stay quiet, chime, ring |
# | dynamics | $p(s' \mid s, a)$ | a ring nearly always wakes her, a chime makes her sleep lighter, in silence her sleep gets deeper |
# | reward | $r(s, a, s')$ | 0, 1 or 2 for the depth of sleep; a ring costs 4, and not being awake in the end 10 |
# | discount | $\gamma = 1$ | a night has eight steps |

# %%
source(Morning, "transition", "reward")

# %% [markdown]
# **Play it yourself.** Play two nights. You may try things out; whoever learns below may not.

# %%
play(Morning())

# %% [markdown]
# Clocks have been sold for years, and each has kept a log-book: what it saw, what it did, what it got. We call a clock by its *share*: one with
# share 0.5 does what is best in half of its steps, and else any of the three actions at random. The policy that wrote the log-book is
# the *behaviour policy* $b$.

# %%
model = finite_model(Morning())
best = value_iteration(model).greedy_policy()
half_good = 0.5 * best + 0.5 / 3
log_book = collect(model, half_good, n_episodes=1000, seed=1)
print(log_book)
print(f"a night is worth {log_book.returns().mean():.1f}")
for k in range(8):
    state, action = model.states[log_book.states[k]], log_book.actions[k]
    print(f"state {state}, action {action}, b = {log_book.probabilities[k]:.2f}, reward {log_book.rewards[k]:4.1f}")

# %% [markdown]
# Each step also says with which probability the action was taken. We know the model, so we can
# always compare with the truth. Whoever has only the data cannot.

# %% [markdown]
# ## The idea: weigh what happened, and distrust what did not
#
# ### What would another policy have been worth?
# A night of the log-book was worth 0.2 on average. The best clock, $\pi$, is worth 10.3. It never acted; but in some of the
# nights the old clock happened to do what $\pi$ would have done. So we weigh each night by how much more likely $\pi$ would have played it:
#
# $$
# \rho = \prod_t \frac{\pi(A_t \mid S_t)}{b(A_t \mid S_t)}, \qquad
# V_{\text{ordinary}} = \frac{1}{n} \sum_i \rho_i\, G_i, \qquad
# V_{\text{weighted}} = \frac{\sum_i \rho_i\, G_i}{\sum_i \rho_i}
# $$
#
# The probabilities of a night under $\pi$ and under $b$ have the same factors $p(s' \mid s, a)$, which cancel. The ordinary estimate has no bias if $b$ takes every action that
# $\pi$ takes, and if $\pi$ was not learned from these nights. The weighted one has a little in general, and often much less variance. A third one weighs each reward only by the actions *up to* it
# (*per decision*), since what is done later changes nothing of it.
#
# Our $b$ agrees with $\pi$ in $1/2 + 1/2 \cdot 1/3 = 2/3$ of the steps: in half on purpose, and else in one of three by luck. In all eight
# steps it agrees in $(2/3)^8 = 0.039$ of the nights. The other nights have the weight 0.
#
# ### Correct what you believe
# The *doubly robust* estimate begins with values $Q$ of $\pi$ that somebody believes in, and lets the data correct them. From the end of each
# night to its start, with $V_{\text{DR}} = 0$ at the end, $\rho = \pi(A \mid S) / b(A \mid S)$ of this one step, and $V(s) = \sum_a \pi(a \mid s)\, Q(s, a)$:
#
# $$
# V_{\text{DR}} \leftarrow V(S) + \rho\, \bigl( R + V_{\text{DR}} - Q(S, A) \bigr)
# $$
#
# The estimate is the mean over the nights. Where $Q$ is right, what stands in the parentheses is 0 on average, and the weights multiply the luck of single steps, not whole returns. Where it is wrong, data that do what $\pi$ does put
# it right. Under the same conditions as above it has no bias, whatever $Q$ is, if $Q$ does not come from the same nights.

# %%
for method in methods.ESTIMATORS:
    found = methods.estimate(log_book, best, method, methods.MORNING)
    print(f"{method:13} {found.value:5.2f} ± {found.standard_error:.2f}, as from {found.effective_episodes:.0f} nights")
print(f"exact         {policy_evaluation(model, best).start:5.2f}")

# %% [markdown]
# The number after ± is the standard error. The last number is the *effective* number of nights, $(\sum \rho)^2 / \sum \rho^2$: here those whose weight is not 0, since all these weights are equal ($1.5^8$). Of 1 000 nights
# 44 follow the best clock to their end. (The last two estimates also use the beginnings of nights that leave it later. The
# doubly robust one takes its values $Q$ from these same nights, so it may be biased.)
#
# ### Learn from the data alone
# *Fitted Q-iteration* is Q-learning without interaction. It goes through all steps of the log-book at once, again and again:
#
# $$
# Q(s, a) \leftarrow \text{mean of } R + \max_{a'} Q(S', a') \text{ over the steps with } (s, a)
# $$
#
# After the last step of a night the target is $R$ alone. An action that the data do not have in a state keeps the value that it had
# in the beginning, 0. In the end $V$ of the first state is what the learned policy *promises*. What it *keeps* is its exact return.
#
# ### Be pessimistic
# A mean of $n$ targets is off by about their spread over $\sqrt{n}$; we do not know the spread, and $c$ stands for it. And what was never tried may be as bad as can be. The pessimist
# takes both into account. Neither a night nor the rest of one brings less than the *lowest* return, which it must know beforehand:
#
# $$
# Q(s, a) \leftarrow \max\!\left( \text{lowest},\ \text{mean of the targets} - \frac{c}{\sqrt{n(s, a)}} \right),
# \qquad \text{and the lowest return where } n(s, a) = 0
# $$
#
# It is a bonus for exploring with the sign turned round: who may explore goes where little is known, and
# who may not keeps away.

# %% [markdown]
# ## The experiment: whose log-book?
#
# Two clocks have kept a log-book of 300 nights. One presses random buttons (share 0); its nights are worth −9 on average. The other is nearly perfect
# (share 0.97); its nights are worth 9.7. Such data look like this:

# %%
for share in (0.0, 0.97):
    behaviour = share * best + (1 - share) / 3
    data = collect(model, behaviour, n_episodes=300, seed=1)
    print(f"share {share}: a night of the data is worth {data.returns().mean():.1f}")
    print(f"  expected, exactly: {policy_evaluation(model, behaviour).start:.1f}")
    print(f"  {(data.visits > 0).sum()} of 66 pairs were tried (22 states before 8:30, 3 actions)")

# %% [markdown]
# | setting | value |
# |---|---|
# | data | 300 nights of a clock with a share from 0 to 0.97 |
# | fitted Q as it is | what was never tried is worth 0 |
# | with pessimism | $c = 1$, and the lowest return is −42: eight rings, and oversleeping (a bound; no night is as bad) |
# | promised and kept | the learned $V$ of the first state; the exact return of the greedy policy |
# | repetitions | 100 (20 in one figure below), each with other nights; bands are 95 % intervals |
#
# **Predict.** From which log-book does fitted Q, as it is, learn the better clock?

# %%
whose = predict(
    "The better clock is learned ...",
    ["from the random clock", "from the nearly perfect clock", "from both alike"],
)
whose

# %%
by_share = {share: methods.learned(share=share) for share in figures.SHARES}
display(figures.promises(by_share))
for share, rule in ((0.0, "as it is"), (0.97, "as it is"), (0.97, "pessimistic")):
    promised, kept = (numbers[rule].mean() for numbers in by_share[share][:2])
    print(f"share {share}, {rule}: promised {promised:.1f}, kept {kept:.1f}")
random_kept, good_kept = (by_share[share].kept["as it is"].mean() for share in (0.0, 0.97))
whose.measured(whose.options[0 if random_kept > good_kept + 0.5 else 1 if good_kept > random_kept + 0.5 else 2])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** From the random clock: what is learned from its nights keeps 10.1, nearly as good as the best. The nearly perfect clock, whose nights are
# worth 9.7, teaches one that keeps 5.8, and promises 13.4, more than any clock can be worth. From a share of
# 0.6 on, the better the clock, the larger the gap. With pessimism the promise lies below what is kept, most with random nights, and what is learned from the good log-book keeps 10.3.
#
# So "data of a better clock are better data" is wrong for fitted Q as it is. It matters *what the data cover*. And the value that
# offline Q-learning reports need not be what you get.
# </details>

# %% [markdown]
# ## Your turn
#
# How many nights does each rule need, and what does a larger penalty cost? (6 runs for each point.)


# %%
def one_setting(n_nights=300, penalty=1.0):
    """Draw what is promised and kept, by the share of the clock that wrote the log-book."""
    return figures.one_setting(n_nights, penalty)


sliders(one_setting, n_nights=[30, 100, 300], penalty=[0.0, 0.3, 1.0, 3.0, 10.0])

# %% [markdown]
# <details><summary>What to look for</summary>
#
# With 30 nights, fitted Q as it is promises too much whoever wrote the log-book (a likely reason: then even random
# buttons leave some actions untried, and many hardly tried). With pessimism and a good log-book 30 nights are enough. Compare what a larger
# penalty does with random nights, at share 0, and with good ones, at 0.97.
# </details>

# %% [markdown]
# ## See inside: where the promise comes from
#
# One log-book of the nearly perfect clock, and the learned values where she sleeps deeply and little time is left:

# %%
nearly_perfect = 0.97 * best + 0.01
data = collect(model, nearly_perfect, n_episodes=300, seed=1)
learned = fitted_q_iteration(data)
true_Q = value_iteration(model).Q
print("state    tried         learned Q             true Q")
for state in ((5, 2), (6, 2), (7, 2)):
    s = model.row(state)
    print(f"{state}  {data.visits[s]!s:12} {learned.Q[s].round(1)!s:21} {true_Q[s].round(1)}")
print(f"promised {learned.start:.1f}, kept {policy_evaluation(model, learned.greedy_policy()).start:.1f}")

# %% [markdown]
# At $(6, 2)$ the good clock has always chimed. Its value is −0.7 by the data (in truth it is lower still). Nobody has tried to stay quiet or to ring there, so both keep
# their 0, and 0 is more. The maximum takes it (where several values are equal, this policy takes each equally often). At $(5, 2)$ somebody stayed quiet once, and got 2; the target adds the 0 of the
# next state, and so the wrong value climbs back, step by step, to the first state. At $(7, 2)$ the ring, −6, loses to two zeros in the same way, so in truth she oversleeps in most nights of the learned clock.
#
# Could the estimates from above have warned? Let us ask them what the learned policy is worth:

# %%
policy = learned.greedy_policy()
for method in ("ordinary", "per decision", "doubly robust"):
    found = methods.estimate(data, policy, method, methods.MORNING)
    print(f"{method:13} {found.value:5.2f} ± {found.standard_error:.2f}, as from {found.effective_episodes:.0f} nights")

# %% [markdown]
# They cannot. (*Per decision* has a value even from 0 whole nights, since it uses the first steps of nights that leave the policy later; *weighted* would be 0/0.) Nights as this policy plays them are so rare (about one in 10 000) that these 300 contain none, and 300 fresh ones would hardly contain one either. The doubly robust estimate even
# repeats the promise, with a standard error of 0, since no step of the data corrects the values it was given. But one number does warn: *no* whole
# night of the data follows this policy. What the doubly robust estimate says then rests on the values that it was given, and its standard error does not show it.

# %% [markdown]
# ## Predict, then check
#
# ### Is it the zero?
# We leave the penalty out ($c = 0$), and only give the *lowest* value, −42, to what was never tried.
#
# **Predict.** From the nearly perfect clock's 300 nights, the learned policy now keeps ... (it was 5.8, and 10.3 is the best).

# %%
no_zero = predict("It keeps ...", unit="(at most 10.3)")
no_zero

# %%
good = by_share[0.97]
for rule in methods.RULES:
    print(f"{rule:15} promised {good.promised[rule].mean():5.2f}, kept {good.kept[rule].mean():5.2f}")
no_zero.measured(good.kept["unseen is worst"].mean())

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** About 9.7: most of the harm came from the zero. The rest is what the penalty is for: with it 10.3 is kept. An action that was tried
# once or twice has a value that is too high or too low by chance, and the maximum looks for the one that is too high (the
# maximisation bias of Sutton and Barto, section 6.7).
# </details>

# %% [markdown]
# ### Do more nights help?
# In 300 nights the nearly perfect clock has taken about 72 actions at random: 3 of 100, in nights of 8 steps. In 1 000 nights it has
# taken 240.
#
# **Predict.** Fitted Q as it is, from 1 000 nights of the nearly perfect clock, learns a clock that is ...

# %%
more_nights = predict(
    "From 1000 nights of the nearly perfect clock it learns a clock that is ...",
    [
        "as good as the best",
        "better than the nearly perfect clock, but not the best",
        "worse than the nearly perfect clock",
    ],
)
more_nights

# %%
by_nights = {n: methods.learned(n_nights=n) for n in (300, 1000, 3000, 10_000)}
display(figures.promises(by_nights, "nights of the nearly perfect clock", "by_nights", log=True))
kept = {n: one.kept["as it is"].mean() for n, one in by_nights.items()}
print(", ".join(f"{n} nights: kept {worth:.1f}" for n, worth in kept.items()))
print(f"{methods.N_NIGHTS} nights of the random clock: kept {random_kept:.1f}")
thousand, gathered = kept[1000], by_nights[1000].gathered.mean()
more_nights.measured(more_nights.options[2 if thousand < gathered else 1 if thousand < 10.2 else 0])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Worse than the nearly perfect clock: it keeps 7.3, and nights of the data are worth 9.7. From three
# thousand nights it keeps 9.6, and from ten thousand 10.3; three hundred random ones keep 10.1.
# </details>

# %% [markdown]
# ### What does pessimism cost?
# Three hundred random nights, in which every action was tried. Fitted Q as it is keeps 10.1, and with $c = 1$ it is about the same.
#
# **Predict.** What is kept with a penalty ten times as large?

# %%
cost = predict("From 300 random nights, with c = 10, it keeps ...", unit="(at most 10.3)")
cost

# %%
heavy = methods.learned(share=0.0, penalty=10.0).kept
some_good = methods.learned(share=0.3, penalty=10.0).kept
for share, worth in ((0.0, heavy), (0.3, some_good)):
    print(f"share {share}: as it is kept {worth['as it is'].mean():.1f}, with c = 10 {worth['pessimistic'].mean():.1f}")
for share in (0.0, 0.97):
    print(f"the most frequent action, share {share}: kept {methods.imitated(share=share).mean():5.2f}")
cost.measured(heavy["pessimistic"].mean())

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** About 7. That every action was tried is not to blame: so it was in nights with a share of 0.3, and there the same
# penalty does no harm. Our reading: it draws to what the log-book has often, and random buttons mostly keep her awake. Is pessimism just imitation, then? The action that the log-book has most often keeps 10.3 if a good
# clock wrote it, and −9 if the buttons were random. So it is not.
# </details>

# %% [markdown]
# ### How many nights count?
# A night of 12 steps. The log-book has again 1 000 nights of a clock with share 0.5, and we judge the best clock.
#
# **Predict.** How many of the 1 000 nights count? (Of nights of 8 steps 39 were to be expected, and there were 44.)

# %%
counting = predict("Of 1000 nights of 12 steps there count ...", unit="nights")
counting

# %%
longer = methods.judged(methods.morning(length=12), methods=("ordinary",))
print(f"effective nights: {longer.effective.mean():.0f}, and by hand {1000 * (2 / 3) ** 12:.1f}")
counting.measured(longer.effective.mean())

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** About 8. Each further step takes a third of what is left: the number of nights that an estimate needs grows exponentially with the length of
# a night. So on a long task importance sampling of whole episodes is hopeless unless $b$ is close to $\pi$. This is one reason to learn values instead,
# although they are biased.
# </details>
#
# The figure shows how far each estimate is off on nights of 8 steps. The ordinary one is the worst, and *per decision* mostly lies between it and the other two. Here the doubly robust one is no better than the weighted:

# %%
nights = {n: methods.judged(n_nights=n, repetitions=20) for n in (300, 1000, 3000, 10_000)}
figures.errors(nights)

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for your answer, and below it a cell that checks it: it says what was expected, what came, and
# which mistake that looks like.

# %%
from edugym_course.grading import check
from edugym_course.lessons.offline.exercises import exercise_1, exercise_2, exercise_3

# %% [markdown]
# ### Exercise 1: a weighted estimate
# `episodes` is a list of episodes, each a list of steps `(state, action, reward)`. `target` and `behaviour` are the policies $\pi$ and
# $b$, arrays of shape (S, A). Return what $\pi$ is worth, by *weighted* importance sampling, without discount. (Some episode has a weight above 0.)
#
# <details><summary>Hint</summary>One weight for each episode: the product of the ratios of its steps. Then two sums, and one divided by
# the other.</details>


# %%
def weighted_estimate(episodes, target, behaviour):
    """Return the weighted estimate of what the target policy is worth."""
    ### BEGIN SOLUTION
    total, weights = 0.0, 0.0
    for episode in episodes:
        weight = 1.0
        for state, action, _ in episode:
            weight *= target[state, action] / behaviour[state, action]
        total += weight * sum(reward for _, _, reward in episode)
        # own: total += weight * sum({discount}**t * reward for t, (_, _, reward) in enumerate(episode))
        weights += weight
    return total / weights
    ### END SOLUTION


# %% tags=["check"]
check(exercise_1, weighted_estimate)
### BEGIN HIDDEN TESTS
check(exercise_1, weighted_estimate, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 2: correct what you believe
# Return the doubly robust value of *one* episode, without discount. `Q` is an array of shape (S, A): the values that are believed.
#
# <details><summary>Hint</summary>Begin with 0 behind the last step, and go through <code>reversed(episode)</code>. V is the mean of
# <code>Q[state]</code> by the probabilities <code>target[state]</code>.</details>


# %%
def doubly_robust_value(episode, target, behaviour, Q):
    """Return the doubly robust value of an episode."""
    ### BEGIN SOLUTION
    value = 0.0
    for state, action, reward in reversed(episode):
        ratio = target[state, action] / behaviour[state, action]
        V = (target[state] * Q[state]).sum()
        value = V + ratio * (reward + value - Q[state, action])
        # own: value = V + ratio * (reward + {discount} * value - Q[state, action])
    return value
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_2, doubly_robust_value)
### BEGIN HIDDEN TESTS
check(exercise_2, doubly_robust_value, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 3: one pessimistic sweep
# `steps` is a list of `(state, action, reward, next_state, terminated)`, and `Q` the table before the sweep. Return the *new* table after one sweep of
# pessimistic fitted Q, without discount: the mean of the targets less `penalty` over the root of their number, and never below
# `lowest`. Pairs without a step are worth `lowest`.
#
# <details><summary>Hint</summary>Collect the targets of each pair in a dictionary of lists, or their sums and numbers in two arrays. All targets use
# the table before the sweep.</details>


# %%
def pessimistic_sweep(steps, Q, penalty, lowest):
    """Return the values after one sweep of pessimistic fitted Q."""
    ### BEGIN SOLUTION
    targets = {}
    for state, action, reward, next_state, terminated in steps:
        target = reward if terminated else reward + Q[next_state].max()
        # own: target = reward if terminated else reward + {discount} * Q[next_state].max()
        targets.setdefault((state, action), []).append(target)
    new = np.full(Q.shape, float(lowest))
    for pair, found in targets.items():
        new[pair] = max(lowest, np.mean(found) - penalty / np.sqrt(len(found)))
    return new
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_3, pessimistic_sweep)
### BEGIN HIDDEN TESTS
check(exercise_3, pessimistic_sweep, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### From a blank file
# Now learn a clock from a log-book, from an empty cell, with NumPy alone: some 20 lines.
#
# **What it must do.** `my_program(steps, n_states, n_actions, seed)` returns a policy, a function from a state to an action, always the
# same one for a state.
#
# - `steps` is a list of `(state, action, reward, next_state, terminated)`: 80 nights of a clock with share 0.25, one after the other. A night has ten
#   steps, with `terminated` in the last one (its `next_state` is one from which no step begins), and rings and oversleeping cost more than above: no return is below −90.
# - A state is a number from 0 to `n_states - 1`, and a policy has an action for each of them, also for one that is in no step. Other tasks have another number of actions. The numbers are dealt out anew each time, so they tell neither the time nor the depth of sleep.
# - There is no environment. You may not try anything out. `seed` is for your own random numbers, if you draw any.
#
# The check works out exactly what your policy is worth, with $\gamma = 1$, for five log-books. The middle one of the five should be worth 9.2 or more. (The best clock is worth 12.8, ours 12.6 in the middle, and nine in ten of our runs 9.7 or more.) Then it gives your
# program a few log-books of other tasks, in which the data leave only one sensible choice: in some of them the best action on paper rests on very few steps. They, too, have 80 nights of ten steps, and no
# return below −90.
# <details><summary>A plan</summary>Make many sweeps of exercise 3, until nothing changes: first values of 0, a penalty of 2, and −90 for what
# was never tried. Then take the best action.</details>

# %% tags=["project"]
my_program = ...  # your program


### BEGIN PROGRAM
def my_program(steps, n_states, n_actions, seed):
    """Learn by pessimistic fitted Q."""
    lowest, penalty = -90.0, 2.0
    targets_of = {}
    for state, action, *outcome in steps:
        targets_of.setdefault((state, action), []).append(outcome)
    Q = np.zeros((n_states, n_actions))
    for _ in range(20):
        V = Q.max(axis=1)
        Q = np.full((n_states, n_actions), lowest)
        for pair, outcomes in targets_of.items():
            targets = [reward + (0.0 if terminated else V[after]) for reward, after, terminated in outcomes]
            Q[pair] = max(lowest, np.mean(targets) - penalty / np.sqrt(len(targets)))
    return lambda state: int(Q[state].argmax())


### END PROGRAM

# %% tags=["project"]
from edugym_course.lessons.offline.project import project_16

check(project_16, my_program)

# %% [markdown]
# ## What you saw
#
# - A policy that never acted can be judged by the data of another one; of 1 000 nights 44 counted, and of longer nights about 8.
# - Fitted Q learned a better clock from 300 random nights than from 300 of a nearly perfect clock, which leave many actions untried.
# - It promised 13.4 and kept 5.8: the maximum takes what nobody has tried where its first value, 0, is more than what was tried is worth.
# - With the lowest value for what was never tried, and a penalty for what was tried seldom, it kept 10.3, more than the data gathered.
# - From random nights a large penalty did harm: with $c = 10$, 300 of them taught 7 instead of 10.
#
# ### In one paragraph
# *Learn it by heart, or better, say it in your own words.* Data say something about a policy only where they do what it does. Importance
# sampling weighs episodes by the ratio of the two policies, and its variance grows with every step; a doubly robust estimate
# corrects values by the data. Who learns from data and takes the largest value goes where the values are too
# high: to actions that were seldom tried, or never. So I count how often something was tried, and expect the worst of what I do
# not know. If the penalty is large enough, I then mostly get what I was promised, or more.
#
# ### Limits
# The behaviour policy is known here, and every state is seen as it is. If the log-book does not say with which probability an action was taken, it must be
# estimated; if the old clock saw something that the log-book does not have, all of this can go wrong, and the data need not show it. The
# penalty was chosen by us. Theory gives a safe $c$, from how large
# rewards can be, and it is much larger than our 1. In a table an untried action has the first value; a network invents one,
# and methods such as conservative Q-learning press it down.
#
# ### Further reading
# - Precup, Sutton and Singh (2000), *Eligibility traces for off-policy policy evaluation*: per-decision importance sampling.
# - Jiang and Li (2016), *Doubly robust off-policy value evaluation for reinforcement learning*.
# - Thomas and Brunskill (2016), *Data-efficient off-policy policy evaluation for reinforcement learning*: the weighted forms.
# - Ernst, Geurts and Wehenkel (2005), *Tree-based batch mode reinforcement learning*: fitted Q-iteration.
# - Jin, Yang and Wang (2021), *Is pessimism provably efficient for offline RL?*; Rashidinejad, Zhu, Ma, Jiao and Russell (2021), *Bridging offline
#   reinforcement learning and imitation learning*.
# - Kumar, Zhou, Tucker and Levine (2020), *Conservative Q-learning for offline reinforcement learning*: pessimism for networks.
# - Levine, Kumar, Tucker and Fu (2020), *Offline reinforcement learning: tutorial, review, and perspectives on open problems*.
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 5.5 (importance sampling), 5.9 (per decision), 6.7 (maximisation bias).
