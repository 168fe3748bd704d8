// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sherd {

/// Bending energies, a Jacobian and a method, with which the steps of a scene are solved.
struct SolverChoice {
    std::string name;      ///< method, unless it is Newton's, and (energy, Jacobian) as in Cubic Shells
    std::string energies;  ///< name of the energies; choices with the same energies have the same solutions
    std::string beside;    ///< name of the choice with whose cost this one is compared; may be itself
    std::vector<std::string> settings;  ///< KEY=VALUE, as for `sherd run --set`
    bool exact = true;                  ///< whether the Jacobian is that of the energies
    std::string colour;                 ///< colour of the choice's line in charts, as in SVG
    bool dashed = false;                ///< whether this line is dashed

    bool is_coupled() const { return energies == "coupled"; }
};

/// All choices; a choice comes after the one with which it is compared.
std::vector<SolverChoice> solver_choices();

/// The exact choices with `only` in their names. Throws Error if there is none.
std::vector<SolverChoice> exact_choices(const std::string& only);

/// The choice of this name. Throws std::logic_error if there is none.
const SolverChoice& choice_named(const std::vector<SolverChoice>& choices, const std::string& name);

/// Index of the choice with which choices[i] is compared (SolverChoice::beside).
std::size_t place_beside(const std::vector<SolverChoice>& choices, std::size_t i);

}  // namespace sherd
