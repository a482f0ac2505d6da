# %% [markdown]
# # Several agents: Soccer
#
# **The challenge.** Two agents learn in one world. To each of them the other is a part of this world, and so the world
# changes while it learns. Can each learn as if it were alone?
#
# **You will be able to** compute exactly what a policy loses to the best opponent that there could be; say when learning
# alone does harm, and when hardly any; and write minimax Q-learning.
#
# **Time.** {time} **Before you start.** You should know Q-learning (Sutton and Barto,
# 2nd edition, section 6.5) and value iteration (section 4.4). Game theory is not needed. All
# symbols are in the [table of notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).

# %%
import numpy as np

from edugym import QLearning, games, value_iteration
from edugym_course.lessons.several_agents import figures, methods
from edugym_course.notebook import frames, play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: two games
#
# ### Rock-paper-scissors
# Two players choose at the same moment, once. Paper beats rock, scissors beat paper, and rock beats scissors. The winner gets 1 from
# the loser. Player 0 chooses the row and player 1 the column; the table says what player 0 gets. Player 1 gets the opposite.

# %%
rock_paper_scissors = games.RockPaperScissors.create()
print(rock_paper_scissors.payoffs[:, :, 0])

# %% [markdown]
# ### Soccer
# The second game, that of Littman (1994), takes many steps.

# %%
soccer = games.Soccer.create()
soccer.scene(soccer.initial(np.random.default_rng(1)))

# %% [markdown]
# | | | in words |
# |---|---|---|
# | states | $s$ | the squares of both players, and who has the ball: 760 states in which the game goes on |
# | actions | $a, o \in \{$north, south, east, west, stand$\}$ | both choose at the same moment: $a$ is one's own, $o$ that of the other |
# | dynamics | $p(s' \mid s, a, o)$ | a coin decides who moves first; who has the ball and runs into the other loses it |
# | reward | $1$, $-1$ or $0$ | 1 for the player who carries the ball into the goal, $-1$ for the other |
# | discount | $\gamma = 0.9$ | a goal now is better than a goal later |
#
# A goal terminates the episode; after 100 steps it is truncated. Player 0 is blue and plays to the right, player 1 is red and plays
# to the left. Both see everything.
#
# Two players choose instead of one, and each has a reward of its own: that makes a *Markov game* of an MDP. Where one gets what the other loses, a game is called *zero-sum*.

# %%
source(games.Soccer, "moved", "rewards")

# %% [markdown]
# **Play it yourself.** You are blue. Your opponent never learns, and its policy is *safe*: nobody wins from it on average, if late goals count less (by $\gamma$).
# How do you get past it?

# %%
opponent = methods.solution().policies[1]
play(games.against(soccer, 0, opponent))

# %% [markdown]
# ## The idea: expect an opponent who knows you
#
# ### Against a player who never changes, a game is an MDP
# Let player 1 follow a fixed policy $\rho$. Then its actions are one more source of chance, and what is left is an MDP:
#
# $$
# p(s' \mid s, a) = \sum_o \rho(o \mid s) \, p(s' \mid s, a, o)
# $$
#
# Q-learning finds the best answer to $\rho$ in the states that it visits often enough, and value iteration computes it
# exactly. This player takes rock in half of its games:

# %%
model = games.game_model(rock_paper_scissors)
often_rock = [[0.5, 0.25, 0.25]]
answers = value_iteration(model.against(0, often_rock))
for action, worth in zip(rock_paper_scissors.action_names, answers.Q[0], strict=True):
    print(f"{action:9} {worth:5.2f}")

# %% [markdown]
# Paper is worth 0.25 a game. By hand: it wins against rock (0.5) and loses against scissors (0.25).
#
# ### How much can be won from you?
# So we can ask for any pair of policies: what would each player gain if it knew the other's policy, and answered as well
# as possible? The mean of the two gains is the *exploitability* of the pair (in
# soccer below these are discounted returns: a goal in the tenth step counts 0.39):
#
# $$
# \tfrac{1}{2} \left[ \max_{\pi'} v_0(\pi', \rho) - v_0(\pi, \rho) \;+\; \max_{\rho'} v_1(\pi, \rho') - v_1(\pi, \rho) \right]
# $$
#
# Here $v_i(\pi, \rho)$ is what player $i$ expects from the start. Each maximum is the optimal value of an MDP, so all of it is exact. If
# it is 0, nobody gains by playing something else. Such a pair is called a *Nash equilibrium*. In a zero-sum game we call both of its policies *safe*:
# against the best opponent, too, such a policy gets what the game is worth. (In rock-paper-scissors and in soccer that is 0.)

# %%
a_third_each = [[1 / 3, 1 / 3, 1 / 3]]
for name, pair in {
    "a third each, both": (a_third_each, a_third_each),
    "a third each, and often rock": (a_third_each, often_rock),
    "always rock, both": ([[1, 0, 0]], [[1, 0, 0]]),
}.items():
    print(f"{name:29} {games.exploitability(model, pair):.3f}")

# %% [markdown]
# ### What Q-learning takes for granted
# Q-learning learns $Q(s, a)$, the return of an action in a world with *one* $p(s' \mid s, a)$. But this $p$ contains $\rho$. When the
# other learns, $\rho$ changes, and what was learned about an action is out of date. And in the end Q-learning has a policy
# *without chance*, one that takes a single action in each state where it has learned: $\arg\max_a Q(s, a)$.
#
# ### Minimax Q-learning
# Littman's player learns the value of each *pair* of actions, $Q(s, a, o)$: it sees what the other did. With these it looks at each state
# as at a matrix game, with its own actions in the rows. And it chooses the policy that is best against the opponent
# that is worst for it:
#
# $$
# \begin{aligned}
# Q(S, A, O) &\leftarrow Q(S, A, O) + \alpha \left[ R + \gamma V(S') - Q(S, A, O) \right] \\
# V(s) &= \max_{\pi} \min_o \sum_a \pi(a \mid s) \, Q(s, a, o)
# \end{aligned}
# $$
#
# Besides the second action, one thing in the update is new: where Q-learning has $\max_a Q(S', a)$, this has $V(S')$, the value of a matrix game. An example. What is the best
# policy for the row player here?
#
# | | $o = 0$ | $o = 1$ |
# |---|---|---|
# | $a = 0$ | 2 | $-1$ |
# | $a = 1$ | $-1$ | 1 |
#
# Each row by itself guarantees only $-1$. Now take row 0 with probability $p$. Column 0 then pays $2p - (1 - p) = 3p - 1$, and
# column 1 pays $-p + (1 - p) = 1 - 2p$. The other takes the column that pays less. The lower of the two is highest where they are equal: $3p - 1 = 1 - 2p$, so $p = 0.4$. Then both columns pay 0.2, and it
# does not help the other to know the policy. That there is such a value is von Neumann's theorem (1928); with more actions a linear programme finds it:

# %%
value, own, other = games.solve_zero_sum([[2, -1], [-1, 1]])
print(f"value {value:.2f}, own policy {own.round(3)}, the other's policy {other.round(3)}")

# %%
source(games.MinimaxQ, "learn", "act")

# %% [markdown]
# `solve_state` solves the matrix game of one state, and writes the policy down. (`decay` lowers the learning rate a little after each step: `share[0]` is what is left.)

# %% [markdown]
# ## The experiment: two who learn
#
# ### Rock-paper-scissors
# Two Q-learners play 2 000 games against each other. Each learns from its own rewards, as if it were alone.
#
# **Predict.** How exploitable are they in the end? Two who choose each action with probability 1/3 have 0; the worst is 1.

# %%
in_the_end = predict("After 2 000 games their exploitability is ...", ["0", "about 0.3", "1"])
in_the_end

# %%
players = [QLearning.create(games.table_shape(rock_paper_scissors, player)) for player in (0, 1)]
run = games.train_players(rock_paper_scissors, players, 2_000, evaluate_every=200)
names = rock_paper_scissors.action_names
for steps, (first, second) in zip(run.steps, run.policies, strict=True):
    if steps > 0:
        best = f"{names[first[0].argmax()]} against {names[second[0].argmax()]}"
        print(f"{steps:5} games: {best:29} exploitability {games.exploitability(model, (first, second)):.2f}")
in_the_end.measured(str(round(games.exploitability(model, run.policies[-1]))))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** 1, from the first look to the last. What they play changes again and again, but at any moment it is one action each. Who knows it takes
# what beats it: for each of the nine pairs of actions the mean gain of the best answers is exactly 1.
# </details>

# %% [markdown]
# ### Soccer
# Now both kinds of players, each against one of its kind:
#
# | setting | value |
# |---|---|
# | all | $\gamma = 0.9$, $\varepsilon = 0.2$, first values of 1 |
# | learning rate | from 1 to 0.01, as Littman's |
# | training | 1 000 000 steps |
# | exploitability | computed exactly from what they have learned, six times, without the random actions |
# | repetitions | 3 here, 5 in the full experiment; bands are 95 % intervals |
#
# The dotted line is an equilibrium. Random players have an exploitability of 0.55.
#
# **Predict.** Which pair comes close to an equilibrium, below 0.1?

# %%
who = predict(
    "After a million steps, below 0.1 are ...",
    ["none of them", "Q-learning only", "minimax Q-learning only", "both"],
)
who

# %%
field = methods.soccer()
learned = methods.compare(field, methods.BOTH, 1_000_000, repetitions=3)
display(figures.learning({"soccer": learned}))
ends = {method: learned.final(method).mean() for method in learned.methods}
earned = {method: learned.late(method, 3, "training_return").mean() for method in learned.methods}
for method in learned.methods:
    print(f"{method:24} exploitability {ends[method]:.2f}, return while it learns {earned[method]:5.2f}")
close = tuple(method for method, end in ends.items() if end < 0.1)
options = {(): 0, ("Q-learning, each alone",): 1, ("minimax Q-learning",): 2}
who.measured(who.options[options.get(close, 3)])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Minimax Q-learning only. The pairs of Q-learners differ widely: 0.37, 0.16 and 0.35.
#
# The mean returns are about 0 for both, as symmetry demands. Who judges these players by their learning curves sees no
# difference. Only the best opponent finds out who is not safe.
# </details>

# %% [markdown]
# ## Your turn
#
# ### The prisoner's dilemma
# Not every game is like this. In the prisoner's dilemma $T$ is the *temptation*:
#
# | what you and the other get | it keeps silent | it talks |
# |---|---|---|
# | **silent** | 3, 3 | 0, $T$ |
# | **talk** | $T$, 0 | 1, 1 |
#
# This game is not zero-sum: both can win, and both can lose. Let two Q-learners play it, ten pairs for 1 000 games. Where does the
# exploitability go, and what do they end up doing? Begin with a temptation of 5. Then try 2, where it is no longer a dilemma.


# %%
def dilemma(temptation=5.0, learning_rate=0.1, epsilon=0.1):
    """Draw the exploitability of ten pairs of Q-learners, and count what they do in the end."""
    return figures.dilemma(temptation, learning_rate, epsilon)


sliders(dilemma, temptation=(1.0, 8.0, 0.5), learning_rate=(0.05, 1.0, 0.05), epsilon=(0.0, 0.5, 0.05))

# %% [markdown]
# <details><summary>What came out</summary>
#
# Above 3 talking is better *whatever the other does*. So it does not matter that the other learns: with a learning rate
# of 0.1 and $\varepsilon = 0.1$ both end up talking, and the exploitability comes to 0 (up to 4 that may take longer).
# So, above 3, learning alone is harmless, but not good: both get 1, and could have 3. An equilibrium says that nobody
# gains *alone*, and no more.
#
# At 3 and below there are two equilibria without chance, both silent and both talking, and with $\varepsilon = 0.1$ it
# depends on the first games which of them a pair finds. Most end up talking: eight of the ten pairs with a temptation of
# 2.
# </details>

# %% [markdown]
# ### Soccer with other rules
# With `contact` 0 who has the ball runs through the other. What does that change? And what if the future counts less?


# %%
def one_match(contact=1.0, discount=0.9):
    """Draw the exploitability of two kinds of players, in a run of a million steps each."""
    return figures.one_match(contact, discount)


sliders(one_match, contact=[0.0, 0.5, 1.0], discount=(0.5, 0.95, 0.05))

# %% [markdown]
# <details><summary>What came out</summary>
#
# Without contact both kinds were at 0 at their first measurement after the start: nothing that the other does matters. With it, minimax Q-learning was below Q-learning in the end. Where the future counts less (try 0.6), less can be won, and from random play, too.
# </details>

# %% [markdown]
# ## See inside
#
# ### The world moves
# These are the best actions of Q-learners in rock-paper-scissors (learning rate 0.01). On the left the other learns as well. On the
# right it does not, and takes rock in four games of five.

# %%
looked_at = {"n_steps": 3_000, "every": 20, "seed": 0}
both_learn = methods.against_each_other("rock-paper-scissors", learns=True, **looked_at)
one_learns = methods.against_each_other("rock-paper-scissors", learns=False, **looked_at)
display(figures.answers({"both learn": both_learn, "player 1 never learns": one_learns}))
for name, run in {"both learn": both_learn, "player 1 never learns": one_learns}.items():
    print(f"{name}: in the second half {methods.changes(run):.1f} changes in 1 000 games")

# %% [markdown]
# Look at the left. Where both play paper, both learn that scissors win. Soon both play scissors, and learn that rock wins. So it goes on, mostly in this order: each step of one makes
# the other's answer wrong. On the right the world stands still, and the learner comes to rest.
#
# ### Where a policy without chance is weak
# Take the policy of a Q-learner in soccer. Of the states in which it has the ball and a random choice is needed, this is where it falls
# farthest short of what could be guaranteed. All of this is computed, not played.

# %%
alone = games.learned_policy(soccer, 0, learned.agents["Q-learning, each alone"][0][0])
state, possible, guaranteed = methods.weakest_state(alone)
print(f"a safe policy guarantees {possible:.2f} from here on, the Q-learner's {guaranteed:.2f}")
seen = soccer.observation(state, 0, None)
for action, safe, own in zip(soccer.action_names, methods.solution().policies[0][seen], alone[seen], strict=True):
    print(f"{action:6} safe policy {safe:4.0%}   Q-learner {own:4.0%}")
soccer.scene(state)

# %% [markdown]
# (Blue is in the top row: to go north is to stand still.) An opponent who knows what blue will do goes there, and takes the ball or stands in the way. A safe policy draws its way, so that nobody
# knows which one to block. In 56 of the 760 states every single action guarantees less than a random choice. And this is a game against the best answer to the same
# Q-learner (blue, the stronger of its pair):

# %%
challenger = methods.best_answer(field, 0, alone)
won = methods.can_lose(field, 0, alone)
print(f"the challenger wins {won:.2f} a game (discounted); from a safe policy nobody wins anything")
frames(games.against(soccer, 1, alone), games.FixedPlayer.create(soccer, 1, challenger), seed=1)

# %% [markdown]
# ## Predict, then check
#
# ### Is it that a random choice is needed?
# Let us take away that some states need a random choice. In *soccer in turns* the players move one after the
# other, as in chess. So whoever moves has seen what the other did. The other still learns, and it still takes the ball by contact.
#
# **Predict.** Two Q-learners play soccer in turns for a million steps. Their exploitability in the end is ...

# %%
in_turns = predict(
    "In turns two Q-learners have an exploitability of ...", ["less than 0.1", "0.1 to 0.2", "more than 0.2"]
)
in_turns

# %%
turns = methods.in_turns()
for name, known in {"soccer": field, "soccer in turns": turns}.items():
    print(f"{name}: {methods.random_states(known)} states need a random choice")
print(f"exploitability in turns of two who play as if there were no contact: {methods.blind_to_contact():.2f}")
control = methods.compare(turns, methods.IN_TURNS, 1_000_000, repetitions=3)
display(figures.learning({"soccer in turns": control}))
ends = {method: control.final(method).mean() for method in control.methods}
print("in the end:", ", ".join(f"{method} {end:.2f}" for method, end in ends.items()))
patient = methods.compare(turns, {"γ = √0.9": methods.independent}, 1_000_000, discount=0.9**0.5, repetitions=8)
print(f"Q-learning, γ = √0.9: {patient.final('γ = √0.9').mean():.2f}")
end = ends["Q-learning, each alone"]
in_turns.measured(in_turns.options[0 if end < 0.1 else 1 if end < 0.2 else 2])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Less than 0.1 on average. Both learn, the world changes for each of them, and
# the other matters (who ignores contact has 0.38). But in every state one action by itself is safe.
# So here learning as if alone did little harm. (A step is the move of one player here, so $\gamma = 0.9$ discounts a round twice; with $\sqrt{0.9}$ Q-learning has 0.09.)
#
# In the figure minimax Q-learning ends at 0.15. It has five times five pairs of actions to learn in each state, though in turns only the five of one player count,
# and its learning rate is small before it has learned them. Take either away, and it comes to 0. On the green line it is told whose turn it is, and learns from each step
# for all five actions of the one whose action does not count. And with a learning rate that falls only to 0.4 it ended at 0.001 (10 runs; in soccer itself, at 0.18).
# </details>

# %% [markdown]
# How much do the 56 states of soccer explain? Give each pair of Q-learners a safe policy in these states, and leave them their own in all others. Then
# the other way round.

# %%
for pair in learned.agents["Q-learning, each alone"].values():
    own = [games.learned_policy(soccer, k, pair[k]) for k in (0, 1)]
    there, elsewhere = (
        methods.gains(field, methods.with_safe_choices(own, elsewhere=where), 0.9) for where in (False, True)
    )
    print(
        f"exploitability {methods.gains(field, own, 0.9):.2f};"
        f" safe only in the 56 states {there:.2f}, safe everywhere but there {elsewhere:.2f}"
    )

# %% [markdown]
# Where they are safe everywhere else, 0.16 can still be won from each pair, in the 56 states: there a single action is never enough. Safe choices in these states alone
# help one pair most: the two others lose more where a single action would be safe and theirs is not. (Over 20 other pairs such safe choices lower the mean from 0.22 to 0.11.)
#
# ### Is it that the other learns?
# Is it enough that the world stands still? Player 1 now plays a safe policy, and never learns.
# So player 0 is in an MDP.
#
# **Predict.** After a million steps against this safe teacher, what does the best opponent win from the Q-learner? (From random play it wins 0.55.)

# %%
pupil = predict("The best opponent wins ... from it", ["less than 0.05", "0.05 to 0.3", "more than 0.3"])
pupil

# %%
taught = methods.compare(field, {"taught": methods.taught}, 1_000_000, measure=methods.losses, repetitions=3)
end = taught.final("taught").mean()
print(f"the best opponent wins {end:.2f} a game")
pairs = [[games.learned_policy(soccer, k, both[k]) for k in (0, 1)] for both in taught.agents["taught"].values()]
lost = [games.expected_returns(field.model, pair, 0.9)[1] for pair in pairs]
print(f"its safe teacher wins {np.mean(lost):.3f} a game")
for both in taught.agents["taught"].values():
    share, corrected = methods.with_best_answers(field, games.learned_policy(soccer, 0, both[0]))
    rest = methods.can_lose(field, 0, corrected)
    visited = (both[0].Q != 1.0).any(axis=1).sum()  # 1 is the first value
    print(f"it plays a best answer in {share:.0%} of the 760 states; it has been in {visited}")
    print(f"with best answers in all states: {rest:.2f}")
pupil.measured(pupil.options[0 if end < 0.05 else 1 if end < 0.3 else 2])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** More than 0.3: most of what this opponent wins from random play. Nobody can win from a safe teacher, and the pupil
# loses hardly anything to it in these three runs. But in nearly half of the states it does not play a best answer, not
# even to the teacher. In most of these it has never been, but best answers there alone hardly help: in 15 other runs it lost 0.46
# instead of 0.47. Best answers where it has been brought it to 0.29. With best answers to the teacher in all states it would still lose about 0.15 (the line printed last), since
# such an answer need not be safe. So a world that stands still was not enough: a safe teacher does not make a safe pupil.
# </details>

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for your answer, and below it a cell that checks it: it says what was expected, what came, and
# which mistake that looks like.

# %%
from edugym_course.grading import check
from edugym_course.lessons.several_agents.exercises import exercise_1, exercise_2, exercise_3

# %% [markdown]
# ### Exercise 1: exploitability by hand
# In a zero-sum game of one move, `payoffs[a, o]` is what player 0 gets, and player 1 gets the opposite. `first` and `second` are the
# policies of both: arrays with a probability for each row and for each column. Return the exploitability of the pair.
#
# <details><summary>Hint</summary><code>payoffs @ second</code> is what each row is worth to player 0 against this policy, and
# <code>first @ payoffs</code> what each column costs player 1.</details>


# %%
def exploitability(payoffs, first, second):
    """Return the mean of what both players gain by their best answers."""
    ### BEGIN SOLUTION
    now = first @ payoffs @ second
    gain_of_first = (payoffs @ second).max() - now
    gain_of_second = now - (first @ payoffs).min()
    return (gain_of_first + gain_of_second) / 2
    # own: return (gain_of_first + {weight} * gain_of_second) / 2
    ### END SOLUTION


# %% tags=["check"]
check(exercise_1, exploitability)
### BEGIN HIDDEN TESTS
check(exercise_1, exploitability, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 2: a safe policy
# `payoffs` is a zero-sum game with two rows and two columns, in which the best policies are random. Return the probability of row 0 in the
# best policy of player 0.
#
# <details><summary>Hint</summary>Do as in the example above, with letters: [[a, b], [c, d]]. The two columns must pay the
# same.</details>


# %%
def safe_probability(payoffs):
    """Return the probability of row 0 with which both columns pay the same."""
    ### BEGIN SOLUTION
    (a, b), (c, d) = payoffs
    return (d - c) / (a - b - c + d)
    # own: return ({share} * d - c) / (a - {share} * b - c + {share} * d)
    ### END SOLUTION


# %% tags=["check"]
check(exercise_2, safe_probability)
### BEGIN HIDDEN TESTS
check(exercise_2, safe_probability, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 3: the update of minimax Q-learning
# `Q[state, action, other_action]` and `V[state]` are arrays. Learn from one step, with $\alpha = 0.5$ and $\gamma = 0.9$: change `Q`, then `V`, in place.
# `games.solve_zero_sum(table).value` is the value of a matrix game, and your own actions are its rows.
#
# <details><summary>Hint</summary>It is Q-learning with V(S') in the target. After that only the matrix game of
# <code>state</code> has changed.</details>


# %%
def learn(Q, V, state, action, other_action, reward, next_state, terminated):
    """Move Q(S, A, O) towards R + γ V(S'), and solve the matrix game of S anew."""
    ### BEGIN SOLUTION
    target = reward if terminated else reward + 0.9 * V[next_state]
    # own: target = reward - {cost} if terminated else reward - {cost} + 0.9 * V[next_state]
    Q[state, action, other_action] += 0.5 * (target - Q[state, action, other_action])
    V[state] = games.solve_zero_sum(Q[state]).value
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_3, learn)
### BEGIN HIDDEN TESTS
check(exercise_3, learn, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### From a blank file
# Now write it all yourself, from an empty cell, with NumPy and `games.solve_zero_sum` only: minimax Q-learning, and a loop in which one `Q` plays both
# sides: `value, rows, columns = games.solve_zero_sum(Q[state])` gives the value of the matrix game, the policy of the rows, and that of the columns. Some 30 lines.
#
# **What it must do.** `my_program(environment, n_steps, seed)` takes `n_steps` steps in a zero-sum game, episode after episode, and learns from each of
# them. In the end it returns the policy of player 0: a function that takes a state and returns the probabilities of its actions.
#
# - The environment is a parallel environment as in [PettingZoo](https://pettingzoo.farama.org). Everything comes in dictionaries, by the names
#   `"player_0"` and `"player_1"`: `seen, _ = environment.reset(seed=seed)`, and `seen, rewards, terminated, truncated, _ = environment.step({"player_0": a, "player_1": o})`.
#   When an episode is over, terminated or truncated, `environment.agents` is empty, and `seen` still holds the last state for both. Only `terminated["player_0"]` means that nothing follows.
# - `environment.observation_space("player_0").n` says how many states there are, and `environment.action_space("player_0").n` how many actions it has; `"player_1"` may have fewer.
#   Both players see the same state. (Try your program in `games.parallel_env(games.RockPaperScissors.create())`: soon it should return about a third each.)
# - Take $\gamma = 0.9$, a learning rate of 0.2, first values of 0, and $\varepsilon = 0.2$, drawn separately for each player. Otherwise player 0 draws from the policy of the rows, and player 1 from that of the columns.
# - Draw all random numbers from `np.random.default_rng(seed)`, and give the seed to the first `reset` alone.
#
# The check lets your program learn nine small games, one of them with chance in it, and computes exactly what the best opponent wins from your policy in each state. It accepts a policy from which this opponent wins at most 0.2 points more than from a safe one, in every state. It does not look
# at your code. So the mistake that it names is only the likely one.

# %% tags=["project"]
my_program = ...  # your program
### BEGIN PROGRAM


def my_program(environment, n_steps, seed):
    """Let minimax Q-learning play both sides, and return the policy of player 0."""
    rng = np.random.default_rng(seed)
    n_states = environment.observation_space("player_0").n
    n_actions, n_others = (environment.action_space(name).n for name in ("player_0", "player_1"))
    Q = np.zeros((n_states, n_actions, n_others))
    V = np.zeros(n_states)
    policy = np.full((n_states, n_actions), 1 / n_actions)
    other_policy = np.full((n_states, n_others), 1 / n_others)

    def draw(probabilities):
        if rng.random() < 0.2:
            return int(rng.integers(len(probabilities)))
        return int(rng.choice(len(probabilities), p=probabilities / probabilities.sum()))

    seen, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        state = seen["player_0"]
        action, other = draw(policy[state]), draw(other_policy[state])
        seen, rewards, terminated, _, _ = environment.step({"player_0": action, "player_1": other})
        target = rewards["player_0"]
        if not terminated["player_0"]:
            target += 0.9 * V[seen["player_0"]]
        Q[state, action, other] += 0.2 * (target - Q[state, action, other])
        V[state], policy[state], other_policy[state] = games.solve_zero_sum(Q[state])
        if not environment.agents:
            seen, _ = environment.reset()
    return lambda state: policy[state]


### END PROGRAM

# %% tags=["project"]
from edugym_course.lessons.several_agents.project import project_13

check(project_13, my_program)

# %% [markdown]
# ## What you saw
#
# - Against a player who never changes, a game is an MDP, so what can be won from a policy is computed exactly.
# - Two Q-learners in rock-paper-scissors kept changing what they play, with an exploitability of 1 at any moment. Against a player who never learned
#   a Q-learner came to rest.
# - In soccer minimax Q-learning came close to an equilibrium, and Q-learning did not. Their returns while they learned were the same.
# - Where no random choice is needed, in the prisoner's dilemma and in soccer in turns, learning as if alone came close to an equilibrium. In soccer
#   even pairs that were safe wherever one action is enough lost 0.16.
# - A safe opponent did not make the Q-learner safe.
#
# ### In one paragraph
# *Learn it by heart, or better, say it in your own words.* To an agent the others are a part of the world, and if they learn, this world moves. The best answer to what they do now need not be a safe policy: it is without chance, and who knows it may beat it. Minimax Q-learning learns the values of pairs of actions, solves a matrix game in each
# state, and so, in soccer, comes close to a policy that loses nothing to anybody. What a policy loses to its best opponent tells them apart; the returns against the partner in training do not.
#
# ### Limits
# Minimax Q-learning is for two players of whom one gets what the other loses. It needs to see the other's actions, and it solves a linear programme at every step. It is safe, and no more:
# against a weak opponent it does not try to win as much as it could. In games that are not zero-sum there may be many equilibria, and to find a good one
# together is another problem.
#
# ### Further reading
# - Littman (1994), *Markov games as a framework for multi-agent reinforcement learning*: minimax Q-learning, and this game. He let Q-learning train a challenger for each of
#   his players, as we compute it: his Q-learners won none of their games against theirs, and minimax Q-learning 37.5 %.
# - Shapley (1953), *Stochastic games*: value iteration with a matrix game in each state, with which the safe policies were found.
# - Brown (1951), *Iterative solution of games by fictitious play*; Robinson (1951), *An iterative method of solving a game*: an older way, to answer the average play of the other (`methods.LEARNERS` has it).
# - Bowling and Veloso (2002), *Multiagent learning using a variable learning rate*: learners that come to rest in the same games.
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 4.4 and 6.5.
