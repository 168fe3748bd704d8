// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/triangle_soup.h"

namespace sherd {

/// Edges of one triangle that lie exactly where others do, without being joined to them: what a crack that
/// was opened looks like, and a seam that a modeller left open. In the order of their points, each as two
/// points.
std::vector<std::array<std::uint32_t, 2>> seam_edges(const TriangleSoup& soup);

}  // namespace sherd
