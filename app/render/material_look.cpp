// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/material_look.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include "meshops/read_write/material_library.h"

namespace sherd {
namespace {

/// Returns the numbers at the beginning of the statement `keyword`. Another word, for example of a spectral
/// curve, ends the numbers.
std::vector<float> numbers(const SurfaceMaterial& material, const std::string& keyword) {
    std::istringstream words(statement(material, keyword));
    words.imbue(std::locale::classic());
    std::vector<float> values;
    for (float value = 0; words >> value;) values.push_back(std::isfinite(value) ? value : 0);
    return values;
}

std::optional<float> number(const SurfaceMaterial& material, const std::string& keyword) {
    const std::vector<float> values = numbers(material, keyword);
    return values.empty() ? std::nullopt : std::optional(values.front());
}

/// Returns the colour in the statement `keyword`, or `otherwise` if the statement has no numbers. A single
/// number is a grey.
Eigen::Vector3f colour(const SurfaceMaterial& material, const std::string& keyword,
                       const Eigen::Vector3f& otherwise) {
    const std::vector<float> values = numbers(material, keyword);
    if (values.empty()) return otherwise;
    const Eigen::Vector3f colour =
        values.size() < 3 ? Eigen::Vector3f::Constant(values[0]) : Eigen::Vector3f(values.data());
    return colour.cwiseMax(0).cwiseMin(1);
}

}  // namespace

MaterialLook material_look(const SurfaceMaterial& material) {
    MaterialLook look;
    look.colour = colour(material, "Kd", look.colour);
    look.glow = colour(material, "Ke", look.glow);
    if (const auto transparency = number(material, "Tr")) look.opacity = 1 - *transparency;
    look.opacity = std::clamp(number(material, "d").value_or(look.opacity), 0.0f, 1.0f);
    // As in Blender's importer: an exponent of 0 means rough, an exponent of 900 smooth.
    if (const auto exponent = number(material, "Ns"))
        look.roughness = 1 - std::sqrt(std::clamp(*exponent, 0.0f, 900.0f)) / 30;
    look.picture = statement(material, "map_Kd");
    return look;
}

}  // namespace sherd
