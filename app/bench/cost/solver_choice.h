// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sherd {

/// A way to solve the steps of a scene.
struct SolverChoice {
    std::string name;                   ///< as the paper has it: (energy, Jacobian)
    std::string energies;               ///< choices of one kind end a step at the same positions
    std::string beside;                 ///< name of the choice that its cost is compared with
    std::vector<std::string> settings;  ///< KEY=VALUE, as of `sherd run --set`
    bool exact = true;                  ///< whether the Jacobian is that of its energies
    std::string colour;                 ///< colour of its line, as in SVG
    bool dashed = false;

    bool is_coupled() const { return energies == "coupled"; }
};

/// All that are compared; each comes after the one that it is compared with.
std::vector<SolverChoice> solver_choices();

/// Choices with the Jacobian of their energies and with `only` in their names. Throws Error if there is none.
std::vector<SolverChoice> exact_choices(const std::string& only);

/// The choice of this name. Throws std::logic_error if there is none.
const SolverChoice& choice_named(const std::vector<SolverChoice>& choices, const std::string& name);

/// Place of the choice beside which the i-th one stands.
std::size_t place_beside(const std::vector<SolverChoice>& choices, std::size_t i);

}  // namespace sherd
