// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace sherd::python {

// Functions that add parts of the interface to the module, with docstrings.
void bind_error(pybind11::module_& module);
void bind_scene(pybind11::module_& module);
void bind_snapshot(pybind11::module_& module);
void bind_step_report(pybind11::module_& module);
void bind_simulation(pybind11::module_& module);
void bind_recording(pybind11::module_& module);
void bind_cut(pybind11::module_& module);
void bind_mechanics(pybind11::module_& module);

}  // namespace sherd::python
