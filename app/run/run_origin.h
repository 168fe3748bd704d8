// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "app/run/runner.h"

namespace sherd {

/// Origin of a run: runs of the same origin give the same bits.
struct RunOrigin {
    std::string program;                          ///< version, and checksum of the program's file
    std::map<std::string, std::string> settings;  ///< Scene::settings, but those that may change
    std::map<std::string, std::uint64_t> meshes;  ///< checksums of the input files
    std::uint64_t start = 0;                      ///< checksum of the initial state

    void visit_state(StateVisitor& visit) {
        auto& [program, settings, meshes, start] = *this;
        visit(program, settings, meshes, start);
    }
};

/// Returns the origin of a run before its first step.
RunOrigin run_origin(const Runner& runner);

/// Returns the differences of `now` from `before`, a line each, or "".
std::string differences(const RunOrigin& before, const RunOrigin& now);

}  // namespace sherd
