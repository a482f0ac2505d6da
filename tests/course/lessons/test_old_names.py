"""Notebooks that students wrote with version 0.1 still find what they call in a lesson, by its old name."""

import importlib
import sys
from types import ModuleType

import pytest

from edugym.training.attempt import attempt
from edugym_course.lessons.exploration.methods import compare
from edugym_course.lessons.loop.methods import Q_LEARNING
from edugym_course.lessons.memory.players import N_STEPS
from edugym_course.lessons.own_problem.bedroom import bedroom

pytestmark = pytest.mark.filterwarnings("ignore:.* has moved")
CALLED = {
    "loop": """
        BAGS MYOPIC OPTIMUM Q_LEARNING RANDOM agent_after best_way items_on learned_beside_exact learning_curves
        myopic_return nine_challenges play_and_learn play_at_random race random_return rewards_and_returns
        right_choices untried with_discount""",
    "exploration": """
        Fork METHODS OPTIMIST attempt climb_shares compare compare_on_fork curves fork_maps frontier
        frontier_lines higher_frontier in_pairs learning_curves paper_methods race random_search_steps
        returns_to right_grips turns visit_maps visits_of watch_frontier watch_random_search""",
    "on_off_policy": """
        Icy best_run best_soft_return cliff_figure compare compare_on_cliff first_fall greedy_run in_the_plane
        learning_curves let_epsilon_decay mean_values online online_against_rate race share_lost
        shortfall_against_epsilon stopping_places switch_lines""",
    "depth": """
        BY_DEPTH best_rates bias_series compare credit_maps curves difference_where_both_pass early_difference
        episodes_until expected_returns final_difference greedy_return handed_back label maker met_exam
        noise_share off_policy_sheet passes pupil race rate_series shortfall split through_rates variance_sheet""",
    "dimensionality": """
        COLUMN GENERAL METHODS NETWORK NUMBERS OFFSET OpenDQN PIXELS POSITIONS PPO_IMAGE SMALL STORED TABLE
        TILES TRAINED WITHHELD boards_figure car_figure catch compare_sights costs_figure different_boards drive
        ever_learned generalise growth joined learn network network_figure paddle_ends pixels policy_maps race
        race_networks returns_by_column rows_of_table seen shared_by_column size_sheet steps_to_solve
        stored_networks table_and_network train_network w_to_2w withheld""",
    "memory": """
        EyesShut RECURRENT Rememberer STORED action_law best_play compare_windows joined late learn learn_all
        learn_blindly learn_with_network network_figure one_window race remember smallest_window twin_figure
        walk_figure window_law window_lines worth""",
    "signal": """
        Coin LEARNED LONGER Moody OPTIMUM RANDOM_PLAY RoundRobin Voter after answers best_return bits
        compare_noise compare_vocabularies information joint_table joint_tables late learn learn_long
        learn_with_memory lengths_sheet median_late memory_sheet messages_panel moody_toy noise_label
        noise_sheet one_toy one_word_panel play race rows_of_table vocabulary_sheet vote walk""",
    "continuous_actions": """
        Drawing SHOWN_BINS STORED baseline_figure best_return climb climb_race curves deliveries estimates
        exact_figure frozen_lake gaussian gradient_figure in_a_table lake_figure learn_all maps narrowing
        noise_figure one_setting peaks ppo_figure race scores slopes steps_to trainer value""",
    "stochasticity": """
        AVERSE NEUTRAL RISKS SEEKING against_level attitudes by_first_swing certain_value compare_on_lake
        crossing crossing_by_attitude crossing_lines from_the_tee frontier_figure games_figure lake_figure
        lake_optimum landings landings_figure lead learn learned_value learning_curves outcomes patient play
        play_by_rules race share_of_drivers slider_figure values_on_the_tee weights_figure""",
    "model_based": """
        Clock Close GIVEN Knowledge LEARNED REMEDIES SLOW_DYNA WRONG attempt clocks compare compare_planners
        dynamic_programming follow_plans given_curves items_found learning learning_curves look_ahead_lines
        plan_lines race spreading steps_to targets_computed used_and_seen who_knows_the_way with_right_model
        wrong_plan""",
    "own_problem": """
        BUDGETS MEANT Morning POTENTIAL REWARDS TASKS WAKINGS WithPotential as_meant bedroom best_blind
        best_policy count_matters first_stall learn learning_lines methods_with morning_map player policies race
        random_return shaped_policies solve take_through_everything true_returns weights_sheet what_happens""",
}
"""The names of each lesson in its notebook of version 0.1."""


@pytest.mark.parametrize("lesson", CALLED)
def test_a_notebook_finds_what_it_calls(lesson: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """None is a module, and the first import says where the lesson is now."""
    monkeypatch.delitem(sys.modules, f"edugym.lessons.{lesson}", raising=False)
    with pytest.warns(DeprecationWarning, match=f"import edugym_course.lessons.{lesson}"):
        old = importlib.import_module(f"edugym.lessons.{lesson}")
    assert [name for name in CALLED[lesson].split() if isinstance(getattr(old, name), ModuleType)] == []
    with pytest.raises(AttributeError, match="nothing"):
        _ = old.nothing


@pytest.mark.parametrize(
    ("lesson", "name", "value"),
    [
        ("exploration", "compare", compare),
        ("model_based", "attempt", attempt),
        ("loop", "Q_LEARNING", Q_LEARNING),
        ("memory", "N_STEPS", N_STEPS),
        ("own_problem", "bedroom", bedroom),
    ],
)
def test_names_that_several_files_have(lesson: str, name: str, value: object) -> None:
    """Files, exercises or other modules have them too."""
    assert getattr(importlib.import_module(f"edugym.lessons.{lesson}"), name) is value
