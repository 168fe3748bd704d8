// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/cost/solver_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "meshops/error.h"

namespace sherd {
namespace {

/// A model of hinges: the name of its energies, the name of its choice with Newton's method, the name of the
/// choice with which it is compared, and its setting. The Jacobian is that of the energies, unless a further
/// setting chooses another.
struct Hinges {
    std::string energies, pairing, beside, bending;
};

const Hinges nonlinear{"NH", "(NH, NH)", "(NH, NH)", "solver.bending=nonlinear"},
    cubic{"CS", "(CS, CS)", "(NH, NH)", "solver.bending=cubic"},
    coupled{"coupled", "coupled", "coupled", "solver.bending=coupled"};

/// Newton's method with a pairing (energy, Jacobian) of the paper in which the Jacobian is not that of the
/// energy. jacobian: setting for it.
SolverChoice inexact(const Hinges& hinges, const char* pairing, const char* jacobian, const char* colour) {
    return {.name = pairing,
            .energies = hinges.energies,
            .beside = hinges.beside,
            .settings = {hinges.bending, jacobian, "solver.method=newton"},
            .exact = false,
            .colour = colour};
}

SolverChoice with_method(const Hinges& hinges, const char* method, const char* name, const char* colour) {
    return {.name = fmt::format("{}{}", name, hinges.pairing),
            .energies = hinges.energies,
            .beside = hinges.beside,
            .settings = {hinges.bending, fmt::format("solver.method={}", method)},
            .colour = colour,
            .dashed = hinges.energies == "coupled"};
}

}  // namespace

std::vector<SolverChoice> solver_choices() {
    return {with_method(nonlinear, "newton", "", "#000000"),
            inexact(nonlinear, "(NH, CS)", "solver.jacobian=cubic", "#e69f00"),
            inexact(nonlinear, "(NH, CC)", "solver.jacobian=constant", "#f0c800"),
            with_method(cubic, "newton", "", "#009e73"),
            inexact(cubic, "(CS, CC)", "solver.jacobian=constant", "#56b4e9"),
            with_method(nonlinear, "quasi-newton", "quasi-newton ", "#d55e00"),
            with_method(cubic, "quasi-newton", "quasi-newton ", "#0072b2"),
            with_method(coupled, "newton", "", "#000000"),
            with_method(coupled, "quasi-newton", "quasi-newton ", "#cc79a7")};
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
