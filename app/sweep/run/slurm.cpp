// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/run/slurm.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/files/disk/checksum.h"
#include "app/files/disk/pending_file.h"
#include "app/json/json.h"
#include "app/messages/shell_quoting.h"
#include "app/process/child_run.h"
#include "meshops/error.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

constexpr double safety = 5;  // factor on the time of the first steps, for contact and cracks in later ones
constexpr double longest_chunk = 3600, shortest_time = 300;  // s; longest_chunk by estimate, shortest_time to
                                                             // ask for
constexpr double most_tasks = 1000;                          // Slurm's MaxArraySize is 1001 by default
constexpr double megabyte = 1e6, spare_memory = 300e6;       // bytes; spare_memory for each row that runs

fs::path job_file(const fs::path& folder) {
    return folder / "slurm" / "job.json";
}

/// Returns ascending numbers as text: "0-3,7,9-12".
std::string ranges_text(const std::vector<std::size_t>& numbers) {
    std::string text;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t last = i;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
        text += fmt::format("{}{}", text.empty() ? "" : ",", numbers[i]);
        if (last > i) text += fmt::format("-{}", numbers[last]);
        i = last + 1;
    }
    return text;
}

/// Returns the states of a job's tasks that are in the queue; empty if squeue has no such job, or is missing.
std::map<std::size_t, std::string> queued_tasks(const std::string& job) try {
    const ProgramEnd end = end_of("squeue", {"--noheader", "--array", "--jobs", job, "--format", "%K %T"});
    std::map<std::size_t, std::string> tasks;
    if (end.exit_code != 0) return tasks;
    std::istringstream lines(end.out);
    std::size_t task = 0;
    std::string state;
    while (lines >> task >> state)
        if (state != "COMPLETING") tasks[task] = state;  // a task may have this state for long after its end
    return tasks;
} catch (const Error&) {
    return {};
}

void write_file(const fs::path& file, const std::string& text) {
    const OutputLock lock(file);
    PendingFile pending(lock, Fault::input);
    pending.write(text);
    pending.publish(true);
}

/// Escapes a path, so that sbatch replaces no pattern in it.
std::string without_patterns(const std::string& path) {
    std::string text;
    for (const char c : path) text += c == '%' ? std::string("%%") : std::string(1, c);
    return text;
}

}  // namespace

std::size_t chunk_size(std::size_t rows, const RowCost& cost) {
    const double by_time = std::floor(longest_chunk / std::max(1e-3, safety * cost.seconds));
    const double by_tasks = std::ceil(static_cast<double>(rows) / most_tasks);
    return static_cast<std::size_t>(std::clamp(std::max(by_time, by_tasks), 1., static_cast<double>(rows)));
}

std::string slurm_script(const SlurmJob& job, const SlurmOptions& options, const RowCost& cost,
                         const fs::path& folder) {
    const double rows_after_each_other = std::ceil(static_cast<double>(job.chunk) / job.jobs);
    const double seconds = std::max(shortest_time, safety * cost.seconds * rows_after_each_other);
    const double bytes = job.jobs * (1.5 * cost.memory + spare_memory);
    std::string script = "#!/bin/bash\n";
    const auto ask = [&](const char* option, const std::string& value) {
        if (value.find('\n') != std::string::npos)
            throw Error(fmt::format("a line break cannot be handed to sbatch --{}: '{}'", option, value));
        if (!value.empty()) script += fmt::format("#SBATCH --{}={}\n", option, shell_quoted(value));
    };
    ask("job-name", "sherd-" + folder.filename().string());
    ask("array", ranges_text(job.tasks));
    ask("partition", options.partition);
    ask("account", options.account);
    ask("time", options.time.empty() ? fmt::format("{:.0f}", std::ceil(seconds / 60)) : options.time);
    ask("mem", options.memory.empty() ? fmt::format("{:.0f}M", std::ceil(bytes / megabyte)) : options.memory);
    ask("cpus-per-task", std::to_string(job.jobs));
    ask("output", without_patterns((folder / "slurm" / "").string()) + "%A_%a.log");
    std::string command;
    for (const std::string& word : job.sweep) command += shell_quoted(word) + " ";
    return script + fmt::format(
                        "first=$((SLURM_ARRAY_TASK_ID * {0}))\n"
                        "exec {1}--jobs {2} --rows $first-$((first + {0} - 1))\n",
                        job.chunk, command, job.jobs);
}

void require_no_job(const fs::path& folder) {
    if (const auto job = submitted_job(folder); job && !job->tasks.empty())
        throw Error(
            fmt::format("job {0} of this study is still in the queue: wait for it (sherd sweep --status), or "
                        "end it (scancel {0})",
                        job->number));
}

std::string submit(std::size_t chunk, const std::string& script, const fs::path& folder) {
    make_folder(folder / "slurm");
    const fs::path file = folder / "slurm" / "job.sh";
    write_file(file, script);
    ProgramEnd end;
    try {
        end = end_of("sbatch", {"--parsable", file.string()});
    } catch (const Error& error) {
        throw Error(
            fmt::format("sbatch: {}; --slurm is for machines that submit jobs to Slurm", error.what()),
            Fault::run);
    }
    if (end.exit_code != 0) throw Error(end.err, Fault::run);  // each line of stderr names sbatch already
    std::string number = end.out.substr(0, end.out.find_first_of(";\n"));  // "NUMBER;CLUSTER"
    write_file(job_file(folder), Json{{"job", number}, {"chunk", chunk}}.dump() + "\n");
    return number;
}

std::optional<SubmittedJob> submitted_job(const fs::path& folder) {
    if (!fs::exists(job_file(folder))) return std::nullopt;
    const Json json = Json::parse(text_of(job_file(folder)), nullptr, false);
    if (!json.is_object() || !json.contains("job") || !json.contains("chunk"))
        throw Error(fmt::format("'{}' is damaged; remove it", job_file(folder).string()));
    SubmittedJob job{json["job"], json["chunk"], {}};
    job.tasks = queued_tasks(job.number);
    return job;
}

}  // namespace sherd
