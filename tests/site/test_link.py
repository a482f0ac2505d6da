"""The playground's link: what it holds comes back, and what cannot be is left out."""

import json
import random
import subprocess
from typing import Any

import playground
import pytest
from races import RACES

from tests.site.node import NODE

pytestmark = pytest.mark.skipif(NODE is None, reason="needs Node.js: apt-get install nodejs")


def in_node(body: str, given: Any) -> Any:
    """What the page's functions make of something."""
    page = playground.PAGE.as_uri()
    script = f"""
        import {{ readFileSync }} from 'node:fs'
        import {{ FIRST, read, write }} from '{page}/link.js'
        import {{ LONGEST, pack, unpack }} from '{page}/packed.js'
        const given = JSON.parse(readFileSync(0))
        process.stdout.write(JSON.stringify({body}))
    """
    command = [str(NODE), "--input-type=module", "--eval", script]
    done = subprocess.run(command, input=json.dumps(given), capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def test_a_program_comes_back_from_its_letters() -> None:
    """Any text; all files of the package's agents are short enough for a link."""
    draw = random.Random(0)
    texts = ["", "\ufeffx", *playground.sources(RACES).values()]
    texts += ["".join(chr(draw.choice([10, 32, 97, 233, 0x1F388])) for _ in range(size)) for size in (1, 50, 5_000)]
    packed, longest = in_node("[await Promise.all(given.map(pack)), LONGEST]", texts)
    assert in_node("await Promise.all(given.map(unpack))", packed) == texts
    for letters in packed:
        assert letters.replace("-", "").replace("_", "").isalnum()
        assert len(letters) < longest


@pytest.mark.parametrize(
    "letters", ["'AAAA'", "'+'", "(await pack('agent = 1')).slice(1)", "await pack('a'.repeat(1e6))"]
)
def test_what_stands_for_no_program_gives_none(letters: str) -> None:
    """Also what would be endless."""
    assert in_node(f"await unpack({letters}) ?? 'none'", None) == "none"


def test_what_is_written_is_read() -> None:
    """All that the page shows."""
    state = in_node("FIRST", None) | {"task": "Golf", "strength": 3, "agents": [2, 0, 1], "source": "q1-_"}
    state |= {"speed": 2.5, "steps": 1_000, "discount": 0.5, "show": "values", "policy": False, "code": True}
    state |= {"at": [5, 0, 9], "several": 5}
    assert in_node("read(write(given))", state) == state


@pytest.mark.parametrize(
    "link",
    ["#bet=1", "#steps=1e9", "#source=%3Cb%3E", f"#source={'a' * 8_001}", "#agents=0.1", "#show=all", "#other=1", "#"],
)
def test_what_cannot_be_is_left_out(link: str) -> None:
    """The rest is as at first."""
    assert in_node("read(given)", link) == in_node("FIRST", None)
