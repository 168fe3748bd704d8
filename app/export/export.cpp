// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export.h"

#include <fmt/format.h>

#include "app/export/export_formats.h"
#include "app/files/disk/pending_file.h"

namespace sherd {

namespace {

namespace fs = std::filesystem;

/// Creates `folder`, the folder of the files, if options.output is this folder. Throws Error (input) if it
/// does not exist then.
void prepare_folder(const ExportOptions& options, const fs::path& folder) {
    std::error_code reason, unreadable;
    if (folder.empty() || fs::is_directory(folder, unreadable)) return;
    // A missing parent folder is not created: more likely it is a mistake.
    if (folder == (options.output / "file").parent_path()) fs::create_directory(folder, reason);
    if (!fs::is_directory(folder, unreadable))
        throw Error(fmt::format("cannot write to the folder '{}': {}; create it first", folder.string(),
                                reason ? reason.message() : "it does not exist"));
}

void write_job(const ExportJob& job, const OutputLock& whole, bool force) {
    PendingFile pending(job.file, Fault::run, whole);
    if (job.write)
        job.write(pending.path());
    else
        pending.write(job.content());
    pending.publish(force);
}

}  // namespace

ExportReport export_recording(const ExportOptions& options) {
    const ExportFormat& format = export_format(options);
    ExportOptions used = options;
    used.solid |= format.bodies;
    ExportSource source(used, format.extension, format.all_frames);
    const std::vector<ExportJob> jobs = format.plan(source);
    for (const ExportJob& job : jobs) check_free(job.file, options.force, {options.recording});
    prepare_folder(options, jobs.front().file.parent_path());
    const OutputLock lock(source.clip_file(format.extension));
    ExportReport report;
    for (const ExportJob& job : jobs) try {
            write_job(job, lock, options.force);
            report.files.push_back(job.file);
        } catch (const Error& error) {
            const auto& done = report.files;
            throw Error(fmt::format("{}; {} of {} files are complete{}", error.what(), done.size(),
                                    jobs.size(), done.empty() ? "" : ", up to " + done.back().string()),
                        error.fault);
        }
    report.warnings = source.warnings;
    report.pace = source.pace_text;
    return report;
}

}  // namespace sherd
