// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <type_traits>
#include <utility>

#include "core/block_columns.h"
#include "core/energy.h"
#include "core/state_visitor.h"

namespace sherd {

// Sums over elements, with one loop for all energies. `elements` must have, for i from 0 to size() - 1,
//     vertices(i)                  std::array<Index, N>; a number below zero: the vertex is not in the shell,
//                                  its position is prescribed, and forces on it are dropped
//     value(i, local)              J
//     gradient(i, local)           N, [3, N]
//     hessian(i, local, curvature) N/m, [3 N, 3 N], symmetric, coordinate fastest
// where `local` is the result of elements.gather(i, x), or, if there is no such function, the positions, [3,
// N] m, of the element's vertices.

template <class Elements>
auto local_positions(const Elements& elements, std::size_t i, const Positions& x) {
    if constexpr (requires { elements.gather(i, x); })
        return elements.gather(i, x);
    else
        return columns(x, elements.vertices(i));
}

template <class Elements>
double sum_of_values(const Elements& elements, const Positions& x) {
    double sum = 0;
    for (std::size_t i = 0; i < elements.size(); ++i)
        sum += elements.value(i, local_positions(elements, i, x));
    return sum;
}

template <class Elements>
void add_gradients(const Elements& elements, const Positions& x, Positions& gradient,
                   const Threads& threads = Threads()) {
    using Local = std::remove_cvref_t<decltype(elements.gradient(0, local_positions(elements, 0, x)))>;
    threads.share_lots<Local>(
        elements.size(),
        [&](std::size_t i, Local& local) { local = elements.gradient(i, local_positions(elements, i, x)); },
        [&](std::size_t first, std::span<const Local> lot) {
            for (std::size_t i = 0; i < lot.size(); ++i) {
                const auto vertices = elements.vertices(first + i);
                for (std::size_t v = 0; v < vertices.size(); ++v)
                    if (vertices[v] >= 0)
                        gradient.col(vertices[v]) += lot[i].col(static_cast<Eigen::Index>(v));
            }
        });
}

template <class Elements>
void add_hessians(const Elements& elements, const Positions& x, Curvature curvature, BlockMatrix& hessian) {
    using Local =
        std::remove_cvref_t<decltype(elements.hessian(0, local_positions(elements, 0, x), curvature))>;
    hessian.add_elements<Local>(
        elements.size(),
        [&](std::size_t i, Local& local) {
            if (!hessian.has_all(elements.vertices(i))) return false;
            local = elements.hessian(i, local_positions(elements, i, x), curvature);
            return true;
        },
        [&](BlockMatrix::Columns& columns, std::size_t i, const Local& local) {
            add_element(columns, elements.vertices(i), local);
        });
}

/// Appends the pairs of vertices of each element.
template <class Elements>
void add_patterns(const Elements& elements, std::vector<std::pair<Index, Index>>& pairs) {
    for (std::size_t i = 0; i < elements.size(); ++i) add_pairs(pairs, elements.vertices(i));
}

/// An energy that is the sum over elements. The elements do not change within a step.
template <class Elements>
class ElementEnergy : public Energy {
  public:
    explicit ElementEnergy(Elements elements) : elements(std::move(elements)) {}

    double value(const Positions& x) const override { return sum_of_values(elements, x); }
    void add_gradient(const Positions& x, Positions& gradient) const override {
        add_gradients(elements, x, gradient);
    }
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override {
        add_hessians(elements, x, curvature, hessian);
    }
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override {
        add_patterns(elements, pairs);
    }
    void add_pattern_among(const std::vector<char>& among,
                           std::vector<std::pair<Index, Index>>& pairs) const override {
        for (std::size_t i = 0; i < elements.size(); ++i)
            if (std::ranges::all_of(elements.vertices(i), [&](Index v) { return v < 0 || among[v] != 0; }))
                add_pairs(pairs, elements.vertices(i));
    }
    /// Elements that have no visit_state() belong to the shell, or begin() makes them.
    void visit_state(StateVisitor& visit) override {
        if constexpr (HasState<Elements>) visit(elements);
    }

  protected:
    Elements elements;
};

}  // namespace sherd
