// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include "app/python/bindings.h"
#include "app/python/without_lock.h"

// NOLINTNEXTLINE: the macro is pybind11's.
PYBIND11_MODULE(_sherd, module) {
    using namespace sherd::python;
    namespace py = pybind11;
    module.doc() = "The compiled part of sherd: see help(sherd).";
    module.attr("__version__") = SHERD_VERSION;
    py::options options;
    options.disable_function_signatures();  // docstrings have shorter signatures
    bind_error(module);
    bind_scene(module);
    bind_snapshot(module);
    bind_step_report(module);
    bind_simulation(module);
    bind_recording(module);
    bind_cut(module);
    bind_mechanics(module);
    py::module_::import("atexit").attr("register")(py::cpp_function(end_of_python));
}
