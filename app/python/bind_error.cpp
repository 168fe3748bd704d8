// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/bindings.h"
#include "meshops/error.h"

namespace sherd::python {
namespace {

namespace py = pybind11;

constexpr const char* description =
    "An error, with the message that the program would print: what is wrong, where, and what\n"
    "to do.\n"
    "\n"
    "`fault` is \"input\" (a scene, an array or a file is wrong) or \"run\" (a step cannot be\n"
    "solved, a disk is full).";

}  // namespace

void bind_error(py::module_& module) {
    module.attr("Error") = py::reinterpret_steal<py::object>(
        PyErr_NewExceptionWithDoc("sherd.Error", description, nullptr, nullptr));
    // NOLINTNEXTLINE(performance-unnecessary-value-param): the signature is pybind11's
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const Error& error) {
            const py::object type = py::module_::import("sherd._sherd").attr("Error");
            const py::object instance = type(error.what());
            instance.attr("fault") = error.fault == Fault::input ? "input" : "run";
            PyErr_SetObject(type.ptr(), instance.ptr());
        }
    });
}

}  // namespace sherd::python
