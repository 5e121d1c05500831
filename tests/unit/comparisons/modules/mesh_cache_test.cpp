#include "comparisons/modules/mesh_cache.hpp"

#include "comparisons/config/document.hpp"
#include "meshes/format/msh.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

using testing::read_whole;
using testing::TemporaryFolder;

constexpr SphereMeshRequest request{.radius = 0.0331, .cells = 60};

bool same(const Mesh& a, const Mesh& b) {
  return a.vertices == b.vertices && a.cells == b.cells && a.axis_edges == b.axis_edges &&
         a.contact_edges == b.contact_edges;
}

TEST(MeshCacheTest, TheSecondMeshIsTheFirstBitForBit) {
  const TemporaryFolder cache;
  const CachedMesh made = sphere_mesh(request, cache.path());
  const auto first_written = std::filesystem::last_write_time(made.file);
  const CachedMesh found = sphere_mesh(request, cache.path());
  EXPECT_EQ(std::filesystem::last_write_time(found.file), first_written);
  EXPECT_EQ(found.file, made.file);
  EXPECT_TRUE(same(found.mesh, made.mesh));
  EXPECT_EQ(found.note, "");
}

TEST(MeshCacheTest, AnotherRequestIsAnotherFile) {
  const TemporaryFolder cache;
  SphereMeshRequest other = request;
  other.contact_radius = 0.01;
  EXPECT_NE(sphere_mesh(request, cache.path()).file, sphere_mesh(other, cache.path()).file);
}

TEST(MeshCacheTest, ADamagedFileIsMadeAgainAndReported) {
  const TemporaryFolder cache;
  const CachedMesh made = sphere_mesh(request, cache.path());
  const std::string whole = read_whole(made.file);
  std::string changed = whole;
  changed[whole.find("$Nodes") + 40] ^= 1;
  for (const std::string& damaged : {changed, whole.substr(0, whole.size() / 2), std::string()}) {
    cache.write(made.file.filename().string(), damaged);
    const CachedMesh again = sphere_mesh(request, cache.path());
    EXPECT_NE(again.note.find("damaged"), std::string::npos);
    EXPECT_TRUE(same(again.mesh, made.mesh));
    EXPECT_TRUE(read_whole(made.file) == whole);
  }
}

TEST(MeshCacheTest, ACacheThatCannotBeWrittenIsReportedNotFatal) {
  const TemporaryFolder folder;
  folder.write("file", "");
  const CachedMesh made = sphere_mesh(request, folder.path() / "file");
  EXPECT_FALSE(made.mesh.cells.empty());
  EXPECT_TRUE(made.file.empty());
  EXPECT_NE(made.note.find("not cached"), std::string::npos);
}

TEST(MeshCacheTest, ACachedFileIsAnOrdinaryMshFile) {
  const TemporaryFolder cache;
  const CachedMesh made = sphere_mesh(request, cache.path());
  EXPECT_TRUE(same(read_msh(read_whole(made.file), "m"), made.mesh));
}

}  // namespace
}  // namespace rebound
