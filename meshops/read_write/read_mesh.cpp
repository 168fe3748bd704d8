// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/read_write/read_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "meshops/attributes.h"
#include "meshops/error.h"
#include "meshops/number_text.h"
#include "meshops/repair/flat_triangles.h"
#include "meshops/repair/inside_out.h"
#include "meshops/repair/repeated_polygons.h"
#include "meshops/repair/seams.h"
#include "meshops/repair/separate_sheets.h"
#include "meshops/soup/triangle_soup.h"

namespace sherd {
namespace {

// Fraction of the length of an edge: points nearer to the edge than that are probably meant to lie on it.
constexpr double near_share = 1e-3;

/// Warnings about the seams of a soup. A warning is empty if there is nothing to report.
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
    /// Returns advice to join points that are at most `gap` apart, in units of the file.
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
    constexpr double least = 1e-6;  // mean edges: smallest distance to advise, above round-off
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

/// Returns warnings about seams, where a sheet is open although it looks closed: edges that lie on each
/// other, edges that nearly lie on each other, and vertices on edges that they do not divide. Each warning
/// contains advice to join them. Returns none if `options.join_advice` is empty.
std::vector<std::string> seam_warnings(const TriangleSoup& soup, const ReadMeshOptions& options) {
    if (options.join_advice.empty()) return {};
    const SeamWarnings warnings{soup, options};
    std::vector<std::string> sentences{warnings.on_seams(), warnings.on_near_seams(),
                                       warnings.on_junctions()};
    std::erase(sentences, std::string());
    return sentences;
}

/// The start of a warning: "1 face was" or "3 faces were".
std::string counted(std::size_t count, const std::string& noun) {
    const std::string plural = noun.ends_with("x") ? noun.substr(0, noun.size() - 2) + "ices" : noun + "s";
    return std::to_string(count) + " " + (count == 1 ? noun + " was" : plural + " were");
}

/// Reading of one file: the steps from polygons to a mesh, and the warnings on the way.
struct Reading {
    PolygonSoup polygons;
    const ReadMeshOptions& options;
    std::vector<std::string>& warnings;
    TriangleSoup soup = {};

    void warn(const std::string& sentence) const {
        warnings.push_back(polygons.file.string() + ": " + sentence);
    }
    std::string place(std::size_t triangle) const {
        return place_of_polygon(polygons, soup.polygon[triangle]);
    }
    std::string vertex(std::uint32_t point) const { return std::to_string(soup.file_vertex[point]); }
    std::string corners(std::size_t triangle) const {
        const auto& [a, b, c] = soup.triangles[triangle];
        return vertex(a) + ", " + vertex(b) + " and " + vertex(c) + " at " + middle(soup.triangles[triangle]);
    }
    std::string middle(std::span<const std::uint32_t> points) const { return middle_text(soup, points); }
    /// Returns advice on a repair that does `what`, such as "; `repair = true` on the mesh drops such
    /// triangles"; or advice to correct the file, if the user cannot request repairs.
    std::string advice(const std::string& what) const {
        return options.repair_advice.empty() ? "; correct it in the program that made it"
                                             : "; " + std::string(options.repair_advice) + " " + what;
    }

    bool repairs_all() const { return options.repair == Repair::all; }
    /// Returns the place in the file of the first of `triangles`, and how many more there are: "a.obj:7: face
    /// 1 (and 2 more)".
    std::string places(const std::vector<std::size_t>& triangles) const {
        return place(triangles[0]) +
               (triangles.size() > 1 ? " (and " + std::to_string(triangles.size() - 1) + " more)" : "");
    }

    void drop_few_corners();
    /// Joins points according to the options. Returns the number of points that are no longer used, and a
    /// warning about these, which is empty if there are none.
    std::pair<std::size_t, std::string> join_points();
    void drop_repeated_polygons();
    void divide_edges();
    void remove_zero_area();
    void remove_repeated();
    void make_manifold();
    void make_consistent();
    void turn_outward();
    void tell_bare() const;
    /// Reports points that no face uses. wanted: number of points without those that join_points() replaced.
    void report_unused(std::size_t wanted) const;
    Mesh build() const;
    void give_attributes(Mesh& mesh) const;
};

void Reading::drop_few_corners() {
    const auto found = polygons_of_few_corners(polygons);
    if (found.empty()) return;
    const std::string first = place_of_polygon(polygons, found[0]);
    if (!repairs_all())
        throw Error(first + ": has " + std::to_string(polygons.polygons[found[0]].size()) +
                    " corners, a face needs three or more" + advice("drops such faces"));
    warn(counted(found.size(), "face") + " dropped for fewer than three corners (the first: " + first + ")");
    for (const std::size_t polygon : found) polygons.polygons[polygon].clear();
}

void Reading::drop_repeated_polygons() {
    const auto found = repeated_polygons(polygons);
    if (found.empty()) return;
    const std::string first = place_of_polygon(polygons, found[0].polygon) +
                              ", which covers the same area as face " + std::to_string(found[0].earlier);
    if (!repairs_all())
        throw Error(first + ", which makes their edges non-manifold" + advice("drops repeated faces"));
    warn(counted(found.size(), "face") + " dropped as repeated (the first: " + first + ")");
    for (const RepeatedPolygon& repeated : found) polygons.polygons[repeated.polygon].clear();
}

void Reading::remove_zero_area() {
    const auto found = zero_area_triangles(soup);
    if (found.empty()) return;
    if (!repairs_all()) {
        throw Error(place(found[0]) + ": the triangle of vertices " + corners(found[0]) + " has zero area" +
                    (found.size() > 1 ? " (and " + std::to_string(found.size() - 1) + " more)" : "") +
                    advice("drops such triangles"));
    }
    warn(counted(found.size(), "triangle") + " dropped for zero area (the first: " + place(found[0]) + ")");
    remove_zero_area_triangles(soup);
    if (soup.triangles.empty()) {
        throw Error(polygons.file.string() + ": the mesh has no faces left: all triangles have zero area");
    }
}

void Reading::remove_repeated() {
    const auto found = repeated_triangles(soup);
    if (found.empty()) return;
    if (!repairs_all()) {
        throw Error(place(found[0]) + ": the triangle of vertices " + corners(found[0]) +
                    " occurs twice, which makes its edges non-manifold" + advice("drops repeated triangles"));
    }
    warn(counted(found.size(), "triangle") + " dropped as repeated (the first: " + place(found[0]) + ")");
    erase_triangles(soup, found);
}

void Reading::divide_edges() {
    if (!(options.join_distance > 0)) return;
    const std::size_t divided = split_at_junctions(soup, options.join_distance);
    if (divided > 0) warn(counted(divided, "edge") + " divided by vertices that lie on them");
}

void Reading::make_manifold() {
    const auto edges = non_manifold_edges(soup);
    if (!edges.empty() && !repairs_all()) {
        std::string faces;
        for (const std::size_t triangle : edges[0].triangles) {
            faces += (faces.empty() ? "" : ", ") + std::to_string(soup.polygon[triangle]);
        }
        throw Error(place(edges[0].triangles[2]) +
                    ": non-manifold edge: " + std::to_string(edges[0].triangles.size()) + " faces (" + faces +
                    ") meet at the edge of vertices " + vertex(edges[0].points[0]) + " and " +
                    vertex(edges[0].points[1]) + " at " + middle(edges[0].points) +
                    ", a sheet has at most two" + advice("separates them"));
    }
    if (!edges.empty()) {
        warn(counted(edges.size(), "non-manifold edge") + " separated (the first: vertices " +
             vertex(edges[0].points[0]) + " and " + vertex(edges[0].points[1]) + ")");
    }
    const auto doubled = separate_sheets(soup);
    if (doubled.empty()) return;
    if (options.repair == Repair::none) {
        throw Error(polygons.file.string() + ": faces meet at vertex " + vertex(doubled[0]) +
                    " without being joined by an edge of two faces" +
                    advice("gives each side its own vertex"));
    }
    warn(counted(doubled.size(), "vertex") +
         " doubled because faces met there without being joined by an edge of two faces (the first: vertex " +
         vertex(doubled[0]) + ")");
}

void Reading::make_consistent() {
    const auto orientation = orient(soup);
    if (orientation.one_sided) {
        throw Error(
            place(*orientation.one_sided) + " at " + middle(soup.triangles[*orientation.one_sided]) +
            ": the surface has only one side (like a Moebius band), so its faces cannot all point the "
            "same way; cut it open along a line before it is read");
    }
    if (orientation.turned.empty()) return;
    if (options.repair == Repair::none) {
        throw Error(places(orientation.turned) + ": does not point the same way as its neighbours" +
                    advice("turns such faces over"));
    }
    warn(counted(orientation.turned.size(), "face") +
         " turned over to point the same way as the neighbours (the first: " + place(orientation.turned[0]) +
         ")");
}

void Reading::turn_outward() {
    const auto found =
        options.repair == Repair::least ? std::vector<std::size_t>{} : inside_out_triangles(soup);
    if (found.empty()) return;
    if (!repairs_all()) {
        throw Error(places(found) + ": points into the closed surface that it is part of" +
                    advice("turns such surfaces outward"));
    }
    warn(counted(found.size(), "face") +
         " turned over, of closed parts that were inside out (the first: " + place(found[0]) + ")");
    for (const std::size_t triangle : found) reverse_triangle(soup, triangle);
}

void Reading::tell_bare() const {
    std::size_t bare = 0;
    for (std::size_t i = 0; i < polygons.texture.size(); ++i)
        bare += polygons.texture[i].empty() && !polygons.polygons[i].empty();
    if (bare > 0) warn(counted(bare, "face") + " given texture coordinates (0, 0)");
}

void Reading::report_unused(std::size_t wanted) const {
    const std::size_t unused =
        wanted - static_cast<std::size_t>(std::ranges::count(used_points(polygons), true));
    if (unused == 0) return;
    if (options.repair == Repair::none) {
        throw Error(polygons.file.string() + ": no face uses " + std::to_string(unused) + " of the vertices" +
                    advice("drops them"));
    }
    warn(counted(unused, "vertex") + " dropped that no face uses");
}

std::pair<std::size_t, std::string> Reading::join_points() {
    if (options.join_duplicate_points || options.join_distance > 0) {
        std::size_t joined = join_duplicate_points(polygons);
        const bool is_near = options.join_distance > 0;
        if (is_near) joined += join_near_points(polygons, options.join_distance);
        const std::string where = is_near
                                      ? " within " + number_text(options.join_distance * options.unit) + " m"
                                      : " at the same place";
        return {joined, joined == 0 ? "" : counted(joined, "vertex") + " joined with another" + where};
    }
    if (options.repair == Repair::least || !shares_no_point(polygons)) return {0, ""};
    PolygonSoup joint = polygons;
    const std::size_t joined = join_duplicate_points(joint);
    if (joined == 0) return {0, ""};
    if (options.repair == Repair::none) {
        throw Error(
            polygons.file.string() + ": no two faces share a vertex, but " + std::to_string(joined) +
            " vertices lie where others do" +
            (options.join_advice.empty() ? "" : "; " + std::string(options.join_advice) + " joins them"));
    }
    polygons = std::move(joint);
    return {joined, counted(joined, "vertex") +
                        " joined with another at the same place, since no two faces shared one"};
}

Mesh Reading::build() const {
    std::vector<bool> is_used(soup.points.size(), false);
    for (const auto& triangle : soup.triangles) {
        for (const auto point : triangle) is_used[point] = true;
    }
    Mesh mesh;
    auto file_vertex = add_property(mesh, attribute::file_vertex);
    std::vector<Vertex> vertex_of(soup.points.size());
    for (std::size_t i = 0; i < soup.points.size(); ++i) {
        if (!is_used[i]) continue;
        vertex_of[i] = mesh.add_vertex(soup.points[i]);
        file_vertex[vertex_of[i]] = soup.file_vertex[i];
    }
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        const auto& [a, b, c] = soup.triangles[t];
        if (mesh.add_face(vertex_of[a], vertex_of[b], vertex_of[c]) == Mesh::null_face()) {
            throw Error(place(t) + ": the triangle of vertices " + corners(t) + " does not fit the others",
                        Fault::run);
        }
    }
    if (!soup.texture.empty()) {
        auto texture = add_property(mesh, attribute::texture);
        for (const Face face : mesh.faces()) texture[face] = soup.texture[face.idx()];
    }
    give_attributes(mesh);
    return mesh;
}

void Reading::give_attributes(Mesh& mesh) const {
    const auto file_vertex = find_property(mesh, attribute::file_vertex).first;
    const auto give = [&](const auto& attribute, const auto& elements, const auto& row) {
        const auto& list = polygons.look.*attribute.list;
        if (list.empty()) return;
        auto values = add_property(mesh, attribute);
        for (const auto element : elements) values[element] = list[row(element)];
    };
    visit_attributes_of<Vertex>([&](const auto& attribute) {
        give(attribute, mesh.vertices(), [&](Vertex vertex) { return file_vertex[vertex]; });
    });
    visit_attributes_of<Face>([&](const auto& attribute) {
        give(attribute, mesh.faces(), [&](Face face) { return soup.polygon[face.idx()]; });
    });
}

}  // namespace

Mesh read_mesh(const std::filesystem::path& file, const ReadMeshOptions& options,
               std::vector<std::string>& warnings) {
    Reading reading{read_polygon_soup(file), options, warnings};
    const PolygonSoup& polygons = reading.polygons;
    check_polygon_soup(polygons);
    for (const std::string& missing : polygons.warnings) reading.warn(missing);
    reading.drop_few_corners();
    const auto [joined, sentence] = reading.join_points();
    if (!sentence.empty()) reading.warn(sentence);
    reading.drop_repeated_polygons();
    reading.soup = triangulate(polygons);
    if (reading.soup.triangles.empty())
        throw Error(file.string() + ": the mesh has no faces left: none has three corners");
    reading.tell_bare();
    reading.report_unused(polygons.points.size() - joined);
    reading.divide_edges();
    reading.remove_zero_area();
    reading.remove_repeated();
    for (const std::string& seam : seam_warnings(reading.soup, options)) reading.warn(seam);
    reading.make_manifold();
    reading.make_consistent();
    reading.turn_outward();
    return reading.build();
}

}  // namespace sherd
