// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/build/strength_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/scene/build/texture.h"
#include "meshops/error.h"
#include "meshops/float_grid.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double grey(const Image& image, const Vector2d& uv) {
    double grey = 0;
    for (const WeightedColour& texel : texels_around(image, uv))
        grey += texel.weight * texel.colour.cast<double>().mean();
    return grey;
}

std::vector<double> values_of(const StrengthTexture& map, const Mesh& mesh, const Eigen::Affine3d&,
                              std::vector<std::string>&) {
    const Image image = read_png(map.path);
    const auto texture = texture_coordinates(mesh);
    std::vector<double> values(mesh.number_of_edges(), 0);
    for (const Face face : mesh.faces()) {
        int corner = 0;  // a halfedge's target, after the corner that is its source
        for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(face))) {
            const Vector2d middle = (texture[face][(corner + 2) % 3] + texture[face][corner]) / 2;
            values[mesh.edge(h)] += grey(image, middle) / (mesh.is_border(mesh.edge(h)) ? 1 : 2);
            ++corner;
        }
    }
    return values;
}

std::vector<double> values_of(const StrengthGrid& map, const Mesh& mesh, const Eigen::Affine3d& to_file,
                              std::vector<std::string>& warnings) {
    std::vector<Vector3d> middles;
    for (const Edge e : mesh.edges())
        middles.push_back(to_file *
                          ((position(mesh, mesh.vertex(e, 0)) + position(mesh, mesh.vertex(e, 1))) / 2));
    const GridSamples samples = sample_float_grid(map.path, map.name, middles);
    for (std::size_t i = 0; i < middles.size(); ++i)
        if (!(samples.values[i] >= 0 && std::isfinite(samples.values[i])))
            throw Error(fmt::format(
                "{} is {} at ({:.4g}, {:.4g}, {:.4g}), in the middle of edge {}; a strength "
                "needs values of 0 or more",
                map.path.string(), samples.values[i], middles[i].x(), middles[i].y(), middles[i].z(), i));
    if (samples.outside > 0)
        warnings.push_back(fmt::format(
            "{} of {} edges lie outside the active region of {} and take its background value, {:.4g}",
            samples.outside, middles.size(), map.path.string(), samples.background));
    return samples.values;
}

}  // namespace

std::vector<double> map_factors(const StrengthMap& map, const Mesh& placed, const Eigen::Affine3d& to_file,
                                std::vector<std::string>& warnings) {
    std::vector<std::string> found;
    std::vector<double> factors = with_context(map.where, [&] {
        return std::visit([&](const auto& kind) { return values_of(kind, placed, to_file, found); },
                          map.kind);
    });
    for (const std::string& warning : found) warnings.push_back(fmt::format("{}: {}", map.where, warning));
    for (double& factor : factors) {
        if (map.never) factor = factor < 0.5 ? 1 : std::numeric_limits<double>::infinity();
        if (map.range) factor = std::lerp((*map.range)[0], (*map.range)[1], std::min(factor, 1.0));
    }
    return factors;
}

}  // namespace sherd
