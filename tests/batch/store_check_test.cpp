#include "math/checksum.hpp"
#include "os/instructions.hpp"
#include "batch/engine.hpp"
#include "batch/samples.hpp"

namespace store_check_test {

/// A store of four realisations under the head of somebody else.
struct Begun {
  ScratchFolder folder;
  Study study = study_in(folder.path(), changed(column_study, "number = 12", "number = 4"));
  std::string file = folder.path() + "/part_1_of_1.rows";

  explicit Begun(const std::string& build, const std::string& set = std::string(instructions()))
  {
    Realisations rows;
    run_realisations(study, folder.path(), {.threads = 2}, never_stop, rows);
    StoreHead head = head_of(study);
    const std::string own = line_of(head);
    head.build = build, head.instructions = set;
    replace(own, line_of(head));
  }

  void replace(const std::string& line, const std::string& by) const
  {
    const auto whole = [](const std::string& text) { return digits_of(text) + '\t' + text + '\n'; };
    write_file_atomically(file, changed(read_file(file), whole(line), whole(by)));
  }

  std::string check() const
  {
    return check_that_bits_agree(study, folder.path(), read_store(study, folder.path()), never_stop);
  }
};

TEST(StoreCheck, OwnResultsNeedNone)
{
  const Begun begun(head_of(Begun("x").study).build);
  EXPECT_EQ(begun.check(), "");
  EXPECT_THAT(read_store(begun.study, begun.folder.path()).solvers, SizeIs(1));
}

TEST(StoreCheck, AnotherBuildIsTriedAndNamed)
{
  const Begun begun("0123456789abcdef");
  EXPECT_THAT(begun.check(), MatchesRegex("note: part of this store was solved by build 0123456789abcdef of terp with "
                                          ".*; this is build .* with .*. Realisation [0-3] has the same bits here\n"));
  Realisations rows = read_store(begun.study, begun.folder.path()).rows;
  rows.erase(3);
  run_realisations(begun.study, begun.folder.path(), {}, never_stop, rows);
  const StoredStudy stored = read_store(begun.study, begun.folder.path());
  ASSERT_THAT(stored.solvers, SizeIs(2)) << "the second head stands before what this build has solved";
  EXPECT_EQ(stored.solvers[0].head.build, "0123456789abcdef");
  EXPECT_EQ(stored.solvers[1].head, head_of(begun.study));
  EXPECT_EQ(stored.solvers[1].first_solved, 3);
}

TEST(StoreCheck, OtherBitsAreRefused)
{
  const Begun begun("0123456789abcdef");
  const StoredStudy stored = read_store(begun.study, begun.folder.path());
  Realisation row = stored.rows.at(*stored.solvers.front().first_solved);
  const std::string line = line_of(row);
  row.outcomes.front() = std::nextafter(row.outcomes.front(), 1e9);
  begun.replace(line, line_of(row));
  EXPECT_THAT(refusal<FileError>([&] { begun.check(); }),
      AllOf(HasSubstr(fmt::format("realisation {} of this store has other results here\n", row.number)),
          HasSubstr("It was solved by build 0123456789abcdef of terp"), HasSubstr("-o DIR")));
}

TEST(StoreCheck, AnotherInstructionSetIsRefusedWithoutATry)
{
  const std::string own(instructions());
  if (own != "sse2" && !own.starts_with("avx")) GTEST_SKIP() << "a build with a single set";
  const std::string other = own == "sse2" ? "avx2" : "sse2";
  const Begun begun("0123456789abcdef", other);
  EXPECT_THAT(refusal<FileError>([&] { begun.check(); }),
      AllOf(HasSubstr("this store was solved with the instruction set " + other + ", and this terp uses " + own),
          HasSubstr("TERP_INSTRUCTIONS=" + other)));
}

TEST(StoreCheck, PartsThatRanAtOneTimeWithOtherBitsAreNamed)
{
  StoredStudy stored;
  for (const char* set : {"avx2", "avx512"}) stored.solvers.push_back({.head = {.build = "b", .instructions = set}});
  EXPECT_EQ(why_bits_differ(stored), "");
  stored.solvers.push_back({.head = {.build = "b", .instructions = "sse2"}});
  EXPECT_EQ(why_bits_differ(stored),
      "warning: parts of this study were solved with avx2 and with sse2, which give other bits\n"
      "  The table is not that of one process. Begin anew with TERP_INSTRUCTIONS=sse2 on all machines.\n");
}

}  // namespace store_check_test
