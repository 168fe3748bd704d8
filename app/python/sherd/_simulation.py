# SPDX-License-Identifier: GPL-3.0-or-later
from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from typing import Any

from . import _sherd
from ._scene import Scene


class Simulation(_sherd.Simulation):
    """Simulation(scene, threads=1): steps a scene.

    scene    a Scene, or its file or dict
    threads  largest number of threads of explicit steps; results do not depend on it

    Issues the warnings that the program would print. Raises Error if the scene cannot be built. Methods and the state
    raise Error while another thread is in step().

    The first simulation of a process sets the OpenBLAS that Sherd uses to one thread.
    """

    def __init__(self, scene: Any, threads: int = 1) -> None:
        super().__init__(scene if isinstance(scene, Scene) else Scene(scene), threads)
        for warning in self.warnings:
            warnings.warn(warning, stacklevel=2)

    def run(self, until: float | None = None, observe: Callable[[_sherd.StepReport], object] | None = None) -> bool:
        """Makes steps until the scene's end, or until a time (s), which may be after the scene's end.

        observe  function that is called with the StepReport after each step; the run ends when it returns True. It may
                 read and change the simulation.

        Returns whether that end was reached: False if `observe` ended the run. Ctrl-C raises KeyboardInterrupt after
        the current step. Raises Error if a step cannot be solved.
        """
        rounding = 1e-12
        end = math.inf if until is None else until * (1 - rounding)
        while self.time < end and not (self.has_arrived if until is not None else self.has_ended):
            report = self.step()
            if observe is not None and observe(report) is True:
                return False
        return self.time >= end or self.has_ended
