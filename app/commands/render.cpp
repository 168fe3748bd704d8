// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/render.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "app/commands/commands.h"
#include "app/commands/slow_motion_options.h"
#include "app/export/export.h"
#include "app/files/disk/pending_file.h"
#include "app/messages/counted.h"
#include "app/messages/print.h"
#include "app/playback/playback.h"
#include "app/progress/interruption.h"
#include "app/progress/progress.h"
#include "app/recording/recording.h"
#include "app/render/legend/colour_bar.h"
#include "app/render/render_stage.h"
#include "app/render/trace/render_film.h"
#include "app/render/trace/render_picture.h"
#include "meshops/error.h"
#include "meshops/read_write/text_line.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

/// Returns the two numbers of a text; none if the text is not two numbers in this format. format: for
/// sscanf(), with %n at the end.
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
    constexpr int largest = 16384, most_samples = 65536, most_threads = 1024;
    const auto size = parse_pair<int>(options.size, "%dx%d%n");
    if (!size || size->first < 1 || size->second < 1 || size->first > largest || size->second > largest)
        throw Error(fmt::format("--size {}: give WIDTHxHEIGHT in pixels, each 1 to {}, such as 960x540",
                                options.size, largest));
    if (options.samples < 1 || options.samples > most_samples)
        throw Error(fmt::format("--samples {}: must be 1 to {}", options.samples, most_samples));
    if (options.threads < 0 || options.threads > most_threads)
        throw Error(fmt::format("--threads {}: must be 0 (as many as the processor runs at once) to {}",
                                options.threads, most_threads));
    return {size->first, size->second, options.samples, options.threads};
}

StageOptions stage_options(const RenderOptions& options, const PictureOptions& picture) {
    StageOptions stage;
    stage.colour = parse_render_colour(options.colour, render_colours);
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
    if (!is_scalar(stage.colour))
        throw Error(fmt::format("--range {}: needs --color {}", options.range, colour_names(scalar_colours)));
    return stage;
}

/// Whether the output is the file of a single picture; otherwise it is a folder.
bool is_single(const RenderOptions& options) {
    return lower_case(options.output.extension().string()) == ".png";
}

/// The files of the pictures; none if only a film is wanted. Pictures of frames are numbered as the frames.
/// Pictures of a film are numbered from 0, and have another name, with `_film`.
std::vector<fs::path> planned_files(const RenderOptions& options, const std::vector<PlaybackTime>& moments) {
    if (options.output.empty()) {
        if (options.film.empty()) throw Error("nothing to draw into: give -o PATH, or --film FILE.mp4");
        return {};
    }
    if (is_single(options)) {
        if (moments.size() == 1) return {options.output};
        throw Error(fmt::format("-o {}: {} pictures are wanted; name a folder", options.output.string(),
                                moments.size()));
    }
    std::vector<fs::path> files;
    const std::string name = options.recording.stem().string() + (options.film.empty() ? "" : "_film");
    for (std::size_t i = 0; i < moments.size(); ++i)
        files.push_back(options.output /
                        fmt::format("{}_{:06}.png", name, options.film.empty() ? moments[i].earlier : i));
    return files;
}

/// The moments to draw: the chosen frames or, for a film, moments at equal intervals from the first to the
/// last chosen frame. Sets `pace` to the speed of the film, in words.
std::vector<PlaybackTime> planned_moments(const RenderOptions& options, const Recording& recording,
                                          std::string& pace) {
    const bool film = !options.film.empty();
    const std::string& wanted = !options.frames.empty() ? options.frames : film ? "all" : "last";
    const std::vector<std::size_t> frames = selected_frames(wanted, recording.frame_count());
    std::vector<double> times;
    for (const std::size_t frame : frames) times.push_back(recording.time(frame));
    if (!film) return recorded_times(frames, times);
    const Pace chosen = pace_of(options.slow, times.back() - times.front());
    std::vector<PlaybackTime> moments = even_times(frames, times, chosen.step());
    if (frames.size() > 1) pace = fmt::format("{}, {}", chosen.words(), counted(moments.size(), "picture"));
    return moments;
}

void check_pace(const RenderOptions& options) {
    check_slow_motion(options.slow);
    if (options.film.empty() && (options.slow.factor || options.slow.rate))
        throw Error(fmt::format("{} needs --film", options.slow.factor ? "--slow" : "--rate"));
}

/// The path that is locked while pictures are drawn: the file of a single picture, or the common name of all
/// files without a number.
fs::path whole_output(const RenderOptions& options) {
    if (is_single(options)) return options.output;
    return options.output / fmt::format("{}.png", options.recording.stem().string());
}

void write_whole(const fs::path& file, const std::string& bytes, const OutputLock& lock, bool force) {
    PendingFile pending(file, Fault::run, lock);
    pending.write(bytes);
    pending.publish(force);
}

/// Draws a colour bar, and a caption with the time, into a picture that shows a scalar, if there is room.
void annotate(Image& image, const RenderStage& stage, const Snapshot& frame, const RenderOptions& options) {
    const std::optional<ColourBar> bar = stage.colour_bar();
    if (!bar || options.plain || !fits_colour_bar(image.width, image.height)) return;
    draw_colour_bar(image, *bar);
    draw_caption(image, stage.caption(frame));
}

/// Draws all pictures, in sequence.
void draw_all(const Recording& recording, const RenderStage& stage, const std::vector<PlaybackTime>& moments,
              const std::vector<fs::path>& files, const RenderOptions& options, const OutputLock* lock,
              RenderFilm* film, Rendering& result) {
    const PictureOptions picture = picture_options(options);
    Playback sheets([&recording](std::size_t number) { return recording.frame(number); });
    const ObstaclePlayback obstacles(recording);
    Progress progress(static_cast<double>(moments.size()));
    if (moments.size() > 1) progress.show(0, fmt::format("picture 0 of {}", moments.size()));
    for (std::size_t i = 0; i < moments.size(); ++i) {
        const Snapshot frame = sheets.at(moments[i]);
        std::optional<Image> image =
            render_picture(stage.scene(frame, obstacles.at(moments[i]), obstacles.shapes(moments[i])),
                           stage.camera(), picture, interrupted);
        if (!image) {
            result.interrupted = true;
            break;
        }
        annotate(*image, stage, frame, options);
        const std::string bytes = png_bytes(*image);
        if (!files.empty()) {
            write_whole(files[i], bytes, *lock, options.force);
            result.files.push_back(files[i]);
        }
        if (film) film->add(bytes);
        if (moments.size() > 1)
            progress.show(static_cast<double>(i + 1), fmt::format("picture {} of {}", i + 1, moments.size()));
    }
    if (moments.size() > 1) progress.finish();
}

int print_rendering(const RenderOptions& options) {
    watch_for_interruption();
    const Rendering rendering = render_recording(options);
    for (const fs::path& file : rendering.files) print_result("{}\n", file.string());
    if (!rendering.legend.empty()) print_result("{}\n", rendering.legend);
    if (rendering.interrupted)
        print_message("sherd: interrupted; {} pictures are complete{}\n", rendering.files.size(),
                      options.film.empty() ? "" : ", the film is not");
    return rendering.interrupted ? interruption_exit_code() : 0;
}

}  // namespace

Rendering render_recording(const RenderOptions& options) {
    const PictureOptions picture = picture_options(options);
    const StageOptions wanted = stage_options(options, picture);
    check_pace(options);
    require_kind(options.output, ".png",
                 "pictures are PNG; name a .png file or a folder, or pass --film FILE.mp4 for a film");
    const Recording recording(options.recording);
    std::string pace;
    const std::vector<PlaybackTime> moments = planned_moments(options, recording, pace);
    const std::vector<fs::path> files = planned_files(options, moments);
    for (const fs::path& file : files) check_free(file, options.force, {options.recording});
    if (!options.film.empty()) check_free(options.film, options.force, {options.recording});
    std::vector<std::string> warnings;
    const RenderStage stage(recording, wanted, warnings);
    if (stage.colour_bar() && !options.plain && !fits_colour_bar(picture.width, picture.height))
        warnings.push_back(
            fmt::format("--size {}: the pictures are too small for a colour bar and a caption, which are "
                        "left out",
                        options.size));
    print_warnings(warnings);
    if (!pace.empty()) print_message("sherd: {}\n", pace);
    std::optional<OutputLock> lock;
    if (!files.empty()) {
        make_folder(files.front().parent_path());
        lock.emplace(whole_output(options));
    }
    std::optional<RenderFilm> film;
    if (!options.film.empty()) film.emplace(options.film, options.slow.rate.value_or(default_rate));
    Rendering result;
    result.legend = stage.legend();
    try {
        draw_all(recording, stage, moments, files, options, lock ? &*lock : nullptr, film ? &*film : nullptr,
                 result);
        if (!film || result.interrupted) return result;
        film->publish(options.force);
        result.files.push_back(options.film);
    } catch (const Error& error) {
        if (files.empty()) throw;
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
    option("-o,--output", options->output,
           "Folder for the pictures, or a .png file for one picture; not needed with --film", "PATH");
    option("--frames", options->frames,
           "Frames: last (default), all (default for a film), or numbers and START:STOP:STEP as in Python",
           "WHICH");
    option("--color", options->colour, "Quantity that colours show (default: fragment)",
           "fragment|strain|speed|stress|curvature|axis|tips|material|none");
    option("--range", options->range,
           "Range of the colours for strain, curvature (1/m), speed (m/s), stress (Pa) or tips (1); default: "
           "that of the recording",
           "LOW:HIGH");
    option("--size", options->size, "Size in pixels (default 960x540)", "WxH");
    option("--samples", options->samples, "Samples per pixel; more give less noise (default 32)", "N");
    option("--camera", options->camera,
           "View: AZIMUTH,ELEVATION[,ZOOM] in degrees (default 20,28), or eye and target X,Y,Z,X,Y,Z[,ANGLE] "
           "in m",
           "WHERE");
    option("--ground", options->ground,
           "Ground: auto (default), the scene's planes or one below everything; or none", "auto|none");
    option("--film", options->film,
           "Make a slow-motion film, with pictures interpolated between frames (.mp4, needs ffmpeg)",
           "FILE.mp4");
    add_slow_motion_options(*command, options->slow, "Pictures per second of the film (default 24)");
    option("--threads", options->threads,
           "Number of threads (default: as many as the processor runs at once)", "N");
    command->add_flag("--plain", options->plain, "Leave out the colour bar and the caption");
    command->add_flag("--force", options->force, "Replace files that exist");
    command->footer(
        "Examples:\n"
        "  sherd render plate_drop.h5 -o plate.png\n"
        "  sherd render plate_drop.h5 -o pictures --frames all --color strain\n"
        "  sherd render plate_drop.h5 --film plate.mp4 --slow 500");
    command->callback([&chosen, options] { chosen = [options] { return print_rendering(*options); }; });
}

}  // namespace sherd
