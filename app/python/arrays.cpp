// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/arrays.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>

#include "meshops/error.h"

namespace sherd::python {
namespace {

Error wrong_shape(const Numbers& array, const std::string& name, const std::string& wanted) {
    return Error(fmt::format("{}: is an array of shape [{}], not {}", name,
                             fmt::join(array.shape(), array.shape() + array.ndim(), ", "), wanted));
}

void require_rows(const Numbers& array, const std::string& name, std::size_t width) {
    if (array.ndim() == 2 && array.shape(1) == static_cast<py::ssize_t>(width)) return;
    throw wrong_shape(array, name, fmt::format("[n, {}]", width));
}

Index whole(double value, const std::string& name, py::ssize_t row) {
    if (value == std::floor(value) && std::abs(value) <= std::numeric_limits<Index>::max())
        return static_cast<Index>(value);
    throw Error(fmt::format("{}[{}]: {} is no whole number, or too large", name, row, value));
}

}  // namespace

std::vector<std::array<Index, 3>> corners_of(const Shell& shell) {
    std::vector<std::array<Index, 3>> corners;
    for (const TriangleStencil& triangle : shell.triangles) corners.push_back(triangle.vertices);
    return corners;
}

Positions columns_of(const Numbers& array, const std::string& name) {
    require_rows(array, name, 3);
    Positions columns = Eigen::Map<const Positions>(array.data(), 3, array.shape(0));
    for (Eigen::Index i = 0; i < columns.cols(); ++i)
        if (!columns.col(i).allFinite()) throw Error(fmt::format("{}[{}]: is not finite", name, i));
    return columns;
}

Positions columns_of(const Numbers& array, const std::string& name, Eigen::Index count) {
    Positions columns = columns_of(array, name);
    if (columns.cols() == count) return columns;
    throw Error(fmt::format("{}: has {} rows, not {}", name, columns.cols(), count));
}

std::vector<Index> indices_of(const Numbers& array, const std::string& name) {
    if (array.ndim() != 1) throw wrong_shape(array, name, "[n]");
    std::vector<Index> indices;
    for (py::ssize_t i = 0; i < array.size(); ++i) indices.push_back(whole(array.data()[i], name, i));
    return indices;
}

template <std::size_t N>
std::vector<std::array<Index, N>> rows_of(const Numbers& array, const std::string& name) {
    require_rows(array, name, N);
    std::vector<std::array<Index, N>> rows(static_cast<std::size_t>(array.shape(0)));
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t k = 0; k < N; ++k)
            rows[i][k] = whole(array.data()[N * i + k], name, static_cast<py::ssize_t>(i));
    return rows;
}
template std::vector<std::array<Index, 2>> rows_of<2>(const Numbers&, const std::string&);
template std::vector<std::array<Index, 3>> rows_of<3>(const Numbers&, const std::string&);

std::vector<Edge> edges_of(const Mesh& mesh, const Numbers& pairs) {
    std::vector<Edge> edges;
    const auto count = static_cast<Index>(mesh.number_of_vertices());
    for (const auto& [first, second] : rows_of<2>(pairs, "edges")) {
        const bool is_there = first >= 0 && first < count && second >= 0 && second < count;
        const Halfedge halfedge = is_there ? mesh.halfedge(Vertex(static_cast<unsigned>(first)),
                                                           Vertex(static_cast<unsigned>(second)))
                                           : Mesh::null_halfedge();
        if (halfedge == Mesh::null_halfedge())
            throw Error(fmt::format("edges[{}]: there is no edge between the vertices {} and {}",
                                    edges.size(), first, second));
        edges.push_back(mesh.edge(halfedge));
    }
    return edges;
}

}  // namespace sherd::python
