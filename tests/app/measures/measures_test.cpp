// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "meshops/error.h"
#include "tests/support/program/contains.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {
namespace {

Measures measured(const SyntheticRun& run, double over = 0) {
    const TemporaryDirectory folder;
    record(run, folder.path / "run.h5");
    const Recording recording(folder.path / "run.h5");
    return measures_of(recording, over);
}

TEST(Measures, HaveTheFragmentsByMassAndWhatIsLeftOut) {
    const SyntheticRun run = synthetic_run();
    const Measures all = measured(run);
    ASSERT_EQ(all.fragments.size(), 3u);
    EXPECT_EQ(all.fragments_below, 0u);
    double mass = 0;
    for (const MeasuredFragment& fragment : all.fragments) mass += fragment.info.mass;
    EXPECT_NEAR(mass, run.frames.back().mass.sum(), 1e-15);
    EXPECT_GE(all.fragments[0].info.mass, all.fragments[1].info.mass);
    EXPECT_EQ(all.mass_law->count, 2u);  // the law begins at the lightest fragment, which does not count

    const double lightest = all.fragments[2].info.mass;
    const Measures fewer = measured(run, lightest);
    EXPECT_EQ(fewer.fragments.size(), 2u);
    EXPECT_EQ(fewer.fragments_below, 1u);
    EXPECT_EQ(fewer.mass_below, lightest);
    EXPECT_NEAR(fewer.mass_law->exponent, all.mass_law->exponent, 1e-12);
    EXPECT_EQ(measured(run, 1).fragments_below, 3u);
}

TEST(Measures, CountTheLengthOfAllThatBroke) {
    const SyntheticRun run = synthetic_run();
    const Snapshot& last = run.frames.back();
    const Positions rest = synthetic::whole_positions();
    double length = 0;
    for (const Index tear : {1, 2})
        for (Index y = 0; y < synthetic::rows; ++y) {
            const Index corner = tear * synthetic::columns_per_fragment * (synthetic::rows + 1) + y;
            length += (rest.col(corner + 1) - rest.col(corner)).norm();
        }
    for (std::size_t e = 0; e < last.edges.size(); ++e)
        if (last.edge_state[e] == EdgeState::fractured_interior)
            length += (rest.col(last.original[last.edges[e][0]]) - rest.col(last.original[last.edges[e][1]]))
                          .norm();
    EXPECT_NEAR(measured(run).cracks.length, length, 1e-12);
}

TEST(Measures, TellWhatBrokeFirstAndTheLargestForces) {
    SyntheticRun run = synthetic_run();
    EdgeFailure& most = run.events[1].failures[2];
    most.stage = 0, most.overload = 1e9, most.vertices = {7, 12};
    const Measures measures = measured(run);
    ASSERT_TRUE(measures.first_crack);
    EXPECT_EQ(measures.first_crack->time, 0.25);
    const Positions rest = synthetic::whole_positions();
    EXPECT_LT((measures.first_crack->position - (rest.col(7) + rest.col(12)) / 2).norm(), 1e-15);

    ASSERT_EQ(measures.peak_forces.size(), 3u);
    EXPECT_EQ(measures.peak_forces[2].support.name, "obstacle.floor");
    for (std::size_t i = 0; i < 3; ++i) {
        double largest = 0, time = 0;
        for (const auto& steps : run.steps)
            for (const StepReport& step : steps)
                if (step.reactions[i].force.norm() > largest)
                    largest = step.reactions[i].force.norm(), time = step.time;
        EXPECT_EQ(measures.peak_forces[i].force, largest);
        EXPECT_EQ(measures.peak_forces[i].time, time);
    }
}

// The force at which a plate fractures is that of the step before the first crack: afterwards the plate bears
// less.
TEST(Measures, HaveTheForcesOfAllStepsAndBeforeTheFirstCrack) {
    SyntheticRun run = synthetic_run();
    for (std::size_t k = 1; k < run.events.size(); ++k)
        for (EdgeFailure& failure : run.events[k].failures) failure.step = 10 * static_cast<Index>(k);
    const Measures measures = measured(run);
    ASSERT_EQ(measures.times.size(), 20u);
    EXPECT_EQ(measures.times[3], run.steps[1][3].time);
    ASSERT_EQ(measures.first_crack->forces.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_EQ(measures.peak_forces[i].history.size(), 20u);
        EXPECT_EQ(measures.peak_forces[i].history[12], run.steps[2][2].reactions[i].force.norm());
        EXPECT_EQ(measures.first_crack->forces[i], run.steps[1][8].reactions[i].force.norm());
    }
    run.header.time_unit = "load";
    EXPECT_FALSE(measured(run).tip_speeds);
}

// Cracks must be counted about the point that an obstacle touches first, or about a given point: about
// another point their numbers differ.
TEST(Measures, CountCracksAboutWhatIsSaid) {
    const TemporaryDirectory folder;
    SyntheticRun run = synthetic_run();
    run.steps[1][0].contacts = 0, run.steps[1][1].contacts = 0;
    const GridSurface surface{{{0, 0, 0}, {1e-5, 0, 0}, {0, 1e-5, 0}}, {{0, 1, 2}}};
    const std::vector<RecordedObstacle> obstacles{{"ball", surface, false}};
    const auto pose = [](double height) {
        Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        pose.translation() << 0.1, 0.03, height;
        return std::vector{pose};
    };
    {
        RecordingWriter writer(folder.path / "run.h5", run.header, false, obstacles);
        for (std::size_t k = 0; k < run.frames.size(); ++k)
            writer.append(run.frames[k], run.steps[k], run.events[k], pose(0.005 * (3.0 - 2.0 * k)));
        writer.finish(1, "complete");
    }
    const Recording recording(folder.path / "run.h5");
    const Positions rest = synthetic::whole_positions();
    const Vector3d touched = measures_of(recording, 0, {.obstacle = "ball"}).about->point;
    EXPECT_LT((touched - rest.col(10 * (synthetic::rows + 1) + 3)).norm(), 1e-15);
    EXPECT_EQ(measures_of(recording, 0, {.obstacle = "obstacle.ball"}).about->point, touched);
    EXPECT_THROW(measures_of(recording, 0, {.obstacle = "bell"}), Error);
    const Measures given = measures_of(recording, 0, {.point = Vector3d(1, 2, 3), .radii = {0.04}});
    EXPECT_EQ(given.about->point, Vector3d(1, 2, 3));
    EXPECT_EQ(given.about->circles.size(), 1u);
    const Measures first = measures_of(recording, 0);
    EXPECT_EQ(first.about->point, first.first_crack->position);
}

TEST(Measures, AreOneObjectForScriptsWithNullForWhatIsNotThere) {
    const Measures nothing;
    const nlohmann::json json = nlohmann::json::parse(measures_json(nothing));
    EXPECT_TRUE(json["mass_law"].is_null() && json["first_crack"].is_null() &&
                json["energy_per_area"].is_null() && json["median_mass"].is_null());
    const nlohmann::json all = nlohmann::json::parse(measures_json(measured(synthetic_run())));
    EXPECT_EQ(all["fragments"].size(), 3u);
    EXPECT_EQ(all["median_mass"], all["fragments"][1]["mass"]);
    EXPECT_EQ(all["mass_law"]["interval"].size(), 2u);
    EXPECT_EQ(all["peak_forces"][0]["kind"], "pin");
    EXPECT_EQ(all["peak_forces"][0]["history"].size(), all["times"].size());
    EXPECT_EQ(all["about"]["circles"].size(), 7u);
    EXPECT_EQ(all["directions"]["histogram"].size(), 12u);
    EXPECT_TRUE(all["energies"].contains("lost_to_cracks"));
    EXPECT_TRUE(json["tip_speeds"].is_null() && json["about"].is_null() && json["tortuosity"].is_null());
    const std::string text = measures_text(measured(synthetic_run()), "s");
    EXPECT_TRUE(contains(text, "fragments    3 heavier than 0 kg")) << text;
    EXPECT_TRUE(contains(text, "median_mass  ")) << "a measure of all_measures() that no row has: " << text;
}

TEST(Measures, RefuseARecordingWithoutAFrame) {
    SyntheticRun run = synthetic_run();
    run.frames.clear(), run.steps.clear(), run.events.clear();
    EXPECT_THROW(measured(run), Error);
}

}  // namespace
}  // namespace sherd::test
