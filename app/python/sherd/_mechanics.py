# SPDX-License-Identifier: GPL-3.0-or-later
from __future__ import annotations

import warnings
from typing import Any

from numpy.typing import ArrayLike

from . import _sherd
from ._scene import Scene


class Mechanics(_sherd.Mechanics):
    """Mechanics(scene): elastic energy of a scene's sheets as a function of the positions of their vertices.

    scene  a Scene, or its file or dict. Of the solver's keys only `bending` and `membrane` have an effect. Supports,
           loads, contact and time have none.

    Issues the scene's warnings. Raises Error if the scene cannot be built.
    """

    def __init__(self, scene: Any) -> None:
        super().__init__(scene if isinstance(scene, Scene) else Scene(scene))
        for warning in self.warnings:
            warnings.warn(warning, stacklevel=2)

    def energy(self, positions: ArrayLike) -> float:
        """Returns the elastic energy, J, at positions [V, 3] m. Raises Error if the array has another shape."""
        return sum(self.energies(positions).values())

    def hessian(self, positions: ArrayLike) -> Any:
        """Returns the exact second derivative of the energy at positions [V, 3] m.

        The matrix is a symmetric scipy.sparse.csc_matrix [3 V, 3 V], N/m; row 3 v + c belongs to coordinate c of vertex
        v. Raises ImportError without scipy, and Error if the array has another shape.
        """
        import scipy.sparse

        values, rows, starts = self._hessian(positions)
        size = len(starts) - 1
        lower = scipy.sparse.csc_matrix((values, rows, starts), shape=(size, size))
        return (lower + scipy.sparse.tril(lower, -1).T).tocsc()
