// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "app/run/runner.h"

namespace sherd {

/// What a run comes from: another run of the same origin gives the same bits.
struct RunOrigin {
    std::string program;                          ///< its version and the checksum of its file
    std::map<std::string, std::string> settings;  ///< Scene::settings, without what a run may change
    std::map<std::string, std::uint64_t> meshes;  ///< checksums of the files
    std::uint64_t start = 0;                      ///< checksum of all that was built of them

    void visit_state(StateVisitor& visit) {
        auto& [program, settings, meshes, start] = *this;
        visit(program, settings, meshes, start);
    }
};

/// Of a run that has not made a step yet.
RunOrigin run_origin(const Runner& runner);

/// Says what is another in `now`, a line each; empty: nothing.
std::string differences(const RunOrigin& before, const RunOrigin& now);

}  // namespace sherd
