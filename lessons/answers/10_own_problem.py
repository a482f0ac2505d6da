# ruff: noqa
# Right and wrong answers to the exercises of lesson 10; tests/lessons/test_answers.py tries them all.
# An answer stands in the place of the exercise's cell. Methods without their class replace those of the solution.

# %% setup
from gymnasium.spaces import Box


class Plant(NamedTuple):
    """A plant that may dry out within ten days: the state is (day, water)."""

    days: int = 10
    action_space = property(lambda self: Discrete(2))
    observation_space = property(lambda self: MultiDiscrete([self.days + 1, 4]))

    def initial(self, rng):
        return 0, 2

    def transition(self, state, action, rng):
        day, water = state
        if action == 1:
            water = min(water + 2, 3)
        if rng.random() < 0.6:
            water = max(water - 1, 0)
        return day + 1, water

    def reward(self, state, action, next_state, rng):
        return (1.0 if 0 < next_state[1] < 3 else 0.0) - 0.2 * action

    def terminal(self, state):
        return state[0] == self.days or state[1] == 0

    def observation(self, state, rng):
        return state


# %% exercise 1, right: a fraction
# says: Right: 59/9. Below it the best clock lets her sleep on when she is fast asleep at 8:20. Nothing in its code says
#   so but a number.
late = 59 / 9

# %% exercise 1, right: two digits
late = 6.56

# %% exercise 1, right: rounded down
late = 6.555

# %% exercise 1, right: solved for the cost
ring, works = 4.0, 0.9
late = (ring + 2 - (1 - works) * 1) / works

# %% exercise 1, right: by a search
late = 0.0
while True:
    values = own_problem.solve(own_problem.Morning(late=late))
    if values.Q[values.model.row((7, 2))].argmax() == 2:
        break
    late += 0.005

# %% exercise 1, right: NumPy's number
late = np.float32(6.5556)

# %% exercise 1, right: by bisection
low, high = 0.0, 20.0
while high - low > 1e-4:
    middle = (low + high) / 2
    if -4 + 0.1 * (1 - middle) > 2 - middle:
        high = middle
    else:
        low = middle
late = high

# %% exercise 1, wrong: nothing was done
# says: that is the value with which the cell began
late = 10.0

# %% exercise 1, wrong: the placeholder
# says: Not solved yet
late = ...

# %% exercise 1, wrong: none
# says: Not solved yet
late = None

# %% exercise 1, wrong: a ring that never fails
# says: a ring fails with probability 0.1; then she is dozing, which is worth 1 and costs `late`
late = 6

# %% exercise 1, wrong: compared with the chime
# says: compare the ring with staying quiet, which is better there than a chime
late = 5.2 / 0.9

# %% exercise 1, wrong: dozing is worth nothing
# says: when the ring fails she is dozing, and that is worth 1
late = 6 / 0.9

# %% exercise 1, wrong: sleep is worth nothing after silence
# says: who stays asleep has slept: staying quiet is worth 2 − late
late = 3.9 / 0.9

# %% exercise 1, wrong: sleep is worth nothing at all
# says: staying quiet is worth 2 − late, and a failed ring 1 − late, as sleep is worth its depth
late = 4 / 0.9

# %% exercise 1, wrong: the cost of a ring
# says: that is the cost of a ring alone
late = 4.0

# %% exercise 1, wrong: the probabilities exchanged
# says: 0.9 and 0.1 have changed places: a ring *wakes* her with probability 0.9
late = 51

# %% exercise 1, wrong: negative
# says: late is a cost, and the reward function subtracts it: it is above 0
late = -6.5556

# %% exercise 1, wrong: a reward of zero
# says: best to stay quiet
# says: too low for a ring
late = 2.0

# %% exercise 1, wrong: too large
# says: higher than it need be
late = 8

# %% exercise 1, wrong: one digit
# says: ; you are close, round it to two digits after the decimal point
late = 6.6

# %% exercise 1, wrong: rounded the wrong way
# says: best to stay quiet
# says: round it to two digits
late = 6.55

# %% exercise 1, wrong: a text
# says: leave the quotes out
late = "6.56"

# %% exercise 1, wrong: a function
# says: is a function
late = lambda: 59 / 9

# %% exercise 1, wrong: the slider's list
# says: should be one number
late = [6.5, 7.0]


# %% exercise 1, wrong: the decimal point
# says: that is ten times as much, or the decimal point is in the wrong place
late = 590 / 9


# %% exercise 2, right: in one line
# says: Right: what is given on the way to a state is taken back when it is left. Here are both policies:
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + discount * (0 if terminated else potential(next_state)) - potential(state)


# %% exercise 2, right: with if
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    if terminated:
        return reward - potential(state)
    return reward + discount * potential(next_state) - potential(state)


# %% exercise 2, right: by multiplying
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + discount * potential(next_state) * (1 - terminated) - potential(state)


# %% exercise 2, right: other names
def shaped_reward(r, phi, s, s2, end, gamma):
    F = -phi(s)
    if not end:
        F += gamma * phi(s2)
    return r + F


# %% exercise 2, right: with NumPy
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = np.where(terminated, 0.0, potential(next_state))
    return reward + discount * after - potential(state)


# %% exercise 2, right: a helper inside
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    def phi(s, end=False):
        return 0.0 if end else potential(s)

    return reward + discount * phi(next_state, terminated) - phi(state)


# %% exercise 2, right: a lambda
shaped_reward = lambda r, p, s, n, end, g: r - p(s) + g * p(n) * (not end)


# %% exercise 2, wrong: no discount
# says: the potential of the next state counts γ φ(s'), with the discount
# says: , potential, 'bed', 'door',
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + (0 if terminated else potential(next_state)) - potential(state)


# %% exercise 2, wrong: the end has a potential
# says: after a terminal state there is nothing: its potential is 0 when `terminated`
# says: ) with potential('bed') =
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + discount * potential(next_state) - potential(state)


# %% exercise 2, wrong: neither discount nor end
# says: both mistakes: γ is missing before φ(s'), and the potential of a terminal state is 0
# says: and potential('door') =
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + potential(next_state) - potential(state)


# %% exercise 2, wrong: the sign
# says: the sign is wrong: it is what the potential *gains*, γ φ(s') − φ(s)
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0 if terminated else discount * potential(next_state)
    return reward + potential(state) - after


# %% exercise 2, wrong: no bill
# says: φ(s) is not subtracted: that is a bonus which can be farmed
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + (0 if terminated else discount * potential(next_state))


# %% exercise 2, wrong: a plain bonus
# says: that is a bonus for the next state, without discount and without the bill φ(s)
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + potential(next_state)


# %% exercise 2, wrong: the reward alone
# says: that is the reward alone, without shaping
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward


# %% exercise 2, wrong: the shaping alone
# says: that is the shaping reward alone; add the reward
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0 if terminated else discount * potential(next_state)
    return after - potential(state)


# %% exercise 2, wrong: no bill at the end
# says: at the end the bill still has to be paid: − φ(s) counts also when `terminated`
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    if terminated:
        return reward
    return reward + discount * potential(next_state) - potential(state)


# %% exercise 2, wrong: all of it discounted
# says: only φ(s') is discounted, not φ(s)
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0 if terminated else potential(next_state)
    return reward + discount * (after - potential(state))


# %% exercise 2, wrong: the discount at the other one
# says: γ belongs before φ(s'), not before φ(s)
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0 if terminated else potential(next_state)
    return reward + after - discount * potential(state)


# %% exercise 2, wrong: the reward discounted
# says: the reward itself is not discounted
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0 if terminated else potential(next_state)
    return discount * (reward + after) - potential(state)


# %% exercise 2, wrong: states exchanged
# says: the two states have changed places
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    before = 0 if terminated else potential(state)
    return reward + discount * before - potential(next_state)


# %% exercise 2, wrong: both added
# says: + φ(s) stands where − φ(s) should
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0 if terminated else potential(next_state)
    return reward + discount * after + potential(state)


# %% exercise 2, wrong: the other potential is 0 at the end
# says: when `terminated`, φ(s') is 0, and not φ(s)
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    before = 0 if terminated else potential(state)
    return reward + discount * potential(next_state) - before


# %% exercise 2, wrong: the wrong way round
# says: `terminated` is the wrong way round: φ(s') counts when it is False
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = potential(next_state) if terminated else 0
    return reward + discount * after - potential(state)


# %% exercise 2, wrong: the other potential, and the wrong way round
# says: both: when `terminated` is True it is φ(s') that is 0, and not φ(s) when it is False
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    before = potential(state) if terminated else 0
    return reward + discount * potential(next_state) - before


# %% exercise 2, wrong: no return
# says: is a `return` missing
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    reward += discount * potential(next_state) * (not terminated) - potential(state)


# %% exercise 2, wrong: the potential as a table
# says: a function is called, with parentheses
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + discount * potential[next_state] - potential[state]


# %% exercise 2, wrong: printed
# says: is a `return` missing
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    print(reward - potential(state))


# %% exercise 2, wrong: an argument left out
# says: its parameters are not those of the exercise
def shaped_reward(reward, potential, state, next_state, discount):
    return reward + discount * potential(next_state) - potential(state)


# %% exercise 2, wrong: discount and end exchanged
# says: γ φ(s') is missing; it counts unless `terminated`
def shaped_reward(reward, potential, state, next_state, discount, terminated):
    return reward + (0 if terminated else discount * potential(next_state)) - potential(state)


# %% exercise 2, wrong: a value
# says: reward, potential, state, next_state, terminated and discount
shaped_reward = 1.0


# %% exercise 3, right: counts last
# says: Right: one number more, and the next state depends on the state and the action alone again. See it learn:
def transition(self, state, action, rng):
    t, d, c = state
    u = rng.random()
    if action == 2:
        d = 0 if u < 0.9 else max(d - 1, 0)
    elif action == 1 and c < 2:
        if u < 0.7:
            d = max(d - 1, 0)
    elif u < 0.5:
        d = min(d + 1, 2)
    return t + 1, d, min(c + (action == 1), 2)


# %% exercise 3, right: with a flag
def transition(self, state, action, rng):
    time, depth, chimes = state
    heard = action == 1 and chimes != 2
    luck = rng.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif heard:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    if action == 1 and chimes < 2:
        chimes += 1
    return (time + 1, depth, chimes)


# %% exercise 3, right: an unheard chime becomes silence
def transition(self, state, action, rng):
    time, depth, chimes = state
    count = chimes
    if action == 1:
        count = min(chimes + 1, 2)
        if chimes == 2:
            action = 0
    luck = rng.random()
    if action == 0 and luck < 0.5:
        depth += 1
    if action == 1 and luck < 0.7:
        depth -= 1
    if action == 2:
        depth = 0 if luck < 0.9 else depth - 1
    return time + 1, max(0, min(2, depth)), count


# %% exercise 3, right: by the method of Morning
def transition(self, state, action, rng):
    time, depth, chimes = state
    what = 0 if action == 1 and chimes == 2 else action
    time, depth = own_problem.Morning().transition((time, depth), what, rng)
    return time, depth, chimes + 1 if action == 1 and chimes < 2 else chimes


# %% exercise 3, right: the space in numbers
@property
def observation_space(self):
    return MultiDiscrete([9, 3, 3])


# %% exercise 3, right: the start as a tuple
def initial(self, rng):
    return (0, 2, 0)


# %% exercise 3, right: the space as an array
@property
def observation_space(self):
    return MultiDiscrete(np.array([self.length + 1, 3, 3]))


def initial(self, rng):
    return tuple([0, 2, 0])


# %% exercise 3, wrong: three chimes work
# says: she hears every chime; after two of them a chime should be like silence (is it `chimes < 2`?)
# says: , rng) should lead to
def transition(self, state, action, rng):
    time, depth, chimes = state
    luck = rng.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1 and chimes <= 2:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    if action == 1:
        chimes = min(chimes + 1, 2)
    return time + 1, depth, chimes


# %% exercise 3, wrong: deaf to rings too
# says: after two chimes a ring does nothing any more: she is deaf to chimes only
def transition(self, state, action, rng):
    time, depth, chimes = state
    luck = rng.random()
    if action == 2 and chimes < 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1 and chimes < 2:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    if action == 1:
        chimes = min(chimes + 1, 2)
    return time + 1, depth, chimes


# %% exercise 3, wrong: counted first
# says: the second chime does nothing any more: look at how many chimes came *before* this one
def transition(self, state, action, rng):
    time, depth, chimes = state
    if action == 1:
        chimes = min(chimes + 1, 2)
    luck = rng.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1 and chimes < 2:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    return time + 1, depth, chimes


# %% exercise 3, wrong: she always hears it
# says: after two of them a chime should be like silence
def transition(self, state, action, rng):
    time, depth, chimes = state
    luck = rng.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
        chimes = min(chimes + 1, 2)
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    return time + 1, depth, chimes


# %% exercise 3, wrong: rings are counted
# says: rings are counted as well; count chimes only
def transition(self, state, action, rng):
    time, depth, chimes = state
    luck = rng.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1 and chimes < 2:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    if action != 0:
        chimes = min(chimes + 1, 2)
    return time + 1, depth, chimes


# %% exercise 3, wrong: every step is counted
# says: every action is counted; count a chime only
def transition(self, state, action, rng):
    time, depth, chimes = state
    luck = rng.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1 and chimes < 2:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    return time + 1, depth, min(chimes + 1, 2)


# %% exercise 3, wrong: never counted
# says: chimes are not counted: the third number has to grow with every chime
def transition(self, state, action, rng):
    time, depth, chimes = state
    luck = rng.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1 and chimes < 2:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    return time + 1, depth, chimes


# %% exercise 3, wrong: the count goes on
# says: the count goes on above 2, and leaves the observation space: keep it at 2
def transition(self, state, action, rng):
    time, depth, chimes = state
    luck = rng.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1 and chimes < 2:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    return time + 1, depth, chimes + (action == 1)


# %% exercise 3, wrong: silence sets it back
# says: the count is set back by another action; she does not unlearn what she is used to
def transition(self, state, action, rng):
    time, depth, chimes = state
    luck = rng.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1 and chimes < 2:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    return time + 1, depth, min(chimes + 1, 2) if action == 1 else 0


# %% exercise 3, wrong: an unheard chime changes nothing
# says: a chime that she does not hear leaves her sleep as it is; it should be like silence, in which it gets deeper
def transition(self, state, action, rng):
    time, depth, chimes = state
    luck = rng.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1:
        if chimes < 2:
            depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    if action == 1:
        chimes = min(chimes + 1, 2)
    return time + 1, depth, chimes


# %% exercise 3, wrong: not counted while she is awake
# says: a chime counts also when she is awake
def transition(self, state, action, rng):
    time, depth, chimes = state
    luck = rng.random()
    before = depth
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1 and chimes < 2:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    if action == 1 and before > 0:
        chimes = min(chimes + 1, 2)
    return time + 1, depth, chimes


# %% exercise 3, wrong: time stands still
# says: the time stands still: the first number has to grow by 1
def transition(self, state, action, rng):
    time, depth, chimes = state
    luck = rng.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1 and chimes < 2:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    if action == 1:
        chimes = min(chimes + 1, 2)
    return time, depth, chimes


# %% exercise 3, wrong: the old method
# says: too many values to unpack
def transition(self, state, action, rng):
    time, depth = state
    luck = rng.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    return time + 1, depth


# %% exercise 3, wrong: the count is left out of what is returned
# says: should return three numbers in a tuple, (time, depth, chimes), but returns
def transition(self, state, action, rng):
    time, depth, chimes = state
    luck = rng.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1 and chimes < 2:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    return time + 1, depth


# %% exercise 3, wrong: no return
# says: is a `return` missing
def transition(self, state, action, rng):
    time, depth, chimes = state
    chimes = min(chimes + (action == 1), 2)


# %% exercise 3, wrong: the old start
# says: initial(rng) should return three numbers
def initial(self, rng):
    return 0, 2


# %% exercise 3, wrong: a start with chimes
# says: initial should return (0, 2, 0), fast asleep and no chime yet, but returns
def initial(self, rng):
    return 0, 2, 2


# %% exercise 3, wrong: two values for the count
# says: observation_space should be MultiDiscrete([self.length + 1, 3, 3]), one number for each part of the state, but
#   is
@property
def observation_space(self):
    return MultiDiscrete([self.length + 1, 3, 2])


# %% exercise 3, wrong: the old space
# says: observation_space should be
@property
def observation_space(self):
    return MultiDiscrete([self.length + 1, 3])


# %% exercise 3, wrong: a value of the class
# says: should be the class
class UsedToIt(NamedTuple):
    length: int = 8


UsedToIt = UsedToIt()


# %% exercise 3, wrong: a list
# says: of the type list
def transition(self, state, action, rng):
    time, depth, chimes = state
    luck = rng.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1 and chimes < 2:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    return [time + 1, depth, min(chimes + (action == 1), 2)]


# %% exercise 3, wrong: parameters exchanged
# says: transition of UsedToIt must take (self, state, action, rng)
def transition(self, action, state, rng):
    time, depth, chimes = state
    luck = rng.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1 and chimes < 2:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    return time + 1, depth, min(chimes + (action == 1), 2)


# %% exercise 3, wrong: random numbers of its own
# says: draw from rng
def transition(self, state, action, rng):
    time, depth, chimes = state
    luck = random.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1 and chimes < 2:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    return time + 1, depth, min(chimes + (action == 1), 2)


# %% exercise 3, wrong: an array for a start
# says: of the type ndarray
def initial(self, rng):
    return np.array([0, 2, 0])


# %% exercise 3, wrong: the count is hidden
# says: should be the whole state, but is
# says: that method was right as it was, for only `observation_space`, `initial` and `transition` change
def observation(self, state, rng):
    return state[0], state[1], 0


# %% exercise 3, wrong: another end
# says: terminal((7, 0, 0)) should be False
def terminal(self, state):
    return state[0] >= self.length - 1


# %% exercise 3, wrong: pay for chimes
# says: reward((0, 0, 0), 0, (1, 1, 0), rng) should be 1, but is 0
def reward(self, state, action, next_state, rng):
    reward = float(next_state[2])
    if action == 2:
        reward -= self.ring
    if next_state[0] == self.length and next_state[1] > 0:
        reward -= self.late
    return reward


# %% exercise 3, wrong: a quarter
# says: that is none of the usual mistakes: write down by hand what can happen
def transition(self, state, action, rng):
    time, depth, chimes = state
    if rng.random() < 0.25:
        depth = max(depth - 1, 0)
    return time + 1, depth, chimes


# %% exercise 4, right: a plant
# says: A problem: 40 states, 2 actions, optimum 7.577.
my_problem = Plant()

# %% exercise 4, right: a plant for a month
my_problem = Plant(days=30)


# %% exercise 4, right: a gambler with whole numbers
class Gambler(NamedTuple):
    """Bet 1 or 2 coins, or stop."""

    goal: int = 6
    action_names = ("bet 1", "bet 2", "stop")
    observation_space = property(lambda self: Discrete(self.goal + 3))
    action_space = property(lambda self: Discrete(3))

    def initial(self, rng):
        return 3

    def transition(self, state, action, rng):
        if action == 2:
            return self.goal + 2
        stake = min(action + 1, state, self.goal - state)
        return state + stake if rng.random() < 0.45 else state - stake

    def reward(self, state, action, next_state, rng):
        if action == 2:
            return state / 2
        return 6.0 if next_state == self.goal else 0.0

    def terminal(self, state):
        return state == 0 or state >= self.goal

    def observation(self, state, rng):
        return state


my_problem = Gambler(goal=8)


# %% exercise 4, right: a queue, with the time in the state
class Tills(NamedTuple):
    """Open a second till when the queue gets long."""

    hours: int = 8
    observation_space = property(lambda self: MultiDiscrete([self.hours + 1, 7]))
    action_space = property(lambda self: Discrete(2))

    def initial(self, rng):
        return 0, 0

    def transition(self, state, action, rng):
        hour, waiting = state
        comes = 2 if rng.random() < 0.5 else 0
        return hour + 1, min(max(waiting + comes - 1 - action, 0), 6)

    def reward(self, state, action, next_state, rng):
        return -1.0 * next_state[1] - 1.5 * action

    def terminal(self, state):
        return state[0] == self.hours

    def observation(self, state, rng):
        return state


my_problem = Tills()


# %% exercise 4, wrong: a queue with a step limit
# says: my_problem has `max_steps`, so the best action depends on how many steps are left: keep the time in the state,
#   and end the episode by `terminal`, as Morning does
class Queue(NamedTuple):
    """Open a second till when the queue gets long."""

    max_steps: int = 20
    observation_space = property(lambda self: Discrete(7))
    action_space = property(lambda self: Discrete(2))

    def initial(self, rng):
        return 0

    def transition(self, state, action, rng):
        comes = 2 if rng.random() < 0.5 else 0
        return min(max(state + comes - 1 - action, 0), 6)

    def reward(self, state, action, next_state, rng):
        return -1.0 * next_state - 1.5 * action

    def terminal(self, state):
        return False

    def observation(self, state, rng):
        return state


my_problem = Queue()


# %% exercise 4, right: a phone
class Phone(NamedTuple):
    """Charge the phone now, or use it."""

    hours: int = 12
    observation_space = property(lambda self: MultiDiscrete([self.hours + 1, 5]))
    action_space = property(lambda self: Discrete(2))

    def initial(self, rng):
        return (0, 4)

    def transition(self, state, action, rng):
        hour, battery = state
        if action == 1:
            return (hour + 1, min(battery + 2, 4))
        return (hour + 1, max(battery - int(rng.random() * 3), 0))

    def reward(self, state, action, next_state, rng):
        if next_state[1] == 0:
            return -5
        return 1 if action == 0 else 0

    def terminal(self, state):
        return state[0] == self.hours

    def observation(self, state, rng):
        return state


my_problem = Phone()


# %% exercise 4, right: a bus stop
class BusStop(NamedTuple):
    """Wait for the bus, or walk."""

    longest: int = 10
    action_names = ("wait", "walk")
    observation_space = property(lambda self: Discrete(self.longest + 2))
    action_space = property(lambda self: Discrete(2))

    def initial(self, rng):
        return 0

    def transition(self, state, action, rng):
        if action == 1:
            return self.longest + 1
        return self.longest + 1 if rng.random() < 0.1 + 0.05 * state else min(state + 1, self.longest)

    def reward(self, state, action, next_state, rng):
        return -4.0 if action == 1 else -1.0 - 0.5 * (state < 3)

    def terminal(self, state):
        return state == self.longest + 1

    def observation(self, state, rng):
        return state


my_problem = BusStop(longest=4)._replace(longest=6)

# %% exercise 4, wrong: the placeholder
# says: Not solved yet
my_problem = ...

# %% exercise 4, wrong: the template
# says: that is the problem with which the cell began: write one of your own, under its own name
my_problem = Template(days=8)

# %% exercise 4, wrong: the problem of the lesson
# says: that is the problem of the lesson: write one of your own, under its own name
my_problem = own_problem.Morning(late=20.0)


# %% exercise 4, wrong: the class
# says: is the class Thirsty
class Thirsty(Plant):
    __slots__ = ()


my_problem = Thirsty

# %% exercise 4, wrong: a name
# says: is the name
my_problem = "Boulder"


# %% exercise 4, wrong: a method is missing
# says: must have a method terminal
class Clock(NamedTuple):
    observation_space = property(lambda self: Discrete(3))
    action_space = property(lambda self: Discrete(2))

    def initial(self, rng):
        return 0

    def transition(self, state, action, rng):
        return min(state + action, 2)

    def reward(self, state, action, next_state, rng):
        return 1.0

    def is_terminal(self, state):
        return state == 2

    def observation(self, state, rng):
        return state


my_problem = Clock()


# %% exercise 4, wrong: no NamedTuple
# says: should inherit from NamedTuple, as the form does: class
# says: (NamedTuple), with its numbers as fields and without __init__
class Plain:
    days = 3
    action_space = Discrete(2)
    observation_space = MultiDiscrete([4, 2])

    def initial(self, rng):
        return 0, 0

    def transition(self, state, action, rng):
        return state[0] + 1, int(rng.random() < 0.5)

    def reward(self, state, action, next_state, rng):
        return 1.0 * (action == state[1])

    def terminal(self, state):
        return state[0] == self.days

    def observation(self, state, rng):
        return state


my_problem = Plain()


# %% exercise 4, wrong: a queue without end
# says: states: does a number in its state grow without end? Give it a largest value, for example by min(queue + 1, 10)
# says: my_problem has more than
class Queue(NamedTuple):
    action_space = property(lambda self: Discrete(2))
    observation_space = property(lambda self: MultiDiscrete([1_000_000, 2]))

    def initial(self, rng):
        return 1, 0

    def transition(self, state, action, rng):
        return state[0] + int(rng.random() < 0.6) - action, int(rng.random() * 2)

    def reward(self, state, action, next_state, rng):
        return -1.0 * state[0]

    def terminal(self, state):
        return state[0] < 1

    def observation(self, state, rng):
        return state


my_problem = Queue()


# %% exercise 4, wrong: an episode that never ends
# says: no state of Endless is terminal, so an episode never ends: let `terminal` be True somewhere
class Endless(Plant):
    __slots__ = ()

    def transition(self, state, action, rng):
        return 0, min(max(state[1] + (1 if rng.random() < 0.5 else -1), 0), 3)

    def terminal(self, state):
        return state[0] == 1


my_problem = Endless()


# %% exercise 4, wrong: no chance
# says: my_problem should have chance in its dynamics: use `rng` in `transition`
class Sure(Plant):
    __slots__ = ()

    def transition(self, state, action, rng):
        day, water = state
        return day + 1, max(min(water + 2 * action, 3) - 1, 0)


my_problem = Sure()


# %% exercise 4, wrong: one name too few
# says: action_names of Named must have a name for each action
class Named(Plant):
    __slots__ = ()
    action_names = ("wait",)


my_problem = Named()


# %% exercise 4, wrong: the actions do nothing
# says: the best policy of my_problem earns no more than random actions: do the actions matter?
class Weather(Plant):
    __slots__ = ()

    def transition(self, state, action, rng):
        return state[0] + 1, int(rng.random() * 4)

    def reward(self, state, action, next_state, rng):
        return 1.0 * next_state[1]


my_problem = Weather()


# %% exercise 4, wrong: watering is free
# says: is best in every state, so there is nothing to decide: give it a price
# says: in my_problem the action
class Free(Plant):
    __slots__ = ()

    def reward(self, state, action, next_state, rng):
        return 1.0 * next_state[1]


my_problem = Free()


# %% exercise 4, wrong: one reward for everything
# says: every transition of my_problem has the same reward, so all policies are equal
class Flat(Plant):
    __slots__ = ()

    def reward(self, state, action, next_state, rng):
        return 0.0


my_problem = Flat()


# %% exercise 4, wrong: no end
# says: an episode never ends
class Forever(Plant):
    __slots__ = ()
    observation_space = property(lambda self: MultiDiscrete([2, 4]))

    def transition(self, state, action, rng):
        return 0, max(min(state[1] + 2 * action, 3) - int(rng.random() < 0.6), 0)

    def terminal(self, state):
        return False


my_problem = Forever()


# %% exercise 4, wrong: may never end
# says: may never end
class Maybe(Plant):
    __slots__ = ()
    observation_space = property(lambda self: MultiDiscrete([2, 4]))

    def transition(self, state, action, rng):
        return 0, max(min(state[1] + 2 * action, 3) - int(rng.random() < 0.6), 0)

    def terminal(self, state):
        return state[1] == 0


my_problem = Maybe()


# %% exercise 4, wrong: dice of its own
# says: draw from rng
class Dice(Plant):
    __slots__ = ()

    def transition(self, state, action, rng):
        return state[0] + 1, np.random.randint(4)


my_problem = Dice()


# %% exercise 4, wrong: a reward on some paths only
# says: is a return missing
class Sometimes(Plant):
    __slots__ = ()

    def reward(self, state, action, next_state, rng):
        if next_state[1] == 0:
            return -1.0


my_problem = Sometimes()


# %% exercise 4, wrong: out of its space
# says: must return an element of
class Space(Plant):
    __slots__ = ()
    observation_space = property(lambda self: MultiDiscrete([self.days, 3]))


my_problem = Space()


# %% exercise 4, wrong: states with fractions
# says: no finite model
class Fine(Plant):
    __slots__ = ()
    observation_space = property(lambda self: Box(0.0, 100.0, (2,)))

    def transition(self, state, action, rng):
        return state[0] + 1, state[1] + rng.random()

    def observation(self, state, rng):
        return np.array(state, np.float32)


my_problem = Fine()


# %% exercise 4, wrong: a mistake in a method
# says: raises NameError
class Typo(Plant):
    __slots__ = ()

    def reward(self, state, action, next_state, rng):
        return watter * 1.0


my_problem = Typo()


# %% exercise 4, wrong: too small
# says: my_problem should have two actions and four states or more, but has
class Coin(NamedTuple):
    observation_space = property(lambda self: Discrete(2))
    action_space = property(lambda self: Discrete(2))

    def initial(self, rng):
        return 0

    def transition(self, state, action, rng):
        return 1 if rng.random() < 0.5 else 0

    def reward(self, state, action, next_state, rng):
        return 1.0 * action * next_state

    def terminal(self, state):
        return state == 1

    def observation(self, state, rng):
        return state


my_problem = Coin()
