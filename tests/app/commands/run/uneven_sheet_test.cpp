// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets of uneven thickness, run by the whole program and compared with beam theory.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "app/recording/recording.h"
#include "meshops/mesh_measures.h"
#include "meshops/read_write/read_mesh.h"
#include "meshops/solid/body_check.h"
#include "tests/support/mesh/vdb_file.h"
#include "tests/support/program/built_text.h"
#include "tests/support/program/program.h"

namespace sherd::test {
namespace {

using Profile = std::function<double(double)>;  ///< m or N m, as a function of x, m

constexpr double length = 1, width = 0.1, young = 1e9, density = 1000;

double taper(double x) {
    return 0.02 - 0.012 * x;
}

class UnevenBeam : public testing::Test {
  protected:
    /// Scene of a strip along x with this thickness; clamped() clamps it at x = 0.
    std::string beam(const Profile& thickness, double edge_length = 0.025) {
        const auto value = [&](double x, double, double) { return thickness(x); };
        write_vdb(directory.path / "t.vdb",
                  {vdb_grid("t", 0.005, {{-2, -2, -1}, {202, 22, 1}}, 1.0f, value)});
        return fmt::format(R"(
[sheet.beam]
mesh = {{ generate = "rectangle", width = {}, height = {}, edge_length = {} }}
material = {{ density = {}, young = {}, poisson = 0, thickness = {{ vdb = "{}" }} }}
)",
                           length, width, edge_length, density, young, (directory.path / "t.vdb").string());
    }
    static std::string clamped() {
        return "clamp = { box = [[-1, -1, -1], [1e-6, 1, 1]] }\n[[gauge]]\nname = \"tip\"\nat = [1, 0.05, "
               "0]\n";
    }
    TemporaryDirectory directory;
};

/// Deflection of the tip, m, of a beam by Euler and Bernoulli with moment(x), N m, integrated by Simpson's
/// rule.
double deflection(const Profile& thickness, const Profile& moment) {
    constexpr int parts = 1000;
    double sum = 0;
    for (int i = 0; i <= parts; ++i) {
        const double x = length * i / parts, rigidity = young * width * std::pow(thickness(x), 3) / 12;
        sum += (i == 0 || i == parts ? 1 : 2 + 2 * (i % 2)) * moment(x) * (length - x) / rigidity;
    }
    return sum * length / parts / 3;
}

struct BeamCase {
    const char* bending;
    double tolerance;
};

class TaperedBeam : public UnevenBeam, public testing::WithParamInterface<BeamCase> {
  protected:
    /// Deflection of the tip in z, m, under gravity and the loads of the scene text `load`.
    double computed(const Profile& thickness, const std::string& load) {
        const auto run = simulation_of(
            beam(thickness) + clamped() + load +
            fmt::format("[solver]\nscheme = \"static\"\nstep = 1\nbending = \"{}\"\n", GetParam().bending));
        return run->step().gauges[0].displacement.z();
    }
    /// Compares the deflection of the tapered beam with theory, and more strictly its ratio to that of an
    /// even beam, since the paper's hinges have the same relative error for both.
    void expect_theory(const std::string& load, double of_taper, double of_even) {
        const double found = computed(taper, load);
        EXPECT_NEAR(found, of_taper, GetParam().tolerance * std::abs(of_taper));
        EXPECT_NEAR(found / computed(even, load), of_taper / of_even, 0.02 * of_taper / of_even);
    }
    static double even(double) { return 0.014; }
};
INSTANTIATE_TEST_SUITE_P(Models, TaperedBeam,
                         testing::Values(BeamCase{"coupled", 0.003}, BeamCase{"cubic", 0.25}),
                         [](const auto& input) { return input.param.bending; });

// A beam of the mean thickness would bend one and a half times as much.
TEST_P(TaperedBeam, BendsUnderALoadAtItsTip) {
    const double force = 0.01;
    const auto moment = [&](double x) { return force * (length - x); };
    expect_theory(
        fmt::format("[[force.load]]\nline = [0, 0, {}]\nbox = [[0.9999, -1, -1], [2, 1, 1]]\n[force]\n"
                    "gravity = [0, 0, 0]\n",
                    force / width),
        deflection(taper, moment), deflection(even, moment));
}

TEST_P(TaperedBeam, BendsUnderItsOwnWeight) {
    const double gravity = 1e-3;
    const auto of_weight = [&](const Profile& thickness) {
        return deflection(thickness, [&](double x) {  // moment of the weight beyond x
            double sum = 0;
            constexpr int parts = 200;
            for (int i = 0; i < parts; ++i) {
                const double at = x + (length - x) * (i + 0.5) / parts;
                sum -= density * gravity * width * thickness(at) * (at - x) * (length - x) / parts;
            }
            return sum;
        });
    };
    expect_theory(fmt::format("[force]\ngravity = [0, 0, {}]\n", -gravity), of_weight(taper),
                  of_weight(even));
}

/// Thickness, m: thin for 0.06 m at a quarter of the length, where the moment is not the largest.
double notched(double x) {
    return std::abs(x - 0.25) < 0.03 ? 0.005 : 0.01;
}

// With a threshold of stress and with a threshold of strain, the beam must break at its thin place, where
// both are largest.
TEST_F(UnevenBeam, BreaksWhereItIsThin) {
    for (const char* fracture : {"strength = 1e6", "strain = 0.5"}) {
        const auto run = simulation_of(beam(notched) + clamped() +
                                       fmt::format(R"([sheet.beam.fracture]
{}
[[force.load]]
line = [0, 0, 1]
box = [[0.9999, -1, -1], [2, 1, 1]]
[force]
gravity = [0, 0, 0]
[solver]
scheme = "static"
load = 100
step = 0.5
until_crack = true
)",
                                                   fracture));
        while (!run->arrived()) run->step();
        const CrackEvents events = run->take_events();
        ASSERT_FALSE(events.failures.empty()) << fracture;
        for (const EdgeFailure& failure : events.failures)
            for (const Index v : failure.vertices)
                EXPECT_NEAR(run->shell().mechanics().rest(0, v), 0.25, 0.06) << fracture;
    }
}

// A recording, and all exports of it, must have the sheet's thickness at each place.
TEST_F(UnevenBeam, IsRecordedAndExportedAsThickAsItIs) {
    directory.write("beam.toml", "duration = 2e-4\n" + beam(taper));
    const ProgramResult run = run_sherd({"run", "beam.toml"}, directory.path);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Snapshot frame = Recording(directory.path / "beam.h5").frame(0);
    for (std::size_t f = 0; f < frame.rest.faces.size(); ++f) {
        const double x = columns(frame.rest.position, frame.rest.faces[f]).row(0).mean();
        EXPECT_NEAR(frame.rest.thickness[f], taper(x), 1e-8);
    }
    const ProgramResult exported = run_sherd(
        {"export", "beam.h5", "--to", "ply", "--solid", "--frames", "0", "-o", "body.ply"}, directory.path);
    ASSERT_EQ(exported.exit_code, 0) << exported.err;
    std::vector<std::string> warnings;
    const TriangleSheet body = triangle_sheet(read_mesh(directory.path / "body.ply", {}, warnings));
    const double volume = length * width * taper(0.5);
    EXPECT_NEAR(check_body(body).volume, volume, 1e-3 * volume);
    for (const auto& point : body.points) EXPECT_NEAR(std::abs(point.z()), 0.5 * taper(point.x()), 0.3e-3);
    ASSERT_EQ(
        run_sherd({"export", "beam.h5", "--to", "vdb", "--frames", "0", "-o", "body.vdb"}, directory.path)
            .exit_code,
        0);
    openvdb::io::File file((directory.path / "body.vdb").string());
    file.open();
    const auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid("surface"));
    for (const double x : {0.1, 0.5, 0.9})
        EXPECT_NEAR(grid->tree().getValue(grid->transform().worldToIndexCellCentered({x, 0.05, 0})),
                    -0.5 * taper(x), 0.2e-3)
            << x;
    EXPECT_EQ(run_sherd({"view", "beam.h5", "-o", "beam.html"}, directory.path).exit_code, 0);
}

class BreakingUnevenBeam : public UnevenBeam {};

// Where cracks cut the mesh, new triangles of a different stiffness would change the energy.
TEST_F(BreakingUnevenBeam, AccountsForTheEnergyOfCracksThatCutTheMesh) {
    const auto run = simulation_of("duration = 1\n" + beam(taper) + R"([sheet.beam.fracture]
strength = 1e6
toughness = 2e4
[obstacle.ball]
sphere = { radius = 0.02, centre = [0.5, 0.03, 0.028] }
density = 8000
young = 1e9
velocity = [0, 0, -10]
[solver]
scheme = "explicit"
step = 5e-6
)");
    std::size_t opened = 0;
    double largest = 0;
    for (int i = 0; i < 300; ++i) {
        const StepReport report = run->step();
        largest = std::max({largest, report.kinetic, report.bending});
        opened += run->take_events().openings.size();
        ASSERT_LT(std::abs(report.unexplained), 1e-9 * largest) << i;
    }
    EXPECT_GT(opened, 3u);
    const Shell& shell = run->shell().mechanics();
    EXPECT_NEAR(shell.mass.sum(), density * length * width * taper(0.5), 1e-6);
    for (Index v = 0; v < static_cast<Index>(shell.rest.cols()); ++v)
        EXPECT_NEAR(shell.thickness[v], taper(shell.rest(0, v)), 1e-7);
}

// The thick end of the beam overlaps the floor, while its thin end is above it.
TEST_F(UnevenBeam, StartsWhereHalfItsThicknessLetsIt) {
    const std::string text = "duration = 2e-4\n" + beam(taper) +
                             "place = { translate = [0, 0, 0.007] }\n[obstacle.floor]\nplane = {}\n";
    directory.write("beam.toml", text);
    const ProgramResult result = run_sherd({"check", "beam.toml", "--no-try"}, directory.path);
    EXPECT_NE(result.out.find("is 0.003 m beyond touching"), std::string::npos) << result.out;
    std::vector<std::string> warnings;
    const Scene scene = read_scene(directory.path / "beam.toml");
    const BuiltScene built = build_scene(scene, warnings);
    int inside = 0;
    const Shell& shell = built.sheets.mechanics();
    for (Index v = 0; v < static_cast<Index>(shell.rest.cols()); ++v)
        inside += (0.5 - 1e-3) * taper(shell.rest(0, v)) > 0.007;
    EXPECT_NE(result.out.find(
                  fmt::format("{} of {} vertices of sheet.beam start inside", inside, shell.rest.cols())),
              std::string::npos)
        << result.out;
}

}  // namespace
}  // namespace sherd::test
