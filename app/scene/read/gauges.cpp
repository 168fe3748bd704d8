// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/gauges.h"

#include <algorithm>
#include <array>

#include "app/scene/read/parts/fields.h"

namespace sherd {
namespace {

constexpr std::array<std::string_view, 4> readings{"displacement", "stress", "curvature", "membrane_strain"};

void read_name(TomlTable& table, const KeyInfo& key, GaugeSpec& gauge) {
    gauge.name = table.string(key.name, key.rules.what);
}

void read_record(TomlTable& table, const KeyInfo& key, GaugeSpec& gauge) {
    if (!table.has(key.name)) return;
    const std::vector<std::string> wanted = table.choices(key.name, key.rules.choices);
    gauge.displacement = std::ranges::find(wanted, "displacement") != wanted.end();
    gauge.fields = chosen_fields(wanted);
}

void complete_gauge(TomlTable& table, GaugeSpec& gauge) {
    gauge.where = table.where("at");
}

constexpr std::array gauge_keys{
    special_key("name", Form::name,
                "name of the gauge and of its group in the recording: letters, digits, `_` and `-`",
                {.what = "the name of the gauge", .required = true}, read_name),
    key<&GaugeSpec::at>(
        "at",
        "place of the gauge; the nearest point of the placed sheets is taken, up to an edge length away",
        {.unit = "m", .required = true}),
    key<&GaugeSpec::sheet>("sheet", "name of the gauge's sheet",
                           {.what = "the name of a sheet", .otherwise = "the nearest"}),
    special_key("record", Form::names, "quantities recorded at the point and in its face",
                {.choices = readings, .otherwise = "`[\"displacement\"]`"}, read_record)};

}  // namespace

constinit const Section<GaugeSpec> gauge_section{"A gauge: a point at which quantities are measured",
                                                 gauge_keys, complete_gauge};

}  // namespace sherd
