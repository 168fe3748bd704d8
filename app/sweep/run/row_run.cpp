// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/run/row_run.h"

#include <fmt/format.h>

#include <cstring>

#include "app/files/disk/pending_file.h"
#include "app/files/program_file.h"
#include "app/machine/exit_code.h"
#include "app/measures/measures.h"
#include "app/run/checkpoint.h"
#include "app/sweep/run/python_measure.h"
#include "app/sweep/run/unlocked_output.h"
#include "app/sweep/study/study_measures.h"
#include "meshops/error.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

/// Whether a killed run of this program has left a checkpoint from which it can be resumed.
bool can_resume(const fs::path& recording, std::uint64_t program) {
    if (!fs::exists(recording)) return false;
    std::vector<std::string> warnings;
    const std::optional<Checkpoint> last = last_checkpoint(recording, warnings);
    return last && last->origin.program.find(fmt::format("{:016x}", program)) != std::string::npos;
}

}  // namespace

fs::path row_recording(const fs::path& folder, const StudyRow& row) {
    return folder / "runs" / fmt::format("{:016x}.h5", row.identity);
}

RowRun::RowRun(const Study& study, const StudyRows& rows, const StudyRow& row, const fs::path& folder,
               int threads)
    : study(study), rows(rows), recording(row_recording(folder, row)) {
    wait_until_unlocked(recording);
    std::vector<std::string> arguments = row_arguments(rows, row);
    arguments.insert(arguments.end(),
                     {"--output", recording.string(), "--force", "--threads", std::to_string(threads),
                      "--progress-to", std::to_string(ChildProcess::report_descriptor)});
    if (can_resume(recording, rows.program)) arguments.emplace_back("--resume");
    result.identity = row.identity;
    result.program = rows.program;
    process.emplace("", row.duration, std::move(arguments));
}

bool RowRun::listen() {
    const bool goes_on = process->listen();
    words += process->take_words();
    if (goes_on) return true;
    end_process();
    if (measuring || result.exit_code != 0 || rows.python.empty()) {
        if (result.exit_code == 0) measure();
        return false;
    }
    measuring = true;
    words.clear();
    process.emplace("", 1, python_arguments(rows.python, recording), python_to_start());
    return true;
}

void RowRun::end_process() {
    result.exit_code = process->finish();
    result.processor_seconds += process->processor_seconds();
    if (result.exit_code == 0) return;
    result.message = result.exit_code > signal_base
                         ? fmt::format("ended by signal {} ({})", result.exit_code - signal_base,
                                       strsignal(result.exit_code - signal_base))
                         : reason_in(words);
    if (measuring) result.message = fmt::format("{}: {}", rows.python.filename().string(), result.message);
}

void RowRun::measure() try {
    result.values = measure_values(measures_of(Recording(recording), study.over, study.centre));
    if (measuring)
        result.python =
            with_context(rows.python.filename().string(), [&] { return python_values(process->results); });
} catch (const std::exception& error) {
    result.exit_code = 1;
    result.message = error.what();
}

RowResult RowRun::finish() {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    result.wall_seconds = spent.count();
    if (result.exit_code > signal_base) return result;  // the run can be resumed
    remove_checkpoints(recording);
    const bool kept = study.keep == Keep::all || (study.keep == Keep::failed && result.exit_code != 0);
    if (!kept)
        for (const char* ending : {".h5", ".xdmf"}) fs::remove(fs::path(recording).replace_extension(ending));
    return result;
}

}  // namespace sherd
