// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "app/commands.h"
#include "app/recording.h"
#include "app/recording_file.h"
#include "meshops/write_mesh.h"

namespace sherd {

namespace {

namespace fs = std::filesystem;

TriangleSheet sheet_of(const Snapshot& frame) {
    TriangleSheet sheet;
    for (Eigen::Index v = 0; v < frame.position.cols(); ++v) sheet.points.push_back(frame.position.col(v));
    sheet.triangles = frame.faces;
    return sheet;
}

std::size_t fragment_count(const Snapshot& frame) {
    return frame.face_fragment.empty() ? 0 : *std::ranges::max_element(frame.face_fragment) + 1;
}

std::string fragment_name(std::size_t fragment) {
    return fmt::format("fragment_{:03}", fragment);
}

void add_groups(TriangleSheet& sheet, const Snapshot& frame) {
    sheet.group = frame.face_fragment;
    for (std::size_t i = 0; i < fragment_count(frame); ++i) sheet.group_names.push_back(fragment_name(i));
}

/// The faces of one fragment and the vertices that they use, in their order.
TriangleSheet fragment_sheet(const Snapshot& frame, Index fragment) {
    std::vector<Index> number(frame.position.cols(), -1);
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        if (frame.face_fragment[f] == fragment)
            for (const Index v : frame.faces[f]) number[v] = 0;
    TriangleSheet sheet;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] < 0) continue;
        number[v] = static_cast<Index>(sheet.points.size());
        sheet.points.push_back(frame.position.col(static_cast<Eigen::Index>(v)));
    }
    for (std::size_t f = 0; f < frame.faces.size(); ++f) {
        if (frame.face_fragment[f] != fragment) continue;
        const auto& [a, b, c] = frame.faces[f];
        sheet.triangles.push_back({number[a], number[b], number[c]});
        sheet.group.push_back(fragment);
    }
    for (Index i = 0; i <= fragment; ++i) sheet.group_names.push_back(fragment_name(i));
    return sheet;
}

/// A mesh file that is to be written.
struct Target {
    fs::path file;
    std::size_t frame = 0;
    std::optional<Index> fragment;  ///< only this one
};

std::string extension(const ExportOptions& options) {
    return "." + options.format;
}

/// Name of the output without its extension, and whether it stands for a single file.
struct Stem {
    fs::path path;
    bool single;
};

Stem output_stem(const ExportOptions& options, bool one_frame) {
    fs::path output = options.output;
    if (output.empty()) output = fs::path(options.recording).replace_extension(extension(options));
    const std::string given = output.extension().string();
    if (given == extension(options)) return {output.replace_extension(), one_frame};
    if (given == ".obj" || given == ".ply" || given == ".stl" || given == ".off")
        throw Error(fmt::format("-o {}: the extension does not fit --to {}; name a {} file or a folder",
                                output.string(), options.format, extension(options)));
    return {output / options.recording.stem(), false};
}

std::vector<Target> planned(const ExportOptions& options, const Recording& recording) {
    const std::vector<std::size_t> frames = selected_frames(options.frames, recording.frame_count());
    const Stem stem = output_stem(options, frames.size() == 1);
    std::vector<Target> targets;
    for (const std::size_t frame : frames) {
        const std::string name = stem.path.string() + (stem.single ? "" : fmt::format("_{:06}", frame));
        if (options.format != "ply" || !options.fragments) {
            targets.push_back({name + extension(options), frame, {}});
            continue;
        }
        const std::size_t count = fragment_count(recording.frame(frame));
        for (std::size_t i = 0; i < count; ++i)
            targets.push_back({fmt::format("{}_{}{}", name, fragment_name(i), extension(options)), frame,
                               static_cast<Index>(i)});
    }
    return targets;
}

/// Makes the folder of the targets when the output names one.
void prepare_folder(const ExportOptions& options, const fs::path& folder) {
    if (folder.empty() || fs::is_directory(folder)) return;
    std::error_code reason;
    // Only the folder that was asked for: a missing one above it is more likely a mistake.
    if (folder == (options.output / "file").parent_path()) fs::create_directory(folder, reason);
    if (!fs::is_directory(folder))
        throw Error(fmt::format("cannot write to the folder '{}': {}; create it first", folder.string(),
                                reason ? reason.message() : "it does not exist"));
}

TriangleSheet sheet_for(const Target& target, const Snapshot& frame, const ExportOptions& options) {
    if (target.fragment) return fragment_sheet(frame, *target.fragment);
    TriangleSheet sheet = sheet_of(frame);
    if (options.fragments || options.format == "ply") add_groups(sheet, frame);
    return sheet;
}

int print_export(const ExportOptions& options) {
    for (const fs::path& file : export_recording(options)) fmt::print("{}\n", file.string());
    return 0;
}

}  // namespace

std::vector<fs::path> export_recording(const ExportOptions& options) {
    if (options.format != "obj" && options.format != "ply")
        throw Error(fmt::format("--to {}: there is no such format; give obj or ply", options.format));
    const Recording recording(options.recording);
    const std::vector<Target> targets = planned(options, recording);
    for (const Target& target : targets) check_free(target.file, options.force);
    prepare_folder(options, targets.front().file.parent_path());
    std::vector<fs::path> written;
    std::optional<std::size_t> loaded;
    Snapshot frame;
    for (const Target& target : targets) try {
            if (loaded != target.frame) frame = recording.frame(target.frame);
            loaded = target.frame;
            write_mesh(sheet_for(target, frame, options), target.file);
            written.push_back(target.file);
        } catch (const Error& error) {
            throw Error(
                fmt::format("{}; {} of {} files are complete{}", error.what(), written.size(), targets.size(),
                            written.empty() ? "" : ", up to " + written.back().string()),
                error.fault);
        }
    return written;
}

void add_export(CLI::App& program, Command& chosen) {
    CLI::App* command = program.add_subcommand("export", "Write meshes of a run's frames");
    auto options = std::make_shared<ExportOptions>();
    command->add_option("recording", options->recording, "Recording of a run (.h5)")
        ->required()
        ->option_text("RUN.h5");
    command->add_option("--to", options->format, "Format: obj or ply")->required()->option_text("FORMAT");
    command
        ->add_option("-o,--output", options->output, "File, or folder for several (default: beside RUN.h5)")
        ->option_text("PATH");
    command
        ->add_option("--frames", options->frames,
                     "last (default), all, numbers and START:STOP:STEP as in Python, with commas between")
        ->option_text("WHICH");
    command->add_flag("--fragments", options->fragments, "One object (obj) or file (ply) for each fragment");
    command->add_flag("--force", options->force, "Replace files that exist");
    command->footer(
        "Examples:\n"
        "  sherd export plate_drop.h5 --to obj --fragments -o plate.obj\n"
        "  sherd export plate_drop.h5 --to ply --frames 0:100:10 -o frames");
    command->callback([&chosen, options] { chosen = [options] { return print_export(*options); }; });
}

}  // namespace sherd
