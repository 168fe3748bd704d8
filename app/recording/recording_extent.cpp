// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/recording_extent.h"

#include <algorithm>
#include <functional>

#include "app/recording/recording_table.h"

namespace sherd::recording_format {

std::vector<std::size_t> extent(hid_t file) {
    std::vector<std::size_t> rows;
    visit_tables([&]<class Row>(std::type_identity<Row>) { rows.push_back(table_rows<Row>(file)); });
    visit_lists([&]<class Row>(std::vector<Row> StepReport::*, const std::string& group) {
        for (const std::string& table : numbered_groups(file, group))
            rows.push_back(table_rows<Row>(file, table));
    });
    return rows;
}

void cut(hid_t file, std::size_t frames, std::span<const std::size_t> rows) {
    const std::vector<std::size_t> now = extent(file);
    const std::size_t frames_now = hdf5::member_count(file, "frames");
    if (frames_now < frames || now.size() != rows.size() ||
        !std::ranges::equal(rows, now, std::ranges::less_equal()))
        throw Error("it holds less than had been recorded at the checkpoint", Fault::run);
    for (std::size_t frame = frames_now; frame-- > frames;) hdf5::remove(file, frame_group(frame));
    auto left = rows.begin();
    visit_tables([&]<class Row>(std::type_identity<Row>) { shorten_table<Row>(file, *left++); });
    visit_lists([&]<class Row>(std::vector<Row> StepReport::*, const std::string& group) {
        for (const std::string& table : numbered_groups(file, group))
            shorten_table<Row>(file, *left++, table);
    });
}

}  // namespace sherd::recording_format
