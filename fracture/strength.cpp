// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/strength.h"

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

double directional_strength(const Strength& strength, double angle) {
    const double s0 = strength.along, s1 = strength.across;
    if (s0 == s1) return s0;
    const double cosine = std::cos(angle), sine = std::sin(angle);
    return 1 / (cosine * cosine / s1 + sine * sine / s0);
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
