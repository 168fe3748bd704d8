// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/level_set/vdb_file.h"

#include <openvdb/io/Stream.h>

#include <cerrno>
#include <fstream>
#include <map>
#include <new>
#include <system_error>

#include "meshops/error.h"
#include "meshops/level_set/isolated_run.h"

namespace sherd {
namespace {

openvdb::GridPtrVec read_grids(const std::filesystem::path& file) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) throw Error("is a folder, an OpenVDB file is needed");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw Error("cannot read the grids: " + std::generic_category().message(errno));
    // OpenVDB rarely checks whether reading succeeds; without exceptions, a truncated file would give random
    // values.
    stream.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
    try {
        const bool delay_loading = false;
        return *openvdb::io::Stream(stream, delay_loading).getGrids();
    } catch (const std::ios::failure&) {
        throw Error("damaged OpenVDB file, or not OpenVDB at all: it ends early");
    } catch (const std::bad_alloc&) {
        throw Error(
            "damaged OpenVDB file, or not OpenVDB at all: a length in it needs more memory than there is");
    } catch (const std::exception& error) {
        throw Error(std::string("damaged OpenVDB file, or not OpenVDB at all: ") + error.what());
    }
}

/// Reads the grids of a file. OpenVDB trusts the lengths that a file states, and writes beyond its buffers if
/// a damaged file states wrong ones. No check beforehand finds all such files. Therefore a copy of this
/// process reads the file first, which doubles the time.
openvdb::GridPtrVec read_grids_safely(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored))
        return read_grids(file);  // a pipe can only be read once
    // The limits leave room: an empty node of a grid has 30 times as many bytes in memory as in a file; a
    // core reads 100 MB/s, or 10 MB/s with sanitizers.
    const std::uint64_t size = std::filesystem::file_size(file, ignored);
    const IsolationLimits limits{.memory = (std::uint64_t(1) << 30) + 256 * size,
                                 .seconds = 5 + size / 2'000'000};
    run_isolated([&] { read_grids(file); }, limits,
                 "damaged OpenVDB file, or not OpenVDB at all: it makes OpenVDB crash or read without end");
    return read_grids(file);
}

std::string joined(const std::map<std::string, openvdb::FloatGrid::Ptr>& grids) {
    std::string names;
    for (const auto& [name, grid] : grids) names += (names.empty() ? "'" : ", '") + name + "'";
    return names;
}

openvdb::FloatGrid::Ptr find_grid(const std::filesystem::path& file, const std::string& name) {
    openvdb::initialize();
    std::map<std::string, openvdb::FloatGrid::Ptr> grids;
    for (const openvdb::GridBase::Ptr& grid : read_grids_safely(file))
        if (auto known = openvdb::gridPtrCast<openvdb::FloatGrid>(grid))
            grids.emplace(grid->getName(), known);
    if (grids.empty()) throw Error("holds no float grid");
    if (name.empty() && grids.size() > 1)
        throw Error("holds several float grids: name one of " + joined(grids));
    const auto found = name.empty() ? grids.begin() : grids.find(name);
    if (found == grids.end()) throw Error("has no float grid '" + name + "'; it has " + joined(grids));
    return found->second;
}

}  // namespace

openvdb::FloatGrid::Ptr read_float_grid(const std::filesystem::path& file, const std::string& name) {
    return with_context(file.string(), [&] { return find_grid(file, name); });
}

}  // namespace sherd
