// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>

#include "app/chart/chart.h"
#include "app/chart/chart_page.h"
#include "app/commands/commands.h"
#include "app/files/disk/pending_file.h"
#include "app/messages/counted.h"
#include "app/messages/print.h"
#include "app/messages/time_text.h"
#include "app/recording/recording_format.h"
#include "app/sweep/table/study_chart.h"
#include "core/elements/principal_values.h"
#include "meshops/error.h"

namespace sherd {
namespace {

const ChartAxis time_axis{.name = "time", .unit = "s", .from_zero = true};

using Value = std::function<double(const StepReport&)>;

ChartSeries over_time(const std::vector<StepReport>& steps, const std::string& name, const char* colour,
                      const Value& value) {
    ChartSeries series{.name = name, .colour = colour, .points = {}};
    for (const StepReport& step : steps) series.points.emplace_back(step.time, value(step));
    return series;
}

Chart motion_chart(const std::vector<StepReport>& steps) {
    Chart chart{"Energy", time_axis, {.name = "energy", .unit = "J"}, {}};
    chart.series.push_back(over_time(steps, "kinetic", blue, &StepReport::kinetic));
    chart.series.push_back(over_time(steps, "gravity", vermillion, &StepReport::gravity));
    chart.series.push_back(over_time(steps, "all", black, [](const StepReport& step) {
        return step.kinetic + step.gravity + step.bending + step.membrane + step.contact + step.residual;
    }));
    chart.series.back().dashed = true;
    return chart;
}

Chart elastic_chart(const std::vector<StepReport>& steps) {
    Chart chart{"Elastic energy", time_axis, {.name = "energy", .unit = "J", .from_zero = true}, {}};
    chart.series.push_back(over_time(steps, "bending", green, &StepReport::bending));
    chart.series.push_back(over_time(steps, "membrane", purple, &StepReport::membrane));
    chart.series.push_back(over_time(steps, "contact", orange, &StepReport::contact));
    if (std::ranges::any_of(steps, [](const StepReport& step) { return step.residual > 0; }))
        chart.series.push_back(over_time(steps, "residual stress", vermillion, &StepReport::residual));
    return chart;
}

/// Work and losses; a quantity that is zero throughout has no line.
Chart balance_chart(const std::vector<StepReport>& steps) {
    Chart chart{"Work and losses since the start", time_axis, {.name = "energy", .unit = "J"}, {}};
    const auto add = [&](const char* name, const char* colour, const Value& value) {
        if (std::ranges::any_of(steps, [&](const StepReport& step) { return value(step) != 0; }))
            chart.series.push_back(over_time(steps, name, colour, value));
    };
    add("work", black, [](const StepReport& step) {
        return step.work_of_loads + step.work_of_wind + step.work_of_supports + step.work_of_obstacles;
    });
    add("friction", orange, &StepReport::lost_to_friction);
    add("damping", purple, &StepReport::lost_to_damping);
    add("cracks", vermillion, &StepReport::lost_to_cracks);
    add("remeshing", sky, &StepReport::lost_to_remeshing);
    add("yield", yellow, &StepReport::lost_to_yield);
    add("scheme", blue, &StepReport::lost_to_scheme);
    add("unexplained", green, &StepReport::unexplained);
    return chart;
}

Chart fragment_chart(const std::vector<StepReport>& steps) {
    Chart chart{"Fragments", time_axis, {.name = "number", .whole = true, .from_zero = true}, {}};
    chart.series.push_back(over_time(steps, "fragments", blue, &StepReport::fragments));
    chart.series.back().stepped = true;
    return chart;
}

Chart strain_chart(const std::vector<StepReport>& steps) {
    Chart chart{"Peak strain of the unbroken hinges",
                time_axis,
                {.name = "strain", .unit = "1/m", .from_zero = true},
                {}};
    chart.series.push_back(over_time(steps, "strain", green, &StepReport::peak_strain));
    return chart;
}

/// Adds lines to a chart for the first of these names, as many as have distinct colours and room in the
/// legend. The line of names[i] is value(step, i) over time. which: word for these lines in the title if
/// names are left out.
template <class ValueOf>
Chart chart_of_names(Chart chart, const std::vector<StepReport>& steps, const std::vector<std::string>& names,
                     ValueOf value, const char* which = "first") {
    double room = 430;
    for (std::size_t i = 0; i < std::min(names.size(), series_colours.size()); ++i) {
        room -= legend_width(names[i]);
        if (i > 0 && room < 0) break;
        chart.series.push_back(over_time(steps, names[i], series_colours[i],
                                         [&](const StepReport& step) -> double { return value(step, i); }));
    }
    if (chart.series.size() == 1) chart.title += ": " + names.front();
    if (names.size() > chart.series.size())
        chart.title += fmt::format(" (the {} {} of {})", which, chart.series.size(), names.size());
    return chart;
}

Chart reaction_chart(const RecordingHeader& header, const std::vector<StepReport>& steps) {
    std::vector<std::string> names;
    for (const RecordedSupport& support : header.supports)
        names.push_back(support.name.substr(support.name.find('.') + 1));
    return chart_of_names({"Forces of supports and obstacles",
                           time_axis,
                           {.name = "force", .unit = "N", .from_zero = true},
                           {}},
                          steps, names, [](const StepReport& step, std::size_t i) {
                              return step.reactions.at(i).force.norm();
                          });
}

/// Adds a chart of the gauges that record `column`, if there are any. value: computes the plotted number from
/// a reading.
template <class ValueOf>
void add_gauge_chart(std::vector<Chart>& charts, const RecordingHeader& header,
                     const std::vector<StepReport>& steps, const char* column, Chart chart, ValueOf value) {
    std::vector<std::string> names;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < header.gauges.size(); ++i) {
        if (!recording_format::is_recorded(header.gauges[i], column)) continue;
        names.push_back(header.gauges[i].name);
        numbers.push_back(i);
    }
    if (names.empty()) return;
    charts.push_back(chart_of_names(
        std::move(chart), steps, names,
        [&](const StepReport& step, std::size_t i) { return value(step.gauges.at(numbers[i])); }));
}

void add_gauge_charts(std::vector<Chart>& charts, const RecordingHeader& header,
                      const std::vector<StepReport>& steps) {
    using Reading = GaugeReading;
    add_gauge_chart(charts, header, steps, "displacement",
                    {"Gauges", time_axis, {.name = "displacement", .unit = "m", .from_zero = true}, {}},
                    [](const Reading& reading) { return reading.displacement.norm(); });
    add_gauge_chart(charts, header, steps, "stress_top",
                    {"Gauges", time_axis, {.name = "largest principal stress", .unit = "Pa"}, {}},
                    [](const Reading& reading) { return largest_stress(reading); });
    add_gauge_chart(charts, header, steps, "curvature",
                    {"Gauges", time_axis, {.name = "principal curvature", .unit = "1/m"}, {}},
                    [](const Reading& reading) { return principal_strain(reading.curvature); });
    add_gauge_chart(charts, header, steps, "membrane_strain",
                    {"Gauges", time_axis, {.name = "principal membrane strain"}, {}},
                    [](const Reading& reading) { return principal_strain(reading.membrane_strain); });
}

/// Adds charts of the release rate and speed of crack tips, for the tips that were recorded in the most
/// steps.
void add_tip_charts(std::vector<Chart>& charts, const std::vector<StepReport>& steps,
                    std::span<const TipRecord> records) {
    constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
    if (records.empty()) return;
    std::map<Index, std::map<std::int64_t, const TipRecord*>> by_number;
    for (const TipRecord& record : records) by_number[record.tip][record.step] = &record;
    std::vector<std::pair<Index, const std::map<std::int64_t, const TipRecord*>*>> tips;
    for (const auto& [number, of_step] : by_number) tips.emplace_back(number, &of_step);
    std::ranges::stable_sort(tips, std::greater(), [](const auto& tip) { return tip.second->size(); });
    std::vector<std::string> names;
    for (const auto& [number, of_step] : tips) names.push_back(fmt::format("tip {}", number));
    const auto add = [&](Chart chart, auto value) {
        const auto of_step = [&](const StepReport& step, std::size_t i) {
            const auto found = tips[i].second->find(step.step);
            return found == tips[i].second->end() ? no_value : value(*found->second);
        };
        charts.push_back(chart_of_names(std::move(chart), steps, names, of_step, "longest"));
    };
    add({"Energy released at tips", time_axis, {.name = "G / G_c", .logarithmic = true}, {}},
        [](const TipRecord& tip) { return tip.released > 0 ? tip.released / tip.toughness : no_value; });
    add({"Speed of tips", time_axis, {.name = "speed", .unit = "m/s", .from_zero = true}, {}},
        [](const TipRecord& tip) { return tip.speed; });
}

/// Load over displacement of each gauge, in statics.
Chart load_chart(const RecordingHeader& header, const std::vector<StepReport>& steps) {
    Chart chart{"Load factor over displacement",
                {.name = "displacement", .unit = "m", .from_zero = true},
                {.name = "load factor"},
                {}};
    for (std::size_t i = 0; i < std::min(header.gauges.size(), series_colours.size()); ++i) {
        ChartSeries series{
            .name = header.gauges[i].name, .colour = series_colours[i], .points = {Vector2d::Zero()}};
        for (const StepReport& step : steps)
            series.points.emplace_back(step.gauges.at(i).displacement.norm(), step.load);
        chart.series.push_back(std::move(series));
    }
    return chart;
}

Chart size_chart(std::vector<Vector2d> sizes) {
    return {"Fragment sizes, last frame",
            {.name = "area at rest", .unit = "m\xc2\xb2", .logarithmic = true},
            {.name = "fragments as large or larger", .logarithmic = true},
            {{.name = "sizes", .colour = vermillion, .points = std::move(sizes), .dotted = true}}};
}

std::string heading(const Recording& recording, const RecordingHeader& header, const StepReport& last) {
    const std::string time = time_text(fmt::format("{:.4g}", last.time), header.time_unit);
    return fmt::format("{}, seed {}: {}, {}, {}, {}",
                       std::filesystem::path(header.scene_file).filename().string(), header.seed, time,
                       counted(last.step, "step"), counted(last.fragments, "fragment"), recording.end());
}

struct PlotOptions {
    std::filesystem::path input, output;
    StudyAxes axes;   ///< axes, for the table of a study
    std::string log;  ///< names of the logarithmic axes: "x", "y", "xy"; empty: none
    bool force = false;
};

std::string study_svg(PlotOptions options) {
    if (options.axes.x.empty() || options.axes.y.empty())
        throw Error(fmt::format("'{}' is a table: give the columns to draw, --x NAME and --y NAME",
                                options.input.string()));
    options.axes.log_x = options.log.find('x') != std::string::npos;
    options.axes.log_y = options.log.find('y') != std::string::npos;
    const StudyTable table = read_study_table(options.input);
    return page_svg({options.input.filename().string(), {study_chart(table, options.axes)}, 1, 640, 420});
}

std::string recording_svg(const std::filesystem::path& file) {
    const Recording recording(file);
    if (!recording.recovery().empty()) print_message("sherd: warning: {}\n", recording.recovery());
    return plot_svg(recording);
}

int plot(PlotOptions options) {
    const bool is_table = options.input.extension() == ".csv";
    if (options.output.empty())
        options.output = std::filesystem::path(options.input).replace_extension(".svg");
    if (!is_table && !(options.axes.x + options.axes.y + options.axes.by + options.log).empty())
        throw Error("--x, --y, --by and --log are for the table of a study (.csv)");
    require_kind(options.output, ".svg", "plots are SVG; name a .svg file");
    check_free(options.output, options.force, {options.input});
    const OutputLock lock(options.output);
    PendingFile pending(lock, Fault::input);
    pending.write(is_table ? study_svg(options) : recording_svg(options.input));
    pending.publish(options.force);
    print_result("{}\n", options.output.string());
    return 0;
}

}  // namespace

std::vector<Vector2d> crack_length(const Snapshot& last, const CrackEvents& events, double end) {
    std::vector<Vector2d> points{Vector2d::Zero()};
    const auto rest = [&](Index vertex) -> Vector3d {
        return last.rest.position.col(last.original.at(vertex));
    };
    for (const EdgeFailure& failure : events.failures) {
        const double length = (rest(failure.vertices[0]) - rest(failure.vertices[1])).norm();
        points.emplace_back(failure.time, points.back().y() + length);
    }
    points.emplace_back(std::max(end, points.back().x()), points.back().y());
    return points;
}

std::vector<Vector2d> fragment_sizes(const Snapshot& last) {
    std::map<Index, double> areas;
    for (std::size_t f = 0; f < last.faces.size(); ++f) areas[last.face_fragment[f]] += last.rest.area[f];
    std::vector<Vector2d> sizes;
    for (const auto& [fragment, area] : areas) sizes.emplace_back(area, 0);
    std::ranges::sort(sizes, {}, [](const Vector2d& size) { return size.x(); });
    for (std::size_t i = 0; i < sizes.size(); ++i) sizes[i].y() = static_cast<double>(sizes.size() - i);
    return sizes;
}

std::string plot_svg(const Recording& recording) {
    const RecordingHeader header = recording.header();
    const std::vector<StepReport> steps = recording.steps();
    const std::size_t frames = recording.frame_count();
    if (!recording.modes().empty())
        throw Error(
            "the recording shows modes of vibration, which have no time to plot over; sherd info lists them");
    if (steps.empty() || frames == 0)
        throw Error("nothing has been recorded yet, so there is nothing to plot");
    const Snapshot last = recording.frame(frames - 1);
    const CrackEvents events = recording.events();
    const Chart cracks{"Length of all cracks",
                       time_axis,
                       {.name = "length at rest", .unit = "m", .from_zero = true},
                       {{.name = "cracks",
                         .colour = vermillion,
                         .points = crack_length(last, events, steps.back().time),
                         .stepped = true}}};
    std::vector<Chart> charts{motion_chart(steps),   elastic_chart(steps),
                              fragment_chart(steps), cracks,
                              strain_chart(steps),   size_chart(fragment_sizes(last))};
    if (Chart balance = balance_chart(steps); !balance.series.empty()) charts.push_back(std::move(balance));
    if (!header.supports.empty()) charts.push_back(reaction_chart(header, steps));
    add_gauge_charts(charts, header, steps);
    add_tip_charts(charts, steps, events.tips);
    if (header.time_unit != "s") {
        for (Chart& chart : charts)
            if (chart.x.name == time_axis.name) chart.x = {.name = header.time_unit, .from_zero = true};
        if (!header.gauges.empty()) charts.push_back(load_chart(header, steps));
    }
    return page_svg({heading(recording, header, steps.back()), std::move(charts)});
}

void add_plot(CLI::App& program, Command& chosen) {
    CLI::App* command = program.add_subcommand(
        "plot", "Draw energies, fragments and cracks of a run over time, or columns of a study's table");
    auto options = std::make_shared<PlotOptions>();
    command->add_option("input", options->input, "Recording of a run, or table of a study (.h5 or .csv)")
        ->required()
        ->option_text("FILE");
    command
        ->add_option("--x", options->axes.x,
                     "For a table: the column on the x axis; the end of its name is enough")
        ->option_text("NAME");
    command->add_option("--y", options->axes.y, "For a table: the column on the y axis")->option_text("NAME");
    command
        ->add_option("--by", options->axes.by, "For a table: a column whose values are told apart by colour")
        ->option_text("NAME");
    command->add_option("--log", options->log, "For a table: logarithmic axes")
        ->check(CLI::IsMember({"x", "y", "xy"}))
        ->option_text("x|y|xy");
    command->add_option("-o,--output", options->output, "SVG file (default: beside the input)")
        ->option_text("FILE.svg");
    command->add_flag("--force", options->force, "Replace a file that exists");
    command->footer(
        "Examples:\n  sherd plot plate_drop.h5 -o plate.svg\n"
        "  sherd plot study.csv --x velocity --y fragments --log xy");
    command->callback([&chosen, options] { chosen = [options] { return plot(*options); }; });
}

}  // namespace sherd
