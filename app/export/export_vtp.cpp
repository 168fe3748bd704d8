// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_vtp.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <new>
#include <vector>

#include "app/export/export_formats.h"
#include "app/export/export_sheet.h"
#include "app/export/split_points.h"
#include "app/files/base64.h"
#include "app/files/xml_text.h"
#include "meshops/shared_values.h"

namespace sherd {

namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "the header says little endian");

constexpr std::size_t block_bytes = 32768;  // size of a block before compression, as in VTK's own files

std::vector<std::uint8_t> compressed(std::span<const std::uint8_t> block) {
    std::vector<std::uint8_t> result(compressBound(block.size()));
    uLongf size = result.size();
    if (compress(result.data(), &size, block.data(), block.size()) != Z_OK) throw std::bad_alloc();
    result.resize(size);
    return result;
}

/// Encodes numbers as VTK reads them between the tags of an array: first the number of compressed blocks and
/// their sizes, in base64, then the blocks, all together in base64.
std::string encoded(std::span<const std::uint8_t> bytes) {
    const std::size_t blocks = (bytes.size() + block_bytes - 1) / block_bytes;
    std::vector<std::uint64_t> head{blocks, block_bytes, bytes.size() % block_bytes};
    std::vector<std::uint8_t> data;
    for (std::size_t i = 0; i < blocks; ++i) {
        const std::size_t begin = i * block_bytes;
        const auto block = compressed(bytes.subspan(begin, std::min(block_bytes, bytes.size() - begin)));
        head.push_back(block.size());
        data.insert(data.end(), block.begin(), block.end());
    }
    return base64({reinterpret_cast<const std::uint8_t*>(head.data()), head.size() * sizeof head[0]}) +
           base64(data);
}

template <class T>
std::string array(const char* type, const char* name, int width, const T* values, std::size_t count) {
    return fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">\n{}\n</DataArray>\n",
        type, name, width, encoded({reinterpret_cast<const std::uint8_t*>(values), count * sizeof(T)}));
}

std::string point_array(const double* values, std::size_t points) {
    return "<Points>\n" + array("Float64", "Points", 3, values, 3 * points) + "</Points>\n";
}

Positions chosen_columns(const Positions& values, const std::vector<std::size_t>& columns) {
    Positions result(3, static_cast<Eigen::Index>(columns.size()));
    for (std::size_t i = 0; i < columns.size(); ++i)
        result.col(static_cast<Eigen::Index>(i)) = values.col(static_cast<Eigen::Index>(columns[i]));
    return result;
}

/// Array of values: of their numbers or, for shared values, of the index of each in shared_values().
template <class Value>
std::string value_array(const char* name, const std::vector<Value>& values) {
    if constexpr (std::same_as<Value, Colour>)
        return array("UInt8", name, 4, values[0].data(), 4 * values.size());
    else if constexpr (std::same_as<Value, double>)
        return array("Float64", name, 1, values.data(), values.size());
    else
        return array("Float64", name, Value::RowsAtCompileTime, values[0].data(),
                     Value::RowsAtCompileTime * values.size());
}

template <class T>
std::string value_array(const char* name, const std::vector<std::shared_ptr<const T>>& values) {
    const std::vector<Index> rows = shared_values(values).number;
    return array("Int32", name, 1, rows.data(), rows.size());
}

/// Array of an attribute; "" if the list is empty, or VTP files do not have the attribute.
template <class Value>
std::string attribute_array(const auto& attribute, const std::vector<Value>& list) {
    return *attribute.vtp == 0 || list.empty() ? "" : value_array(attribute.vtp, list);
}

/// Arrays of the look at split points: texture coordinates, and attributes of vertices.
std::string look_arrays(const SurfaceLook& look, const SplitPoints& split) {
    std::string text;
    if (!look.texture.empty()) text = attribute_array(attribute::texture, at_points(split, look.texture));
    visit_attributes_of<Vertex>([&](const auto& attribute) {
        if (const auto& list = look.*attribute.list; !list.empty())
            text += attribute_array(attribute, gathered(list, split.points));
    });
    return text;
}

/// Arrays of the attributes of faces, but not of texture coordinates.
std::string look_arrays(const SurfaceLook& look) {
    std::string text;
    visit_attributes_of<Face>([&](const auto& attribute) {
        const auto& list = look.*attribute.list;
        if constexpr (!std::same_as<std::decay_t<decltype(list)>, std::vector<FaceTexture>>)
            text += attribute_array(attribute, list);
    });
    return text;
}

/// Arrays of the vertices at split points. sheet: frame_sheet() of the frame.
std::string vertex_arrays(const Snapshot& frame, const TriangleSheet& sheet, const SplitPoints& split) {
    const Positions velocity = chosen_columns(frame.velocity, split.points);
    const VectorXd speed = velocity.colwise().norm();
    const std::size_t points = split.points.size();
    return fmt::format("<PointData Scalars=\"speed\"{}>\n",
                       sheet.look.texture.empty() ? "" : " TCoords=\"texture\"") +
           array("Float64", "speed", 1, speed.data(), points) +
           array("Float64", "velocity", 3, velocity.data(), 3 * points) + look_arrays(sheet.look, split) +
           "</PointData>\n" + point_array(chosen_columns(frame.position, split.points).data(), points);
}

/// Array of texts, whose characters are written as numbers.
std::string text_array(const char* name, const std::vector<std::string>& texts) {
    std::string letters;
    for (const std::string& text : texts) {
        for (const char letter : text) letters += std::to_string(static_cast<unsigned char>(letter)) + " ";
        letters += "0\n";
    }
    return fmt::format(
        "<DataArray type=\"String\" Name=\"{}\" NumberOfTuples=\"{}\" format=\"ascii\">\n{}</DataArray>\n",
        name, texts.size(), letters);
}

std::string name_of(const SurfaceMaterial& material) {
    return material.name;
}
std::string name_of(const std::vector<std::string>& groups) {
    return fmt::format("{}", fmt::join(groups, ", "));
}

/// Lists of the names of materials and groups, to which arrays of shared values refer by index.
std::string name_lists(const SurfaceLook& look) {
    std::string lists;
    visit_attributes_of<Face>([&](const auto& attribute) {
        const auto& list = look.*attribute.list;
        if constexpr (requires { shared_values(list); }) {
            if (list.empty()) return;
            std::vector<std::string> names;
            for (const auto& row : shared_values(list).rows) names.push_back(name_of(row));
            lists += text_array((attribute.vtp + std::string("_names")).c_str(), names);
        }
    });
    return lists.empty() ? "" : "<FieldData>\n" + lists + "</FieldData>\n";
}

/// Arrays of each field and of its two principal values, of which the larger comes first.
std::string field_arrays(const FaceFields& fields) {
    std::string text;
    visit_fields(
        fields, [&](const std::string& name, const Eigen::Matrix3Xd& values, const FieldMeaning& meaning) {
            if (values.size() == 0) return;
            const Eigen::Matrix2Xd principal = principal_values(values, meaning.twice);
            text += array("Float64", name.c_str(), 3, values.data(), values.size()) +
                    array("Float64", (name + "_principal").c_str(), 2, principal.data(), principal.size());
        });
    return text;
}

std::string face_arrays(const Snapshot& frame) {
    const std::size_t faces = frame.faces.size();
    return "<CellData Scalars=\"fragment\">\n" +
           array("Int32", "fragment", 1, frame.face_fragment.data(), faces) +
           array("Int32", "sheet", 1, frame.face_sheet.data(), faces) +
           array("Float64", "strain", 1, face_quality(frame, "strain").data(), faces) +
           field_arrays(frame.fields) + look_arrays(frame.rest.look) + "</CellData>\n";
}

std::string triangles(const std::vector<std::array<Index, 3>>& faces) {
    std::vector<std::int64_t> ends;
    for (std::size_t f = 1; f <= faces.size(); ++f) ends.push_back(static_cast<std::int64_t>(3 * f));
    return "<Polys>\n" +
           array("Int32", "connectivity", 1, faces.empty() ? nullptr : faces[0].data(), 3 * faces.size()) +
           array("Int64", "offsets", 1, ends.data(), ends.size()) + "</Polys>\n";
}

/// Text of a .vtp file. arrays: text of the arrays of points and faces; fields: data of the whole mesh.
std::string vtp_text(std::size_t points, const std::vector<std::array<Index, 3>>& faces,
                     const std::string& arrays, const std::string& fields = "") {
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<PolyData>\n" +
           fields +
           fmt::format(
               "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
               "NumberOfPolys=\"{}\">\n",
               points, faces.size()) +
           arrays + triangles(faces) + "</Piece>\n</PolyData>\n</VTKFile>\n";
}

/// File of an obstacle in a frame; if the obstacle does not move, all frames have a single file of it.
fs::path obstacle_file(const ExportSource& source, std::size_t i, std::size_t frame) {
    const std::string suffix = source.obstacle_suffix(i, ".vtp");
    return source.obstacles()[i].moves ? source.numbered_file(frame, suffix) : source.clip_file(suffix);
}

/// Adds files of the obstacles in a frame, but after the first frame not of obstacles that do not move.
void add_obstacles(ExportSource& source, std::size_t frame, std::vector<ExportJob>& jobs) {
    for (std::size_t i = 0; i < source.obstacles().size(); ++i)
        if (source.obstacles()[i].moves || frame == source.frames().front())
            jobs.push_back({obstacle_file(source, i, frame),
                            [&source, i, frame] { return vtp_bytes(source.obstacle(i, frame)); }});
}

std::string index_of(const ExportSource& source) {
    std::vector<TimedFile> files;
    const std::vector<double> times = source.times();
    for (std::size_t k = 0; k < times.size(); ++k) {
        const std::size_t frame = source.frames()[k];
        files.push_back({source.numbered_file(frame, ".vtp"), times[k], 0, "sheets"});
        for (std::size_t i = 0; i < source.obstacles().size(); ++i)
            files.push_back({obstacle_file(source, i, frame), times[k], i + 1, source.obstacles()[i].name});
    }
    return pvd_text(files);
}

}  // namespace

std::string vtp_bytes(const Snapshot& frame) {
    TriangleSheet sheet = frame_sheet(frame);
    sheet.look.face_colour.clear();  // colours are face arrays, so that no point is split for them
    const SplitPoints split = split_points(sheet);
    return vtp_text(split.points.size(), split.triangles,
                    vertex_arrays(frame, sheet, split) + face_arrays(frame), name_lists(frame.rest.look));
}

std::string vtp_bytes(const TriangleSheet& mesh) {
    const double* values = mesh.points.empty() ? nullptr : mesh.points[0].data();
    return vtp_text(mesh.points.size(), mesh.triangles, point_array(values, mesh.points.size()));
}

std::string pvd_text(std::span<const TimedFile> files) {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
        "byte_order=\"LittleEndian\">\n<Collection>\n";
    for (const auto& [file, time, part, name] : files)
        text += fmt::format("<DataSet timestep=\"{:.17g}\" part=\"{}\" name=\"{}\" file=\"{}\"/>\n", time,
                            part, xml_escaped(name), xml_escaped(file.filename().string()));
    return text + "</Collection>\n</VTKFile>\n";
}

std::vector<ExportJob> plan_pvd(ExportSource& source) {
    std::vector<ExportJob> jobs;
    for (const std::size_t number : source.frames()) {
        jobs.push_back({source.numbered_file(number, ".vtp"),
                        [&source, number] { return vtp_bytes(source.frame(number)); }});
        add_obstacles(source, number, jobs);
    }
    jobs.push_back({source.clip_file(".pvd"), [&source] { return index_of(source); }});
    return jobs;
}

}  // namespace sherd
