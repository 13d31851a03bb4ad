#include "batch/store_head.hpp"
#include "model/case/method_form.hpp"
#include "support/test.hpp"

namespace store_head_test {

const StoreHead head{
    .version = "0.1.0", .case_digits = "1", .study_digits = "2", .build = "3", .instructions = "avx512"};

StoreHead with(const std::string& build, const std::string& instructions)
{
  StoreHead other = head;
  other.build = build, other.instructions = instructions;
  return other;
}

TEST(StoreHead, ComesBackAsItWasWritten)
{
  EXPECT_EQ(read_head(line_of(head), "x.rows"), head);
  EXPECT_TRUE(is_head(line_of(head)));
  EXPECT_FALSE(is_head("17\t0.5"));
  EXPECT_EQ(refusal([] { read_head("17\t0.5", "x.rows"); }),
      "x.rows: this is no store of a study\n  Choose another folder: -o DIR");
  for (const auto& [format, last_line] :
      {std::pair<std::string, std::string>{"7", "\n  " + std::string(defaults_before)}, {"10", "-o DIR."}})
    EXPECT_THAT(refusal([&] { read_head("terp study\t" + format + "\t0.1.0\ta\tb", "x.rows"); }),
        AllOf(HasSubstr("x.rows: this store has format " + format + ", and this terp reads format 9\n  Solve it anew"),
            EndsWith(last_line)));
}

TEST(StoreHead, SaysWhatIsAnotherStudy)
{
  EXPECT_EQ(why_of_another_study(with("4", "sse2"), head), "") << "the same study, by another program";
  StoreHead other = head;
  other.study_digits = "9";
  EXPECT_EQ(why_of_another_study(other, head), "what is drawn, its seed or the events are others");
  other = head, other.case_digits = "9";
  EXPECT_EQ(why_of_another_study(other, head), "the case is another one, or its mesh");
  other = head, other.version = "0.0.1";
  EXPECT_EQ(why_of_another_study(other, head), "it was solved by terp 0.0.1, this is 0.1.0");
}

TEST(StoreHead, KnowsWhichInstructionsGiveTheSameBits)
{
  EXPECT_EQ(same_bits(head, head), SameBits::yes);
  EXPECT_EQ(same_bits(head, with("3", "avx2")), SameBits::yes);
  EXPECT_EQ(same_bits(head, with("3", "sse2")), SameBits::no);
  EXPECT_EQ(same_bits(head, with("4", "sse2")), SameBits::no);
  EXPECT_EQ(same_bits(with("3", "sse2"), with("3", "sse2")), SameBits::yes);
  EXPECT_EQ(same_bits(head, with("4", "avx512")), SameBits::unknown) << "another build";
  EXPECT_EQ(same_bits(head, with("3", "native")), SameBits::unknown);
  EXPECT_EQ(same_bits(with("3", "native"), with("3", "native")), SameBits::yes);
  EXPECT_EQ(same_bits(with("unknown", "avx2"), with("unknown", "avx2")), SameBits::unknown);
}

}  // namespace store_head_test
