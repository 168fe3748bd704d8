// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/legend/render_colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/recording/fields.h"
#include "meshops/error.h"

namespace sherd {
namespace {

std::vector<double> vertex_strain(const Snapshot& frame) {
    std::vector<double> sum(frame.position.cols(), 0);
    std::vector<int> hinges(sum.size(), 0);
    for (std::size_t e = 0; e < frame.edges.size(); ++e) {
        if (frame.edge_state[e] != EdgeState::interior) continue;
        for (const Index v : frame.edges[e]) {
            sum[v] += std::abs(frame.edge_strain[e]);
            ++hinges[v];
        }
    }
    for (std::size_t v = 0; v < sum.size(); ++v) sum[v] /= std::max(1, hinges[v]);
    return sum;
}

std::vector<double> vertex_speed(const Snapshot& frame) {
    std::vector<double> speed;
    for (Eigen::Index v = 0; v < frame.velocity.cols(); ++v) speed.push_back(frame.velocity.col(v).norm());
    return speed;
}

/// Returns at each vertex the mean of the values of the faces around it, [V].
std::vector<double> mean_of_faces(const Snapshot& frame, const VectorXd& values) {
    std::vector<double> sum(frame.position.cols(), 0);
    std::vector<int> faces(sum.size(), 0);
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        for (const Index v : frame.faces[f]) {
            sum[v] += values[static_cast<Eigen::Index>(f)];
            ++faces[v];
        }
    for (std::size_t v = 0; v < sum.size(); ++v) sum[v] /= std::max(1, faces[v]);
    return sum;
}

std::string name_of(RenderColour colour) {
    constexpr std::array<const char*, 9> names{"fragment", "strain", "speed",    "stress", "curvature",
                                               "axis",     "tips",   "material", "none"};
    return names.at(static_cast<std::size_t>(colour));
}

/// Returns the colour a for t = 0, b for t = 1, and mixtures in between.
std::uint32_t mixed(std::uint32_t a, std::uint32_t b, double t) {
    std::uint32_t rgb = 0;
    for (const int shift : {16, 8, 0}) {
        const double from = (a >> shift) & 255, to = (b >> shift) & 255;
        rgb |= static_cast<std::uint32_t>(std::lround(from + t * (to - from))) << shift;
    }
    return rgb;
}

}  // namespace

bool is_scalar(RenderColour colour) {
    return std::ranges::find(scalar_colours, colour) != scalar_colours.end();
}

std::string colour_names(std::span<const RenderColour> colours) {
    std::string names;
    for (std::size_t i = 0; i < colours.size(); ++i)
        names += (i == 0 ? "" : i + 1 < colours.size() ? ", " : " or ") + name_of(colours[i]);
    return names;
}

RenderColour parse_render_colour(const std::string& name, std::span<const RenderColour> colours) {
    const auto found = std::ranges::find(colours, name, name_of);
    if (found == colours.end())
        throw Error(
            fmt::format("--color {}: there is no such colouring; give {}", name, colour_names(colours)));
    return *found;
}

RenderScalar render_scalar(const Snapshot& frame, RenderColour colour) {
    switch (colour) {
        case RenderColour::strain:
            return {"strain", "1/m", vertex_strain(frame)};
        case RenderColour::speed:
            return {"speed", "m/s", vertex_speed(frame)};
        case RenderColour::stress:
            require_field(frame.fields.stress_top, "stress");
            return {"stress", "Pa", mean_of_faces(frame, largest_stress(frame.fields))};
        case RenderColour::curvature:
            require_field(frame.fields.curvature, "curvature");
            return {"curvature", "1/m", mean_of_faces(frame, largest_curvature(frame.fields).cwiseAbs())};
        default:
            return {};
    }
}

std::uint32_t fragment_colour(Index fragment) {
    // Palette of Okabe and Ito without black, which would hide the shading: sky blue, orange, bluish green,
    // yellow, blue, vermillion, purple.
    constexpr std::array<std::uint32_t, 7> palette{0x56b4e9, 0xe69f00, 0x009e73, 0xf0e442,
                                                   0x0072b2, 0xd55e00, 0xcc79a7};
    const std::uint32_t base = palette[fragment % palette.size()];
    switch (fragment / palette.size() % 3) {
        case 1:
            return mixed(base, 0xffffff, 0.45);
        case 2:
            return mixed(base, 0x000000, 0.4);
        default:
            return base;
    }
}

std::uint32_t map_colour(double x) {
    // Colours of the map for equally spaced x.
    constexpr std::array<std::uint32_t, 10> stops{0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e,
                                                  0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725};
    const double at = std::clamp(x, 0.0, 1.0) * (stops.size() - 1);
    const auto stop = std::min(static_cast<std::size_t>(at), stops.size() - 2);
    return mixed(stops[stop], stops[stop + 1], at - static_cast<double>(stop));
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[rank];
}

}  // namespace sherd
