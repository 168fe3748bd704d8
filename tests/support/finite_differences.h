// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace sherd::test {

/// Gradient of `value` at x by central differences, in the shape of x.
template <class Function, class Matrix>
Matrix difference_gradient(const Function& value, const Matrix& x, double step) {
    Matrix gradient;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        Matrix plus = x, minus = x;
        plus(i) += step;
        minus(i) -= step;
        gradient(i) = (value(plus) - value(minus)) / (2 * step);
    }
    return gradient;
}

/// Hessian from `gradient`, by central differences; coordinate fastest.
template <class Function, class Matrix>
auto difference_hessian(const Function& gradient, const Matrix& x, double step) {
    constexpr int size = Matrix::SizeAtCompileTime;
    Eigen::Matrix<double, size, size> hessian;
    for (int i = 0; i < size; ++i) {
        Matrix plus = x, minus = x;
        plus(i) += step;
        minus(i) -= step;
        const Matrix column = (gradient(plus) - gradient(minus)) / (2 * step);
        hessian.col(i) = column.reshaped();
    }
    return hessian;
}

}  // namespace sherd::test
