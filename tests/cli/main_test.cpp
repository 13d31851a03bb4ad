#include "os/instructions.hpp"
#include "page/page.hpp"
#include "batch/reliability.hpp"
#include "support/process.hpp"

namespace main_test {

std::size_t longest_line(const std::string& text)
{
  std::size_t longest = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    longest = std::max(longest, end - begin);
    begin = end + 1;
  }
  return longest;
}

TEST(Help, NamesTheCommandsAndExitStatuses)
{
  for (const auto& words : std::vector<std::vector<std::string>>{{"--help"}, {"-h"}, {"help"}}) {
    const Finished f = succeeded(test::terp(words));
    EXPECT_THAT(f.out, StartsWith("terp: explicit material point method for soil"));
    for (const char* part : {"run CASE.toml", "resume RUN", "report RUN", "compare RUN", "check CASE.toml",
             "explain TOPIC", "  list ", "terp COMMAND --help", "--set scheme=mpm_mixed",
             "Examples:", "Exit status: 0 solved, 2 bad input, 3 the run stopped itself, 1 anything else"})
      EXPECT_THAT(f.out, HasSubstr(part));
    EXPECT_LE(longest_line(f.out), 80u);
    EXPECT_EQ(f.err, "");
  }
}

TEST(Help, OfACommandIsItsOwnAndNamesItsOptions)
{
  const std::vector<std::pair<std::string, std::vector<std::string>>> commands{
      {"run", {"--output", "--threads", "--set", "--force", "--report", "--quiet", "--verbose", "--exact-fields",
                  "--from RUN[:STAGE]", "RUN, a folder, with its newest checkpoint", "runs/NAME"}},
      {"resume", {"--threads", "--report", "--quiet"}},
      {"stability", {"--from", "--to", "--tolerance", "--damping", "--rest", "--failure", "--windows", "--output",
                        "--json", "--set"}},
      {"converge", {"--cells", "--variant", "--tolerance", "--estimate", "--output", "--force", "--report", "--json"}},
      {"check", {"--set", "--picture"}}, {"bench", {"--steps", "--warm", "--json", "--set"}}, {"report", {"--output"}},
      {"compare", {"--json"}}, {"export", {"--field", "--frames", "--output"}}, {"watch", {"--every", "--once"}},
      {"study", {"mpirun", "--part", "--keep"}}, {"assess", {"--estimate"}}, {"import", {"--slices"}},
      {"explain", {"TOPIC"}}, {"list", {}}};
  for (const auto& [command, options] : commands) {
    const Finished f = succeeded(test::terp({command, "--help"}));
    EXPECT_THAT(f.out, AllOf(HasSubstr("\nUsage: terp " + command), HasSubstr("\nExit status: 0 solved, 2 bad input")));
    for (const auto& option : options) EXPECT_THAT(f.out, HasSubstr(option)) << command;
    EXPECT_LE(longest_line(f.out), 80u) << command;
    EXPECT_EQ(test::terp({"help", command}).out, f.out);
  }
  EXPECT_EQ(test::terp({"solve", "--help"}).out, test::terp({"--help"}).out);
}

TEST(Help, OffersNothingThatACommandDoesNotDo)
{
  for (const char* command : {"check", "stability"}) {
    EXPECT_THAT(test::terp({command, "--help"}).out, Not(HasSubstr("--verbose"))) << "there are no passes to be timed";
    EXPECT_EQ(test::terp({command, "-v"}).status, 2);
  }
  EXPECT_THAT(test::terp({"stability", "--help"}).out, Not(HasSubstr("Excludes")));
}

TEST(Help, IsWhatTerpAloneSays) { EXPECT_EQ(succeeded(test::terp({})).out, test::terp({"--help"}).out); }

TEST(Version, SaysWhichInstructionsItUsesAndWhatItWasBuiltWith)
{
  const Finished f = succeeded(test::terp({"--version"}));
  EXPECT_THAT(f.out, StartsWith("terp " TERP_VERSION " (" + std::string(instructions()) + ")\n  compiler       "));
  EXPECT_THAT(f.out, ContainsRegex("\n  instructions   .*" + std::string(instructions())));
  EXPECT_THAT(f.out, HasSubstr(std::string("\n  OpenTURNS      ") + (has_openturns() ? "yes\n" : "no\n")));
  EXPECT_THAT(f.out, HasSubstr(std::string("\n  report page    ") + (has_page() ? "yes\n" : "no\n")));
}

TEST(CommandLine, WhatItDoesNotKnowIsBadInputAndPointsToTheHelp)
{
  for (const auto& words : std::vector<std::vector<std::string>>{{"solve"}, {"run"}, {"run", "a.toml", "--fast"},
           {"run", "a.toml", "-j", "0"}, {"run", "a.toml", "b.toml"}, {"explain"}, {"list", "all"}}) {
    const Finished f = test::terp(words);
    EXPECT_EQ(f.status, 2) << words[0];
    EXPECT_EQ(f.out, "");
    EXPECT_THAT(f.err, AllOf(StartsWith("error: "), HasSubstr("see terp "), EndsWith(" --help\n")));
  }
}

TEST(CommandLine, NamesAWordThatIsNoCommandAndTheNearestThatIs)
{
  const Finished f = test::terp({"rnu", "a.toml"});
  EXPECT_EQ(f.status, 2);
  EXPECT_EQ(f.out, "");
  EXPECT_EQ(f.err,
      "error: there is no command `rnu`\n  Did you mean `run`?\n  Commands: run, resume, stability, converge, study, "
      "watch, report, compare, export, check, explain, list, schema, bench, import, assess\n"
      "Usage: terp COMMAND [options]; see terp --help\n");
  EXPECT_THAT(test::terp({"bogus"}).err, StartsWith("error: there is no command `bogus`\n  Commands: run, "));
  EXPECT_THAT(test::terp({"cases/a.toml"}).err, HasSubstr("  To solve that case: terp run cases/a.toml\n"));
  EXPECT_THAT(test::terp({"--verion"}).err,
      StartsWith("error: there is no option `--verion` before a command\n  Did you mean `--version`?\n"));
  EXPECT_THAT(test::terp({"\x1B[2J"}).err, StartsWith("error: there is no command `?[2J`\n"));
}

TEST(CommandLine, NamesWhatIsMissingAndTheNearestOption)
{
  EXPECT_EQ(test::terp({"run"}).err,
      "error: `terp run` needs CASE.toml\nUsage: terp COMMAND [options]; see terp run --help\n");
  EXPECT_THAT(test::terp({"run", "a.toml", "--ouput", "b"}).err,
      StartsWith("error: `terp run` has no option `--ouput`\n  Did you mean `--output`?\n  Options: --"));
  EXPECT_THAT(
      test::terp({"list", "all"}).err, StartsWith("error: `terp list` does not take a further argument, got `all`\n"));
}

TEST(CommandLine, SaysWhatIsNoNumberAndWhatIsOutOfRange)
{
  for (const char* option : {"--from", "--to", "--tolerance", "--rest", "--failure", "--damping"}) {
    const Finished f = test::terp({"stability", "case.toml", option, "nan"});
    EXPECT_EQ(f.status, 2) << option;
    EXPECT_THAT(f.err, StartsWith(std::string("error: ") + option + ": nan is out of range; allowed are "));
  }
  const auto refused = [](const char* option, const char* value) {
    return test::terp({"stability", "case.toml", option, value}).err;
  };
  EXPECT_THAT(
      refused("--damping", "much"), StartsWith("error: --damping: `much` is no number; allowed are 0 to 0.99\n"));
  EXPECT_THAT(refused("--damping", "1"), StartsWith("error: --damping: 1 is out of range; allowed are 0 to 0.99\n"));
  EXPECT_THAT(
      refused("--threads", "1.5"), StartsWith("error: --threads: `1.5` is no whole number; allowed are 1 to 1024\n"));
}

TEST(CommandLine, PagesAreInEnglishOrDutch)
{
  EXPECT_THAT(error_with(2, test::terp({"report", "runs/a", "--language", "fr"})),
      StartsWith("error: --language: fr not in {en,nl}"));
}

TEST(Explain, TellsOfAMaterialASchemeAndAKey)
{
  EXPECT_THAT(succeeded(test::terp({"explain", "tresca_softening"})).out,
      AllOf(HasSubstr("su_peak"), HasSubstr("Pa"), HasSubstr("Eq. (5)")));
  EXPECT_THAT(test::terp({"explain", "mpm_gp"}).out, HasSubstr("material points own the history"));
  EXPECT_THAT(test::terp({"explain", "mesh.cell"}).out, HasSubstr(" m"));
}

TEST(Explain, OffersTheNearestTopicForOneThatIsNone)
{
  const Finished f = test::terp({"explain", "tresca_softning"});
  EXPECT_EQ(f.status, 2);
  EXPECT_EQ(f.out, "");
  EXPECT_THAT(f.err, HasSubstr("tresca_softening"));
}

TEST(List, NamesEverySchemeMaterialAndOutput)
{
  const Finished f = succeeded(test::terp({"list"}));
  for (const char* name :
      {"standard_mpm", "mpm_mixed", "mpm_gp", "linear_elastic", "tresca_softening", "eps_deviatoric", "velocity"})
    EXPECT_THAT(f.out, HasSubstr(name));
}

}  // namespace main_test
