// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/winds.h"

#include <cmath>
#include <numbers>

#include "meshops/random.h"

namespace sherd {
namespace {

using std::numbers::pi;

constexpr int waves = 64;  // number of waves: enough for a sum that is nearly Gaussian

}  // namespace

std::vector<GustWave> gust_waves(const GustSpec& gust, const Vector3d& wind, std::int64_t seed) {
    Random random(static_cast<unsigned>(seed));
    // Random factor from 1/2 to 2 on the wave number or the frequency of a typical gust.
    const auto octaves = [&random] { return std::exp2(2 * random.uniform() - 1); };
    std::vector<GustWave> result;
    for (int i = 0; i < waves; ++i) {
        const double height = 2 * random.uniform() - 1, turn = 2 * pi * random.uniform();
        const double radius = std::sqrt(1 - height * height);
        const Vector3d direction(radius * std::cos(turn), radius * std::sin(turn), height);
        const Vector3d across = direction.unitOrthogonal();
        const double angle = 2 * pi * random.uniform();
        GustWave wave;
        wave.amplitude = gust.amplitude * std::sqrt(2.0 / waves) *
                         (std::cos(angle) * across + std::sin(angle) * direction.cross(across));
        wave.wave = 2 * pi / gust.length * octaves() * direction;
        wave.frequency = 2 * pi / gust.time * octaves() - wave.wave.dot(wind);
        wave.phase = 2 * pi * random.uniform();
        result.push_back(wave);
    }
    return result;
}

void add_winds(const Scene& scene, const Shell& mechanics, SimulationOptions& options) {
    for (const WindSpec& spec : scene.winds) {
        Wind wind = spec.wind;
        if (spec.gust) wind.gusts = gust_waves(*spec.gust, wind.velocity, scene.seed);
        for (Index t = 0; t < static_cast<Index>(mechanics.triangles.size()); ++t) {
            const Index sheet = mechanics.vertex_sheet[mechanics.triangles[t].vertices[0]];
            if (spec.sheet.empty() || scene.sheets[sheet].name == spec.sheet) wind.triangles.push_back(t);
        }
        options.stepper.shell.winds.push_back(wind);
    }
}

}  // namespace sherd
