#include "input/other_files.hpp"

#include "input/samples.hpp"
#include "support/paths.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace terp {
namespace {

using testing::HasSubstr;
using namespace test;

class OtherFiles : public testing::Test {
 protected:
  std::string seen_with(const std::string& mesh_keys) const
  {
    try {
      read_case_text(small_case_on(mesh_keys), folder_.path() + "/case.toml");
    } catch (const CaseError& error) {
      return error.what();
    }
    return "accepted";
  }
  const ScratchFolder folder_;
};

TEST_F(OtherFiles, AreLookedForBesideTheCaseFile)
{
  std::ofstream(folder_.path() + "/dike.msh");
  EXPECT_EQ(seen_with("file = \"dike.msh\""), "accepted");
  EXPECT_EQ(seen_with("file = \"" + folder_.path() + "/dike.msh\""), "accepted");
}

TEST_F(OtherFiles, ThatAreMissingAreShownAtTheirKey)
{
  std::ofstream(folder_.path() + "/dike.msh"), std::ofstream(folder_.path() + "/dyke.geo");
  EXPECT_EQ(seen_with("file = \"dyke.msh\""),
      "error: " + folder_.path() +
          "/case.toml:4:8: there is no such file\n\n    4 | file = \"dyke.msh\"\n      |        ^^^^^^^^^^\n  Did you "
          "mean `dike.msh`?\n  Looked for " +
          folder_.path() +
          "/dyke.msh; names are relative to the case file.\n  More: terp explain mesh.file\n\n1 error; nothing was "
          "run.\n");
}

TEST_F(OtherFiles, MayNotBeFolders)
{
  std::filesystem::create_directory(folder_.path() + "/mesh");
  EXPECT_THAT(seen_with("file = \"mesh\""), HasSubstr(":4:8: this is a folder, not a file\n"));
}

TEST_F(OtherFiles, OfPointsAreCheckedToo)
{
  std::ofstream(folder_.path() + "/points.csv");
  const std::string seen = seen_with("size = [16.0, 3.0]\ncell = 0.5\n[[body]]\npoints = \"piont.csv\"");
  EXPECT_THAT(seen, HasSubstr(":7:10: there is no such file\n"));
  EXPECT_THAT(seen, HasSubstr("Did you mean `points.csv`?\n"));
  EXPECT_THAT(seen, HasSubstr("More: terp explain body.points\n"));
}

TEST_F(OtherFiles, ThatAreNoTextAreLeftToTheirKey)
{
  EXPECT_THAT(seen_with("file = 3"), HasSubstr("`file` must be text\n"));
  EXPECT_THAT(seen_with("file = 3"), HasSubstr("1 error; nothing was run.\n"));
}

TEST_F(OtherFiles, AreNamedAsTheirCopiesAreCalled)
{
  Node root = parse_toml("[mesh]\nfile = \"a/../b.msh\"\n[[body]]\nbox = []\n[[body]]\npoints = \"c.csv\"\n");
  std::vector<InputFile> files, again;
  EXPECT_TRUE(name_copies(root, "/somewhere", files));
  EXPECT_EQ(find_node(root, "mesh.file")->text, "mesh.msh");
  EXPECT_EQ(find_node(root, "body[1].points")->text, "points_1.csv");
  ASSERT_EQ(files.size(), 2);
  EXPECT_EQ(files[0].path, "/somewhere/a/../b.msh");
  EXPECT_EQ(files[1].path, "/somewhere/c.csv");
  EXPECT_EQ(files[1].copy, "points_1.csv");
  EXPECT_FALSE(name_copies(root, "/elsewhere", again));
  EXPECT_EQ(again[0].path, "/elsewhere/mesh.msh");
  root = parse_toml("[mesh]\nfile = \"dike.unv\"\n");  // its ending says how it is read
  EXPECT_TRUE(name_copies(root, "/somewhere", files));
  EXPECT_EQ(find_node(root, "mesh.file")->text, "mesh.unv");
}

}  // namespace
}  // namespace terp
