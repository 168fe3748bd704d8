// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "fracture/record/snapshot.h"

namespace sherd::test {

/// Calls visit(name, bytes) for every array of a snapshot, always in the same order.
template <class Visit>
void visit_arrays_of(const Snapshot& frame, Visit visit) {
    const auto pass_bytes = [&](const char* name, const auto& values) {
        visit(name, std::vector<char>(reinterpret_cast<const char*>(values.data()),
                                      reinterpret_cast<const char*>(values.data() + values.size())));
    };
    const auto pass_on = [&](const SnapshotArray& array, const auto& values) {
        pass_bytes(array.name, values);
    };
    visit_arrays(frame, pass_on);
    visit_rest_arrays(frame.rest, pass_on);
    pass_bytes("unbroken faces", frame.rest.unfractured_faces);
    visit_fields(frame.fields, [&](const char* name, const auto& values, const FieldMeaning&) {
        pass_bytes(name, values);
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
