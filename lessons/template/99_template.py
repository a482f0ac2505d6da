# %% [markdown]
# # Topic: Environment
#
# **The challenge.** Two sentences: what is hard, and why.
#
# **You will be able to** explain ...; write ...; predict ...
#
# **Time.** {time} **Before you start.** You should know ... (Sutton and Barto, 2nd edition, section 6.5). All symbols
# are in the [table of notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).
#
# *This is the template of a lesson; CONTRIBUTING says how to copy it. Replace one part after the other, and this one first.
# Keep the headings up to the colon.*

# %%
from edugym import QLearning, make_mdp, train
from edugym_course.lessons.template import experiments
from edugym_course.notebook import frames, play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: what is in the picture
#
# Say in a few sentences what the agent sees, what it does, and what it gets. Introduce each symbol before you use it.

# %%
mdp = make_mdp("Roadrunner")
source(type(mdp), "transition", "reward")

# %% [markdown]
# **Play it yourself.** Ask for something to try: what is the best return that you get?

# %%
play(mdp)

# %% [markdown]
# ## The idea: one sentence
#
# The equation, and below it the lines of the package that run it, in the same symbols:
#
# $$
# Q(S, A) \leftarrow Q(S, A) + \alpha \left[ R + \gamma \max_a Q(S', a) - Q(S, A) \right]
# $$

# %%
source(QLearning.learn)

# %% [markdown]
# ## The experiment: what is compared
#
# A question comes before each experiment. Then every setting: discount, learning rate, exploration, budget,
# repetitions. The experiment itself stands in `experiments.py` beside the text, with the claims that the text makes.

# %%
results = experiments.compare()
display(experiments.learning_curves(results))

# %% [markdown]
# Say what is to be seen, in the order in which the eye finds it.

# %% [markdown]
# ## Your turn
#
# Ask a question that a slider answers. A slider calls a function which the lesson also calls once itself.

# %%
experiments.one_setting()
sliders(experiments.one_setting, epsilon=(0.0, 0.5, 0.05), learning_rate=(0.05, 1.0, 0.05))

# %% [markdown]
# ## See inside: why
#
# The picture that explains why: visits, values, a path, a film of an episode.

# %%
run = train(mdp, QLearning.create(mdp), 20_000, seed=1)
frames(mdp, run.agent)

# %% [markdown]
# ## Predict, then check
#
# **Predict.** Which of the two is ahead while it learns, with $\varepsilon = 0.3$?

# %%
ahead = predict("With ε = 0.3, which is ahead while it learns?", ["Q-learning", "SARSA"])
ahead

# %%
careless = experiments.compare(epsilon=0.3)
display(experiments.learning_curves(careless))
gap = careless.difference("SARSA", "Q-learning", "training_return", over="training")
ahead.measured("SARSA" if gap.estimate > 0 else "Q-learning")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** SARSA, and why. Each such sentence is a claim in `experiments.py`.
# </details>

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for the answer, and below it one that checks it: `exercises.py` holds the checks, and
# `answers` right and wrong answers to them, with what is said of each.

# %%
from edugym_course.grading import check
from edugym_course.lessons.template.exercises import exercise_1, exercise_2

# %% [markdown]
# ### Exercise 1: a number
# Which whole number `best_return` is the best possible return in this environment?
#
# <details><summary>Hint</summary>The dashed line in the figures.</details>

# %%
best_return = ...
### BEGIN SOLUTION
best_return = -2
### END SOLUTION

# %% tags=["check"]
check(exercise_1, best_return)

# %% [markdown]
# ### Exercise 2: a piece of an algorithm
# Write the target of Q-learning: `values` are the values of the actions in the next state.
#
# <details><summary>Hint</summary>A terminated episode has no future.</details>


# %%
def target(reward, values, discount, terminated):
    """Return the target of Q-learning."""
    ### BEGIN SOLUTION
    return reward if terminated else reward + discount * max(values)
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_2, target)
### BEGIN HIDDEN TESTS
check(exercise_2, target, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ## What you saw
#
# One paragraph that a student could learn by heart.
#
# ### Limits
# Where this does not hold.
#
# ### Further reading
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 6.4 and 6.5.
