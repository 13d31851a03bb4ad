#include "meshing/msh_scanner.hpp"
#include "meshing/msh_text.hpp"
#include "support/test.hpp"

namespace msh_scanner_test {

TEST(MshScanner, ReadsTextAndBytesAlike)
{
  MshScanner text("m", " 12 -7 2.5e-1\n");
  MshScanner bytes("m", bytes_of<std::int32_t>(12) + bytes_of<std::int64_t>(-7) + bytes_of(0.25));
  bytes.set_binary(true);
  for (MshScanner* scan : {&text, &bytes}) {
    EXPECT_EQ(scan->integer(Width::four, "a"), 12);
    EXPECT_EQ(scan->integer(Width::eight, "b"), -7);
    EXPECT_EQ(scan->real("c"), 0.25);
    scan->end_record();
  }
}

TEST(MshScanner, ReadsNumbersAtTheEdgeOfTheirRange)
{
  MshScanner scan("m", "1e-400 9223372036854775807 2147483648 1e400");
  EXPECT_EQ(scan.real("x"), 0.0);
  EXPECT_EQ(scan.integer(Width::eight, "n"), 9223372036854775807);
  EXPECT_EQ(refusal<MeshError>([&] { scan.integer(Width::four, "a tag"); }), "m:1: a tag is out of range: 2147483648");
  EXPECT_EQ(refusal<MeshError>([&] { scan.real("x"); }), "m:1: x is expected, got `1e400`");
}

TEST(MshScanner, CountsLinesFromOne)
{
  MshScanner scan("dike.msh", "1\n2\n\nx");
  scan.integer(Width::four, "n");
  scan.end_record();
  scan.integer(Width::four, "n");
  scan.end_record();
  EXPECT_EQ(
      refusal<MeshError>([&] { scan.integer(Width::four, "n"); }), "dike.msh:3: the line ends where n is expected");
  scan.end_record();
  EXPECT_EQ(refusal<MeshError>([&] { scan.integer(Width::four, "n"); }), "dike.msh:4: n is expected, got `x`");
}

TEST(MshScanner, ShowsOnlyWhatCanBePrinted)
{
  MshScanner scan("m", "\x01\x02" + std::string(60, 'a'));
  EXPECT_EQ(refusal<MeshError>([&] { scan.real("x"); }), "m:1: x is expected, got `??" + std::string(38, 'a') + "...`");
}

TEST(MshScanner, WalksFromSectionToSection)
{
  MshScanner scan("m", "words\n$A\n1\n$EndA\n\n$B\nwhat $EndB is\n$EndB\n");
  EXPECT_EQ(scan.next_section(), "A");
  EXPECT_EQ(scan.integer(Width::four, "n"), 1);
  scan.end_section("A");
  EXPECT_EQ(scan.next_section(), "B");
  scan.skip_section("B");
  EXPECT_EQ(scan.next_section(), "");
}

TEST(MshScanner, ReadsNamesInQuotes)
{
  MshScanner scan("m", " \"sand \"and\" clay\" \r\n\"open\n");
  EXPECT_EQ(scan.quoted("a name"), "sand \"and\" clay");
  scan.end_record();
  EXPECT_EQ(
      refusal<MeshError>([&] { scan.quoted("a name"); }), "m:2: a name in double quotes is expected, got `\"open`");
}

TEST(MshScanner, RefusesACountBeyondTheRestOfTheFile)
{
  const std::string text = "3\n1 2\n3 4\n5 6\n";
  EXPECT_EQ(MshScanner("m", text).count(Width::eight, 2, "n"), 3);
  EXPECT_EQ(refusal<MeshError>([&] { MshScanner("m", "4" + text.substr(1)).count(Width::eight, 2, "n"); }),
      "m:1: n is 4, more than the rest of the file can hold");
}

}  // namespace msh_scanner_test
