// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of opening a mesh. Argument: number of faces. `items_per_second` counts failed edges.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <vector>

#include "fracture/mesh/crack_mesh.h"
#include "meshops/generate/generate.h"
#include "meshops/random.h"

namespace {

using namespace sherd;

/// Square plate of about this number of faces.
const Mesh& plate(std::int64_t faces) {
    static std::int64_t last = 0;
    static Mesh mesh;
    if (last != faces) {
        const GenerateOptions options{std::sqrt(2.0 / static_cast<double>(faces)), Layout::delaunay, 1};
        mesh = generate_rectangle(1, 1, options);
        last = faces;
    }
    return mesh;
}

/// All interior edges, shuffled.
std::vector<Edge> shuffled_edges(const Mesh& mesh) {
    std::vector<Edge> edges;
    for (const Edge edge : mesh.edges())
        if (!mesh.is_border(edge)) edges.push_back(edge);
    Random random(1);
    for (std::size_t i = 1; i < edges.size(); ++i)
        std::swap(edges[i], edges[static_cast<std::size_t>(random.uniform() * static_cast<double>(i + 1))]);
    return edges;
}

void report(benchmark::State& state, const Mesh& mesh, std::size_t failed) {
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * failed));
    state.counters["faces"] = static_cast<double>(mesh.number_of_faces());
}

void every_edge_one_by_one(benchmark::State& state) {
    const Mesh& mesh = plate(state.range(0));
    const std::vector<Edge> edges = shuffled_edges(mesh);
    for (auto iteration : state) {
        state.PauseTiming();
        CrackMesh cracks(mesh);
        state.ResumeTiming();
        for (const Edge edge : edges) cracks.fail(std::array{edge});
        benchmark::DoNotOptimize(cracks.mesh().number_of_vertices());
    }
    report(state, mesh, edges.size());
}

void every_edge_at_once(benchmark::State& state) {
    const Mesh& mesh = plate(state.range(0));
    const std::vector<Edge> edges = shuffled_edges(mesh);
    for (auto iteration : state) {
        state.PauseTiming();
        CrackMesh cracks(mesh);
        state.ResumeTiming();
        benchmark::DoNotOptimize(cracks.fail(edges).topology.vertices.size());
    }
    report(state, mesh, edges.size());
}

constexpr std::int64_t smallest = 10'000, largest = 1'000'000;
BENCHMARK(every_edge_one_by_one)
    ->RangeMultiplier(10)
    ->Range(smallest, largest)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(every_edge_at_once)->RangeMultiplier(10)->Range(smallest, largest)->Unit(benchmark::kMillisecond);

}  // namespace
