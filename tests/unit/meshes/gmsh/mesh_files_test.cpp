// What is read of .msh files of every version, and what is refused.
#include <gmsh.h>

#include <algorithm>
#include <filesystem>

#include "fem/interface/interface_stamp.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "meshes/gmsh/gmsh_session.hpp"
#include "meshes/gmsh/interface.hpp"
#include "meshes/gmsh/isolated.hpp"
#include "meshes/quality/check_mesh.hpp"
#include "meshes/quality/mesh_quality.hpp"
#include "tests/support/mesh_files.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"

extern "C" const rebound::GmshModule* rebound_gmsh_module(unsigned long stamp);

namespace rebound {
namespace {

using testing::refusal_of;
using testing::two_cells_msh;

const GmshModule& gmsh_for_files() {
  return *rebound_gmsh_module(interface_stamp);
}

Mesh two_cells() {
  return {.vertices = {{0, 0}, {1.0 / 3.0, 0}, {1.0 / 3.0, 1}, {0, 1}, {1.0 / 3.0, 2}, {0, 2}},
          .cells = {{3, 2, 4, 5}, {1, 2, 3, 0}},
          .axis_edges = {{3, 0}, {5, 3}},
          .contact_edges = {{0, 1}},
          .regions = {1, 0},
          .region_names = {"core", "shell"}};
}

class MshFile : public ::testing::Test {
 protected:
  Mesh read(const std::string& text, const std::string& name = "m.msh") const {
    return gmsh_for_files().read(folder_.write(name, text).string(), 1000, {});
  }
  testing::TemporaryFolder folder_;
};

void expect_same(const Mesh& read, const Mesh& mesh) {
  EXPECT_EQ(read.vertices, mesh.vertices);
  EXPECT_EQ(read.cells, mesh.cells);
  EXPECT_EQ(read.axis_edges, mesh.axis_edges);
  EXPECT_EQ(read.contact_edges, mesh.contact_edges);
}

TEST_F(MshFile, WritingAndReadingKeepsEveryBitAndTheRegions) {
  const Mesh mesh = two_cells();
  const std::string text = gmsh_for_files().msh(mesh);
  EXPECT_EQ(text, gmsh_for_files().msh(mesh));
  const Mesh back = read(text);
  expect_same(back, mesh);
  ASSERT_EQ(back.regions.size(), 2u);
  EXPECT_EQ(back.region_names.at(static_cast<std::size_t>(back.regions[0])), "shell");
  EXPECT_EQ(back.region_names.at(static_cast<std::size_t>(back.regions[1])), "core");
}

TEST_F(MshFile, ACellOfNoRegionStaysSo) {
  Mesh mesh = two_cells();
  mesh.regions = {-1, 0};
  mesh.region_names = {"core"};
  const Mesh back = read(gmsh_for_files().msh(mesh));
  expect_same(back, mesh);
  EXPECT_EQ(back.regions, mesh.regions);
  EXPECT_EQ(back.region_names, mesh.region_names);
}

TEST_F(MshFile, ASphereKeepsEveryBit) {
  const Mesh mesh = generate_sphere_mesh({.radius = 0.0331, .cells = 300});
  expect_same(read(gmsh_for_files().msh(mesh)), mesh);
}

TEST_F(MshFile, NodesOfNoCellAreDropped) {
  const Mesh mesh = read(two_cells_msh);
  EXPECT_EQ(mesh.vertices.size(), 6u);
  EXPECT_EQ(mesh.cells.size(), 2u);
  EXPECT_EQ(mesh.axis_edges.size(), 2u);
  EXPECT_EQ(mesh.region_names, std::vector<std::string>{"ball"});
  ASSERT_EQ(mesh.contact_edges.size(), 1u);
  const auto& end = mesh.vertices[static_cast<std::size_t>(mesh.contact_edges[0][1])];
  EXPECT_EQ(end[0], 1.0);
  EXPECT_EQ(end[1], 0.0);
}

/// The two cells in another version of the format, or in second order, as Gmsh writes them.
struct Format {
  const char* name;
  double version;
  int binary;
};
class MshVersion : public MshFile, public ::testing::WithParamInterface<Format> {
 protected:
  std::string converted(double version, int binary, int order) const {
    const std::string from = folder_.write("from.msh", two_cells_msh).string();
    const std::string to = (folder_.path() / "to.msh").string();
    isolated(
        [&] {
          open_gmsh();
          gmsh::open(from);
          if (order > 1) gmsh::model::mesh::setOrder(order);
          gmsh::option::setNumber("Mesh.MshFileVersion", version);
          gmsh::option::setNumber("Mesh.Binary", binary);
          gmsh::write(to);
          return std::string();
        },
        {.files = Isolation::Files::writes}, {});
    return testing::read_whole(to);
  }
};

TEST_P(MshVersion, IsReadToTheSameCells) {
  const std::string text = converted(GetParam().version, GetParam().binary, 1);
  const Mesh mesh = read(text), same = read(two_cells_msh);
  EXPECT_EQ(measure_quality(mesh).volume, measure_quality(same).volume);
  expect_same(mesh, same);
  EXPECT_EQ(mesh.regions, same.regions);
}

TEST_P(MshVersion, OfSecondOrderIsRefused) {
  const std::string text = converted(GetParam().version, GetParam().binary, 2);
  EXPECT_NE(std::string(refusal_of([&] { read(text); }).what()).find("order 2"), std::string::npos);
}

/// Cut anywhere, with a byte turned over anywhere: a mesh or a refusal, never a crash of this
/// process, and never fewer cells than the file had.
TEST_P(MshVersion, DamagedIsRefused) {
  const std::string text = converted(GetParam().version, GetParam().binary, 1);
  const std::size_t stride = std::max<std::size_t>(1, text.size() / 60);
  const std::size_t whole = text.find("$EndElements") + std::string("$EndElements").size();
  for (std::size_t length = 0; length < whole; length += stride) {
    const Error error = refusal_of([&] { read(text.substr(0, length)); });
    EXPECT_EQ(error.code(), ExitCode::bad_input) << length;
  }
  for (std::size_t place = 1; place < text.size(); place += stride) {
    std::string damaged = text;
    damaged[place] = static_cast<char>(damaged[place] ^ 0x55);
    try {
      EXPECT_LE(read(damaged).cells.size(), 2u) << place;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::bad_input) << place;
      EXPECT_FALSE(error.location().file.empty()) << place;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Every, MshVersion,
                         ::testing::Values(Format{"Ascii22", 2.2, 0}, Format{"Binary22", 2.2, 1},
                                           Format{"Ascii40", 4.0, 0}, Format{"Ascii41", 4.1, 0},
                                           Format{"Binary41", 4.1, 1}),
                         [](const auto& instance) { return std::string(instance.param.name); });

struct Changed {
  const char* name;
  const char* from;
  const char* to;
  const char* part;
};

class MshRefuses : public MshFile, public ::testing::WithParamInterface<Changed> {};

TEST_P(MshRefuses, WithTheReason) {
  const Changed& c = GetParam();
  std::string text = two_cells_msh;
  const auto at = text.find(c.from);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string(c.from).size(), c.to);
  const Error error = refusal_of([&] { read(text); });
  EXPECT_EQ(error.code(), ExitCode::bad_input);
  EXPECT_TRUE(error.location().file.ends_with("m.msh")) << error.location().file;
  EXPECT_NE(std::string(error.what()).find(c.part), std::string::npos) << error.what();
}

INSTANTIATE_TEST_SUITE_P(
    Cases, MshRefuses,
    ::testing::Values(Changed{"NoMesh", "$MeshFormat", "# a text", "not a Gmsh mesh"},
                      Changed{"Version", "4.1 0 8", "7.3 0 8", "Gmsh"},
                      Changed{"NoNames", "3\n1 7 \"axis\"\n1 8 \"contact\"\n2 9 \"ball\"\n", "0\n",
                              "\"axis\""},
                      Changed{"NoAxis", "\"axis\"", "\"axle\"", "\"axis\""},
                      Changed{"NoContact", "\"contact\"", "\"plate\"", "\"contact\""},
                      Changed{"Inverted", "11 21 22 12", "12 22 21 11", "inverted"},
                      Changed{"Crossed", "11 21 22 12", "11 22 21 12", "inverted"},
                      Changed{"OffAxis", "0 1 0\n0 2 0", "0.01 1 0\n0 2 0", "off the axis"},
                      Changed{"LeftOfAxis", "1 2 0\n", "-1 2 0\n", "r < 0"},
                      Changed{"BelowPlate", "1 0 0\n", "1 -0.1 0\n", "z < 0"},
                      Changed{"OffPlane", "1 2 0\n", "1 2 0.5\n", "off the plane"},
                      Changed{"NoNumber", "1 2 0\n", "1 two 0\n", ""},
                      Changed{"Infinite", "1 2 0\n", "1 inf 0\n", "finite"},
                      Changed{"NoSuchNode", "11 21 22 12", "11 21 22 77", ""},
                      Changed{"EdgeOfNoCell", "4 11 21\n", "4 98 99\n", "belongs to no cell"},
                      Changed{"Triangles", "2 6 3 2\n5 11 21 22 12\n6 12 22 23 13\n",
                              "2 6 2 1\n5 11 21 22\n", "triangles"},
                      Changed{"NoCells", "2 6 3 2\n5 11 21 22 12\n6 12 22 23 13\n", "", ""},
                      Changed{"HugeCount", "2 6 0 5", "2 6 0 999999999999", ""},
                      Changed{"NoEnd", "$EndElements", "", "truncated"}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST_F(MshFile, WhatIsNoMeshIsRefused) {
  EXPECT_EQ(refusal_of([&] { read(""); }).code(), ExitCode::bad_input);
  EXPECT_EQ(refusal_of([&] { read("garbage\n\x01\x02"); }).code(), ExitCode::bad_input);
  EXPECT_EQ(refusal_of([&] { read(two_cells_msh, "m.vtk"); }).location().allowed,
            ".msh, .geo, .step or .stp");
  // What begins as anything else would be run as a script.
  const std::string made = (folder_.path() / "made").string();
  refusal_of([&] { read("SystemCall \"touch " + made + "\";\n"); });
  EXPECT_FALSE(std::filesystem::exists(made));
}

TEST_F(MshFile, AFileThatIsNotThereIsAReadingFailure) {
  const auto gone = (folder_.path() / "none.msh").string();
  const Error error = refusal_of([&] { gmsh_for_files().read(gone, 1000, {}); });
  EXPECT_EQ(error.code(), ExitCode::input_output_failed);
  EXPECT_EQ(error.location().file, gone);
  EXPECT_EQ(refusal_of([&] { gmsh_for_files().read("/tmp/.msh/", 1, {}); }).code(),
            ExitCode::bad_input);
}

/// Gmsh takes NAME.opt beside a file for a script.
TEST_F(MshFile, NothingBesideTheFileIsRun) {
  const auto made = folder_.path() / "made";
  folder_.write("m.msh.opt", "SystemCall \"touch " + made.string() + "\";\n");
  EXPECT_EQ(read(two_cells_msh).cells.size(), 2u);
  EXPECT_FALSE(std::filesystem::exists(made));
}

TEST(CheckMeshTest, AnEmptyMeshIsRefused) {
  EXPECT_NE(std::string(refusal_of([] { check_mesh({}, "m"); }).what()).find("no cells"),
            std::string::npos);
}

TEST(CheckMeshTest, AMeshThatHoversIsRefused) {
  Mesh mesh = two_cells();
  for (auto& vertex : mesh.vertices) vertex[1] += 0.5;
  EXPECT_NE(std::string(refusal_of([&] { check_mesh(mesh, "m"); }).what()).find("touches"),
            std::string::npos);
}

}  // namespace
}  // namespace rebound
