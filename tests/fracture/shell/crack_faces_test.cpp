// SPDX-License-Identifier: GPL-3.0-or-later
// A strip broken in the middle, whose halves are pushed together again: nothing may pass through the crack.
// (Crack faces are called lips.)
#include "fracture/shell/crack_faces.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <memory>

#include "core/contact/crack_faces/crack_face.h"
#include "core/time/implicit_stepper.h"
#include "fracture/shell/breakable_shell.h"
#include "meshops/error.h"
#include "meshops/generate/generate.h"
#include "meshops/intersect/self_intersections.h"
#include "tests/support/shell/materials.h"

namespace sherd {
namespace {

constexpr double closed_strip_length = 0.12, closed_strip_width = 0.04, middle = closed_strip_length / 2;

SheetInput strip_input(Layout layout) {
    SheetInput strip;
    strip.mesh = generate_rectangle(closed_strip_length, closed_strip_width, {0.01, layout, 3});
    strip.material = test::glass;
    return strip;
}

/// Two halves of a broken strip at their original places.
class BrokenStrip {
  public:
    /// step: s.
    BrokenStrip(Layout layout, double step) : sheet({strip_input(layout)}) {
        sheet.fail(rim_of_left_half());
        StepperOptions options;
        options.step = step;
        options.gravity.setZero();
        options.contact.sheets = true;
        time_step = std::make_unique<ImplicitStepper>(sheet.mechanics(), options);
        on_left.resize(sheet.mesh().number_of_vertices());
        for (const Face face : sheet.mesh().faces())
            for (const Vertex v : sheet.mesh().vertices_around_face(sheet.mesh().halfedge(face)))
                on_left[v] = left(face);
    }

    template <class Velocity>
    void set_velocity(const Velocity& of_vertex) {
        Shell& mechanics = sheet.mechanics();
        for (Index v = 0; v < static_cast<Index>(mechanics.position.cols()); ++v)
            mechanics.velocity.col(v) = of_vertex(on_left[v], Vector3d(mechanics.position.col(v)));
    }

    /// Makes one step, and checks that it is solved and that no faces intersect.
    void advance() {
        time_step->begin();
        const StepResult result = time_step->solve(50);
        EXPECT_TRUE(result);
        time_step->finish();
        largest_overlap = std::max(largest_overlap, time_step->crack_face_overlap());
        if (sheet.release_apart()) time_step->topology_changed({});
        expect_no_intersection();
    }

    /// Mean of the positions or velocities `x` of one half, weighted by mass.
    Vector3d mean(const Positions& x, bool of_left) const {
        Vector3d sum = Vector3d::Zero();
        double mass = 0;
        for (Index v = 0; v < static_cast<Index>(x.cols()); ++v) {
            if (on_left[v] != of_left) continue;
            sum += sheet.mechanics().mass[v] * x.col(v);
            mass += sheet.mechanics().mass[v];
        }
        return sum / mass;
    }

    BreakableShell sheet;
    std::unique_ptr<ImplicitStepper> time_step;
    std::vector<char> on_left;   ///< flag of each vertex
    double largest_overlap = 0;  ///< m, of crack faces without barrier

  private:
    bool left(Face face) const {
        double x = 0;
        for (const Vertex v : sheet.mesh().vertices_around_face(sheet.mesh().halfedge(face)))
            x += sheet.mesh().point(v).x() / 3;
        return x < middle;
    }
    /// Edges between a face of the left half and a face of the right half.
    std::vector<Edge> rim_of_left_half() const {
        const Mesh& mesh = sheet.mesh();
        std::vector<Edge> edges;
        for (const Edge edge : mesh.edges())
            if (!mesh.is_border(edge) &&
                left(mesh.face(mesh.halfedge(edge, 0))) != left(mesh.face(mesh.halfedge(edge, 1))))
                edges.push_back(edge);
        return edges;
    }
    void expect_no_intersection() const {
        Mesh mesh = sheet.mesh();
        for (const Vertex v : mesh.vertices()) {
            const Vector3d at = sheet.mechanics().position.col(static_cast<Index>(v));
            mesh.point(v) = Point(at.x(), at.y(), at.z());
        }
        for (const auto& [a, b] : self_intersections(mesh)) {
            bool exempt_pairs = false;
            for (const Vertex p : mesh.vertices_around_face(mesh.halfedge(a)))
                for (const Vertex q : mesh.vertices_around_face(mesh.halfedge(b)))
                    exempt_pairs |= sheet.cracks().original(p) == sheet.cracks().original(q);
            EXPECT_TRUE(exempt_pairs)
                << "faces " << a.idx() << " and " << b.idx() << " pass through each other";
        }
    }
};

class BrokenStrips : public ::testing::TestWithParam<Layout> {};

// Halves that are pushed together in their plane at 1 m/s must bounce off each other, and keep their
// momentum.
TEST_P(BrokenStrips, PushedTogetherInPlaneBounce) {
    BrokenStrip strip(GetParam(), 2e-6);
    strip.set_velocity([](bool left, const Vector3d&) { return Vector3d(left ? 0.5 : -0.5, 0, 0); });
    const Shell& mechanics = strip.sheet.mechanics();
    const Vector3d momentum = mechanics.velocity * mechanics.mass;
    for (int i = 0; i < 50; ++i) strip.advance();
    EXPECT_LT(strip.mean(mechanics.velocity, true).x(), -0.1);
    EXPECT_GT(strip.mean(mechanics.velocity, false).x(), 0.1);
    EXPECT_GT(strip.largest_overlap, 0);
    EXPECT_LT(strip.largest_overlap, 0.01 * test::glass.thickness);
    EXPECT_LT((mechanics.velocity * mechanics.mass - momentum).norm(), 1e-9 * 0.5 * mechanics.mass.sum());
}

// When halves have moved apart, the barrier must act from then on, and keep them a thickness apart when they
// come together again.
TEST_P(BrokenStrips, AreLeftToTheBarrierOnceApart) {
    BrokenStrip strip(GetParam(), 1e-4);
    strip.set_velocity([](bool left, const Vector3d&) { return Vector3d(left ? -5 : 5, 0, 0); });
    for (int i = 0; i < 10; ++i) strip.advance();
    EXPECT_TRUE(strip.sheet.mechanics().exempt_pairs.empty());
    EXPECT_TRUE(strip.sheet.mechanics().crack_faces.empty());
    strip.set_velocity([](bool left, const Vector3d&) { return Vector3d(left ? 5 : -5, 0, 0); });
    for (int i = 0; i < 30; ++i) strip.advance();
    EXPECT_EQ(strip.largest_overlap, 0);
    const Positions& x = strip.sheet.mechanics().position;
    EXPECT_GT(strip.mean(x, false).x() - strip.mean(x, true).x(),
              0.5 * closed_strip_length + 0.75 * test::glass.thickness);
    EXPECT_LT(strip.mean(strip.sheet.mechanics().velocity, true).x(), 0);
}

// Halves are folded like a book about the crack, by 180 degrees and more: the crack faces turn on each
// other, then the halves meet, and nothing may pass.
TEST_P(BrokenStrips, FoldedOntoEachOtherStayApart) {
    BrokenStrip strip(GetParam(), 1e-4);
    strip.set_velocity([](bool left, const Vector3d& x) {
        const double arm = x.x() - middle;
        return Vector3d(left ? 0.1 : -0.1, 0, 100 * std::abs(arm));
    });
    for (int i = 0; i < 300; ++i) strip.advance();
    EXPECT_LT(strip.largest_overlap, 0.1 * test::glass.thickness);
}

// The right half is turned by 90 degrees about the strip's axis, so that crack faces cross like scissors:
// their ends are far from each other, but their middles are near. Contact by the barrier once began all the
// same, and the run ended.
TEST(BrokenStrip, CrackFacesThatCrossAreNotLeftToTheBarrier) {
    BrokenStrip strip(Layout::structured, 1e-4);
    Positions& x = strip.sheet.mechanics().position;
    const double gap = 0.6 * test::glass.thickness;
    const Vector3d centre(middle, 0.375 * closed_strip_width, 0);  // between two vertices of the crack
    for (Eigen::Index v = 0; v < x.cols(); ++v)
        if (!strip.on_left[v]) {
            const Vector3d arm = x.col(v) - centre;
            x.col(v) = centre + Vector3d(arm.x() + gap, -arm.z(), arm.y());
        }
    ASSERT_NO_THROW(strip.time_step->topology_changed({}));
    strip.sheet.release_apart();
    EXPECT_FALSE(strip.sheet.mechanics().exempt_pairs.empty());
    strip.time_step->topology_changed({});
    EXPECT_TRUE(strip.time_step->begin());

    for (Eigen::Index v = 0; v < x.cols(); ++v)
        if (!strip.on_left[v]) x(0, v) += test::glass.thickness;
    EXPECT_TRUE(strip.sheet.release_apart());
    EXPECT_TRUE(strip.sheet.mechanics().exempt_pairs.empty());
}

/// Halves of a strip with a straight crack, whose crack faces are cut by edges that end there.
class CutStrip {
  public:
    CutStrip() : sheet({strip_input(Layout::structured)}) { sheet.fail(crack()); }

    /// Makes an edge from the apex of the triangle at a crack face to a point of this face, at the share
    /// `share` of the face's length.
    void cut(unsigned crack_face, double share) {
        const std::vector<Halfedge> all = crack_faces();
        const Halfedge h = all[crack_face % all.size()];
        const Vertex apex = sheet.mesh().target(sheet.mesh().next(h));
        const Vector3d end =
            (1 - share) * rest(sheet.mesh().source(h)) + share * rest(sheet.mesh().target(h));
        AdvanceOptions options;
        options.snap = false;
        options.always_straight = true;
        sheet.advance(apex, end - rest(apex), options);
    }
    /// Energy, J, of the crack faces when the halves are pushed into each other by `overlap` m.
    double energy(double overlap) {
        Shell& shell = sheet.mechanics();
        Positions x = shell.rest;
        for (const TriangleStencil& triangle : shell.triangles)
            for (const Index v : triangle.vertices)
                if (columns(shell.rest, triangle.vertices).row(0).mean() > middle)
                    x(0, v) = shell.rest(0, v) - overlap;
        return CrackFaceContact(shell.crack_faces).value(x);
    }
    std::size_t crack_face_count() const { return crack_faces().size(); }
    /// Number of the crack face opposite to `crack_face`. After a cut of a face, its first piece keeps the
    /// number.
    unsigned facing(unsigned crack_face) const {
        const std::vector<Halfedge> all = crack_faces();
        for (unsigned other = 0; other < all.size(); ++other)
            if (rest(sheet.mesh().source(all[other])) == rest(sheet.mesh().target(all[crack_face])) &&
                rest(sheet.mesh().target(all[other])) == rest(sheet.mesh().source(all[crack_face])))
                return other;
        throw Error("no lip lies on this one");
    }

  private:
    Vector3d rest(Vertex v) const { return sheet.mechanics().rest.col(static_cast<Index>(v)); }
    bool is_on_crack(Edge edge) const {
        for (const int end : {0, 1})
            if (std::abs(rest(sheet.mesh().vertex(edge, end)).x() - middle) > 1e-9) return false;
        return true;
    }
    std::vector<Edge> crack() const {
        std::vector<Edge> edges;
        for (const Edge edge : sheet.mesh().edges())
            if (is_on_crack(edge)) edges.push_back(edge);
        return edges;
    }
    std::vector<Halfedge> crack_faces() const {
        std::vector<Halfedge> all;
        for (const Edge edge : crack()) {
            const Halfedge h = sheet.mesh().halfedge(edge);
            all.push_back(sheet.mesh().is_border(h) ? sheet.mesh().opposite(h) : h);
        }
        return all;
    }

    BreakableShell sheet;
};

/// Energy, J, of the crack faces of a strip without cuts that overlap by `overlap` m.
double energy_of_whole(double overlap) {
    return 0.5 * test::glass.young / 2 * closed_strip_width * overlap * overlap;
}

// A crack that ends at a closed crack face cuts it. A piece between two such cuts once had no opposite face,
// and passed through.
RC_GTEST_PROP(CutStrip, HasCrackFacesAsStiffAsWholeOnes, ()) {
    CutStrip strip;
    const std::size_t whole = strip.crack_face_count();
    const double overlap = 1e-5, expected = energy_of_whole(overlap);
    RC_ASSERT(std::abs(strip.energy(overlap) / expected - 1) < 1e-9);
    for (int i = 0; i < 8; ++i) strip.cut(*rc::gen::inRange(0u, 1u << 30), *rc::gen::inRange(20, 81) / 100.0);
    RC_PRE(strip.crack_face_count() > whole);
    RC_ASSERT(std::abs(strip.energy(overlap) / expected - 1) < 1e-9);
    RC_ASSERT(strip.energy(-overlap) == 0);
}

// Two cracks end at one place on opposite crack faces: up to rounding the pieces of both faces end there.
// Pieces once had half the stiffness there, or one and a half times as much.
TEST(CutStrip, HasCrackFacesAsStiffThatAreCutAtOnePlaceFromBothSides) {
    const double overlap = 1e-5, expected = energy_of_whole(overlap);
    const std::size_t whole = CutStrip().crack_face_count();
    int both = 0;
    for (unsigned crack_face = 0; crack_face < whole; ++crack_face)
        for (int percent = 20; percent <= 80; ++percent) {
            CutStrip strip;
            const unsigned facing = strip.facing(crack_face);
            strip.cut(crack_face, percent / 100.0);
            strip.cut(facing, 1 - percent / 100.0);
            both += strip.crack_face_count() ==
                    whole + 2;  // not if the bound on angles ended an edge before the crack face
            EXPECT_NEAR(strip.energy(overlap), expected, 1e-9 * expected)
                << crack_face << " at " << percent << " %";
        }
    EXPECT_GT(both, 50);
}

INSTANTIATE_TEST_SUITE_P(Layouts, BrokenStrips, ::testing::Values(Layout::structured, Layout::delaunay),
                         [](const auto& layout) {
                             return layout.param == Layout::structured ? "Straight" : "Zigzag";
                         });

}  // namespace
}  // namespace sherd
