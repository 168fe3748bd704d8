// SPDX-License-Identifier: GPL-3.0-or-later
// frame_intersections RUN.h5...: prints a row of a table for each recording, with the numbers of
// intersections in all its frames. Pairs of faces that intersect or touch in a point in the first frame, and
// pairs of their neighbours, are not counted, since they may continue to intersect.
#include "tests/support/recording/frame_intersections.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "app/recording/recording.h"

namespace sherd {
namespace {

/// Pairs of vertices between which contact keeps no distance: vertices of two faces that intersect in the
/// first frame, and vertices that coincide in it. They have the numbers of their originals at rest.
class CrossingStart {
  public:
    explicit CrossingStart(const Snapshot& first) {
        add_touching(first);
        for (const auto& pair : test::frame_intersections(first).passing)
            for (const Index p : first.faces[pair[0]])
                for (const Index q : first.faces[pair[1]])
                    together.insert(ordered(first.original[p], first.original[q]));
    }

    bool has(const Snapshot& frame, const std::array<Face, 2>& pair) const {
        for (const Index p : frame.faces[pair[0]])
            for (const Index q : frame.faces[pair[1]])
                if (together.contains(ordered(frame.original[p], frame.original[q]))) return true;
        return false;
    }

  private:
    void add_touching(const Snapshot& first) {
        const Positions& x = first.position;
        const double reach = 1e-9 * (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).norm();
        std::vector<Eigen::Index> along(x.cols());
        std::iota(along.begin(), along.end(), 0);
        std::ranges::sort(along, {}, [&](Eigen::Index v) { return x(0, v); });
        for (std::size_t i = 0; i < along.size(); ++i)
            for (std::size_t j = i + 1; j < along.size() && x(0, along[j]) - x(0, along[i]) <= reach; ++j)
                if ((x.col(along[j]) - x.col(along[i])).norm() <= reach)
                    together.insert(ordered(first.original[along[i]], first.original[along[j]]));
    }

    static std::pair<Index, Index> ordered(Index a, Index b) { return std::minmax(a, b); }
    std::set<std::pair<Index, Index>> together;
};

void print_row(const std::filesystem::path& file) {
    const Recording recording(file);
    std::size_t passing = 0, crack_faces = 0, through = 0;
    const std::vector<RecordedObstacle> obstacles = recording.obstacles();
    const CrossingStart start(recording.frame(0));
    for (std::size_t i = 0; i < recording.frame_count(); ++i) {
        const Snapshot frame = recording.frame(i);
        const test::FrameIntersections found = test::frame_intersections(frame);
        passing +=
            std::ranges::count_if(found.passing, [&](const auto& pair) { return !start.has(frame, pair); });
        crack_faces = std::max(crack_faces, found.crack_faces);
        through += test::faces_in_obstacles(frame, obstacles, recording.poses(i));
    }
    double crack_face = 0, obstacle = 0;
    for (const StepReport& step : recording.steps()) {
        crack_face = std::max(crack_face, step.crack_face_overlap);
        obstacle = std::max(obstacle, step.obstacle_overlap);
    }
    const Snapshot last = recording.frame(recording.frame_count() - 1);
    fmt::print("| {} | {} | {} | {} | {} | {} | {} | {:.1f} | {:.1f} |\n", file.stem().string(),
               last.faces.size(), recording.steps().size(), recording.frame_count(), passing, through,
               crack_faces, 1e6 * crack_face, 1e6 * obstacle);
}

}  // namespace
}  // namespace sherd

// NOLINTNEXTLINE(bugprone-exception-escape): an exception may end the program.
int main(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) sherd::print_row(argv[i]);
}
