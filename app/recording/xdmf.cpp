// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/xdmf.h"

#include <fmt/format.h>

#include <iterator>

#include "app/files/xml_text.h"
#include "app/recording/recording_format.h"

namespace sherd {

namespace {

constexpr const char* reals = "NumberType=\"Float\" Precision=\"8\"";
constexpr const char* integers = "NumberType=\"Int\" Precision=\"4\"";
constexpr const char* bytes = "NumberType=\"UChar\" Precision=\"1\"";

/// One frame of one collection, written line by line.
class Grid {
  public:
    /// `source` is the group of the frame, as XDMF names it.
    Grid(std::string& out, const std::string& name, const std::string& source, const XdmfFrame& frame)
        : out(out), source(source), frame(frame) {
        add("<Grid Name=\"{}\"><Time Value=\"{:.17g}\"/>\n", name, frame.time);
    }

    void topology(const std::string& attributes, std::size_t count, std::size_t corners,
                  const std::string& dataset) {
        add("<Topology {} NumberOfElements=\"{}\">", attributes, count);
        data(integers, fmt::format("{} {}", count, corners), dataset);
        out += "</Topology>\n<Geometry GeometryType=\"XYZ\">";
        data(reals, fmt::format("{} 3", frame.vertices), "vertex/position");
        out += "</Geometry>\n";
    }

    void attribute(const std::string& dataset, const std::string& kind, const std::string& center,
                   const std::string& number, const std::string& dimensions) {
        add("<Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">",
            dataset.substr(dataset.find('/') + 1), kind, center);
        data(number, dimensions, dataset);
        out += "</Attribute>\n";
    }

    void end() { out += "</Grid>\n"; }

  private:
    void data(const std::string& number, const std::string& dimensions, const std::string& dataset) {
        add("<DataItem Format=\"HDF\" {} Dimensions=\"{}\">{}{}</DataItem>", number, dimensions, source,
            dataset);
    }

    template <class... Arguments>
    void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(out), format, std::forward<Arguments>(arguments)...);
    }

    std::string& out;
    std::string source;
    const XdmfFrame& frame;
};

void add_surface(Grid grid, const XdmfFrame& frame) {
    const std::string faces = std::to_string(frame.faces), vertices = std::to_string(frame.vertices);
    grid.topology("TopologyType=\"Triangle\"", frame.faces, 3, "face/vertices");
    grid.attribute("face/fragment", "Scalar", "Cell", integers, faces);
    grid.attribute("face/sheet", "Scalar", "Cell", integers, faces);
    for (const std::string& field : frame.fields) {
        grid.attribute("face/" + field, "Vector", "Cell", reals, faces + " 3");
        grid.attribute("face/" + field + recording_format::principal_suffix, "Matrix", "Cell", reals,
                       faces + " 2");
    }
    grid.attribute("vertex/speed", "Scalar", "Node", reals, vertices);
    grid.attribute("vertex/velocity", "Vector", "Node", reals, vertices + " 3");
    grid.end();
}

void add_edges(Grid grid, const XdmfFrame& frame) {
    const std::string edges = std::to_string(frame.edges);
    grid.topology("TopologyType=\"Polyline\" NodesPerElement=\"2\"", frame.edges, 2, "edge/vertices");
    grid.attribute("edge/state", "Scalar", "Cell", bytes, edges);
    grid.attribute("edge/strain", "Scalar", "Cell", reals, edges);
    grid.end();
}

template <class AddFrame>
void add_collection(std::string& out, const char* name, const std::string& source,
                    std::span<const XdmfFrame> frames, AddFrame add_frame) {
    out += fmt::format("<Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n", name);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        // Without the domain FILE the reader would look for one before the first colon of the file's name.
        const std::string group = fmt::format("FILE:{}:/{}/", source, recording_format::frame_group(i));
        add_frame(Grid(out, fmt::format("{} {}", name, i), group, frames[i]), frames[i]);
    }
    out += "</Grid>\n";
}

}  // namespace

std::string xdmf_text(const std::string& recording_name, std::span<const XdmfFrame> frames) {
    std::string out = "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n";
    const std::string source = xml_escaped(recording_name);
    add_collection(out, "surface", source, frames, add_surface);
    add_collection(out, "edges", source, frames, add_edges);
    return out + "</Domain>\n</Xdmf>\n";
}

}  // namespace sherd
