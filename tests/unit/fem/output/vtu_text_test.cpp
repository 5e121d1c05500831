#include "fem/output/vtu_text.hpp"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"
#include "tests/support/vtu.hpp"

namespace rebound::fem {
namespace {

TEST(VtuTextTest, ReadsBackWhatWasWritten) {
  const VtuMesh mesh{
      .points = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 2.0}, {0.0, 2.0}, {2.0, 0.0}, {2.0, 2.0}},
      .connectivity = {0, 1, 2, 3, 1, 4, 5, 2}};
  const VtuFrame frame{.time = 0.00123456789012345678,
                       .of_points = {{"up_m", 3, std::vector<float>(18, 0.25f)}},
                       .of_cells = {{"heat_J", 1, {1.5f, -2.5e10f}}}};
  testing::TemporaryFolder folder;
  folder.write("a.vtu", vtu_text(mesh, frame));
  const auto read = test::read_vtu(folder.path() / "a.vtu");
  EXPECT_EQ(read.points, 6u);
  EXPECT_EQ(read.cells, 2u);
  EXPECT_EQ(read.time, frame.time);
  EXPECT_EQ(read.values("points_m"),
            (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 2, 0, 0, 2, 0, 2, 0, 0, 2, 2, 0}));
  EXPECT_EQ(read.values("connectivity"), (std::vector<double>{0, 1, 2, 3, 1, 4, 5, 2}));
  EXPECT_EQ(read.values("offsets"), (std::vector<double>{4, 8}));
  EXPECT_EQ(read.values("types"), (std::vector<double>{9, 9}));
  EXPECT_EQ(read.arrays.at("up_m").components, 3u);
  EXPECT_EQ(read.arrays.at("up_m").section, "PointData");
  EXPECT_EQ(read.values("up_m"), std::vector<double>(18, 0.25));
  EXPECT_EQ(read.arrays.at("heat_J").section, "CellData");
  EXPECT_EQ(read.values("heat_J"), (std::vector<double>{1.5, -2.5e10f}));
}

// RFC 4648, section 10, by way of the arrays: every length modulo three.
TEST(VtuTextTest, PadsBase64) {
  for (std::size_t cells : {1u, 2u, 3u, 4u}) {
    VtuMesh mesh{.points = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, .connectivity = {}};
    for (std::size_t i = 0; i < cells; ++i)
      mesh.connectivity.insert(mesh.connectivity.end(), {0, 1, 2, 3});
    testing::TemporaryFolder folder;
    folder.write("a.vtu", vtu_text(mesh, {}));
    EXPECT_EQ(test::read_vtu(folder.path() / "a.vtu").values("types"),
              std::vector<double>(cells, 9.0));
  }
}

TEST(VtuTextTest, TheListHasTimesToTheLastDigit) {
  testing::TemporaryFolder folder;
  folder.write("a.pvd", pvd_text({{0.0, "frame-0000.vtu"}, {1.0 / 3.0, "frame-0001.vtu"}}));
  EXPECT_EQ(test::read_pvd(folder.path() / "a.pvd"),
            (std::vector<std::pair<double, std::string>>{{0.0, "frame-0000.vtu"},
                                                         {1.0 / 3.0, "frame-0001.vtu"}}));
}

}  // namespace
}  // namespace rebound::fem
