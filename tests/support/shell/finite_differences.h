// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace sherd::test {

/// d f(x + s e_i) / ds at s = 0 by central differences of fourth order.
template <class Function, class Matrix>
auto difference_quotient(const Function& f, const Matrix& x, Eigen::Index i, double step) {
    const auto at = [&](double steps) {
        Matrix moved = x;
        moved(i) += steps * step;
        return f(moved);
    };
    const auto near = at(1), far = at(2);
    return decltype(at(1))((8 * (near - at(-1)) - (far - at(-2))) / (12 * step));
}

/// Gradient of `value` at x by central differences, in the shape of x.
template <class Function, class Matrix>
Matrix difference_gradient(const Function& value, const Matrix& x, double step) {
    Matrix gradient;
    for (Eigen::Index i = 0; i < x.size(); ++i) gradient(i) = difference_quotient(value, x, i, step);
    return gradient;
}

/// Hessian from `gradient`, by central differences. The entries of x are numbered column by column.
template <class Function, class Matrix>
auto difference_hessian(const Function& gradient, const Matrix& x, double step) {
    constexpr int size = Matrix::SizeAtCompileTime;
    Eigen::Matrix<double, size, size> hessian;
    for (int i = 0; i < size; ++i) {
        const Matrix column = difference_quotient(gradient, x, i, step);
        hessian.col(i) = column.reshaped();
    }
    return hessian;
}

}  // namespace sherd::test
