"""Compiles a loop over an MDP and an agent to WebAssembly, ahead of time: Numba -> LLVM -> object file -> module.

`edugym.compiled` compiles the same code for this machine. Here Numba's code generator is replaced by one for wasm32,
and around the machine code comes a function `run(block)` that JavaScript can call: `block` is the address of slots of 8
bytes, which hold numbers and the addresses of arrays. Which slot holds what stands in the module itself, in its custom
section "edugym".

`install` changes Numba for the whole process, which can then compile nothing for this machine: use it in a process of
its own.
"""

import importlib
import inspect
import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from linker import linked

from edugym.compiled import compiler
from edugym.compiled.code import code_of
from edugym.compiled.numba_setup import CompilationError, numba_ready

binding: Any = importlib.import_module("llvmlite.binding")
ir: Any = importlib.import_module("llvmlite.ir")
types: Any = importlib.import_module("numba.core.types")

TRIPLE = "wasm32-unknown-unknown"
FEATURES = "+bulk-memory,+sign-ext,+nontrapping-fptoint,+mutable-globals"
"""What every browser of the last years has."""
NOTE = "edugym"
"""The custom section of a kernel: its fingerprint and its slots, as JSON."""
RUNTIME = Path(__file__).with_name("pcg64.ll")


def install() -> None:
    """Make Numba generate code for wasm32, in this process and from now on."""
    codegen: Any = importlib.import_module("numba.core.codegen")
    config: Any = importlib.import_module("numba.core.config")
    cgutils: Any = importlib.import_module("numba.core.cgutils")
    context: Any = importlib.import_module("numba.core.cpu").CPUContext

    def begin(self: Any, name: str) -> None:
        codegen.initialize_llvm()
        self._rtlinker = codegen.RuntimeLinker()
        self._tm_features = FEATURES
        self._tm = _machine()
        self._target_data = self._tm.target_data
        self._data_layout = str(self._target_data)
        self._llvm_module = binding.parse_assembly(str(self._create_empty_module(name)))
        self._engine = None
        self._loopvect, self._opt_level = False, 0

    def empty_module(self: Any, name: str) -> Any:
        module = ir.Module(cgutils.normalize_ir_text(name))
        module.triple, module.data_layout = TRIPLE, self._data_layout
        return module

    def no_entry_point(self: Any, library: Any, description: Any, env: Any) -> Any:
        library._ensure_finalized()
        return [].append  # a dispatcher wants one builtin function for each; nobody calls it

    codegen.JITCPUCodegen = type(
        "WasmCodegen",
        (codegen.CPUCodegen,),
        {
            "__init__": begin,
            "_library_class": codegen.AOTCodeLibrary,
            "_create_empty_module": empty_module,
            "_add_module": lambda self, module: None,  # there is no engine to which it could be added
            "set_env": lambda self, name, env: None,  # there is no Python
        },
    )
    _draw_without_long_numbers()
    config.LOOP_VECTORIZE = config.SLP_VECTORIZE = 0
    context.get_executable = no_entry_point


def _draw_without_long_numbers() -> None:
    """Let `integers` draw from more than 2^32 numbers without numbers of 128 bits, which a kernel has not.

    LLVM sees that Numba's own code multiplies two numbers of 64 bits, and would do so in one of 128. So the product is
    written out in another way. The draws are NumPy's, by the method of Lemire (2019), Fast random integer generation in
    an interval.
    """
    methods: Any = importlib.import_module("numba.np.random.random_methods")
    next_64: Any = methods.next_uint64
    jitable: Any = importlib.import_module("numba.core.extending").register_jitable
    uint64 = types.uint64

    @jitable  # type: ignore[untyped-decorator]
    def upper_half(x: Any, y: Any) -> Any:
        """The upper 64 bits of x y, from 16 bits of y after the other, the lowest first."""
        high, low = x >> uint64(32), x & uint64(0xFFFFFFFF)
        a, b = uint64(0), uint64(0)  # a 2^32 + b is the sum so far, without what lies below
        for k in range(4):
            part = (y >> uint64(16 * k)) & uint64(0xFFFF)
            b = ((a & uint64(0xFFFF)) << uint64(16)) + (b >> uint64(16)) + low * part
            a = (a >> uint64(16)) + high * part + (b >> uint64(32))
            b = b & uint64(0xFFFFFFFF)
        return (a << uint64(16)) + (b >> uint64(16))

    @jitable  # type: ignore[untyped-decorator]
    def up_to(bits: Any, last: Any) -> Any:
        n, drawn = uint64(last) + uint64(1), next_64(bits)
        if drawn * n < n:
            threshold = (uint64(0) - n) % n
            while drawn * n < threshold:
                drawn = next_64(bits)
        return upper_half(drawn, n)

    methods.bounded_lemire_uint64 = up_to


def _machine() -> Any:
    binding.initialize_all_targets()
    binding.initialize_all_asmprinters()
    target = binding.Target.from_triple(TRIPLE)
    return target.create_target_machine(cpu="generic", features=FEATURES, opt=3, reloc="static", codemodel="default")


def compiled(loop: Callable[..., Any], arguments: tuple[Any, ...], fingerprint: str) -> bytes:
    """The module of a loop for arguments like these.

    Args:
        loop: a plain function.
        arguments: what it will be called with, or values of the same types.
        fingerprint: what the kernel is known by; it is written into the module.

    Raises:
        CompilationError: it cannot be compiled, or it allocates memory, for which a kernel has no room.
    """
    numba = numba_ready()
    code = code_of(loop, arguments)
    signature = signature_of(arguments)
    made = compiler._compile(numba, loop, signature, None, code, compiler.LEAN).overloads[signature]
    compiler._check_no_counts(made)
    kernel = _Kernel(made, tuple(inspect.signature(loop).parameters))
    note = {"fingerprint": fingerprint, "slots": kernel.slots, "results": kernel.n_arguments}
    return linked(kernel.object_file(), ("run",), {NOTE: json.dumps(note).encode()})


def optimised(source: str, exported: tuple[str, ...]) -> bytes:
    """The object file of a text of LLVM and the runtime, optimised; functions that are not exported go away."""
    module = binding.parse_assembly(source + RUNTIME.read_text())
    for value in [*module.functions, *module.global_variables]:  # what only CPython calls goes away with this
        if not value.is_declaration and value.name not in exported:
            value.linkage = "internal"
    module.verify()
    machine = _machine()
    for _ in range(2):
        options = binding.create_pipeline_tuning_options(speed_level=3)
        options.loop_vectorization = options.slp_vectorization = False
        options.inlining_threshold = 100_000
        builder = binding.create_pass_builder(machine, options)
        builder.getModulePassManager().run(module, builder)
    made: bytes = machine.emit_object(module)
    return made


def signature_of(arguments: tuple[Any, ...]) -> tuple[Any, ...]:
    """Numba's types of the arguments of a loop."""
    streams = [k for k, argument in enumerate(arguments) if isinstance(argument, np.random.Generator)]
    return tuple(map(numba_ready().typeof, compiler._with_located(arguments, streams)))


class Slot(NamedTuple):
    """A word of 8 bytes by which a kernel is told an argument, or tells a result.

    Attributes:
        name: as in "agent.Q", and "agent.Q.shape0".
        kind: "array float64", "generator", "bool", "int64", "float64", ...
    """

    name: str
    kind: str


class _Kernel:
    """A build of Numba, and around it, as LLVM's text, the function `run` that fills its arguments from slots.

    Attributes:
        slots: the slots of the arguments, then those of the results.
        n_arguments: the number of slots of the arguments.
    """

    def __init__(self, made: Any, names: tuple[str, ...]) -> None:
        self.slots: list[Slot] = []
        self._lines: list[str] = []
        self._arguments: list[str] = []
        self._made, self._context = made, made.target_context
        description = made.fndesc
        for kind, name in zip(description.argtypes, names, strict=True):
            self._argument(kind, name)
        self.n_arguments = len(self.slots)
        result = description.restype
        self._result_type = "ptr"
        called = f"call i32 @{description.llvm_func_name}(ptr %result, ptr %error, {', '.join(self._arguments)})"
        self._lines.append(f"%status = {called}")
        if not isinstance(result, types.NoneType):
            self._result_type = str(self._context.data_model_manager[result].get_data_type())
            self._result(result, "result", ())

    def object_file(self) -> bytes:
        """The object file, optimised."""
        source = str(binding.parse_assembly(str(self._made.library._final_module)))
        source = source.replace("@edugym_asked_to_stop(", "@asked_to_stop(")
        source = re.sub(r"^declare [^\n]*@asked_to_stop\([^\n]*$", "", source, flags=re.MULTILINE)
        return optimised(source + self._run(), ("run",))

    def _run(self) -> str:
        body = "\n  ".join(self._lines)
        room = f"%result = alloca {self._result_type}\n  %error = alloca ptr"
        return f"\ndefine i32 @run(ptr %block) {{\n  {room}\n  {body}\n  ret i32 %status\n}}\n"

    def _new(self, line: str) -> str:
        """The name of a new value, and the line that computes it."""
        name = f"%value{len(self._lines)}"
        self._lines.append(f"{name} = {line}")
        return name

    def _slot(self, name: str, kind: str) -> str:
        self.slots.append(Slot(name, kind))
        return self._new(f"getelementptr i64, ptr %block, i32 {len(self.slots) - 1}")

    def _load(self, name: str, kind: str, as_type: str) -> str:
        place = self._slot(name, kind)
        return self._new(f"load {as_type}, ptr {place}")

    def _argument(self, kind: Any, name: str) -> None:
        """Load an argument from its slots, in the parts in which Numba passes it."""
        add = self._arguments.append
        if isinstance(kind, types.BaseTuple):
            for field, part in zip(_fields(kind), kind.types, strict=True):
                self._argument(part, f"{name}.{field}")
        elif isinstance(kind, types.Array):
            self._array(kind, name)
        elif isinstance(kind, types.NumPyRandomGeneratorType):
            state = self._load(name, "generator", "i64")
            draws = (f"i64 ptrtoint (ptr @pcg64_next_{draw} to i64)" for draw in ("uint64", "uint32", "double"))
            for part in ("ptr null", f"i64 {state}", f"i64 {state}", *draws, "i64 0", "ptr null", "ptr null"):
                add(part)
        elif isinstance(kind, types.Boolean):
            word = self._load(name, "bool", "i64")
            add(f"i8 {self._new(f'trunc i64 {word} to i8')}")
        elif isinstance(kind, types.Float) and kind.bitwidth == 64:
            add(f"double {self._load(name, str(kind), 'double')}")
        elif isinstance(kind, types.Integer) and kind.bitwidth == 64:
            add(f"i64 {self._load(name, str(kind), 'i64')}")
        elif isinstance(kind, types.NoneType):
            add("ptr null")
        else:
            raise CompilationError(f"a kernel takes no {kind} ({name})")

    def _array(self, kind: Any, name: str) -> None:
        if kind.layout != "C":
            raise CompilationError(f"a kernel takes arrays that are contiguous, not {kind} ({name})")
        size = self._context.get_abi_sizeof(self._context.get_data_type(kind.dtype))
        address = self._load(name, f"array {kind.dtype}", "i64")
        pointer = self._new(f"inttoptr i64 {address} to ptr")
        shape = [self._load(f"{name}.shape{axis}", "int64", "i64") for axis in range(kind.ndim)]
        strides, stride = list[str](), str(size)
        for extent in reversed(shape):
            strides.insert(0, stride)
            stride = self._new(f"mul i64 {stride}, {extent}")
        items = self._new(f"udiv exact i64 {stride}, {size}")
        parts = ["ptr null", "ptr null", f"i64 {items}", f"i64 {size}", f"ptr {pointer}"]
        self._arguments += [*parts, *(f"i64 {part}" for part in shape + strides)]

    def _result(self, kind: Any, name: str, path: tuple[int, ...]) -> None:
        """Store a result into its slots."""
        if isinstance(kind, types.BaseTuple):
            for k, (field, part) in enumerate(zip(_fields(kind), kind.types, strict=True)):
                self._result(part, f"{name}.{field}", (*path, k))
            return
        places = "".join(f", i32 {k}" for k in path)
        place = self._new(f"getelementptr {self._result_type}, ptr %result, i32 0{places}")
        as_type = str(self._context.get_data_type(kind))
        value = self._new(f"load {as_type}, ptr {place}")
        if as_type not in ("double", "i64"):
            value, as_type = self._new(f"zext {as_type} {value} to i64"), "i64"
        slot = self._slot(name, str(kind))
        self._lines.append(f"store {as_type} {value}, ptr {slot}")


def _fields(kind: Any) -> tuple[str, ...]:
    return tuple(getattr(kind, "fields", None) or map(str, range(len(kind.types))))
