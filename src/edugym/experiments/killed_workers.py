"""What `repeat` does where a process of its workers is killed."""

import sys
import warnings
from collections.abc import Callable, Sized

from edugym.system.interrupts import SignalGuard


def again_if_killed(do: Callable[[], None], runs: Sized, guard: SignalGuard) -> None:
    """Do what is missing among `runs`; where a process of joblib's or Ray's is killed, do it again.

    Raises:
        TerminatedWorkerError, RayActorError: three times in a row a process is killed before any run ends.
    """
    from joblib.externals.loky.process_executor import TerminatedWorkerError

    of_ray = getattr(sys.modules.get("ray.exceptions"), "RayActorError", TerminatedWorkerError)
    finished, attempts = len(runs), 3
    while True:
        try:
            return do()
        except (TerminatedWorkerError, of_ray):
            if guard.stop_ordered:  # by Ctrl-C, which may have ended the process as well
                return None
            finished, attempts = len(runs), 3 if len(runs) > finished else attempts - 1
            if not attempts:
                raise
            killed = "a process that joblib uses was killed, perhaps for lack of memory: its runs are done again"
            warnings.warn(killed, RuntimeWarning, stacklevel=3)
