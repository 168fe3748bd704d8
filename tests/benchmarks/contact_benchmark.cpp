// SPDX-License-Identifier: GPL-3.0-or-later
// contact_benchmark [RUN.h5]: cost of contact in one step of a sheet that touches itself all over. The name
// of a benchmark has the number of faces, its argument is the number of threads. Time is wall time. Without a
// recording the sheet is a roll with edges two thicknesses long; more faces give it more turns. With a
// recording, the sheet has the shape of its last frame, at three resolutions: as recorded, and with each
// triangle divided into four and into sixteen.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "app/recording/recording.h"
#include "core/contact/sheets/sheet_contact.h"
#include "tests/support/recording/recorded_sheet.h"

namespace {

using namespace sherd;

constexpr double thickness = 1e-3, edge = 2e-3, pitch = 0.97 * thickness, inner_radius = 0.005;
constexpr Index across = 8;  // number of squares across the roll

/// Returns the point at `angle` on the spiral r = inner_radius + pitch angle / (2 pi), and advances `angle`
/// by about the length `edge`.
Vector3d next_on_spiral(double& angle) {
    const double growth = pitch / (2 * std::numbers::pi), radius = inner_radius + growth * angle;
    Vector3d at(radius * std::cos(angle), radius * std::sin(angle), 0);
    angle += edge / radius;
    return at;
}

Shell roll(std::int64_t faces) {
    const Index along = static_cast<Index>(faces) / (2 * across), row = across + 1;
    Positions rest(3, (along + 1) * row), position = rest;
    std::vector<std::array<Index, 3>> triangles;
    double angle = 0;
    for (Index i = 0; i <= along; ++i) {
        const Vector3d at = next_on_spiral(angle);
        for (Index j = 0; j <= across; ++j) {
            const Index v = i * row + j;
            rest.col(v) = Vector3d(i * edge, j * edge, 0);
            position.col(v) = at + Vector3d(0, 0, j * edge);
            if (i == along || j == across) continue;
            triangles.push_back({v, v + row, v + row + 1});
            triangles.push_back({v, v + row + 1, v + 1});
        }
    }
    const std::size_t count = rest.cols();
    return test::bare_sheet(rest, position, triangles, std::vector<double>(count, thickness),
                            std::vector<Index>(count, 0));
}

/// Sheet of the same shape with each triangle divided into four at the midpoints of its sides.
Shell in_four(const Shell& sheet) {
    std::map<std::array<Index, 2>, Index> middle;
    std::vector<std::array<Index, 3>> triangles;
    Index count = static_cast<Index>(sheet.position.cols());
    for (const TriangleStencil& triangle : sheet.triangles) {
        const auto& corner = triangle.vertices;
        std::array<Index, 3> between;
        for (int i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax(corner[i], corner[(i + 1) % 3]);
            const auto found = middle.try_emplace({low, high}, count);
            count += found.second;
            between[i] = found.first->second;
        }
        triangles.push_back(between);
        for (int i = 0; i < 3; ++i) triangles.push_back({corner[i], between[i], between[(i + 2) % 3]});
    }
    Positions rest = sheet.rest, position = sheet.position;
    std::vector<double> thick(sheet.thickness.begin(), sheet.thickness.end());
    std::vector<Index> body = sheet.vertex_sheet;
    rest.conservativeResize(3, count);
    position.conservativeResize(3, count);
    thick.resize(count);
    body.resize(count);
    for (const auto& [ends, v] : middle) {
        rest.col(v) = 0.5 * (sheet.rest.col(ends[0]) + sheet.rest.col(ends[1]));
        position.col(v) = 0.5 * (sheet.position.col(ends[0]) + sheet.position.col(ends[1]));
        thick[v] = thick[ends[0]];
        body[v] = body[ends[0]];
    }
    return test::bare_sheet(rest, position, triangles, thick, body);
}

/// Motion by which each coordinate changes by up to a fiftieth of the thickness.
Positions shaking(const Shell& sheet) {
    Positions motion(3, sheet.position.cols());
    Index i = 0;
    for (double& entry : motion.reshaped()) entry = 0.02 * sheet.thickness[0] * std::sin(1.7 * ++i);
    return motion;
}

SheetContact contact_of(const Shell& sheet, const benchmark::State& state) {
    return SheetContact(sheet, {}, true, false, Threads(static_cast<int>(state.range(0))));
}

BlockMatrix contact_matrix(const Shell& sheet, const SheetContact& contact, const benchmark::State& state) {
    std::vector<std::pair<Index, Index>> pairs;
    contact.add_contacts(sheet.position, true, pairs);
    BlockMatrix matrix(static_cast<Index>(sheet.position.cols()), pairs, sheet.fixed);
    matrix.share_among(Threads(static_cast<int>(state.range(0))));
    return matrix;
}

/// Evaluations of one iteration of Newton's method.
void iterate(const SheetContact& contact, const Positions& x, const Positions& motion, BlockMatrix& matrix) {
    Positions gradient = Positions::Zero(3, x.cols());
    benchmark::DoNotOptimize(contact.value(x));
    contact.add_gradient(x, gradient);
    contact.add_hessian(x, Curvature::exact, matrix);
    benchmark::DoNotOptimize(contact.safe_fraction(x, motion));
}

void report(benchmark::State& state, const Shell& sheet, const SheetContact& contact) {
    state.counters["faces"] = static_cast<double>(sheet.triangles.size());
    state.counters["touching"] = static_cast<double>(contact.active_pairs(sheet.position).size());
}

/// Measures a step whose contact must find all pairs.
void from_nothing(benchmark::State& state, const Shell& sheet) {
    const Positions motion = shaking(sheet);
    const SheetContact contact = contact_of(sheet, state);
    BlockMatrix matrix = contact_matrix(sheet, contact, state);
    for (auto iteration : state) {
        const SheetContact anew = contact_of(sheet, state);
        iterate(anew, sheet.position, motion, matrix);
    }
    report(state, sheet, contact);
}

/// Measures a later step, whose contact already knows the pairs; the sheet moves back and forth.
void of_known_pairs(benchmark::State& state, const Shell& sheet) {
    const Positions motion = shaking(sheet);
    const SheetContact contact = contact_of(sheet, state);
    BlockMatrix matrix = contact_matrix(sheet, contact, state);
    int steps = 0;
    for (auto iteration : state) {
        const Positions x = sheet.position + (++steps % 2) * 1e-2 * motion;
        iterate(contact, x, motion, matrix);
    }
    report(state, sheet, contact);
}

void add_benchmarks(const Shell& sheet) {
    const std::string faces = std::to_string(sheet.triangles.size());
    for (const auto& [name, function] :
         {std::pair{"from_nothing/", &from_nothing}, std::pair{"of_known_pairs/", &of_known_pairs}})
        benchmark::RegisterBenchmark((name + faces).c_str(), function, sheet)
            ->ArgName("threads")
            ->Arg(1)
            ->Arg(2)
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (argc > 1) {
        const Recording recording(argv[1]);
        Shell sheet = test::recorded_sheet(recording.frame(recording.frame_count() - 1));
        for (int times = 0; times < 3; ++times) {
            add_benchmarks(sheet);
            sheet = in_four(sheet);
        }
    } else {
        for (const std::int64_t faces : {5'000, 20'000, 100'000}) add_benchmarks(roll(faces));
    }
    benchmark::RunSpecifiedBenchmarks();
}
