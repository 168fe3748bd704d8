// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "meshops/attributes.h"
#include "meshops/error.h"
#include "meshops/read_write/read_mesh.h"
#include "tests/support/mesh/mesh_quality.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {

/// Writes a text to a file and reads it as a mesh.
class MeshReading : public ::testing::Test {
  protected:
    Mesh read(const std::string& name, const std::string& text, const ReadMeshOptions& options = {}) {
        warnings.clear();
        return read_mesh(directory.write(name, text), options, warnings);
    }

    /// Returns the message of the Error that reading the text throws; "no error" if there is none.
    std::string failure(const std::string& name, const std::string& text,
                        const ReadMeshOptions& options = {}) {
        try {
            read(name, text, options);
        } catch (const Error& error) {
            EXPECT_EQ(error.fault, Fault::input);
            return error.what();
        }
        return "no error";
    }

    /// Expects that reading fails with a message that has the name of the file and `part`.
    void expect_failure(const std::string& name, const std::string& text, const std::string& part,
                        const ReadMeshOptions& options = {}) {
        const std::string message = failure(name, text, options);
        EXPECT_NE(message.find(name), std::string::npos) << message;
        EXPECT_NE(message.find(part), std::string::npos) << message;
    }

    void expect_warning(const std::string& part) const {
        for (const auto& warning : warnings) {
            if (warning.find(part) != std::string::npos) return;
        }
        ADD_FAILURE() << "no warning with `" << part << "` among " << warnings.size() << ": "
                      << (warnings.empty() ? "" : warnings[0]);
    }

    TemporaryDirectory directory;
    std::vector<std::string> warnings;
};

using Triangles = std::vector<std::vector<unsigned>>;

/// Corners of each face, by the numbers of their vertices in the file, in the file's order.
inline Triangles triangles(const Mesh& mesh) {
    const auto [file_vertex, exists] = find_property(mesh, attribute::file_vertex);
    EXPECT_TRUE(exists);
    Triangles result;
    for (const Face face : mesh.faces()) {
        auto& corners = result.emplace_back();
        for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
            corners.push_back(file_vertex[v]);
    }
    return result;
}

inline double area(const Mesh& mesh) {
    return mesh_quality(mesh).area;
}

inline constexpr ReadMeshOptions repair{.repair = Repair::all};
inline const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

}  // namespace sherd::test
