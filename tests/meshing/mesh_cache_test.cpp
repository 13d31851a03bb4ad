#include "meshing/mesh_cache.hpp"
#include "support/environment.hpp"
#include "support/process.hpp"
#include "support/test.hpp"

namespace mesh_cache_test {

TEST(MeshCache, LiesWhereTheVariablesSay)
{
  const Variable cache("XDG_CACHE_HOME", "/somewhere/cache"), home("HOME", "/home/someone");
  EXPECT_EQ(cached_mesh_path("abc"), "/somewhere/cache/terp/meshes/abc.msh");
  const Variable relative("XDG_CACHE_HOME", "not/absolute");
  EXPECT_EQ(cached_mesh_path("abc"), "/home/someone/.cache/terp/meshes/abc.msh");
  const Variable nowhere("HOME", "");
  EXPECT_EQ(cached_mesh_path("abc"), "");
}

TEST(MeshCache, KeepsBytesWhole)
{
  const ScratchFolder scratch;
  const Variable cache("XDG_CACHE_HOME", scratch.path());
  const std::string bytes("a\0b\n", 4);
  EXPECT_TRUE(keep_mesh("abc", bytes));
  EXPECT_EQ(text_of(cached_mesh_path("abc")), bytes);
  const auto folder = std::filesystem::directory_iterator(scratch.path() + "/terp/meshes");
  EXPECT_EQ(std::distance(begin(folder), end(folder)), 1);
}

TEST(MeshCache, FindsWhatStartsAlikeTheNewestFirst)
{
  const ScratchFolder scratch;
  const Variable cache("XDG_CACHE_HOME", scratch.path());
  EXPECT_TRUE(cached_meshes("ab-").empty());
  for (const char* key : {"ab-1", "ab-2", "b-1"}) ASSERT_TRUE(keep_mesh(key, "x"));
  const std::string old = cached_mesh_path("ab-1"), young = cached_mesh_path("ab-2");
  std::filesystem::last_write_time(old, std::filesystem::last_write_time(young) - std::chrono::seconds(5));
  EXPECT_THAT(cached_meshes("ab-"), ElementsAre(young, old));
}

TEST(MeshCache, SaysThatItCannotBeWritten)
{
  const ScratchFolder scratch;
  std::ofstream(scratch.path() + "/file") << "not a folder";
  const Variable cache("XDG_CACHE_HOME", scratch.path() + "/file");
  EXPECT_FALSE(keep_mesh("abc", "bytes"));
}

}  // namespace mesh_cache_test
