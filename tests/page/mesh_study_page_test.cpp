#include "page/mesh_study_page.hpp"
#include "io/results/runs.hpp"
#include "support/scratch.hpp"
#include <fmt/format.h>

namespace mesh_study_page_test {

struct MeshStudyPage : ScratchTest {
  /// Runs on these cells [m] whose fronts end there [m].
  StudySequence sequence(const std::string& name, const std::vector<std::pair<Real, Real>>& fronts) const
  {
    StudySequence made{name, {}, {}};
    for (const auto& [cell, front] : fronts) {
      const std::string run = fmt::format("{}/{}_{}", folder, name, cell);
      write_run(run, [x = front](Summary& s) { s.front_x = x; });
      made.runs.push_back({.cell = cell, .size = cell, .folder = run, .results = read_run(run)});
    }
    return made;
  }
};

TEST_F(MeshStudyPage, HasAnswerTableChartsAndNothingFromOutside)
{
  MeshStudy study = study_mesh({sequence("as given", {{0.4, 11.0}, {0.2, 11.5}, {0.1, 11.75}})}, 0.02);
  study.title = "<column>";
  const std::string page = study_page(study, "2026-01-02T03:04:05Z");
  EXPECT_THAT(page, AllOf(StartsWith("<!doctype html>"), HasSubstr("<h1>&lt;column&gt;</h1>"),
                        HasSubstr("<th>front at the end</th>"), HasSubstr("tends to a limit"), HasSubstr("<svg "),
                        HasSubstr("content=\"default-src 'none'; style-src 'unsafe-inline'\"")));
  EXPECT_THAT(page, Not(AnyOf(HasSubstr("src="), HasSubstr("href="), HasSubstr("nan"))));
}

TEST_F(MeshStudyPage, HasTheVariantsBesideEachOther)
{
  const auto given = sequence("as given", {{0.4, 12.0}, {0.2, 13.0}}),
             turned = sequence("mesh.turn=45", {{0.4, 14.0}, {0.2, 15.0}});
  EXPECT_THAT(study_page(study_mesh({given}, 0.02), ""), Not(HasSubstr("<h2>All variants</h2>")));
  EXPECT_THAT(study_page(study_mesh({given, turned}, 0.02), ""),
      AllOf(HasSubstr("<h2>All variants</h2>\n<p class=\"answer\">On cells of 0.2 m, as given and with 1 variant: "),
          HasSubstr("<th>as given</th><th>mesh.turn=45</th><th>range</th><th>share</th>"),
          HasSubstr("<td>13.00</td><td>15.00</td><td>2.00</td>")));
}

TEST_F(MeshStudyPage, OfRunsThatAllFailedSaysSo)
{
  const StudyRun failed{.cell = 0.4, .size = 0.4, .folder = "x", .fault = "step 3 & more"};
  EXPECT_THAT(study_page(study_mesh({{"as given", {}, {failed, failed}}}, 0.02), ""),
      AllOf(HasSubstr("nothing can be said of the mesh"), HasSubstr("step 3 &amp; more")));
}

}  // namespace mesh_study_page_test
