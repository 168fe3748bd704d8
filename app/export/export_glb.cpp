// SPDX-License-Identifier: GPL-3.0-or-later
// glb: the fragments of the last frame as nodes, moved rigidly or by morph targets, and obstacles as further
// nodes.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <memory>

#include "app/export/export_clip.h"
#include "app/export/export_formats.h"
#include "app/export/export_sheet.h"
#include "app/export/glb_file.h"
#include "app/export/split_points.h"
#include "app/playback/playback.h"
#include "app/render/creased_surface.h"
#include "meshops/error.h"

namespace sherd {

namespace {

/// Colours of split points: the colours of the vertices or, if there are none, of the faces.
std::vector<Colour> colours(const TriangleSheet& sheet, const SplitPoints& split) {
    if (!sheet.look.vertex_colour.empty()) return gathered(sheet.look.vertex_colour, split.points);
    std::vector<Colour> colours;
    if (sheet.look.face_colour.empty()) return colours;
    for (const auto& [triangle, corner] : split.corners) colours.push_back(sheet.look.face_colour[triangle]);
    return colours;
}

/// Adds the attributes of vertices that are plain numbers, with names in capital letters, as in glTF.
void add_numbers(const SurfaceLook& look, const SplitPoints& split, GlbNode& node) {
    visit_numbers<Vertex>([&](const auto& attribute) {
        const auto& list = look.*attribute.list;
        if constexpr (std::same_as<std::decay_t<decltype(list)>, std::vector<double>>) {
            if (list.empty()) return;
            std::string name = attribute.vtp;
            std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::toupper(c); });
            node.numbers[name] = gathered(list, split.points);
        }
    });
}

std::vector<Vector3d> moved(const std::vector<Vector3d>& points, const Eigen::Isometry3d& motion) {
    std::vector<Vector3d> result;
    for (const Vector3d& point : points) result.push_back(motion * point);
    return result;
}

Positions matrix_of(const std::vector<Vector3d>& points) {
    Positions result(3, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) result.col(static_cast<Eigen::Index>(i)) = points[i];
    return result;
}

Vector3d centroid(const std::vector<Vector3d>& points) {
    return matrix_of(points).rowwise().mean();
}

/// The rigid motion that takes the points `from` nearest to the points `to` in least squares (Umeyama 1991).
Eigen::Isometry3d best_fit(const std::vector<Vector3d>& from, const std::vector<Vector3d>& to) {
    const bool with_scaling = false;
    Eigen::Isometry3d motion;
    motion.matrix() = Eigen::umeyama(matrix_of(from), matrix_of(to), with_scaling);
    return motion;
}

/// Makes the nodes of a clip.
class Animation {
  public:
    Animation(ExportSource& source, Clip& clip)
        : source(source), clip(clip), slowdown(source.pace().slowdown) {}
    GlbScene scene();

  private:
    void add_times(GlbScene& scene);
    void add_nodes(GlbScene& scene);
    void add_bodies(GlbScene& scene);
    void add_motions(GlbScene& scene);
    void add_shapes(GlbScene& scene);
    void add_obstacles(GlbScene& scene);
    void warn_of_deviation(double deviation);
    GlbShape shape_of(std::size_t fragment, const std::vector<Vector3d>& points) const;

    ExportSource& source;
    Clip& clip;
    double slowdown;
    std::vector<TriangleSheet> parts;                ///< mesh of each fragment
    std::vector<SplitPoints> split;                  ///< split points of each fragment
    std::vector<std::vector<std::size_t>> vertices;  ///< numbers of the vertices of each fragment
    std::vector<std::vector<Vector3d>> local;  ///< m, positions of `vertices` about the fragment's centroid
};

GlbScene Animation::scene() {
    GlbScene scene;
    scene.name = source.options.recording.stem().string();
    scene.double_sided = !source.options.solid;
    add_times(scene);
    add_nodes(scene);
    if (source.options.animate == "morph") {
        add_shapes(scene);
    } else {
        add_bodies(scene);
        add_motions(scene);
    }
    add_obstacles(scene);
    return scene;
}

void Animation::add_times(GlbScene& scene) {
    for (std::size_t i = 0; i < clip.size(); ++i)
        scene.times.push_back(slowdown * (clip.time(i) - clip.time(0)));
}

void Animation::add_nodes(GlbScene& scene) {
    const TriangleSheet& topology = clip.topology();
    for (std::size_t i = 0; i < topology.group_names.size(); ++i) {
        GlbNode node;
        node.name = topology.group_names[i];
        parts.push_back(group_part(topology, static_cast<Index>(i)));
        split.push_back(split_points(parts.back()));
        node.triangles = split.back().triangles;
        node.material = parts.back().look.material;
        if (!parts.back().look.texture.empty())
            node.texture = at_points(split.back(), parts.back().look.texture);
        node.colour = colours(parts.back(), split.back());
        add_numbers(parts.back().look, split.back(), node);
        scene.nodes.push_back(node);
    }
}

/// Returns the shape of a fragment with these points.
GlbShape Animation::shape_of(std::size_t fragment, const std::vector<Vector3d>& points) const {
    return {gathered(points, split[fragment].points),
            at_points(split[fragment], corner_normals(points, parts[fragment]))};
}

/// Gives the node of each fragment a single shape: that of the last frame, with its centroid at the origin.
void Animation::add_bodies(GlbScene& scene) {
    const std::size_t last = clip.size() - 1;
    const std::vector<Vector3d> sheet_points = clip.sheet_points(last), points = clip.points(last);
    const TriangleSheet sheet = frame_sheet(source.frame(source.frames().back()));
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const auto fragment = static_cast<Index>(i);
        vertices.push_back(group_points(sheet, fragment));
        if (vertices[i].empty())
            throw Error(
                fmt::format("'{}' is damaged: its last frame has fragments after {}, which has no face",
                            source.options.recording.string(), scene.nodes[i].name));
        const std::vector<Vector3d> own = gathered(sheet_points, vertices[i]);
        const Eigen::Isometry3d to_origin(Eigen::Translation3d(-centroid(own)));
        local.push_back(moved(own, to_origin));
        scene.nodes[i].shapes.push_back(
            shape_of(i, moved(gathered(points, group_points(clip.topology(), fragment)), to_origin)));
    }
}

void Animation::add_motions(GlbScene& scene) {
    double deviation = 0;
    for (std::size_t k = 0; k < clip.size(); ++k) {
        const std::vector<Vector3d> points = clip.sheet_points(k);
        for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
            const std::vector<Vector3d> target = gathered(points, vertices[i]);
            const Eigen::Isometry3d motion = best_fit(local[i], target);
            scene.nodes[i].motions.push_back(motion);
            const Positions off = matrix_of(moved(local[i], motion)) - matrix_of(target);
            deviation = std::max(deviation, off.colwise().norm().maxCoeff());
        }
    }
    warn_of_deviation(deviation);
}

/// Warns if the recording deviates visibly from rigid motions. deviation: largest distance from them, m.
void Animation::warn_of_deviation(double deviation) {
    const Positions all = matrix_of(clip.sheet_points(clip.size() - 1));
    const double size = (all.rowwise().maxCoeff() - all.rowwise().minCoeff()).norm();
    if (deviation > 0.01 * size)
        source.warnings.push_back(
            fmt::format("the fragments deform: their rigid motions differ from the recording by up to {:.2g} "
                        "m; --animate morph shows the deformation",
                        deviation));
}

void Animation::add_shapes(GlbScene& scene) {
    for (GlbNode& node : scene.nodes) node.motions.push_back(Eigen::Isometry3d::Identity());
    for (std::size_t k = 0; k < clip.size(); ++k) {
        const std::vector<Vector3d> points = clip.points(k);
        for (std::size_t i = 0; i < scene.nodes.size(); ++i)
            scene.nodes[i].shapes.push_back(
                shape_of(i, gathered(points, group_points(clip.topology(), static_cast<Index>(i)))));
    }
}

/// Adds a node for each obstacle. Its origin is the obstacle's middle, about which the obstacle turns between
/// frames. A deforming obstacle has a shape for each frame instead of motions.
void Animation::add_obstacles(GlbScene& scene) {
    const std::vector<ExportObstacle>& obstacles = source.obstacles();
    const std::size_t first = scene.nodes.size();
    std::vector<CreasedSurface> surfaces;
    for (const ExportObstacle& obstacle : obstacles) {
        surfaces.push_back(creased(obstacle.surface));
        const CreasedSurface& surface = surfaces.back();
        const Eigen::Isometry3d to_middle(Eigen::Translation3d(-middle(obstacle.surface)));
        GlbNode node{.name = obstacle.name, .obstacle = true, .triangles = surface.triangles};
        if (obstacle.deforms)
            node.motions = {Eigen::Isometry3d::Identity()};
        else
            node.shapes = {{moved(surface.points, to_middle), surface.normals}};
        scene.nodes.push_back(node);
    }
    for (std::size_t k = 0; k < clip.size(); ++k) {
        const std::vector<Eigen::Isometry3d> poses = source.poses(source.frames()[k]);
        const ObstacleShapes shapes = source.shapes(source.frames()[k]);
        for (std::size_t i = 0; i < obstacles.size(); ++i) {
            GlbNode& node = scene.nodes[first + i];
            if (obstacles[i].deforms) {
                const CreasedSurface shape = reshaped(surfaces[i], shapes[i]);
                node.shapes.push_back({shape.points, shape.normals});
            } else if (k == 0 || obstacles[i].moves) {
                node.motions.push_back(poses[i] * Eigen::Translation3d(middle(obstacles[i].surface)));
            }
        }
    }
}

}  // namespace

std::vector<ExportJob> plan_glb(ExportSource& source) {
    if (source.frames().size() > 1) source.pace_text = source.pace().words();
    const auto clip = std::make_shared<Clip>(source, recorded_times(source.frames(), source.times()));
    return {{source.clip_file(".glb"),
             [&source, clip] { return glb_bytes(Animation(source, *clip).scene(), source.warnings); }}};
}

}  // namespace sherd
