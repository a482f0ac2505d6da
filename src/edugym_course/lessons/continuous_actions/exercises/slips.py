"""The usual mistakes in REINFORCE with a baseline, by the sentences that tell of them."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

MISTAKES: Mapping[str, Mapping[str, Any]] = MappingProxyType(
    {
        "the factor γ^t is missing in the step of the preferences": {"power": "none"},
        "the power of γ counts the steps from the *end*; t counts from the start": {"power": "end"},
        "the power of γ is one too high: the first step has γ^0 = 1": {"power": "next"},
        "V(S_t) is not subtracted: δ is the return less the baseline": {"baseline": "none"},
        "the baseline is V(S_t), not the mean of the rewards": {"baseline": "mean"},
        "the baseline is V(S_t), not the mean of the returns": {"baseline": "mean return"},
        "V moves, but the baseline of the preferences is the mean of the returns, and it should be V(S_t)": {
            "delta": "of the mean"
        },
        "V[t] is the value of state t; that of the state of step t is V[self.states[t]]": {"V": "t"},
        "the baseline is V(S_t), not the largest of all values": {"baseline": "largest"},
        "V moves, but the preferences move by the reward instead of δ": {"delta": "reward"},
        "V moves, but the preferences move by G instead of δ": {"delta": "return"},
        "the baseline V does not change": {"value": "none"},
        "V is set to α^w δ; write `+=`": {"value": "set"},
        "V moves by the whole δ; multiply it by α^w": {"value": "whole"},
        "V moves away from the return: the sign is wrong": {"value": "away"},
        "V moves by α^w G instead of α^w δ": {"value": "return"},
        "δ is computed again after V has changed; use the one from before": {"late": True},
        "the two learning rates have changed places": {"rates": "swapped"},
        "V has a learning rate of its own, value_learning_rate": {"rates": "policy"},
        "that is the reward R_{t+1}, not the return G_t": {"return": "reward"},
        "the return is not discounted: G_t = R_{t+1} + γ G_{t+1}": {"return": "undiscounted"},
        "every step gets the return of the whole episode; it should be the one from step t on": {"return": "first"},
        "the return G_t begins with the reward R_{t+1} = rewards[t], which is missing": {"return": "next"},
        "that is G_{t+1}, the return from the next step: is it noted before the reward of step t is added?": {
            "return": "of the next step"
        },
        "it adds the rewards from the start up to step t; the return adds those from step t on": {"return": "past"},
        "the reward R_{t+1} itself is discounted; only what follows it should be": {"return": "discounted reward"},
        "G_t is discounted from step t on, and not from the start of the episode": {"return": "absolute"},
        "the returns stand in the reverse order, as in a list that is filled from the last step on": {
            "return": "reversed"
        },
        "the return begins behind the end with V of the last state; an episode that is over has nothing more to come": {
            "return": "goes on"
        },
        "every step gets the last reward alone": {"return": "last"},
        "it goes through the whole of `rewards`; this episode has only its first n steps": {"return": "buffer"},
        "the return begins with rewards[n], which an earlier episode has left there: the last reward of n steps is"
        " rewards[n - 1]": {"return": "one more"},
        "π is missing in the score: it is 1{a = A} − π(a|S)": {"score": "one"},
        "only the preference of the action that was taken changes; all others change by −π": {"score": "own"},
        "the sign of the score is wrong: it is 1{a = A} − π(a|S)": {"score": "minus"},
        "the score is that of ln π; here the derivative of the preference is multiplied by π": {"score": "pi"},
        "that is 1/π for the action taken; the score of a softmax is 1{a = A} − π(a|S)": {"score": "inverse"},
        "1{a = A} is missing: the action that was taken gets 1 − π, the others −π": {"score": "others"},
        "all actions get 1 − π; only the one that was taken should, and the others −π": {"score": "all as taken"},
        "the action that was taken gets 1 − π, not 1: π is subtracted for it, too": {"score": "one or π"},
        "π should be subtracted in the score, not added": {"score": "plus"},
        "the probabilities are those of another state: call self.look(state) first": {"look": "never"},
        "the probabilities are those of the first state for all steps: call self.look(state) for every step": {
            "look": "first"
        },
        "the probabilities change between the actions of one step: call self.look(state) once, before that loop": {
            "look": "often"
        },
        "the probabilities are those from before the episode; they should be those of the preferences as the updates"
        " so far have left them": {"look": "old"},
        "δ is computed with V from before the episode; that is sound too, but in this box V is the one that the updates"
        " so far have left": {"values": "old"},
        "V moves after all steps of the policy; that is sound too, but in this box it moves first, in each step": {
            "values": "afterwards"
        },
        "a state that comes twice is updated twice, once for each step": {"visits": "one"},
        "that is the TD error of the actor-critic; here δ is the return less V(S_t)": {"delta": "TD"},
        "that is the TD error of the actor-critic, and at the last step it looks up states[n], which is not of this"
        " episode; here δ is the return less V(S_t)": {"delta": "TD, unwritten"},
        "that is the state after the step, states[t + 1], not S_t": {"state": "next"},
        "the return of the first step is missing, rewards[0] is still the reward: range(n - 1, -1, -1) goes down to"
        " 0": {"return": "not the first"},
        "the return of the first step is missing, it is still 0: range(n - 1, -1, -1) goes down to 0": {
            "return": "first zero"
        },
        "the preferences of the last state change in every step, not those of S_t": {"row": "last"},
        "an episode that is cut off is over as well: call `update` also when `truncated`": {"cut off": "forgotten"},
        "the first step of the episode is left out: range(n - 1, -1, -1) goes down to 0": {
            "steps": lambda n: range(1, n)
        },
        "the last step of the episode is left out: its number is n − 1": {"steps": lambda n: range(n - 1)},
        "it learns from all places of the arrays; the episode has only its first n steps: range(n)": {
            "steps": "buffer"
        },
        "only the first step learns: is `return` inside the loop?": {"steps": lambda n: range(1)},
        "the factor is γ^t, discount**t, and not γ": {"power": "once"},
        "δ is missing in the step of the preferences": {"delta": "missing"},
        "the power of γ counts the steps to the *end*; t counts from the start": {"power": "end+1"},
        "the factor is γ^t, discount**t, and not γ t": {"power": "product"},
        "γ^t belongs to the preferences alone; V moves by α^w δ": {"value": "discounted"},
        "the others get −π, not +π: it is 1{a = A} − π(a|S)": {"score": "others plus"},
        "the score takes the probabilities π, not the preferences: 1{a = A} − π(a|S)": {"score": "θ"},
        "preferences has two indices, the state and the action: self.preferences[a] is the whole row of state a": {
            "preferences": "rows"
        },
        "that is the number of the step; its state is self.states[t]": {"state": "t"},
        "preferences[t] is the row of state t; that of step t is preferences[self.states[t]]": {"row": "t"},
        "the preferences are set to their step; write `+=`": {"preferences": "set"},
        "self.look takes the *state* of step t, self.states[t], and not t": {"look": "t"},
        "set brackets around the score: the step is multiplied by (1{a = A} − π(a|S))": {"score": "no brackets"},
        "the learning rate of the preferences is missing": {"learning_rate": 1.0},
        "use `self.learning_rate` in place of 0.4: the check takes another one": {"learning_rate": 0.4},
        "use `self.value_learning_rate` in place of 0.4: the check takes another one": {"value_learning_rate": 0.4},
        "use `self.discount` in place of 0.99: the check takes another one": {"discount": 0.99},
        "use `self.learning_rate` and `self.value_learning_rate` in place of 0.4: the check takes others": {
            "learning_rate": 0.4,
            "value_learning_rate": 0.4,
        },
    }
)
"""By the sentence that tells of it, what each mistake changes in `episodes.after`."""
