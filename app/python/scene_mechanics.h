// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/scene/build/built_scene.h"
#include "core/forces/shell_energies.h"

namespace sherd::python {

/// Elastic energy of a scene's sheets as a function of the positions of their vertices, [3, V] m, with the
/// exact second derivative, and without supports.
class SceneMechanics {
  public:
    explicit SceneMechanics(const Scene& scene);
    SceneMechanics(const SceneMechanics&) = delete;  // the energies refer to the shell

    const Shell& shell() const { return built.sheets.mechanics(); }
    const std::vector<std::string>& warnings() const { return warning_list; }

    /// Returns the positions. Throws Error if there are not V.
    Positions placed(Positions positions) const;
    struct Parts {
        double bending, membrane;  ///< J
    };
    Parts energies(const Positions& x);
    Positions gradient(const Positions& x);
    BlockMatrix hessian(const Positions& x);
    FaceFields fields(const Positions& x);

  private:
    std::vector<std::string> warning_list;
    BuiltScene built;
    ShellEnergies all;
};

}  // namespace sherd::python
