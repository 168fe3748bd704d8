// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "app/python/bindings.h"
#include "app/python/tables.h"

namespace sherd::python {

void bind_step_report(py::module_& module) {
    using namespace recording_format;
    py::class_<StepReport> report(
        module, "StepReport",
        "What a step did, and the sheets and bodies at its end: the columns of /steps of a\n"
        "recording, with their units. Losses and work are since the start.");
    Table<StepReport>::visit([&]<class T>(const char* name, hdf5::Meaning meaning, T StepReport::*member) {
        const std::string about = std::string(meaning.description).empty()
                                      ? std::string(meaning.unit)
                                      : fmt::format("{}; {}", meaning.unit, meaning.description);
        report.def_property_readonly(
            name, [member](const StepReport& one) { return value_of(one.*member); }, about.c_str());
    });
    report.def("__repr__", [](const StepReport& one) {
        return fmt::format("<step {} to {:g}: {} fragments, {:g} J kinetic, {:g} J bending>", one.step,
                           one.time, one.fragments, one.kinetic, one.bending);
    });
}

}  // namespace sherd::python
