// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/run/result_journal.h"

#include <fcntl.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/files/disk/checksum.h"
#include "app/messages/split.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

RowResults results_of(const fs::path& journal) {
    const std::string text = text_of(journal);
    RowResults results;
    for (const std::string& line : split(text.substr(0, text.rfind('\n') + 1), '\n'))
        if (std::optional<RowResult> result = row_result(line))
            results[result->identity] = std::move(*result);
    return results;
}

}  // namespace

ResultJournal::ResultJournal(const fs::path& file_) : lock(file_), file(file_, O_RDWR | O_CREAT) {
    end = text_of(file_).rfind('\n') + 1;
    file.resize(end);
}

void ResultJournal::append(const RowResult& result) {
    const std::string line = to_line(result) + "\n";
    file.write(end, std::as_bytes(std::span(line)));
    end += line.size();
}

RowResults read_results(const fs::path& folder) {
    std::vector<fs::path> journals;
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing))
        if (entry.path().extension() == ".jsonl") journals.push_back(entry.path());
    std::ranges::sort(journals);
    RowResults all;
    for (const fs::path& journal : journals)
        for (auto& [identity, result] : results_of(journal)) {
            const auto [known, is_new] = all.try_emplace(identity, result);
            if (!is_new && known->second.exit_code != 0) known->second = std::move(result);
        }
    return all;
}

}  // namespace sherd
