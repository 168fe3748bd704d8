// SPDX-License-Identifier: GPL-3.0-or-later
// Exported files of single frames, read back byte by byte: ply with its scalar, stl, pvd with vtp, and
// solids.
#include <Eigen/Geometry>
#include <cmath>
#include <csignal>
#include <fstream>
#include <set>

#include "app/export/export_vtp.h"
#include "app/progress/interruption.h"
#include "meshops/topology/components.h"
#include "tests/support/recording/export_fixture.h"
#include "tests/support/recording/vtp_array.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

/// Largest strain of a face's edges in a frame, found by a search over all edges.
double strain_of(const Snapshot& frame, std::size_t face) {
    const std::set<Index> corners(frame.faces[face].begin(), frame.faces[face].end());
    double strain = 0;
    for (std::size_t e = 0; e < frame.edges.size(); ++e)
        if (corners.contains(frame.edges[e][0]) && corners.contains(frame.edges[e][1]))
            strain = std::max(strain, std::abs(frame.edge_strain[e]));
    return strain;
}

/// Property `quality` of the faces of a PLY file written by Sherd.
std::vector<double> quality_of(const std::string& ply, std::size_t vertices, std::size_t faces) {
    const std::string end = "end_header\n";
    Bytes bytes(ply, ply.find(end) + end.size());
    for (std::size_t i = 0; i < 3 * vertices; ++i) bytes.next<double>();
    std::vector<double> quality;
    for (std::size_t f = 0; f < faces; ++f) {
        EXPECT_EQ(bytes.next<std::uint8_t>(), 3);
        for (int k = 0; k < 4; ++k) bytes.next<std::int32_t>();
        quality.push_back(bytes.next<double>());
    }
    EXPECT_TRUE(bytes.at_end());
    return quality;
}

void expect_arrays_of(const std::string& vtp, const Snapshot& frame) {
    const auto doubles = [](const Positions& x) {
        return std::vector<double>(x.data(), x.data() + x.size());
    };
    EXPECT_EQ(vtp_array<double>(vtp, "Float64", "Points"), doubles(frame.position));
    EXPECT_EQ(vtp_array<double>(vtp, "Float64", "velocity"), doubles(frame.velocity));
    EXPECT_EQ(vtp_array<double>(vtp, "Float64", "speed").size(), frame.position.cols());
    EXPECT_EQ(vtp_array<Index>(vtp, "Int32", "fragment"), frame.face_fragment);
    EXPECT_EQ(vtp_array<Index>(vtp, "Int32", "sheet"), frame.face_sheet);
    const auto strain = vtp_array<double>(vtp, "Float64", "strain");
    const auto corners = vtp_array<Index>(vtp, "Int32", "connectivity");
    const auto ends = vtp_array<std::int64_t>(vtp, "Int64", "offsets");
    ASSERT_EQ(corners.size(), 3 * frame.faces.size());
    ASSERT_TRUE(strain.size() == frame.faces.size() && ends.size() == frame.faces.size());
    for (std::size_t f = 0; f < frame.faces.size(); ++f) {
        EXPECT_TRUE(std::equal(frame.faces[f].begin(), frame.faces[f].end(), corners.begin() + 3 * f));
        EXPECT_EQ(ends[f], static_cast<std::int64_t>(3 * f + 3));
        EXPECT_EQ(strain[f], strain_of(frame, f));
    }
}

// MeshLab shows the property only if its name is `quality`.
TEST_F(Export, PlyHasStrainOrAnotherScalarAsQuality) {
    const Snapshot& frame = run.frames[2];
    const auto quality = [&](const std::string& name) {
        ExportOptions wanted = options("ply", name + ".ply");
        wanted.quality = name;
        export_recording(wanted);
        const std::string ply = bytes(name + ".ply");
        EXPECT_NE(ply.find("property int fragment\nproperty double quality\n"), std::string::npos);
        return quality_of(ply, frame.original.size(), frame.faces.size());
    };
    const auto strain = quality("strain"), speed = quality("speed"), fragment = quality("fragment");
    double largest = 0;
    for (std::size_t f = 0; f < frame.faces.size(); ++f) {
        EXPECT_EQ(strain[f], strain_of(frame, f));
        largest = std::max(largest, strain[f]);
        double sum = 0;
        for (const Index v : frame.faces[f]) sum += frame.velocity.col(v).norm();
        EXPECT_NEAR(speed[f], sum / 3, 1e-12 * sum);
        EXPECT_EQ(fragment[f], frame.face_fragment[f]);
    }
    EXPECT_GT(largest, 0);
}

TEST_F(Export, StlHasEveryTriangleInItsOrder) {
    export_recording(options("stl", "out.stl"));
    const Snapshot& frame = run.frames[2];
    Bytes stl(bytes("out.stl"));
    EXPECT_FALSE(stl.text(80).starts_with("solid")) << "readers would take it for text";
    ASSERT_EQ(stl.next<std::uint32_t>(), frame.faces.size());
    for (const auto& face : frame.faces) {
        const Vector3d p = frame.position.col(face[0]), q = frame.position.col(face[1]),
                       r = frame.position.col(face[2]);
        const Vector3d normal = (q - p).cross(r - p).normalized();
        for (const double n : normal) EXPECT_EQ(stl.next<float>(), static_cast<float>(n));
        for (const Vector3d& corner : {p, q, r})
            for (const double x : corner) EXPECT_EQ(stl.next<float>(), static_cast<float>(x));
        stl.next<std::uint16_t>();
    }
    EXPECT_TRUE(stl.at_end());
}

TEST_F(Export, StlFragmentsAreFiles) {
    ExportOptions wanted = options("stl", "pieces");
    wanted.fragments = true;
    EXPECT_EQ(export_recording(wanted).files.size(), 3u);
    EXPECT_EQ(read("pieces/run_000002_fragment_002.stl").number_of_faces(), 48u);
}

// The .pvd file must list every frame, with its time. (tests/partners/check_pvd.py lets ParaView read it.)
TEST_F(Export, PvdNamesAFileForEachFrame) {
    const auto files = export_recording(options("pvd", "out.pvd")).files;
    ASSERT_EQ(files.size(), 4u);
    const std::string index = bytes("out.pvd");
    for (int i = 0; i < 3; ++i) {
        const std::string name = "out_00000" + std::to_string(i) + ".vtp";
        EXPECT_EQ(files[i], folder.path / name);
        EXPECT_NE(index.find("file=\"" + name + "\""), std::string::npos);
        expect_arrays_of(bytes(name), run.frames[i]);
    }
    EXPECT_NE(index.find("timestep=\"0.10000000000000001\""), std::string::npos);
}

// Arrays must be correct if they fill several zlib blocks, with the last block full or not: otherwise
// ParaView would show noise, or nothing.
TEST_F(Export, VtpHoldsArraysOfAnyLength) {
    Snapshot frame = run.frames[2];
    for (const Eigen::Index vertices : {3000, 4096}) {
        frame.position = Positions::Random(3, vertices);
        frame.velocity = Positions::Zero(3, vertices);
        expect_arrays_of(vtp_bytes(frame), frame);
    }
}

TEST_F(Export, SolidsAreClosedBodiesOnePerFragment) {
    for (const std::string format : {"obj", "ply", "stl"}) {
        ExportOptions wanted = options(format, "solid." + format);
        wanted.solid = true;
        const ExportReport report = export_recording(wanted);
        EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
        const Mesh mesh = read("solid." + format);
        EXPECT_TRUE(CGAL::is_closed(mesh)) << format;
        EXPECT_EQ(connected_components(mesh).count, 3) << format;
    }
}

// Recordings of earlier versions have no thickness: then the user must be able to give it.
TEST_F(Export, ThicknessComesFromTheRecordingOrTheUser) {
    run.header.rest_thickness.clear();
    set_rest(run);
    record(run, folder.path / "old.h5");
    ExportOptions wanted = options("obj", "out.obj");
    wanted.recording = folder.path / "old.h5";
    export_recording(wanted);
    wanted.force = wanted.solid = true;
    EXPECT_NE(error_of(wanted).find("--thickness"), std::string::npos);
    wanted.thickness = 1e-3;
    export_recording(wanted);
    for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        wanted.thickness = bad;
        EXPECT_NE(error_of(wanted).find("above 0"), std::string::npos);
    }
}

TEST_F(Export, SolidThatIntersectsItselfIsToldOf) {
    ExportOptions wanted = options("obj", "out.obj");
    wanted.solid = true;
    wanted.thickness = 0.2;
    const ExportReport report = export_recording(wanted);
    ASSERT_FALSE(report.warnings.empty());
    EXPECT_NE(report.warnings.front().find("intersects itself"), std::string::npos)
        << report.warnings.front();
}

TEST_F(Export, RefusesOptionsThatTheFormatDoesNotKnow) {
    const auto before = folder.contents();
    ExportOptions wanted = options("pvd", "out.pvd");
    wanted.solid = true;
    EXPECT_NE(error_of(wanted).find("--solid"), std::string::npos);
    wanted.solid = false;
    wanted.fragments = true;
    EXPECT_NE(error_of(wanted).find("--fragments"), std::string::npos);
    wanted = options("ply", "out.ply");
    wanted.quality = "colour";
    EXPECT_NE(error_of(wanted).find("strain or speed or fragment"), std::string::npos);
    wanted = options("obj", "out.obj");
    wanted.thickness = 1e-3;
    EXPECT_NE(error_of(wanted).find("--solid"), std::string::npos) << "it would change nothing";
    wanted = options("obj", "out.obj");
    wanted.animate = "morph";
    EXPECT_NE(error_of(wanted).find("--to glb"), std::string::npos);
    EXPECT_EQ(folder.contents(), before);
}

/// Exports after Ctrl-C was pressed. Returns 42 if the export was interrupted with an error that says so, 2
/// after another error, and 0 if it was completed.
int exit_code_after_interruption(const ExportOptions& options) {
    watch_for_interruption();
    std::raise(SIGINT);
    try {
        export_recording(options);
    } catch (const Error& error) {
        return error.fault == Fault::run && std::string(error.what()).starts_with("interrupted") ? 42 : 2;
    }
    return 0;
}

TEST_F(Export, EndsCleanlyOnCtrlC) {
    ExportOptions wanted = options("obj", "out.obj");
    wanted.frames = "all";
    GTEST_FLAG_SET(death_test_style, "threadsafe");  // other tests have left threads behind
    EXPECT_EXIT(std::_Exit(exit_code_after_interruption(wanted)), ::testing::ExitedWithCode(42), "");
    for (const auto& [file, content] : folder.contents()) EXPECT_FALSE(file.ends_with(".part"));
}

// The stress and curvature of each face must be the numbers that `sherd info` compares.
TEST_F(Export, PlyHasTheLargestStressAndCurvature) {
    add_fields(run);
    record(run, folder.path / "fields.h5");
    const Snapshot& last = run.frames.back();
    for (const std::string name : {"stress", "curvature"}) {
        ExportOptions wanted = options("ply", name + ".ply");
        wanted.quality = name;
        EXPECT_NE(error_of(wanted).find("output.fields = [\"" + name + "\"]"), std::string::npos);
        EXPECT_FALSE(std::filesystem::exists(wanted.output));
        wanted.recording = folder.path / "fields.h5";
        export_recording(wanted);
        const std::vector<double> found =
            quality_of(bytes(name + ".ply"), last.original.size(), last.faces.size());
        const VectorXd largest =
            name == "stress" ? largest_stress(last.fields) : largest_curvature(last.fields);
        EXPECT_EQ(found, std::vector<double>(largest.begin(), largest.end()));
    }
}

TEST_F(Export, VtpHasFieldsAndTheirPrincipalValues) {
    EXPECT_EQ(vtp_bytes(run.frames[0]).find("stress"), std::string::npos);
    add_fields(run);
    const FaceFields& fields = run.frames[0].fields;
    const std::string vtp = vtp_bytes(run.frames[0]);
    const auto stress = vtp_array<double>(vtp, "Float64", "stress_bottom"),
               principal = vtp_array<double>(vtp, "Float64", "curvature_principal");
    EXPECT_EQ(stress, std::vector<double>(fields.stress_bottom.data(),
                                          fields.stress_bottom.data() + fields.stress_bottom.size()));
    const Eigen::Matrix2Xd curvature = principal_values(fields.curvature, true);
    EXPECT_EQ(principal, std::vector<double>(curvature.data(), curvature.data() + curvature.size()));
}

}  // namespace
}  // namespace sherd::test
