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

    scene    a Scene, or what one is made of: a file, a dict
    threads  that explicit steps may use at most; results do not depend on them

    Warns of what the program would warn of. Raises Error when the scene cannot be built.

    The first simulation of a process lets the OpenBLAS that Sherd uses compute in one thread.
    """

    def __init__(self, scene: Any, threads: int = 1) -> None:
        super().__init__(scene if isinstance(scene, Scene) else Scene(scene), threads)
        for warning in self.warnings:
            warnings.warn(warning, stacklevel=2)

    def run(self, until: float | None = None, observe: Callable[[_sherd.StepReport], object] | None = None) -> bool:
        """Steps on to the scene's end, or until a time (s), past the scene's end if need be.

        observe  is called with the StepReport after each step; when it returns True the run ends there. It may look at
                 the simulation and change it.

        Returns whether it came to the end that was asked for. Ctrl-C raises KeyboardInterrupt after the step. Raises
        Error when a step cannot be solved.
        """
        rounding = 1e-12
        end = math.inf if until is None else until * (1 - rounding)
        while self.time < end and not (self.has_arrived if until is not None else self.has_ended):
            report = self.step()
            if observe is not None and observe(report) is True:
                return False
        return self.time >= end or self.has_ended
