// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/shell/shell_case.h"

#include <fmt/format.h>

namespace sherd {
namespace {

/// The [solver] table. Cases with a single step have small loads and small displacements, for which a smaller
/// tolerance gives the same relative accuracy.
std::string solver_text(const ShellCase& one, const ShellVariant& variant) {
    const std::string models =
        fmt::format("bending = \"{}\"\n{}", variant.bending,
                    variant.membrane.empty() ? "" : fmt::format("membrane = \"{}\"\n", variant.membrane));
    if (!one.frequencies.empty()) return "[solver]\n" + models;
    return fmt::format(
        "[solver]\nscheme = \"static\"\nmax_iterations = 200\nstep = {}\narc_length = {}\ntolerance = {}\n{}",
        one.step, !one.limits.empty(), one.step < 1 ? 1e-6 : 1e-7, models);
}

}  // namespace

std::function<std::vector<ShellResult>(const Simulation&, const StepReport&)> energy_beside(
    double reference) {
    return [reference](const Simulation&, const StepReport& report) -> std::vector<ShellResult> {
        return {{"energy", report.bending + report.membrane, reference}};
    };
}

ShellVariant shell_variant(const std::string& model, double edge, bool structured) {
    const std::size_t plus = model.find('+');
    return {edge, structured, model.substr(0, plus), plus == std::string::npos ? "" : model.substr(plus + 1)};
}

std::vector<ShellCase> shell_cases() {
    std::vector<ShellCase> all = sze_cases();
    for (ShellCase& one : plate_cases()) all.push_back(std::move(one));
    all.push_back(plate_hole_case());
    for (ShellCase& one : hyperboloid_cases()) all.push_back(std::move(one));
    return all;
}

std::string scene_text(const ShellCase& one, const ShellVariant& variant) {
    std::string sheets = "[sheet.shell]\n" + one.sheet + one.rest;
    const std::string mesh =
        fmt::format("edge_length = {}, structured = {}", variant.edge, variant.structured);
    for (std::size_t at = 0; (at = sheets.find("MESH", at)) != std::string::npos;)
        sheets.replace(at, 4, mesh);
    return fmt::format("{}{}\n[force]\ngravity = [0, 0, 0]\n[contact]\nsheets = false\n{}",
                       one.frequencies.empty() ? "" : "duration = 1\n", sheets, solver_text(one, variant));
}

}  // namespace sherd
