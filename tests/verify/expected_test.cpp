#include "verify/expected.hpp"
#include "io/case/case_file.hpp"
#include "support/catalogue.hpp"
#include "whole/ledger_samples.hpp"

namespace expected_test {

const std::string good = R"(title = "Flight"
[constants]
V = { key = "body[0].velocity[0]" }
twice = "2*V"
[[run]]
name = "a"
schemes = ["mpm_gp", "mpm_mixed"]
set = ["time.end=0.2"]
seconds = 3
[[run]]
name = "b"
long = true
[[quantity]]
name = "path"
value = "ux"
reduce = "max_error"
reference = "V*t"
tolerance = 1e-9
runs = ["a"]
source = "Newton"
)";

TEST(Expected, KeepsWhatTheFileSays)
{
  const LedgerSample sample(good);
  const Expected file = read_expected(sample.path());
  EXPECT_EQ(file.title, "Flight");
  ASSERT_EQ(file.constants.size(), 2u);
  EXPECT_EQ(file.constants[0].key, "body[0].velocity[0]");
  EXPECT_EQ(file.constants[1].formula.text, "2*V");
  ASSERT_EQ(file.variants.size(), 2u);
  EXPECT_THAT(file.variants[0].schemes, ElementsAre("mpm_gp", "mpm_mixed"));
  EXPECT_THAT(file.variants[0].set, ElementsAre("time.end=0.2"));
  EXPECT_EQ(file.variants[0].case_file, "case.toml");
  EXPECT_EQ(file.variants[0].seconds, 3.0);
  EXPECT_TRUE(file.variants[1].is_long);
  ASSERT_EQ(file.quantities.size(), 1u);
  EXPECT_EQ(file.quantities[0].reduce, Reduce::max_error);
  EXPECT_EQ(file.quantities[0].tolerance.text, "1e-09");
}

TEST(Expected, WhatIsWrongIsRefusedInTheWordsOfTheCatalogue)
{
  const auto rows = read_catalogue(source_path("tests/whole/expected.wrong"));
  EXPECT_GE(rows.size(), 60u);
  for (const WrongRow& row : rows) {
    const LedgerSample sample(spoil(good, row));
    const std::string message = refusal<CaseError>([&] { read_expected(sample.path()); });
    EXPECT_EQ(message.empty(), row.verdict == "accepted") << row.where << '\n' << message;
    EXPECT_THAT(message, HasSubstr(row.expected)) << row.where;
  }
}

TEST(Expected, OnlyOneRunNeedsNoName)
{
  std::string nameless = good;
  for (const std::string name : {"name = \"a\"\n", "name = \"b\"\n", "runs = [\"a\"]\n"})
    nameless.erase(nameless.find(name), name.size());
  const LedgerSample sample(nameless);
  EXPECT_THAT(refusal<CaseError>([&] { read_expected(sample.path()); }), HasSubstr("more than one run has no `name`"));
}

TEST(Expected, AFolderWithoutOneIsNoCase)
{
  EXPECT_EQ(refusal<CaseError>([] { read_expected("/nowhere/expected.toml"); }),
      "error: /nowhere/expected.toml: there is no such file\n  A verification case is a folder with case.toml and "
      "expected.toml.\n");
}

}  // namespace expected_test
