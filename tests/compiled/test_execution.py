"""What a student meets when code runs fast: the same results, ordinary tracebacks, and one plain warning at most."""

import traceback
import warnings
from itertools import count as count_up
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from unittest.mock import Mock

import numpy as np
import pytest

import edugym
from edugym.adapters.gymnasium_env import MDPEnv
from edugym.adapters.vector_env import MDPVectorEnv
from edugym.compiled import compiler, execution
from edugym.compiled.code import code_of
from edugym.compiled.execution import COMPILE_FROM, executable
from edugym.system import waiting
from edugym.training import loops
from tests.compiled.cells import LEARNER, WALK, cell
from tests.compiled.processes import printed

pytestmark = pytest.mark.usefixtures("compiled_at_once")
N_STEPS = 120_000  # more than one call of machine code


def count(n: int, table: np.ndarray[Any, Any], task: Any, rng: np.random.Generator) -> int:
    """A loop: n draws, counted in a table by a method."""
    for _ in range(n):
        table[task.place(rng)] += 1
    return n


COUNTER = """class Counter(NamedTuple):
    size: int
    def place(self, rng):
        return int(rng.random() * self.size)
"""


def arguments_of(source: str) -> Any:
    """What the loop is called with, for the class `Counter` of a cell."""
    return np.zeros(4), cell(source)["Counter"](4), np.random.default_rng(0)


def test_short_runs_are_interpreted() -> None:
    """Few steps are not worth compiling, unless there is machine code of them already."""
    arguments = arguments_of(COUNTER)
    assert executable(count, arguments, expected=COMPILE_FROM - 1) is count
    assert executable(count, arguments, expected=COMPILE_FROM) is not count
    assert executable(count, arguments, expected=1) is not count


def test_students_code_is_compiled_when_that_pays(monkeypatch: pytest.MonkeyPatch) -> None:
    """That is when the interpreter would take longer than the compiler, all runs of the same code together."""
    clock = count_up(step=0.2)  # seconds from one look to the next: 200 rehearsed steps last 0.2 s, 10 000 10 s
    monkeypatch.setattr(execution, "time", SimpleNamespace(perf_counter=lambda: next(clock)))
    monkeypatch.setattr(execution, "seconds_to_build", lambda: 25.0)
    monkeypatch.setattr(execution, "_interpreted", {})
    changed = [COUNTER.replace("* self.size", f"* self.size * {factor}") for factor in (0.5, 0.25)]
    fast = [executable(count, arguments_of(changed[0]), expected=10_000) is not count for _ in range(3)]
    assert fast == [False, False, True]
    assert executable(count, arguments_of(changed[1]), expected=24_000) is count
    assert executable(count, arguments_of(changed[1]), expected=2_000) is count  # too short to be rehearsed
    assert executable(count, arguments_of(changed[1])) is not count


def test_a_build_takes_as_long_as_the_last_one(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of those that were not on the disk."""
    edugym.train("Boulder", edugym.QLearning.create((11, 2)), COMPILE_FROM)
    monkeypatch.setattr(compiler, "_built", {})
    monkeypatch.setattr(compiler, "_build_seconds", [1_000.0])
    edugym.train("Boulder", edugym.QLearning.create((11, 2)), COMPILE_FROM)
    assert compiler.seconds_to_build() == 1_000.0, "what is on the disk tells nothing"
    executable(count, arguments_of(COUNTER))
    assert 0.0 < compiler.seconds_to_build() < 1_000.0


def test_who_is_rehearsed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Code of a student, on copies: tables and streams stay as they are. The package's own goes straight on."""
    table, _, rng = arguments = arguments_of(COUNTER)
    before = rng.bit_generator.state
    executable(count, arguments)
    assert rng.bit_generator.state == before
    assert table.sum() == 0
    monkeypatch.setattr(execution, "copied", lambda value: pytest.fail("rehearsed"))
    agent = edugym.QLearning.create((11, 2))
    edugym.train("Boulder", agent, 10_000)
    assert agent.Q.any()


def line_of(error: BaseException) -> str:
    """The line at fault."""
    return traceback.extract_tb(error.__traceback__)[-1].line or ""


def with_slip(slip: str) -> Any:
    """A student's task and agent, which counts its calls and then does something wrong."""
    head, counts = "def learn(self, state, action, reward, next_state, terminated):", "calls: np.ndarray"
    source = LEARNER.replace(head, f"{head}\n        self.calls[0] += 1\n        {slip}")
    notebook = cell(WALK + source.replace("rate: float = 0.5", f"{counts}\n    rate: float = 0.5"))
    return notebook["Walk"](5), notebook["Learner"](np.zeros((6, 2)), np.zeros(1, np.int64))


ADAPTED = """
class Adapted(NamedTuple):
    agent: object

    def act(self, state, rng):
        return self.agent.act(state=state, rng=rng)

    def learn(self, state, action, reward, next_state, terminated, truncated):
        self.agent.learn(
            state=state, action=action, reward=reward, next_state=next_state, terminated=terminated)
"""
SHUFFLED = LEARNER.replace(
    "self, state, action, reward, next_state, terminated",
    "self, reward, terminated, next_state, action, state, alpha=0.5",
).replace("self.rate *", "alpha *")


@pytest.mark.parametrize("adapted", [False, True])
def test_students_agents_learn(adapted: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """A student's agent in a student's task learns the same, compiled and interpreted.

    So does one whose methods an adapter calls by keywords, with defaults and in another order.
    """
    runs = []
    for seconds in (0.0, 1e9):
        monkeypatch.setattr(execution, "seconds_to_build", lambda seconds=seconds: seconds)
        notebook = cell(WALK + (SHUFFLED + ADAPTED if adapted else LEARNER))
        learner = notebook["Learner"](np.zeros((6, 2)))
        agent = notebook["Adapted"](learner) if adapted else learner
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            run = edugym.train(notebook["Walk"](5), agent, 12_000, evaluate_every=1500, seed=3)
        runs.append((run.returns.tolist(), run.training_returns[1:].tolist(), learner.Q.tolist()))
        assert run.returns[-1] == 1 - 4 * 0.25  # five steps, the last of which pays
    assert runs[0] == runs[1]


@pytest.mark.parametrize("after", [3, 50_000])
def test_slips_of_the_index(after: int) -> None:
    """A wrong index stops at the student's line, whether it comes at once or in the middle of a long compiled run."""
    line = f"if self.calls[0] == {after}: self.Q[state, action + 7] = 1.0"
    tables = []
    for n_steps, evaluate_every in ((N_STEPS, None), (after, N_STEPS)):
        task, agent = with_slip(line)
        with pytest.raises(IndexError) as caught:
            edugym.train(task, agent, n_steps, seed=1, evaluate_every=evaluate_every)
        assert line_of(caught.value) == line
        assert agent.calls.tolist() == [after]
        tables.append(agent.Q)
    np.testing.assert_array_equal(*tables)


def test_mistake_in_a_task() -> None:
    """A mistake in a student's task stops at its line in training, in an environment and in a vector environment."""
    notebook = cell(WALK.replace("return max(0, state", "return max(0, self.sise + state") + LEARNER)
    task = notebook["Walk"](5)
    for use in (
        lambda: edugym.train(task, notebook["Learner"](np.zeros((6, 2))), N_STEPS),
        lambda: stepped(MDPEnv(task)),
        lambda: stepped(MDPVectorEnv(MDPEnv(task), 2)),
    ):
        with pytest.raises(AttributeError, match="sise") as caught:
            use()
        assert line_of(caught.value) == "return max(0, self.sise + state + 2 * action - 1)"


def stepped(env: Any) -> None:
    """Take one step."""
    env.reset(seed=0)
    env.step(env.action_space.sample())


def test_what_cannot_be_compiled(monkeypatch: pytest.MonkeyPatch) -> None:
    """A class that cannot be compiled runs interpreted, with the same results, after one short warning."""
    source = COUNTER.replace("return int", "notes = {'size': self.size, 2: None}\n        return int")
    arguments = arguments_of(source)
    with pytest.warns(UserWarning, match="^Counter cannot be compiled and runs interpreted, .*: ") as caught:
        assert executable(count, arguments) is count
    (warning,) = caught
    assert "\n" not in str(warning.message)
    assert len(str(warning.message)) < 300
    monkeypatch.setattr(compiler, "_build", lambda *_: pytest.fail("tried again"))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert executable(count, arguments) is count


def test_it_is_announced_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """By the names that a student knows, and taken away when it is done; not where there is nothing to compile."""
    lines: list[str] = []
    monkeypatch.setattr(waiting, "show", lines.append)
    monkeypatch.setattr(waiting, "clear", lambda text: lines.append(f"no {text}"))
    monkeypatch.setattr(execution, "is_on_disk", lambda code: False)
    task = edugym.NoisyObservation.create(edugym.make_mdp("Catch"), 3)
    code = code_of(loops.off_policy, (task, edugym.LinearQLearning.create(task)))
    monkeypatch.setattr(execution, "is_built", lambda loop, code: False)
    with execution._announced(loops.off_policy, code):
        assert lines == ["edugym: compiling CatchGrid and LinearQLearning (once, a second or two) ..."]
    assert lines[1:] == [f"no {lines[0]}"]
    monkeypatch.setattr(execution, "is_built", lambda loop, code: True)
    with execution._announced(loops.off_policy, code):
        pass
    assert len(lines) == 2


EVERYWHERE = """
import sys, warnings
warnings.simplefilter("error")
if sys.argv[1] == "no numba":
    sys.modules["numba"] = None
import numpy as np
import edugym
from edugym.system import waiting
from edugym.training import loops
from tests.compiled.cells import LEARNER, WALK, cell
from edugym.adapters.gymnasium_env import MDPEnv
from edugym.adapters.vector_env import MDPVectorEnv

notebook = cell(WALK + LEARNER)
task, agent = notebook["Walk"](5), notebook["Learner"](np.zeros((6, 2)))
run = edugym.train(task, agent, 6000, seed=1)
print(run.returns.tolist(), run.training_returns.tolist()[1:5], run.agent.Q.tolist())
vector = MDPVectorEnv(MDPEnv(edugym.make_mdp("MemoryCorridor")), 3, "SameStep")
vector.reset(seed=0)
vector.action_space.seed(0)
for _ in range(50):
    observations, rewards, *_ = vector.step(vector.action_space.sample())
    print(observations.tolist(), rewards.tolist())
print("numba" in sys.modules and sys.modules["numba"] is not None)
"""


@pytest.mark.slow
def test_without_a_compiler() -> None:
    """Without Numba, or with it switched off, everything gives the same results, and no warning."""
    ways: tuple[tuple[str, dict[str, str]], ...] = ("numba", {}), ("off", {"NUMBA_DISABLE_JIT": "1"}), ("no numba", {})
    outputs = [printed(EVERYWHERE, how, **variables).splitlines() for how, variables in ways]
    assert [lines.pop() for lines in outputs] == ["True", "False", "False"]
    assert outputs[0] == outputs[1] == outputs[2]
    assert len(outputs[0]) == 51


MOVED = """
import sys, warnings
import numba
{change}
import edugym
from edugym.compiled import execution
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    task = edugym.make_mdp("Boulder", height=4)
    for _ in range(2):
        run = edugym.train(task, edugym.QLearning.create(task), 6000)
print(run.complete, [str(w.message) for w in caught])
"""


@pytest.mark.slow
@pytest.mark.parametrize(
    "change",
    [
        "sys.modules['numba.core.imputils'] = None",
        "import numba.core.compiler as c; del c.DefaultPassBuilder.define_nopython_pipeline",
        "import numba.core.typing.typeof as t; del t.Purpose",
    ],
)
def test_a_numba_that_is_not_as_expected(change: str, tmp_path: Path) -> None:
    """Where something in Numba has moved, everything runs interpreted, after one warning."""
    complete, _, said = printed(MOVED.format(change=change), EDUGYM_CACHE_DIR=str(tmp_path)).partition(" ")
    assert complete == "True"
    assert said.count("interpreted") == 1, said


def test_a_living_environment_runs_what_its_class_has_become() -> None:
    """A method, a global or a constant of a class that changes shows at the next step, also as machine code."""
    notebook = cell("BONUS = 1.0\n" + WALK.replace("else -0.25", "else -0.25 * BONUS"))
    task = notebook["Walk"](50)
    vector = MDPVectorEnv(MDPEnv(task), 4)
    vector.reset(seed=0)
    step = np.ones(4, np.int64)
    assert vector.step(step)[1].tolist() == [-0.25] * 4
    notebook["BONUS"] = 2.0
    assert vector.step(step)[1].tolist() == [-0.5] * 4
    cell(WALK.replace("else -0.25", "else -3.0"), notebook)
    task.__class__.reward = notebook["Walk"].reward
    assert vector.step(step)[1].tolist() == [-3.0] * 4
    notebook["BONUS"] = []  # which is not to be compiled, and not used any more
    assert vector.step(step)[1].tolist() == [-3.0] * 4


def test_machine_code_that_differs_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    """What the first steps come to is compared; where it differs the class runs interpreted and says so."""
    original = compiler.compiled

    def wrong(loop: Any, *arguments: Any, **named: Any) -> Any:
        made = original(loop, *arguments, **named)

        def run(n: int, table: Any, *rest: Any) -> Any:
            table[3] += 1e-9
            return made(n, table, *rest)

        return run

    monkeypatch.setattr(execution, "compiled", wrong)
    arguments = arguments_of(COUNTER)
    with pytest.warns(UserWarning, match="comes to something else than Python in the first steps"):
        assert executable(count, arguments) is count
    assert not arguments[0].any()


def test_no_step_happens_twice(capsys: pytest.CaptureFixture[str]) -> None:
    """What a student's code prints, or counts outside, it does once for each step."""
    for line in ("print('step')", "seen.append(1)", "T.k[0] += 1"):
        source = "seen = []\nclass T: k = [0]\n" + COUNTER.replace("return int", f"{line}\n        return int")
        notebook = cell(source)
        arguments = np.zeros(4), notebook["Counter"](4), np.random.default_rng(0)
        with pytest.warns(UserWarning, match="runs interpreted"):
            run = executable(count, arguments)
        run(7, *arguments)
        assert capsys.readouterr().out.count("step") + len(notebook["seen"]) + notebook["T"].k[0] == 7


def test_builds_do_not_pile_up(monkeypatch: pytest.MonkeyPatch) -> None:
    """Run the cell of a class again unchanged, and nothing is compiled; change it, and the oldest builds go."""
    monkeypatch.setattr(compiler, "_built", {})
    compile_once = Mock(wraps=compiler._compile)
    monkeypatch.setattr(compiler, "_compile", compile_once)

    def run(source: str) -> None:
        arguments = arguments_of(source)
        executable(count, arguments)(10, *arguments)

    for _ in range(3):
        run(COUNTER)
    assert compile_once.call_count == 1
    for k in range(1, 7):
        run(COUNTER.replace("* self.size", f"* self.size * {1 - k / 10}"))
    assert compile_once.call_count == 7
    assert len(compiler._built) == compiler.KEPT
