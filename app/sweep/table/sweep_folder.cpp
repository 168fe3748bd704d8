// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/table/sweep_folder.h"

#include <fmt/format.h>

#include <unordered_set>

#include "app/files/disk/pending_file.h"
#include "app/sweep/table/study_chart.h"
#include "app/sweep/table/study_summary.h"
#include "app/sweep/table/study_table.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

void publish_text(const OutputLock& whole, const fs::path& file, const std::string& text) {
    PendingFile pending(file, Fault::input, whole);
    pending.write(text);
    pending.publish(true);
}

}  // namespace

void make_sweep_folder(const fs::path& folder) {
    make_folder(folder);
    make_folder(folder / "rows");
    make_folder(folder / "runs");
}

fs::path journal_file(const fs::path& folder, std::size_t begin, std::size_t end) {
    return folder / "rows" / fmt::format("{:07}-{:07}.jsonl", begin, end - 1);
}

RowResults results_in(const fs::path& folder) {
    return read_results(folder / "rows");
}

SweepState sweep_state(const StudyRows& rows, const RowResults& results) {
    SweepState state;
    std::unordered_set<std::uint64_t> seen;
    std::size_t known = 0;
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
        const std::uint64_t identity = rows.rows[i].identity;
        const bool is_first = seen.insert(identity).second;
        const auto found = results.find(identity);
        if (found == results.end()) {
            if (is_first) state.missing.push_back(i);
            continue;
        }
        known += is_first;
        if (found->second.program != rows.program) ++state.of_other_program;
        if (found->second.exit_code == 0)
            ++state.done;
        else
            state.failed.push_back(i);
    }
    state.foreign = results.size() - known;
    return state;
}

std::string failed_lines(const StudyRows& rows, const RowResults& results,
                         std::span<const std::size_t> failed) {
    constexpr std::size_t most = 10;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, failed.size()); ++i) {
        const RowResult& result = results.at(rows.rows[failed[i]].identity);
        text += fmt::format("sherd: row {} failed ({}): {}\n", failed[i], result.exit_code, result.message);
    }
    if (failed.size() > most)
        text += fmt::format("sherd: and {} more; study.csv has them all\n", failed.size() - most);
    return text;
}

std::vector<fs::path> write_tables(const Study& study, const StudyRows& rows, const RowResults& results,
                                   const OutputLock& lock) {
    const fs::path folder = lock.output().parent_path();
    const StudyTable table = study_table(study, rows, results, folder);
    std::vector<fs::path> files{lock.output(), folder / "study.h5", folder / "summary.csv"};
    publish_text(lock, files[0], csv_text(csv_rows(table)));
    write_study_h5(table, lock, files[1]);
    publish_text(lock, files[2], csv_text(study_summary(rows, table)));
    if (const std::string picture = summary_svg(study, table); !picture.empty()) {
        files.push_back(folder / "summary.svg");
        publish_text(lock, files.back(), picture);
    }
    return files;
}

}  // namespace sherd
