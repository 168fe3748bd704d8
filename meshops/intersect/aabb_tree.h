// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// CGAL's trees of boxes around triangles. Their headers and types have other names in CGAL 6 than in CGAL 5.
#include <CGAL/AABB_tree.h>
#if __has_include(<CGAL/AABB_traits_3.h>)
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <vector>

#include "meshops/mesh.h"

namespace sherd {

using TriangleIterator = std::vector<Kernel::Triangle_3>::const_iterator;
#if __has_include(<CGAL/AABB_traits_3.h>)
using TrianglePrimitive = CGAL::AABB_triangle_primitive_3<Kernel, TriangleIterator>;
template <class Primitive>
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;
#else
using TrianglePrimitive = CGAL::AABB_triangle_primitive<Kernel, TriangleIterator>;
template <class Primitive>
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
#endif

}  // namespace sherd
