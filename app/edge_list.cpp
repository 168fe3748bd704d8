// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/edge_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <map>
#include <string>

#include "meshops/error.h"
#include "meshops/text_line.h"

namespace sherd {
namespace {

using VertexPair = std::pair<std::uint32_t, std::uint32_t>;

/// The mesh's edges by the numbers of their ends in the file. Where the reader separated what was not
/// manifold, several edges share a pair.
std::multimap<VertexPair, Edge> edges_by_file_vertices(const Mesh& mesh) {
    const auto number = mesh.property_map<Vertex, std::uint32_t>(property::file_vertex).first;
    std::multimap<VertexPair, Edge> edges;
    for (const Edge edge : mesh.edges())
        edges.emplace(std::minmax(number[mesh.vertex(edge, 0)], number[mesh.vertex(edge, 1)]), edge);
    return edges;
}

std::uint32_t vertex_number(TextLine& line) {
    const std::string_view word = line.next_word();
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (word.empty() || error != std::errc() || end != word.data() + word.size())
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
    if (!stream) throw Error(fmt::format("{}: cannot read the list of edges; check the path", file.string()));
    const auto edges = edges_by_file_vertices(mesh);
    std::map<VertexPair, std::size_t> line_of;
    std::vector<Edge> chosen;
    std::string text;
    for (std::size_t number = 1; std::getline(stream, text); ++number) {
        text = text.substr(0, text.find('#'));
        TextLine line(file, number, text);
        if (line.is_at_end()) continue;
        const VertexPair ends = read_pair(line);
        const std::string where =
            fmt::format("{}:{}: edge {} {}", file.string(), number, ends.first, ends.second);
        const auto [known, added] = line_of.emplace(ends, number);
        if (!added)
            throw Error(fmt::format("{} was given in line {} already; remove one", where, known->second));
        const auto [begin, end] = edges.equal_range(ends);
        if (begin == end)
            throw Error(where + " is not in the mesh; vertices are numbered from 0, as in the mesh file");
        if (std::distance(begin, end) > 1)
            throw Error(where + " is not manifold in the mesh file and was separated; it is open already");
        if (mesh.is_border(begin->second)) throw Error(where + " is on the boundary; it is open already");
        chosen.push_back(begin->second);
    }
    if (chosen.empty())
        throw Error(fmt::format("{}: holds no edge; write two vertex numbers a line", file.string()));
    return chosen;
}

}  // namespace sherd
