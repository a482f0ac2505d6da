"""Numba's long error messages in a few words that the author of the code understands."""

import inspect
import re
import traceback
from pathlib import Path
from types import FunctionType

from edugym.compiled.byte_code import place
from edugym.compiled.code import Code

MAX_LENGTH = 150
"""How many letters of a message are shown."""
MESSAGES = (
    (
        r"Cannot modify readonly array of type.*",
        "it writes to an array that is no field, or that may only be read: pass it, or a copy of it, as a field",
    ),
    (r"Unknown attribute '(\w+)' of type NumPyRandomGeneratorType.*", r"it uses rng's \1"),
    (
        r"Unknown attribute '(\w+)' of type class\(<class '(?:.*\.)?(\w+)'>\).*",
        r"it takes \1 from the class \2: take it from a value, as in self.\1",
    ),
    (
        r"Unknown attribute '_replace' of type (.+)",
        r"it uses _replace of a value of type \1: make a new one of all fields",
    ),
    (
        r"Unknown attribute '(size|shape|ndim|dtype|flat|ravel)' of type list.*",
        "it gives a list to a function that takes arrays: make it with np.array([...])",
    ),
    (r"Unknown attribute '(\w+)' of type (.+)", r"it uses \1 of a value of type \2"),
    (
        r"Cannot unify (.+) and (.+) for '(state|observation|action)\.\d+', defined at \S+/edugym/training/loops.py.*",
        r"the \3 should always be of the same type, but is of two, \1 and \2",
    ),
    (r"Cannot unify (.+) and (.+) for .*", r"one name stands for values of two types, \1 and \2"),
    (r"Can't unify return type from the following types: (.+), (\w+)", r"it returns values of two types, \1 and \2"),
    (r"Unsupported array index type (\S+) in .*", r"an index of an array is of type \1"),
    (r">>> NumPyRandomGeneratorType_(\w+)\(.*array\(.*", r"rng.\1 draws an array of numbers: draw them one by one"),
    (r">>> rng.integers\(.*array\(.*", "rng.integers draws an array of numbers: draw them one by one"),
    (r">>> rng.integers\(.*class\(.*", "rng.integers draws numbers of another type than int64"),
    (r">>> rng.integers\(.*", "rng.integers takes whole numbers, but was given something else"),
    (
        r">>> rng.choice\(.*",
        "rng.choice is compiled only for one draw, as rng.choice(n) or rng.choice(values), with p or without",
    ),
    (r"Argument \w+ is not one of the expected type.*", "a call is given something of a type that Numba does not take"),
    (r"(Cannot bind|missing a required|got an unexpected) .*", "a call has other arguments than Numba takes"),
    (
        r"Type of variable .* cannot be determined.*",
        "Numba cannot tell the type of a value (as after := and case)",
    ),
    (r"Cannot cast (.+) to (\S+): .*", r"it computes with \1 as if it were \2: write .value"),
    (r"Invalid use of getiter with parameters \((Literal\[)?(int|float|bool)\S*\)", "it loops over a single number"),
    (r"Invalid use of getiter with parameters \(Tuple\(\)\)", "it loops over an empty tuple"),
    (r"Invalid use of getiter with parameters \((.+)\)", r"it loops over values of several types, \1"),
    (r"Invalid use of (int|float|bool)\w* with parameters .*", "it calls a number as if it were a function"),
    (r"Invalid use of NumPyRandomGeneratorType with parameters .*", "it calls rng as if it were a function"),
    (r"Invalid use of BoundFunction\(array\.(\w+) for .*", r"it uses an array's \1 like this"),
    (r"Invalid use of (.+) with parameters \((.*)\)", r"Numba cannot call \1 with \2"),
    (
        r">>> setitem\(array\(.*\), .*, Tuple\(.*\)\)",
        "it puts values of several types in an array at once: put them there one by one",
    ),
    (r"Use of unsupported opcode \(UNPACK_EX\).*", "it takes something apart with *"),
    (r"Use of unsupported opcode \(MATCH_\w+\).*", "it has a match that takes something apart"),
    (r"compiler re-entrant to the same function signature.*", "it calls itself"),
    (r"Use of unsupported opcode \((\w+)\).*", r"it has a statement that Numba does not know, \1"),
    (
        r">>> getitem\(Tuple\(.*\), u?int64\)",
        "a tuple with values of several types can be indexed only by a constant, as in t[0]",
    ),
    (r">>> le\(float64, unicode_type\)", "it makes a number of text"),
    (
        r">>> (_impl|dot)\(array\(.*, array\(.*\)\)",
        "it multiplies matrices of whole numbers, or of two types: make both arrays of real numbers",
    ),
    (r">>> (.+)", r"Numba has no \1"),
    (
        r"Cannot refine type StarArgTuple.*",
        "it calls a function with *, as a decorator may: give each argument by itself",
    ),
    (r"Int value is too large.*", "it has a whole number of more than 64 bits"),
    (r"Illegal IR, del found.*", "it deletes a variable"),
)
"""Patterns of Numba's messages, and what is said in their place."""
TYPES = (
    (r"Literal\[(\w+)\]\([^)]*\)", r"\1"),
    (r"OptionalType\((\w+)\)", r"\1 or None"),
    (r"Function\(<class '(\w+)'>\)", r"\1"),
    (r"Function\(<ufunc '(\w+)'>\)", r"np.\1"),
    (r"Function\(<built-in function (\w+)>\)", r"\1"),
    (r"array\([\w]+, \d+d, \w\)", "array"),
    (r"(Uni)?Tuple\([^)]*\)", "tuple"),
    (r"list\(\w+\)<iv=[^>]*>", "list"),
    (r"list\(list\)<iv=[^>]*>", "list"),
    (r"unicode_type", "str"),
    (r"range_state_int64", "range"),
    (r"slice<[\w:]+>", "slice"),
    (r"\b(int|float)64\b", r"\1"),
    (r"(Enum|IntEnum) ?(class)?<\w+>\((\w+)\)", r"\3"),
    (r"\b([A-Z]\w*)\((int|float|bool|str|array|tuple)( x \d+|, \w+)*\)", r"\1"),
    (r"\bnone\b", "None"),
    (r"values of two types, array and array$", "arrays of two types, or of other numbers of dimensions"),
    (r"(of|values of) two(?: types)?, tuple and tuple$", r"\1 two types of tuples, as those of other lengths are"),
    (r"values of two types, (.+) and \1$", r"values of \1 with fields of two types, as 0 and 0.0 are"),
)
"""Patterns of Numba's names of types, and how Python writes them."""


def reason(error: Exception, code: Code) -> str:
    """What an error of Numba's says, and the innermost line of the student's code among those that it names.

    Args:
        error: what compiling has raised.
        code: what was compiled.
    """
    own = {Path(file).name: file for file in code.foreign_files}
    if not type(error).__module__.startswith("numba"):  # an internal error of Numba
        line = _line_at_work(error, own)
        said = "Numba cannot compile this line" if line else f"Numba cannot compile it ({type(error).__name__})"
        if "no attribute 'args'" in str(error):  # of the signature that it has not found
            said = "it changes an array in place that is no field: pass it as a field"
        return f"{said} ({line})" if line else said
    text = re.sub(r"\x1b\[[0-9;]*m", "", str(error))
    lines = re.split(r"^(?:During: |File )", text, maxsplit=1, flags=re.MULTILINE)[0].splitlines()
    places = re.findall(r'(?:File "| at |Raised from )([^"\n]+?)"?(?:, line | \()(\d+)', text)
    own_lines = [place(own[name], int(line)) for file, line in places if (name := Path(file).name) in own]
    if not own_lines and re.search(r">>> isfinite\(array", text):  # in a guard around the student's MDP
        return "the reward is an array, but should be a number: for np.where write `... if ... else ...`"
    said = _method_without_self(text, code) or _translated(lines)
    return f"{said} ({own_lines[0]})" if own_lines else said


def _line_at_work(error: Exception, own: dict[str, str]) -> str | None:
    """The student's line that Numba was compiling when it failed, as its own functions know it."""
    for frame, _ in reversed([*traceback.walk_tb(error.__traceback__)]):
        for value in frame.f_locals.values():
            if type(value).__module__ == "numba.core.ir":
                loc = getattr(value, "loc", value)
                if file := own.get(Path(getattr(loc, "filename", "")).name):
                    return place(file, loc.line)
    return None


def _method_without_self(text: str, code: Code) -> str | None:
    """A sentence about a class method or a static method, if that is the member that Numba does not know."""
    if found := re.search(r"Unknown attribute '(\w+)' of type class\(<class '(?:.*\.)?(\w+)'>\)", text):
        for kind in code.classes:
            if kind.__name__ == found[2] and isinstance(inspect.getattr_static(kind, found[1], None), FunctionType):
                return f"it calls {found[1]} of the class {found[2]}: write it as a function outside of the class"
    if found := re.search(r"Unknown attribute '(\w+)' of type", text):
        for kind in code.classes:
            member = inspect.getattr_static(kind, found[1], None)
            if isinstance(member, classmethod | staticmethod):
                which = "a class method" if isinstance(member, classmethod) else "a static method"
                return f"{found[1]} of {kind.__name__} is {which}: make it a method, with self"
    return None


def _translated(lines: list[str]) -> str:
    """Numba's message in other words, if there are some for one of its lines; else its first line."""
    messages = [re.sub(r"^\w+Error: ", "", line.strip()) for line in lines if line.strip()]
    for pattern, words in MESSAGES:
        for line in messages:
            if found := re.fullmatch(pattern, line):
                said = found.expand(words)
                for written, plain in TYPES:
                    said = re.sub(written, plain, said)
                return said[:MAX_LENGTH]
    first = next((line for line in messages if not line.startswith(("Failed in", "- "))), "Numba does not say why")
    return first[:MAX_LENGTH]
