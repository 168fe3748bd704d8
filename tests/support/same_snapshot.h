// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "app/recording/recording_format.h"

namespace sherd::test {

/// Calls visit(name, bytes) for every array of a snapshot, always in the same order.
template <class Visit>
void visit_arrays_of(const Snapshot& frame, Visit visit) {
    const auto pass_on = [&](const char* name, hdf5::Meaning, const auto& values) {
        visit(name, std::vector<char>(reinterpret_cast<const char*>(values.data()),
                                      reinterpret_cast<const char*>(values.data() + values.size())));
    };
    recording_format::visit_arrays(frame, pass_on);
    recording_format::visit_rest_arrays(frame.rest, pass_on);
    pass_on("unbroken faces", {}, frame.rest.unbroken_faces);
    pass_on(recording_format::held_edges, {}, frame.edge_held);
    visit_fields(frame.fields, [&](const char* name, const auto& values, const FieldMeaning&) {
        pass_on(name, {}, values);
    });
}

/// Expects equality to the last bit.
inline void expect_same(const Snapshot& found, const Snapshot& expected) {
    EXPECT_EQ(found.step, expected.step);
    EXPECT_EQ(found.time, expected.time);
    EXPECT_TRUE(found.rest.look == expected.rest.look);
    std::vector<std::vector<char>> wanted;
    visit_arrays_of(expected, [&](const char*, const std::vector<char>& bytes) { wanted.push_back(bytes); });
    auto next = wanted.begin();
    visit_arrays_of(found, [&](const char* name, const std::vector<char>& bytes) {
        EXPECT_TRUE(bytes == *next++) << name << " at " << expected.time << " s";
    });
}

}  // namespace sherd::test
