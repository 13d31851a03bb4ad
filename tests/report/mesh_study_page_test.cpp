#include "report/mesh_study_page.hpp"
#include "results/runs.hpp"
#include "support/test.hpp"
#include <fmt/format.h>

namespace mesh_study_page_test {

TEST(MeshStudyPage, HasAnswerTableChartsAndNothingFromOutside)
{
  const ScratchFolder scratch;
  StudySequence sequence{"as given", {}, {}};
  const Real cells[] = {0.4, 0.2, 0.1};
  for (int k = 0; k < 3; ++k) {
    const std::string folder = fmt::format("{}/{}", scratch.path(), k);
    write_run(folder, [&](Summary& s) { s.front_x = 12.0 - std::pow(0.5, k); });
    sequence.runs.push_back(
        {.cell = cells[k], .size = cells[k], .folder = std::to_string(k), .results = read_run(folder)});
  }
  MeshStudy study = study_mesh({sequence}, 0.02);
  study.title = "<column>";
  const std::string page = study_page(study, "2026-01-02T03:04:05Z");
  EXPECT_THAT(page, AllOf(StartsWith("<!doctype html>"), HasSubstr("<h1>&lt;column&gt;</h1>"),
                        HasSubstr("<th>front at the end</th>"), HasSubstr("tends to a limit"), HasSubstr("<svg "),
                        HasSubstr("content=\"default-src 'none'; style-src 'unsafe-inline'\"")));
  EXPECT_THAT(page, Not(AnyOf(HasSubstr("src="), HasSubstr("href="), HasSubstr("nan"))));
}

TEST(MeshStudyPage, HasTheVariantsBesideEachOther)
{
  const ScratchFolder scratch;
  std::vector<StudySequence> sequences{{"as given", {}, {}}, {"mesh.turn=45", {}, {}}};
  for (int k = 0; k < 4; ++k) {
    const std::string folder = fmt::format("{}/{}", scratch.path(), k);
    write_run(folder, [&](Summary& s) { s.front_x = 12.0 + k; });
    const Real cell = k % 2 == 0 ? 0.4 : 0.2;
    sequences[static_cast<std::size_t>(k / 2)].runs.push_back(
        {.cell = cell, .size = cell, .folder = std::to_string(k), .results = read_run(folder)});
  }
  EXPECT_THAT(study_page(study_mesh({sequences[0]}, 0.02), ""), Not(HasSubstr("<h2>All variants</h2>")));
  EXPECT_THAT(study_page(study_mesh(sequences, 0.02), ""),
      AllOf(HasSubstr("<h2>All variants</h2>\n<p class=\"answer\">On cells of 0.2 m, as given and with 1 variant: "),
          HasSubstr("<th>as given</th><th>mesh.turn=45</th><th>range</th><th>share</th>"),
          HasSubstr("<td>13.00</td><td>15.00</td><td>2.00</td>")));
}

TEST(MeshStudyPage, OfRunsThatAllFailedSaysSo)
{
  StudySequence sequence{"as given", {}, {}};
  for (const Real cell : {0.4, 0.2}) {
    sequence.runs.push_back({.cell = cell, .size = cell, .folder = "x"});
    sequence.runs.back().fault = "step 3 & more";
  }
  EXPECT_THAT(study_page(study_mesh({sequence}, 0.02), ""),
      AllOf(HasSubstr("nothing can be said of the mesh"), HasSubstr("step 3 &amp; more")));
}

}  // namespace mesh_study_page_test
