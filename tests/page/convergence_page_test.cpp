#include "page/convergence_page.hpp"
#include "io/results/runs.hpp"
#include "support/page_data.hpp"
#include "support/scratch.hpp"
#include <fmt/format.h>

namespace convergence_page_test {

TEST(ConvergencePage, HasTheNumbersOfTheStudyAndTheLedgersOfWhatWasSolved)
{
  const ScratchFolder scratch;
  StudySequence sequence{"as given", {}, {}};
  for (const auto& [cell, front] : {std::pair(0.4, 11.0), std::pair(0.2, 11.5), std::pair(0.1, 11.75)}) {
    const std::string run = fmt::format("{}/{}", scratch.path(), cell);
    write_run(run, [x = front](Summary& s) { s.front_x = x; });
    sequence.runs.push_back({.cell = cell, .size = cell, .folder = run, .results = read_run(run)});
  }
  sequence.runs.push_back({.cell = 0.05, .size = 0.05, .folder = "x", .fault = "step 3 & more"});
  MeshStudy study = study_mesh({sequence}, 0.02);
  study.title = "A column";
  const Payload payload = convergence_payload(study, "2026-01-02T03:04:05Z");
  EXPECT_EQ(nlohmann::json::parse(payload.json)["kind"], "convergence");
  const auto data = test::data_of(payload);
  EXPECT_EQ(data["title"], "A column");
  const auto& front = data["sequences"][0]["quantities"][0];
  EXPECT_EQ(front["name"], "front_x");
  EXPECT_EQ(front["digits"], 3) << "the cells are small";
  EXPECT_NEAR(front["relative_error"], 1.25 * 0.25 / 5.0, 1e-12);  // of a run-out of 5 m
  const auto& runs = data["sequences"][0]["runs"];
  EXPECT_EQ(runs[3]["fault"], "step 3 & more");
  EXPECT_FALSE(runs[3].contains("over_time"));
  const RunResults& first = study.sequences[0].sequence.runs[0].results;
  const auto times = test::column_of(payload, runs[0]["over_time"], "time");
  ASSERT_EQ(times.size(), first.ledger.n_rows());
  EXPECT_EQ(times.back(), static_cast<float>(first.ledger.find("time")->back()));
  EXPECT_EQ(test::column_of(payload, runs[0]["over_time"], "kinetic")[0],
      static_cast<float>((*first.ledger.find("kinetic"))[0]));
}

}  // namespace convergence_page_test
