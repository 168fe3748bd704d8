// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <vector>

#include "meshops/read_write/read_mesh.h"
#include "tests/fuzz/read_input.h"

namespace sherd::test {

/// Reads the mesh `file` with the least repair and with all repair; a mesh that is read must be valid.
inline void fuzz_mesh(const std::filesystem::path& file) {
    for (const bool mends : {false, true})
        read_or_refuse([&] {
            std::vector<std::string> warnings;
            const Mesh mesh = read_mesh(
                file, {.join_duplicate_points = mends, .repair = mends ? Repair::all : Repair::least},
                warnings);
            if (!mesh.is_valid(false) || mesh.number_of_faces() == 0) std::abort();
        });
}

}  // namespace sherd::test
