// What Terp doubts of a case before it runs: a row of findings.wrong each.
#include "io/case/case_file.hpp"
#include "model/parts/setup.hpp"
#include "run/findings/setup_warnings.hpp"
#include "support/catalogue.hpp"
#include "support/paths.hpp"
#include "support/problems.hpp"

namespace findings_test {

std::vector<Problem> told_of(const Case& c)
{
  try {
    Model model = build_model(c, 1);
    return find_warnings(model, build_state(model));
  } catch (const InputError& error) {
    return error.problems();
  }
}

TEST(Findings, AreThoseOfTheCatalogueAndNoOthers)
{
  const std::string path = source_path("tests/run/findings/findings.wrong");
  for (const WrongRow& row : read_catalogue(path)) {
    std::string all;
    for (const Problem& p : told_of(read_case(source_path("tests/support/" + row.name + ".toml"), row.changes).values))
      all += (all.empty() ? "" : "\n") + p.key + ": " + p.what + (p.detail.empty() ? "" : "\n" + p.detail);
    expect_row(path, row, all);
  }
}

}  // namespace findings_test
