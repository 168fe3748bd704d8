// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of evaluating a crack tip in a plate of 8,000 faces. First argument: number of rings around the tip.
// Second argument: whether the tip force includes bending.
#include <benchmark/benchmark.h>

#include "core/tips/configurational_force.h"
#include "core/tips/stress_intensity.h"
#include "fracture/shell/breakable_shell.h"
#include "meshops/generate/generate.h"

namespace {

using namespace sherd;

/// Square plate that is cut from one side to its centre, and the tip of this crack.
struct TornPlate {
    TornPlate() : shell(torn()), around(shell), bending(shell, {}), x(shell.rest) {
        Index centre = 0;
        shell.rest.colwise().squaredNorm().minCoeff(&centre);
        tip = crack_tip(shell, around, centre, std::vector<char>(shell.rest.cols()));
        for (Index v = 0; v < x.cols(); ++v) x(2, v) = 0.05 * x(0, v) * x(1, v) + 0.02 * x(1, v) * x(1, v);
    }
    static Shell torn() {
        SheetInput input;
        input.mesh = generate_polygon({{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {}, {{{-1, 0}, {0, 0}}}},
                                      {0.034, Layout::delaunay, 1});
        input.material = {.density = 1000, .thickness = 0.01, .young = 1e9, .poisson = 0.3};
        return BreakableShell({input}).mechanics();
    }

    Shell shell;
    VertexFaces around;
    CoupledBending bending;
    Positions x;
    CrackTip tip;
};

const TornPlate& torn_plate() {
    static const TornPlate plate;
    return plate;
}

void make_tip_force(benchmark::State& state) {
    const TornPlate& p = torn_plate();
    for (auto iteration : state)
        benchmark::DoNotOptimize(
            TipForce(p.shell, p.around, {&p.bending}, p.tip, static_cast<int>(state.range(0))));
    state.counters["faces"] = static_cast<double>(p.shell.triangles.size());
}

void evaluate_tip(benchmark::State& state) {
    const TornPlate& p = torn_plate();
    const auto rings = static_cast<int>(state.range(0));
    const bool bends = state.range(1) != 0;
    const TipForce force(p.shell, p.around, {bends ? &p.bending : nullptr}, p.tip, rings);
    for (auto iteration : state) benchmark::DoNotOptimize(force.at(p.x));
}

void factors_of_membrane(benchmark::State& state) {
    const TornPlate& p = torn_plate();
    for (auto iteration : state) benchmark::DoNotOptimize(membrane_intensity(p.shell, p.around, p.tip, p.x));
}

void factors_of_bending(benchmark::State& state) {
    const TornPlate& p = torn_plate();
    for (auto iteration : state)
        benchmark::DoNotOptimize(plate_intensity(p.shell, p.around, p.bending, p.tip, p.x));
}

BENCHMARK(make_tip_force)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(evaluate_tip)->ArgsProduct({{0, 1, 2}, {0, 1}})->Unit(benchmark::kMicrosecond);
BENCHMARK(factors_of_membrane)->Unit(benchmark::kMicrosecond);
BENCHMARK(factors_of_bending)->Unit(benchmark::kMicrosecond);

}  // namespace
