// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <set>
#include <thread>

#include "app/commands/commands.h"
#include "app/commands/number_check.h"
#include "app/commands/run_cost.h"
#include "app/files/program_file.h"
#include "app/messages/counted.h"
#include "app/messages/print.h"
#include "app/messages/split.h"
#include "app/progress/interruption.h"
#include "app/scene/assemble/built_scene.h"
#include "app/scene/read/scene.h"
#include "app/scene/read/shipped_scenes.h"
#include "app/sweep/run/python_measure.h"
#include "app/sweep/run/slurm.h"
#include "app/sweep/run/sweep_runner.h"
#include "app/sweep/run/unlocked_output.h"
#include "app/sweep/table/sweep_folder.h"
#include "meshops/error.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

/// The command line of `sherd sweep`.
struct SweepOptions {
    fs::path study, folder;
    int jobs = 0;  ///< rows at a time; 0: as many as the processor runs at once, 1 in a task of Slurm
    bool quick = false, retry = false, slurm = false, status = false, collect = false;
    std::string rows;  ///< FIRST-LAST; empty: all
    SlurmOptions on_slurm;
};

/// A study, its rows and its folder.
struct Sweep {
    explicit Sweep(const SweepOptions& options)
        : study(read_study(find_study(options.study), options.quick)),
          rows(study_rows(study, options.rows.empty() && !options.status && !options.collect)),
          folder(options.folder.empty() ? options.study.stem() : options.folder) {}

    Study study;
    StudyRows rows;
    fs::path folder;
};

/// Reads FIRST-LAST as the half-open range [FIRST, LAST + 1), cut at the number of rows `count`; an empty
/// text is all rows. Throws Error unless the range has rows of the study.
std::pair<std::size_t, std::size_t> row_range(const std::string& text, std::size_t count) {
    if (text.empty()) return {0, count};
    const std::vector<std::string> ends = split(text, '-');
    const auto is_number = [](const std::string& word) {
        return !word.empty() && word.size() < 10 && word.find_first_not_of("0123456789") == std::string::npos;
    };
    if (ends.size() != 2 || !std::ranges::all_of(ends, is_number) ||
        std::stoul(ends[0]) > std::stoul(ends[1]))
        throw Error(fmt::format("--rows {}: give FIRST-LAST, such as 0-99", text));
    if (std::stoul(ends[0]) >= count)
        throw Error(fmt::format("--rows {}: the study has {} rows, counted from 0", text, count));
    return {std::stoul(ends[0]), std::min(count, std::stoul(ends[1]) + 1)};
}

std::vector<std::size_t> rows_to_run(const Sweep& sweep, const SweepState& state, bool retry) {
    std::vector<std::size_t> wanted = state.missing;
    std::set<std::uint64_t> seen;
    for (const std::size_t row : state.failed)
        if (retry && seen.insert(sweep.rows.rows[row].identity).second) wanted.push_back(row);
    std::ranges::sort(wanted);
    return wanted;
}

/// Reports the results of earlier sweeps in the folder.
void report_before(const SweepState& state, const StudyRows& rows, const fs::path& folder, bool retry) {
    if (state.done > 0)
        print_message("sherd: {} of {} rows are done already\n", state.done, rows.rows.size());
    if (!state.failed.empty())
        print_message("sherd: {} failed before{}\n", counted(state.failed.size(), "row"),
                      retry ? " and are run again" : "; --retry runs them again");
    if (state.of_other_program > 0)
        print_message(
            "sherd: {} rows were run by another build of this program (program_hash); remove '{}' to "
            "run them again\n",
            state.of_other_program, (folder / "rows").string());
    if (state.foreign > 0)
        print_message(
            "sherd: the study has changed: {} results belong to rows that it no longer has; they are kept, "
            "but are not in its tables\n",
            state.foreign);
}

std::string rows_words(const SweepState& state, std::size_t count) {
    return fmt::format("rows         {}: {} done, {} failed, {} to run\n", count, state.done,
                       state.failed.size(), count - state.done - state.failed.size());
}

/// Runs those of the chosen rows that are missing or, with --retry, failed. Returns false after an
/// interruption.
bool run_rows(const Sweep& sweep, const SweepOptions& options) {
    const auto [begin, end] = row_range(options.rows, sweep.rows.rows.size());
    const fs::path file = journal_file(sweep.folder, begin, end);
    wait_until_unlocked(file);
    ResultJournal journal(file);
    const SweepState state = sweep_state(sweep.rows, results_in(sweep.folder));
    report_before(state, sweep.rows, sweep.folder, options.retry);
    std::vector<std::size_t> wanted = rows_to_run(sweep, state, options.retry);
    std::erase_if(wanted, [begin = begin, end = end](std::size_t row) { return row < begin || row >= end; });
    if (wanted.empty()) return true;
    if (!sweep.rows.python.empty()) require_measure(sweep.rows.python);
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    watch_for_interruption();
    SweepRunner runner(sweep.study, sweep.rows, sweep.folder, wanted,
                       options.jobs > 0 ? options.jobs : cores);
    runner.run(journal);
    return !runner.stopped;
}

/// Reports the end of the sweep, and returns the exit code.
int end_of_sweep(const Sweep& sweep, bool complete) {
    const RowResults results = results_in(sweep.folder);
    const SweepState state = sweep_state(sweep.rows, results);
    print_result("{}", rows_words(state, sweep.rows.rows.size()));
    print_message("{}", failed_lines(sweep.rows, results, state.failed));
    if (!complete) {
        print_message(
            "sherd: interrupted; the same command continues with the rows that were not run to their end\n");
        return interruption_exit_code();
    }
    if (!state.failed.empty())
        throw Error(fmt::format("{} of {} rows failed; --retry runs them again", state.failed.size(),
                                sweep.rows.rows.size()),
                    Fault::run);
    return 0;
}

/// Estimated cost of a row: the larger cost of the first and the last missing row, as estimated from their
/// first steps on this machine.
RowCost estimated_row_cost(const StudyRows& rows, const std::vector<std::size_t>& missing) {
    RowCost largest;
    for (const std::size_t row : {missing.front(), missing.back()}) {
        std::vector<std::string> warnings;
        const Scene scene = read_scene(rows.scene, rows.rows[row].choice);
        BuiltScene built = build_scene(scene, warnings);
        RunCost cost = run_cost(scene, built);
        add(cost, try_steps(scene, std::move(built)));
        largest.seconds = std::max(largest.seconds, cost.seconds);
        largest.memory = std::max({largest.memory, cost.memory, cost.peak_memory});
        if (missing.size() == 1) break;
    }
    return largest;
}

/// The study's options for Slurm, overridden by those of the command line.
SlurmOptions slurm_options(SlurmOptions slurm, const SlurmOptions& given) {
    for (std::string SlurmOptions::*text :
         {&SlurmOptions::partition, &SlurmOptions::account, &SlurmOptions::time, &SlurmOptions::memory})
        if (!(given.*text).empty()) slurm.*text = given.*text;
    if (given.chunk > 0) slurm.chunk = given.chunk;
    return slurm;
}

SlurmJob slurm_job(const Sweep& sweep, const SweepOptions& options, const fs::path& folder, std::size_t chunk,
                   const std::vector<std::size_t>& wanted) {
    SlurmJob job{.chunk = chunk, .tasks = {}, .jobs = std::max(1, options.jobs), .sweep = {}};
    for (const std::size_t row : wanted)
        if (job.tasks.empty() || job.tasks.back() != row / chunk) job.tasks.push_back(row / chunk);
    job.sweep = {fs::canonical(program_to_start()).string(), "sweep", fs::absolute(sweep.study.file).string(),
                 "-o", folder.string()};
    if (options.quick) job.sweep.emplace_back("--quick");
    if (options.retry) job.sweep.emplace_back("--retry");
    return job;
}

int submit_sweep(const Sweep& sweep, const SweepOptions& options) {
    const SweepState state = sweep_state(sweep.rows, results_in(sweep.folder));
    report_before(state, sweep.rows, sweep.folder, options.retry);
    const std::vector<std::size_t> wanted = rows_to_run(sweep, state, options.retry);
    if (wanted.empty()) {
        print_message("sherd: no row is left to run; --collect makes the tables\n");
        return 0;
    }
    if (!sweep.rows.python.empty()) require_measure(sweep.rows.python);
    const SlurmOptions slurm = slurm_options(sweep.study.slurm, options.on_slurm);
    const RowCost cost = estimated_row_cost(sweep.rows, wanted);
    const std::size_t chunk = slurm.chunk > 0 ? slurm.chunk : chunk_size(sweep.rows.rows.size(), cost);
    const fs::path folder = fs::absolute(sweep.folder).lexically_normal();
    const SlurmJob job = slurm_job(sweep, options, folder, chunk, wanted);
    const std::string number = submit(chunk, slurm_script(job, slurm, cost, folder), folder);
    print_result("job          {}: {} tasks of {} rows each, {} rows to run\n", number, job.tasks.size(),
                 chunk, wanted.size());
    return 0;
}

int print_status(const Sweep& sweep) {
    const RowResults results = results_in(sweep.folder);
    const SweepState state = sweep_state(sweep.rows, results);
    report_before({.of_other_program = state.of_other_program, .foreign = state.foreign}, sweep.rows,
                  sweep.folder, false);
    print_result("{}", rows_words(state, sweep.rows.rows.size()));
    if (const auto job = submitted_job(sweep.folder)) {
        std::size_t running = 0, waiting = 0, rows_running = 0, rows_waiting = 0;
        for (const auto& [task, name] : job->tasks) ++(name == "PENDING" ? waiting : running);
        for (const std::size_t row : state.missing)
            if (const auto task = job->tasks.find(row / job->chunk); task != job->tasks.end())
                ++(task->second == "PENDING" ? rows_waiting : rows_running);
        print_result("job          {}: {} tasks run ({} rows), {} wait ({} rows)\n", job->number, running,
                     rows_running, waiting, rows_waiting);
    }
    print_message("{}", failed_lines(sweep.rows, results, state.failed));
    return 0;
}

int sweep(const SweepOptions& options) {
    const Sweep sweep(options);
    if (options.status) return print_status(sweep);
    make_sweep_folder(sweep.folder);
    if (!options.rows.empty()) return end_of_sweep(sweep, run_rows(sweep, options));
    const OutputLock lock(sweep.folder / "study.csv");
    if (!options.collect) require_no_job(sweep.folder);
    if (options.slurm) return submit_sweep(sweep, options);
    const bool complete = options.collect || run_rows(sweep, options);
    const std::vector<fs::path> files = write_tables(sweep.study, sweep.rows, results_in(sweep.folder), lock);
    for (const fs::path& file : files) print_result("{}\n", file.string());
    return end_of_sweep(sweep, complete);
}

void add_slurm_options(CLI::App& command, SweepOptions& options) {
    CLI::Option* slurm =
        command.add_flag("--slurm", options.slurm, "Submit the rows to Slurm as a job array, and exit");
    const auto add = [&](const char* name, auto& value, const char* text, const char* description) {
        return command.add_option(name, value, description)->option_text(text)->needs(slurm);
    };
    SlurmOptions& of = options.on_slurm;
    add("--partition", of.partition, "NAME", "Partition of Slurm");
    add("--account", of.account, "NAME", "Account of Slurm");
    add("--time", of.time, "TIME",
        "Time limit of a task, in the form of sbatch; default: several times the estimate from the first "
        "steps");
    add("--memory", of.memory, "SIZE",
        "Memory of a task, in the form of sbatch; default: estimated from the first steps, too");
    add("--chunk", of.chunk, "N",
        "Rows per task; default: as many as take less than an hour, in 1000 tasks at most")
        ->check(whole_number(1));
    command
        .add_flag("--status", options.status,
                  "Report how many rows are done, failed, running and waiting, and exit")
        ->excludes(slurm);
    command
        .add_flag("--collect", options.collect, "Write the tables of the rows that are done, and run nothing")
        ->excludes(slurm);
}

}  // namespace

void add_sweep(CLI::App& program, Command& chosen) {
    CLI::App* command = program.add_subcommand(
        "sweep", "Run a study: a scene many times, with parameters that vary, with one table of results");
    auto options = std::make_shared<SweepOptions>();
    command
        ->add_option("study", options->study,
                     "Study file (.toml; keys in docs/commands.md), or one of those in scenes/studies")
        ->required()
        ->option_text("STUDY.toml");
    command
        ->add_option(
            "-o,--output", options->folder,
            "Folder for tables and recordings; a study that is there is continued. Default: the study's name")
        ->option_text("FOLDER");
    command
        ->add_option("-j,--jobs", options->jobs,
                     "Number of rows to run at a time; default: as many as the processor runs at once, 1 in "
                     "a task of Slurm")
        ->check(whole_number(1))
        ->option_text("N");
    command->add_flag("--retry", options->retry, "Run failed rows again");
    command->add_flag("--quick", options->quick,
                      "Let the keys of the study's table [quick] override the others");
    command
        ->add_option("--rows", options->rows,
                     "Run only these rows, while other processes run others; the first is 0. --collect "
                     "writes the tables")
        ->option_text("FIRST-LAST");
    add_slurm_options(*command, *options);
    command->footer(
        "Example:\n  sherd sweep study.toml -o study --jobs 4\n  sherd sweep studies/drop_height --quick");
    command->callback([&chosen, options] { chosen = [options] { return sweep(*options); }; });
}

}  // namespace sherd
