// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batches/coupled_batches.h"

#include <numeric>

#include "core/elements/dihedral_angle.h"
#include "core/elements/fold_gradient.h"
#include "core/elements/membrane_stress.h"

namespace sherd {
namespace {

using LanesMatrix = Eigen::Matrix<Lanes, 3, 3>;

/// Index of each entry of a symmetric matrix among the six numbers that a batch stores.
constexpr int entry[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};

constexpr Index batches_at_once = 64, rows_at_once = 512;

}  // namespace

void FaceBatches::build(const Shell& shell, const std::vector<Level>& levels, const SideMoments* bending,
                        CornerSums& corners, std::vector<Level>& at_vertices) {
    const std::size_t count = shell.triangles.size();
    std::vector<Level> of_faces(count, 0);
    for (std::size_t f = 0; f < count; ++f) {
        Level& level = of_faces[f];
        for (const Index v : shell.triangles[f].vertices) raise(level, levels[v]);
        if (bending != nullptr)
            for (const Index side : bending->of_face[f]) raise(level, bending->levels[side]);
        for (const Index v : shell.triangles[f].vertices) raise(at_vertices[v], level);
    }
    order = LevelOrder(of_faces);
    batches.assign(batches_of(count), {});
    for (Index b = 0; b < static_cast<Index>(batches.size()); ++b) {
        Batch& batch = batches[b];
        for (int lane = 0; lane < Lanes::count; ++lane) {
            const Index face = order[element_of(b, lane, count)];
            const auto& [vertices, membrane] = shell.triangles[face];
            for (int i = 0; i < 3; ++i) {
                batch.vertices[i][lane] = vertices[i];
                batch.sides[i][lane] = bending != nullptr ? bending->of_face[face][i] : 0;
                for (int j = 0; j < 3; ++j)
                    batch.stiffness[entry[i][j]].set(lane, membrane.area * membrane.elasticity(i, j));
                if (i > 0)
                    for (int j = 0; j < 2; ++j)
                        batch.derivatives[i - 1][j].set(lane, membrane.derivatives(i, j));
            }
        }
        batch.place = corners.append(batch.vertices, present_in(b, count));
    }
}

inline FaceBatches::Strained FaceBatches::Batch::at(const PaddedPositions& x) const {
    const LanesVector start = gather(x, vertices[0]);
    Strained of;
    of.one = gather(x, vertices[1]) - start;
    of.other = gather(x, vertices[2]) - start;
    for (int i = 0; i < 2; ++i) of.F.col(i) = derivatives[0][i] * of.one + derivatives[1][i] * of.other;
    of.strain = strain_of(of.F);
    for (int i = 0; i < 3; ++i)
        of.stress[i] = stiffness[entry[i][0]] * of.strain[0] + stiffness[entry[i][1]] * of.strain[1] +
                       stiffness[entry[i][2]] * of.strain[2];
    return of;
}

void FaceBatches::find(Index begin, Index end, const PaddedPositions& x, const SideMoments* bending,
                       CornerSums& corners) const {
    const bool bent = bending != nullptr;
    wide_loop(begin, end, [&](Index number) {
        const Batch& batch = batches[number];
        const auto& D = batch.derivatives;
        const auto [one, other, F, strain, stress] = batch.at(x);
        const Eigen::Matrix<Lanes, 3, 2> P = pulled(F, stress);
        LanesMatrix gradient;
        for (int i = 0; i < 2; ++i) gradient.col(i + 1) = D[i][0] * P.col(0) + D[i][1] * P.col(1);
        gradient.col(0) = -(gradient.col(1) + gradient.col(2));
        if (bent) {
            LanesMatrix edges;
            edges.col(0) = other - one;
            edges.col(1) = -other;
            edges.col(2) = one;
            const auto& [a, b, c] = batch.sides;
            const std::vector<double>& moments = bending->per_length;
            gradient += fold_gradient(edges, {gather(moments, a), gather(moments, b), gather(moments, c)});
        }
        for (int i = 0; i < 3; ++i) scatter(gradient.col(i), corners.at(batch.place + i * Lanes::count));
    });
}

double FaceBatches::energy(const PaddedPositions& x) const {
    double sum = 0;
    wide_loop(0, static_cast<Index>(batches.size()), [&](Index number) {
        const Strained of = batches[number].at(x);
        const Lanes energies = 0.5 * of.strain.dot(of.stress);
        for (int lane = 0; lane < present_in(number, order.count(0)); ++lane) sum += energies[lane];
    });
    return sum;
}

CoupledBatches::Rows CoupledBatches::Rows::transposed(Index columns) const {
    Rows other;
    other.start.assign(columns + 1, 0);
    for (const Index c : column) ++other.start[c + 1];
    std::partial_sum(other.start.begin(), other.start.end(), other.start.begin());
    other.column.resize(column.size());
    other.weight.resize(column.size());
    std::vector<Index> next(other.start.begin(), other.start.end() - 1);
    for (Index row = 0; row + 1 < static_cast<Index>(start.size()); ++row)
        for (Index i = start[row]; i < start[row + 1]; ++i) {
            const Index at = next[column[i]]++;
            other.column[at] = row;
            other.weight[at] = weight[i];
        }
    return other;
}

void CoupledBatches::build(const Shell& of, const CoupledBending& bending, const std::vector<Level>& levels) {
    shell = &of;
    of_hinges = static_cast<Index>(of.hinges.size());
    folds = of_hinges + bending.all_folds().folds_of_edges();
    build_shares(bending);
    build_tangents(bending);
    find_levels(bending, levels);
    build_hinges(bending);
    build_faces(bending);
    changes.assign(folds, 0);
    of_length.assign(of_hinges, 0);
    of_tangents.assign(tangents.size(), 0);
    at_sides.per_length.assign(folds + 1, 0);
}

Index CoupledBatches::number(const CoupledBending& bending, Index fold) const {
    const Index mirrors = bending.all_folds().folds_of_edges();
    return fold < mirrors ? of_hinges + fold : shell->edge_hinge[fold - mirrors];
}

void CoupledBatches::build_shares(const CoupledBending& bending) {
    shares = {};
    for (Index hinge = 0; hinge < of_hinges; ++hinge) {
        for (const auto& [fold, weight] : bending.face_curvature().shares_of_first(shell->hinge_edge[hinge]))
            shares.append(number(bending, fold), weight);
        shares.end_row();
    }
    shared = shares.transposed(folds);
}

void CoupledBatches::build_tangents(const CoupledBending& bending) {
    const FaceCurvature& curvature = bending.face_curvature();
    const Index mirrors = bending.all_folds().folds_of_edges();
    const Index count = static_cast<Index>(shell->triangles.size());
    tangents_of_face.resize(count);
    at_sides.of_face.resize(count);
    Index next_free = 2 * folds;
    for (Index face = 0; face < count; ++face)
        for (int side = 0; side < 3; ++side) {
            const Index fold = curvature.around().fold_at(face, side);
            Index& tangent = tangents_of_face[face][side];
            at_sides.of_face[face][side] = folds;
            if (fold < 0) {
                tangent = next_free++;
                continue;
            }
            const Index here = number(bending, fold);
            tangent = 2 * here;
            if (fold < mirrors) continue;
            at_sides.of_face[face][side] = here;
            if (!curvature.is_first(fold - mirrors, {face, side})) ++tangent;
        }
    tangents.assign(next_free, 0);
}

void CoupledBatches::find_levels(const CoupledBending& bending, const std::vector<Level>& of_vertices) {
    std::vector<Level> of_changes(folds, 0);  // levels of the folds' angles
    for (Index hinge = 0; hinge < of_hinges; ++hinge)
        for (const Index v : shell->hinges[hinge].vertices) raise(of_changes[hinge], of_vertices[v]);
    for (Index mirror = 0; mirror < folds - of_hinges; ++mirror)
        for (const Index v : bending.all_folds().vertices(mirror))
            if (v >= 0) raise(of_changes[of_hinges + mirror], of_vertices[v]);

    std::vector<Level> of_tangents(folds, 0);  // levels of the tangents at folds
    for (Index fold = 0; fold < folds; ++fold) {
        of_tangents[fold] = of_changes[fold];
        if (fold >= of_hinges) continue;
        for (Index i = shares.start[fold]; i < shares.start[fold + 1]; ++i)
            raise(of_tangents[fold], of_changes[shares.column[i]]);
    }

    std::vector<Level> of_faces(tangents_of_face.size(), 0);
    std::vector<Level> of_derivatives(tangents.size(),
                                      0);  // levels of the entries of CoupledBatches::of_tangents
    for (std::size_t face = 0; face < tangents_of_face.size(); ++face) {
        for (const Index tangent : tangents_of_face[face])
            if (tangent < 2 * folds) raise(of_faces[face], of_tangents[tangent / 2]);
        for (const Index tangent : tangents_of_face[face]) raise(of_derivatives[tangent], of_faces[face]);
    }

    at_sides.levels.assign(folds + 1, 0);
    for (Index fold = 0; fold < folds; ++fold) {
        Level& level = at_sides.levels[fold];
        // The derivative by the angle is divided by the length of the side, which changes with the angle.
        level = std::max({of_changes[fold], of_derivatives[2 * fold], of_derivatives[2 * fold + 1]});
        for (Index i = shared.start[fold]; i < shared.start[fold + 1]; ++i)
            for (const int first : {0, 1}) raise(level, of_derivatives[2 * shared.column[i] + first]);
    }

    const auto of_hinges_alone = [this](const std::vector<Level>& all) {
        return LevelOrder({all.begin(), all.begin() + of_hinges});
    };
    hinge_order = of_hinges_alone(of_changes);
    tangent_order = of_hinges_alone(of_tangents);
    face_order = LevelOrder(of_faces);
    moment_order = of_hinges_alone(at_sides.levels);
}

void CoupledBatches::build_hinges(const CoupledBending& bending) {
    const Index mirrors = bending.all_folds().folds_of_edges();
    hinges.assign(batches_of(of_hinges), {});
    for (Index i = 0; i < Lanes::count * batches_of(of_hinges); ++i) {
        const Index b = i / Lanes::count;
        const int lane = i % Lanes::count;
        const Index hinge = hinge_order[element_of(b, lane, of_hinges)];
        auto& [start, vertices, numbers] = hinges[b];
        const double angle = bending.start_angle(mirrors + shell->hinge_edge[hinge]);
        start[0].set(lane, std::cos(angle));
        start[1].set(lane, std::sin(angle));
        for (int v = 0; v < 4; ++v) vertices[v][lane] = shell->hinges[hinge].vertices[v];
        numbers[lane] = hinge;
    }
}

void CoupledBatches::build_faces(const CoupledBending& bending) {
    const std::size_t count = shell->triangles.size();
    faces.assign(batches_of(count), {});
    for (Index i = 0; i < Lanes::count * batches_of(count); ++i) {
        const Index b = i / Lanes::count;
        const int lane = i % Lanes::count;
        const Index face = face_order[element_of(b, lane, count)];
        for (int side = 0; side < 3; ++side) faces[b].tangents[side][lane] = tangents_of_face[face][side];
        const Matrix3d C = bending.face_curvature().per_tangent(face);
        const Matrix3d full = C.transpose() * bending.rigidity(face) * C;
        const double entries[] = {full(0, 0), full(1, 1), full(2, 2), full(0, 1), full(0, 2), full(1, 2)};
        for (int k = 0; k < 6; ++k) faces[b].rigidity[k].set(lane, entries[k]);
    }
}

void CoupledBatches::find(const PaddedPositions& x, int level, const Threads& threads,
                          std::vector<double>& of_mirrors) {
    const Index mirrors = folds - of_hinges;
    for (Index m = 0; m < mirrors; ++m) {
        changes[of_hinges + m] = of_mirrors[m];
        tangents[2 * (of_hinges + m)] = 0.5 * of_mirrors[m];
    }
    threads.share_ranges(batches_of(hinge_order.count(level)), batches_at_once,
                         [&](Index begin, Index end) { find_changes(begin, end, x); });
    threads.share_ranges(tangent_order.count(level), rows_at_once,
                         [&](Index begin, Index end) { find_tangents(begin, end); });
    threads.share_ranges(batches_of(face_order.count(level)), 2 * batches_at_once,
                         [&](Index begin, Index end) { find_of_tangents(begin, end); });
    threads.share_ranges(moment_order.count(level), rows_at_once,
                         [&](Index begin, Index end) { find_moments(begin, end); });
    for (Index m = 0; m < mirrors; ++m)
        of_mirrors[m] = 0.5 * of_tangents[2 * (of_hinges + m)] + moment(of_hinges + m);
}

double CoupledBatches::energy() const {
    const auto count = static_cast<Eigen::Index>(tangents.size());
    return 0.5 * Eigen::Map<const VectorXd>(tangents.data(), count)
                     .dot(Eigen::Map<const VectorXd>(of_tangents.data(), count));
}

void CoupledBatches::find_changes(Index begin, Index end, const PaddedPositions& x) {
    wide_loop(begin, end, [&](Index b) {
        const auto& [start, vertices, numbers] = hinges[b];
        Eigen::Matrix<Lanes, 3, 4> at;
        for (int v = 0; v < 4; ++v) at.col(v) = gather(x, vertices[v]);
        const DihedralAngleOf<Lanes> fold(at);
        const Lanes change = fold.angle_from({start[0], start[1]}), inverse = 1 / fold.edge_length();
        scatter(change, numbers, changes);
        scatter(inverse, numbers, of_length);
    });
}

void CoupledBatches::find_tangents(Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
        const Index fold = tangent_order[i];
        double sum = 0;
        for (Index j = shares.start[fold]; j < shares.start[fold + 1]; ++j)
            sum += shares.weight[j] * changes[shares.column[j]];
        tangents[2 * fold] = sum;
        tangents[2 * fold + 1] = changes[fold] - sum;
    }
}

void CoupledBatches::find_of_tangents(Index begin, Index end) {
    wide_loop(begin, end, [&](Index b) {
        const auto& [D, at] = faces[b];
        const Lanes angle[] = {gather(tangents, at[0]), gather(tangents, at[1]), gather(tangents, at[2])};
        scatter(D[0] * angle[0] + D[3] * angle[1] + D[4] * angle[2], at[0], of_tangents);
        scatter(D[3] * angle[0] + D[1] * angle[1] + D[5] * angle[2], at[1], of_tangents);
        scatter(D[4] * angle[0] + D[5] * angle[1] + D[2] * angle[2], at[2], of_tangents);
    });
}

/// Part of the derivative of the energy by a fold's angle, N m: the part due to the fold's shares in the
/// angles to tangents.
double CoupledBatches::moment(Index fold) const {
    double sum = 0;
    for (Index i = shared.start[fold]; i < shared.start[fold + 1]; ++i) {
        const double* both = of_tangents.data() + 2 * shared.column[i];
        sum += shared.weight[i] * (both[0] - both[1]);
    }
    return sum;
}

void CoupledBatches::find_moments(Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
        const Index fold = moment_order[i];
        at_sides.per_length[fold] = of_length[fold] * (of_tangents[2 * fold + 1] + moment(fold));
    }
}

}  // namespace sherd
