// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/sheet/edge_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "meshops/attributes.h"
#include "meshops/error.h"
#include "meshops/read_write/text_line.h"

namespace sherd {
namespace {

using VertexPair = std::pair<std::uint32_t, std::uint32_t>;
using EdgesByEnds = std::vector<std::pair<VertexPair, Edge>>;

/// Returns the mesh's edges, sorted by the numbers that their ends have in the mesh file. Where the reader
/// has separated a non-manifold edge, several edges have the same pair of ends.
EdgesByEnds edges_by_file_vertices(const Mesh& mesh) {
    const auto number = find_property(mesh, attribute::file_vertex).first;
    EdgesByEnds edges;
    edges.reserve(mesh.number_of_edges());
    for (const Edge edge : mesh.edges())
        edges.emplace_back(std::minmax(number[mesh.vertex(edge, 0)], number[mesh.vertex(edge, 1)]), edge);
    std::ranges::sort(edges);
    return edges;
}

/// Returns the only edge between `ends`. Throws Error, beginning with `where`, if there is none, if there are
/// several, or if it is on the boundary.
Edge interior_edge(const Mesh& mesh, const EdgesByEnds& edges, const VertexPair& ends,
                   const std::string& where) {
    const auto before = [](const auto& a, const auto& b) { return a.first < b.first; };
    const auto [begin, end] = std::equal_range(edges.begin(), edges.end(), std::pair(ends, Edge()), before);
    if (begin == end)
        throw Error(where + " is not in the mesh; vertices are numbered from 0, as in the mesh file");
    if (std::distance(begin, end) > 1)
        throw Error(where + " is not manifold in the mesh file and was separated; it is open already");
    if (mesh.is_border(begin->second)) throw Error(where + " is on the boundary; it is open already");
    return begin->second;
}

std::uint32_t vertex_number(TextLine& line) {
    const std::string_view word = line.next_word();
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (word.empty()) line.fail("a vertex number is missing; write two 0-based numbers a line", word);
    if (error != std::errc() || end != word.data() + word.size())
        line.fail("is not a vertex number; write two 0-based numbers a line", word);
    return number;
}

VertexPair read_pair(TextLine& line) {
    const std::uint32_t first = vertex_number(line), second = vertex_number(line);
    if (!line.is_at_end()) line.fail("is one too many; write two vertex numbers a line", line.next_word());
    return std::minmax({first, second});
}

}  // namespace

std::vector<Edge> read_edge_list(const std::filesystem::path& file, const Mesh& mesh) {
    std::ifstream stream(file);
    if (!stream || std::filesystem::is_directory(file))
        throw Error(fmt::format("{}: cannot read the list of edges; check the path", file.string()));
    const auto edges = edges_by_file_vertices(mesh);
    std::map<VertexPair, std::size_t> line_of;
    std::vector<Edge> chosen;
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    TextLines lines(file, without_byte_order_mark(file, text));
    while (std::optional<TextLine> line = lines.next_with_words('#')) {
        const std::size_t number = lines.number();
        const VertexPair ends = read_pair(*line);
        const std::string where =
            fmt::format("{}:{}: edge {} {}", file.string(), number, ends.first, ends.second);
        const auto [known, added] = line_of.emplace(ends, number);
        if (!added)
            throw Error(fmt::format("{} was given in line {} already; remove one", where, known->second));
        chosen.push_back(interior_edge(mesh, edges, ends, where));
    }
    if (chosen.empty())
        throw Error(fmt::format("{}: holds no edge; write two vertex numbers a line", file.string()));
    return chosen;
}

}  // namespace sherd
