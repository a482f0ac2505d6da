"""The vector environment is n copies of the single one, and behaves as Gymnasium's own vector environments do."""

import copy
import pickle
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.error import ResetNeeded
from gymnasium.vector import AutoresetMode
from gymnasium.vector.utils import batch_space, concatenate, create_empty_array

from edugym.adapters.registration import Entry, find
from edugym.adapters.vector_env import MDPVectorEnv
from edugym.checks.parameters import in_short
from tests.contract.parameters import PARAMETERS, Keywords
from tests.contract.play import MODES, Copies, every_corner, every_environment, good_or_not, plain

BoulderEnv: Any = find("Boulder").load()


@every_corner
def test_copies(entry: Entry, keywords: Keywords) -> None:
    """Several copies (or one) are as many environments that draw from one stream, in every mode."""
    n = 1 if keywords == PARAMETERS[entry.name].corners[-1] else 3
    for mode in MODES:
        rng = np.random.default_rng(n)
        alone = Copies([entry.load()(**keywords) for _ in range(n)], mode, seed=17)
        vector = gymnasium.make_vec(entry.id, n, autoreset_mode=mode, **keywords).unwrapped
        assert isinstance(vector, MDPVectorEnv)
        space = vector.single_observation_space
        assert (space, vector.single_action_space) == (alone.envs[0].observation_space, alone.envs[0].action_space)
        assert vector.observation_space == batch_space(space, n)
        assert vector.action_space == batch_space(vector.single_action_space, n)
        assert vector.metadata["autoreset_mode"] == mode

        def batch(values: Any, space: Any = space) -> Any:
            rows: Any = create_empty_array(space, n)
            return plain(concatenate(space, values, rows))

        assert plain(vector.reset(seed=17)) == (batch(alone.observations), {})
        for env in alone.envs:
            env.action_space.seed(int(rng.integers(2**31)))
        for _ in range(40):
            together = zip(alone.envs, alone.infos, strict=True)
            chosen = [good_or_not(entry.name, info, env, env.action_space, rng) for env, info in together]
            actions = np.array(chosen, vector.single_action_space.dtype)
            rewards, terminations, truncations, last = alone.step(actions)
            observations, *seen, infos = vector.step(actions)
            assert plain(observations) == batch(alone.observations)
            assert plain(seen) == plain([np.array(rewards), np.array(terminations), np.array(truncations)])
            assert vector.observation_space.contains(observations)
            assert plain([vector.state(i) for i in range(n)]) == plain([env.state for env in alone.envs])
            assert plain(vector.np_random) == plain(alone.envs[0].np_random)
            ended = [observation is not None for observation in last]
            assert set(infos) == ({"final_obs", "_final_obs"} if any(ended) else set())
            if any(ended):
                assert infos["_final_obs"].tolist() == ended
                assert plain(list(infos["final_obs"])) == plain(last)
            if mode is AutoresetMode.DISABLED and any(alone.over):
                with pytest.raises(ResetNeeded, match=rf"finished copies \[{np.flatnonzero(alone.over)[0]}"):
                    vector.step(actions)
                mask = np.array(alone.over)
                for i in np.flatnonzero(mask):
                    alone.restart(int(i))
                assert plain(vector.reset(options={"reset_mask": mask})) == (batch(alone.observations), {})


@every_environment
def test_bad_actions(entry: Entry) -> None:
    """Wrong actions, also of one copy alone, raise a ValueError that names them and the space; nothing is stepped."""
    vector = MDPVectorEnv(entry.load()(render_mode="ansi"), 3)
    for call in (lambda: vector.step(vector.action_space.sample()), vector.render):
        with pytest.raises(ResetNeeded, match="before the first reset"):
            call()
    vector.reset(seed=0)
    good, space = vector.action_space.sample(), vector.single_action_space
    bad: list[Any] = [None, "left", good[:2], good[0], [good] * 3, good.astype(complex), np.array(["a", "b", "c"])]
    if isinstance(space, spaces.Discrete):
        bad += [[0, 0, int(space.n)], [-1, 0, 0], [0, 2**62, 0], np.array([0, 2**64 - 1, 0], np.uint64)]
        bad += [[0.0, 0.0, 0.0], [0, 0, 0.5], [True, False, True], [0, None, 0]]
    elif isinstance(space, spaces.MultiDiscrete):
        bad += [-np.ones_like(good), good + space.nvec]
    else:
        bad += [good * np.nan, good * np.inf]
    before = plain(([vector.state(i) for i in range(3)], vector.np_random))
    for actions in bad:
        with pytest.raises(ValueError, match="not in the action space") as caught:
            pytest.fail(f"{actions!r} are taken as actions: {vector.step(actions)}")
        assert in_short(actions) in str(caught.value)
        assert str(vector.action_space) in str(caught.value)
        assert plain(([vector.state(i) for i in range(3)], vector.np_random)) == before
    vector.step(good)
    assert list(map(type, vector.render() or [])) == [str] * 3


@every_environment
def test_bad_masks(entry: Entry) -> None:
    """A mask that is no array of n booleans raises a ValueError and changes nothing, the random stream included."""
    vector = MDPVectorEnv(entry.load()(), 3)
    vector.reset(seed=0)
    before = plain(([vector.state(i) for i in range(3)], vector.np_random))
    for mask in ([True] * 3, np.ones(2, np.bool_), np.ones(3, np.int64), np.ones((3, 1), np.bool_), None, True, "all"):
        with pytest.raises(ValueError, match="reset_mask must be an array of 3 booleans, but is") as caught:
            vector.reset(seed=5, options={"reset_mask": mask})
        assert in_short(mask) in str(caught.value)
        assert plain(([vector.state(i) for i in range(3)], vector.np_random)) == before
    vector.reset(options={"reset_mask": np.zeros(3, np.bool_)})
    assert plain(([vector.state(i) for i in range(3)], vector.np_random)) == before


@every_environment
def test_copied(entry: Entry) -> None:
    """Copied or pickled it continues in the same way, apart from the first, and nothing writes to what was given."""
    vector = MDPVectorEnv(entry.load()(), 3, "SameStep")
    vector.action_space.seed(0)
    given: list[Any] = [vector.reset(seed=0)[0], [vector.action_space.sample() for _ in range(20)]]
    kept = [plain(part) for part in given]
    plays = given[1]
    for actions in plays[:5]:
        vector.step(actions)
    for one in (vector, copy.deepcopy(vector), pickle.loads(pickle.dumps(vector))):
        for actions in plays:
            given.append(one.step(actions))
            kept.append(plain(given[-1]))
    assert kept[2:22] == kept[22:42] == kept[42:]
    assert [plain(part) for part in given] == kept


def test_wrong_parameters() -> None:
    """The number of copies is 1 or more, and the mode is one of Gymnasium's."""
    wrong: list[Any] = [0, -1, 1.0, "2", None, True]
    for n in wrong:
        with pytest.raises(ValueError, match="num_envs"):
            MDPVectorEnv(BoulderEnv(), n)
    with pytest.raises(ValueError, match="Sometimes"):
        MDPVectorEnv(BoulderEnv(), 2, "Sometimes")
