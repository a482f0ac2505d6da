"""The command `edugym`."""

import os
import sys

from edugym.system.interrupts import INTERRUPTED, SignalGuard


def main() -> None:
    """Run the command; Ctrl-C ends it without a traceback, also while its modules are imported."""
    try:
        with SignalGuard():
            from edugym_course.commands import run
    except KeyboardInterrupt:
        print("edugym: interrupted", file=sys.stderr, flush=True)
        os._exit(INTERRUPTED)
    run()
