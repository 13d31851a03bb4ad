#include "io/case/case_file.hpp"
#include "io/case/printable.hpp"
#include "io/case/samples.hpp"
#include "support/paths.hpp"

namespace case_file_test {

TEST(CaseFile, ModelTwoIsThePaperColumnWithSoftening)
{
  const CaseFile file = read_case(source_path("cases/column_collapse/model_2.toml"));
  EXPECT_TRUE(file.warnings.empty()) << render_warnings(file);
  const Case& c = file.values;
  EXPECT_EQ(c.name, "model_2");
  EXPECT_EQ(c.mesh.size, (Vec<2>{16.0, 3.0}));
  EXPECT_EQ(c.mesh.cell, (Vec<2>{0.1, 0.1}));
  EXPECT_THAT(
      c.materials.at(0).parameters, ElementsAre(2.0e6, 0.48, 8.0e3, 2.0e3, 50.0, 2.0e3, 0.0, 0.0, INFINITY, INFINITY));
  ASSERT_EQ(c.sides.size(), 3u);
  EXPECT_EQ(c.sides[2].kind, SideKind::contact_bilateral);
  EXPECT_EQ(c.sides[2].adhesion, 8.0e3);
  ASSERT_EQ(c.output.history_points.size(), 10u);
  EXPECT_EQ(c.output.history_points[2].second, (Vec<2>{7.13, 1.09}));
  EXPECT_EQ(c.output.history_points[9].first, "J");
  EXPECT_TRUE(c.output.field_names.empty());
  EXPECT_EQ(c.output.checkpoint_every, 1.0);
}

TEST(CaseFile, ModelOneKeepsItsStrengthOnASmoothBase)
{
  const CaseFile file = read_case(source_path("cases/column_collapse/model_1.toml"));
  EXPECT_TRUE(file.warnings.empty()) << render_warnings(file);
  EXPECT_EQ(file.values.materials.at(0).parameters.at(3), 8.0e3);
  EXPECT_EQ(file.values.sides.at(2).kind, SideKind::roller);
}

TEST(DefaultRunFolder, IsNamedAfterTheFileOrWhereThatIsCaseTomlAfterItsFolder)
{
  EXPECT_EQ(default_run_folder("cases/dike.toml"), "runs/dike");
  EXPECT_EQ(default_run_folder("cases/dike/case.toml"), "runs/dike");
  EXPECT_EQ(default_run_folder("cases/dike/./case.toml"), "runs/dike");
  EXPECT_EQ(default_run_folder("case.toml"), "runs/" + std::filesystem::current_path().filename().string());
  EXPECT_EQ(default_run_folder("/case.toml"), "runs/case");  // its folder has no name
  EXPECT_EQ(default_run_folder("cases/dike/case.toml.toml"), "runs/case.toml");
  EXPECT_EQ(read_case_text(small_case, "cases/dike/case.toml").values.name, "dike");
}

TEST(CaseFile, KeepsTheTextOfAnUnchangedCase) { EXPECT_EQ(read_case_text(small_case, "case.toml").text, small_case); }

TEST(CaseFile, RecordsChangesInATextThatReadsTheSame)
{
  const std::string model_2 = source_path("cases/column_collapse/model_2.toml");
  const CaseFile changed = read_case(model_2, {"scheme=mpm_mixed", "mesh.cell=0.2", "time.end=0.30000000000000004"});
  EXPECT_THAT(changed.text, HasSubstr("#   --set scheme=mpm_mixed\n"));
  const CaseFile again = read_case_text(changed.text, "case.toml");
  EXPECT_EQ(again.values.scheme, "mpm_mixed");
  EXPECT_EQ(again.values.mesh.cell, (Vec<2>{0.2, 0.2}));
  EXPECT_EQ(again.values.time.end, 0.30000000000000004);
  EXPECT_EQ(again.values.output.history_points, changed.values.output.history_points);
  EXPECT_EQ(again.values.sides[2].kind, SideKind::contact_bilateral);
  EXPECT_EQ(again.values.bodies[0].polygon, changed.values.bodies[0].polygon);
}

TEST(CaseFile, KnowsTheFolderOfTheCase)
{
  EXPECT_EQ(read_case_text(small_case, "case.toml").values.folder, ".");
  EXPECT_EQ(read_case_text(small_case, "cases/dike/case.toml").values.folder, "cases/dike");
}

const char* const case_with_files = "file = \"sub/../a.msh\"\n[[body]]\npoints = \"a.csv\"";

TEST(CaseFile, NamesTheCopiesOfOtherFilesSoThatARunFolderCanBeMoved)
{
  const ScratchFolder folder, run;
  std::filesystem::create_directory(folder.path() + "/sub");
  std::ofstream(folder.path() + "/a.msh"), std::ofstream(folder.path() + "/a.csv");
  const CaseFile file = read_case_text(small_case_on(case_with_files), folder.path() + "/case.toml");
  EXPECT_EQ(file.values.mesh.file, "sub/../a.msh");
  EXPECT_THAT(file.text, HasSubstr("case.toml, with copies of the files that it names\n"));
  std::ofstream(run.path() + "/case.toml") << file.text;
  for (const InputFile& input : file.inputs) std::filesystem::copy_file(input.path, run.path() + "/" + input.copy);
  const CaseFile again = read_case(run.path() + "/case.toml");
  EXPECT_EQ(again.values.mesh.file, "mesh.msh");
  EXPECT_EQ(again.values.bodies[0].points_file, "points_1.csv");
  EXPECT_EQ(again.values.bodies[1].polygon, file.values.bodies[1].polygon);
  EXPECT_EQ(again.text, file.text);
}

TEST(CaseFile, RecordsChangesAndCopiesTogether)
{
  const ScratchFolder folder;
  std::ofstream(folder.path() + "/a.msh"), std::ofstream(folder.path() + "/b.msh"),
      std::ofstream(folder.path() + "/a.csv");
  const CaseFile file =
      read_case_text(small_case_on(case_with_files), folder.path() + "/case.toml", {"mesh.file=b.msh"});
  EXPECT_THAT(
      file.text, HasSubstr("changed by\n#   --set mesh.file=b.msh\n# and with copies of the files that it names\n"));
  EXPECT_THAT(file.text, HasSubstr("file = \"mesh.msh\"\n"));
  EXPECT_EQ(file.inputs.at(0).path, folder.path() + "/b.msh");
}

TEST(CaseFile, ShowsNoControlCharactersOfTheFile)
{
  for (const std::string bad : {"\x1B[2J", "\x07", "\x7F", "\xFF", "\r"})
    for (const std::string& line :
        {"title = \"" + bad + "\"", "t" + bad + "itle = 1", "# " + bad, "a = [" + bad, "scheme = '" + bad + "'"}) {
      const std::string seen = message_for(line + "\nend = -1\n" + small_case);
      EXPECT_EQ(seen, printable(seen)) << line;
    }
  EXPECT_THAT(message_for("scheme = \"\\u001b[2J\"\n" + small_case), HasSubstr("`scheme` cannot be \"?[2J\""));
  EXPECT_THAT(message_for(small_case, {"scheme=\x1B[2J"}), HasSubstr("--set scheme=?[2J: "));
  EXPECT_THAT(message_for("end = -1 # \x1B[2J\n" + small_case), HasSubstr("    1 | end = -1 # ?[2J\n"));
}

// It follows from the error, and goes with it.
TEST(CaseFile, BesideAnErrorNothingIsSaidOfWhatIsNotUsed)
{
  const std::string water = "[water]\nphreatic_line = [[0, 2]]\nhead_lines = { aquifr = [[0, 3]] }\n";
  const std::string line = "reference_lines = [{ line = [[0, 1]], head = \"aquifer\" }]\n";
  EXPECT_THAT(refusal<CaseError>([&] { read_case_text(small_case + water + line, "case.toml"); }),
      AllOf(StartsWith("error: "), HasSubstr("there is no head line `aquifer`")));
  const CaseFile without_error = read_case_text(small_case + water, "case.toml");
  EXPECT_THAT(render_warnings(without_error), HasSubstr("no reference line uses the head line `aquifr`"));
}

}  // namespace case_file_test
