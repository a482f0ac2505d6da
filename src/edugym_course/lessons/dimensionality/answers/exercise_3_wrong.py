# %% terminated is forgotten
# says: after a terminal state nothing follows: where `terminated` is 1 the target is the reward alone
# says: of the next state by the old weights, target_of should return
def target_of(self, row):
    dqn.forward(self.target, self.memory.next_states[row], self.h, self.Q)
    return self.memory.rewards[row] + self.discount * self.Q[0].max()


# %% the present weights
# says: the values of the next state come from the old weights, `self.target`
# says: and the values
def target_of(self, row):
    if self.memory.terminated[row] == 1:
        return self.memory.rewards[row]
    dqn.forward(self.weights, self.memory.next_states[row], self.h, self.Q)
    return self.memory.rewards[row] + self.discount * self.Q[0].max()


# %% the present state
# says: the value should be that of the next state, `memory.next_states[row]`
def target_of(self, row):
    if self.memory.terminated[row] == 1:
        return self.memory.rewards[row]
    dqn.forward(self.target, self.memory.states[row], self.h, self.Q)
    return self.memory.rewards[row] + self.discount * self.Q[0].max()


# %% no discount
# says: the discount is missing
def target_of(self, row):
    if self.memory.terminated[row] == 1:
        return self.memory.rewards[row]
    dqn.forward(self.target, self.memory.next_states[row], self.h, self.Q)
    return self.memory.rewards[row] + self.Q[0].max()


# %% the mean
# says: take the largest value, not the mean
def target_of(self, row):
    if self.memory.terminated[row] == 1:
        return self.memory.rewards[row]
    dqn.forward(self.target, self.memory.next_states[row], self.h, self.Q)
    return self.memory.rewards[row] + self.discount * self.Q[0].mean()


# %% the action of the memory
# says: take the best action in the next state, not the one that was taken before
# in: the solution of target_of
# - return memory.rewards[row] + self.discount * self.Q[0].max()
# + return memory.rewards[row] + self.discount * self.Q[0, memory.actions[row]]


# %% argmax
# says: that is the number of the best action; its value is needed
def target_of(self, row):
    if self.memory.terminated[row] == 1:
        return self.memory.rewards[row]
    dqn.forward(self.target, self.memory.next_states[row], self.h, self.Q)
    return self.memory.rewards[row] + self.discount * self.Q[0].argmax()


# %% the reward alone
# says: the value of the next state is missing
def target_of(self, row):
    return self.memory.rewards[row]


# %% nothing at the end
# says: at the end of an episode the target is the reward, not 0
def target_of(self, row):
    if self.memory.terminated[row] == 1:
        return 0.0
    dqn.forward(self.target, self.memory.next_states[row], self.h, self.Q)
    return self.memory.rewards[row] + self.discount * self.Q[0].max()


# %% the other way round
# says: the terminal case is the wrong way round
def target_of(self, row):
    if self.memory.terminated[row] == 0:
        return self.memory.rewards[row]
    dqn.forward(self.target, self.memory.next_states[row], self.h, self.Q)
    return self.memory.rewards[row] + self.discount * self.Q[0].max()


# %% the error
# says: the present value belongs to the error, not to the target
def target_of(self, row):
    memory = self.memory
    y = memory.rewards[row]
    if memory.terminated[row] == 0:
        dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
        y += self.discount * self.Q[0].max()
    dqn.forward(self.weights, memory.states[row], self.h, self.Q)
    return y - self.Q[0, memory.actions[row]]


# %% a row of values
# says: should be one number
def target_of(self, row):
    dqn.forward(self.target, self.memory.next_states[row], self.h, self.Q)
    return self.memory.rewards[row] + self.discount * self.Q[0]


# %% forward returns nothing
# says: NoneType
def target_of(self, row):
    return self.memory.rewards[row] + self.discount * dqn.forward(
        self.target, self.memory.next_states[row], self.h, self.Q
    )


# %% empty rows
# says: transitions, in a memory of
# says: you draw from
# says:  places, and
# says:  are filled. Their number is the smaller one of `self.steps[0]` and `len(self.memory.actions)`
def row_for(self, u):
    return int(u * len(self.memory.actions))


# %% one place too few
# says:  are filled: subtract no 1 from their number
def row_for(self, u):
    return int(u * (min(self.steps[0], len(self.memory.actions)) - 1))


# %% beyond the memory
# says: you draw from
# says: , but the places 0 to
def row_for(self, u):
    return int(u * self.steps[0])


# %% counted from 1
# says: places count from 0, so that the last one is their number less 1
def row_for(self, u):
    return int(u * min(self.steps[0], len(self.memory.actions))) + 1


# %% the last row never
# says: you draw from
# says: , every filled place should be equally likely:
def row_for(self, u):
    return int(u * max(min(self.steps[0], len(self.memory.actions)) - 1, 1))


# %% rounded
# says: multiply `u` by the number of filled places, and cut off by int(...); neither round(...) nor a remainder by % is even
def row_for(self, u):
    return round(u * (min(self.steps[0], len(self.memory.actions)) - 1))


# %% not whole
# says: : make it one by int(...)
# says: ) should be a whole number, but is
def row_for(self, u):
    return u * min(self.steps[0], len(self.memory.actions))


# %% a function
# says: should be the class
MyDQN = lambda task: DQN.create(task)


# %% it writes into the memory
# says: changes `self.memory.rewards`
# says: `; it should only read it, and return a number
def target_of(self, row):
    memory = self.memory
    if memory.terminated[row] == 0:
        dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
        memory.rewards[row] += self.discount * self.Q[0].max()
    return memory.rewards[row]


# %% random numbers of its own
# says: row_for(0.5) gives another place in every call: the random number is drawn already, it is `u`
def row_for(self, u):
    return int(np.random.random() * min(self.steps[0], len(self.memory.actions)))


# %% it counts the draws
# says: row_for(0.5) changes `self.steps`: only read it, and return a place
def row_for(self, u):
    self.steps[0] += 1
    return int(u * min(self.steps[0] - 1, len(self.memory.actions)))


# %% the array of steps
# says: take an entry of it
def row_for(self, u):
    return int(u * np.minimum(self.steps, len(self.memory.actions) * np.ones(2)))


# %% DQN for OpenDQN
# says: MyDQN should begin with `class MyDQN(OpenDQN):`, as it is OpenDQN that calls `target_of` and `row_for`
class MyDQN(DQN):
    __slots__ = ()

    def target_of(self, row):
        memory = self.memory
        if memory.terminated[row] == 1:
            return memory.rewards[row]
        dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
        return memory.rewards[row] + self.discount * self.Q[0].max()

    def row_for(self, u):
        return int(u * min(self.steps[0], len(self.memory.actions)))


# %% a method under another name
# says: MyDQN has no method `row_for` of its own
# says: ` of its own, so it uses that of OpenDQN: is the name spelt as in the exercise, and does the method stand inside
#   the class?
class MyDQN(OpenDQN):
    __slots__ = ()

    def target_of(self, row):
        memory = self.memory
        if memory.terminated[row] == 1:
            return memory.rewards[row]
        dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
        return memory.rewards[row] + self.discount * self.Q[0].max()

    def row_of(self, u):
        return int(u * min(self.steps[0], len(self.memory.actions)))


# %% the present weights and state
# says: the value should be that of the next state, by the old weights `self.target`
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.weights, memory.states[row], self.h, self.Q)
    best = np.max(self.Q[0])
    if memory.terminated[row] == 1:
        return memory.rewards[row]
    return memory.rewards[row] + self.discount * best


# %% the minimum
# says: take the largest value, not the smallest
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    best = np.min(self.Q[0])
    if memory.terminated[row] == 1:
        return memory.rewards[row]
    return memory.rewards[row] + self.discount * best


# %% the sum
# says: take the largest value, not the sum
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    best = np.sum(self.Q[0])
    if memory.terminated[row] == 1:
        return memory.rewards[row]
    return memory.rewards[row] + self.discount * best


# %% the first value
# says: the index is missing: that is the value of action 0, and the largest one is needed
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    best = self.Q[0, 0]
    if memory.terminated[row] == 1:
        return memory.rewards[row]
    return memory.rewards[row] + self.discount * best


# %% no reward
# says: the reward is missing
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    best = np.max(self.Q[0])
    if memory.terminated[row] == 1:
        return 0.0
    return self.discount * best


# %% all is discounted
# says: the reward is discounted as well; only the next value should be
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    best = np.max(self.Q[0])
    if memory.terminated[row] == 1:
        return memory.rewards[row]
    return self.discount * (memory.rewards[row] + best)


# %% double DQN
# says: that is the target of double DQN: here the old weights choose the action as well
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.weights, memory.next_states[row], self.h, self.Q)
    chosen = int(np.argmax(self.Q[0]))
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    best = self.Q[0, chosen]
    if memory.terminated[row] == 1:
        return memory.rewards[row]
    return memory.rewards[row] + self.discount * best


# %% no value after a good step
# says: that is none of the usual mistakes, so compare your code with the equation, term by term
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    best = np.max(self.Q[0])
    if memory.terminated[row] == 1:
        return memory.rewards[row]
    return memory.rewards[row] + (self.discount * best if row == 1 else 0.0)


# %% a maximum that starts from 0
# says: all values may be lower: the largest one is one of them, and not 0
# in: the solution of target_of
# - return memory.rewards[row] + self.discount * self.Q[0].max()
# + return memory.rewards[row] + self.discount * max(0.0, self.Q[0].max())


# %% without the sign
# says: take the largest value, and not the largest without its sign
# in: the solution of target_of
# - return memory.rewards[row] + self.discount * self.Q[0].max()
# + return memory.rewards[row] + self.discount * abs(self.Q[0]).max()


# %% the last action is never looked at
# says: the last action is left out of the maximum: its number is the number of actions less 1
def target_of(self, row):
    memory = self.memory
    if memory.terminated[row]:
        return memory.rewards[row]
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    best = self.Q[0, 0]
    for a in range(1, self.Q.shape[1] - 1):
        best = max(best, self.Q[0, a])
    return memory.rewards[row] + self.discount * best


# %% the first action is never looked at
# says: action 0 is left out of the maximum
def target_of(self, row):
    memory = self.memory
    if memory.terminated[row]:
        return memory.rewards[row]
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    return memory.rewards[row] + self.discount * np.max(self.Q[0, 1:])


# %% no forward
# says: that is what an earlier call left in `self.Q`: call dqn.forward(self.target, ...) first
def target_of(self, row):
    memory = self.memory
    if memory.terminated[row]:
        return memory.rewards[row]
    return memory.rewards[row] + self.discount * np.max(self.Q[0])


# %% what forward returns
# says: something is None there: is a `return` missing, or does what is called return nothing?
def target_of(self, row):
    memory = self.memory
    if memory.terminated[row]:
        return memory.rewards[row]
    values = dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    return memory.rewards[row] + self.discount * np.max(values)


# %% rounded up
# says: `u` may be 0, and that belongs to place 0: cut off by int(...), without a rounding up
def row_for(self, u):
    return int(np.ceil(u * min(self.steps[0], len(self.memory.actions)))) - 1


# %% rounded, of all places
# says: round(...) may round up, so that the last place is one too far; cut off by int(...)
def row_for(self, u):
    return round(u * min(self.steps[0], len(self.memory.actions)))


# %% cut off too early
# says: it is always place
# says: , whatever `u` is: multiply `u` by the number of filled places, and cut off after that, since int(u) is 0
def row_for(self, u):
    return int(u) * min(self.steps[0], len(self.memory.actions))


# %% the places of a batch
# says: you draw from
def row_for(self, u):
    return int(u * 32)


# %% no sign of the reward
# says: a reward may be negative: take it as it is
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    future = 0.0 if memory.terminated[row] else self.discount * np.max(self.Q[0])
    return abs(memory.rewards[row]) + future


# %% a minus for a plus
# says: the value of the next state is added, not subtracted
# in: the solution of target_of
# - return memory.rewards[row] + self.discount * self.Q[0].max()
# + return memory.rewards[row] - self.discount * self.Q[0].max()


# %% the number of a transition
# says: that counts the transitions from the first one on, but transition
# says: took place 0 again, and so on: the place of transition k is k %
# says: , with `len(self.memory.actions)` for
def row_for(self, u):
    return int(self.steps[0] - 1 - int(u * min(self.steps[0], len(self.memory.actions))))


# %% a remainder for the number of places
# says: , now that the memory is just full. Is the number of filled places a remainder by %, which is 0 here? It is the smaller one of `self.steps[0]` and `len(self.memory.actions)`
def row_for(self, u):
    return int(u * (self.steps[0] % len(self.memory.actions)))
