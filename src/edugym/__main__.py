"""`python -m edugym` is the command `edugym`, for those whose shell does not find it."""

from importlib.metadata import entry_points

if __name__ == "__main__":
    [command] = entry_points(group="console_scripts", name="edugym")  # the course brings it along
    command.load()()
