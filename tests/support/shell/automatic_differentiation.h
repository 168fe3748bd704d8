// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unsupported/Eigen/AutoDiff>

#include "core/vector.h"

namespace sherd::test {

/// Scalar with its first derivatives by N variables; and, below, scalar with first and second derivatives.
template <int N>
using Gradient = Eigen::AutoDiffScalar<Eigen::Matrix<double, N, 1>>;
template <int N>
using Curved = Eigen::AutoDiffScalar<Eigen::Matrix<Gradient<N>, N, 1>>;

/// Value, gradient and Hessian of a function.
template <int N>
struct Derivatives {
    double value;
    Eigen::Matrix<double, N, 1> gradient;
    Eigen::Matrix<double, N, N> hessian;
};

/// Differentiates `f`, which takes a Matrix<Curved<N>, rows, columns> and returns a Curved<N>, at x. The
/// entries of x are numbered column by column.
template <class Function, int Rows, int Columns>
Derivatives<Rows * Columns> differentiate(const Function& f, const Eigen::Matrix<double, Rows, Columns>& x) {
    constexpr int N = Rows * Columns;
    Eigen::Matrix<Curved<N>, Rows, Columns> variables;
    for (int i = 0; i < N; ++i) {
        variables(i) = Curved<N>(Gradient<N>(x(i), N, i), N, i);
        for (int j = 0; j < N; ++j)  // the first derivatives are constants
            variables(i).derivatives()(j).derivatives().setZero();
    }
    const Curved<N> y = f(variables);
    Derivatives<N> result;
    result.value = y.value().value();
    result.gradient = y.value().derivatives();
    for (int i = 0; i < N; ++i) result.hessian.col(i) = y.derivatives()(i).derivatives();
    return result;
}

}  // namespace sherd::test
