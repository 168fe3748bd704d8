// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/shell/shell.h"

namespace sherd {

/// Estimates the highest angular frequency, rad/s, of a shell at x [3, V] m with lumped masses, by Lanczos'
/// method (Spectra's) on M^-1 K, with differences of forces for K. The estimate approaches the frequency from
/// below. mode: [3, V], the vector at which the method starts, replaced by the mode that it finds; without
/// columns it starts from noise. Throws std::runtime_error if it does not converge. gradient(x) returns the
/// gradient of the elastic energy, N, [3, V].
double highest_frequency(const std::function<Positions(const Positions&)>& gradient, const Shell& shell,
                         const Positions& x, Positions& mode);

/// Returns the triangle that moves most in a mode [3, V]: the sum over its corners of mass times amplitude
/// squared is the largest.
Index fastest_triangle(const Shell& shell, const Positions& mode);

}  // namespace sherd
