// SPDX-License-Identifier: GPL-3.0-or-later
// Reactions, weight and loads must balance every change of momentum, in each step and with any support,
// motion, contact and fracture.
#include <gtest/gtest.h>

#include "app/scene/assemble/sheet/supports.h"
#include "tests/support/program/built_text.h"

namespace sherd::test {
namespace {

// Scene of a plate with 0 <= x <= 2 and 0 <= y <= 1, m, and a mass of 10 kg.
const std::string held_plate = R"(duration = 100
[sheet.plate]
mesh = { generate = "rectangle", width = 2, height = 1, edge_length = 0.25 }
material = { density = 1000, thickness = 0.005, young = 1e9, poisson = 0.3 }
)";
constexpr double weight = 98.1;

class Motion {
  public:
    explicit Motion(const std::string& text) {
        auto [read, built] = built_from(text);
        scene = std::move(read);
        names = support_names(scene);
        simulation = std::make_unique<Simulation>(std::move(built.sheets), built.options);
    }

    StepReport steps(int count) {
        StepReport report;
        for (int i = 0; i < count; ++i) report = simulation->step();
        return report;
    }
    const Shell& shell() const { return simulation->shell().mechanics(); }

    /// Makes a step. Returns by how much mass times acceleration differs from reactions, weight and a load:
    /// force and moment (m), both divided by the weight. load_per_mass: N/kg, on all vertices.
    std::pair<double, double> imbalance(const Vector3d& load_per_mass = Vector3d::Zero()) {
        Positions before = shell().velocity;
        const StepReport report = simulation->step();
        const CrackEvents events = simulation->take_events();
        cracks += events.failures.size();
        before.conservativeResize(Eigen::NoChange, shell().velocity.cols());
        for (const VertexSplit& split : events.splits) before.col(split.created) = before.col(split.vertex);
        Reaction all;
        for (const Reaction& reaction : report.reactions) {
            all.force += reaction.force;
            all.moment += reaction.moment;
        }
        double scale = 0;
        for (Eigen::Index v = 0; v < shell().mass.size(); ++v) {
            const Vector3d acceleration = (shell().velocity.col(v) - before.col(v)) / report.step_size;
            const Vector3d missing = scene.simulation.stepper.gravity + load_per_mass - acceleration;
            all.add(shell().position.col(v), shell().mass[v] * missing);
            scale += shell().mass[v] * scene.simulation.stepper.gravity.norm();
        }
        return {all.force.norm() / scale, all.moment.norm() / scale};
    }

    Scene scene;
    std::vector<SupportName> names;
    std::unique_ptr<Simulation> simulation;
    std::size_t cracks = 0;
};

TEST(Reaction, OfAPlateOnBearingsIsItsWeight) {
    Motion run(held_plate + R"(pin = [
    { box = [[-1, -1, -1], [1e-6, 2, 1]], free = ["x", "y"] },
    { box = [[1.999, -1, -1], [3, 2, 1]], free = ["x"] },
    { box = [[-1e-6, -1, -1], [1e-6, 1e-6, 1]] } ]
[force]
gravity = [0, 0, -0.0981]  # so little that it stays flat
[solver]
step = 1  # far beyond the slowest period, which takes the vibration out
)");
    const double little = weight / 100;  // N
    const StepReport report = run.steps(40);
    ASSERT_EQ(report.reactions.size(), 3u);
    EXPECT_EQ(run.names[1].name, "sheet.plate.pin[1]");
    EXPECT_EQ(run.names[1].kind, "pin");
    Vector3d force = Vector3d::Zero(), moment = force;
    for (const Reaction& reaction : report.reactions) {
        force += reaction.force;
        moment += reaction.moment;
    }
    EXPECT_LT((force - Vector3d(0, 0, little)).norm(), 1e-5 * little) << force;
    const Vector3d centre = run.shell().position * run.shell().mass / run.shell().mass.sum();
    EXPECT_LT((moment - centre.cross(Vector3d(0, 0, little))).norm(), 1e-5 * little) << moment;
    EXPECT_EQ(report.reactions[0].force.head<2>(), Vector2d(0, 0)) << "it is free there";
    EXPECT_EQ(report.reactions[1].force.x(), 0);
    EXPECT_NEAR(report.reactions[1].force.z(), little / 2, 0.01 * little);
    // The corner is in two pins: its force along z counts for the first of them, which holds this direction.
    EXPECT_EQ(report.reactions[2].force.z(), 0);
}

// A clamp bears a moment, which pins alone do not; a symmetry plane bears the moment of the other half.
class ReactionWith : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Bending, ReactionWith, testing::Values("cubic", "coupled"));

TEST_P(ReactionWith, ClampsAndPlanesBearMoments) {
    Motion run(held_plate + R"(clamp = { box = [[-1, -1, -1], [1e-6, 2, 1]] }
symmetry = { point = [2, 0, 0], normal = [1, 0, 0] }
[solver]
step = 1  # far beyond the slowest period, which takes the vibration out
bending = ")" + GetParam() +
               R"("
[force]
gravity = [0, 0, -1e-3]
)");
    const StepReport report = run.steps(40);
    ASSERT_EQ(report.reactions.size(), 2u);
    const double load = 10 * 1e-3;  // N
    EXPECT_NEAR(report.reactions[0].force.z(), load, 1e-5 * load);
    EXPECT_NEAR(report.reactions[1].force.z(), 0, 1e-9 * load);
    // The plate is half of a beam, 4 m long and clamped at both ends: the moment is q l^2 / 12 at the clamp
    // and q l^2 / 24 in the middle, within the error of plain hinges, or of the width of the plate.
    const double error = (GetParam() == "cubic" ? 0.15 : 0.03) * load;
    EXPECT_NEAR(report.reactions[0].moment.y(), -load / 2 * 16 / 12, error);
    EXPECT_NEAR(report.reactions[1].moment.y(), -load / 2 * 16 / 24, error);
    EXPECT_NEAR(report.reactions[0].moment.y() + report.reactions[1].moment.y(), -load, 1e-4 * load);
}

class ReactionOf : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Membrane, ReactionOf, testing::Values("constant-strain", "arc"));

TEST_P(ReactionOf, EveryStepBalances) {
    Motion run(held_plate + R"(pin = { box = [[-1, -1, -1], [1e-6, 0.3, 1]], free = ["y"] }
clamp = { box = [[1.999, -1, -1], [3, 0.6, 1]], keys = [
    { time = 0 }, { time = 0.1, translate = [0.01, 0, 0.05], rotate = { axis = [1, 2, 0], degrees = 20 } } ] }
symmetry = [{ point = [0, 1, 0], normal = [0, 1, 0] }, { point = [0, 0, 0], normal = [1, 0, 0] }]
velocity = [0, 0, 0.1]
[force]
gravity = [1, 2, -9.81]
load = { area = [0, 0, 50] }
[solver]
step = 5e-3
tolerance = 1e-10
membrane = ")" +
               GetParam() + "\"\n");
    for (int i = 0; i < 20; ++i) {
        const auto [force, moment] = run.imbalance({0, 0, 50 / 5.0});
        EXPECT_LT(force, 1e-9) << i;
        EXPECT_LT(moment, 1e-9) << i;
    }
}

// Copies of a held vertex must be held, too, and fragments that fall off must not keep a reaction.
TEST(BreakingReaction, BalancesWhileTheSheetBreaks) {
    for (const std::string rule : {"staged", "paper"}) {
        Motion run(held_plate + R"(pin = [{ boundary = true }]
fracture = { strain = 0.01 }
[contact]
sheets = false
[solver]
step = 1e-2
tolerance = 1e-10
rule = ")" + rule + "\"\n");
        for (int i = 0; i < 20; ++i) {
            const auto [force, moment] = run.imbalance();
            EXPECT_LT(force, 1e-9) << rule << i;
            EXPECT_LT(moment, 1e-9) << rule << i;
        }
        EXPECT_GT(run.cracks, 10u) << "nothing broke: the test proves nothing";
    }
}

TEST(Reaction, OfAnObstacleIsTheWeightOfWhatRestsOnIt) {
    const std::string floor = "[obstacle.floor]\nfriction = 0.3\nplane = { point = [0, 0, -0.0026] }\n";
    const std::string table =
        "[obstacle.table]\nfriction = 0.3\nbox = { size = [1, 0.6, 1], centre = [1, 0.5, -0.503] }\n";
    const std::string solver = "[solver]\nstep = 1e-2\ndamping = { mass = 5 }\n";
    for (const std::string& obstacle : {floor, table}) {
        Motion run(held_plate + obstacle + solver);
        const StepReport report = run.steps(200);
        ASSERT_EQ(report.reactions.size(), 1u);
        EXPECT_LT((report.reactions[0].force - Vector3d(0, 0, weight)).norm(), 1e-3 * weight)
            << obstacle << report.reactions[0].force;
        EXPECT_LT((report.reactions[0].moment - Vector3d(0.5 * weight, -weight, 0)).norm(), 1e-2 * weight)
            << obstacle << report.reactions[0].moment;
    }
    Motion ball(held_plate + "pin = { boundary = true }\n[obstacle.floor]\nplane = { point = [0, 0, -1] }\n" +
                "[obstacle.ball]\nsphere = { radius = 0.1, centre = [3, 3, -0.9] }\nmass = 2\n" + solver);
    const StepReport report = ball.steps(50);
    ASSERT_EQ(report.reactions.size(), 2u) << "a pin and a floor; a free body is neither";
    EXPECT_EQ(ball.names[1].name, "obstacle.floor");
    const double of_ball = 2 * 9.81;
    EXPECT_LT((report.reactions[1].force - Vector3d(0, 0, of_ball)).norm(), 1e-6 * of_ball);
    EXPECT_LT((report.reactions[1].moment - Vector3d(3 * of_ball, -3 * of_ball, 0)).norm(), 1e-6 * of_ball);
}

}  // namespace
}  // namespace sherd::test
