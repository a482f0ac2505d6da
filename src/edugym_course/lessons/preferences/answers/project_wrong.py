# %% nothing is learned of the comparisons
# slow
# says: it chooses action 0 in every state: does Q-learning use *your* rewards (those of step are always 0), are they other than 0 and looked up in the state and the action where they belong, and does each step begin where the last one ended?
# in: visits as vectors
# - rewards += 0.02 * (differences.T @ (preferred - p) - 0.1 * rewards)
# + rewards += 0.0 * (differences.T @ (preferred - p) - 0.1 * rewards)

# %% the wrong way round
# slow
# says: the middle one of
# says: runs makes a clock worth
# says: , and it should be worth
# says: the night that was *not* preferred gains: where the first one was preferred, y is 1, and w grows by α (y - p) times its counts less those of the second
# in: visits as vectors
# - rewards += 0.02 * (differences.T @ (preferred - p) - 0.1 * rewards)
# + rewards += 0.02 * (differences.T @ (1 - preferred - p) - 0.1 * rewards)

# %% both nights gain
# slow
# says: the counts of both nights are added, and those of the second should be taken from those of the first
# in: visits as vectors
# - differences.append(visits(first) - visits(second))
# + differences.append(visits(first) + visits(second))

# %% no p
# slow
# says: With a teacher who
# says: hates to doze
# says: after deep sleep comes dozing in most random nights, so a step must not get the credit of its night. Are there many passes, and is it the error y - p that is learned from, with p by the rewards as they are then? (Or are too few comparisons asked, is the depth left out, has Q-learning too few nights or too small an α, or is its largest value that of another state than the next one?)
# in: visits as vectors
# - p = 0.5 * (1 + np.tanh(differences @ rewards / 2))
# + p = 0.5

# %% the sign of p
# slow
# says: Are there many passes, and is it the error y - p that is learned from, with p by the rewards as they are then?
# in: visits as vectors
# - p = 0.5 * (1 + np.tanh(differences @ rewards / 2))
# + p = 0.5 * (1 - np.tanh(differences @ rewards / 2))

# %% a discount
# slow
# says: pays for silence at once, and is paid for it later
# says: is all that follows a step counted, in full and by the best action, with 0 after the end?
# in: gradient steps and planning by counting
# - Q = w[time] + p[time] @ V
# + Q = w[time] + 0.5 * (p[time] @ V)

# %% the last step alone
# slow
# says: it has learned something; does every step of both nights count, as often as it was taken, with its time, depth and action, are there enough passes over the comparisons, and enough nights with random actions in them to learn the policy? Has its target the largest value of the *next* state, without a discount, and in the last step the reward alone? Does it go on from the next observation, is α large enough, and does the policy take the best action by these values, and not by the rewards?
# in: visits as vectors
# - for (time, depth), action, _ in steps:
# + for (time, depth), action, _ in steps[-1:]:

# %% no time
# slow
# says: that is hardly better than random buttons; do the rewards change with every comparison, and does the policy use them?
# in: visits as vectors
# - table[time, depth, action] += 1
# + table[0, depth, action] += 1

# %% few questions
# slow
# says: it asks 30 of 300 comparisons; ask them all
# in: visits as vectors
# - for _ in range(n_comparisons):
# + for _ in range(n_comparisons // 10):

# %% the environment's rewards
# slow
# says: it chooses action 0 in every state
# in: visits as vectors
# - target = rewards[state][action] + Q[next_state].max()  # after the last step it is 0
# + target = 0.0 + Q[next_state].max()

# %% too many questions
# says: compare may be called 300 times, and this is one time more
# in: visits as vectors
# - for _ in range(n_comparisons):
# + for _ in range(n_comparisons + 1):

# %% half a night
# says: a night has 10 steps, from reset to the end, but one given has 4
# in: visits as vectors
# - observation, over = next_observation, terminated or truncated
# + observation, over = next_observation, len(steps) == 4

# %% no night
# says: compare takes two nights, each a list of (observation, action, next_observation), one for each step, but one of them is
# says: a list of (observation, action, next_observation), one for each step
# in: visits as vectors
# - preferred.append(float(compare(first, second)))
# + preferred.append(float(compare(visits(first), visits(second))))

# %% never asked
# says: calls compare(first, second)
# says: times, and nothing else says what is wanted
def my_program(environment, compare, n_comparisons, seed):
    return lambda observation: 1


# %% a clock written by hand
# says: With a teacher who
# says: likes to doze
# says: , the middle one of
# says: runs makes a clock worth
# says: to her, and it should be worth
# says: or more (random buttons
# says: , the best clock
# says: only her answers tell what is wanted: nothing that *you* know of good nights may be in the program, and time, depth and action may each change what a step is worth
def my_program(environment, compare, n_comparisons, seed):
    rng = np.random.default_rng(seed)

    def night():
        steps, (observation, _), over = [], environment.reset(), False
        while not over:
            action = int(rng.integers(3))
            after, _, terminated, truncated, _ = environment.step(action)
            steps.append((tuple(observation), action, tuple(after)))
            observation, over = after, terminated or truncated
        return steps

    for _ in range(20):
        compare(night(), night())

    def clock(observation):
        left, depth = 10 - observation[0], observation[1]
        if left > 2 or depth == 0:
            return 0
        return 2 if left == 1 else 1

    return clock


# %% the table
# says: should return a function from an observation to an action, but what it returns is
def my_program(environment, compare, n_comparisons, seed):
    return np.zeros((11, 3, 3))


# %% a night that was made up
# says: no night has a step from
# says: : give steps that were taken
def my_program(environment, compare, n_comparisons, seed):
    night = [((t, 2 if t == 0 else 0), 0, (t + 1, 0)) for t in range(10)]
    compare(night, night)


# %% steps that do not fit
# says: a night has a step from
# says: where the one before it ended in
# says: : give all the steps of one episode, in their order, with `next_observation` last
# in: visits as vectors
# - steps.append((tuple(observation), action, tuple(next_observation)))
# + steps.append((tuple(next_observation), action, tuple(observation)))

# %% no observations
# says: a step of a night is (observation, action, next_observation), but one given is
# in: visits as vectors
# - preferred.append(float(compare(first, second)))
# + preferred.append(float(compare([(s[0], a, t[0]) for s, a, t in first], [(s[0], a, t[0]) for s, a, t in second])))

# %% nothing comes back
# says: (environment, compare,
# says: gives None: return the policy, a function from an observation to an action
# in: visits as vectors
# - return lambda observation: int(Q[tuple(observation)].argmax())
# + policy = lambda observation: int(Q[tuple(observation)].argmax())

# %% an action that is not there
# says: , for the observation
# in: visits as vectors
# - return lambda observation: int(Q[tuple(observation)].argmax())
# + return lambda observation: 3

# %% a policy
# says: environment, compare, n_comparisons and seed
my_program = [0, 1, 2]

# %% actions are drawn
# slow
# says: returns draws its actions: asked twice about one observation
# says: cases. It should take the *best* action, and never a random one
# in: visits as vectors
# - return lambda observation: int(Q[tuple(observation)].argmax())
# + return lambda observation: int(rng.integers(3))

# %% γ = 0.9
# slow
# says: Another sleeper stays as she is after the first step. The teacher pays
# says: for a ring then, or
# says: for silence in the last step, if she is still asleep. Her answers tell so, and yet only
# says: clocks wait for it: what comes late counts in full, without a discount; the value of a state is that of its *best* action, not a mean; rewards are learned by y - p, in many passes, and a step may be worth another thing with each time, depth *and* action; and Q-learning needs many nights, with random buttons in them
# in: visits as vectors
# - target = rewards[state][action] + Q[next_state].max()  # after the last step it is 0
# + target = rewards[state][action] + 0.95 * Q[next_state].max()

# %% a mean over the actions
# slow
# says: the value of a state is that of its *best* action, not a mean
# in: gradient steps and planning by counting
# - V = Q.max(axis=1)
# + V = Q.mean(axis=1)

# %% a night compared with itself
# says: compare is given one list twice, of which neither is better: play two nights, and make a new list for each
# in: visits as vectors
# - preferred.append(float(compare(first, second)))
# + preferred.append(float(compare(first, first)))

# %% the first step has no reward
# slow
# says: One sleeper begins a night asleep or awake, and wakes and falls asleep again in turns, whatever is done. The teacher pays
# says: in the first step, for a chime if she is asleep, and for a ring if she is awake, and takes
# says: for the same later. Only
# says: clocks do both, and not again: each *time*, depth and action has its own reward, in the first step of *both* nights too (are the counts of the second night taken from those of the first?), and it belongs where it is looked up later: by the depth from which the step comes in both places, or by the one to which it leads
# in: visits as vectors
# - for (time, depth), action, _ in steps:
# + for (time, depth), action, _ in steps[1:]:

# %% learned by the next depth and looked up by this one
# slow
# says: it belongs where it is looked up later: by the depth from which the step comes in both places, or by the one to which it leads
# in: visits as vectors
# - for (time, depth), action, _ in steps:
# + for (time, _), action, (_, depth) in steps:

# %% luck of its own
# slow
# says: my_program does not repeat itself: two runs with seed 0 take different actions
# in: visits as vectors
# - rng = np.random.default_rng(seed)
# + rng = np.random.default_rng()

# %% random nights without a ring
# slow
# says: action 2 is never taken in the nights that my_program compares: draw a random button among all of them
# in: visits as vectors
# - first, second = (night_of(lambda state: int(rng.integers(3))) for _ in range(2))
# + first, second = (night_of(lambda state: int(rng.integers(2))) for _ in range(2))

# %% the same buttons in each night
# slow
# says: nights that you compare only
# says: different rows of actions are taken: make rng once, before the first night, and draw anew in each step
# in: visits as vectors
# - first, second = (night_of(lambda state: int(rng.integers(3))) for _ in range(2))
# + draws = [np.random.default_rng(seed + k) for k in range(2)]
# + first, second = (night_of(lambda state: int(draw.integers(3))) for draw in draws)

# %% the same luck in each night
# slow
# says: my_program gives reset the same seed
# says: times, and each time the same luck begins: give it to the first reset alone
# in: visits as vectors
# - observation, _ = environment.reset()
# + observation, _ = environment.reset(seed=seed)

# %% a policy by the rewards
# slow
# says: its actions are mostly those of a usual mistake:
# says: the policy takes the action with the largest reward, and it should be that with the largest value, which counts what comes later, too (or the target of these values lacks that of the next observation)
# in: visits as vectors
# - return lambda observation: int(Q[tuple(observation)].argmax())
# + return lambda observation: int(rewards[tuple(observation)].argmax())

# %% learned by the next observation and looked up by this one
# slow
# says: a reward is learned for the observation to which a step leads, and looked up for the one from which it comes: take the same one in both places
# in: visits as vectors
# - for (time, depth), action, _ in steps:
# + for _, action, (time, depth) in steps:

# %% rewards without actions
# slow
# says: a reward does not hang on the action: each time, depth *and* action has its own
# in: visits as vectors
# - table[time, depth, action] += 1
# + table[time, depth, 0] += 1
# - target = rewards[state][action] + Q[next_state].max()  # after the last step it is 0
# + target = rewards[state][0] + Q[next_state].max()

# %% one night of each pair
# slow
# says: are the counts of the second night taken from those of the first?
# in: visits as vectors
# - differences.append(visits(first) - visits(second))
# + differences.append(visits(first))

# %% rewards without time
# slow
# says: each *time*, depth and action has its own reward, in the first step of *both* nights too
# in: visits as vectors
# - table[time, depth, action] += 1
# + table[0, depth, action] += 1
# - rewards = rewards.reshape(shape)
# + rewards = np.tile(rewards.reshape(shape)[:1], (shape[0], 1, 1))
# - rewards += 0.02 * (differences.T @ (preferred - p) - 0.1 * rewards)
# + rewards += 0.002 * (differences.T @ (preferred - p) - 0.1 * rewards)

# %% values without time
# slow
# says: it does the same at every time: a state is the time *and* the depth, in the values and in the policy
# in: visits as vectors
# - target = rewards[state][action] + Q[next_state].max()  # after the last step it is 0
# - Q[state][action] += 0.1 * (target - Q[state][action])
# + target = rewards[state][action] + (state[0] < shape[0] - 2) * Q[0, next_state[1]].max()
# + Q[0, state[1], action] += 0.1 * (target - Q[0, state[1], action])
# - return lambda observation: int(Q[tuple(observation)].argmax())
# + return lambda observation: int(Q[0, observation[1]].argmax())

# %% the second night is not taken away
# slow
# says: clocks do both
# in: visits as vectors
# - rewards += 0.02 * (differences.T @ (preferred - p) - 0.1 * rewards)
# + rewards += 0.02 * (firsts.T @ (preferred - p) - 0.1 * rewards)
# - differences, preferred = [], []
# + differences, preferred, firsts = [], [], []
# - differences.append(visits(first) - visits(second))
# + differences.append(visits(first) - visits(second))
# + firsts.append(visits(first))
# - differences, preferred = np.array(differences), np.array(preferred)
# + differences, preferred, firsts = np.array(differences), np.array(preferred), np.array(firsts)

# %% the sign of the error
# slow
# says: that is worse than random buttons: does the *preferred* night gain, so that w grows by α (y - p), and not by α (p - y), and is the *best* action taken? (Or are few of the comparisons learned from?)
# in: visits as vectors
# - rewards += 0.02 * (differences.T @ (preferred - p) - 0.1 * rewards)
# + rewards += 0.02 * (differences.T @ (p - preferred) - 0.1 * rewards)

# %% rewards without time that are planned with
# slow
# says: a reward does not hang on the time: each *time*, depth and action has its own
# in: gradient steps and planning by counting
# - Q = w[time] + p[time] @ V
# + Q = w[:-1].mean(axis=0) + p[time] @ V
