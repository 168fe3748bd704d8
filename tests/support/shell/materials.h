// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/material/material.h"

namespace sherd::test {

inline const Material ceramic{.density = 2400, .thickness = 2e-3, .young = 7e10, .poisson = 0.2};
inline const Material glass{.density = 2500, .thickness = 4e-3, .young = 7e10, .poisson = 0.2};
inline const Material rubber{.density = 1000, .thickness = 2e-3, .young = 2e6, .poisson = 0.4};
inline const Material thin_rubber{.density = 1000, .thickness = 1e-3, .young = 2e6, .poisson = 0.4};
inline const Material firm_rubber{.density = 1000, .thickness = 2e-3, .young = 1e7, .poisson = 0.4};
inline const Material thick_foam{.density = 1000, .thickness = 1e-2, .young = 1e6, .poisson = 0.3};

}  // namespace sherd::test
