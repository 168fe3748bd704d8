// SPDX-License-Identifier: GPL-3.0-or-later
// fragments RUN.h5: lists the fragments in the last frame of a recording, with their mass and centre of mass.
#include <cstdio>
#include <map>
#include <set>

#include "app/recording/recording.h"
#include "meshops/error.h"

int main(int count, char** arguments) try {
    if (count != 2) throw sherd::Error("usage: fragments RUN.h5");
    const sherd::Recording recording(arguments[1]);
    if (recording.frame_count() == 0) throw sherd::Error("the recording has no frame yet");
    const sherd::Snapshot frame = recording.frame(recording.frame_count() - 1);

    // A vertex belongs to a single fragment.
    std::map<sherd::Index, std::set<sherd::Index>> vertices;
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        vertices[frame.face_fragment[f]].insert(frame.faces[f].begin(), frame.faces[f].end());
    for (const auto& [fragment, own] : vertices) {
        double mass = 0;
        sherd::Vector3d centre = sherd::Vector3d::Zero();
        for (const sherd::Index v : own) {
            mass += frame.mass[v];
            centre += frame.mass[v] * frame.position.col(v);
        }
        centre /= mass;
        std::printf("%4d  %-10g kg at (%.4f, %.4f, %.4f) m\n", fragment, mass, centre.x(), centre.y(),
                    centre.z());
    }
} catch (const sherd::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
}
