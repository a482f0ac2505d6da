# %% [markdown]
# # Search at decision time: how many simulations, and how deep?
#
# **The challenge.** You have a model of the task, but no policy, and no time to plan for all states. Before each step you may simulate a
# little, from where you stand. How do you spend these simulations? And what if the model is wrong?
#
# **You will be able to** write Monte Carlo tree search with upper bounds (UCT); say what a tree gains over plain roll-outs, and what more
# actions cost; and compute exactly what a deeper look ahead is worth, in a right model and in a wrong one.
#
# **Time.** {time} **Before you start.** You should know values, value iteration (Sutton and Barto, 2nd edition, section 4.4), and upper confidence bounds (2.7; lesson 0b). This
# lesson is about their sections 8.8 to 8.11. Lesson 9 plans in the same shop, with and without a given model. All symbols are in the [table of
# notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).

# %%
from functools import partial

import numpy as np

from edugym import UCT, finite_model
from edugym_course.lessons.search import figures, methods, plans
from edugym_course.notebook import play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: a shop, and its model
#
# A shopper collects three items, for 25 each, and leaves by the exit, for 50. Every step costs 1. The best return is 95, in 30 steps. Here
# an episode is cut off after 100 steps.
#
# | | | in words |
# |---|---|---|
# | states | $s$ | the cell, and which items are in the bag: 428 states |
# | actions | $a$ | up, down, left, right |
# | dynamics | $p(s' \mid s, a)$ | one cell on; a wall leaves you where you are. Nothing is random |
# | reward | $r$ | −1 a step, +25 for each item, +50 at the exit |

# %%
shop = methods.shop()
play(shop)

# %% [markdown]
# **The model is given.** For each state and action it says what follows, and asking it changes nothing in the shop. This is the first step:

# %%
model = finite_model(shop)
start = shop.initial(np.random.default_rng(0))
for action, name in enumerate(shop.action_names):
    for outcome in model.outcomes(start, action):
        print(f"{name:5} {outcome}")

# %% [markdown]
# ## The idea: look ahead from where you are
#
# ### Look at everything
# The best that one can do in $d$ more steps is
#
# $$
# V_d(s) = \max_a \sum_{s'} p(s' \mid s, a) \left[ r + \gamma V_{d-1}(s') \right], \qquad V_0(s) = 0.
# $$
#
# (Nothing follows where the task has ended.) Before each step, compute the sum behind the maximum for each action, take the best one, and forget the rest. It needs no table and no learning. (Exercise 3
# is to write it.) But with $b$ actions there are $b^d$ ways to go on. For 20 steps in the shop these are $4^{20}$, a million millions.
# Only where many ways lead to the same few states is there a short cut: $d$ sweeps of value iteration give $V_d$ of all states at once. So we can compute below what the
# exact look-ahead gets in this shop. In a large task nobody can.
#
# ### Try some of it: roll-outs
# So *sample*. Try each action in the model, go on at random until step $d$, and add up the discounted rewards. The mean of many such returns is taken for
# the value of the action. This costs at most $d$ steps of the model for each *simulation*, however many ways there are.
#
# ### Remember where it was good: UCT
# Nobody will act at random after the first step. So keep a *tree* of what was simulated, with a mean return $Q(\text{node}, a)$ and
# a count $N(\text{node}, a)$ for each action, and choose in the tree by an upper bound. Each simulation has four parts:
#
# 1. **Select.** From the root on, take the action with the highest
#    $$
#    Q(\text{node}, a) + c \sqrt{\frac{\ln N(\text{node})}{N(\text{node}, a)}},
#    $$
#    but an action that was never tried comes before all others. The bonus $c \sqrt{\cdot}$ is large for what was seldom tried; $c$ is in the unit of the returns. $N(\text{node})$ counts all choices in the node, the present one included.
# 2. **Expand.** The first step that leads out of the tree adds a node: a state, with the way to it.
# 3. **Roll out.** From there on, act at random until the end, or until step $d$.
# 4. **Back up.** $G$ is the return of the roll-out at first, 0 if the task has ended. From the last node to the root: $G \leftarrow R + \gamma G$, count the action, and
#    $Q(\text{node}, A) \leftarrow Q(\text{node}, A) + \left[ G - Q(\text{node}, A) \right] / N(\text{node}, A)$.
#
# In the end take the action with the highest $Q$ in the root, and throw the tree away. (UCT is short for *upper confidence bounds applied to trees*. In the code `OUTSIDE` means: not in the tree. The code counts an action
# when it is selected, which comes to the same as in step 4.)

# %%
source(UCT, "simulate", "select", "roll_out", "back_up")

# %% [markdown]
# (`select` gives the values and counts of the node to `choose` of `UCB`: that is the formula of step 1, as in lesson 0b. Where the model was never told of an
# action, the simulation ends; here it knows all.)

# %% [markdown]
# ## The experiment: more simulations
#
# | setting | value |
# |---|---|
# | simulations before each step | 30 to 3000, each of at most $d = 20$ steps |
# | constant, discount | $c = 10$, $\gamma = 0.95$ (returns are shown without a discount) |
# | plain roll-outs | the same, but the tree has no node besides the root: only the first action is chosen, by its bound |
# | episodes | 30 for each point; bands are 95 % intervals |
#
# **Predict.** Take plain roll-outs with 3000 simulations before each step instead of 300. They now get ...

# %%
more = predict("Compared with 300 simulations, 3000 plain roll-outs get ...", ["more", "about the same", "less"])
more

# %%
figure, found = figures.measured_simulations(repetitions=30)
display(figure)
tree, plain = found["UCT"], found["plain roll-outs"]
for name, measured in found.items():
    told = ", ".join(f"{n}: {r.mean():.0f}" for n, r in zip(methods.NUMBERS, measured, strict=True))
    print(f"{name:16} {told}")
print(f"what plain roll-outs come to: {plans.random_play():.0f}")
change = plain[4].mean() - plain[2].mean()
more.measured(more.options[0 if change > 3 else 2 if change < -3 else 1])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Less. With more roll-outs each value comes closer to its mean, the value of *random play* after the first step. That is the
# wrong value to know exactly. The best action by these values gets 59 (dotted line, computed exactly): it leaves with one item (with two it would get 78). With 300 simulations the values still have errors, and it gets 68.
# UCT gets 81 with 1000 simulations, but no more with 3000. (Its tree also chooses later actions; that may be why it gets more.) The exact
# look-ahead of 20 steps gets 95.
# </details>

# %% [markdown]
# ## Your turn
#
# How does it depend on the depth $d$ and on $c$? (20 episodes for each point.)


# %%
def one_setting(depth=20, c=10.0):
    """Draw what both searches get with 30 to 1000 simulations."""
    return figures.one_setting(depth, c)


sliders(one_setting, depth=[5, 10, 20], c=[0.0, 1.0, 10.0, 100.0])

# %% [markdown]
# <details><summary>What to look for</summary>
#
# With a depth of 5 both often see neither item nor exit, and then all actions look alike. With 20 steps, 1000 simulations and $c = 10$ the tree gains clearly.
# With 20 steps and $c = 0$ both stay with what looked good first, and get much less. With $c = 100$ the tree gets about what plain roll-outs get.
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: UCT plays soccer
# Soccer (lesson 13) against an opponent who always runs towards the goal in which it scores. The model of UCT contains this opponent ($c = 1$, since a game brings −1, 0 or 1; 200 games for each number, so 95 % within ± 0.14). With a contact of 1, who has the ball and runs into the other always loses it; with 0.5, every second time.

# %%
print("simulations          " + "".join(f"{number:7}" for number in (5, 10, 30, 100, 300)) + "   exact look-ahead")
for contact in (1.0, 0.5):
    got = [plans.simulated_in_soccer(number, contact, repetitions=200).mean() for number in (5, 10, 30, 100, 300)]
    exact = plans.in_soccer(True, contact)[-1]
    print(f"return, contact {contact:3}  " + "".join(f"{mean:7.2f}" for mean in got) + f"{exact:19.2f}")

# %% [markdown]
# A hundred simulations are nearly as good as the exact look-ahead. In the shop, ten times as many were not (81 of 95). Our guess is that it helps to have the goal only a few steps away.

# %% [markdown]
# ## See inside: where the tree grows
#
# One search from the entrance. This is its root:

# %%
agent = methods.searcher(model)
agent.greedy(start, np.random.default_rng(0))
for action, name in enumerate(shop.action_names):
    print(f"{name:5}  N = {agent.tree.counts[0, action]:3}   Q = {agent.tree.values[0, action]:6.2f}")

# %% [markdown]
# Only `down` leads into the shop; the others are walls. It got more simulations, but not many more: a wall costs just one step of the twenty, so the values differ little, and $c = 10$ is large beside
# the difference. Now the whole tree. Each node is a state and the way to it, so a cell can have many
# nodes. Move the number of simulations.


# %%
def one_search(simulations=1000):
    """Draw in which cells the nodes of a search are, for three constants c."""
    return figures.tree_maps(simulations=simulations)


sliders(one_search, simulations=[30, 100, 300, 1000, 3000])

# %% [markdown]
# With $c = 1$ the tree grows deep where it once was good. With $c = 100$ it grows wide, and stays near the entrance. With $c = 10$ this search needed 3000 simulations to get far. Grey cells have no node, and neither have white cells with an item or the exit; very light cells have few.

# %% [markdown]
# ### What could hold UCT back?
# There are two suspects: the random roll-outs, by which it judges new nodes, and $c$. So let us take them away. In place of a roll-out we tell each new
# node what it is worth, exactly: if one plays at random from there on (without an end at step 20), or if one plays well. And we take a smaller $c$.

# %%
print("new nodes are judged by      c = 10   c = 1")
judges = {"random roll-outs": None, "the value of random play": "at random", "the value of good play": "well"}
for name, told in judges.items():
    search = methods.searched if told is None else partial(methods.told, told)
    large, small = (search(c=c, repetitions=100).mean() for c in (10.0, 1.0))
    print(f"{name:27} {large:7.0f} {small:7.0f}")
longer = [methods.told(told, simulations=10_000, repetitions=5).mean() for told in ("at random", "well")]
print(f"10 000 simulations, c = 10: told the value of random play {longer[0]:.0f}, of good play {longer[1]:.0f}")
highest = methods.told("well", highest=True, repetitions=20).mean()
print(f"told the value of good play, c = 10: {highest:.0f} if a value is the highest return, and not the mean")

# %% [markdown]
# Better judges alone: 78 instead of 80. A smaller $c$ alone: 63. Both: 95.
#
# - Why 78 with good judges and $c = 10$? A value in the tree is the mean over all tries, the poor ones too: if it is the *highest* return of these tries, UCT gets 95. Ten times as many simulations are no cure here: 78, too.
# - Told the value of random play, it gets 59, too.

# %% [markdown]
# ## Predict, then check
#
# ### More actions
# Give the shopper twelve more actions. They all stand still, for −1. The best return is still 95.
#
# **Predict.** UCT gets about 80 with 4 actions (1000 simulations). What does it get with 16?

# %%
crowded = predict("With 16 actions, of which 12 stand still, UCT gets ...", unit="(a return)")
crowded

# %%
crowds = {n_actions: methods.in_crowd(n_actions, repetitions=20) for n_actions in (4, 8, 16)}
for n_actions, got in crowds.items():
    print(f"{n_actions:2} actions: {got.mean():4.0f}   less than 0 in {(got < 0).sum():2} of {len(got)} episodes")
repeating = methods.in_crowd(16, copies=True, repetitions=20).mean()
print(f"16 actions, of which 12 repeat the four directions: {repeating:.0f}")
for where in ("tree", "roll-outs"):
    alone = methods.idle_only_in(where, repetitions=20).mean()
    print(f"16 actions, of which 12 stand still, only in the {where}: {alone:.0f}")
crowded.measured(crowds[16].mean())

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** −32, and 18 of 20 episodes get less than 0 (three items without the exit come to 75 − 100 = −25). Is the tree to blame, which has 16 branches at each node now? Or
# the roll-outs, in which 15 of 20 steps stand still? It takes both: with the twelve actions only in the tree UCT gets 52, and with them only in the roll-outs 63. If the twelve
# *repeat* the four directions instead, UCT gets 67. This may be one reason why programs that play well seldom roll out at random: they
# use a policy or a value that was learned.
# </details>

# %% [markdown]
# ### Is it random play that misleads roll-outs?
# Above, plain roll-outs got worse from 300 to 3000 simulations. If the reason is that their values come to those of random play, it should not be so where random play is a better guide. In *shorter*
# roll-outs it is one: with 10 steps the best action by its exact values gets 78, not 59.
#
# **Predict.** With roll-outs of 10 steps, what do 3000 simulations get, compared with 300?

# %%
short = predict("With roll-outs of 10 steps, 3000 simulations get ...", ["more", "about as much", "less"])
short

# %%
plain = {n: methods.searched(nodes=1, depth=10, simulations=n, repetitions=30).mean() for n in (300, 3000)}
print(
    f"10 steps: {plain[300]:.0f} with 300 simulations, {plain[3000]:.0f} with 3000; exact {plans.random_play(10):.0f}"
)
short.measured(short.options[0 if plain[3000] > plain[300] + 3 else 2 if plain[3000] < plain[300] - 3 else 1])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** More. So the direction depends on what the values come to. Even with the right model the *shorter* look is the better
# one for very many plain roll-outs: 78 against 59.
# </details>

# %% [markdown]
# ### A deeper look in a wrong model
# Now no sampling at all: we look ahead *exactly*, and so we need no seeds. But the map is an old one. It shows a door in the wall between two of the items (row 7, column 3, both counted from 0), which is
# bricked up by now. In the right model 8 steps of look-ahead get 59, and 20 steps get 95. On the old map 8 steps get 59, too.
#
# **Predict.** What do 20 steps of look-ahead get on the old map?

# %%
deep = predict(
    "20 steps of look-ahead on the old map get ...", ["about 95", "between 59 and 95", "about 59", "less than 59"]
)
deep

# %%
display(figures.over_depth())
for name, door in (("right map", None), ("old map", methods.DOOR), ("a useless door", (7, 6))):
    shallow, far = plans.in_the_shop(door, (8, 20))
    print(f"{name:15} 8 steps: {shallow:3.0f}   20 steps: {far:3.0f}")
print(f"old map, mended on the way:     20 steps: {plans.mending(20):3.0f}")
searching = [methods.searched(door=door, repetitions=20).mean() for door in (None, methods.DOOR)]
print(f"UCT with 1000 simulations: {searching[0]:.0f} on the right map, {searching[1]:.0f} on the old one")
certain = methods.told("well", door=methods.DOOR, repetitions=20)
print(f"UCT on the old map, if it knows what each place is worth there: {certain.mean():.0f}")
_, worth = plans.in_the_shop(methods.DOOR, (8, 20))
deep.measured(deep.options[0 if worth > 90 else 1 if worth > 62 else 2 if worth > 55 else 3])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Less than 59: it gets −50. The longer look gets as far as the door. It collects two items, goes where the door should be, and walks into the wall until the episode is cut off. It plans anew before each step, and finds
# the same plan each time. With 8 steps the door changes no value on the way. On the right map a deeper look was never worth less. Three controls point to the door: take it away, put it
# where it is of no use, or write into the map what your own steps show; then 20 steps beat 8. (Below 8 steps neither map is ahead throughout.)
#
# UCT loses on the old map, too, though less. Told what each place is worth there, it gets −50, as the exact look-ahead does.
#
# The right panel shows soccer (lesson 13). We think that the opponent moves at random; in truth it always runs towards the goal in which it scores. Three steps of look-ahead
# gain 0.5 a game, and four or more gain nothing. (In a model that knows the opponent, three steps gain 0.5 too, and four or more gain 1.)
# </details>

# %% [markdown]
# Not every wrong model is like that. Let all rewards of the model have fixed errors, with a standard deviation of 1. ("No step seems to pay": what costs in truth costs at
# least a little in the model, too.)

# %%
for name, pay in (("a step may seem to pay", True), ("no step seems to pay", False)):
    eight, twenty = np.array([plans.with_errors(k, (8, 20), steps_pay=pay) for k in range(1, 301)]).T
    for steps, got in ((8, eight), (20, twenty)):
        print(f"{name:23} {steps:2} steps get {got.mean():3.0f}, and -100 in {(got == -100).sum():2} of 300 models")

# %% [markdown]
# There the deeper look is the better one, and the *short* one suffers more: it gets 13 instead of 59, and the deeper one 79 instead of 95. Where an error makes
# a step seem to pay, the short look takes such steps until the episode is cut off: so it gets −100 in 79 of 300 models. Where no step seems to pay, it gets −100 in only 13 of them, and 48 on average.
#
# ### What does it cost?
# With 1000 simulations of up to 20 steps, UCT takes up to 20 000 steps of the model before *each* step of its own. And it learns nothing: in the next episode it begins again.
#
# **Predict.** Let Q-learning take 20 000 steps in the model, once ($\alpha = 1$, $\varepsilon = 0.1$). Then it follows its table, without any search. It gets ...

# %%
cheap = predict("Q-learning after 20 000 steps gets ...", ["more than UCT", "about as much", "less than UCT"])
cheap

# %%
learned = methods.learned(repetitions=20).mean()
print(f"Q-learning gets {learned:.0f}, UCT {searching[0]:.0f}")
needed = plans.sweeps_needed()
for where, sweeps in (("from the entrance on", needed.from_entrance), ("in every state", needed.everywhere)):
    asked = sweeps * needed.pairs
    print(f"value iteration, best {where}: {sweeps} sweeps over {needed.pairs} pairs are {asked} questions")
cheap.measured(cheap.options[0 if learned > searching[0] + 3 else 2 if learned < searching[0] - 3 else 1])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** More than UCT. And value iteration asks the model about as often, *once*, and then knows the best way from the entrance to the exit. After 27 sweeps it knows the best action in every state. In a small task that you will
# do often, search is a waste. It pays where the states cannot be gone through: Go has more than $10^{170}$, and a search sees no more of them than it simulates. It can also pay where
# the model changes from day to day.
# </details>

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for your answer, and below it a cell that checks it: it says what was expected, what came, and
# which mistake that looks like.

# %%
from edugym_course.grading import check
from edugym_course.lessons.search.exercises import exercise_1, exercise_2, exercise_3

# %% [markdown]
# ### Exercise 1: the upper bound
# Return the number by which UCT selects an action: `q` is its mean return in this node, `n_action` how often it was tried there, `n_node` how many choices the
# node has seen, the present one included; the check also gives 0, where nothing was tried. What was never tried comes before everything else: its bound is infinite.
#
# <details><summary>Hint</summary><code>float("inf")</code> is larger than every number.</details>

# %%
from math import log


def upper_bound(q, n_action, n_node, c):
    """Return the upper bound of an action in a node."""
    ### BEGIN SOLUTION
    if n_action == 0:
        return float("inf")
    return q + c * (log(n_node) / n_action) ** 0.5
    # own: return q + c * (log(n_node) / n_action) ** {power}
    ### END SOLUTION


# %% tags=["check"]
check(exercise_1, upper_bound)
### BEGIN HIDDEN TESTS
check(exercise_1, upper_bound, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 2: back up a simulation
# `values` and `counts` are arrays of shape (nodes, actions), as they were before this simulation. `path` lists its pairs (node, action), from the root on, `rewards` what followed on each, and `G` is
# the return of the roll-out after the last one. Change both arrays in place, leave the two lists as they are, and return nothing.
#
# <details><summary>Hint</summary>Go through path and rewards from the end: <code>reversed</code>. First count, then move the value.</details>


# %%
def back_up(values, counts, path, rewards, G, discount):
    """Let every node on the path of a simulation learn from what followed."""
    ### BEGIN SOLUTION
    for (node, action), reward in zip(reversed(path), reversed(rewards), strict=True):
        G = reward + discount * G
        # own: G = reward - {cost} + discount * G
        counts[node, action] += 1
        values[node, action] += (G - values[node, action]) / counts[node, action]
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_2, back_up)
### BEGIN HIDDEN TESTS
check(exercise_2, back_up, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 3: look at everything
# Return what a state is worth if you look `depth` steps ahead, exactly, with $\gamma = 0.9$: the first equation of this lesson.
# `model` is a dictionary. `model[state]` is a list with one entry for each action, and this entry is a list of outcomes `(probability, next_state, reward, terminated)`.
#
# <details><summary>Hint</summary>The function calls itself, with one step less. When does it stop?</details>


# %%
def look_ahead(model, state, depth):
    """Return the best expected return of so many steps."""
    ### BEGIN SOLUTION
    if depth == 0:
        return 0.0
    values = []
    for outcomes in model[state]:
        value = 0.0
        for probability, next_state, reward, terminated in outcomes:
            future = 0.0 if terminated else look_ahead(model, next_state, depth - 1)
            value += probability * (reward + 0.9 * future)
            # own: value += probability * (reward + {discount} * future)
        values.append(value)
    return max(values)
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_3, look_ahead)
### BEGIN HIDDEN TESTS
check(exercise_3, look_ahead, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### From a blank file
# Now write UCT from an empty cell, with Python and NumPy: some 40 lines.
#
# **What it must do.** `my_program(model, n_actions, state, n_simulations, seed)` returns the best action in `state`.
#
# - `model(state, action)` gives `(reward, next_state, terminated)`. What follows may be drawn at random. Actions are 0 to `n_actions - 1`. You get no environment, only this function. Ask it for the steps of your simulations, in their order, and for no others.
# - Make `n_simulations` simulations, each from `state` on. Each ends where the model says so, or after 10 steps in all, roll-out included.
# - $\gamma = 0.9$ and $c = 5$. What was never tried in a node comes first; among equals draw one (at the very end you may also return the first).
# - Return the action with the highest value in the root, of those that were tried there: there may be fewer simulations than actions. Random numbers come from `rng = np.random.default_rng(seed)`.
#
# The check sets it riddles: tiny tasks, each of which needs one part of the search. States and actions are renumbered each time.
# <details><summary>A plan</summary>Keep a dictionary: for each node two lists, counts and values. A node may be the tuple of what led to it: (), then (action, state), and so on. (A table with one entry a state, in which all ways to it meet, is accepted as well.) A function
# that simulates from a node on, and calls itself for the next one, backs up by itself: it returns its return.</details>

# %% tags=["project"]
my_program = ...  # your program


### BEGIN PROGRAM
def my_program(model, n_actions, state, n_simulations, seed):
    """Search by UCT."""
    rng = np.random.default_rng(seed)
    gamma, depth, c = 0.9, 10, 5.0
    tree = {(): ([0] * n_actions, [0.0] * n_actions)}

    def select(counts, values):
        bounds = np.full(n_actions, np.inf)
        for a in range(n_actions):
            if counts[a]:
                bounds[a] = values[a] + c * np.sqrt(np.log(sum(counts) + 1) / counts[a])
        return int(rng.choice(np.flatnonzero(bounds == bounds.max())))

    def roll_out(state, steps):
        if steps == depth:
            return 0.0
        reward, after, ended = model(state, int(rng.integers(n_actions)))
        return reward if ended else reward + gamma * roll_out(after, steps + 1)

    def simulate(node, state, steps):
        if steps == depth:
            return 0.0
        counts, values = tree[node]
        action = select(counts, values)
        reward, after, ended = model(state, action)
        child = (*node, action, after)
        if ended:
            future = 0.0
        elif child in tree:
            future = simulate(child, after, steps + 1)
        else:
            tree[child] = ([0] * n_actions, [0.0] * n_actions)
            future = roll_out(after, steps + 1)
        G = reward + gamma * future
        counts[action] += 1
        values[action] += (G - values[action]) / counts[action]
        return G

    for _ in range(n_simulations):
        simulate((), state, 0)
    counts, values = tree[()]
    return max((a for a in range(n_actions) if counts[a]), key=lambda a: values[a])


### END PROGRAM

# %% tags=["project"]
from edugym_course.lessons.search.project import project_18

check(project_18, my_program)

# %% [markdown]
# ## What you saw
#
# - Plain roll-outs come to the values of random play. From 300 to 3000 simulations they got *worse* here: their limit, 59, can be computed.
# - UCT got about 80 with 1000 simulations, and no more with 3000. Told the value of good play and with $c = 1$, it got 95; with $c = 10$, 78.
# - Twelve actions that stand still ruined UCT. In the tree alone, or in the roll-outs alone, they cost much less.
# - On an old map 8 steps of look-ahead got 59, and 20 steps −50. On the right map deeper was never worse, and with errors as large as the cost of a step in all rewards 20 steps were better than 8.
# - Nothing is kept. UCT simulates up to 20 000 steps before each of its own; value iteration asks the model about as often, once, and has the best way.
#
# ### In one paragraph
# *Learn it by heart, or better, say it in your own words.* Search at decision time plans for the present state only, again before each step. A tree with upper bounds spends simulations where it seems good, and
# so may see what good play leads to, not only what random play does. It costs much, and keeps nothing, so it pays where there are too many states to plan for all. A deeper
# look trusts the model further. If the model is wrong there, the search finds what does not exist, and may go after it for ever.
#
# ### Limits
# The shop is small, so we can compute what a search should find, and planning once is cheaper. Nothing in it is random. We chose the old map so that its door
# matters: with other wrong models a deeper look is better. AlphaZero and MuZero keep what they learn: networks
# for policy and value take the place of random roll-outs, and MuZero learns its model as well.
#
# ### Further reading
# - Kocsis and Szepesvári (2006), *Bandit based Monte-Carlo planning*: UCT.
# - Browne et al. (2012), *A survey of Monte Carlo tree search methods*.
# - Jiang, Kulesza, Singh and Lewis (2015), *The dependence of effective planning horizon on model accuracy*: with a model that was learned from little, a shorter horizon can be better.
# - Silver et al. (2018), *A general reinforcement learning algorithm that masters chess, shogi, and Go through self-play*; Schrittwieser et al. (2020), *Mastering Atari, Go, chess and shogi by planning with a learned model*.
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 8.8 to 8.11 (planning at decision time, roll-outs, tree search), 16.6 (AlphaGo).
