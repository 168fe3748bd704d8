// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/run/peak_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sherd {
namespace {

constexpr std::array shares{0.5, 0.9, 0.99, 0.999, 1.0};

const char* words(Measure measure) {
    switch (measure) {
        case Measure::stress:
            return "stress, Pa";
        case Measure::bending:
            return "bending strain, 1/m";
        default:
            return "strain, 1/m";
    }
}

/// Rounds x > 0 down to one significant digit.
double rounded_down(double x) {
    const double digit = std::pow(10.0, std::floor(std::log10(x)));
    return std::floor(x / digit) * digit;
}

std::size_t count_over(std::span<const double> peaks, double threshold) {
    return static_cast<std::size_t>(peaks.end() - std::upper_bound(peaks.begin(), peaks.end(), threshold));
}

std::string threshold_line(const PeakRow& row) {
    std::vector<std::string> counts;
    for (const double threshold : round_thresholds(row.peaks))
        counts.push_back(fmt::format("{:g}: {}", threshold, count_over(row.peaks, threshold)));
    return fmt::format("  of its {} hinges over {}\n", row.peaks.size(), fmt::join(counts, ", over "));
}

}  // namespace

double peak_quantile(std::span<const double> peaks, double share) {
    const double place = std::ceil(share * static_cast<double>(peaks.size()) - 1e-9);
    return peaks[static_cast<std::size_t>(std::max(place, 1.0)) - 1];
}

std::vector<double> round_thresholds(std::span<const double> peaks) {
    std::vector<double> thresholds;
    for (const double share : {0.999, 0.99, 0.9}) {
        const double peak = peak_quantile(peaks, share);
        if (!(peak > 0)) continue;
        const double threshold = rounded_down(peak);
        const bool new_one = thresholds.empty() || threshold < thresholds.back();
        if (new_one && count_over(peaks, threshold) > 0) thresholds.push_back(threshold);
    }
    return thresholds;
}

std::vector<PeakRow> peak_rows(const Scene& scene, const Simulation& simulation) {
    const BreakableShell& sheet = simulation.shell();
    const HingeMeasures& peaks = simulation.peaks().of_edges();
    std::vector<PeakRow> rows;
    for (std::size_t s = 0; s < scene.sheets.size(); ++s) {
        const SheetSpec& spec = scene.sheets[s];
        const double threshold = spec.fracture ? spec.fracture->strength.along : 1;
        std::vector<Measure> measures{Measure::stress, Measure::strain};
        if (spec.fracture) measures = {spec.fracture->strength.measure};
        for (const Measure measure : measures) {
            PeakRow row{spec.name, words(measure), {}};
            const double compression =
                spec.fracture && measure == Measure::stress ? spec.material.tempered : 0;
            for (std::size_t hinge = 0; hinge < sheet.mechanics().hinges.size(); ++hinge) {
                const Edge edge = sheet.edge_of_hinge(hinge);
                if (sheet.sheet_of(edge) != static_cast<Index>(s)) continue;
                const double factor = spec.fracture ? (sheet.strength(edge) - compression) / threshold : 1;
                const bool is_evaluated = static_cast<Eigen::Index>(edge) < peaks.strain.size();
                const double peak = is_evaluated ? peaks.of(measure, static_cast<Index>(edge)) : 0;
                row.peaks.push_back(peak > compression ? (peak - compression) / factor : 0);
            }
            std::sort(row.peaks.begin(), row.peaks.end());
            if (!row.peaks.empty()) rows.push_back(std::move(row));
        }
    }
    return rows;
}

std::string peak_table(std::span<const PeakRow> rows) {
    std::size_t width = 22;
    for (const PeakRow& row : rows) width = std::max(width, row.name.size() + row.measure.size() + 4);
    std::string text = fmt::format("{:<{}}{:>10}{:>10}{:>10}{:>10}{:>10}\n", "peaks of hinges", width, "50 %",
                                   "90 %", "99 %", "99.9 %", "largest");
    for (const PeakRow& row : rows) {
        text += fmt::format("{:<{}}", fmt::format("  {} {}", row.name, row.measure), width);
        for (const double share : shares) text += fmt::format("{:>10.3g}", peak_quantile(row.peaks, share));
        text += '\n';
        if (row.peaks.back() > 0) text += threshold_line(row);
    }
    return text;
}

}  // namespace sherd
