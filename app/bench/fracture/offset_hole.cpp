// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/QR>
#include <cmath>

#include "app/bench/fracture/grown_crack.h"

namespace sherd {
namespace {

constexpr int degree = 10;  // degree of SmoothCurve: a lower degree does not fit the path on fine meshes

/// The polynomial y(x) that fits points in the least squares.
class SmoothCurve {
  public:
    explicit SmoothCurve(const std::vector<Vector2d>& points)
        : from(points.front().x()), length(points.back().x() - points.front().x()) {
        Eigen::MatrixXd powers(points.size(), degree + 1);
        VectorXd y(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            powers.row(row) = powers_at(points[i].x()).transpose();
            y[row] = points[i].y();
        }
        factors = powers.colPivHouseholderQr().solve(y);
    }
    double arc_length() const {
        constexpr int pieces = 1000;
        double sum = 0;
        for (int i = 0; i < pieces; ++i) sum += (at(i + 1.0, pieces) - at(i, pieces)).norm();
        return sum;
    }

  private:
    Vector2d at(double i, int pieces) const {
        const double x = from + length * i / pieces;
        return {x, factors.dot(powers_at(x))};
    }
    VectorXd powers_at(double x) const {
        VectorXd powers(degree + 1);
        for (int n = 0; n <= degree; ++n) powers[n] = std::pow(2 * (x - from) / length - 1, n);
        return powers;
    }

    double from, length;
    VectorXd factors;
};

std::vector<double> measure_torn(const FractureHistory& run) {
    std::vector<Vector2d> path{FirstCrack(run.scene).to};
    double length = 0;
    for (const GrownEdge& edge : grown_edges(run)) {
        length += (edge.to - path.back()).norm();
        path.push_back(edge.to);
    }
    return {length / SmoothCurve(path).arc_length()};
}

}  // namespace

FractureCase offset_hole() {
    return {.name = "notch and offset hole",
            .scene = "experiments/offset_hole",
            .variant = "",
            .source = "",
            .unit = 0.012,
            .in_units = "R",
            .edges = {0.004, 0.0028, 0.002},
            .numbers = {{"path / smooth curve", 1, 0.02}},
            .measure = measure_torn,
            .compares_paths = true};
}

}  // namespace sherd
