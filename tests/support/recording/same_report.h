// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <tuple>

#include "fracture/record/events.h"
#include "fracture/step/step_report.h"

namespace sherd::test {

template <class T>
bool same_bits(const T* a, const T* b, std::size_t count) {
    return count == 0 || std::memcmp(a, b, count * sizeof(T)) == 0;
}
template <class Matrix>
requires requires(Matrix m) {
    m.cols();
}
bool same(const Matrix& a, const Matrix& b) {
    return a.size() == b.size() && same_bits(a.data(), b.data(), static_cast<std::size_t>(a.size()));
}
template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && same_bits(a.data(), b.data(), a.size());
}
inline bool same(double a, double b) {
    return same_bits(&a, &b, 1);
}

inline void expect_same(const StepReport& a, const StepReport& b) {
    EXPECT_EQ(a.step, b.step);
    for (const auto member :
         {&StepReport::time, &StepReport::step_size, &StepReport::kinetic, &StepReport::bending,
          &StepReport::membrane, &StepReport::gravity, &StepReport::contact, &StepReport::peak_strain,
          &StepReport::crack_face_overlap, &StepReport::obstacle_overlap, &StepReport::peak_stress,
          &StepReport::peak_bending_strain, &StepReport::peak_overload})
        EXPECT_TRUE(same(a.*member, b.*member));
    for (const auto member : balance_parts) EXPECT_TRUE(same(a.*member, b.*member));
    EXPECT_TRUE(same(a.linear_momentum, b.linear_momentum));
    EXPECT_TRUE(same(a.angular_momentum, b.angular_momentum));
    EXPECT_EQ(a.newton_iterations, b.newton_iterations);
    EXPECT_EQ(a.halvings, b.halvings);
    EXPECT_EQ(a.stages, b.stages);
    EXPECT_EQ(a.stage_cap_reached, b.stage_cap_reached);
    EXPECT_EQ(a.contacts, b.contacts);
    EXPECT_EQ(a.fragments, b.fragments);
    ASSERT_EQ(a.reactions.size(), b.reactions.size());
    for (std::size_t i = 0; i < a.reactions.size(); ++i)
        EXPECT_TRUE(same(a.reactions[i].force, b.reactions[i].force) &&
                    same(a.reactions[i].moment, b.reactions[i].moment));
    ASSERT_EQ(a.gauges.size(), b.gauges.size());
    for (std::size_t i = 0; i < a.gauges.size(); ++i)
        for (const auto member :
             {&GaugeReading::displacement, &GaugeReading::curvature, &GaugeReading::membrane_strain,
              &GaugeReading::stress_top, &GaugeReading::stress_bottom})
            EXPECT_TRUE(same(a.gauges[i].*member, b.gauges[i].*member));
}

inline void expect_same(const CrackEvents& a, const CrackEvents& b) {
    ASSERT_EQ(a.failures.size(), b.failures.size());
    for (std::size_t i = 0; i < a.failures.size(); ++i) {
        const EdgeFailure &x = a.failures[i], &y = b.failures[i];
        EXPECT_TRUE(same(x.time, y.time) && same(x.strain, y.strain));
        EXPECT_TRUE(same(x.stress, y.stress) && same(x.overload, y.overload));
        EXPECT_EQ(std::tie(x.step, x.stage, x.edge, x.vertices, x.boundary_vertices),
                  std::tie(y.step, y.stage, y.edge, y.vertices, y.boundary_vertices));
    }
    ASSERT_EQ(a.openings.size(), b.openings.size());
    for (std::size_t i = 0; i < a.openings.size(); ++i) {
        const EdgeOpening &x = a.openings[i], &y = b.openings[i];
        EXPECT_EQ(std::tie(x.time, x.step, x.edge, x.created), std::tie(y.time, y.step, y.edge, y.created));
    }
    ASSERT_EQ(a.splits.size(), b.splits.size());
    for (std::size_t i = 0; i < a.splits.size(); ++i) {
        const VertexSplit &x = a.splits[i], &y = b.splits[i];
        EXPECT_EQ(std::tie(x.time, x.step, x.vertex, x.created),
                  std::tie(y.time, y.step, y.vertex, y.created));
    }
    ASSERT_EQ(a.fragment_splits.size(), b.fragment_splits.size());
    for (std::size_t i = 0; i < a.fragment_splits.size(); ++i) {
        const FragmentSplit &x = a.fragment_splits[i], &y = b.fragment_splits[i];
        EXPECT_EQ(std::tie(x.time, x.step, x.fragment, x.parent),
                  std::tie(y.time, y.step, y.fragment, y.parent));
    }
    ASSERT_EQ(a.vertex_insertions.size(), b.vertex_insertions.size());
    for (std::size_t i = 0; i < a.vertex_insertions.size(); ++i) {
        const VertexInsertion &x = a.vertex_insertions[i], &y = b.vertex_insertions[i];
        EXPECT_EQ(std::tie(x.time, x.step, x.created, x.parents, x.weights),
                  std::tie(y.time, y.step, y.created, y.parents, y.weights));
    }
    ASSERT_EQ(a.face_insertions.size(), b.face_insertions.size());
    for (std::size_t i = 0; i < a.face_insertions.size(); ++i) {
        const FaceInsertion &x = a.face_insertions[i], &y = b.face_insertions[i];
        EXPECT_EQ(std::tie(x.time, x.step, x.created, x.parent),
                  std::tie(y.time, y.step, y.created, y.parent));
    }
}

}  // namespace sherd::test
