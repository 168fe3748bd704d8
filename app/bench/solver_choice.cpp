// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/solver_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "meshops/error.h"

namespace sherd {
namespace {

const std::vector<std::string> nonlinear{"solver.bending=nonlinear"}, cubic{"solver.bending=cubic"},
    coupled{"solver.bending=coupled"};

std::vector<std::string> with(std::vector<std::string> settings, const std::string& setting) {
    settings.push_back(setting);
    return settings;
}

}  // namespace

std::vector<SolverChoice> solver_choices() {
    const std::string constant_jacobian = "solver.jacobian=constant",
                      cubic_jacobian = "solver.jacobian=cubic";
    return {
        {.name = "(NH, NH)",
         .energies = "NH",
         .beside = "(NH, NH)",
         .settings = nonlinear,
         .colour = "#000000"},
        {.name = "(NH, CS)",
         .energies = "NH",
         .beside = "(NH, NH)",
         .settings = with(nonlinear, cubic_jacobian),
         .exact = false,
         .colour = "#e69f00"},
        {.name = "(NH, CC)",
         .energies = "NH",
         .beside = "(NH, NH)",
         .settings = with(nonlinear, constant_jacobian),
         .exact = false,
         .colour = "#f0c800"},
        {.name = "(CS, CS)", .energies = "CS", .beside = "(NH, NH)", .settings = cubic, .colour = "#009e73"},
        {.name = "(CS, CC)",
         .energies = "CS",
         .beside = "(NH, NH)",
         .settings = with(cubic, constant_jacobian),
         .exact = false,
         .colour = "#56b4e9"},
        {.name = "coupled",
         .energies = "coupled",
         .beside = "coupled",
         .settings = coupled,
         .colour = "#cc79a7",
         .dashed = true},
    };
}

std::vector<SolverChoice> exact_choices(const std::string& only) {
    std::vector<SolverChoice> choices = solver_choices();
    std::erase_if(choices, [](const SolverChoice& choice) { return !choice.exact; });
    std::string names;
    for (const SolverChoice& choice : choices) names += "\n  " + choice.name;
    std::erase_if(choices,
                  [&](const SolverChoice& choice) { return choice.name.find(only) == std::string::npos; });
    if (choices.empty())
        throw Error(
            fmt::format("--only {}: no choice of a solver has this in its name; there are:{}", only, names));
    return choices;
}

const SolverChoice& choice_named(const std::vector<SolverChoice>& choices, const std::string& name) {
    const auto found = std::ranges::find(choices, name, &SolverChoice::name);
    if (found == choices.end()) throw std::logic_error("no solver choice " + name);
    return *found;
}

std::size_t place_beside(const std::vector<SolverChoice>& choices, std::size_t i) {
    return static_cast<std::size_t>(&choice_named(choices, choices[i].beside) - choices.data());
}

}  // namespace sherd
