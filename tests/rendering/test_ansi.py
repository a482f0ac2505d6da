"""The pictures of ``render_mode="ansi"``, character by character."""

from edugym.rendering import icons
from edugym.rendering.ansi import to_text
from edugym.rendering.palette import BLUE, GREEN, INK, PAPER, RED, rgb
from edugym.rendering.scene import Arc, Circle, Line, Polygon, Rectangle, Scene, Text


def test_text_of_a_small_scene() -> None:
    """A board of cells, two characters wide and one high, with a frame, words and a smiley; what is outside is cut."""
    board = Rectangle(0, 0, 8, 5, glyph="#"), Rectangle(1, 1, 6, 3, glyph=" ")
    circles = Circle(2.5, 2.5, 0.5), Circle(3.5, 2.5, 0.5, glyph="o")  # without a glyph: not drawn
    words = (
        Rectangle(6, 3, 1, 1, glyph="EXIT"),  # more than a character: at the middle
        Text(4, 4.5, "HP 10"), Text(1, 3.5, "left", anchor="start"), Text(7, 1.5, "right", anchor="end"),
        Text(7, 2.5, "cut off", anchor="start"), Text(0.5, 0.5, "word", glyph="?"), Text(0, 1.5, "<>"),
    )  # fmt: skip
    picture = Scene(8, 5, (*board, *circles, *icons.smiley(1.5, 1.5, 0.4), *words), columns=16)
    assert to_text(picture).splitlines() == [
        "?###############",
        ">#☺      right##",
        "##    o       cu",
        "##left     EXIT#",
        "#####HP 10######",
    ]
    cells = [Circle((k + 0.5) * 0.1, 0.5, 0.05, glyph=str(k)) for k in range(10)]
    assert to_text(Scene(1, 1, cells, columns=20)).split("\n")[5] == "0 1 2 3 4 5 6 7 8 9"
    finer = to_text(picture, columns=32).splitlines()
    assert (len(finer), max(map(len, finer))) == (10, 32)


def test_text_draws_lines_and_later_shapes_on_top() -> None:
    """A line's character follows it, an arc's too; a rectangle smaller than a cell still shows; trailing blanks go."""
    line, arc = Line(((0.5, 1), (4.5, 5)), glyph="\\"), Arc(9, 5, 3, 180, 360, glyph="*")
    ground, ball = Rectangle(0, 5.1, 12, 0.2, glyph="="), Circle(9, 5, 1, glyph="@")
    picture = Scene(12, 6, (line, arc, ground, ball), columns=24)
    assert to_text(picture).splitlines() == [
        "",
        " \\\\",
        "   \\\\        **********",
        "     \\\\     **        **",
        "       \\\\   *          *",
        "=================@======",
    ]


def test_a_line_is_drawn_to_its_ends() -> None:
    """Both of them; the cells of each, where they do not divide evenly."""
    lines = (Line(((0.5, 1), (9.5, 1)), glyph="-"), Line(((1.5, 3), (4.5, 3), (4.5, 7)), glyph="+"))
    assert to_text(Scene(10, 8, lines, columns=10)).splitlines() == ["----------", " ++++", "    +", "    +"]


def test_words_stand_in_the_middle_of_what_they_mark() -> None:
    """Between the outermost points, wherever most of the points are."""
    shapes = (
        Polygon(((1, 0), (10, 0), (10, 4)), glyph="abc"),
        Line(((1, 8), (2, 8), (10, 4)), glyph="def"),
        Arc(5.5, 12, 4, 180, 360, glyph="ghi"),
    )
    assert to_text(Scene(10, 14, shapes, columns=10)).splitlines() == ["", "    abc", "", "    def", "", "    ghi"]


def escape(front: str, behind: str) -> str:
    """Begin to write in a colour on another."""
    return "\x1b[38;2;{};{};{};48;2;{};{};{}m".format(*rgb(front), *rgb(behind))


def test_colours() -> None:
    """A shape has the colour of its edge on that of its inside; words and paths leave what is behind them."""
    words, block = Text(2, 1, "ab", colour=BLUE), Rectangle(3, 0, 1, 2, fill=GREEN, outline=None, glyph="+")
    picture = Scene(5, 2, (Rectangle(0, 0, 2, 2, fill=RED, glyph="#"), words, block), columns=5)
    assert to_text(picture, colour=True) == (
        f"{escape(INK, RED)}#{escape(BLUE, RED)}a{escape(BLUE, PAPER)}b"
        f"{escape(GREEN, GREEN)}+{escape(INK, PAPER)} \x1b[0m"
    )
    ground = Rectangle(0, 0, 2, 1, fill=GREEN, outline=None, glyph=" ")
    paths = (Line(((0.5, 0.5), (1.5, 0.5)), colour=RED, glyph="-"), Arc(2.5, 1, 0.4, 181, 359, colour=BLUE, glyph="^"))
    painted = to_text(Scene(3, 2, (ground, *paths), columns=3), colour=True)
    assert painted.startswith(f"{escape(RED, GREEN)}--{escape(BLUE, PAPER)}^")
