#include "cli/coarse_column.hpp"

namespace check_test {

TEST(Check, TellsWhatWouldRun)
{
  const ScratchFolder folder;
  const Finished f = succeeded(test::terp(column_command("check"), folder.path()));
  for (const char* line :
      {"  scheme         mpm_gp\n  method         as in the paper\n", "  mesh           192 cells, 231 nodes\n",
          "  cells of soil  64\n", "  points         1600\n",
          "  body 0         clay, 16 m^2, 31840 kg per m, 1600 points\n", "  mass           31840 kg per m\n",
          "  softening      no length, no reference width: the result will depend on the cells (docs/convergence.md)\n",
          "  time step      0.00303 s\n", "  steps          66 to t = 0.2 s\n", "nothing was run\n"})
    EXPECT_THAT(f.out, HasSubstr(line));
  EXPECT_THAT(f.out, AllOf(HasSubstr("  smallest cell  0.5 m high, "), ContainsRegex("  memory         [0-9]+ MB\n")));
  EXPECT_THAT(f.out, ContainsRegex("  expected time  [0-9.]+ s on 1 thread, [0-9.]+ s of it for output "
                                   "[(][0-9.]+ M point-steps/s in a trial[)]\n"));
  EXPECT_TRUE(names_in(folder.path()).empty());
}

TEST(Check, TellsInWhatTheMethodIsNotThePapers)
{
  const auto said = [](const std::vector<std::string>& changes) {
    std::vector<std::string> more;
    for (const std::string& change : changes) more.insert(more.end(), {"--set", change});
    const std::string out = succeeded(test::terp(column_command("check", more))).out;
    const std::size_t begin = out.find("  method "), end = out.find("  mesh  ");
    return begin < end ? out.substr(begin, end - begin) : "";
  };
  EXPECT_EQ(said({"scheme=mpm_mixed"}), "  method         as in the paper\n");
  EXPECT_EQ(said({"method.shares=overlap", "method.flip=0.95"}),
      "  method         not the paper's: shares = overlap, flip = 0.95\n");
  EXPECT_THAT(said({"scheme=mpm_mixed", "method.as=terp"}),
      AllOf(StartsWith("  method         not the paper's: shares = overlap, "),
          HasSubstr("                 points add to their own history what the law adds")));
  EXPECT_EQ(said({"scheme=standard_mpm"}), "");
}

TEST(Check, NamesWhatChangedSinceTheImport)
{
  const ScratchFolder folder;
  const std::string record = folder.path() + "/imported.toml";
  std::ofstream(record) << text_of(test::column_file);
  const std::vector<std::string> reference{"--set", "reference.imported=\"" + record + "\""};
  EXPECT_THAT(succeeded(test::terp(column_command("check", reference))).out,
      AllOf(HasSubstr("  changed        `mesh`: `cell` was 0.1 m in the import, is 0.5 m here.\n"),
          HasSubstr("  changed        `time`: `end` was 4 s in the import, is 0.2 s here.\n")));
  EXPECT_THAT(test::terp(column_command("check")).out, Not(HasSubstr("  changed ")));
}

TEST(Check, QuietItPrintsWarningsAlone)
{
  const Finished f = succeeded(test::terp(column_command("check", {"-q", "--set", "body.0.box=[[0,0.5],[8,2]]"})));
  EXPECT_EQ(f.out, "");
  EXPECT_THAT(f.err, HasSubstr("body 0 (`clay`) hangs in the air"));
}

TEST(Check, SaysHowFarK0IsFromBalanceOnGroundThatIsNotLevel)
{
  const char* words = "  initial stress k0 on ground that is not level: ";
  EXPECT_THAT(succeeded(test::terp(column_command("check", {"--set", "initial={stress=\"k0\", k0=0.5}"}))).out,
      AllOf(HasSubstr(words), HasSubstr(" % of the weight is out of balance at t = 0")));
  EXPECT_THAT(test::terp(column_command("check")).out, Not(HasSubstr("initial stress")));
}

TEST(Check, ListsTheSidesWithTheirLengthsAndConditions)
{
  const Finished f = test::terp(column_command("check"));
  for (const char* line : {"  side left      roller, no motion across, ",
           "  side bottom    contact that never opens, adhesion ", "  side top       free, "})
    EXPECT_THAT(f.out, HasSubstr(line));
}

TEST(Check, DrawsTheSection)
{
  const ScratchFolder folder;
  const std::string svg = folder.path() + "/section.svg";
  EXPECT_THAT(
      succeeded(test::terp(column_command("check", {"--picture", svg}))).out, StartsWith("picture in " + svg + "\n"));
  EXPECT_THAT(text_of(svg), AllOf(StartsWith("<svg "), HasSubstr("bottom: contact")));
  EXPECT_EQ(error_with(2, test::terp(column_command("check", {"--picture", "section.png"}))),
      "error: --picture section.png: the picture is an SVG file, which every browser opens\n  Write --picture "
      "section.svg. For PNG: rsvg-convert section.svg -o section.png (Debian package librsvg2-bin)\n");
}

/// The number before `unit` in the line of `terp check` that begins with `word`.
double number_in(const std::string& out, const std::string& word, const std::string& unit)
{
  const std::size_t line = out.find("  " + word + " "), end = out.find(" " + unit, line);
  const std::size_t begin = out.rfind(' ', end - 1) + 1;
  return std::stod(out.substr(begin, end - begin));
}

TEST(Check, SaysHowMuchDiskTheRunNeedsToAFactorOfTwo)
{
  for (const std::string field : {"output.fields.every=0.01", "output.fields.every=0.2"}) {
    const ScratchFolder scratch;
    const std::string folder = scratch.path() + "/run";
    const std::vector<std::string> more{
        "--set", field, "--set", "output.checkpoint.every=0.05", "--set", "mesh.cell=0.2"};
    const Finished check = succeeded(test::terp(column_command("check", more)));
    EXPECT_THAT(check.out, ContainsRegex("  output         [0-9]+ frames of [0-9.]+ MB, 4 checkpoints of [0-9.]+ "
                                         "MB, [0-9]+ rows\n  disk           [0-9.]+ MB at the end, with 2 "
                                         "checkpoints\n"));
    succeeded(run_column(folder, more));
    double bytes = 0.0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) bytes += static_cast<double>(entry.file_size());
    const double ratio = number_in(check.out, "disk", "MB") * 1e6 / bytes;
    EXPECT_GT(ratio, 0.5) << check.out;
    EXPECT_LT(ratio, 2.0) << check.out;
  }
}

TEST(Check, WarnsOfASideThatMovesFurtherThanItsCells)
{
  EXPECT_THAT(succeeded(test::terp(column_command("check", {"--set", "boundary.left={velocity=[4.0, 0.0]}"}))).err,
      AllOf(StartsWith("warning: --set boundary.left={velocity=[4.0, 0.0]}: the side stays in place"),
          HasSubstr("time.end is 0.8 m")));
}

TEST(Check, ShowsNoControlCharactersOfTheTitle)
{
  EXPECT_THAT(succeeded(test::terp(column_command("check", {"--set", R"(title="red \u001b[31m soil")"}))).out,
      StartsWith("red ?[31m soil\n"));
}

TEST(Check, AVariantOfAMeshFromAPolygonHasOtherCells)
{
  const auto told = [](const std::string& variant) {
    return test::terp({"check", source_path("cases/column_collapse/model_2_unstructured.toml"), "--set",
        "mesh.cell=0.5", "--set", "mesh.variant=" + variant, "-j", "1"});
  };
  const auto mesh_line = [](const std::string& out) {
    const std::size_t begin = out.find("  mesh  ");
    return out.substr(begin, out.find('\n', begin) - begin);
  };
  const Finished best = told("0"), other = told("1");
  ASSERT_EQ(best.status + other.status, 0) << best.err << other.err;
  EXPECT_NE(mesh_line(best.out), mesh_line(other.out));
}

TEST(Check, WarnsOfAHistoryPointFarFromTheSoil)
{
  EXPECT_THAT(succeeded(test::terp(column_command("check", {"--set", "output.history.points.far=[12.0, 1.0]"}))).err,
      StartsWith("warning: --set output.history.points.far=[12.0, 1.0]: no soil is near the history point `far`\n"));
}

TEST(Check, PointsAtTheChangeThatSetUpCannotUse)
{
  const std::string unstructured = source_path("cases/column_collapse/model_2_unstructured.toml");
  const auto error_after = [](const std::string& file, const std::string& change) {
    const Finished f = test::terp({"check", file, "--set", change});
    EXPECT_EQ(f.out, "");
    return error_with(2, f);
  };
  EXPECT_THAT(error_after(column_file, "mesh.size=[6.0, 3.0]"),
      AllOf(StartsWith("error: --set mesh.size=[6.0, 3.0]: the body lies outside the mesh\n"),
          HasSubstr("Enlarge the mesh")));
  EXPECT_THAT(error_after(column_file, "body[0].box=[[0.0, 0.0], [20.0, 2.0]]"),
      StartsWith("error: --set body[0].box=[[0.0, 0.0], [20.0, 2.0]]: the body lies outside the mesh\n"));
  EXPECT_THAT(error_after(column_file, "mesh.cell=1e-6"),
      HasSubstr("error: --set mesh.cell=1e-6: the mesh has too many cells\n"));
  EXPECT_THAT(error_after(unstructured, "mesh.polygon=[[0, 0], [3, 0], [3, 2], [2, 3], [0, 2]]"),
      StartsWith(
          "error: --set mesh.polygon=[[0, 0], [3, 0], [3, 2], [2, 3], [0, 2]]: the body lies outside the mesh\n"));
}

}  // namespace check_test
