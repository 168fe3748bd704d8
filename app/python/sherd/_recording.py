# SPDX-License-Identifier: GPL-3.0-or-later
from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator

from ._sherd import Error, Recording
from ._simulation import Simulation


@contextlib.contextmanager
def record(simulation: Simulation, file: str | os.PathLike[str], force: bool = False) -> Iterator[Simulation]:
    """with record(simulation, "run.h5"): records the steps that are made within the block, as `sherd run` does.

    Writes a frame at the start, frames at the times that the scene asks for, a frame at the end, all steps and all
    events, and an .xdmf for ParaView beside the file. If the block raises an exception the recording has all steps
    until then; Recording.end is "failed: ..." after an Error, with no frame at the end, and else "interrupted". force:
    whether to replace an existing file.

    Raises Error if the simulation has made a step or is being recorded, or if the file exists or cannot be written.
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
