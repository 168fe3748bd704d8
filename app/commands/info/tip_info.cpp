// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/info/tip_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "app/messages/counted.h"

namespace sherd {

std::vector<TipInfo> tips_of(std::span<const TipRecord> records) {
    std::map<Index, TipInfo> tips;
    for (const TipRecord& record : records) {
        TipInfo& tip = tips.try_emplace(record.tip, TipInfo{record, record}).first->second;
        tip.last = record;
        tip.fastest = std::max(tip.fastest, record.speed);
        tip.largest = std::max(tip.largest, record.released);
    }
    std::vector<TipInfo> all;
    for (auto& [number, tip] : tips) all.push_back(tip);
    return all;
}

void add_tip_table(std::string& text, std::vector<TipInfo> tips, const std::string& time_unit) {
    constexpr std::size_t most = 20;
    if (tips.empty()) return;
    const std::size_t count = tips.size();
    std::ranges::stable_sort(tips, std::greater(), &TipInfo::largest);
    tips.resize(std::min(most, count));
    std::ranges::sort(tips, {}, [](const TipInfo& tip) { return tip.last.tip; });
    auto out = std::back_inserter(text);
    fmt::format_to(out,
                   "\ntip   from ({0}) to ({0})   fastest (m/s)  largest G / G_c  last K_I, K_II, k_1, k_2 "
                   "(Pa m^0.5)\n",
                   time_unit);
    for (const TipInfo& tip : tips)
        fmt::format_to(out, "{:<5} {:<9.4g} {:<9.4g} {:<14.4g} {:<16.3g} {:.3g}, {:.3g}, {:.3g}, {:.3g}\n",
                       tip.last.tip, tip.first.time, tip.last.time, tip.fastest,
                       tip.largest / tip.last.toughness, tip.last.opening, tip.last.shear, tip.last.bending,
                       tip.last.twist);
    if (count > most)
        fmt::format_to(out, "... and {} with a smaller largest G; all are in /tips\n",
                       counted(count - most, "tip"));
}

Json tips_json(std::span<const TipInfo> tips) {
    Json json = Json::array();
    for (const auto& [first, last, fastest, largest] : tips)
        json.push_back({{"tip", last.tip},
                        {"first_time", first.time},
                        {"last_time", last.time},
                        {"position", {last.position.x(), last.position.y(), last.position.z()}},
                        {"fastest", fastest},
                        {"largest_G", largest},
                        {"G_c", last.toughness},
                        {"K_I", last.opening},
                        {"K_II", last.shear},
                        {"k_1", last.bending},
                        {"k_2", last.twist}});
    return json;
}

}  // namespace sherd
