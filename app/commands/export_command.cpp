// SPDX-License-Identifier: GPL-3.0-or-later

#include <memory>

#include "app/commands/commands.h"
#include "app/commands/slow_motion_options.h"
#include "app/export/export_formats.h"
#include "app/messages/print.h"
#include "app/progress/interruption.h"
#include "meshops/error.h"

namespace sherd {

namespace {

void print_report(const ExportReport& report) {
    print_warnings(report.warnings);
    if (!report.pace.empty()) print_message("sherd: {}\n", report.pace);
    for (const std::filesystem::path& file : report.files) print_result("{}\n", file.string());
}

int print_export(const ExportOptions& options) {
    watch_for_interruption();
    try {
        print_report(export_recording(options));
        return 0;
    } catch (const Error& error) {
        if (!interrupted()) throw;
        print_message("sherd: {}\n", error.what());
        return interruption_exit_code();
    }
}

/// Names of all formats, as "obj|ply|...".
std::string format_words() {
    std::string words = export_format_names();
    for (std::size_t at = words.find(", "); at != std::string::npos; at = words.find(", "))
        words.replace(at, 2, "|");
    return words;
}

void add_form_options(CLI::App& command, ExportOptions& options) {
    command.add_flag("--fragments", options.fragments,
                     "One object (obj) or file (ply, stl) for each fragment; glb always has a node for each");
    command.add_flag("--sheets-only", options.sheets_only, "Without obstacles and free bodies");
    command.add_flag("--solid", options.solid,
                     "Closed bodies of the sheets' thickness, one per fragment (obj, ply, stl, pc2, mdd, "
                     "glb); vdb always has the thickness");
    command.add_option("--thickness", options.thickness, "Thickness in m, instead of the recording's")
        ->option_text("T");
    command
        .add_option(
            "--quality", options.quality,
            "Main scalar of ply: strain (default; 1/m, largest of a face's edges), speed, fragment, or the "
            "largest stress (Pa) or curvature (1/m)")
        ->option_text("strain|speed|fragment|stress|curvature");
    command
        .add_option("--animate", options.animate,
                    "Motion of the fragments in glb: rigid (default) or morph (with changes of shape)")
        ->option_text("rigid|morph");
    command
        .add_option("--voxel", options.voxel,
                    "Edge length of the voxels of vdb in m (default: a quarter of the thickness)")
        ->option_text("SIZE");
    add_slow_motion_options(command, options.slow, "Samples per second of pc2 and mdd (default 24)");
}

}  // namespace

void add_export(CLI::App& program, Command& chosen) {
    CLI::App* command = program.add_subcommand("export", "Write meshes of a run's frames");
    auto options = std::make_shared<ExportOptions>();
    command->add_option("recording", options->recording, "Recording of a run (.h5)")
        ->required()
        ->option_text("RUN.h5");
    command->add_option("--to", options->format, "Format of the files")
        ->required()
        ->option_text(format_words());
    command
        ->add_option("-o,--output", options->output, "File, or folder for several (default: beside RUN.h5)")
        ->option_text("PATH");
    command
        ->add_option("--frames", options->frames,
                     "Frames: last (default for obj, ply, stl, vdb, fragments), all (default for pvd, pc2, "
                     "mdd, glb), or numbers and START:STOP:STEP as in Python, separated by commas")
        ->option_text("WHICH");
    add_form_options(*command, *options);
    command->add_flag("--force", options->force, "Replace files that exist");
    command->footer(
        "Examples:\n"
        "  sherd export plate_drop.h5 --to obj --fragments -o plate.obj\n"
        "  sherd export plate_drop.h5 --to stl --solid --fragments -o pieces\n"
        "  sherd export plate_drop.h5 --to fragments -o pieces/plate.csv\n"
        "  sherd export plate_drop.h5 --to glb -o plate.glb\n"
        "  sherd export plate_drop.h5 --to ply --frames 0:100:10 -o frames");
    command->callback([&chosen, options] { chosen = [options] { return print_export(*options); }; });
}

}  // namespace sherd
