// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/self_intersections.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>

namespace sherd {

std::vector<std::array<Face, 2>> self_intersections(const Mesh& mesh) {
    std::vector<std::pair<Face, Face>> found;
    CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(faces(mesh), mesh,
                                                                            std::back_inserter(found));
    std::vector<std::array<Face, 2>> pairs;
    for (const auto& [a, b] : found) pairs.push_back({std::min(a, b), std::max(a, b)});
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace sherd
