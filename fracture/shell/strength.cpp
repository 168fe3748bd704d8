// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/shell/strength.h"

#include <algorithm>
#include <cmath>

#include "meshops/mesh_measures.h"
#include "meshops/random.h"

namespace sherd {
namespace {

double hinge_area(const Mesh& mesh, Edge edge) {
    double area = 0;
    for (const int side : {0, 1})
        if (const Halfedge h = mesh.halfedge(edge, side); !mesh.is_border(h))
            area += face_area(mesh, mesh.face(h)) / 3;
    return area;
}

}  // namespace

Strength uniform_strength(double value, Measure measure) {
    return {.measure = measure, .along = value, .across = value};
}

double hankinson(double along, double across, double angle) {
    if (along == across) return along;
    const double cosine = std::cos(angle), sine = std::sin(angle);
    return 1 / (cosine * cosine / across + sine * sine / along);
}

double directional_strength(const Strength& strength, double angle) {
    return hankinson(strength.along, strength.across, angle);
}

std::optional<FactorRange> factor_range(std::span<const double> factors) {
    std::optional<FactorRange> range;
    std::size_t never = 0;
    for (const double factor : factors) {
        if (std::isinf(factor)) {
            ++never;
        } else if (!range) {
            range = FactorRange{factor, factor};
        } else {
            range->least = std::min(range->least, factor);
            range->most = std::max(range->most, factor);
        }
    }
    if (range) range->never = never;
    return range;
}

std::vector<double> weibull_factors(const Mesh& mesh, const Weibull& weibull) {
    Random random(weibull.seed);
    const double power = 1 / weibull.modulus, mean = std::tgamma(1 + power);
    std::vector<double> factors;
    for (const Edge edge : mesh.edges()) {
        const double least = 0x1p-53;  // a hinge of strength zero would fail without load
        const double survival = 1 - std::max(least, random.uniform());
        factors.push_back(std::pow(-std::log(survival), power) / mean);
        if (weibull.area > 0) factors.back() *= std::pow(weibull.area / hinge_area(mesh, edge), power);
    }
    return factors;
}

}  // namespace sherd
