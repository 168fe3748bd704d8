// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/record/gauge.h"

#include <algorithm>
#include <limits>

#include "core/contact/geometry/distance.h"
#include "core/elements/principal_values.h"

namespace sherd {
namespace {

/// Barycentric coordinates of the gauge's place in its face at rest.
Vector3d coordinates(const Shell& shell, const Gauge& gauge) {
    const TrianglePositions x = columns(shell.rest, shell.triangles[gauge.face].vertices);
    const Vector3d normal = Vector3d(x.col(1) - x.col(0)).cross(Vector3d(x.col(2) - x.col(0)));
    Vector3d shares;
    for (int i = 0; i < 3; ++i) {
        const Vector3d next = x.col((i + 1) % 3), last = x.col((i + 2) % 3);
        shares[i] = (last - next).cross(gauge.place - next).dot(normal) / normal.squaredNorm();
    }
    return shares;
}

}  // namespace

double largest_stress(const GaugeReading& reading) {
    return std::max(principal_values(reading.stress_top)[0], principal_values(reading.stress_bottom)[0]);
}

Gauge nearest_gauge(const Shell& shell, const Vector3d& place, Index sheet) {
    Gauge nearest;
    double least = std::numeric_limits<double>::infinity();
    for (Index face = 0; face < static_cast<Index>(shell.triangles.size()); ++face) {
        if (sheet >= 0 && shell.face_sheet[face] != sheet) continue;
        PairPositions pair;
        pair << place, columns(shell.rest, shell.triangles[face].vertices);
        const Vector3d way = pair * closest_points(PairKind::vertex_triangle, pair).weights;
        if (way.squaredNorm() >= least) continue;
        least = way.squaredNorm();
        nearest.face = face;
        nearest.place = place - way;
    }
    return nearest;
}

GaugeReading reading(const Shell& shell, const Gauge& gauge, const std::optional<FaceState>& state) {
    const std::array<Index, 3>& vertices = shell.triangles[gauge.face].vertices;
    const TrianglePositions moved = columns(shell.position, vertices) - columns(shell.rest, vertices);
    GaugeReading reading;
    if (gauge.displacement) reading.displacement = moved * coordinates(shell, gauge);
    if (!state) return reading;
    if (gauge.fields.curvature) reading.curvature = state->curvature;
    if (gauge.fields.membrane_strain) reading.membrane_strain = state->membrane_strain;
    if (!gauge.fields.stress) return reading;
    reading.stress_top = state->stress_top;
    reading.stress_bottom = state->stress_bottom;
    return reading;
}

void follow(const Shell& shell, const ShellChange& change, std::span<Gauge> gauges) {
    for (Gauge& gauge : gauges) {
        std::vector<Index> parts{gauge.face};
        follow_faces(change, parts);
        for (const auto& [face, parents] : change.reshaped)
            if (std::ranges::find(parents, gauge.face, &IndexWithParents::Parent::element) != parents.end())
                parts.push_back(face);
        double deepest = -std::numeric_limits<double>::infinity();
        for (const Index part : parts) {
            const double depth = coordinates(shell, {part, gauge.place}).minCoeff();
            if (depth <= deepest) continue;
            deepest = depth;
            gauge.face = part;
        }
    }
}

}  // namespace sherd
