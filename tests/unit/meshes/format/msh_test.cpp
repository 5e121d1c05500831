#include "meshes/format/msh.hpp"

#include "meshes/format/check_mesh.hpp"
#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

using testing::refusal_of;

/// Two unit cells, one above the other, on the axis and on the plate.
Mesh two_cells() {
  return {.vertices = {{0, 0}, {1.0 / 3.0, 0}, {1.0 / 3.0, 1}, {0, 1}, {1.0 / 3.0, 2}, {0, 2}},
          .cells = {{3, 2, 4, 5}, {1, 2, 3, 0}},
          .axis_edges = {{3, 0}, {5, 3}},
          .contact_edges = {{0, 1}}};
}

/// The same as Gmsh 4 writes it, with a stray point at a node of no cell.
const std::string version_4 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
3
1 7 "axis"
1 8 "contact"
2 9 "ball"
$EndPhysicalNames
$Entities
1 2 1 0
1 0.5 0.5 0 0
4 0 0 0 0 2 0 1 7 2 1 -2
5 0 0 0 1 0 0 1 8 2 1 -2
6 0 0 0 1 2 0 1 9 2 4 5
$EndEntities
$Nodes
2 7 1 99
1 4 0 3
11
12
13
0 0 0
0 1 0
0 2 0
2 6 0 4
21
22
23
99
1 0 0
1 1 0
1 2 0
0.5 0.5 0
$EndNodes
$Elements
4 6 1 6
0 1 15 1
1 99
1 4 1 2
2 12 11
3 13 12
1 5 1 1
4 11 21
2 6 3 2
5 11 21 22 12
6 12 22 23 13
$EndElements
)";

TEST(MshTest, WritingAndReadingKeepsEveryBit) {
  const Mesh mesh = two_cells();
  const Mesh read = read_msh(write_msh(mesh), "m");
  EXPECT_EQ(read.vertices, mesh.vertices);
  EXPECT_EQ(read.cells, mesh.cells);
  EXPECT_EQ(read.axis_edges, mesh.axis_edges);
  EXPECT_EQ(read.contact_edges, mesh.contact_edges);
}

TEST(MshTest, ReadsVersionFourAndDropsNodesOfNoCell) {
  const Mesh mesh = read_msh(version_4, "m");
  EXPECT_EQ(mesh.vertices.size(), 6u);
  EXPECT_EQ(mesh.cells.size(), 2u);
  EXPECT_EQ(mesh.axis_edges.size(), 2u);
  ASSERT_EQ(mesh.contact_edges.size(), 1u);
  const auto& end = mesh.vertices[static_cast<std::size_t>(mesh.contact_edges[0][1])];
  EXPECT_EQ(end[0], 1.0);
  EXPECT_EQ(end[1], 0.0);
}

TEST(MshTest, EveryTruncationIsRefused) {
  for (const std::string& text : {write_msh(two_cells()), version_4})
    for (std::size_t length = 0; length + 1 < text.size(); ++length) {
      const std::string cut = text.substr(0, length);
      EXPECT_THROW(read_msh(cut, "m"), Error) << length;
    }
}

struct Changed {
  const char* name;
  const char* from;
  const char* to;
  const char* part;
};

class MshRefuses : public ::testing::TestWithParam<Changed> {};

TEST_P(MshRefuses, WithTheReason) {
  const Changed& c = GetParam();
  std::string text = version_4;
  const auto at = text.find(c.from);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string(c.from).size(), c.to);
  const Error error = refusal_of([&] { read_msh(text, "m.msh"); });
  EXPECT_EQ(error.code(), ExitCode::bad_input);
  EXPECT_EQ(error.location().file, "m.msh");
  EXPECT_NE(std::string(error.what()).find(c.part), std::string::npos) << error.what();
}

INSTANTIATE_TEST_SUITE_P(
    Cases, MshRefuses,
    ::testing::Values(
        Changed{"NoMesh", "$MeshFormat", "# a text", "not a Gmsh mesh"},
        Changed{"Binary", "4.1 0 8", "4.1 1 8", "binary"},
        Changed{"Version", "4.1 0 8", "3.0 0 8", "versions 2.2 and 4.1"},
        Changed{"NoNames", "$PhysicalNames", "$Other", "no named groups"},
        Changed{"NoAxis", "\"axis\"", "\"axle\"", "\"axis\""},
        Changed{"NoContact", "\"contact\"", "\"plate\"", "\"contact\""},
        Changed{"Inverted", "11 21 22 12", "12 22 21 11", "inverted"},
        Changed{"Crossed", "11 21 22 12", "11 22 21 12", "inverted"},
        Changed{"OffAxis", "0 1 0\n0 2 0", "0.01 1 0\n0 2 0", "off the axis"},
        Changed{"LeftOfAxis", "1 2 0\n", "-1 2 0\n", "r < 0"},
        Changed{"BelowPlate", "1 0 0\n", "1 -0.1 0\n", "z < 0"},
        Changed{"OffPlane", "1 2 0\n", "1 2 0.5\n", "off the plane"},
        Changed{"NoNumber", "1 2 0\n", "1 two 0\n", "no number"},
        Changed{"Infinite", "1 2 0\n", "1 inf 0\n", "finite"},
        Changed{"NoSuchNode", "11 21 22 12", "11 21 22 77", "does not exist"},
        Changed{"TwiceANode", "21\n22\n", "21\n21\n", "twice"},
        Changed{"Triangles", "2 6 3 2\n5 11 21 22 12\n6 12 22 23 13\n", "2 6 2 1\n5 11 21 22\n",
                "triangles"},
        Changed{"HugeCount", "1 4 0 3", "1 4 0 999999999999", "truncated"}),
    [](const auto& instance) { return std::string(instance.param.name); });

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
