# %% [markdown]
# # Topic: Environment
#
# **The challenge.** Two sentences: what is hard, and why.
#
# **You will be able to** explain ...; write ...; predict ...
#
# **Time.** 45 minutes. **Before you start.** You should know ... (Sutton and Barto, 2nd edition, section 6.5).
#
# *This is the template of a lesson. Copy it to `lessons/NN_name.py`, build it, and replace one section after the other.
# Keep the headings up to the colon.*

# %%
from edugym import SARSA, EpsilonGreedy, QLearning, finite_model, make_mdp, repeat, train, value_iteration
from edugym.experiments.figures import Curves, Sheet
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
# repetitions. The experiment itself belongs into a file beside the text (CONTRIBUTING), with the
# claims that the text makes; it is here only to keep the template in one file.


# %%
def compare(epsilon=0.1, learning_rate=0.1):
    """Draw the learning curves of both methods, with the best possible return."""
    settings = {"discount": 1.0, "learning_rate": learning_rate, "exploration": EpsilonGreedy(epsilon)}
    methods = {
        "Q-learning": lambda environment: QLearning.create(environment, **settings),
        "SARSA": lambda environment: SARSA.create(environment, **settings),
    }
    results = repeat(mdp, methods, 20_000, repetitions=20)
    optimum = value_iteration(finite_model(mdp)).start
    return Sheet("comparison", [[Curves(results, "Roadrunner", "training_return", optimum=optimum, smooth=10)]])


compare()

# %% [markdown]
# Say what is to be seen, in the order in which the eye finds it.

# %% [markdown]
# ## Your turn
#
# Ask a question that a slider answers. A slider calls a function which the lesson also calls once itself.

# %%
sliders(compare, epsilon=(0.0, 0.5, 0.05), learning_rate=(0.05, 1.0, 0.05))

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
display(compare(epsilon=0.3))
ahead.measured("SARSA")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** What the figure shows, with an interval, and why. Each such sentence is a claim in the module of the
# lesson.
# </details>

# %% [markdown]
# ## Exercises
#
# ### Exercise 1: change a parameter
# Which whole number `best_return` is the best possible return in this environment?
#
# <details><summary>Hint</summary>The dashed line in the figures.</details>

# %%
best_return = 0
### BEGIN SOLUTION
best_return = -2
### END SOLUTION

# %% tags=["check"]
assert best_return == -2, f"value iteration on the exact model gives another number than {best_return}"

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
found = target(1.0, [0.0, 4.0], 0.5, False)
assert found == 3.0, f"target(1, [0, 4], 0.5, False) is 1 + 0.5 * 4 = 3, not {found}"
### BEGIN HIDDEN TESTS
assert target(1.0, [0.0, 4.0], 0.5, True) == 1.0, "a terminated episode has no future"
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
