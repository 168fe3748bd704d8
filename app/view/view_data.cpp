// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/view_data.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "app/files/base64.h"
#include "app/playback/frame_parents.h"
#include "app/playback/tip_history.h"
#include "app/render/legend/render_colour.h"
#include "app/render/render_solid.h"

namespace sherd {
namespace {

static_assert(std::endian::native == std::endian::little, "browsers read the arrays as they are here");

template <class Number>
std::string base64_of(const std::vector<Number>& numbers) {
    return base64({reinterpret_cast<const std::uint8_t*>(numbers.data()), numbers.size() * sizeof(Number)});
}

/// States of a vertex and of a line on the page.
enum ViewState : std::uint8_t { unbroken, failed_closed, cracked_open };

struct Line {
    Index a, b;
    ViewState state;
};

/// Returns the edges to be drawn: edges that have failed and are closed, and all open edges. Open edges on
/// the rim of the unfractured mesh count as unbroken.
std::vector<Line> lines_of(const Snapshot& frame) {
    std::vector<Line> lines;
    const std::vector<std::array<bool, 3>> open = open_edges(frame.faces), rim = rim_edges(frame.rest);
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        for (int k = 0; k < 3; ++k)
            if (open[f][k])
                lines.push_back(
                    {frame.faces[f][k], frame.faces[f][(k + 1) % 3], rim[f][k] ? unbroken : cracked_open});
    for (std::size_t e = 0; e < frame.edges.size(); ++e)
        if (frame.edge_state[e] == EdgeState::fractured_interior)
            lines.push_back({frame.edges[e][0], frame.edges[e][1], failed_closed});
    return lines;
}

std::vector<std::uint16_t> packed_positions(const Positions& position, const Vector3d& low,
                                            const Vector3d& step) {
    std::vector<std::uint16_t> packed;
    for (Eigen::Index v = 0; v < position.cols(); ++v)
        for (int k = 0; k < 3; ++k) {
            const double x = (position(k, v) - low[k]) / step[k];
            packed.push_back(std::isfinite(x) ? static_cast<std::uint16_t>(std::clamp(x, 0.0, 65535.0) + 0.5)
                                              : 0);
        }
    return packed;
}

std::vector<std::uint8_t> packed_scalar(const std::vector<double>& values, double largest) {
    std::vector<std::uint8_t> packed;
    for (const double value : values)
        packed.push_back(value > 0 ? static_cast<std::uint8_t>(255 * std::min(1.0, value / largest) + 0.5)
                                   : 0);
    return packed;
}

std::vector<std::uint32_t> corners_of(const Snapshot& frame) {
    std::vector<std::uint32_t> corners;
    for (const auto& face : frame.faces) corners.insert(corners.end(), face.begin(), face.end());
    return corners;
}

std::vector<std::uint32_t> owners_of(const Snapshot& frame) {
    return {frame.face_fragment.begin(), frame.face_fragment.end()};
}

/// Returns the changes from `before` to `after`, as pairs of an index and the new value there; `after` may be
/// longer.
std::vector<std::uint32_t> changes(const std::vector<std::uint32_t>& before,
                                   const std::vector<std::uint32_t>& after) {
    std::vector<std::uint32_t> pairs;
    for (std::size_t i = 0; i < after.size(); ++i)
        if (i >= before.size() || before[i] != after[i])
            pairs.insert(pairs.end(), {static_cast<std::uint32_t>(i), after[i]});
    return pairs;
}

/// Vertices and faces whose places in the frame before do not follow from the corners that faces keep.
struct Insertions {
    std::vector<std::uint32_t> vertices;  ///< [4 n] a vertex, and the three earlier vertices between which it
                                          ///< was
    std::vector<float> shares;            ///< [3 n] shares of these three earlier vertices
    std::vector<std::uint32_t> parts;     ///< [2 m] a face, and the earlier face of which it is a part
};

/// Returns, for each vertex of the later frame, the earlier vertex that the page takes for its place in the
/// frame before: found by the corners that faces keep.
std::vector<Index> vertices_before(const Snapshot& earlier, const Snapshot& later) {
    std::vector<Index> before(later.position.cols());
    for (std::size_t v = 0; v < before.size(); ++v)
        before[v] = std::min(static_cast<Index>(v), static_cast<Index>(earlier.position.cols() - 1));
    for (std::size_t f = 0; f < earlier.faces.size(); ++f)
        for (int k = 0; k < 3; ++k) before[later.faces[f][k]] = earlier.faces[f][k];
    return before;
}

Insertions fragment_splits(const Snapshot& earlier, const Snapshot& later) {
    const FrameParents exact = frame_parents(earlier, later);
    const std::vector<Index> known = vertices_before(earlier, later);
    Insertions fragment_splits;
    for (std::size_t v = 0; v < known.size(); ++v) {
        if (exact.weights[v][0] == 1 && exact.vertices[v][0] == known[v]) continue;
        fragment_splits.vertices.push_back(static_cast<std::uint32_t>(v));
        fragment_splits.vertices.insert(fragment_splits.vertices.end(), exact.vertices[v].begin(),
                                        exact.vertices[v].end());
        for (const double share : exact.weights[v])
            fragment_splits.shares.push_back(static_cast<float>(share));
    }
    for (std::size_t f = 0; f < exact.faces.size(); ++f)
        if (exact.faces[f] != static_cast<Index>(f))
            fragment_splits.parts.insert(
                fragment_splits.parts.end(),
                {static_cast<std::uint32_t>(f), static_cast<std::uint32_t>(exact.faces[f])});
    return fragment_splits;
}

/// Packs the frames of a page, one after the other.
class Packer {
  public:
    Packer(const RenderStage& stage, const std::optional<PageLook>& look)
        : look(look ? &*look : nullptr),
          low(stage.everything().min()),
          step((stage.everything().sizes() / 65535).cwiseMax(1e-12)),
          colour(stage.colour()),
          largest(stage.largest()) {}

    PageJson frame(const Snapshot& snapshot) {
        const std::vector<Line> lines = lines_of(snapshot);
        std::vector<std::uint8_t> state(snapshot.position.cols(), unbroken);
        std::vector<std::uint32_t> ends;
        for (const Line& line : lines) {
            for (const Index v : {line.a, line.b}) state[v] = std::max<std::uint8_t>(state[v], line.state);
            ends.insert(ends.end(), {static_cast<std::uint32_t>(line.a), static_cast<std::uint32_t>(line.b),
                                     static_cast<std::uint32_t>(line.state)});
        }
        std::vector<std::uint32_t> new_corners = corners_of(snapshot), new_owners = owners_of(snapshot);
        const bool first = corners.empty();
        const Insertions inserted = first ? Insertions() : fragment_splits(before, snapshot);
        PageJson packed{{"position", base64_of(packed_positions(snapshot.position, low, step))},
                        {"scalar", base64_of(packed_scalar(render_scalar(snapshot, colour).values, largest))},
                        {"state", base64_of(state)},
                        {"lines", base64_of(ends)},
                        {"corners", first ? "" : base64_of(changes(corners, new_corners))},
                        {"owners", first ? "" : base64_of(changes(owners, new_owners))},
                        {"born", base64_of(inserted.vertices)},
                        {"shares", base64_of(inserted.shares)},
                        {"parts", base64_of(inserted.parts)}};
        corners = std::move(new_corners);
        owners = std::move(new_owners);
        if (look) add_look(snapshot, packed);
        before = snapshot;
        return packed;
    }

    const PageLook* look;  ///< null: the page has no look
    Vector3d low, step;
    RenderColour colour;
    double largest;                              ///< scalar that has the brightest colour
    std::vector<std::uint32_t> corners, owners;  ///< values in the frame packed before
    PageLook::Arrays looks;                      ///< values in the frame packed before
    Snapshot before;

  private:
    void add_look(const Snapshot& snapshot, PageJson& packed) {
        PageLook::Arrays after = look->arrays(snapshot);
        const bool first = looks.material.empty();
        packed["texture"] = first ? "" : base64_of(changes(looks.texture, after.texture));
        packed["material"] = first ? "" : base64_of(changes(looks.material, after.material));
        packed["colour"] = first ? "" : base64_of(changes(looks.colour, after.colour));
        looks = std::move(after);
    }
};

/// Returns the look of the first frame.
PageJson look_json(const PageLook& look, const PageLook::Arrays& arrays) {
    PageJson materials = PageJson::array();
    for (const PageLook::Material& material : look.materials())
        materials.push_back({material.colour, material.picture});
    return {{"materials", materials},
            {"pictures", look.pictures().urls()},
            {"texture", base64_of(arrays.texture)},
            {"material", base64_of(arrays.material)},
            {"colour", base64_of(arrays.colour)}};
}

/// Returns the shapes of obstacles, each in its own frame. Planes are left out, as the page draws them as
/// ground.
PageJson obstacles_json(const std::vector<RecordedObstacle>& obstacles) {
    PageJson list = PageJson::array();
    for (const RecordedObstacle& obstacle : obstacles) {
        if (obstacle.plane) continue;
        std::vector<float> points;
        std::vector<std::uint32_t> faces;
        for (const Vector3d& point : obstacle.surface.points)
            for (const double x : point) points.push_back(static_cast<float>(x));
        for (const auto& face : obstacle.surface.triangles)
            faces.insert(faces.end(), face.begin(), face.end());
        list.push_back({{"name", obstacle.name}, {"points", base64_of(points)}, {"faces", base64_of(faces)}});
    }
    return list;
}

/// Returns the poses of all obstacles but planes: for each 4 x 4 numbers, column by column, of the
/// transformation from its own frame to space relative to `origin`.
std::string packed_poses(const std::vector<RecordedObstacle>& obstacles, std::vector<Eigen::Isometry3d> poses,
                         const Vector3d& origin) {
    std::vector<float> numbers;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        if (obstacles[i].plane) continue;
        const Eigen::Matrix4f matrix = poses[i].pretranslate(-origin).matrix().cast<float>();
        numbers.insert(numbers.end(), matrix.data(), matrix.data() + matrix.size());
    }
    return base64_of(numbers);
}

/// Returns the points, m, of all obstacles but planes in a frame; no points for rigid ones.
PageJson packed_shapes(const std::vector<RecordedObstacle>& obstacles, const ObstacleShapes& shapes) {
    PageJson list = PageJson::array();
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        if (obstacles[i].plane) continue;
        std::vector<float> points;
        for (const Vector3d& point : shapes[i])
            for (const double x : point) points.push_back(static_cast<float>(x));
        list.push_back(base64_of(points));
    }
    return list;
}

/// Returns 13 numbers for each crack tip: its number, place relative to `origin` (m), direction, speed (m/s),
/// G / G_c, K_I, K_II, k_1 and k_2 (Pa m^0.5).
std::string packed_tips(std::span<const TipRecord> tips, const Vector3d& origin) {
    std::vector<float> numbers;
    const auto add = [&](auto... values) { (numbers.push_back(static_cast<float>(values)), ...); };
    for (const TipRecord& tip : tips) {
        const Vector3d place = tip.position - origin;
        add(tip.tip, place.x(), place.y(), place.z(), tip.direction.x(), tip.direction.y(), tip.direction.z(),
            tip.speed, tip.released / tip.toughness, tip.opening, tip.shear, tip.bending, tip.twist);
    }
    return base64_of(numbers);
}

PageJson bar_json(const ColourBar& bar) {
    PageJson ticks = PageJson::array();
    for (const BarTick& tick : bar.ticks) ticks.push_back({tick.share, tick.words});
    return {{"title", bar.title}, {"ticks", ticks}, {"below", bar.below}, {"above", bar.above}};
}

/// Returns camera, ground and colours. poses: poses of the obstacles in the first frame, for the ground.
PageJson stage_json(const RenderStage& stage, std::span<const Eigen::Isometry3d> poses) {
    PageJson planes = PageJson::array();
    for (const RenderPlane& plane : stage.ground(poses))
        planes.push_back({vector_json<PageJson>(plane.point.cast<double>()),
                          vector_json<PageJson>(plane.normal.cast<double>())});
    PageJson palette = PageJson::array(), map = PageJson::array();
    for (Index i = 0; i < 21; ++i) palette.push_back(fragment_colour(i));
    for (int i = 0; i < 256; ++i) map.push_back(map_colour(i / 255.0));
    const Camera& camera = stage.camera();
    return {{"up", vector_json<PageJson>(stage.upward())},
            {"eye", vector_json<PageJson>(camera.eye)},
            {"target", vector_json<PageJson>(camera.target)},
            {"angle", camera.view_angle},
            {"radius", stage.radius()},
            {"planes", planes},
            {"palette", palette},
            {"map", map}};
}

}  // namespace

std::vector<std::size_t> shown_frames(std::size_t count, std::size_t frame_bytes, std::size_t most_bytes) {
    const std::size_t wanted =
        std::min(count, std::max<std::size_t>(2, most_bytes / std::max<std::size_t>(1, frame_bytes)));
    std::vector<std::size_t> frames;
    for (std::size_t i = 0; i < wanted; ++i)
        frames.push_back(wanted < 2 ? 0 : i * (count - 1) / (wanted - 1));
    return frames;
}

PageJson view_data(const Recording& recording, const RenderStage& stage,
                   const std::vector<std::size_t>& frames, const std::optional<MeshThinning>& thinning,
                   const std::optional<PageLook>& look) {
    Packer packer(stage, look);
    const TipHistory tips(recording);
    const std::vector<RecordedObstacle> obstacles = recording.obstacles();
    PageJson data = stage_json(stage, recording.poses(frames.front())), packed = PageJson::array(),
             times = PageJson::array(), captions = PageJson::array();
    for (const std::size_t number : frames) {
        const Snapshot snapshot =
            thinning ? thinning->thinned(recording.frame(number)) : recording.frame(number);
        packed.push_back(packer.frame(snapshot));
        packed.back()["poses"] = packed_poses(obstacles, recording.poses(number), stage.centre());
        packed.back()["shapes"] = packed_shapes(obstacles, recording.shapes(number));
        if (!tips.empty())
            packed.back()["tips"] = packed_tips(tips.at(snapshot.step, snapshot.time), stage.centre());
        times.push_back(snapshot.time);
        captions.push_back(stage.caption(snapshot));
        if (number != frames.front()) continue;
        data["faces"] = base64_of(packer.corners);
        data["fragments"] = base64_of(packer.owners);
        if (look) data["look"] = look_json(*look, packer.looks);
    }
    const std::vector<double>& thickness = packer.before.rest.thickness;
    data["thickness"] = base64_of(std::vector<float>(thickness.begin(), thickness.end()));
    data["obstacles"] = obstacles_json(obstacles);
    data["low"] = vector_json<PageJson>(packer.low - stage.centre());
    data["step"] = vector_json<PageJson>(packer.step);
    data["scalar"] = render_scalar(packer.before, packer.colour).name;
    if (const std::optional<ColourBar> bar = stage.colour_bar()) data["bar"] = bar_json(*bar);
    data["captions"] = captions;
    data["time"] = times;
    data["time_unit"] = stage.time_unit();
    data["tips"] = !tips.empty();
    data["number"] = frames;
    data["frames"] = packed;
    return data;
}

}  // namespace sherd
