// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene_wind.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "app/scene/scene_force.h"
#include "meshops/random.h"

namespace sherd {
namespace {

using std::numbers::pi;

constexpr int waves = 64;  // enough for sums that are nearly Gaussian

GustSpec read_gust(TomlTable& table) {
    GustSpec gust;
    gust.amplitude = table.number("amplitude", "m/s", not_negative);
    gust.time = table.number("time", "s", positive);
    gust.length = table.number("length", "m", positive);
    table.finish();
    return gust;
}

WindSpec read_wind(TomlTable& table, const Scene& scene) {
    WindSpec spec;
    spec.where = table.where("");
    Wind& wind = spec.wind;
    wind.velocity = table.vector("velocity", "m/s", wind.velocity);
    wind.ramp = table.number("ramp", "s", not_negative, wind.ramp);
    wind.density = table.number("density", "kg/m^3", positive, wind.density);
    wind.drag = table.number("drag", "", not_negative, wind.drag);
    wind.lift = table.number("lift", "", not_negative, wind.lift);
    wind.friction = table.number("friction", "", not_negative, wind.friction);
    if (auto gust = table.table("gust")) spec.gust = read_gust(*gust);
    spec.sheet = read_sheet_name(table, scene);
    for (const WindSpec& other : scene.winds)
        if (other.sheet == spec.sheet || other.sheet.empty() || spec.sheet.empty())
            table.report("sheet", fmt::format("a sheet is in the wind of {} already: give each wind the name "
                                              "of another sheet",
                                              other.where));
    table.finish();
    return spec;
}

}  // namespace

void read_winds(TomlTable& force, Scene& scene) {
    for (TomlTable& wind : force.tables("wind")) scene.winds.push_back(read_wind(wind, scene));
}

std::vector<GustWave> gust_waves(const GustSpec& gust, const Vector3d& wind, std::int64_t seed) {
    Random random(static_cast<unsigned>(seed));
    // Half to twice as long or slow as a typical gust.
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

void add_winds(const Scene& scene, const Sheet& mechanics, SimulationOptions& options) {
    for (const WindSpec& spec : scene.winds) {
        Wind wind = spec.wind;
        if (spec.gust) wind.gusts = gust_waves(*spec.gust, wind.velocity, scene.seed);
        for (Index t = 0; t < static_cast<Index>(mechanics.triangles.size()); ++t) {
            const Index sheet = mechanics.body[mechanics.triangles[t].vertices[0]];
            if (spec.sheet.empty() || scene.sheets[sheet].name == spec.sheet) wind.triangles.push_back(t);
        }
        options.stepper.shell.winds.push_back(wind);
    }
}

}  // namespace sherd
