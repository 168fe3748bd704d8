// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "core/vector.h"
#include "meshops/mesh.h"

namespace sherd {

/// Distinct values of a face property, and the number of each face's value.
template <class T>
struct SharedValues {
    std::vector<T> rows = {};        ///< in the order of their first faces
    std::vector<Index> number = {};  ///< [F] row of each face, -1: none; empty: the mesh has no such property
};

/// Reads the property `name`, whose values are std::shared_ptr<const T>.
template <class T>
SharedValues<T> shared_values(const Mesh& mesh, const char* name) {
    SharedValues<T> shared;
    const auto [values, exists] = find_property<Face, std::shared_ptr<const T>>(mesh, name);
    if (!exists) return shared;
    std::map<T, Index> known;
    for (const Face face : mesh.faces()) {
        if (!values[face]) {
            shared.number.push_back(-1);
            continue;
        }
        const auto next = static_cast<Index>(shared.rows.size());
        const auto [entry, is_new] = known.try_emplace(*values[face], next);
        if (is_new) shared.rows.push_back(*values[face]);
        shared.number.push_back(entry->second);
    }
    return shared;
}

/// Writes the values to the faces of a mesh that has the property.
template <class T>
void give_values(const SharedValues<T>& shared, const char* name, Mesh& mesh) {
    auto values = find_property<Face, std::shared_ptr<const T>>(mesh, name).first;
    std::vector<std::shared_ptr<const T>> rows;
    for (const T& row : shared.rows) rows.push_back(std::make_shared<const T>(row));
    for (const Face face : mesh.faces()) {
        const Index number = shared.number[face.idx()];
        values[face] = number < 0 ? nullptr : rows[number];
    }
}

}  // namespace sherd
