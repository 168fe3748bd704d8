// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/energy.h"
#include "core/shell/shell.h"

namespace sherd {

/// Estimates the highest angular frequency, rad/s, of a shell at x [3, V] m with lumped masses, by Lanczos'
/// method (Spectra's) on M^-1 K, with differences of forces for K. It comes from below. mode: [3, V], where
/// the method starts and what it leaves for the next time; without columns it starts anew. Throws
/// std::runtime_error when it does not converge.
double highest_frequency(std::span<Energy* const> energies, const Shell& shell, const Positions& x,
                         Positions& mode);

}  // namespace sherd
