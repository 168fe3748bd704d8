// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/xdmf.h"

#include <fmt/ostream.h>

#include <algorithm>
#include <ostream>
#include <utility>

#include "app/files/xml_text.h"
#include "app/recording/recording_format.h"

namespace sherd {

namespace {

using namespace recording_format;

constexpr const char* reals = "NumberType=\"Float\" Precision=\"8\"";
constexpr const char* integers = "NumberType=\"Int\" Precision=\"4\"";
constexpr const char* triangles = "TopologyType=\"Triangle\"";
constexpr const char* bytes = "NumberType=\"UChar\" Precision=\"1\"";

/// Returns XDMF's type of the numbers in a dataset of `Value`.
template <class Value>
const char* number_type() {
    using Scalar = typename hdf5::Element<Value>::Scalar;
    return std::same_as<Scalar, double> ? reals : std::same_as<Scalar, std::uint8_t> ? bytes : integers;
}

/// Writes a grid of XDMF, for example a frame of a collection, line by line.
class Grid {
  public:
    /// source: path_in() of the group of its datasets.
    Grid(std::ostream& out, const std::string& name, const std::string& source) : out(out), source(source) {
        add("<Grid Name=\"{}\">\n", name);
    }

    void time(double value) { add("<Time Value=\"{:.17g}\"/>\n", value); }

    void topology(const std::string& attributes, std::size_t count, std::size_t corners,
                  const std::string& dataset) {
        add("<Topology {} NumberOfElements=\"{}\">", attributes, count);
        data(integers, fmt::format("{} {}", count, corners), dataset);
        out << "</Topology>\n";
    }

    void geometry(std::size_t points, const std::string& dataset) {
        out << "<Geometry GeometryType=\"XYZ\">";
        data(reals, fmt::format("{} 3", points), dataset);
        out << "</Geometry>\n";
    }

    void attribute(const std::string& dataset, const std::string& kind, const std::string& center,
                   const std::string& number, const std::string& dimensions) {
        add("<Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">",
            dataset.substr(dataset.find('/') + 1), kind, center);
        data(number, dimensions, dataset);
        out << "</Attribute>\n";
    }

    void end() { out << "</Grid>\n"; }

  private:
    void data(const std::string& number, const std::string& dimensions, const std::string& dataset) {
        add("<DataItem Format=\"HDF\" {} Dimensions=\"{}\">{}{}</DataItem>", number, dimensions, source,
            dataset);
    }

    template <class... Arguments>
    void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::print(out, format, std::forward<Arguments>(arguments)...);
    }

    std::ostream& out;
    std::string source;
};

/// Adds those arrays of a kind of element that ParaView shows. count: number of the elements.
void add_shown(Grid& grid, Elements entries, std::size_t count) {
    const Snapshot types{};
    visit_arrays(types, [&]<class Array>(const SnapshotArray& array, const Array&) {
        if (!array.shown || array.entries != entries) return;
        const std::string center = entries == Elements::vertices ? "Node" : "Cell";
        if constexpr (std::same_as<Array, Positions>)
            grid.attribute(array.name, "Vector", center, reals, fmt::format("{} 3", count));
        else if constexpr (hdf5::Element<typename Array::value_type>::width == 1)
            grid.attribute(array.name, "Scalar", center, number_type<typename Array::value_type>(),
                           std::to_string(count));
    });
}

void add_surface(Grid grid, const XdmfFrame& frame) {
    const std::string faces = std::to_string(frame.faces), vertices = std::to_string(frame.vertices);
    grid.topology(triangles, frame.faces, 3, "face/vertices");
    grid.geometry(frame.vertices, "vertex/position");
    add_shown(grid, Elements::faces, frame.faces);
    for (const std::string& field : frame.fields) {
        grid.attribute("face/" + field, "Vector", "Cell", reals, faces + " 3");
        grid.attribute("face/" + field + principal_suffix, "Matrix", "Cell", reals, faces + " 2");
    }
    grid.attribute("vertex/speed", "Scalar", "Node", reals, vertices);
    add_shown(grid, Elements::vertices, frame.vertices);
    grid.end();
}

void add_edges(Grid grid, const XdmfFrame& frame) {
    grid.topology("TopologyType=\"Polyline\" NodesPerElement=\"2\"", frame.edges, 2, "edge/vertices");
    grid.geometry(frame.vertices, "vertex/position");
    add_shown(grid, Elements::edges, frame.edges);
    grid.end();
}

/// Returns XDMF's path of a group in the file `source`. Without the domain FILE the reader would take what
/// precedes the first colon of the file's name as domain.
std::string path_in(const std::string& source, const std::string& group) {
    return fmt::format("FILE:{}:/{}", source, group);
}

void begin_collection(std::ostream& out, const std::string& name) {
    fmt::print(out, "<Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n", name);
}

template <class AddFrame>
void add_collection(std::ostream& out, const char* name, const std::string& source,
                    std::span<const XdmfFrame> frames, AddFrame add_frame) {
    begin_collection(out, name);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        Grid grid(out, fmt::format("{} {}", name, i), path_in(source, frame_group(i) + "/"));
        grid.time(frames[i].time);
        add_frame(std::move(grid), frames[i]);
    }
    out << "</Grid>\n";
}

/// Writes the i-th obstacle: as a single grid without time if its points are in one dataset for all frames,
/// otherwise as a collection.
void add_obstacle(std::ostream& out, const XdmfObstacle& obstacle, std::size_t i, const std::string& source,
                  std::span<const XdmfFrame> frames) {
    const auto add = [&](const std::string& name, const XdmfFrame& frame, bool at_its_time) {
        Grid grid(out, name, path_in(source, ""));
        if (at_its_time) grid.time(frame.time);
        grid.topology(triangles, obstacle.triangles, 3, obstacle_faces(i));
        grid.geometry(obstacle.points, frame.obstacles[i]);
        grid.end();
    };
    const std::string name = "obstacle " + xml_escaped(obstacle.name);
    const bool rests = std::ranges::all_of(
        frames, [&](const XdmfFrame& frame) { return frame.obstacles[i] == frames.front().obstacles[i]; });
    if (rests) return add(name, frames.front(), false);
    begin_collection(out, name);
    for (std::size_t k = 0; k < frames.size(); ++k) add(fmt::format("{} {}", name, k), frames[k], true);
    out << "</Grid>\n";
}

}  // namespace

void write_xdmf(std::ostream& out, const std::string& recording_name, std::span<const XdmfFrame> frames,
                std::span<const XdmfObstacle> obstacles) {
    out << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n";
    const std::string source = xml_escaped(recording_name);
    add_collection(out, "surface", source, frames, add_surface);
    add_collection(out, "edges", source, frames, add_edges);
    for (std::size_t i = 0; i < obstacles.size() && !frames.empty(); ++i)
        add_obstacle(out, obstacles[i], i, source, frames);
    out << "</Domain>\n</Xdmf>\n";
}

}  // namespace sherd
