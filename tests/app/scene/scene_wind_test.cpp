// SPDX-License-Identifier: GPL-3.0-or-later
// Wind of a scene must have the given values, act on the given sheet, and be the same every time.
#include <gtest/gtest.h>

#include <cmath>

#include "app/scene/assemble/built_scene.h"
#include "app/scene/assemble/winds.h"
#include "app/scene/read/scene.h"
#include "meshops/error.h"
#include "tests/support/program/message_thrown_by.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

// Scene of two flags of 0.2 m x 0.1 m, one above the other.
const std::string flags = R"(duration = 0.1
seed = 7
[sheet.lower]
mesh = { generate = "rectangle", width = 0.2, height = 0.1, edge_length = 0.025 }
material = { preset = "cotton" }
pin = { box = [[-1e-6, -1, -1], [1e-6, 2, 1]] }
[sheet.upper]
mesh = { generate = "rectangle", width = 0.2, height = 0.1, edge_length = 0.025 }
material = { preset = "cotton" }
place.translate = [0, 0, 0.5]
[solver]
step = 2e-3
)";
const std::string gusty = flags + R"([force.wind]
velocity = [5, 0, 0]
gust = { amplitude = 2, time = 0.3, length = 0.5 }
)";

SimulationOptions prepare(const std::string& text, std::vector<SheetInput>& inputs) {
    const TemporaryDirectory directory;
    const Scene scene = read_scene(directory.write("scene.toml", text));
    std::vector<std::string> warnings;
    const BuiltScene built = build_scene(scene, warnings);
    inputs = built.inputs;
    return built.options;
}

std::string wind_message(const std::string& text) {
    std::vector<SheetInput> inputs;
    return message_thrown_by([&] { prepare(text, inputs); });
}

TEST(SceneWind, EveryKeyArrives) {
    std::vector<SheetInput> inputs;
    const std::vector<Wind> winds = prepare(flags + R"([[force.wind]]
velocity = [1, 2, 3]
ramp = 0.5
density = 1000
drag = 1
lift = 2
friction = 3
sheet = "upper"
[[force.wind]]
sheet = "lower"
gust = { amplitude = 2, time = 0.3, length = 0.5 }
)",
                                            inputs)
                                        .stepper.shell.winds;
    ASSERT_EQ(winds.size(), 2u);
    EXPECT_EQ(winds[0].velocity, Vector3d(1, 2, 3));
    EXPECT_EQ(winds[0].ramp, 0.5);
    EXPECT_EQ(winds[0].density, 1000);
    EXPECT_EQ(winds[0].drag, 1);
    EXPECT_EQ(winds[0].lift, 2);
    EXPECT_EQ(winds[0].friction, 3);
    EXPECT_TRUE(winds[0].gusts.empty());
    const auto lower = static_cast<Index>(inputs[0].mesh.number_of_faces());
    EXPECT_EQ(winds[0].triangles.front(), lower) << "the upper flag's first face";
    EXPECT_EQ(winds[0].triangles.size(), inputs[1].mesh.number_of_faces());
    EXPECT_EQ(winds[1].triangles.back(), lower - 1);
    EXPECT_EQ(winds[1].velocity, Vector3d(0, 0, 0)) << "air that rests";
    EXPECT_EQ(winds[1].density, 1.225);
    EXPECT_FALSE(winds[1].gusts.empty());
}

TEST(SceneWind, MistakesAreNamed) {
    const auto says = [](const std::string& keys, const std::string& wanted) {
        const std::string message = wind_message(flags + keys);
        EXPECT_NE(message.find(wanted), std::string::npos) << message;
    };
    says("[force.wind]\ndensity = 0\n",
         "scene.toml:14: force.wind.density: must be a positive number (kg/m^3)");
    says("[force.wind]\nspeed = 3\n", "scene.toml:14: force.wind.speed: unknown key");
    says("[force.wind]\nsheet = \"middle\"\n", "force.wind.sheet: names no sheet of this scene");
    says("[force.wind]\ngust = { amplitude = 1, time = 1 }\n", "force.wind.gust.length: is missing");
    says("[[force.wind]]\nsheet = \"upper\"\n[[force.wind]]\ndrag = 2\n",
         "force.wind[1].sheet: a sheet is in the wind of");
}

// Users see the size and the rate of gusts, which must be as given. The sums are over many places, times and
// seeds.
TEST(SceneWind, GustsHaveTheSizeTheLengthAndThePaceThatAreGiven) {
    const GustSpec gust{2, 0.3, 0.5};
    const auto wind = [&](std::int64_t seed) {
        Wind result;
        result.velocity = {5, 0, 0};
        result.gusts = gust_waves(gust, result.velocity, seed);
        return result;
    };
    double square = 0, nearby = 0, carried = 0, slope = 0;
    int count = 0;
    for (std::int64_t seed = 1; seed <= 100; ++seed) {
        const Wind air = wind(seed);
        const auto gust_at = [&](const Vector3d& place, double time) {
            return Vector3d(air.at(place, time) - air.velocity);
        };
        for (int i = 0; i < 20; ++i, ++count) {
            const Vector3d place(0.37 * i, 0.11 * i, -0.2 * i);
            const double time = 0.13 * i, way = 0.02, delay = 0.012;
            const Vector3d here = gust_at(place, time);
            square += here.squaredNorm();
            nearby += (gust_at(place + Vector3d(way, 0, 0), time) - here).squaredNorm();
            carried += (gust_at(place + delay * air.velocity, time + delay) - here).squaredNorm();
            const double d = 1e-4;
            double divergence = 0;
            for (int k = 0; k < 3; ++k)
                divergence += (gust_at(place + d * Vector3d::Unit(k), time) - here)[k] / d;
            slope = std::max(slope, std::abs(divergence));
        }
    }
    const auto rms = [&](double sum) { return std::sqrt(sum / count); };
    EXPECT_NEAR(rms(square), 2, 0.1);
    // A wave of length l changes by 2 pi s / l over a distance s along it. The factor is the mean over
    // directions and octaves.
    const double wavelengths = 2 * std::acos(-1) / std::sqrt(3.0) * 1.18;
    EXPECT_NEAR(rms(nearby), 2 * wavelengths * 0.02 / 0.5, 0.1) << "over a twenty-fifth of the length";
    EXPECT_NEAR(rms(carried), 2 * 2 * std::acos(-1) * 1.16 * 0.012 / 0.3, 0.1)
        << "a twenty-fifth of the time";
    EXPECT_LT(slope, 0.2) << "the air is squeezed: 2 m/s in 0.5 m would be up to 25";
}

TEST(SceneWind, TheSameSeedGivesTheSameBitsAndAnotherOneOthers) {
    const auto positions = [](std::int64_t seed) {
        std::vector<SheetInput> inputs;  // made with the scene's seed, so that only the air differs
        SimulationOptions options = prepare(gusty, inputs);
        if (seed != 7) options.stepper.shell.winds[0].gusts = gust_waves({2, 0.3, 0.5}, {5, 0, 0}, seed);
        Simulation simulation(inputs, options);
        for (int i = 0; i < 10; ++i) simulation.step();
        return Positions(simulation.shell().mechanics().position);
    };
    const Positions once = positions(7);
    EXPECT_EQ(once, positions(7));
    EXPECT_GT((positions(8) - once).cwiseAbs().maxCoeff(), 1e-5);
    EXPECT_EQ(positions(8), positions(8));
}

// The free flag must move with the wind, and the pinned flag stream out behind its pole.
TEST(SceneWind, BlowsFlags) {
    std::vector<SheetInput> inputs;
    const SimulationOptions options = prepare(
        flags + "[force]\ngravity = [0, 0, 0]\nwind = { velocity = [0, 0, 4], ramp = 0.01 }\n", inputs);
    Simulation simulation(inputs, options);
    for (int i = 0; i < 50; ++i) simulation.step();
    const Shell& sheet = simulation.shell().mechanics();
    const auto lower = static_cast<Index>(inputs[0].mesh.number_of_vertices());
    EXPECT_GT(sheet.velocity.rightCols(sheet.velocity.cols() - lower).row(2).minCoeff(), 2);
    EXPECT_LT(sheet.velocity.row(2).maxCoeff(), 4.5);
    EXPECT_GT(sheet.position.leftCols(lower).row(2).maxCoeff(), 0.1);
    EXPECT_EQ(sheet.position.leftCols(lower).row(2).minCoeff(), 0);
}

}  // namespace
}  // namespace sherd::test
