// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/numpy.h>

#include <array>
#include <span>
#include <string>
#include <vector>

#include "app/recording/hdf5.h"
#include "core/shell/shell.h"
#include "core/vector.h"
#include "meshops/mesh.h"

/// Python module of Sherd.
namespace sherd::python {

namespace py = pybind11;

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Returns an array of numbers: [rows], or, if `width` is more than 1, [rows, width]. With an owner, the
/// array is a read-only view that keeps the owner alive; without one, the array is a copy.
template <class Scalar>
py::array numbers(const Scalar* first, std::size_t rows, std::size_t width, py::handle owner = {}) {
    std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows)};
    if (width > 1) shape.push_back(static_cast<py::ssize_t>(width));
    py::array array(py::dtype::of<Scalar>(), shape, rows == 0 ? nullptr : first, owner);
    if (owner) array.attr("setflags")(py::arg("write") = false);
    return array;
}

template <class T>
py::array array_of(const std::vector<T>& rows, py::handle owner = {}) {
    using E = hdf5::Element<T>;
    return numbers(reinterpret_cast<const typename E::Scalar*>(rows.data()), rows.size(), E::width, owner);
}

inline py::array array_of(const VectorXd& values, py::handle owner = {}) {
    return numbers(values.data(), static_cast<std::size_t>(values.size()), 1, owner);
}

/// Returns columns [3, n] as an array [n, 3].
inline py::array array_of(const Positions& columns, py::handle owner = {}) {
    return numbers(columns.data(), static_cast<std::size_t>(columns.cols()), 3, owner);
}

/// Returns the matrix [4, 4] of a motion.
inline py::array array_of(const Eigen::Isometry3d& motion) {
    const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> rows = motion.matrix();
    return numbers(rows.data(), 4, 4);
}

/// Returns the vertices of each face of a shell.
std::vector<std::array<Index, 3>> corners_of(const Shell& shell);

/// Returns the rows of an array [n, 3] as columns [3, n]. Throws Error, naming the array, if it has another
/// shape or a number that is not finite.
Positions columns_of(const Numbers& array, const std::string& name);

/// Returns the rows of an array [count, 3] as columns. Throws Error as columns_of() does, and also if the
/// number of rows is not `count`.
Positions columns_of(const Numbers& array, const std::string& name, Eigen::Index count);

/// Returns the whole numbers of an array [n]. Throws Error, naming the array, if it has another shape, or a
/// number that is not whole.
std::vector<Index> indices_of(const Numbers& array, const std::string& name);

/// Returns the whole numbers in the rows of an array [n, N]. Throws Error as indices_of() does.
template <std::size_t N>
std::vector<std::array<Index, N>> rows_of(const Numbers& array, const std::string& name);

/// Returns the edges between pairs of vertices [n, 2]. Throws Error, naming the pair, if there is no edge
/// between its vertices.
std::vector<Edge> edges_of(const Mesh& mesh, const Numbers& pairs);

}  // namespace sherd::python
