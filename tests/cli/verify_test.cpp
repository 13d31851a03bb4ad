#include "support/process.hpp"
#include "whole/ledger_samples.hpp"

namespace verify_test {

/// Cases in a folder of their own; the block of flying_case moves by 2 m/s for 0.5 s.
struct Ledger {
  void add(const std::string& name, const std::string& lines)
  {
    const std::string at = folder.path() + "/" + name;
    std::filesystem::create_directory(at);
    std::ofstream(at + "/case.toml") << flying_case;
    std::ofstream(at + "/expected.toml") << "title = \"Flight\"\n" << lines;
  }
  Finished verify(std::vector<std::string> words = {}) const
  {
    words.insert(words.begin(), {"verify", "--cases", folder.path(), "-j", "1"});
    return test::terp(words);
  }
  ScratchFolder folder;
};

std::string path_is(const std::string& reference, const std::string& more = "")
{
  return "[[quantity]]\nname = \"path\"\nvalue = \"ux\"\nreduce = \"mean\"\nreference = " + reference +
         "\nunit = \"m\"\ntolerance = 1e-9\nsource = \"Newton\"\n" + more;
}

TEST(Verify, PrintsTheRowsAndCountsAndReturnsZeroIfAllPass)
{
  Ledger ledger;
  ledger.add("flight", path_is("1.0"));
  const Finished f = succeeded(ledger.verify());
  EXPECT_THAT(f.out, AllOf(HasSubstr("flight: Flight\n"), HasSubstr("path      mpm_gp  1 m        1 m   "),
                         HasSubstr("1 rows: 1 pass, 0 red\n")));
  EXPECT_THAT(f.err, HasSubstr("[1/1] flight"));
}

TEST(Verify, ARowThatMissesFailsItUnlessTheCaseDeclaresItRed)
{
  Ledger ledger;
  ledger.add("flight", path_is("1.1"));
  const Finished fails = ledger.verify();
  EXPECT_EQ(fails.status, 1);
  EXPECT_THAT(
      fails.out, AllOf(HasSubstr("  FAIL    Newton"), HasSubstr("1 rows: 0 pass, 1 red (1 not known: FAIL)\n")));
  ledger.add("flight", path_is("1.1", "red = \"it was slow\"\n"));
  EXPECT_THAT(succeeded(ledger.verify()).out,
      AllOf(HasSubstr("  ! path: it was slow\n"), HasSubstr("1 rows: 0 pass, 1 red (1 known, with the reason)\n")));
}

TEST(Verify, WritesThePages)
{
  Ledger ledger;
  ledger.add("flight", path_is("1.0"));
  const std::string page = ledger.folder.path() + "/page";
  succeeded(ledger.verify({"--markdown", page + ".md", "--overview", page + "_short.md"}));
  EXPECT_TRUE(std::filesystem::file_size(page + ".md") > 100);
  EXPECT_THAT(text_of(page + "_short.md"), HasSubstr("| Flight | 1 | 0 | "));

  ledger.add("fall", path_is("1.0"));
  succeeded(ledger.verify({"fall", "--overview", page + "_short.md"}));
  EXPECT_THAT(
      text_of(page + "_short.md"), AllOf(HasSubstr("2 rows: 2 pass"), HasSubstr("[fall]"), HasSubstr("[flight]")));
}

TEST(Verify, PagesThatCannotBeWrittenAreRefusedBeforeAnythingIsSolved)
{
  Ledger ledger;
  ledger.add("flight", path_is("1.0"));
  for (const std::string& page : {ledger.folder.path() + "/no/page.md", ledger.folder.path()}) {
    EXPECT_THAT(error_with(1, ledger.verify({"--markdown", page})),
        AllOf(HasSubstr(page + ": the page cannot be written"), Not(HasSubstr("[1/1]"))));
  }
}

TEST(Verify, NothingToSolveOrToJudgeIsNoPass)
{
  Ledger ledger;
  ledger.add("flight", "[[run]]\nlong = true\n" + path_is("1.0"));
  EXPECT_THAT(
      error_with(1, ledger.verify({"--short"})), HasSubstr("there is nothing to solve: these cases have no short run"));
  ledger.add("flight", "");
  EXPECT_THAT(error_with(2, ledger.verify()), HasSubstr("there is no [[quantity]]"));
}

TEST(Verify, ACaseThatCannotBeReadIsBadInput)
{
  Ledger ledger;
  ledger.add("flight", path_is("V"));
  EXPECT_THAT(error_with(2, ledger.verify()), HasSubstr("expected.toml:6:13: "));
}

TEST(Verify, ABrokenCaseIsOneRowAndTheOthersAreSolved)
{
  Ledger ledger;
  ledger.add("broken", path_is("\"V\""));
  ledger.add("flight", path_is("1.0"));
  const Finished f = ledger.verify({"flight", "broken", "fli*"});  // named twice, solved once
  EXPECT_EQ(f.status, 1);
  EXPECT_THAT(f.out, AllOf(HasSubstr("`V` is not known here"), HasSubstr("2 rows: 1 pass, 1 red (1 not known: FAIL)")));
}

TEST(Verify, AnExpectedTomlThatCannotBeReadIsOneRowAndTheOthersAreSolved)
{
  Ledger ledger;
  ledger.add("broken", path_is("V"));
  ledger.add("empty", "");
  ledger.add("flight", path_is("1.0"));
  const std::string page = ledger.folder.path() + "/page.md";
  const Finished f = ledger.verify({"--markdown", page});
  EXPECT_EQ(f.status, 1);
  EXPECT_THAT(f.out, AllOf(HasSubstr("broken: \n"), HasSubstr("broken/expected.toml:6:13: "),
                         HasSubstr("there is no [[quantity]], so nothing would be judged"),
                         HasSubstr("3 rows: 1 pass, 2 red (2 not known: FAIL)")));
  EXPECT_THAT(text_of(page), HasSubstr("expected.toml"));
  EXPECT_THAT(ledger.verify({"--list"}).out, AllOf(HasSubstr("cannot be read\n"), HasSubstr("flight ")));
}

TEST(Verify, ListsWithoutSolvingAndChoosesByNameAndLength)
{
  Ledger ledger;
  ledger.add("short_one", path_is("1.0"));
  ledger.add("long_one", "[[run]]\nlong = true\n" + path_is("1.0"));
  EXPECT_THAT(
      ledger.verify({"--list"}).out, AllOf(HasSubstr("short_one"), HasSubstr("long_one"), Not(HasSubstr("rows"))));
  EXPECT_THAT(ledger.verify({"--short"}).out, AllOf(HasSubstr("short_one"), Not(HasSubstr("long_one"))));
  EXPECT_THAT(ledger.verify({"--long"}).out, AllOf(HasSubstr("long_one"), Not(HasSubstr("short_one"))));
  EXPECT_THAT(ledger.verify({"short_one"}).out, HasSubstr("1 rows: 1 pass"));
  EXPECT_THAT(error_with(1, ledger.verify({"shart_one"})),
      HasSubstr("there is no verification case `shart_one`. Did you mean `short_one`?"));
  EXPECT_EQ(ledger.verify({"--short", "--long"}).status, 2);
}

}  // namespace verify_test
