// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/cracks/residual_stress.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <unordered_set>

#include "fracture/cracks/tip_stress.h"

namespace sherd {
namespace {

/// Energy that a freed end of a strip releases per metre of its width, over S^2 t^2 (1 - nu^2) / Y.
constexpr double released_by_end = 0.0368;
/// Distance from a crack, in multiples of ResidualStress::reach, beyond which its release of energy is
/// neglected.
constexpr double far = 5;
/// Largest distance between sample points beside a crack piece, in multiples of ResidualStress::reach.
constexpr double fineness = 0.1;
/// Tolerance of crossings, as a share of the lengths of the two lines: a line that begins on the other one
/// does not cross it, and a crossing may lie just beyond the other line's ends.
constexpr double touch = 1e-6;

/// A crack piece as seen from a point beside it.
struct Beside {
    double distance;  ///< m, from the point; infinite if the point's projection is not on the piece
    Vector3d along;   ///< unit vector along the piece
};

Beside beside(const Vector3d& point, const CrackPiece& piece) {
    const Vector3d way = piece.to - piece.from, away = point - piece.from;
    const double length = way.norm(), share = away.dot(way) / (length * length);
    if (!(share >= 0 && share <= 1)) return {std::numeric_limits<double>::infinity(), way / length};
    return {(away - share * way).norm(), way / length};
}

/// Share of `way` at which the line from `from` to from + way crosses a piece, in the projection on the plane
/// of the given normal; infinite if it does not cross the piece.
double crossing(const Vector3d& from, const Vector3d& way, const CrackPiece& piece, const Vector3d& normal) {
    const Vector3d side = piece.to - piece.from, to = piece.from - from;
    const double both = normal.dot(way.cross(side));
    const double share = normal.dot(to.cross(side)) / both, on_piece = normal.dot(to.cross(way)) / both;
    const bool meets = share > touch && on_piece >= -touch && on_piece <= 1 + touch;
    return meets ? share : std::numeric_limits<double>::infinity();
}

/// Shares of the residual energy at a point that the cracks around it have released, sorted into ranges of
/// the cracks' directions. Of each range the largest share counts.
class Freed {
  public:
    explicit Freed(double reach) : reach(reach) { along.fill(Vector3d::Zero()); }

    double of(const Beside& crack) const { return std::exp(-crack.distance / reach); }
    /// Index of the range of 15 degrees to which the direction `along` belongs, counted from `first` about
    /// the normal. Opposite directions belong to the same range.
    static std::size_t direction(const Vector3d& along, const Vector3d& first, const Vector3d& normal) {
        const double angle = std::atan2(normal.dot(first.cross(along)), first.dot(along)) / std::numbers::pi;
        return static_cast<std::size_t>((angle - std::floor(angle)) * directions) % directions;
    }
    void add(const Beside& crack, std::size_t direction) {
        const double freed = of(crack);
        if (freed <= share[direction]) return;
        share[direction] = freed;
        along[direction] = crack.along;
    }
    /// The share released by all cracks and by one more crack.
    double with(const Beside& crack) const {
        double most = 0;
        for (std::size_t i = 0; i < directions; ++i)
            most = std::max(most, pair(of(crack), crack.along, share[i], along[i]));
        return std::max(most, of(crack));
    }
    double sum() const {
        double most = 0;
        for (std::size_t i = 0; i < directions; ++i)
            for (std::size_t j = i; j < directions; ++j)
                most = std::max(most, pair(share[i], along[i], share[j], along[j]));
        return most;
    }

  private:
    static constexpr std::size_t directions = 12;
    /// The share that two cracks release together: the larger of their shares, and of the smaller share the
    /// part that is due to stress along the other crack.
    static double pair(double a, const Vector3d& along_a, double b, const Vector3d& along_b) {
        const double cosine = along_a.dot(along_b);
        return std::max(a, b) + std::min(a, b) * (1 - cosine * cosine);
    }

    double reach;
    std::array<double, directions> share{};
    std::array<Vector3d, directions> along;
};

/// Cracks and ends of the sheet around a point, as pieces of straight lines, and the sheet's normal there.
struct Surroundings {
    Vector3d normal = Vector3d::Zero();
    std::vector<CrackPiece> cracks;
    std::vector<CrackPiece> ends;  ///< cracks and the outline of the sheet
};

/// The faces around a vertex, their neighbours, the neighbours of these, and so on, as long as a face has a
/// corner within `reach` (m) of the vertex. Faces on the two sides of an open crack are no neighbours.
std::vector<Index> faces_within(const BreakableShell& shell, Vertex from, double reach) {
    const Mesh& mesh = shell.mesh();
    const Shell& mechanics = shell.mechanics();
    const Vector3d place = mechanics.rest.col(static_cast<Index>(from));
    const auto is_near = [&](Index face) {
        const TrianglePositions corners = columns(mechanics.rest, mechanics.triangles[face].vertices);
        return (corners.colwise() - place).colwise().norm().minCoeff() < reach;
    };
    std::vector<Index> faces = faces_around(mesh, from);
    std::unordered_set<Index> known(faces.begin(), faces.end());
    for (std::size_t next = 0; next < faces.size(); ++next)
        for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(Face(faces[next])))) {
            if (mesh.is_border(mesh.edge(h))) continue;
            const auto other = static_cast<Index>(mesh.face(mesh.opposite(h)));
            if (is_near(other) && known.insert(other).second) faces.push_back(other);
        }
    return faces;
}

Surroundings surroundings(const BreakableShell& shell, Vertex from, double reach,
                          std::span<const CrackPiece> others) {
    const Mesh& mesh = shell.mesh();
    const Positions& rest = shell.mechanics().rest;
    Surroundings around{
        rest_normal_at(shell, from), {others.begin(), others.end()}, {others.begin(), others.end()}};
    for (const Index face : faces_within(shell, from, reach))
        for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(Face(face)))) {
            const Edge edge = mesh.edge(h);
            if (shell.cracks().state(edge) == EdgeState::interior) continue;
            const CrackPiece piece{rest.col(static_cast<Index>(mesh.source(h))),
                                   rest.col(static_cast<Index>(mesh.target(h)))};
            around.ends.push_back(piece);
            if (!shell.cracks().is_outline(edge)) around.cracks.push_back(piece);
        }
    return around;
}

/// Share of the path from `from` to from + way that lies before the first end of the sheet.
double way_within(const Surroundings& around, const Vector3d& from, const Vector3d& way) {
    double share = 1;
    for (const CrackPiece& end : around.ends)
        share = std::min(share, crossing(from, way, end, around.normal));
    return share;
}

/// Integral, m, of the share that a piece releases in addition to existing cracks, along the line from its
/// point `point` at right angles to it. side: 1 or -1, for the side of the piece on which the line runs.
double freed_across(const Surroundings& around, const Vector3d& point, const CrackPiece& piece, double side,
                    double reach) {
    const Vector3d along = (piece.to - piece.from).normalized();
    const Vector3d way = side * far * reach * around.normal.cross(along).normalized();
    const double length = way_within(around, point, way) * far * reach;
    const int points = static_cast<int>(std::ceil(length / (fineness * reach)));
    std::vector<std::size_t> directions;
    for (const CrackPiece& crack : around.cracks)
        directions.push_back(Freed::direction(crack.to - crack.from, along, around.normal));
    double sum = 0;
    for (int i = 0; i < points; ++i) {
        const double distance = length * (i + 0.5) / points;
        const Vector3d at = point + way.normalized() * distance;
        Freed freed(reach);
        for (std::size_t k = 0; k < directions.size(); ++k)
            freed.add(beside(at, around.cracks[k]), directions[k]);
        sum += std::max(0.0, freed.with({distance, along}) - freed.sum());
    }
    return points > 0 ? sum * length / points : 0;
}

}  // namespace

ResidualStress residual_stress(const Material& material) {
    const double squared = material.tempered * material.tempered;
    return {(1 - material.poisson) * material.thickness * squared / (5 * material.young),
            10 * released_by_end * (1 + material.poisson) * material.thickness};
}

double residual_energy(const BreakableShell& shell, std::span<const Edge> cracks) {
    const Shell& mechanics = shell.mechanics();
    double stored = 0;
    for (const Face face : shell.mesh().faces())
        stored += residual_stress(shell.material_of(face)).energy * mechanics.triangles[face].membrane.area;
    std::vector<CrackPiece> pieces;
    for (const Edge edge : cracks) {
        const Vertex from = shell.mesh().vertex(edge, 0);
        const Vector3d to = mechanics.rest.col(static_cast<Index>(shell.mesh().vertex(edge, 1)));
        const CrackPiece piece{mechanics.rest.col(static_cast<Index>(from)), to};
        stored -= residual_release(shell, from, to, pieces) * (to - piece.from).norm();
        pieces.push_back(piece);
    }
    return stored;
}

double residual_release(const BreakableShell& shell, Vertex from, const Vector3d& to,
                        std::span<const CrackPiece> others) {
    const ResidualStress residual = residual_stress(shell.material_at(static_cast<Index>(from)));
    const Vector3d place = shell.mechanics().rest.col(static_cast<Index>(from));
    CrackPiece piece{place, to};
    if (!(residual.energy > 0) || to == place) return 0;
    const Surroundings around = surroundings(shell, from, (to - place).norm() + far * residual.reach, others);
    piece.to = place + way_within(around, place, to - place) * (to - place);
    const Vector3d middle = 0.5 * (piece.from + piece.to);
    double freed = 0;
    for (const double side : {1.0, -1.0}) freed += freed_across(around, middle, piece, side, residual.reach);
    return 0.5 * residual.energy * freed;
}

void add_residual(const BreakableShell& shell, const GrowingTip& tip, TipLoad& load) {
    if (!(shell.material_at(tip.vertex).tempered > 0)) return;
    const Shell& mechanics = shell.mechanics();
    const Vector3d ahead = edge_length_ahead(shell, tip) * tip.direction;
    const double released =
                     residual_release(shell, Vertex(tip.vertex), mechanics.rest.col(tip.vertex) + ahead),
                 added = released / mechanics.thickness[tip.vertex] * mechanics.young[tip.vertex],
                 loaded = load.intensity * load.intensity;
    if (!(added > 0)) return;
    load.direction = (loaded * load.direction + added * tip.direction).normalized();
    load.intensity = std::sqrt(loaded + added);
    load.residual = added / (loaded + added);
}

}  // namespace sherd
