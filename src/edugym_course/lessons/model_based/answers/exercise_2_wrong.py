# %% no return
# says: ) gives None: is a `return` missing?
# in: the solution of imagine
# - return reward + bonus + self.discount * value
# + reward + bonus + self.discount * value


# %% no bonus
# says: the bonus is missing
# says: ), where γ = 0.75, κ = 2,
# in: the solution of imagine
# - return reward + bonus + self.discount * value
# + return reward + self.discount * value


# %% no root
# says: the root is missing: the bonus is κ√τ
# in: the solution of imagine
# - bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
# + bonus = self.kappa * (self.clock[0] - self.last[s, a])


# %% kappa under the root
# says: κ belongs before the root: κ√τ, not √(κτ)
# in: the solution of imagine
# - bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
# + bonus = (self.kappa * (self.clock[0] - self.last[s, a])) ** 0.5


# %% the bonus subtracted
# says: the bonus is subtracted
# in: the solution of imagine
# - return reward + bonus + self.discount * value
# + return reward - bonus + self.discount * value


# %% no bonus for what was never tried
# says: only actions that were tried get a bonus, and those that were never tried need it most
# says: , the action was never tried and Q[
# in: the solution of imagine
# - bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
# + bonus = (self.last[s, a] > 0) * self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5


# %% a bonus for what was never tried only
# says: only actions that were never tried get a bonus; every action does
# in: the solution of imagine
# - bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
# + bonus = (self.last[s, a] == 0) * self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5


# %% the time of the last try
# says: τ is the time *since* the last try, `now − last`, and that is the time of the last try
# in: the solution of imagine
# - bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
# + bonus = self.kappa * self.last[s, a] ** 0.5


# %% the clock
# says: τ is the time since the last try; subtract `last` from the clock
# in: the solution of imagine
# - bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
# + bonus = self.kappa * self.clock[0] ** 0.5


# %% one more
# says: τ is one too large
# in: the solution of imagine
# - bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
# + bonus = self.kappa * (self.clock[0] - self.last[s, a] + 1) ** 0.5


# %% the end ignored
# says: after a terminal state there is no future: leave γ max_a Q(S', a) out where `ends` is 1
# in: the solution of imagine
# - value = 0.0 if ended else max(self.Q[next_state])
# + value = max(self.Q[next_state])


# %% what was never tried is the bonus alone
# says: an action that was never tried is imagined to lead back to its own state, so γ max_a Q(s, a) belongs to its
#   target
# in: the solution of imagine
# - reward, next_state, ended = 0.0, s, False
# + reward, next_state, ended = 0.0, s, True


# %% what was never tried is 0
# says: an action that was never tried has a target too: reward 0, back to its own state, and the bonus
# in: the solution of imagine
# - def imagine(self, s, a):
# + def imagine(self, s, a):
# +     if self.last[s, a] == 0:
# +         return 0.0


# %% reads the empty tables
# says: an action that was never tried has nothing in the tables yet, so do not read `next_states` there: it leads back
#   to its own state
# in: the solution of imagine
# - reward, next_state, ended = 0.0, s, False
# + reward = 0.0


# %% the mean
# says: the mean over the actions stands where the maximum should
# in: the solution of imagine
# - value = 0.0 if ended else max(self.Q[next_state])
# + value = 0.0 if ended else self.Q[next_state].mean()


# %% the own state
# says: the maximum is taken over Q(s, a) of the state itself instead of the next state
# in: the solution of imagine
# - value = 0.0 if ended else max(self.Q[next_state])
# + value = 0.0 if ended else max(self.Q[s])


# %% the same action
# says: the value of the *same* action stands where the maximum over all actions should
# in: the solution of imagine
# - value = 0.0 if ended else max(self.Q[next_state])
# + value = 0.0 if ended else self.Q[next_state, a]


# %% no future
# says: the value of the next state is missing
# in: the solution of imagine
# - return reward + bonus + self.discount * value
# + return reward + bonus


# %% no discount
# says: the value of the next state is not discounted
# in: the solution of imagine
# - return reward + bonus + self.discount * value
# + return reward + bonus + value


# %% the bonus discounted
# says: the bonus is discounted; γ belongs to the value of the next state only
# in: the solution of imagine
# - return reward + bonus + self.discount * value
# + return reward + self.discount * (bonus + value)


# %% no reward
# says: the reward is missing
# in: the solution of imagine
# - return reward + bonus + self.discount * value
# + return bonus + self.discount * value


# %% the TD error
# says: that is the TD error: return the whole target, which `act` puts into Q
# in: the solution of imagine
# - return reward + bonus + self.discount * value
# + return reward + bonus + self.discount * value - self.Q[s, a]


# %% no bonus at the end
# says: at the end of an episode the bonus is lost: only the value of the next state is 0 there
# in: the solution of imagine
# - return reward + bonus + self.discount * value
# + return reward + (0.0 if ended else bonus) + self.discount * value


# %% does the update itself
# says: changes a table: it should only return the target, and `act` puts that into Q
# in: the solution of imagine
# - return reward + bonus + self.discount * value
# + self.Q[s, a] = reward + bonus + self.discount * value


# %% not solved
# says: Not solved yet
def imagine(self, s, a):
    raise NotImplementedError


# %% any action of the state asked
# says: that asks whether any action of the state was tried; ask whether this *pair* was tried: `self.last[s, a] == 0`
# says: this *pair*
# in: the solution of imagine
# - if self.last[s, a] == 0:
# + if max(self.last[s]) == 0:


# %% the value of the action that was never tried
# says: for an action that was never tried the target has the *largest* value of the state, max_a Q(s, a), and not the
#   value of that action
def imagine(self, s, a):
    bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
    if self.last[s, a] == 0:
        return bonus + self.discount * self.Q[s, a]
    value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
    return self.rewards[s, a] + bonus + self.discount * value


# %% by the reward asked
# says: a reward may be 0, so it does not say that nothing was tried; ask whether this *pair* was tried: `self.last[s,
#   a] == 0`
# says: this *pair*
# in: the solution of imagine
# - if self.last[s, a] == 0:
# + if self.rewards[s, a] == 0:


# %% by the next state asked
# says: the next state may be 0, so it does not say that nothing was tried; ask whether this *pair* was tried:
#   `self.last[s, a] == 0`
# says: this *pair*
# in: the solution of imagine
# - if self.last[s, a] == 0:
# + if self.next_states[s, a] == 0:


# %% the discount as a number
# says: everything fits a discount of 0.99: use self.discount
# in: the solution of imagine
# - return reward + bonus + self.discount * value
# + return reward + bonus + 0.99 * value


# %% kappa as a number
# says: everything fits a κ of 0.03: use self.kappa
# in: the solution of imagine
# - bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
# + bonus = 0.03 * (self.clock[0] - self.last[s, a]) ** 0.5


# %% another class
# says: DynaPlus should have the method `imagine`
class DynaPlus(NamedTuple):
    Q: np.ndarray
    discount: float = 0.99
    kappa: float = 0.03

    def act(self, state, rng):
        return 0

    def learn(self, state):
        pass

    @classmethod
    def create(cls, environment):
        return cls(np.zeros((6, 3)))


# %% one more, another way
# says: the reward
# says: the discounted value that follows
# says: : which of them is another one in your code?
def imagine(self, s, a):
    return self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5 + self.discount * self.Q[s].max() + 1.0


# %% a maximum that starts from 0
# says: the maximum starts from 0, and all values may be lower: start from the first one
# in: the solution of imagine
# - value = 0.0 if ended else max(self.Q[next_state])
# + value = 0.0 if ended else max(0.0, *self.Q[next_state])


# %% step 1 is forgotten
# says: a pair that was tried in step 1 has `last` = 1: only 0 means that it was never tried
# in: the solution of imagine
# - if self.last[s, a] == 0:
# + if self.last[s, a] <= 1:


# %% no kappa
# says: κ is missing: the bonus is κ√τ
# in: the solution of imagine
# - bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
# + bonus = (self.clock[0] - self.last[s, a]) ** 0.5


# %% the end the wrong way round
# says: the test of `ends` is the wrong way round: the value of the next state counts where it is 0
# in: the solution of imagine
# - value = 0.0 if ended else max(self.Q[next_state])
# + value = max(self.Q[next_state]) if ended else 0.0


# %% never the wrong way round
# says: the test of whether the pair was tried is the wrong way round: `self.last[s, a] == 0` means never
# in: the solution of imagine
# - if self.last[s, a] == 0:
# + if self.last[s, a] > 0:


# %% a logarithm
# says: it should add up the reward,
# says: , the bonus,
# says: , and the discounted value that follows,
# says: the reward
# says: the discounted value that follows
# says: : which of them is another one in your code?
# in: the solution of imagine
# - bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
# + bonus = self.kappa * np.log(1 + self.clock[0] - self.last[s, a])
