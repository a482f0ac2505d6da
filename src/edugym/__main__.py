"""`python -m edugym` is the command `edugym`, for those whose shell does not find it."""

from edugym.cli import main

if __name__ == "__main__":
    main()
