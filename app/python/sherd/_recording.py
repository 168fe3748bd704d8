# SPDX-License-Identifier: GPL-3.0-or-later
from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator

from ._sherd import Error, Recording
from ._simulation import Simulation


@contextlib.contextmanager
def record(simulation: Simulation, file: str | os.PathLike[str], force: bool = False) -> Iterator[Simulation]:
    """with record(simulation, "run.h5"): records what is stepped within, as `sherd run` records it.

    There are frames where the scene wants them, the first one at once and one at the end; steps and events are all
    there. An .xdmf for ParaView goes beside the file. The simulation must not have made a step yet. When the block ends
    with an exception the recording has all until then, and says so. force: replaces a file that is there.

    Raises Error when the file is there or cannot be written.
    """
    simulation._record(os.fspath(file), force)
    try:
        yield simulation
    except Error as error:
        simulation._end_recording(str(error))
        raise
    except BaseException:
        simulation._end_recording("")
        raise
    simulation._end_recording("")
