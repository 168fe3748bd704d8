# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits a parameter: finds the Young's modulus with which the end of a strip sags as far as was measured."""
import numpy
import scipy.optimize

import sherd

MEASURED = 0.0123  # m, sag of the free end of a strip whose other end is clamped
SCENE = {
    "sheet": {"strip": {
        "mesh": {"generate": "rectangle", "width": 0.3, "height": 0.03, "edge_length": 0.01},
        "material": {"density": 1200, "thickness": 1e-3, "poisson": 0.35},
        "clamp": {"box": [[-1, -1, -1], [0.001, 1, 1]]},
    }},
    "solver": {"scheme": "static", "step": 0.25},
}


def sag(young):
    """Returns the sag of the free end under the strip's weight, m. young: Pa."""
    simulation = sherd.Simulation(sherd.Scene(SCENE, set={"sheet.strip.material.young": young}))
    rest = simulation.positions
    simulation.run()
    end = rest[:, 0] > 0.299
    return -simulation.positions[end, 2].mean()


tried = []


def misfit(logarithm):
    tried.append(numpy.exp(logarithm))
    return numpy.log(sag(tried[-1]) / MEASURED)


young = numpy.exp(scipy.optimize.brentq(misfit, numpy.log(1e9), numpy.log(2e10), xtol=1e-5))
beam = 1200 * 9.81 * 0.3**4 / (8 * MEASURED * 1e-3**2 / 12)
print(f"after {len(tried)} runs: Young's modulus is {young / 1e9:.4f} GPa, the sag {sag(young) * 1e3:.3f} mm")
print(f"by the theory of slender beams that sag a little: {beam / 1e9:.2f} GPa")
