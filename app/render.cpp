// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "app/commands.h"
#include "app/export/export.h"
#include "app/interruption.h"
#include "app/progress/progress.h"
#include "app/recording/recording.h"
#include "app/recording/recording_file.h"
#include "app/render/render_film.h"
#include "app/render/render_picture.h"
#include "app/render/render_stage.h"
#include "meshops/error.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

/// Two numbers with `separator` between, nothing else.
template <class Number>
std::optional<std::pair<Number, Number>> parse_pair(const std::string& text, const char* format) {
    std::pair<Number, Number> pair;
    int used = 0;
    if (std::sscanf(text.c_str(), format, &pair.first, &pair.second, &used) != 2 ||
        used != static_cast<int>(text.size()))
        return std::nullopt;
    return pair;
}

PictureOptions picture_options(const RenderOptions& options) {
    constexpr int largest = 16384, most_samples = 65536;
    const auto size = parse_pair<int>(options.size, "%dx%d%n");
    if (!size || size->first < 1 || size->second < 1 || size->first > largest || size->second > largest)
        throw Error(fmt::format("--size {}: give WIDTHxHEIGHT in pixels, each 1 to {}, such as 960x540",
                                options.size, largest));
    if (options.samples < 1 || options.samples > most_samples)
        throw Error(fmt::format("--samples {}: must be 1 to {}", options.samples, most_samples));
    if (options.threads < 0) throw Error(fmt::format("--threads {}: must be 0 or more", options.threads));
    return {size->first, size->second, options.samples, options.threads};
}

StageOptions stage_options(const RenderOptions& options, const PictureOptions& picture) {
    StageOptions stage;
    stage.colour = parse_render_colour(options.colour);
    stage.camera = parse_camera(options.camera);
    stage.aspect = static_cast<double>(picture.width) / picture.height;
    if (options.ground != "auto" && options.ground != "none")
        throw Error(fmt::format("--ground {}: give auto or none", options.ground));
    stage.ground = options.ground == "auto";
    if (options.range.empty()) return stage;
    stage.range = parse_pair<double>(options.range, "%lf:%lf%n");
    if (!stage.range || !(stage.range->first < stage.range->second) || !std::isfinite(stage.range->first) ||
        !std::isfinite(stage.range->second))
        throw Error(fmt::format("--range {}: give LOW:HIGH, two numbers, the smaller first", options.range));
    if (stage.colour != RenderColour::strain && stage.colour != RenderColour::speed)
        throw Error(fmt::format("--range {}: goes with --color strain or speed only", options.range));
    return stage;
}

std::vector<fs::path> planned_files(const RenderOptions& options, const std::vector<std::size_t>& frames) {
    if (options.output.extension() == ".png") {
        if (frames.size() == 1) return {options.output};
        throw Error(fmt::format("-o {}: {} pictures are wanted; name a folder", options.output.string(),
                                frames.size()));
    }
    std::vector<fs::path> files;
    for (const std::size_t frame : frames)
        files.push_back(options.output /
                        fmt::format("{}_{:06}.png", options.recording.stem().string(), frame));
    return files;
}

/// What is locked while pictures are drawn: the one, or the name that all have without their number.
fs::path whole_output(const RenderOptions& options) {
    if (options.output.extension() == ".png") return options.output;
    return options.output / fmt::format("{}.png", options.recording.stem().string());
}

void write_whole(const fs::path& file, const std::string& bytes, const OutputLock& lock, bool force) {
    PendingFile pending(file, Fault::run, lock);
    pending.write(bytes);
    pending.publish(force);
}

/// Draws the pictures one after the other.
void draw_all(const Recording& recording, const RenderStage& stage, const std::vector<std::size_t>& frames,
              const std::vector<fs::path>& files, const RenderOptions& options, const OutputLock& lock,
              RenderFilm* film, Rendering& result) {
    const PictureOptions picture = picture_options(options);
    Progress progress(static_cast<double>(frames.size()));
    if (frames.size() > 1) progress.show(0, fmt::format("picture 0 of {}", frames.size()));
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const std::optional<Image> image =
            render_picture(stage.scene(recording.frame(frames[i]), recording.poses(frames[i])),
                           stage.camera(), picture, interrupted);
        if (!image) {
            result.interrupted = true;
            break;
        }
        const std::string bytes = png_bytes(*image);
        write_whole(files[i], bytes, lock, options.force);
        result.files.push_back(files[i]);
        if (film) film->add(bytes);
        if (frames.size() > 1)
            progress.show(static_cast<double>(i + 1), fmt::format("picture {} of {}", i + 1, frames.size()));
    }
    if (frames.size() > 1) progress.finish();
}

int print_rendering(const RenderOptions& options) {
    watch_for_interruption();
    const Rendering rendering = render_recording(options);
    for (const fs::path& file : rendering.files) fmt::print("{}\n", file.string());
    if (!rendering.legend.empty()) fmt::print("{}\n", rendering.legend);
    if (rendering.interrupted)
        fmt::print(stderr, "sherd: interrupted; {} pictures are complete\n", rendering.files.size());
    return rendering.interrupted ? 1 : 0;
}

}  // namespace

Rendering render_recording(const RenderOptions& options) {
    const PictureOptions picture = picture_options(options);
    const StageOptions wanted = stage_options(options, picture);
    const Recording recording(options.recording);
    const std::vector<std::size_t> frames = selected_frames(options.frames, recording.frame_count());
    const std::vector<fs::path> files = planned_files(options, frames);
    for (const fs::path& file : files) check_free(file, options.force);
    if (!options.film.empty()) check_free(options.film, options.force);
    std::vector<std::string> warnings;
    const RenderStage stage(recording, wanted, warnings);
    for (const std::string& warning : warnings) fmt::print(stderr, "sherd: warning: {}\n", warning);
    make_folder(files.front().parent_path());
    const OutputLock lock(whole_output(options));
    std::optional<RenderFilm> film;
    if (!options.film.empty()) film.emplace(options.film, options.rate);
    Rendering result;
    result.legend = stage.legend();
    try {
        draw_all(recording, stage, frames, files, options, lock, film ? &*film : nullptr, result);
        if (!film || result.interrupted) return result;
        film->publish(options.force);
        result.files.push_back(options.film);
    } catch (const Error& error) {
        throw Error(
            fmt::format("{}; {} of {} pictures are complete{}", error.what(), result.files.size(),
                        files.size(), result.files.empty() ? "" : ", up to " + result.files.back().string()),
            error.fault);
    }
    return result;
}

void add_render(CLI::App& program, Command& chosen) {
    CLI::App* command = program.add_subcommand("render", "Draw pictures of a run, without a display");
    auto options = std::make_shared<RenderOptions>();
    const auto option = [command](const char* name, auto& value, const char* words, const char* what) {
        return command->add_option(name, value, words)->option_text(what);
    };
    option("recording", options->recording, "Recording of a run (.h5)", "RUN.h5")->required();
    option("-o,--output", options->output, "Folder for the pictures, or for one picture a .png", "PATH")
        ->required();
    option("--frames", options->frames, "last (default), all, numbers and START:STOP:STEP as in Python",
           "WHICH");
    option("--color", options->colour, "fragment (default), strain, speed, axis or none", "WHAT");
    option("--range", options->range, "Of strain (1/m) or speed (m/s); default: all of the recording",
           "LOW:HIGH");
    option("--size", options->size, "Pixels (default 960x540)", "WxH");
    option("--samples", options->samples, "Of each pixel: more have less grain (default 32)", "N");
    option("--camera", options->camera,
           "AZIMUTH,ELEVATION[,ZOOM] in degrees (default 20,28), or eye and target X,Y,Z,X,Y,Z[,ANGLE] in m",
           "WHERE");
    option("--ground", options->ground, "auto (default): the scene's planes, or one below everything; none",
           "WHICH");
    option("--film", options->film, "Make a film of the pictures, too (.mp4, needs ffmpeg)", "FILE.mp4");
    option("--rate", options->rate, "Pictures a second of the film (default 25)", "R")
        ->check(CLI::Range(0.1, 1000.0));
    option("--threads", options->threads, "Default: as many as the processor runs at once", "N");
    command->add_flag("--force", options->force, "Replace files that exist");
    command->footer(
        "Examples:\n"
        "  sherd render plate_drop.h5 -o plate.png\n"
        "  sherd render plate_drop.h5 -o pictures --frames all --film plate.mp4 --color strain");
    command->callback([&chosen, options] { chosen = [options] { return print_rendering(*options); }; });
}

}  // namespace sherd
