#include "model/meshes/gmsh_program.hpp"
#include "model/meshes/mesh_error.hpp"
#include "support/environment.hpp"
#include "support/paths.hpp"
#include <sys/wait.h>
#include <unistd.h>
#include <chrono>

namespace gmsh_program_test {

namespace fs = std::filesystem;

TEST(WorkFolder, IsGoneAtTheEnd)
{
  std::string path;
  {
    const WorkFolder folder;
    path = folder.path();
    std::ofstream(path + "/file") << "x";
    EXPECT_TRUE(fs::exists(path + "/file"));
  }
  EXPECT_FALSE(fs::exists(path));
}

/// Looks two minutes old.
void age(const std::string& path)
{
  fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::minutes(2));
}

TEST(WorkFolder, OfAKilledProcessIsRemovedByTheNextOneAndNoOther)
{
  const ScratchFolder scratch;
  const Variable place("TMPDIR", scratch.path());
  const pid_t child = fork();
  if (child == 0) {
    const WorkFolder folder;
    std::ofstream(folder.path() + "/section.geo") << "x";
    _exit(0);  // as a kill: no destructor runs
  }
  waitpid(child, nullptr, 0);
  ASSERT_EQ(std::distance(fs::directory_iterator(scratch.path()), {}), 1);
  const std::string stale = fs::directory_iterator(scratch.path())->path().string();
  const WorkFolder first;  // the stale one may be a folder that is not locked yet
  EXPECT_TRUE(fs::exists(stale));
  age(stale);
  age(first.path());
  fs::create_directory(scratch.path() + "/other");
  age(scratch.path() + "/other");
  const WorkFolder second;
  EXPECT_FALSE(fs::exists(stale));
  EXPECT_TRUE(fs::exists(first.path()));  // at work
  EXPECT_TRUE(fs::exists(scratch.path() + "/other"));
}

TEST(RunGmsh, HasAHomeOfItsOwnAndSaysHowLongItTakes)
{
  const ScratchFolder scratch;
  std::ofstream(scratch.path() + "/gmsh") << "#!/bin/sh\necho $GMSH_HOME $LC_ALL $1\nexec /bin/sleep 0.5\n";
  fs::permissions(scratch.path() + "/gmsh", fs::perms::owner_all);
  const Variable path("PATH", scratch.path());
  double seconds = -1.0;
  EXPECT_EQ(run_gmsh({"-2"}, "/home", 10.0, [&](double passed) { seconds = passed; }).output, "/home C -2\n");
  EXPECT_GT(seconds, 0.1);
  EXPECT_TRUE(run_gmsh({"-2"}, "/home", 0.1).timed_out);
}

TEST(GmshVersion, IsEmptyWithoutGmshAndRefusedIfItFails)
{
  const ScratchFolder scratch;
  const Variable path("PATH", scratch.path());
  EXPECT_EQ(gmsh_version("/home"), "");
  std::ofstream(scratch.path() + "/gmsh") << "#!/bin/sh\necho no display\nexit 1\n";
  fs::permissions(scratch.path() + "/gmsh", fs::perms::owner_all);
  EXPECT_EQ(refusal<MeshError>([] { gmsh_version("/home"); }), "`gmsh --version` fails: no display\n");
}

}  // namespace gmsh_program_test
