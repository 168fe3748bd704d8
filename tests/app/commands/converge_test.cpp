// SPDX-License-Identifier: GPL-3.0-or-later
// `sherd converge`: users would trust a wrong order of convergence or a wrong limit more than the results.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/converge/observed_order.h"
#include "app/converge/run_results.h"
#include "tests/support/program/built_text.h"
#include "tests/support/program/message_thrown_by.h"

namespace sherd::test {
namespace {

TEST(Convergence, FindsOrderLimitAndError) {
    for (const double order : {1.0, 2.0, 3.5}) {
        const auto value = [&](double length) { return 7 + 0.1 * std::pow(length, order); };
        const Convergence found = convergence({value(4), value(2), value(1)});
        ASSERT_TRUE(found.order);
        EXPECT_NEAR(*found.order, order, 1e-9);
        EXPECT_NEAR(*found.limit, 7, 1e-9);
        EXPECT_NEAR(*found.error, 0.1 / 7, 1e-9);
    }
}

TEST(Convergence, ClaimsNothingWhereThereIsNone) {
    EXPECT_FALSE(convergence({1, 2, 1}).order) << "to and fro";
    EXPECT_FALSE(convergence({1, 2, 4}).order) << "away";
    EXPECT_FALSE(convergence({1, 2, 3}).order) << "straight on";
    EXPECT_FALSE(convergence({1, 1, 1}).order);
    EXPECT_FALSE(convergence({1, 2, 2}).error) << "there is no error that could be told";
}

const std::string strip = R"([sheet.strip]
mesh = { generate = "rectangle", width = 1, height = 0.25, edge_length = 0.0625, structured = true }
material = { density = 1000, thickness = 0.01, young = 1e9, poisson = 0 }
clamp = { box = [[-1, -1, -1], [1e-6, 2, 1]] }
[[gauge]]
name = "tip"
at = [1, 0.125, 0]
[force]
gravity = [0, 0, -0.01]
[solver]
scheme = "static"
step = 0.25
bending = "coupled"
)";

TEST(RunResults, OfCoupledHingesIsOfSecondOrderInTheEdges) {
    const Scene scene = built_from(strip).scene;
    std::array<double, 3> tip;
    const std::array<double, 3> times{4, 2, 1};
    for (std::size_t i = 0; i < 3; ++i) {
        const RunResults results = results_of(with_edges(scene, times[i]));
        EXPECT_EQ(results.steps, 4);
        EXPECT_EQ(results.quantities[0].name, "tip, at the end");
        tip[i] = results.quantities[0].value;
    }
    const Convergence found = convergence(tip);
    ASSERT_TRUE(found.order) << tip[0] << " " << tip[1] << " " << tip[2];
    EXPECT_NEAR(*found.order, 2, 0.7);
    // Deflection of a cantilever, q L^4 / (8 D), with q = 0.1 Pa and D = 250 / 3 N m
    EXPECT_NEAR(*found.limit, 0.1 / 8 * 3 / 250, 0.02 * 1.5e-4);
}

Quantity quantity(const RunResults& results, const std::string& name) {
    const auto found = std::ranges::find(results.quantities, name, &Quantity::name);
    if (found == results.quantities.end()) throw std::runtime_error("no quantity is " + name);
    return *found;
}

// A gauge of stress records no displacement: once a displacement of 0 m was reported instead of the stress.
TEST(RunResults, OfAGaugeOfStressIsItsComponentsAndThePrincipalOneInPascal) {
    std::string text = strip;
    text.replace(text.find("at = [1, 0.125, 0]"), 18, "at = [0.51, 0.13, 0]\nrecord = [\"stress\"]");
    const RunResults results = results_of(built_from(text).scene);
    EXPECT_EQ(results.quantities[0].name, "tip, stress top 00, at the end");
    EXPECT_EQ(results.quantities[0].unit, "Pa");
    const Quantity principal = quantity(results, "tip, principal stress, at the end");
    EXPECT_EQ(principal.unit, "Pa");
    EXPECT_EQ(quantity(results, "tip, principal stress, largest").value, principal.value) << "the load grows";
    // Bending stress of a cantilever, 3 q (L - x)^2 / t^2, with q = 0.1 Pa, on the tensile side; a face is
    // 0.06 L long
    EXPECT_NEAR(principal.value, 3 * 0.1 * 0.49 * 0.49 / 1e-4, 0.3 * 720);
}

TEST(RunResults, StepsAndMeshesThatCannotBeCoarserSaySo) {
    const Scene scene = built_from(strip).scene;
    EXPECT_EQ(with_steps(scene, 2).simulation.stepper.step, 0.5);
    EXPECT_NE(message_thrown_by([&] { with_steps(scene, 8); }).find("longer than the run"),
              std::string::npos);
    Scene from_file = scene;
    from_file.sheets[0].mesh = MeshFile{.path = "strip.obj", .remesh = {}};
    EXPECT_NE(message_thrown_by([&] { with_edges(from_file, 2); }).find("remesh"), std::string::npos);
}

}  // namespace
}  // namespace sherd::test
