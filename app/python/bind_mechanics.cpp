// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/scene/assemble/built_scene.h"
#include "core/bending/bending.h"
#include "core/forces/shell_energies.h"
#include "meshops/error.h"

namespace sherd::python {
namespace {

/// Elastic energy of a scene's sheets as a function of the positions of their vertices, [3, V] m, with the
/// exact second derivative, and without supports.
class SceneMechanics {
  public:
    explicit SceneMechanics(const Scene& scene);
    SceneMechanics(const SceneMechanics&) = delete;  // the energies refer to the shell

    const Shell& shell() const { return built.sheets.mechanics(); }
    const std::vector<std::string>& warnings() const { return warning_list; }

    /// Returns `positions`. Throws Error unless there are as many as vertices, V.
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

/// Returns options with the exact second derivative of the energy.
ShellEnergyOptions exact(ShellEnergyOptions options) {
    options.bending.jacobian = exact_jacobian(options.bending.model);
    return options;
}

SceneMechanics::SceneMechanics(const Scene& scene)
    : built(build_scene(scene, warning_list)), all(shell(), exact(built.options.stepper.shell)) {
    const StepContext start{0, 0, 0, shell().position, shell().velocity, {}};
    for (Energy* energy : all.elastic()) energy->begin(start);
}

Positions SceneMechanics::placed(Positions positions) const {
    if (positions.cols() != shell().position.cols())
        throw Error(fmt::format("positions: has {} rows, and the sheets have {} vertices", positions.cols(),
                                shell().position.cols()));
    return positions;
}

SceneMechanics::Parts SceneMechanics::energies(const Positions& x) {
    return {all.bending_value(x), all.membrane_value(x)};
}

Positions SceneMechanics::gradient(const Positions& x) {
    Positions sum = Positions::Zero(3, x.cols());
    for (const Energy* energy : all.elastic()) energy->add_gradient(x, sum);
    return sum;
}

BlockMatrix SceneMechanics::hessian(const Positions& x) {
    std::vector<std::pair<Index, Index>> pairs;
    for (const Energy* energy : all.elastic()) energy->add_pattern(pairs);
    const auto vertices = static_cast<Index>(x.cols());
    BlockMatrix sum(vertices, pairs, std::vector<char>(static_cast<std::size_t>(vertices), 0));
    for (const Energy* energy : all.elastic()) energy->add_hessian(x, Curvature::exact, sum);
    return sum;
}

FaceFields SceneMechanics::fields(const Positions& x) {
    return face_fields(shell(), all.face_strains(x), all.face_curvatures(x), {true, true, true});
}

/// Returns the lower triangle of the energy's second derivative in the form of scipy.sparse.csc_matrix:
/// values, rows, starts of columns.
py::tuple hessian(SceneMechanics& mechanics, const Numbers& positions) {
    const BlockMatrix matrix = mechanics.hessian(mechanics.placed(columns_of(positions, "positions")));
    const auto list = [](auto span) { return numbers(span.data(), span.size(), 1); };
    return py::make_tuple(list(matrix.values()), list(matrix.rows()), list(matrix.columns()));
}

py::dict fields(SceneMechanics& mechanics, const Numbers& positions) {
    const FaceFields found = mechanics.fields(mechanics.placed(columns_of(positions, "positions")));
    py::dict by_name;
    visit_fields(found, [&](const char* name, const Eigen::Matrix3Xd& values, const FieldMeaning&) {
        by_name[name] = array_of(values);
    });
    return by_name;
}

}  // namespace

void bind_mechanics(py::module_& module) {
    using M = SceneMechanics;
    py::class_<M>(module, "Mechanics", "The elasticity of a scene's sheets, without time.")
        .def(py::init<const Scene&>(), py::arg("scene"))
        .def_property_readonly("warnings", &M::warnings, "Warnings about the scene, as sentences.")
        .def_property_readonly(
            "rest_positions", [](const M& one) { return array_of(one.shell().rest); }, "[V, 3] m, a copy.")
        .def_property_readonly(
            "positions", [](const M& one) { return array_of(one.shell().position); },
            "[V, 3] m, where the scene starts, a copy.")
        .def_property_readonly(
            "masses", [](const M& one) { return array_of(one.shell().mass); }, "[V] kg, lumped, a copy.")
        .def_property_readonly(
            "faces", [](const M& one) { return array_of(corners_of(one.shell())); },
            "[F, 3] vertices, a copy.")
        .def(
            "energies",
            [](M& one, const Numbers& positions) {
                const auto [bending, membrane] = one.energies(one.placed(columns_of(positions, "positions")));
                py::dict parts;
                parts["bending"] = bending;
                parts["membrane"] = membrane;
                return parts;
            },
            py::arg("positions"),
            "energies(positions) -> dict\n"
            "\n"
            "Returns the energies, J, of \"bending\" and \"membrane\", at positions [V, 3] m.")
        .def(
            "gradient",
            [](M& one, const Numbers& positions) {
                return array_of(one.gradient(one.placed(columns_of(positions, "positions"))));
            },
            py::arg("positions"),
            "gradient(positions) -> array\n"
            "\n"
            "Returns the derivative of the energy by the positions, [V, 3] N, at positions [V, 3] m: minus\n"
            "the force. Pins and clamps have no effect here.")
        .def("_hessian", &hessian, py::arg("positions"))
        .def("fields", &fields, py::arg("positions"),
             "fields(positions) -> dict\n"
             "\n"
             "Returns fields of each face at positions [V, 3] m, as in Snapshot: \"curvature\",\n"
             "\"membrane_strain\", \"stress_top\", \"stress_bottom\", [F, 3] each.");
}

}  // namespace sherd::python
