// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <numbers>
#include <vector>

#include "app/commands/commands.h"
#include "app/commands/number_check.h"
#include "app/files/disk/pending_file.h"
#include "app/json/json.h"
#include "app/messages/print.h"
#include "app/scene/assemble/sheet/edge_list.h"
#include "fracture/mesh/crack_mesh.h"
#include "meshops/error.h"
#include "meshops/read_write/material_library.h"
#include "meshops/read_write/read_mesh.h"
#include "meshops/read_write/text_line.h"
#include "meshops/read_write/write_mesh.h"
#include "meshops/topology/advance/line_cut.h"
#include "meshops/topology/components.h"

namespace sherd {
namespace {

double coordinate(TextLine& line) {
    if (line.is_at_end()) line.fail("a coordinate is missing; write x y z, in metres", "");
    const double value = line.next_number();
    if (!std::isfinite(value)) line.fail("a coordinate is not finite", "");
    return value;
}

/// Reads polylines from a text file with a point per line as x y z, m; a blank line begins another polyline.
/// A # starts a comment. Points are named by file and line. Throws Error with file and line on a line that is
/// not three finite numbers, on a polyline of one point, and on a file that is missing or has no point.
std::vector<std::vector<LinePoint>> read_cut_lines(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream || std::filesystem::is_directory(file))
        throw Error(fmt::format("{}: cannot read the lines to cut; check the path", file.string()));
    std::vector<std::vector<LinePoint>> lines;
    bool is_new = true;
    const std::string content{std::istreambuf_iterator<char>(stream), {}};
    TextLines texts(file, without_byte_order_mark(file, content));
    while (!texts.is_at_end()) {
        const std::string_view text = texts.next_text();
        const bool is_comment =
            text.find_first_not_of(" \t\r") == text.find('#') && text.find('#') != text.npos;
        TextLine line(file, texts.number(), text.substr(0, text.find('#')));
        if (line.is_at_end()) {
            is_new = is_new || !is_comment;
            continue;
        }
        const double x = coordinate(line), y = coordinate(line), z = coordinate(line);
        if (!line.is_at_end()) line.fail("is one too many; write x y z, in metres", line.next_word());
        if (is_new) lines.emplace_back();
        is_new = false;
        lines.back().push_back({{x, y, z}, fmt::format("{}:{}", file.string(), texts.number())});
    }
    if (lines.empty()) throw Error(fmt::format("{}: holds no point; write x y z a line", file.string()));
    for (const auto& line : lines)
        if (line.size() < 2)
            throw Error(line.front().name +
                        ": this point stands alone; a line needs two or more, without an empty "
                        "line between them");
    return lines;
}

struct CutOptions {
    std::filesystem::path mesh, edges, line, output;
    bool keep_vertices = false;
    ReadMeshOptions read{.repair_advice = "--repair", .join_advice = ""};
    bool repair = false;
    bool force = false, json = false;
};

Json summary(const Mesh& before, std::span<const Edge> edges, const CrackMesh& cracks,
             const CrackMesh::Change& change) {
    const Mesh& mesh = cracks.mesh();
    const std::size_t opened = change.topology.opened.size();
    return {{"vertices_before", before.number_of_vertices()},
            {"vertices_after", mesh.number_of_vertices()},
            {"faces", mesh.number_of_faces()},
            {"edges_requested", edges.size()},
            {"edges_opened", opened},
            {"edges_closed", edges.size() - opened},
            {"vertices_split", change.topology.vertices.size()},
            {"fragments", connected_components(mesh).count},
            {"euler_characteristic",
             static_cast<std::int64_t>(mesh.number_of_vertices() + mesh.number_of_faces()) -
                 static_cast<std::int64_t>(mesh.number_of_edges())}};
}

OutputLock checked_output(const CutOptions& options) {
    const std::filesystem::path& output = options.output;
    if (!can_write_mesh(output))
        throw Error(fmt::format(
            "'{}' ends in none of .obj, .ply and .off; name a file that does (STL would close every crack)",
            output.string()));
    check_free(output, true, {options.mesh, options.edges, options.line});
    OutputLock lock(output);
    check_free(output, options.force);
    return lock;
}

/// Edges of the mesh to open. With --line, inserts them into the mesh first, and reports the changes of the
/// mesh in `told`.
std::vector<Edge> edges_to_open(const CutOptions& options, Mesh& mesh, Json& told) {
    if (options.line.empty()) return read_edge_list(options.edges, mesh);
    LineCut lines(mesh, options.keep_vertices);
    for (const std::vector<LinePoint>& line : read_cut_lines(options.line)) lines.cut(line);
    if (lines.edges().empty())
        throw Error(
            fmt::format("{}: the line lies on the boundary, which is open already", options.line.string()));
    told = {{"line_length", lines.length()},
            {"vertices_moved", lines.moved_vertices()},
            {"vertices_born", lines.inserted_vertices()},
            {"smallest_angle_made", lines.smallest_angle() * 180 / std::numbers::pi}};
    return lines.edges();
}

int cut(const CutOptions& options) {
    if (options.edges.empty() && options.line.empty())
        throw Error("say what to cut: --edges FILE or --line FILE");
    const OutputLock lock = checked_output(options);
    std::vector<std::string> warnings;
    ReadMeshOptions read = options.read;
    if (options.repair) read.repair = Repair::all;
    Mesh mesh = read_mesh(options.mesh, read, warnings);
    print_warnings(warnings);
    const Mesh before = mesh;
    Json told = Json::object();
    const std::vector<Edge> edges = edges_to_open(options, mesh, told);
    CrackMesh cracks(mesh);
    const CrackMesh::Change change = cracks.fail(edges);
    const TriangleSheet sheet = triangle_sheet(cracks.mesh());
    if (has_material_file(sheet, options.output)) check_free(material_file(options.output), options.force);
    write_mesh(sheet, options.output);

    Json result = summary(before, edges, cracks, change);
    result.update(told);
    if (options.json)
        print_result("{}\n", result.dump(2));
    else
        for (const auto& [key, value] : result.items()) print_result("{:<22}{}\n", key, value.dump());
    return 0;
}

}  // namespace

void add_cut(CLI::App& program, Command& chosen) {
    CLI::App* command =
        program.add_subcommand("cut", "Open edges of a mesh, or cut it along lines: no physics");
    auto options = std::make_shared<CutOptions>();
    command->add_option("mesh", options->mesh, "Mesh file (.obj, .ply, .off, .stl)")
        ->required()
        ->option_text("MESH");
    CLI::Option* edges = command->add_option(
        "--edges", options->edges, "Text file, one edge per line: two 0-based vertex numbers of MESH");
    edges->option_text("FILE");
    command
        ->add_option(
            "--line", options->line,
            "Text file, one point of a polyline per line: x y z, m; an empty line begins another polyline")
        ->excludes(edges)
        ->option_text("FILE");
    command->add_flag("--keep-vertices", options->keep_vertices,
                      "With --line: move no vertex of MESH, cut faces only");
    command->add_option("-o,--output", options->output, "Mesh to write (.obj, .ply or .off)")
        ->required()
        ->option_text("OUT");
    command->add_flag("--repair", options->repair, "Repair unambiguous defects, as scenes do");
    command->add_flag("--join", options->read.join_duplicate_points, "Merge points at the same place first");
    command
        ->add_option("--join-within", options->read.join_distance,
                     "Also merge border points within this distance, and divide border edges at such points; "
                     "in units of MESH")
        ->check(positive_number())
        ->option_text("DISTANCE");
    command->add_flag("--force", options->force, "Replace OUT if it exists");
    command->add_flag("--json", options->json, "Print the counts as JSON");
    command->footer(
        "Example:\n  sherd cut bowl.obj --edges cracks.txt -o opened.obj\n"
        "  sherd cut bowl.obj --line cracks.txt -o opened.obj");
    command->callback([&chosen, options] { chosen = [options] { return cut(*options); }; });
}

}  // namespace sherd
