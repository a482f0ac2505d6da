"""Links one WebAssembly object file of LLVM: a module that can be instantiated, which exports some of its functions.

An object file is a module already, laid out as if its data began at address 0. What is missing are the exports, whose
names stand in its section "linking". That section, the relocations and the names are of no use afterwards. Nothing that
LLVM was asked for here takes more (no second object, no table of functions, no library), so no other linker is needed.

References: the WebAssembly specification, section 5.5; the tool conventions of WebAssembly, Linking.md.
"""

from collections.abc import Iterator

HEADER = b"\0asm\1\0\0\0"
CUSTOM, EXPORT, ORDER = 0, 7, (1, 2, 3, 4, 5, 13, 6, 7, 8, 9, 12, 10, 11)
"""The ids of two sections, and the order in which sections must come."""
SYMBOL_TABLE, FUNCTION, DATA, SECTION = 8, 0, 1, 3
"""A part of the section "linking", and the kinds of symbols that are encoded in ways of their own."""
UNDEFINED, NAMED = 0x10, 0x40


class Reader:
    """Reads the numbers and names of the binary format one after the other."""

    def __init__(self, content: bytes) -> None:
        """Begin at the start."""
        self._content, self._at = content, 0

    @property
    def over(self) -> bool:
        """Whether all has been read."""
        return self._at == len(self._content)

    def take(self, n: int) -> bytes:
        """The next n bytes."""
        self._at += n
        return self._content[self._at - n : self._at]

    def rest(self) -> bytes:
        """All that is left."""
        return self.take(len(self._content) - self._at)

    def number(self) -> int:
        """A number in LEB128: seven bits a byte, the lowest first; the eighth says that more follow."""
        value = shift = 0
        while True:
            (byte,) = self.take(1)
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return value

    def sized(self) -> bytes:
        """A number of bytes, and so many bytes."""
        return self.take(self.number())


def number(value: int) -> bytes:
    """A number in LEB128."""
    low, rest = value & 127, value >> 7
    return bytes([low | 128]) + number(rest) if rest else bytes([low])


def sized(content: bytes) -> bytes:
    """The number of bytes, and the bytes."""
    return number(len(content)) + content


def linked(object_file: bytes, exports: tuple[str, ...], notes: dict[str, bytes]) -> bytes:
    """The object file as a module.

    Args:
        object_file: as LLVM writes it.
        exports: the names of functions in it.
        notes: custom sections to add, by name.

    Raises:
        ValueError: it is no object file, or has no such function.
    """
    if not object_file.startswith(HEADER):
        raise ValueError("object_file must be a WebAssembly module")
    sections: dict[int, bytes] = {}
    functions: dict[str, int] = {}
    reader = Reader(object_file[len(HEADER) :])
    while not reader.over:
        (kind,) = reader.take(1)
        content = reader.sized()
        if kind != CUSTOM:
            sections[kind] = content
        elif (custom := Reader(content)).sized() == b"linking":
            functions = dict(_functions(custom))
    if missing := [name for name in exports if name not in functions]:
        raise ValueError(f"exports must be functions of the object file, but {missing[0]!r} is none")
    entries = [sized(name.encode()) + bytes([FUNCTION]) + number(functions[name]) for name in exports]
    sections[EXPORT] = number(len(entries)) + b"".join(entries)
    body = b"".join(bytes([kind]) + sized(sections[kind]) for kind in ORDER if kind in sections)
    custom_sections = (bytes([CUSTOM]) + sized(sized(name.encode()) + note) for name, note in notes.items())
    return HEADER + body + b"".join(custom_sections)


def _functions(reader: Reader) -> Iterator[tuple[str, int]]:
    """The functions that an object file defines, by name, from its section "linking"."""
    reader.number()  # the version of the format
    while not reader.over:
        (part,) = reader.take(1)
        symbols = Reader(reader.sized())
        for _ in range(symbols.number() if part == SYMBOL_TABLE else 0):
            (kind,) = symbols.take(1)
            flags = symbols.number()
            if kind == DATA:
                symbols.sized()
                for _ in range(0 if flags & UNDEFINED else 3):
                    symbols.number()
            elif kind == SECTION:
                symbols.number()
            else:
                index = symbols.number()
                if not flags & UNDEFINED or flags & NAMED:
                    name = symbols.sized().decode()
                    if kind == FUNCTION:
                        yield name, index


def notes_of(module: bytes) -> dict[str, bytes]:
    """The custom sections of a module, by name."""
    reader, notes = Reader(module[len(HEADER) :]), dict[str, bytes]()
    while not reader.over:
        (kind,) = reader.take(1)
        content = Reader(reader.sized())
        if kind == CUSTOM:
            name = content.sized().decode()
            notes[name] = content.rest()
    return notes
