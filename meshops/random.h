// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>

namespace sherd {

/// Random numbers that are the same with every standard library, in contrast to those of
/// std::uniform_real_distribution.
class Random {
  public:
    explicit Random(unsigned seed) : engine(seed) {}
    /// A uniformly distributed number in [0, 1).
    double uniform() { return static_cast<double>(engine() >> 11) * 0x1p-53; }

  private:
    std::mt19937_64 engine;
};

}  // namespace sherd
