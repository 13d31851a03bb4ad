#include "cli/coarse_column.hpp"
#include "io/files/files.hpp"
#include "mpm/step/passes.hpp"
#include <poll.h>
#include <nlohmann/json.hpp>

namespace report_test {

/// Two short runs of the column, made once.
struct Runs {
  ScratchFolder scratch;
  std::string gp = scratch.path() + "/gp", mixed = scratch.path() + "/mixed";

  Runs()
  {
    run_column(gp, {"-q", "--set", "output.fields.every=0.1"});
    run_column(mixed, {"-q", "--set", "output.fields.every=0.1", "--set", "scheme=mpm_mixed"});
  }
};

const Runs& runs()
{
  static const Runs two;
  return two;
}

nlohmann::json document_in(const std::string& html)
{
  const std::string start = "<script id=\"terp-report\" type=\"application/json\">";
  const auto begin = html.find(start) + start.size();
  return nlohmann::json::parse(html.substr(begin, html.find("</script>", begin) - begin));
}

TEST(Report, IsOneFileWithBothRunsAndTheirComparison)
{
  const std::string path = runs().scratch.path() + "/report.html";
  EXPECT_THAT(succeeded(test::terp({"report", runs().mixed, runs().gp, "-o", path})).out,
      AllOf(StartsWith("mixed: 3 frames, 1600 points, places to "), HasSubstr("report in " + path + " (")));
  const auto document = document_in(read_file(path));
  EXPECT_EQ(document["runs"].size(), 2);
  EXPECT_EQ(document["runs"][0]["scheme"], "mpm_mixed");
  EXPECT_EQ(document["runs"][0]["fields"][0]["name"], "eps_eq_p");
  EXPECT_EQ(document["runs"][0]["passes"].size(), n_passes);
  const Finished compared = test::terp({"compare", runs().mixed, runs().gp, "--json"});
  EXPECT_EQ(document["comparison"], nlohmann::json::parse(compared.out));
}

TEST(Report, ReplacesAnEarlierPageButNoOtherFile)
{
  const ScratchFolder scratch;
  const std::string page = scratch.path() + "/page.html", other = scratch.path() + "/results.vtkhdf.series";
  std::ofstream(page) << "<!DOCTYPE html><p>old";
  std::ofstream(other) << "ten days of work";
  succeeded(test::terp({"report", runs().gp, "-o", page}));
  EXPECT_EQ(document_in(read_file(page))["runs"].size(), 1);
  EXPECT_EQ(error_with(2, test::terp({"report", runs().gp, "-o", other})),
      "error: " + other + " is there already, and it is no page\n  Choose another name: -o report.html\n");
  EXPECT_EQ(read_file(other), "ten days of work");
}

TEST(Report, IsWrittenAtTheEndOfARunThatAsksForIt)
{
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run";
  EXPECT_THAT(succeeded(run_column(folder, {"--report"})).out, HasSubstr("report in " + folder + "/report.html"));
  EXPECT_EQ(document_in(read_file(folder + "/report.html"))["runs"][0]["finished"], true);
  succeeded(run_column(folder, {"--force", "-q"}));
  EXPECT_FALSE(std::filesystem::exists(folder + "/report.html"));  // of the earlier run
}

TEST(Report, IsWrittenAtTheEndOfARunThatGoesOn)
{
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run", page = folder + "/report.html",
                    checkpoint = folder + "/checkpoint_000000033.h5";
  succeeded(run_column(folder, {"-q", "--set", "output.checkpoint={every=0.1, keep=0}"}));
  succeeded(test::terp({"resume", checkpoint, "-q"}));
  EXPECT_FALSE(std::filesystem::exists(page));
  succeeded(test::terp({"resume", checkpoint, "--report"}));
  EXPECT_EQ(document_in(read_file(page))["runs"][0]["finished"], true);
}

TEST(Watch, WhileARunGoesOnSaysWhenItWillEnd)
{
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/run";
  const Process solver(column_command("run",
      {"-q", "-o", folder, "--set", "time.end=1000", "--set", "mesh.cell=0.25", "--set", "output.fields.every=0"}));
  Finished f;
  for (int k = 0; k < 300 && f.out.find("ETA") == std::string::npos; ++k) {
    poll(nullptr, 0, 100);
    if (std::filesystem::exists(folder + "/case.toml")) f = test::terp({"watch", folder, "--once"});
  }
  EXPECT_EQ(f.status, 0) << f.err;
  EXPECT_THAT(
      f.out, AllOf(StartsWith("t = "), HasSubstr(" of 1000 s (0 %)"), HasSubstr("  ETA "), Not(HasSubstr("no terp"))));
}

}  // namespace report_test
