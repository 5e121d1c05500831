// What Gmsh meshes: the sphere, scripts, STEP files.
#include <gmsh.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "fem/interface/interface_stamp.hpp"
#include "meshes/gmsh/gmsh_session.hpp"
#include "meshes/gmsh/interface.hpp"
#include "meshes/gmsh/isolated.hpp"
#include "meshes/quality/mesh_quality.hpp"
#include "meshes/refine/refined_mesh.hpp"
#include "tests/support/mesh_files.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"

extern "C" const rebound::GmshModule* rebound_gmsh_module(unsigned long stamp);

namespace rebound {
namespace {

using testing::ball_geo;
using testing::refusal_of;

constexpr double radius = 0.0331;
constexpr double volume = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;

const GmshModule& gmsh_of_test() {
  return *rebound_gmsh_module(interface_stamp);
}

TEST(UnstructuredSphere, HasTheCellsAndTheVolumeAskedFor) {
  for (const SpherePart part : {SpherePart::whole, SpherePart::lower_half})
    for (const int cells : {60, 500, 1000}) {
      const Mesh mesh = gmsh_of_test().sphere({.radius = radius, .cells = cells, .part = part}, {});
      const MeshQuality quality = measure_quality(mesh);
      EXPECT_NEAR(quality.cells, cells, 0.15 * cells);
      EXPECT_GT(quality.worst_scaled_jacobian, 0.3);
      const double whole = (part == SpherePart::whole ? 1.0 : 0.5) * volume;
      EXPECT_NEAR(quality.volume / whole, 1.0, 3.0 / cells);
      for (const auto& edge : mesh.axis_edges)
        for (const int vertex : edge)
          EXPECT_EQ(mesh.vertices[static_cast<std::size_t>(vertex)][0], 0.0);
      for (const auto& edge : mesh.contact_edges)
        for (const int vertex : edge) {
          const auto& [r, z] = mesh.vertices[static_cast<std::size_t>(vertex)];
          EXPECT_NEAR(std::hypot(r, z - radius) / radius, 1.0, 1e-9);
        }
    }
}

TEST(UnstructuredSphere, IsGradedToThePoleAndTheSameEachTime) {
  const SphereMeshRequest request{.radius = radius, .cells = 500, .grading = 8.0};
  const Mesh graded = gmsh_of_test().sphere(request, {}),
             again = gmsh_of_test().sphere(request, {});
  EXPECT_EQ(graded.vertices, again.vertices);
  EXPECT_EQ(graded.cells, again.cells);
  const Mesh even = gmsh_of_test().sphere({.radius = radius, .cells = 500, .grading = 1.0}, {});
  EXPECT_LT(measure_quality(graded).contact_edge_length,
            0.7 * measure_quality(even).contact_edge_length);
}

TEST(UnstructuredSphere, RefusesWhatItCannotMake) {
  for (const SphereMeshRequest& request :
       {SphereMeshRequest{.radius = 0.0}, SphereMeshRequest{.radius = radius, .cells = 3},
        SphereMeshRequest{.radius = radius, .grading = 0.5},
        SphereMeshRequest{.radius = radius, .grading = 1e3}})
    EXPECT_EQ(refusal_of([&] { gmsh_of_test().sphere(request, {}); }).code(), ExitCode::bad_input);
}

TEST(UnstructuredSphere, StopsWhenInterrupted) {
  const RunControl stopped{.interrupted = [] { return true; }, .progress = {}};
  EXPECT_EQ(refusal_of([&] {
              gmsh_of_test().sphere({.radius = radius, .cells = 100000}, stopped);
            }).code(),
            ExitCode::interrupted);
}

class GeometryFile : public ::testing::Test {
 protected:
  Mesh read(const std::string& text, const std::string& name, int cells = 1000) const {
    return gmsh_of_test().read(folder_.write(name, text).string(), cells, {});
  }
  /// What Gmsh's other kernel exports; lengths in the unit that STEP files state, mm.
  std::string step_of(const std::function<void()>& make) const {
    const std::string file = (folder_.path() / "made.step").string();
    isolated(
        [&] {
          open_gmsh();
          gmsh::option::setString("Geometry.OCCTargetUnit", "");
          gmsh::model::add("made");
          make();
          gmsh::model::occ::synchronize();
          gmsh::write(file);
          return std::string();
        },
        {.files = Isolation::Files::writes}, {});
    return testing::read_whole(file);
  }
  testing::TemporaryFolder folder_;
};

std::map<std::string, int> cells_of_regions(const Mesh& mesh) {
  std::map<std::string, int> count;
  for (const int region : mesh.regions)
    ++count[mesh.region_names.at(static_cast<std::size_t>(region))];
  return count;
}

TEST_F(GeometryFile, AScriptIsMeshedWithItsSurfacesAsRegions) {
  const Mesh mesh = read(ball_geo, "ball.geo");
  EXPECT_NEAR(measure_quality(mesh).volume / volume, 1.0, 0.02);
  const auto count = cells_of_regions(mesh);
  ASSERT_EQ(count.size(), 2u);
  EXPECT_GT(count.at("core"), 10);
  EXPECT_GT(count.at("shell"), count.at("core"));

  // Neither refinement nor a file loses them.
  const Mesh fine = refined_mesh(mesh, radius);
  for (const auto& [name, cells] : cells_of_regions(fine)) EXPECT_EQ(cells, 4 * count.at(name));
  const Mesh back = read(gmsh_of_test().msh(fine), "fine.msh");
  EXPECT_EQ(cells_of_regions(back), cells_of_regions(fine));
  EXPECT_EQ(back.vertices, fine.vertices);
}

TEST_F(GeometryFile, AScriptWithoutGroupsOrSurfacesOrSenseIsRefused) {
  const auto refused = [&](const std::string& text, const std::string& part) {
    const Error error = refusal_of([&] { read(text, "ball.geo"); });
    EXPECT_EQ(error.code(), ExitCode::bad_input);
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  };
  refused(ball_geo.substr(0, ball_geo.find("Physical")), "\"axis\"");
  refused("Point(1) = {0, 0, 0};\n", "no surface");
  refused("Pint(1) = {0, 0, 0, ;\n", "Gmsh");
}

TEST_F(GeometryFile, AStepFileIsMeshedInMetresWithGroupsOfItsOwn) {
  const std::string step = step_of([] {
    constexpr double mm = 1e3;
    const int disk = gmsh::model::occ::addDisk(0, mm * radius, 0, mm * radius, mm * radius);
    const int right = gmsh::model::occ::addRectangle(0, -100, 0, 200, 400);
    gmsh::vectorpair made;
    std::vector<gmsh::vectorpair> map;
    gmsh::model::occ::intersect({{2, disk}}, {{2, right}}, made, map);
  });
  for (const int cells : {300, 1000}) {
    const Mesh mesh = read(step, "ball.step", cells);
    const MeshQuality quality = measure_quality(mesh);
    EXPECT_NEAR(quality.volume / volume, 1.0, 0.01);
    EXPECT_NEAR(quality.cells, cells, 0.35 * cells);
    EXPECT_FALSE(mesh.axis_edges.empty());
  }
}

TEST_F(GeometryFile, AStepFileOfASolidOrOfNothingIsRefused) {
  const std::string ball = step_of([] { gmsh::model::occ::addSphere(0, 33.1, 0, 33.1); });
  EXPECT_NE(std::string(refusal_of([&] { read(ball, "ball.step"); }).what()).find("solid"),
            std::string::npos);
  const std::string head = ball.substr(0, ball.size() / 2);
  for (const std::string& text : {head, std::string("no STEP"), std::string("ISO-10303-21;\n")})
    EXPECT_EQ(refusal_of([&] { read(text, "ball.step"); }).code(), ExitCode::bad_input);
}

}  // namespace
}  // namespace rebound
