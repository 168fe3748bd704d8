// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/render.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>

#include "app/files/picture/image.h"
#include "app/render/render_stage.h"
#include "meshops/error.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

const std::string two_sheets = R"(duration = 0.3
[sheet.left]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.01 }
material = { preset = "stoneware", thickness = 0.004 }
[sheet.right]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.01 }
material = { preset = "stoneware", thickness = 0.004 }
)";

std::string bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Test that draws a recording of the synthetic run in small pictures.
class Render : public ::testing::Test {
  protected:
    Render() : run(synthetic_run()) {
        run.header.scene_text = two_sheets;
        record(run, folder.path / "run.h5");
    }

    RenderOptions options(const std::string& output) const {
        RenderOptions options;
        options.recording = folder.path / "run.h5";
        options.output = folder.path / output;
        options.size = "96x54";
        options.samples = 5;
        return options;
    }

    std::string error_of(const RenderOptions& options) const {
        try {
            render_recording(options);
        } catch (const Error& error) {
            EXPECT_EQ(error.fault, Fault::input) << error.what();
            return error.what();
        }
        ADD_FAILURE() << "no error";
        return "";
    }

    TemporaryDirectory folder;
    SyntheticRun run;
};

// A picture that depended on the distribution of work among threads could not be compared with an earlier
// one.
TEST_F(Render, GivesTheSameBytesOnAnyNumberOfThreads) {
    std::string first;
    for (const int threads : {1, 2, 7}) {
        RenderOptions wanted = options("picture.png");
        wanted.threads = threads;
        wanted.force = true;
        render_recording(wanted);
        const std::string bytes = bytes_of(folder.path / "picture.png");
        ASSERT_GT(bytes.size(), 500u);
        if (first.empty()) first = bytes;
        EXPECT_EQ(bytes, first) << threads << " threads";
    }
}

// The picture must show three fragments, a ground and shadows, instead of a single colour.
TEST_F(Render, ShowsEveryFragmentInItsColour) {
    RenderOptions wanted = options("picture.png");
    wanted.samples = 16;
    render_recording(wanted);
    const Image image = read_png(folder.path / "picture.png");
    ASSERT_EQ(image.width, 96);
    ASSERT_EQ(image.height, 54);
    int blue = 0, orange = 0, green = 0;
    for (Eigen::Index i = 0; i < image.colours.cols(); ++i) {
        const Eigen::Vector3f c = image.colours.col(i);
        blue += c.z() > c.x() + 0.15f && c.z() > c.y() + 0.05f;
        orange += c.x() > c.y() + 0.1f && c.y() > c.z() + 0.15f;
        green += c.y() > c.x() + 0.15f && c.y() > c.z() + 0.05f;
    }
    EXPECT_GT(blue, 30);
    EXPECT_GT(orange, 30);
    EXPECT_GT(green, 30);
    EXPECT_LT(blue + orange + green, 96 * 54 / 2) << "there is ground around them";
}

// Some programs write extensions in capitals. Such a name once made a folder.
TEST_F(Render, TakesTheExtensionInCapitals) {
    render_recording(options("picture.PNG"));
    EXPECT_TRUE(fs::is_regular_file(folder.path / "picture.PNG"));
}

TEST_F(Render, NumbersPicturesByFrameAndTellsTheirRange) {
    RenderOptions wanted = options("pictures");
    wanted.frames = "0,2";
    wanted.colour = "speed";
    const Rendering rendering = render_recording(wanted);
    const fs::path expected = folder.path / "pictures";
    EXPECT_EQ(rendering.files,
              (std::vector<fs::path>{expected / "run_000000.png", expected / "run_000002.png"}));
    EXPECT_TRUE(rendering.legend.starts_with("speed: 0 m/s")) << rendering.legend;
    EXPECT_NE(bytes_of(rendering.files[0]), bytes_of(rendering.files[1]));
    wanted.range = "0.5:2";
    wanted.force = true;
    EXPECT_TRUE(render_recording(wanted).legend.starts_with("speed: 0.5 m/s"));
}

TEST_F(Render, KeepsFilesThatExistUnlessForced) {
    folder.write("picture.png", "the only copy");
    const auto before = folder.contents();
    EXPECT_NE(error_of(options("picture.png")).find("--force"), std::string::npos);
    EXPECT_EQ(folder.contents(), before);
    folder.write("film.mp4", "the only copy");
    RenderOptions film = options("other.png");
    film.frames = "last";
    film.film = folder.path / "film.mp4";
    EXPECT_NE(error_of(film).find("film.mp4"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder.path / "other.png"));
}

TEST_F(Render, RefusesWhatItCannotDrawBeforeItWritesAnything) {
    const auto before = folder.contents();
    const auto refused = [&](auto RenderOptions::*member, const auto& value, const std::string& word) {
        RenderOptions wanted = options("picture.png");
        wanted.*member = value;
        EXPECT_NE(error_of(wanted).find(word), std::string::npos) << word;
    };
    for (const std::string size : {"960", "0x5", "960x", "axb", "960x540x3", "-5x5", "20000x5"})
        refused(&RenderOptions::size, size, "--size " + size);
    for (const std::string camera :
         {"", "1", "1,x", "1,2,3,4", "0,95", "0,0,0", "1,2,3,1,2,3", "1,2,3,4,5,6,0"})
        refused(&RenderOptions::camera, camera, "--camera " + camera);
    for (const std::string frames : {"3", "x", "5:9"})
        refused(&RenderOptions::frames, frames, "--frames " + frames);
    refused(&RenderOptions::colour, std::string("red"), "--color red");
    refused(&RenderOptions::ground, std::string("grass"), "--ground grass");
    refused(&RenderOptions::range, std::string("2:1"), "--range 2:1");
    refused(&RenderOptions::range, std::string("1:2"), "--range 1:2: needs --color strain");
    refused(&RenderOptions::samples, 0, "--samples 0");
    refused(&RenderOptions::threads, -1, "--threads -1");
    refused(&RenderOptions::frames, std::string("all"), "name a folder");
    refused(&RenderOptions::output, folder.path / "no" / "such" / "folder", "such/folder");
    // Such a name once made a folder, with a picture of another format in it.
    for (const std::string name : {"x.jpg", "x.JPEG", "x.gif", "x.tiff", "x.svg", "x.mp4", "x.webm", "x.avi"})
        refused(&RenderOptions::output, folder.path / name, name + ": pictures are PNG");
    refused(&RenderOptions::film, folder.path / "film.mp4", "97 pictures are wanted");
    refused(&RenderOptions::slow, SlowMotion{2, {}}, "--slow needs --film");
    refused(&RenderOptions::slow, SlowMotion{{}, 30}, "--rate needs --film");
    refused(&RenderOptions::slow, SlowMotion{-2, {}}, "--slow -2");
    refused(&RenderOptions::recording, folder.path / "missing.h5", "missing.h5");
    RenderOptions film = options("");
    film.output.clear();
    EXPECT_NE(error_of(film).find("-o PATH, or --film"), std::string::npos);
    film.film = folder.path / "film.avi";
    EXPECT_NE(error_of(film).find("must end with .mp4"), std::string::npos);
    EXPECT_EQ(folder.contents(), before);
}

/// Output of ffprobe for a film: pictures per second, and number of pictures.
std::string probed(const fs::path& film) {
    const std::string command =
        "ffprobe -v error -select_streams v -show_entries "
        "stream=r_frame_rate,nb_frames -of csv=p=0 '" +
        film.string() + "'";
    std::string text;
    FILE* pipe = popen(command.c_str(), "r");
    for (int c = std::fgetc(pipe); c != EOF && c != '\n'; c = std::fgetc(pipe)) text += static_cast<char>(c);
    EXPECT_EQ(pclose(pipe), 0);
    return text;
}

// A film with a few pictures only, or one that a player cannot open, would be worse than none.
TEST_F(Render, MakesAFilmInSlowMotion) {
    RenderOptions wanted = options("pictures");
    wanted.film = folder.path / "film.mp4";
    wanted.slow = {10, 4};
    const Rendering rendering = render_recording(wanted);
    ASSERT_EQ(rendering.files.size(), 10u) << "2 s at 4 pictures a second, the last one, and the film";
    EXPECT_EQ(rendering.files.back(), wanted.film);
    EXPECT_FALSE(fs::exists(folder.path / "film.mp4.part"));
    EXPECT_EQ(probed(wanted.film), "4/1,9");
    // The film has four pictures from frame to frame. Pictures at the time of a frame must show this frame,
    // and no two pictures may be the same.
    RenderOptions stills = options("stills");
    stills.frames = "all";
    const std::vector<fs::path> frames = render_recording(stills).files;
    ASSERT_EQ(frames.size(), 3u);
    std::set<std::string> different;
    for (std::size_t i = 0; i < 9; ++i) {
        different.insert(bytes_of(rendering.files[i]));
        if (i % 4 == 0) {
            EXPECT_EQ(bytes_of(rendering.files[i]), bytes_of(frames[i / 4])) << i;
        }
    }
    EXPECT_EQ(different.size(), 9u);
    EXPECT_EQ(rendering.files[3], folder.path / "pictures" / "run_film_000003.png");
}

TEST_F(Render, MakesAFilmAlone) {
    const ProgramResult result = run_sherd(
        {"render", "run.h5", "--film", "film.mp4", "--size", "32x18", "--samples", "1"}, folder.path);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "film.mp4\n");
    EXPECT_NE(result.err.find("20 times slower than reality: 0.2 s last 4 s, 97 pictures"), std::string::npos)
        << result.err;
    EXPECT_EQ(probed(folder.path / "film.mp4"), "24/1,97");
    EXPECT_EQ(run_sherd({"render", "run.h5"}, folder.path).exit_code, 2) << "nowhere to draw";
}

// If the disk is full at the end of a film, which then has no header, ffmpeg reports no failure.
TEST_F(Render, AFullDiskLeavesNoFilm) {
    ProgramLimits limits;
    limits.file_bytes = 4000;
    const ProgramResult result = run_sherd(
        {"render", "run.h5", "--film", "film.mp4", "--size", "64x36", "--samples", "1"}, folder.path, limits);
    EXPECT_EQ(result.exit_code, 1) << result.err;
    EXPECT_FALSE(fs::exists(folder.path / "film.mp4"));
    EXPECT_FALSE(fs::exists(folder.path / "film.mp4.part"));
}

TEST_F(Render, SaysThatFfmpegIsMissing) {
    const std::string path = getenv("PATH");
    setenv("PATH", folder.path.c_str(), 1);
    const ProgramResult result = run_sherd(
        {"render", "run.h5", "-o", "pictures", "--size", "16x9", "--film", "film.mp4"}, folder.path);
    setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("ffmpeg is not installed"), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(folder.path / "film.mp4"));
    EXPECT_FALSE(fs::exists(folder.path / "film.mp4.part"));
}

// After Ctrl-C in the middle of a film, files that exist must be complete, and no temporary files may remain.
TEST_F(Render, LeavesWholePicturesWhenInterrupted) {
    std::vector<std::string> words{SHERD_PROGRAM, "render", "run.h5",    "-o",  "pictures",
                                   "--frames",    "all",    "--samples", "120", "--film",
                                   "film.mp4",    "--size", "400x300"};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        if (chdir(folder.path.c_str()) == 0) execv(arguments[0], arguments.data());
        _exit(127);
    }
    const fs::path first = folder.path / "pictures" / "run_film_000000.png";
    for (int i = 0; i < 6000 && !fs::exists(first); ++i) usleep(10'000);
    kill(child, SIGINT);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_EQ(read_png(first).width, 400);
    for (const auto& entry : fs::directory_iterator(folder.path / "pictures")) {
        EXPECT_EQ(entry.path().extension(), ".png") << entry.path();
        EXPECT_EQ(read_png(entry.path()).height, 300);
    }
    EXPECT_FALSE(fs::exists(folder.path / "film.mp4")) << "a film of some pictures only";
    EXPECT_FALSE(fs::exists(folder.path / "film.mp4.part"));
}

// The frame in which a run diverged is the one that its user needs to see.
TEST_F(Render, DrawsWhatIsLeftOfARunThatBlewUp) {
    run.frames[2].position(0, 3) = std::numeric_limits<double>::quiet_NaN();
    run.frames[2].position(2, 9) = std::numeric_limits<double>::infinity();
    record(run, folder.path / "blown.h5");
    RenderOptions wanted = options("picture.png");
    wanted.recording = folder.path / "blown.h5";
    render_recording(wanted);
    const Image image = read_png(folder.path / "picture.png");
    EXPECT_TRUE(image.colours.allFinite());
    EXPECT_GT((image.colours.rowwise().maxCoeff() - image.colours.rowwise().minCoeff()).minCoeff(), 0.2f);
}

// If a sheet were drawn with the thickness that it had before --set, the picture would be wrong.
TEST_F(Render, TakesTheSceneAsItWasRun) {
    run.header.scene_text += "# --set sheet.left.material.thickness=0.007\n# --set seed=3\n";
    const Scene scene = recorded_scene(run.header);
    EXPECT_EQ(scene.sheets[0].material.thickness, 0.007);
    EXPECT_EQ(scene.sheets[1].material.thickness, 0.004);
    EXPECT_EQ(scene.seed, 3);
    run.header.scene_text =
        std::string(two_sheets) +
        "[[variant]]\nname = \"thin\"\nsheet.left.material.thickness = 0.002\n# --variant thin\n";
    EXPECT_EQ(recorded_scene(run.header).sheets[0].material.thickness, 0.002);
}

TEST_F(Render, DrawsARecordingWhoseSceneItCannotRead) {
    run.header.scene_text = "duration = ";
    record(run, folder.path / "strange.h5");
    const ProgramResult result =
        run_sherd({"render", "strange.h5", "-o", "picture.png", "--size", "16x9"}, folder.path);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.err.find("warning: the scene in the recording cannot be read"), std::string::npos);
    EXPECT_EQ(read_png(folder.path / "picture.png").width, 16);
    EXPECT_EQ(run_sherd({"render", "strange.h5", "-o", "axis.png", "--color", "axis"}, folder.path).exit_code,
              2);
}

}  // namespace
}  // namespace sherd::test
