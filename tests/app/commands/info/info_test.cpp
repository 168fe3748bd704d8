// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/info/info.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "meshops/error.h"
#include "tests/support/program/edited_file.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {
namespace {

using Json = nlohmann::json;

Json json_of(const std::filesystem::path& file) {
    return Json::parse(run_info_json(read_run_info(file)));
}

TEST(Info, CountsWhatTheRecordingHolds) {
    const TemporaryDirectory folder;
    const SyntheticRun run = synthetic_run();
    record(run, folder.path / "run.h5");
    const Json info = json_of(folder.path / "run.h5");
    EXPECT_EQ(info["steps"], 20);
    EXPECT_EQ(info["time"], run.steps[2].back().time);
    EXPECT_EQ(info["frames"], 3);
    EXPECT_EQ(info["vertices"], 75);
    EXPECT_EQ(info["faces"], 96);
    EXPECT_EQ(info["crack_events"], 8);
    EXPECT_EQ(info["edges_opened"], 8);
    EXPECT_EQ(info["vertices_split"], 10);
    EXPECT_EQ(info["wall_seconds"], 12.5);
    EXPECT_EQ(info["end"], "complete");
    EXPECT_EQ(info["seed"], -7);
    EXPECT_EQ(info["scene_file"], "strip & \"strip\".toml");
    EXPECT_EQ(info["sheets"][0]["name"], "left \"half\"");
    EXPECT_EQ(info["sheets"][1]["faces"], 48);
}

TEST(Info, TellsTheEnergiesOfTheLastStepAndTheExtremesOfAll) {
    const TemporaryDirectory folder;
    const SyntheticRun run = synthetic_run();
    record(run, folder.path / "run.h5");
    const Json info = json_of(folder.path / "run.h5");
    const StepReport& last = run.steps[2].back();
    EXPECT_EQ(info["energy"]["kinetic"], last.kinetic);
    EXPECT_EQ(info["energy"]["bending"], last.bending);
    EXPECT_EQ(info["energy"]["membrane"], last.membrane);
    EXPECT_EQ(info["energy"]["gravity"], last.gravity);
    EXPECT_EQ(info["energy"]["contact"], last.contact);
    EXPECT_EQ(info["balance"]["work_of_supports"], last.work_of_supports);
    EXPECT_EQ(info["balance"]["lost_to_cracks"], last.lost_to_cracks);
    EXPECT_EQ(info["balance"]["lost_to_remeshing"], last.lost_to_remeshing);
    EXPECT_EQ(info["balance"]["unexplained"], last.unexplained);
    EXPECT_EQ(info["momentum"]["linear"][2], last.linear_momentum.z());
    EXPECT_EQ(info["momentum"]["angular"][0], last.angular_momentum.x());
    EXPECT_EQ(info["reactions"][1]["name"], "sheet.a/b.clamp[1]");
    EXPECT_EQ(info["reactions"][1]["kind"], "clamp");
    EXPECT_EQ(info["reactions"][1]["force"][0], last.reactions[1].force.x());
    EXPECT_EQ(info["reactions"][2]["moment"][1], last.reactions[2].moment.y());
    EXPECT_EQ(info["gauges"][0]["name"], "tip");
    EXPECT_EQ(info["gauges"][0]["displacement"][2], last.gauges[0].displacement.z());
    double moved = 0;
    for (const auto& steps : run.steps)
        for (const StepReport& step : steps) moved = std::max(moved, step.gauges[0].displacement.norm());
    EXPECT_EQ(info["gauges"][0]["largest"], moved);
    double peak = 0;
    int iterations = 0;
    for (const auto& steps : run.steps)
        for (const StepReport& step : steps) {
            peak = std::max(peak, step.peak_strain);
            iterations += step.newton_iterations;
        }
    EXPECT_EQ(info["peak_strain"], peak);
    EXPECT_NEAR(info["peak_stress"], 3e7 + 1, 0.1);
    EXPECT_NEAR(info["peak_bending_strain"], 2, 0.1);
    EXPECT_NEAR(info["peak_overload"], 1.5, 0.1);
    EXPECT_EQ(info["capped_steps"], 1) << "step 11";
    EXPECT_EQ(info["newton_iterations"], iterations);
    EXPECT_EQ(info["halvings"], 2);
    EXPECT_EQ(info["most_stages"], 3);
}

// If a recording has no energy balance, zeros would claim that nothing was lost.
TEST(Info, HasNoBalanceOfARecordingOfBeforeThereWasOne) {
    const TemporaryDirectory folder;
    record(synthetic_run(), folder.path / "run.h5");
    remove_balance(folder.path / "run.h5");
    const RunInfo read = read_run_info(folder.path / "run.h5");
    EXPECT_TRUE(Json::parse(run_info_json(read))["balance"].is_null());
    const std::string text = run_info_text(read);
    EXPECT_EQ(text.find("work "), std::string::npos) << text;
    EXPECT_EQ(text.find("lost to"), std::string::npos) << text;
    EXPECT_NE(text.find("energy "), std::string::npos) << text;
}

// With the strain of another face, or relative to another rest shape, the report would mislead its reader.
TEST(Info, TellsTheLargestMembraneStrainOfTheLastFrame) {
    const TemporaryDirectory folder;
    const auto reported = [&](const SyntheticRun& run) {
        record(run, folder.path / "run.h5");
        Json strain = json_of(folder.path / "run.h5")["membrane_strain"];
        for (const auto& file : {"run.h5", "run.xdmf"}) std::filesystem::remove(folder.path / file);
        return strain;
    };
    SyntheticRun run = synthetic_run();
    EXPECT_NEAR(reported(run)["strain"].get<double>(), 0, 1e-13) << "torn off and moved, but rigidly";
    // A sheet scaled by s in every direction has Green's strain (s^2 - 1) / 2.
    run.frames[2].position *= 1.1;
    EXPECT_NEAR(reported(run)["strain"].get<double>(), 0.105, 1e-13);
    run.frames[2].position *= 0.5 / 1.1;
    EXPECT_NEAR(reported(run)["strain"].get<double>(), -0.375, 1e-13);
    // This face has the only vertex that belongs to no other face.
    const Index face = 2 * synthetic::rows - 1;
    run.frames[2].position.col(run.frames[2].faces[face][2]).y() += 1;
    EXPECT_EQ(reported(run)["face"], face);
    run.frames[2].position.col(run.frames[2].faces[0][0]).x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(reported(run)["strain"].is_null()) << "a run that blew up has no largest strain";
}

// Users compare this stress with a strength.
TEST(Info, TellsTheLargestStressAndCurvatureOfAllFrames) {
    const TemporaryDirectory folder;
    SyntheticRun run = synthetic_run();
    add_fields(run);
    for (Snapshot& frame : run.frames)
        visit_fields(frame.fields,
                     [](const char*, Eigen::Matrix3Xd& values, const FieldMeaning&) { values.setZero(); });
    run.frames[1].fields.stress_top.col(7) << 3e6, 3e6, 4e6;
    run.frames[2].fields.stress_bottom.col(5) << -9e7, 2e6, 0;
    run.frames[2].fields.curvature.col(9) << 0, -5, 0;
    record(run, folder.path / "run.h5");
    const RunInfo read = read_run_info(folder.path / "run.h5");
    const nlohmann::json info = nlohmann::json::parse(run_info_json(read));
    EXPECT_NEAR(info["largest_stress"]["stress"], 7e6, 1e-3);
    EXPECT_EQ(info["largest_stress"]["face"], 7);
    EXPECT_EQ(info["largest_stress"]["surface"], "top");
    EXPECT_EQ(info["largest_stress"]["time"], run.frames[1].time);
    EXPECT_EQ(info["largest_curvature"]["curvature"], -5);
    EXPECT_EQ(info["largest_curvature"]["face"], 9);
    EXPECT_NE(run_info_text(read).find("stress       7e+06 Pa at most, at the top of face 7 at 0.1 s"),
              std::string::npos)
        << run_info_text(read);
    const nlohmann::json& gauge = info["gauges"][0];
    EXPECT_FALSE(gauge.contains("displacement"));
    EXPECT_EQ(gauge["stress_top"][0], run.steps.back().back().gauges[0].stress_top[0]);
    double largest = 0;
    for (const std::vector<StepReport>& steps : run.steps)
        for (const StepReport& step : steps) largest = std::max(largest, largest_stress(step.gauges[0]));
    EXPECT_EQ(gauge["largest_stress"], largest);
    EXPECT_FALSE(info["gauges"][1].contains("stress_top"));
}

TEST(Info, HasNoStressOfARecordingWithoutFields) {
    const TemporaryDirectory folder;
    record(synthetic_run(), folder.path / "run.h5");
    const RunInfo read = read_run_info(folder.path / "run.h5");
    EXPECT_TRUE(nlohmann::json::parse(run_info_json(read))["largest_stress"].is_null());
    EXPECT_EQ(run_info_text(read).find("Pa at most"), std::string::npos);
}

// A lost or repeated row of the fragment table would change the sums.
TEST(Info, FragmentsShareOutTheWholeSheet) {
    const TemporaryDirectory folder;
    const SyntheticRun run = synthetic_run();
    record(run, folder.path / "run.h5");
    const Json fragments = json_of(folder.path / "run.h5")["fragments"];
    ASSERT_EQ(fragments.size(), 3u);
    double area = 0, mass = 0, rest_area = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(fragments[i]["id"], i);
        EXPECT_EQ(fragments[i]["parent"], static_cast<int>(i) - 1)
            << "the synthetic run tears one off another";
        EXPECT_EQ(fragments[i]["faces"], i < 2 ? 24 : 48);
        area += fragments[i]["area"].get<double>();
        mass += fragments[i]["mass"].get<double>();
    }
    for (const double a : run.header.rest_area) rest_area += a;
    EXPECT_NEAR(area, rest_area, 1e-14);
    EXPECT_NEAR(mass, run.frames[2].mass.sum(), 1e-14);
    // No vertex is shared between fragments, so that a fragment has exactly the mass of its vertices.
    double first = 0;
    for (std::size_t v = 0; v < run.frames[2].original.size(); ++v) {
        const auto& faces = run.frames[2].faces;
        for (std::size_t f = 0; f < 24; ++f)
            if (std::ranges::count(faces[f], static_cast<Index>(v))) {
                first += run.frames[2].mass[static_cast<Eigen::Index>(v)];
                break;
            }
    }
    EXPECT_NEAR(fragments[0]["mass"].get<double>(), first, 1e-15);
}

TEST(Info, TellsOfARunThatHasJustBegun) {
    const TemporaryDirectory folder;
    { const RecordingWriter begun(folder.path / "run.h5", synthetic_run().header, false); }
    const Json info = json_of(folder.path / "run.h5");
    EXPECT_EQ(info["frames"], 0);
    EXPECT_EQ(info["steps"], 0);
    EXPECT_EQ(info["vertices"], 65);
    EXPECT_EQ(info["faces"], 96);
    EXPECT_EQ(info["end"], "running");
    EXPECT_TRUE(info["fragments"].empty());
    EXPECT_TRUE(info["membrane_strain"].is_null());
    EXPECT_NE(run_info_text(read_run_info(folder.path / "run.h5")).find("running"), std::string::npos);
}

// A run that diverged, or a scene name in another encoding, must still give JSON that parses.
TEST(Info, GivesValidJsonOfStrangeValues) {
    RunInfo info;
    info.last = StepReport{};
    info.last->kinetic = std::numeric_limits<double>::quiet_NaN();
    info.last->contact = std::numeric_limits<double>::infinity();
    info.scene_file = "line\nbreak\t\xff.toml";
    const Json json = Json::parse(run_info_json(info));
    EXPECT_TRUE(json["energy"]["kinetic"].is_null());
    EXPECT_TRUE(json["energy"]["contact"].is_null());
    EXPECT_EQ(json["scene_file"], "line\nbreak\t\xef\xbf\xbd.toml");
}

TEST(Info, ListsTheLargestFragmentsForPeople) {
    const TemporaryDirectory folder;
    record(synthetic_run(), folder.path / "run.h5");
    RunInfo info = read_run_info(folder.path / "run.h5");
    const std::string text = run_info_text(info);
    for (const char* word : {"complete", "20 steps", "3 frames", "75 vertices", "8 edges failed", "kinetic",
                             "membrane     strain"})
        EXPECT_NE(text.find(word), std::string::npos) << word << " is not in\n" << text;
    for (Index i = 3; i < 50; ++i)
        info.fragments.push_back({.id = i, .parent = 0, .faces = 1, .area = 1e-6 * i, .mass = 1e-6});
    EXPECT_NE(run_info_text(info).find("and 30 smaller ones"), std::string::npos);
}

TEST(Info, RefusesWhatIsNoRecording) {
    const TemporaryDirectory folder;
    EXPECT_THROW(read_run_info(folder.path / "missing.h5"), Error);
    EXPECT_THROW(read_run_info(folder.write("text.h5", "text")), Error);
    SyntheticRun run = synthetic_run();
    run.header.sheet_names.pop_back();
    record(run, folder.path / "nameless.h5");
    EXPECT_THROW(read_run_info(folder.path / "nameless.h5"), Error);
    for (const bool shorter : {true, false}) {
        const std::filesystem::path file = folder.path / (shorter ? "short.h5" : "astray.h5");
        record(synthetic_run(), file);
        std::vector<std::array<Index, 3>> faces = run.header.rest_faces;
        shorter ? faces.pop_back() : void(faces[5][1] = 1000000);
        const hdf5::Handle opened = open_to_edit(file);
        hdf5::remove(opened, "rest/faces");
        hdf5::write<std::array<Index, 3>>(opened, "rest/faces", faces, {});
    }
    EXPECT_THROW(read_run_info(folder.path / "short.h5"), Error);
    EXPECT_THROW(read_run_info(folder.path / "astray.h5"), Error);
}

}  // namespace
}  // namespace sherd::test
