// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_vtp.h"

#include <fmt/format.h>

#include <bit>
#include <memory>

#include "app/export/export_formats.h"
#include "app/export/export_sheet.h"
#include "app/recording/xdmf.h"

namespace sherd {

namespace {

static_assert(std::endian::native == std::endian::little, "the header says little endian");

/// The XML of arrays whose numbers are appended behind it.
class Arrays {
  public:
    template <class T>
    void add(const char* type, const char* name, int width, const T* values, std::size_t count) {
        xml += fmt::format(
            "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
            "offset=\"{}\"/>\n",
            type, name, width, data.size());
        const std::uint64_t size = count * sizeof(T);
        data.append(reinterpret_cast<const char*>(&size), sizeof size);
        data.append(reinterpret_cast<const char*>(values), size);
    }
    void line(const std::string& text) { xml += text + "\n"; }
    std::string finish() { return xml + "<AppendedData encoding=\"raw\">\n_" + data + "\n</AppendedData>\n"; }

  private:
    std::string xml, data;
};

void add_face_arrays(Arrays& arrays, const Snapshot& frame) {
    const std::size_t faces = frame.faces.size();
    arrays.line("<CellData Scalars=\"fragment\">");
    arrays.add("Int32", "fragment", 1, frame.face_fragment.data(), faces);
    arrays.add("Int32", "sheet", 1, frame.face_sheet.data(), faces);
    arrays.add("Float64", "strain", 1, face_quality(frame, "strain").data(), faces);
    arrays.line("</CellData>");
}

void add_vertex_arrays(Arrays& arrays, const Snapshot& frame) {
    const VectorXd speed = frame.velocity.colwise().norm();
    const auto vertices = static_cast<std::size_t>(frame.position.cols());
    arrays.line("<PointData Scalars=\"speed\">");
    arrays.add("Float64", "speed", 1, speed.data(), vertices);
    arrays.add("Float64", "velocity", 3, frame.velocity.data(), 3 * vertices);
    arrays.line("</PointData>\n<Points>");
    arrays.add("Float64", "Points", 3, frame.position.data(), 3 * vertices);
    arrays.line("</Points>");
}

void add_triangles(Arrays& arrays, const Snapshot& frame) {
    std::vector<std::int64_t> ends;
    for (std::size_t f = 1; f <= frame.faces.size(); ++f) ends.push_back(static_cast<std::int64_t>(3 * f));
    arrays.line("<Polys>");
    arrays.add("Int32", "connectivity", 1, frame.faces.empty() ? nullptr : frame.faces[0].data(),
               3 * frame.faces.size());
    arrays.add("Int64", "offsets", 1, ends.data(), ends.size());
    arrays.line("</Polys>");
}

}  // namespace

std::string vtp_bytes(const Snapshot& frame) {
    Arrays arrays;
    arrays.line(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n<PolyData>");
    arrays.line(
        fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
                    "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">",
                    frame.position.cols(), frame.faces.size()));
    add_vertex_arrays(arrays, frame);
    add_face_arrays(arrays, frame);
    add_triangles(arrays, frame);
    arrays.line("</Piece>\n</PolyData>");
    return arrays.finish() + "</VTKFile>\n";
}

std::string pvd_text(std::span<const TimedFile> files) {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
        "byte_order=\"LittleEndian\">\n<Collection>\n";
    for (const auto& [file, time] : files)
        text += fmt::format("<DataSet timestep=\"{:.17g}\" part=\"0\" file=\"{}\"/>\n", time,
                            xml_escaped(file.filename().string()));
    return text + "</Collection>\n</VTKFile>\n";
}

std::vector<ExportJob> plan_pvd(ExportSource& source) {
    const auto index = std::make_shared<std::vector<TimedFile>>();
    std::vector<ExportJob> jobs;
    for (const std::size_t number : source.frames()) {
        const auto file = source.numbered_file(number, ".vtp");
        jobs.push_back({file, [&source, index, number, file] {
                            const Snapshot& frame = source.frame(number);
                            index->push_back({file, frame.time});
                            return vtp_bytes(frame);
                        }});
    }
    jobs.push_back({source.clip_file(".pvd"), [index] { return pvd_text(*index); }});
    return jobs;
}

}  // namespace sherd
