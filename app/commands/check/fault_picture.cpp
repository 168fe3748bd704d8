// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/check/fault_picture.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>

#include "app/commands/commands.h"
#include "app/files/disk/pending_file.h"
#include "app/messages/counted.h"
#include "app/messages/print.h"
#include "app/scene/assemble/sheet/sheet.h"
#include "app/scene/assemble/start/start_faults.h"
#include "meshops/error.h"
#include "meshops/read_write/mesh_faults.h"

namespace sherd {
namespace {

struct FaultColour {
    FaultKind kind;
    Colour colour;
    const char* words;
};
constexpr Colour grey{190, 190, 190, 255};
constexpr std::array<FaultColour, 8> colours{
    {{FaultKind::zero_area, {230, 0, 150, 255}, "magenta: zero area, with the neighbours"},
     {FaultKind::repeated, {0, 150, 80, 255}, "green: repeats another face"},
     {FaultKind::non_manifold, {0, 170, 220, 255}, "cyan: at a non-manifold edge"},
     {FaultKind::inside_obstacle, {0, 70, 220, 255}, "blue: inside an obstacle"},
     {FaultKind::near_obstacle, {240, 220, 0, 255}, "yellow: too near to an obstacle's surface"},
     {FaultKind::across_obstacle, {140, 40, 190, 255}, "violet: across an obstacle's surface"},
     {FaultKind::too_near, {255, 140, 0, 255}, "orange: too near to another face"},
     {FaultKind::crossing, {220, 20, 20, 255}, "red: crosses or touches another face"}}};

/// Triangles of the picture, and the worst fault of each.
struct Picture {
    std::vector<std::array<Vector3d, 3>> triangles;
    std::vector<std::optional<FaultKind>> faults;
    std::vector<std::string> undrawn = {};  ///< sheets whose mesh cannot be made

    void add(const TriangleSheet& sheet, const Eigen::Affine3d& place) {
        for (const auto& [a, b, c] : sheet.triangles)
            triangles.push_back({place * sheet.points[a], place * sheet.points[b], place * sheet.points[c]});
        faults.resize(triangles.size());
    }
    void mark(std::size_t triangle, FaultKind kind) {
        std::optional<FaultKind>& fault = faults[triangle];
        if (!fault || *fault < kind) fault = kind;
    }
};

FaultKind kind_of(TriangleFault fault) {
    if (fault == TriangleFault::zero_area) return FaultKind::zero_area;
    return fault == TriangleFault::repeated ? FaultKind::repeated : FaultKind::non_manifold;
}

/// Adds a sheet whose mesh make_sheet() has refused, as it is in its file, with its faults.
void add_refused(const SheetSpec& sheet, Picture& picture) {
    const auto* spec = std::get_if<MeshFile>(&sheet.mesh);
    if (!spec) return picture.undrawn.push_back(sheet.name);
    try {
        const FaultyMesh mesh = find_mesh_faults(spec->path, spec->join || spec->join_distance > 0,
                                                 spec->join_distance / spec->scale);
        const std::size_t first = picture.triangles.size();
        picture.add(mesh.sheet, Eigen::Affine3d(sheet.place) * Eigen::Scaling(spec->scale));
        for (std::size_t t = 0; t < mesh.faults.size(); ++t)
            if (mesh.faults[t] != TriangleFault::none) picture.mark(first + t, kind_of(mesh.faults[t]));
    } catch (const Error&) {
        picture.undrawn.push_back(sheet.name);  // `check` reports why the file cannot be read
    }
}

Picture picture_of(const Scene& scene) {
    Picture picture;
    std::vector<SheetInput> inputs;
    std::vector<std::size_t> first_face;
    std::vector<std::string> told;  // warnings, which `check` prints
    for (const SheetSpec& sheet : scene.sheets) try {
            inputs.push_back(make_sheet(sheet, scene, told));
            first_face.push_back(picture.triangles.size());
            picture.add(triangle_sheet(inputs.back().mesh), Eigen::Affine3d::Identity());
        } catch (const Error&) {
            add_refused(sheet, picture);
        }
    if (inputs.size() < scene.sheets.size()) return picture;
    try {
        for (const StartFault& fault : start_faults(scene, inputs, BreakableShell(inputs)))
            picture.mark(first_face[fault.sheet] + static_cast<std::size_t>(fault.face), fault.kind);
    } catch (const Error&) {
        // Obstacles that cannot be made are left out; `check` reports why.
    }
    return picture;
}

TriangleSheet painted(const Picture& picture) {
    TriangleSheet sheet;
    for (std::size_t t = 0; t < picture.triangles.size(); ++t) {
        Colour colour = grey;
        for (const FaultColour& known : colours)
            if (picture.faults[t] == known.kind) colour = known.colour;
        const auto first = static_cast<std::int32_t>(sheet.points.size());
        // Programs that ignore the colours of faces show the colours of points, so triangles share no points.
        for (const Vector3d& corner : picture.triangles[t]) {
            sheet.points.push_back(corner);
            sheet.look.vertex_colour.push_back(colour);
        }
        sheet.triangles.push_back({first, first + 1, first + 2});
        sheet.look.face_colour.push_back(colour);
    }
    return sheet;
}

void print_legend(const Picture& picture, const std::filesystem::path& file) {
    print_result("{}: {} of the placed sheets, of which coloured:\n", file.string(),
                 counted(picture.faults.size(), "face"));
    for (const FaultColour& known : colours)
        if (const auto count = std::count(picture.faults.begin(), picture.faults.end(), known.kind);
            count > 0)
            print_result("  {:>6} {}\n", count, known.words);
}

}  // namespace

void require_fault_file(const Scene& scene, const std::filesystem::path& file, bool force) {
    if (file.extension() != ".ply")
        throw Error(fmt::format("'{}' does not end in .ply, the format with colours; name a file that does",
                                file.string()));
    require_no_input(file, scene);
    check_free(file, force);
}

void write_fault_picture(const Scene& scene, const std::filesystem::path& file, bool force) {
    const Picture picture = picture_of(scene);
    const auto is_fault = [](const std::optional<FaultKind>& fault) { return fault.has_value(); };
    if (std::none_of(picture.faults.begin(), picture.faults.end(), is_fault)) {
        print_result("{}: {} is not written\n",
                     picture.undrawn.empty()
                         ? "no face crosses another or keeps the scene from starting"
                         : fmt::format("the faces of sheet.{} are unknown, because its mesh cannot be made",
                                       fmt::join(picture.undrawn, ", sheet.")),
                     file.string());
        return;
    }
    const OutputLock lock(file);
    PendingFile pending(lock, Fault::input);
    pending.write(mesh_bytes(painted(picture), file));
    pending.publish(force);
    print_legend(picture, file);
}

}  // namespace sherd
