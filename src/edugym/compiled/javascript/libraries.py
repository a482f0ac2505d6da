"""Writes calls of `math` and `np`, and draws from `rng`, in JavaScript.

The library of mathematics decides the last digit of exp, log, sin and others. So these need the very library that
Python uses.
"""

import ast
from typing import Any

import numpy as np

from edugym.compiled.javascript.kinds import (
    ARRAYS,
    BOOL,
    FLOAT,
    FROZEN,
    INT,
    MIXED,
    NEVER,
    NUMBERS,
    Array,
    Code,
    Kind,
    Static,
    Tuple,
    described,
)
from edugym.compiled.javascript.operations import Operations

Given = list[Code]
Named = dict[str, Code]
LIBM = frozenset(
    [
        "acos",
        "acosh",
        "asin",
        "asinh",
        "atan",
        "atan2",
        "atanh",
        "cos",
        "cosh",
        "exp",
        "expm1",
        "hypot",
        "log",
        "log10",
        "log1p",
        "log2",
        "pow",
        "sin",
        "sinh",
        "tan",
        "tanh",
    ]
)
"""The functions of the library of mathematics."""
OF_TWO = frozenset(["atan2", "copysign", "hypot", "pow"])
"""Those of two numbers; `math.log` with a base, and `math.hypot` of three, are left to Python."""
OF_NUMPY = {"arccos": "acos", "arcsin": "asin", "arctan": "atan", "arctan2": "atan2", "power": "pow"}
"""NumPy's own names for some of them."""
AS_NUMPY = {"absolute": "abs", "amax": "max", "amin": "min", "bool_": "bool"}
"""The second names of functions that NumPy has under two."""


# Functions of `math` and of NumPy


def of_math(writer: Operations, node: ast.AST, name: str, given: Given) -> Code:
    """Writes a call of a function of `math`."""
    if len(given) != (2 if name in OF_TWO else 1):
        raise writer.refused(node, f"it gives math.{name} {len(given)} numbers")
    if not all(one.kind in NUMBERS or one.kind in (BOOL, NEVER) for one in given):
        raise writer.refused(node, f"it calls math.{name} with {described(given[0].kind)}")
    texts = [f"(+{one.text})" for one in given]
    if name in LIBM:
        return Code(writer.libm(node, name, *texts), FLOAT)
    plain = {
        "sqrt": ("root({})", FLOAT),
        "fabs": ("Math.abs({})", FLOAT),
        "floor": ("truncated(Math.floor({}))", INT),
        "ceil": ("truncated(Math.ceil({}))", INT),
        "trunc": ("truncated({})", INT),
        "isnan": ("Number.isNaN({})", BOOL),
        "isfinite": ("Number.isFinite({})", BOOL),
        "isinf": ("(Math.abs({})===Infinity)", BOOL),
        "copysign": ("copysign({},{})", FLOAT),
        "radians": ("({}*(Math.PI/180))", FLOAT),
        "degrees": ("({}*(180/Math.PI))", FLOAT),
    }
    if name not in plain:
        raise writer.refused(node, f"it uses math.{name}")
    text, kind = plain[name]
    return Code(text.format(*texts), kind)


EXTREMES = {"max": "largest", "min": "smallest", "argmax": "placeOfLargest", "argmin": "placeOfSmallest"}
QUICK = ("largest", "placeOfLargest")
"""Those that need no array, but only its data, offset, length and stride."""


def _array(writer: Operations, node: ast.AST, code: Code) -> Code:
    """Writes what NumPy makes of an array, a list or a tuple."""
    kind = writer.spread_kind(node, code.kind)
    return code._replace(text=writer.spreadable(node, code), kind=kind)


def of_array(writer: Operations, node: ast.AST, array: Code, name: str, given: Given, named: Named) -> Code | None:
    """Writes a call of a method of an array; None if there is no translation."""
    kind: Any = array.kind
    if name == "fill" and len(given) == 1 and not named:
        if kind.frozen:
            raise writer.refused(node, FROZEN)
        writer.require_fits(node, kind.of, given[0].kind, alone=True)
        return Code(f"assign({array.text},{given[0].text})", "none")
    if given or named:
        return None
    if name == "copy":
        return Code(f"copied({ARRAYS[kind.of]},{array.text})", Array(kind.of, kind.ndim))
    return _reduced(array, name)


def _reduced(array: Code, name: str) -> Code | None:
    """Writes a call that makes one number of a whole array; None if there is no translation."""
    kind: Any = array.kind
    if name in EXTREMES and kind.of != BOOL:
        function, of = EXTREMES[name], INT if name.startswith("arg") else kind.of
        quick = array.line and kind.of == FLOAT and function in QUICK
        return Code(f"{function}Of({array.line})" if quick else f"{function}({array.text})", of)
    if name == "sum":
        of_all = {FLOAT: "sumOfReals({})", INT: "sumOfWholes({}.flat())", BOOL: "countOf({}.flat())"}[kind.of]
        return Code(of_all.format(array.text), INT if kind.of == BOOL else kind.of)
    if name == "mean" and kind.of == FLOAT:
        return Code(f"meanOf({array.text})", FLOAT)
    if name in ("any", "all"):
        return Code(f"{array.text}.flat().{'some' if name == 'any' else 'every'}(x=>x!==0&&x!==false)", BOOL)
    return None


def of_numpy(writer: Operations, node: ast.AST, name: str, given: Given, named: Named) -> Code | None:
    """Writes a call of a function of NumPy; None if there is no translation."""
    if name in ("zeros", "ones", "full", "empty"):
        return _new_array(writer, node, name, given, named)
    if name in ("clip",):
        values = [*given, *named.values()]
        in_order = [*named] == ["a", "a_min", "a_max"][len(given) :]  # in which they are drawn, too
        if len(values) != 3 or not in_order or not all(one.kind in NUMBERS for one in values):
            return None
        kinds = {one.kind for one in values}
        if MIXED in kinds:
            return None
        return Code(f"clipped({','.join(one.text for one in values)})", INT if kinds == {INT} else FLOAT)
    if name == "array" and len(given) == 1:
        wanted = _dtype(named.pop("dtype", None)) if "dtype" in named else None
        made = _array(writer, node, given[0])
        if named or not isinstance(made.kind, Array):
            return None
        of = wanted or made.kind.of
        writer.require_fits(node, of, made.kind.of)
        return Code(f"copied({ARRAYS[of]},{made.text})", Array(of, made.kind.ndim))
    if named or not given:
        return None
    if len(given) == 1 and all(one.kind in NUMBERS for one in given):
        if name in ("floor", "ceil", "trunc"):
            return Code(f"Math.{name}({given[0].text})", FLOAT) if given[0].kind == FLOAT else None
        if name == "isnan":
            return Code(f"Number.isNaN({given[0].text})", BOOL)
        if name == "sqrt":
            return Code(f"root({given[0].text})", FLOAT)
    if name in LIBM or name in OF_NUMPY:
        return _elementwise_libm(writer, node, OF_NUMPY.get(name, name), given)
    if len(given) != 1:
        return None
    if name == "arange":
        return Code(f"numbered({given[0].text})", Array(INT, 1)) if given[0].kind == INT else None
    array = _array(writer, node, given[0])
    if not isinstance(array.kind, Array):
        return None
    if name == "sqrt" and array.kind.of == FLOAT:
        return Code(f"mapped(Real,root,{array.text})", Array(FLOAT, array.kind.ndim))
    if name == "flatnonzero":
        return Code(array.where or f"whereNotZero({array.text})", Array(INT, 1))
    if name == "count_nonzero":
        return Code(f"countOf({array.text}.flat())", INT)
    if name in ("zeros_like", "ones_like"):
        kind, number = Array(array.kind.of, array.kind.ndim), int(name == "ones_like")
        return Code(f"mapped({ARRAYS[kind.of]},()=>{number},{array.text})", kind)
    if name == "copy":
        return Code(f"copied({ARRAYS[array.kind.of]},{array.text})", Array(array.kind.of, array.kind.ndim))
    if name == "median":
        return Code(f"median({array.text}.flat())", FLOAT)
    return _reduced(array, name)


def _elementwise_libm(writer: Operations, node: ast.AST, name: str, given: Given) -> Code | None:
    if len(given) == (2 if name in OF_TWO else 1) and all(one.kind in NUMBERS for one in given):
        return Code(writer.libm(node, name, *(one.text for one in given)), FLOAT)
    kind = given[0].kind if len(given) == 1 else None
    if name not in OF_TWO and isinstance(kind, Array) and kind.of != BOOL:  # of flags NumPy's have 16 bits
        return Code(f"mapped(Real,x=>{writer.libm(node, name, 'x')},{given[0].text})", Array(FLOAT, kind.ndim))
    return None


def _dtype(code: Code | None) -> str | None:
    """Returns the kind of the elements that `dtype=` asks for; None for one that has no translation."""
    value = code.kind.value if code is not None and isinstance(code.kind, Static) else None
    kinds: dict[Any, str] = {int: INT, float: FLOAT, bool: BOOL, np.int64: INT, np.float64: FLOAT, np.bool_: BOOL}
    return kinds.get(value)


def _new_array(writer: Operations, node: ast.AST, name: str, given: Given, named: Named) -> Code | None:
    if name == "empty":
        raise writer.refused(node, "it uses np.empty, in which there may be anything: use np.zeros")
    count = 2 if name == "full" else 1
    dtype = named.pop("dtype", given[count] if len(given) > count else None)
    if named or len(given) < count or len(given) > count + 1:
        return None
    shape = given[0]
    if shape.kind == INT:
        sizes, ndim = f"[{shape.text}]", 1
    elif isinstance(shape.kind, Tuple) and set(shape.kind.parts) == {INT}:
        sizes, ndim = writer.as_list(shape), len(shape.kind.parts)
    else:
        return None
    value = given[1] if name == "full" else Code("0" if name == "zeros" else "1", INT)
    of = _dtype(dtype) if dtype is not None else (str(value.kind) if name == "full" else FLOAT)
    if of is None or of not in ARRAYS:
        raise writer.refused(node, "it makes an array of another type than float, int and bool")
    if name == "full":
        writer.require_fits(node, of, value.kind, alone=True)
    text = value.text if of != BOOL or value.kind == BOOL else f"({value.text}!==0)"
    return Code(f"filled({ARRAYS[of]},{sizes},{text})", Array(of, ndim))


# Draws


PARAMETERS: dict[str, dict[str, str]] = {
    "integers": dict.fromkeys(("low", "high", "size", "dtype", "endpoint"), ""),
    "choice": dict.fromkeys(("a", "size", "replace", "p"), ""),
    "uniform": {"low": "0", "high": "1"},
    "normal": {"loc": "0", "scale": "1"},
    "exponential": {"scale": "1"},
}
"""The parameters of each draw that has a translation, with their defaults if all of them are numbers."""


def draw(writer: Operations, node: ast.AST, rng: str, name: str, given: Given, named: Named) -> Code:
    """Writes a draw; in JavaScript, `rng` is the place of the generator's state."""
    if name == "random" and not given and not named:
        return Code(f"draw.next_double({rng})", FLOAT)
    if name not in PARAMETERS and name != "random":
        known = ", ".join(f"rng.{one}" for one in ("random", *PARAMETERS))
        raise writer.refused(node, f"it draws with rng.{name}; JavaScript knows {known}")
    names = PARAMETERS.get(name, {})
    made = None
    if names and len(given) <= len(names) and list(named) == [one for one in names if one in named]:
        told = dict(zip(names, given, strict=False)) | named
        if name in ("integers", "choice"):
            made = (_integers if name == "integers" else _choice)(writer, node, rng, told)
        elif all(one.kind in NUMBERS for one in told.values()):
            texts = [told[one].text if one in told else usual for one, usual in names.items()]
            made = Code(f"{name}({','.join([rng, *texts])})", FLOAT)
    if made is None:
        raise writer.refused(node, f"rng.{name} is translated only for one draw of a number")
    return made


def _integers(writer: Operations, node: ast.AST, rng: str, told: Named) -> Code | None:
    dtype, endpoint = told.pop("dtype", None), told.pop("endpoint", Code("false", BOOL))
    low, high = told.pop("low", None), told.pop("high", None)
    if low is None or told or endpoint.text not in ("true", "false") or (dtype and _dtype(dtype) != INT):
        return None
    if low.kind != INT or (high and high.kind != INT):
        return None
    more = "+1" if endpoint.text == "true" else ""
    bounds = f"0,{low.text}{more}" if high is None else f"{low.text},{high.text}{more}"
    return Code(f"bounded({rng},{bounds})", INT)


def _choice(writer: Operations, node: ast.AST, rng: str, told: Named) -> Code | None:
    for name, usual in (("size", "none"), ("replace", BOOL)):
        one = told.pop(name, None)
        if one is not None and (one.kind != usual or one.text == "false"):
            return None
    if "a" not in told:
        return None
    values, p = told["a"], told.get("p")
    number, held = values.kind == INT, writer.fresh()
    if not number:
        kind: Kind = _array(writer, node, values).kind
        if not isinstance(kind, Array) or kind.ndim != 1:
            return None
        text = _array(writer, node, values).text
    else:
        text, kind = values.text, INT
    size = held if number else f"{held}.length"
    if p is None:
        drawn = f"bounded({rng},0,{size})"
    else:
        of = _array(writer, node, p)
        if not isinstance(of.kind, Array) or of.kind.ndim != 1:
            return None
        drawn = f"weighted({rng},{size},{of.text}.flat())"
    if isinstance(kind, Array):
        return Code(f"({held}={text},{held}.at1({drawn}))", kind.of)
    return Code(f"({held}={text},{drawn})", INT)
