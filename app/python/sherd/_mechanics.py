# SPDX-License-Identifier: GPL-3.0-or-later
from __future__ import annotations

import warnings
from typing import Any

from numpy.typing import ArrayLike

from . import _sherd
from ._scene import Scene


class Mechanics(_sherd.Mechanics):
    """Mechanics(scene): the elasticity of a scene's sheets as a function of the positions of their vertices.

    scene  a Scene, or what one is made of. Of its solver `bending` and `membrane` count; loads, contact and
           time do not.

    Raises Error when the scene cannot be built.
    """

    def __init__(self, scene: Any) -> None:
        super().__init__(scene if isinstance(scene, Scene) else Scene(scene))
        for warning in self.warnings:
            warnings.warn(warning, stacklevel=2)

    def energy(self, positions: ArrayLike) -> float:
        """J, elastic, at positions [V, 3] m. Raises Error on another shape."""
        return sum(self.energies(positions).values())

    def hessian(self, positions: ArrayLike) -> Any:
        """The exact second derivative of the energy at positions [V, 3] m.

        A symmetric scipy.sparse.csc_matrix [3 V, 3 V], N/m; coordinate c of vertex v has the row 3 v + c. Raises
        ImportError without scipy, and Error on positions of another shape.
        """
        import scipy.sparse

        values, rows, starts = self._hessian(positions)
        size = len(starts) - 1
        lower = scipy.sparse.csc_matrix((values, rows, starts), shape=(size, size))
        return (lower + scipy.sparse.tril(lower, -1).T).tocsc()
