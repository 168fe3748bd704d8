// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/seam_warnings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meshops/number_text.h"
#include "meshops/seams.h"

namespace sherd {
namespace {

// Share of an edge's length: points nearer to the edge than that are probably meant to lie on it.
constexpr double near_share = 1e-3;

/// Warnings about the seams of a soup.
struct SeamWarnings {
    const TriangleSoup& soup;
    const ReadMeshOptions& options;

    std::string metres(double length) const { return number_text(length * options.unit) + " m"; }
    std::string vertex(std::uint32_t point) const { return std::to_string(soup.file_vertex[point]); }
    std::string edge(const std::array<std::uint32_t, 2>& ends) const {
        return "vertices " + vertex(ends[0]) + " and " + vertex(ends[1]) + " at " + middle_text(soup, ends);
    }
    double length(std::uint32_t a, std::uint32_t b) const {
        return std::sqrt(CGAL::squared_distance(soup.points[a], soup.points[b]));
    }
    double mean_edge() const;
    /// Advice to join points that are at most `gap` apart, in units of the file.
    std::string advice(double gap) const;

    std::string on_seams() const;
    std::string on_near_seams() const;
    std::string on_junctions() const;
};

double SeamWarnings::mean_edge() const {
    double sum = 0;
    for (const auto& [a, b, c] : soup.triangles) sum += length(a, b) + length(b, c) + length(c, a);
    return sum / static_cast<double>(3 * soup.triangles.size());
}

std::string SeamWarnings::advice(double gap) const {
    constexpr double least = 1e-6;  // mean edges, for round-off
    const double distance = std::max(2 * gap, least * mean_edge()) * options.unit;
    const double digit = std::pow(10, std::floor(std::log10(distance)));
    constexpr double round_off = 1e-6;
    return "`join = " + number_text(std::ceil(distance / digit - round_off) * digit) + "` (m) on the mesh";
}

std::string SeamWarnings::on_seams() const {
    const auto seams = seam_edges(soup);
    if (seams.empty()) return {};
    double sum = 0;
    for (const auto& [a, b] : seams) sum += length(a, b);
    return std::to_string(seams.size()) +
           " edges lie on each other without being joined, as along a crack (the first: " + edge(seams[0]) +
           "; total length " + metres(sum) + "); " + std::string(options.join_advice) +
           " joins the two sides";
}

std::string SeamWarnings::on_near_seams() const {
    const NearSeams seams = near_seams(soup, near_share);
    if (seams.edges.empty()) return {};
    return std::to_string(seams.edges.size()) +
           (seams.edges.size() == 1 ? " edge lies within " : " edges lie within ") + metres(seams.gap) +
           " of others without being joined to them (the first: " + edge(seams.edges[0]) + "; total length " +
           metres(seams.length) + "), so that the sheet is open there; " + advice(seams.gap) +
           " joins the two sides";
}

std::string SeamWarnings::on_junctions() const {
    const auto found = junctions(soup, near_share, std::numeric_limits<double>::infinity());
    if (found.empty()) return {};
    double sum = 0, gap = 0;
    std::vector<std::uint32_t> points;
    for (std::size_t i = 0; i < found.size(); ++i) {
        points.push_back(found[i].point);
        gap = std::max(gap, found[i].place.distance);
        if (i == 0 || found[i].edge != found[i - 1].edge) sum += length(found[i].edge[0], found[i].edge[1]);
    }
    std::ranges::sort(points);
    const auto count = std::unique(points.begin(), points.end()) - points.begin();
    return std::to_string(count) + (count == 1 ? " vertex lies" : " vertices lie") +
           " on edges without dividing them (T-junctions; the first: vertex " + vertex(found[0].point) +
           " on the edge of " + edge(found[0].edge) + "; edges with a total length of " + metres(sum) +
           "), so that the sheet is open there; " + advice(gap) + " divides these edges";
}

}  // namespace

std::vector<std::string> seam_warnings(const TriangleSoup& soup, const ReadMeshOptions& options) {
    if (options.join_advice.empty()) return {};
    const SeamWarnings warnings{soup, options};
    std::vector<std::string> sentences{warnings.on_seams(), warnings.on_near_seams(),
                                       warnings.on_junctions()};
    std::erase(sentences, std::string());
    return sentences;
}

}  // namespace sherd
