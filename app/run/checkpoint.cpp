// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <ostream>
#include <sstream>

#include "app/files/disk/checksum.h"
#include "app/files/disk/pending_file.h"
#include "app/files/program_file.h"
#include "app/messages/number_list.h"
#include "app/run/obstacle_track.h"
#include "app/run/state_archive.h"

namespace sherd {
namespace {

/// Returns the checksum of the initial state, including all data that textures, grids and lists of edges can
/// make vary over a sheet. Arrays of structs are left out, since the bytes between the members of a struct
/// are arbitrary; the structs follow from these data and the settings.
std::uint64_t checksum_of_start(const Runner& runner) {
    Shell shell = runner.simulation().shell().mechanics();
    const std::span<const Vector3d> axes = runner.simulation().shell().axes();
    std::vector<Vector3d> face_axes(axes.begin(), axes.end());
    std::ostringstream text;
    StateWriter writer(text);
    writer(shell.rest, shell.position, shell.velocity, shell.mass, shell.thickness, shell.young,
           shell.footprint, shell.fixed, shell.script, shell.guide, shell.support_set, shell.vertex_sheet,
           shell.face_sheet, shell.edge_strength, shell.edge_toughness, face_axes);
    const ObstacleTrack track(runner.scene(), runner.simulation());
    for (RecordedObstacle obstacle : track.obstacles())
        writer(obstacle.surface.points, obstacle.surface.triangles);
    return checksum(text.view());
}

template <class T, class Words>
std::string differences(const std::map<std::string, T>& before, const std::map<std::string, T>& now,
                        Words words) {
    std::map<std::string, std::pair<const T*, const T*>> both;
    for (const auto& [key, value] : before) both[key].first = &value;
    for (const auto& [key, value] : now) both[key].second = &value;
    std::string text;
    for (const auto& [key, values] : both)
        if (!values.first || !values.second || *values.first != *values.second)
            text += words(key, values.first, values.second) + "\n";
    return text;
}

/// Returns a setting's value for a message. Settings hold floating-point numbers with 17 digits; a message
/// has the fewest digits that give the number back.
std::string value_words(const std::string& value) {
    const bool is_integer = value.find_first_not_of("+-0123456789") == std::string::npos;
    const std::optional<double> number = is_integer ? std::nullopt : number_of(value);
    return number ? fmt::format("{}", *number) : value;
}

std::string setting_words(const std::string& key, const std::string* before, const std::string* now) {
    if (!before) return fmt::format("{} = {} has been added", key, value_words(*now));
    if (!now) return fmt::format("{} = {} has been removed", key, value_words(*before));
    return fmt::format("{} was {} and is {}", key, value_words(*before), value_words(*now));
}

constexpr std::string_view magic = "sherd checkpoint 4\n";

/// End of a checkpoint file: size (bytes) and checksum of the data between `magic` and the seal.
struct Seal {
    std::uint64_t size = 0, sum = 0;
};

Checkpoint read_checkpoint(const std::filesystem::path& file) {
    std::string text = text_of(file);
    if (!text.starts_with(magic))
        throw Error(fmt::format("'{}' is not a checkpoint of this version", file.string()));
    Seal seal;
    const std::size_t body_size = text.size() - std::min(text.size(), magic.size() + sizeof seal);
    const std::string_view body = std::string_view(text).substr(magic.size(), body_size);
    if (body_size > 0) std::memcpy(&seal, body.data() + body.size(), sizeof seal);
    if (body_size == 0 || body.size() != seal.size || state_sum(body) != seal.sum)
        throw Error(fmt::format("the checkpoint '{}' is damaged or cut off", file.string()));
    Checkpoint checkpoint;
    StateReader reader(body);
    reader(checkpoint);
    const std::size_t state_size = reader.left().size();
    text.erase(0, text.size() - sizeof seal - state_size);
    text.resize(state_size);
    checkpoint.state = std::move(text);
    return checkpoint;
}

}  // namespace

RunOrigin run_origin(const Runner& runner) {
    const Scene& scene = runner.scene();
    RunOrigin origin;
    origin.program = fmt::format("sherd {} ({:016x})", SHERD_VERSION, checksum_of(program_file()));
    origin.settings = scene.settings;
    for (const char* key : free_keys) origin.settings.erase(key);
    const std::filesystem::path folder = std::filesystem::absolute(scene.file).parent_path();
    for (const std::filesystem::path& file : input_files(scene))
        origin.meshes[std::filesystem::proximate(file, folder).string()] = checksum_of(file);
    origin.start = checksum_of_start(runner);
    return origin;
}

std::string differences(const RunOrigin& before, const RunOrigin& now) {
    std::string text = differences(before.settings, now.settings, setting_words);
    text += differences(before.meshes, now.meshes,
                        [](const std::string& file, const std::uint64_t*, const std::uint64_t*) {
                            return fmt::format("the mesh '{}' has changed", file);
                        });
    if (before.program != now.program)
        text += fmt::format("the program was {} and is {}\n", before.program, now.program);
    if (text.empty() && before.start != now.start)
        text = "an input of the scene, such as a texture, a grid or a list of edges, has changed\n";
    return text;
}

std::array<std::filesystem::path, 2> checkpoint_files(const std::filesystem::path& recording) {
    return {recording.string() + ".checkpoint-1", recording.string() + ".checkpoint-2"};
}

void remove_checkpoint(const std::filesystem::path& recording, std::int64_t number) {
    std::error_code ignored;
    std::filesystem::remove(checkpoint_files(recording)[number % 2], ignored);
}

void write_checkpoint(const OutputLock& recording, Checkpoint checkpoint,
                      const std::function<void(StateVisitor&)>& visit_all) {
    PendingFile file(checkpoint_files(recording.output())[checkpoint.number % 2], Fault::run, recording);
    file.write([&](std::ostream& out) {
        out << magic;
        StateWriter writer(out);
        writer(checkpoint);
        visit_all(writer);
        const Seal seal{writer.size(), writer.sum()};
        out.write(reinterpret_cast<const char*>(&seal), sizeof seal);
    });
    file.publish_durably();
}

std::optional<Checkpoint> last_checkpoint(const std::filesystem::path& recording,
                                          std::vector<std::string>& warnings) {
    std::optional<Checkpoint> last;
    for (const std::filesystem::path& file : checkpoint_files(recording)) {
        std::error_code ignored;
        std::filesystem::remove(file.string() + ".part", ignored);
        if (!std::filesystem::exists(file)) continue;
        try {
            Checkpoint one = read_checkpoint(file);
            if (!last || one.number > last->number) last = std::move(one);
        } catch (const Error& error) {
            warnings.emplace_back(error.what());
        }
    }
    return last;
}

void remove_checkpoints(const std::filesystem::path& recording) {
    std::error_code ignored;
    for (const std::filesystem::path& file : checkpoint_files(recording)) {
        std::filesystem::remove(file, ignored);
        std::filesystem::remove(file.string() + ".part", ignored);
        // A program that was killed while writing has left a lock file; taking and releasing the lock removes
        // it.
        if (std::filesystem::exists(file.string() + ".lock", ignored)) try {
                const OutputLock left(file);
            } catch (const Error&) {
                continue;  // another program is writing this file
            }
    }
}

}  // namespace sherd
