#include "io/case/other_files.hpp"
#include "io/case/samples.hpp"
#include "support/paths.hpp"

namespace other_files_test {

TEST(OtherFiles, AreLookedForBesideTheCaseFile)
{
  const ScratchFolder folder;
  std::ofstream(folder.path() + "/dike.msh");
  for (const std::string& name : {std::string("dike.msh"), folder.path() + "/dike.msh"})
    EXPECT_NO_THROW(read_case_text(small_case_on("file = \"" + name + "\""), folder.path() + "/case.toml")) << name;
}

TEST(OtherFiles, ThatAreThereAreNotProposedInTheirOwnPlace)
{
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path() + "/dike.msh");
  const auto message = [&](const char* file) {
    return refusal<CaseError>(
        [&] { read_case_text(small_case_on("file = \"" + std::string(file) + "\""), folder.path() + "/case.toml"); });
  };
  EXPECT_THAT(message("dike.msh"), AllOf(HasSubstr("this is a folder, not a file"), Not(HasSubstr("Did you mean"))));
  EXPECT_THAT(message("dyke.msh"), HasSubstr("Did you mean `dike.msh`?"));
}

TEST(OtherFiles, AreNamedAsTheirCopiesAreCalled)
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
  root = parse_toml("[[stage]]\nset = { \"material.clay.su_peak\" = { csv = \"su.csv\" } }\n");
  EXPECT_TRUE(name_copies(root, "/somewhere", files));
  EXPECT_EQ(files.back().path, "/somewhere/su.csv");
  EXPECT_EQ(files.back().copy, "values_1.csv");
  root = parse_toml("[mesh]\nfile = \"dike.unv\"\n");  // its ending says how it is read
  EXPECT_TRUE(name_copies(root, "/somewhere", files));
  EXPECT_EQ(find_node(root, "mesh.file")->text, "mesh.unv");
}

TEST(OtherFiles, WithTheRecordOfAnImportAreTomlAndKeepTheirName)
{
  const ScratchFolder folder;
  const std::string text =
      small_case_on("size = [6.0, 3.0]\ncell = 1.0") + "\n[reference]\nimported = \"import.toml\"\n";
  const auto message = [&] { return refusal<CaseError>([&] { read_case_text(text, folder.path() + "/case.toml"); }); };
  EXPECT_THAT(message(), AllOf(HasSubstr("there is no such file"), HasSubstr("take `imported` out of [reference]")));
  std::ofstream(folder.path() + "/import.toml") << "a = = 1";
  EXPECT_THAT(message(), AllOf(HasSubstr("`import.toml` is not valid TOML"), HasSubstr("line 1")));
  std::ofstream(folder.path() + "/import.toml") << "a = 1";
  const CaseFile file = read_case_text(text, folder.path() + "/case.toml");
  ASSERT_EQ(file.inputs.size(), 1);
  EXPECT_EQ(file.inputs[0].copy, "imported.toml");
  EXPECT_THAT(refusal<CaseError>([&] {
    read_case_text(std::string(text).replace(text.find("\"import.toml\""), 13, "3"), folder.path() + "/case.toml");
  }),
      HasSubstr("must be text: the name of a file"));
}

}  // namespace other_files_test
