# %% no discount
# says: the potential of the next state counts γ φ(s'), with the discount
# says: , potential, 'bed', 'door',
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + (0 if terminated else potential(next_state)) - potential(state)


# %% the end has a potential
# says: after a terminal state there is nothing: its potential is 0 when `terminated`
# says: ) with potential('bed') =
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + discount * potential(next_state) - potential(state)


# %% neither discount nor end
# says: both mistakes: γ is missing before φ(s'), and the potential of a terminal state is 0
# says: and potential('door') =
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + potential(next_state) - potential(state)


# %% the sign
# says: the sign is wrong: it is what the potential *gains*, γ φ(s') − φ(s)
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0 if terminated else discount * potential(next_state)
    return reward + potential(state) - after


# %% no bill
# says: φ(s) is not subtracted: that is a bonus which can be farmed
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + (0 if terminated else discount * potential(next_state))


# %% a plain bonus
# says: that is a bonus for the next state, without discount and without the bill φ(s)
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + potential(next_state)


# %% the reward alone
# says: that is the reward alone, without shaping
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward


# %% the shaping alone
# says: that is the shaping reward alone; add the reward
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0 if terminated else discount * potential(next_state)
    return after - potential(state)


# %% no bill at the end
# says: at the end the bill still has to be paid: − φ(s) counts also when `terminated`
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    if terminated:
        return reward
    return reward + discount * potential(next_state) - potential(state)


# %% all of it discounted
# says: only φ(s') is discounted, not φ(s)
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0 if terminated else potential(next_state)
    return reward + discount * (after - potential(state))


# %% the discount at the other one
# says: γ belongs before φ(s'), not before φ(s)
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0 if terminated else potential(next_state)
    return reward + after - discount * potential(state)


# %% the reward discounted
# says: the reward itself is not discounted
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0 if terminated else potential(next_state)
    return discount * (reward + after) - potential(state)


# %% states exchanged
# says: the two states have changed places
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    before = 0 if terminated else potential(state)
    return reward + discount * before - potential(next_state)


# %% both added
# says: + φ(s) stands where − φ(s) should
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0 if terminated else potential(next_state)
    return reward + discount * after + potential(state)


# %% the other potential is 0 at the end
# says: when `terminated`, φ(s') is 0, and not φ(s)
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    before = 0 if terminated else potential(state)
    return reward + discount * potential(next_state) - before


# %% the wrong way round
# says: `terminated` is the wrong way round: φ(s') counts when it is False
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = potential(next_state) if terminated else 0
    return reward + discount * after - potential(state)


# %% the other potential, and the wrong way round
# says: both: when `terminated` is True it is φ(s') that is 0, and not φ(s) when it is False
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    before = potential(state) if terminated else 0
    return reward + discount * potential(next_state) - before


# %% the potential as a table
# says: a function is called, with parentheses
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + discount * potential[next_state] - potential[state]


# %% discount and end exchanged
# says: γ φ(s') is missing; it counts unless `terminated`
def shaped_reward(reward, potential, state, next_state, discount, terminated):
    return reward + (0 if terminated else discount * potential(next_state)) - potential(state)


# %% a value
# says: reward, potential, state, next_state, terminated and discount
shaped_reward = 1.0


# %% nothing at the end
# says: the reward counts at the end too, when `terminated`
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    if terminated:
        return 0.0
    return reward + discount * potential(next_state) - potential(state)


# %% no reward at the end
# says: when `terminated`, only φ(s') is 0; the reward still counts
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    if terminated:
        return -potential(state)
    return reward + discount * potential(next_state) - potential(state)


# %% gains only
# says: F may be below 0: what the potential loses is taken back
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0.0 if terminated else potential(next_state)
    gain = discount * after - potential(state)
    return reward + max(gain, 0.0)


# %% without its sign
# says: F may be below 0, and its absolute value is not asked for
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0.0 if terminated else potential(next_state)
    gain = discount * after - potential(state)
    return reward + abs(gain)


# %% the state's potential
# says: φ(s) is subtracted and not added, and γ φ(s') is missing
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + potential(state)


# %% all discounted
# says: only φ(s') is discounted, and not all of it
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0.0 if terminated else potential(next_state)
    return discount * (reward + after - potential(state))


# %% a product
# says: F is added to the reward and not multiplied by it
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0.0 if terminated else potential(next_state)
    gain = discount * after - potential(state)
    return reward * gain


# %% rounded
# says: is it rounded? Give the number as it is, without round(), int() or //
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0.0 if terminated else potential(next_state)
    gain = discount * after - potential(state)
    return round(reward + gain, 1)


# %% no brackets around the reward's part
# says: the reward counts when `terminated`, and F otherwise, but never both: `a + b if c else d` means `(a + b) if c else
#   d`, so put the part with `if` in parentheses
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + 0.0 if terminated else discount * potential(next_state) - potential(state)


# %% no brackets around what follows
# says: φ(s) counts when `terminated`, and all the rest otherwise: `a if c else b - d` means `a if c else (b - d)`, so
#   put the part with `if` in parentheses
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + discount * potential(next_state) if not terminated else 0.0 - potential(state)


# %% half of what is gained
# says: in all cases γ φ(s') counts 0.5 times and −φ(s) counts 0.5 times, and should count once
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0.0 if terminated else potential(next_state)
    return reward + 0.5 * (discount * after - potential(state))


# %% sizes of potentials
# says: a potential may be below 0, and then it counts as it is
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = 0.0 if terminated else abs(potential(next_state))
    return reward + discount * after - abs(potential(state))


# %% nothing where the state stays
# says: should be 17, but is 20: it should add up the reward, 20, γ φ(s'), 9, and −φ(s), -12: which of them is another
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    if state == next_state:
        return reward
    after = 0.0 if terminated else potential(next_state)
    return reward + discount * after - potential(state)
