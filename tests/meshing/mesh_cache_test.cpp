// Where generated meshes are kept.

#include "meshing/mesh_cache.hpp"

#include "support/environment.hpp"
#include "support/paths.hpp"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <iterator>

namespace terp {
namespace {

std::string content(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(ContentKey, IsFnv1a)  // published values of the 64-bit variant
{
  EXPECT_EQ(content_key(""), "cbf29ce484222325");
  EXPECT_EQ(content_key("foobar"), "85944171f73967e8");
}

TEST(MeshCache, LiesWhereTheVariablesSay)
{
  const test::Variable cache("XDG_CACHE_HOME", "/somewhere/cache"), home("HOME", "/home/someone");
  EXPECT_EQ(cached_mesh_path("abc"), "/somewhere/cache/terp/meshes/abc.msh");
  const test::Variable relative("XDG_CACHE_HOME", "not/absolute");
  EXPECT_EQ(cached_mesh_path("abc"), "/home/someone/.cache/terp/meshes/abc.msh");
  const test::Variable nowhere("HOME", "");
  EXPECT_EQ(cached_mesh_path("abc"), "");
}

TEST(MeshCache, KeepsBytesWhole)
{
  const test::ScratchFolder scratch;
  const test::Variable cache("XDG_CACHE_HOME", scratch.path());
  const std::string bytes("a\0b\n", 4);
  EXPECT_EQ(keep_mesh("abc", bytes), cached_mesh_path("abc"));
  EXPECT_EQ(content(cached_mesh_path("abc")), bytes);
  const auto folder = std::filesystem::directory_iterator(scratch.path() + "/terp/meshes");
  EXPECT_EQ(std::distance(begin(folder), end(folder)), 1);
}

TEST(MeshCache, FindsWhatStartsAlikeTheNewestFirst)
{
  const test::ScratchFolder scratch;
  const test::Variable cache("XDG_CACHE_HOME", scratch.path());
  EXPECT_TRUE(cached_meshes("ab-").empty());
  const std::string old = keep_mesh("ab-1", "x"), young = keep_mesh("ab-2", "y");
  keep_mesh("b-1", "z");
  std::filesystem::last_write_time(old, std::filesystem::last_write_time(young) - std::chrono::seconds(5));
  EXPECT_THAT(cached_meshes("ab-"), testing::ElementsAre(young, old));
}

TEST(MeshCache, TakesATemporaryFolderWhereItCannotWrite)
{
  const test::ScratchFolder scratch;
  std::ofstream(scratch.path() + "/file") << "not a folder";
  const test::Variable cache("XDG_CACHE_HOME", scratch.path() + "/file"), temporary("TMPDIR", scratch.path());
  const std::string path = keep_mesh("abc", "bytes");
  EXPECT_THAT(path, testing::StartsWith(scratch.path() + "/terp-mesh-"));
  EXPECT_EQ(content(path), "bytes");
}

TEST(WorkFolder, IsGoneAtTheEnd)
{
  std::string path;
  {
    const WorkFolder folder;
    path = folder.path();
    std::ofstream(path + "/file") << "x";
    EXPECT_TRUE(std::filesystem::exists(path + "/file"));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace terp
