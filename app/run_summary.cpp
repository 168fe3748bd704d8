// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run_summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/messages/counted.h"
#include "app/messages/time_text.h"
#include "app/peak_table.h"
#include "app/scene/build/crack_step_message.h"
#include "app/scene/build/yield_message.h"

namespace sherd {
namespace {

void add_row(std::string& text, const char* name, const std::string& value) {
    text += fmt::format("{:<22}{}\n", name, value);
}

void add_peaks(std::string& text, const RunTotals& totals) {
    add_row(text, "peak strain",
            fmt::format("{:.4g} 1/m (of bending alone: {:.4g} 1/m)", totals.peaks.peak_strain,
                        totals.peaks.peak_bending_strain));
    add_row(text, "peak stress", fmt::format("{:.4g} Pa", totals.peaks.peak_stress));
    if (totals.peaks.peak_overload > 0)
        add_row(text, "peak overload", fmt::format("{:.4g} times the strength", totals.peaks.peak_overload));
}

void add_yield(std::string& text, const RunTotals& totals, const Scene& scene) {
    const StepReport& peaks = totals.peaks;
    if (!(peaks.peak_yield > 0)) return;
    add_row(text, "peak yield", yield_message(peaks.peak_yield, peaks.yielding, scene));
    if (!std::isfinite(totals.yielded_at)) return;
    const bool keeps = bends_plastically(scene, scene.sheets[peaks.yielding.sheet]);
    add_row(
        text, keeps ? "keeps a dent" : "would keep a dent",
        fmt::format("from {} on{}", time_text(fmt::format("{:.4g}", totals.yielded_at), scene.time_unit()),
                    keeps ? "" : "; here it springs back"));
}

/// Number and size of the steps; steps that were halved or cut are shorter than the scene's.
std::string step_words(const RunTotals& totals, const Scene& scene, const char* unit) {
    constexpr double rounding = 1e-9;
    const double whole = static_cast<double>(totals.last.step) * scene.simulation.stepper.step;
    const bool is_cut = !scene.is_static() && totals.last.time < whole * (1 - rounding);
    return fmt::format("{} of {}{:g}{}", totals.last.step, is_cut ? "at most " : "",
                       scene.simulation.stepper.step, unit);
}

std::string load_words(const LoadHistory& load) {
    std::string words = fmt::format("{:.6g} at the end", load.last);
    if (load.limit) words += fmt::format(", fell for the first time at {:.6g}", *load.limit);
    return words;
}

/// Duration, number and causes of the phases of explicit steps between implicit ones, and the number of times
/// that explicit steps failed.
std::string explicit_words(const RunTotals& totals) {
    constexpr std::array<std::pair<Urgency, const char*>, 5> names{{{Urgency::strike, "strikes"},
                                                                    {Urgency::stress, "stress"},
                                                                    {Urgency::crack, "cracks"},
                                                                    {Urgency::unsolved, "unsolved steps"},
                                                                    {Urgency::passage, "passages"}}};
    std::vector<std::string> causes;
    for (const auto& [urgency, name] : names)
        if (const auto times = totals.urgencies[static_cast<std::size_t>(urgency)]; times > 0)
            causes.push_back(fmt::format("{} {}", name, times));
    std::string words = fmt::format("{:g} s of simulated time", totals.explicit_time);
    if (!causes.empty()) words += fmt::format("; started by: {}", fmt::join(causes, ", "));
    if (const auto times = totals.urgencies[static_cast<std::size_t>(Urgency::explicit_failed)]; times > 0)
        words += fmt::format("; {} they failed, and implicit steps continued",
                             times == 1 ? "once" : counted(times, "time"));
    return words;
}

/// Adds a row if the time scheme has increased the energy: it should only dissipate, so it does not suit the
/// scene.
void add_made_energy(std::string& text, const RunTotals& totals, const Scene& scene) {
    constexpr double much = 0.1;  // share of the largest energy
    const double made = -totals.last.lost_to_scheme;
    if (!scene.is_static() && made > much * totals.largest_energy)
        add_row(text, "energy gained",
                fmt::format("{:.3g} J, an error of the time scheme; the largest energy is {:.3g} J: use "
                            "shorter steps, or another solver.scheme",
                            made, totals.largest_energy));
}

std::vector<std::string> untouched_obstacles(const Scene& scene, const Simulation& simulation) {
    std::vector<std::string> names;
    for (std::size_t o = 0; o < scene.obstacles.size(); ++o)
        if (!simulation.touched_obstacles()[o]) names.push_back(scene.obstacles[o].name);
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        if (!simulation.touched_bodies()[b]) names.push_back(scene.bodies[b].name);
    return names;
}

}  // namespace

std::string run_summary(const RunTotals& totals, const RunEnd& end, const std::filesystem::path& recording,
                        const Scene& scene, const Simulation& simulation) {
    std::string text;
    add_row(text, "run", end.how);
    add_row(text, "recording", recording.string());
    const char* unit = scene.is_static() ? "" : " s";
    add_row(text, "steps", step_words(totals, scene, unit));
    if (scene.is_static())
        add_row(text, "load", load_words(totals.load));
    else
        add_row(text, "simulated time", fmt::format("{:g} s", totals.last.time));
    add_row(text, "wall time", fmt::format("{:.1f} s", end.wall_seconds));
    if (scene.simulation.alternates) add_row(text, "explicit steps", explicit_words(totals));
    add_row(
        text,
        scene.simulation.stepper.scheme == Scheme::explicit_differences ? "substeps" : "Newton iterations",
        fmt::format("{} ({:.2f} a step)", totals.newton_iterations,
                    static_cast<double>(totals.newton_iterations) /
                        static_cast<double>(std::max<std::int64_t>(1, totals.last.step))));
    add_row(text, "cracked edges", fmt::format("{}", totals.cracks));
    if (const auto words = crack_step_message(scene, simulation.shell());
        simulation.grown_edges() > 0 && !words.empty())
        add_row(text, "cracks run", words);
    add_row(text, "fragments", fmt::format("{}", totals.last.fragments));
    add_peaks(text, totals);
    add_yield(text, totals, scene);
    if (totals.halvings > 0)
        add_row(
            text, "steps halved",
            fmt::format("{}, down to {:g}{}", counted(totals.halvings, "time"), totals.smallest_step, unit));
    if (simulation.prevented_failures() > 0)
        add_row(text, "failures forbidden",
                fmt::format("{}, which would have made pieces below fracture.smallest",
                            simulation.prevented_failures()));
    if (totals.capped > 0) add_row(text, "steps at stage limit", fmt::format("{}", totals.capped));
    add_made_energy(text, totals, scene);
    if (totals.cracks == 0 && totals.last.step > 0) text += peak_table(peak_rows(scene, simulation));
    if (const auto names = untouched_obstacles(scene, simulation); !names.empty())
        add_row(text, "nothing touched", fmt::format("obstacle.{}", fmt::join(names, ", obstacle.")));
    return text;
}

}  // namespace sherd
