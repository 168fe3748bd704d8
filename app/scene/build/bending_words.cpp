// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/build/bending_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/bending/coupled_cubic_bending.h"

namespace sherd {

std::string bending_words(const BuiltScene& built) {
    const ShellEnergyOptions& options = built.options.stepper.shell;
    if (options.bending.model != BendingModel::coupled_cubic) return {};
    using Form = CoupledCubicBending::Form;
    const CoupledCubicBending bending(built.sheets.mechanics(), options.mirrors);
    const auto count = [&](Form form) { return std::ranges::count(bending.forms(), form); };
    std::string words = fmt::format("bending: {} of {} faces as a polynomial", count(Form::polynomial),
                                    bending.forms().size());
    const char* separator = "; in true angles ";
    const auto add = [&](Form form, const char* reason) {
        if (const auto faces = count(form); faces > 0) {
            words += fmt::format("{}{} {}", separator, faces, reason);
            separator = ", ";
        }
    };
    add(Form::thick, "thicker than a quarter of their shortest side");
    add(Form::crease, "at folds of 45 degrees and more");
    add(Form::unsuited, "that turn by more than 60 degrees to the next but one");
    add(Form::beside_mirror, "at clamps and symmetry planes");
    return words + "\n";
}

}  // namespace sherd
