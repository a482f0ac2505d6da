"""What is said of an answer that is right in some cases: the one mistake that explains the others."""

import pytest

from edugym_course.grading.mistakes import what_it_looks_like

WRONG = [True, True, False, False, False]


@pytest.mark.parametrize(
    ("explained", "said"),
    [
        ({"most": [True, True, True, True, False]}, "in this case it looks like this: most"),
        (
            {"where it is wrong": [True, True, False, False, False]},
            "it is right in 3 of 5 cases, and in the others it looks like this: where it is wrong",
        ),
        ({"one": [True, True, False, False, False], "another": [True, True, False, False, False]}, ""),
        ({"half of them": [True, False, False, False, False]}, ""),
    ],
)
def test_what_an_answer_looks_like(explained: dict[str, list[bool]], said: str) -> None:
    """Two mistakes that explain the same are not told, nor one that explains a part of what is wrong."""
    assert what_it_looks_like(explained, WRONG) == said
