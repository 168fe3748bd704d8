// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/focus.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace sherd {
namespace {

constexpr double kept_share = 0.95;  // smallest share of a sheet's area that remains without outliers
constexpr double nearness = 1.5;     // fragments up to this multiple of the reach of that share are kept, too

struct Piece {
    Eigen::AlignedBox3d box;
    double area = 0;
    double reach = 0;  ///< m, distance of the farthest corner of `box` from the middle of the sheet
};

/// Returns the fragments of each sheet, by the sheet's number.
std::map<Index, std::vector<Piece>> pieces_of(const Snapshot& frame) {
    std::map<std::pair<Index, Index>, Piece> pieces;
    for (std::size_t f = 0; f < frame.faces.size(); ++f) {
        Piece& piece = pieces[{frame.face_sheet[f], frame.face_fragment[f]}];
        piece.area += frame.rest.area[f];
        for (const Index v : frame.faces[f])
            if (frame.position.col(v).allFinite()) piece.box.extend(Vector3d(frame.position.col(v)));
    }
    std::map<Index, std::vector<Piece>> sheets;
    for (const auto& [key, piece] : pieces)
        if (!piece.box.isEmpty()) sheets[key.first].push_back(piece);
    return sheets;
}

double area_of(std::span<const Piece> pieces) {
    double area = 0;
    for (const Piece& piece : pieces) area += piece.area;
    return area;
}

/// Returns the median of the fragments' centres in each direction, weighted by area, which few distant
/// fragments do not change.
Vector3d middle_of(std::span<const Piece> pieces) {
    const double half = area_of(pieces) / 2;
    Vector3d middle;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<std::pair<double, double>> places;  // coordinate and area of each fragment
        for (const Piece& piece : pieces) places.emplace_back(piece.box.center()[axis], piece.area);
        std::ranges::sort(places);
        double below = 0;
        for (const auto& [place, area] : places) {
            middle[axis] = place;
            if ((below += area) >= half) break;
        }
    }
    return middle;
}

/// Returns the distance (m) from the middle of a sheet within which its fragments are no outliers.
double focus_radius(std::vector<Piece> pieces) {
    std::ranges::sort(pieces, {}, [](const Piece& piece) { return piece.reach; });
    const double enough = kept_share * area_of(pieces);
    double inside = 0;
    for (const Piece& piece : pieces)
        if ((inside += piece.area) >= enough) return nearness * piece.reach;
    return nearness * pieces.back().reach;
}

double reach_of(const Eigen::AlignedBox3d& box, const Vector3d& middle) {
    return (box.max() - middle).cwiseAbs().cwiseMax((box.min() - middle).cwiseAbs()).norm();
}

}  // namespace

Eigen::AlignedBox3d focus_box(const Snapshot& frame) {
    Eigen::AlignedBox3d focus;
    for (auto& [sheet, pieces] : pieces_of(frame)) {
        const Vector3d middle = middle_of(pieces);
        for (Piece& piece : pieces) piece.reach = reach_of(piece.box, middle);
        const double radius = focus_radius(pieces);
        for (const Piece& piece : pieces)
            if (piece.reach <= radius) focus.extend(piece.box);
    }
    return focus;
}

}  // namespace sherd
