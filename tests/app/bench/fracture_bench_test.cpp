// SPDX-License-Identifier: GPL-3.0-or-later
// Compares cracks that grow, and bending waves that a break releases, with theory, on the coarsest mesh of
// each experiment: if tips were evaluated, turned or arrested wrongly, cracks took a wrong energy, or bending
// waves were too fast, the tables of docs/theory/fracture.md would be wrong.
#include <gtest/gtest.h>

#include "app/bench/fracture/fracture_run.h"

namespace sherd::test {
namespace {

struct FractureBound {
    const char* name;
    std::vector<double> bounds;  ///< largest difference of each number from theory
};

class FractureBench : public testing::TestWithParam<FractureBound> {};

TEST_P(FractureBench, OfTheCoarsestMeshIsNearTheory) {
    const auto& [name, bounds] = GetParam();
    for (const FractureCase& one : fracture_cases()) {
        if (one.name != name) continue;
        const FractureRun run = run_fracture(one, one.edges.front(), 1);
        EXPECT_EQ(run.failure, "");
        ASSERT_EQ(run.values.size(), bounds.size());
        for (std::size_t i = 0; i < bounds.size(); ++i)
            EXPECT_NEAR(run.values[i], one.numbers[i].theory, bounds[i]) << one.numbers[i].name;
        return;
    }
    FAIL() << "no such case";
}

INSTANTIATE_TEST_SUITE_P(Cases, FractureBench,
                         testing::Values(FractureBound{"centre crack at 0 degrees", {0.03, 0.01, 0.07, 1}},
                                         FractureBound{"centre crack at 30 degrees", {0.03, 0.04, 0.07, 1}},
                                         FractureBound{"centre crack at 60 degrees", {0.03, 0.04, 0.07, 1}},
                                         FractureBound{"edge notch, a / W = 0.4", {0.07, 0.07}},
                                         FractureBound{"bent plate with a centre crack", {0.04, 0.04}},
                                         FractureBound{"double cantilever", {0.06, 0.5, 0.1}},
                                         FractureBound{"notch and offset hole", {0.005}},
                                         FractureBound{"branching", {0.02, 0, 0.4, 8}},
                                         FractureBound{"released strip", {0.03, 0.05}},
                                         FractureBound{"released strip with a scored line", {0.03, 1e-9}}));

// Two random meshes must give the same crack path, or paths would depend on the mesh.
TEST(FractureBenchPaths, OfTwoMeshesAreTheSame) {
    const FractureCase hole = offset_hole();
    const FractureRun one = run_fracture(hole, hole.edges.front(), 1),
                      other = run_fracture(hole, hole.edges.front(), 2);
    ASSERT_GT(one.path.size(), 10u);
    EXPECT_NEAR(one.path.back().x(), 0.12, 1e-9) << "the other side";
    EXPECT_LT(largest_distance({one.path, other.path}), 0.5 * hole.edges.front());
}

TEST(FractureBenchPaths, LargestDistanceIsThatOfPointsFromPaths) {
    const std::vector<Vector2d> straight{{0, 0}, {3, 0}}, bent{{0, 0}, {1, 0.2}, {3, 0}};
    EXPECT_EQ(largest_distance({straight, straight}), 0);
    EXPECT_DOUBLE_EQ(largest_distance({straight, bent}), 0.2);
}

}  // namespace
}  // namespace sherd::test
