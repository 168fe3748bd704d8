// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace sherd {

/// JSON with keys in the order of insertion.
using Json = nlohmann::ordered_json;

/// Returns [x, y, z].
template <class AnyJson = Json>
AnyJson vector_json(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

}  // namespace sherd
