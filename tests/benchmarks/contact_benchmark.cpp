// SPDX-License-Identifier: GPL-3.0-or-later
// What contact costs in one step of a sheet that is rolled up and touches itself all over. Argument: faces.
// The longer the sheet, the more turns the roll has; its edges are two thicknesses long.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "core/contact/sheet_contact.h"

namespace {

using namespace sherd;

constexpr double thickness = 1e-3, edge = 2e-3, pitch = 0.97 * thickness, inner_radius = 0.005;
constexpr Index across = 8;  // squares

/// Where along the spiral r = inner_radius + pitch angle / (2 pi), with angles a chord apart.
Vector3d next_on_spiral(double& angle) {
    const double growth = pitch / (2 * std::numbers::pi), radius = inner_radius + growth * angle;
    const Vector3d at(radius * std::cos(angle), radius * std::sin(angle), 0);
    angle += edge / radius;
    return at;
}

Sheet roll(std::int64_t faces) {
    const Index along = static_cast<Index>(faces) / (2 * across), row = across + 1;
    const Material rubber{.density = 1000, .thickness = thickness, .young = 2e6, .poisson = 0.4};
    Sheet sheet;
    resize_vertices(sheet, (along + 1) * row);
    double angle = 0;
    for (Index i = 0; i <= along; ++i) {
        const Vector3d at = next_on_spiral(angle);
        for (Index j = 0; j <= across; ++j) {
            const Index v = i * row + j;
            sheet.rest.col(v) = Vector3d(i * edge, j * edge, 0);
            sheet.position.col(v) = at + Vector3d(0, 0, j * edge);
            if (i == along || j == across) continue;
            for (const std::array<Index, 3>& corners :
                 {std::array{v, v + row, v + row + 1}, std::array{v, v + row + 1, v + 1}})
                sheet.triangles.push_back({corners, membrane_triangle(triangle_positions(sheet.rest, corners),
                                                                      membrane_elasticity(rubber))});
        }
    }
    sheet.thickness.setConstant(thickness);
    sheet.young.setConstant(rubber.young);
    sheet.footprint.setConstant(edge * edge);
    return sheet;
}

/// Each vertex goes its own way, by up to a fiftieth of the thickness.
Positions shaking(const Sheet& sheet) {
    Positions motion(3, sheet.position.cols());
    Index i = 0;
    for (double& entry : motion.reshaped()) entry = 0.02 * thickness * std::sin(1.7 * ++i);
    return motion;
}

BlockMatrix contact_matrix(const Sheet& sheet, const SheetContact& contact) {
    std::vector<std::pair<Index, Index>> pairs;
    contact.add_contacts(sheet.position, true, pairs);
    return BlockMatrix(static_cast<Index>(sheet.position.cols()), std::move(pairs), sheet.fixed);
}

/// What one iteration of Newton's method asks for.
void iterate(const SheetContact& contact, const Positions& x, const Positions& motion, BlockMatrix& matrix) {
    Positions gradient = Positions::Zero(3, x.cols());
    benchmark::DoNotOptimize(contact.value(x));
    contact.add_gradient(x, gradient);
    contact.add_hessian(x, Curvature::exact, matrix);
    benchmark::DoNotOptimize(contact.safe_fraction(x, motion));
}

void report(benchmark::State& state, const Sheet& sheet, const SheetContact& contact) {
    state.counters["faces"] = static_cast<double>(sheet.triangles.size());
    state.counters["touching"] = static_cast<double>(contact.touching(sheet.position).size());
}

/// A step for which all pairs have to be found.
void from_nothing(benchmark::State& state) {
    const Sheet sheet = roll(state.range(0));
    const Positions motion = shaking(sheet);
    SheetContact contact(sheet);
    BlockMatrix matrix = contact_matrix(sheet, contact);
    for (auto iteration : state) {
        const SheetContact anew(sheet);
        iterate(anew, sheet.position, motion, matrix);
    }
    report(state, sheet, contact);
}

/// A later step, to and fro.
void of_known_pairs(benchmark::State& state) {
    const Sheet sheet = roll(state.range(0));
    const Positions motion = shaking(sheet);
    SheetContact contact(sheet);
    BlockMatrix matrix = contact_matrix(sheet, contact);
    int steps = 0;
    for (auto iteration : state) {
        const Positions x = sheet.position + (++steps % 2) * 1e-2 * motion;
        iterate(contact, x, motion, matrix);
    }
    report(state, sheet, contact);
}

BENCHMARK(from_nothing)->Arg(5'000)->Arg(20'000)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(of_known_pairs)->Arg(5'000)->Arg(20'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

}  // namespace
