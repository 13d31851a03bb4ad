#include "os/instructions.hpp"
#include "support/test.hpp"
#include <cstdlib>

namespace instructions_test {

/// A processor without AVX-512.
const InstructionSet sets[] = {{"avx512", false}, {"avx2", true}, {"sse2", true}};

std::string refusal(std::span<const InstructionSet> of, std::string_view word)
{
  return test::refusal<InstructionsError>([&] { choose_instructions(of, word); });
}

TEST(Instructions, TheBestThatTheProcessorOffersIsTaken)
{
  EXPECT_EQ(sets[choose_instructions(sets, "")].name, "avx2");
  EXPECT_EQ(choose_instructions(std::span(sets).subspan(2), ""), 0u);
}

TEST(Instructions, TheWordOfTheUserCounts) { EXPECT_EQ(sets[choose_instructions(sets, "sse2")].name, "sse2"); }

TEST(Instructions, WhatTheProcessorLacksIsRefused)
{
  EXPECT_EQ(refusal(sets, "avx512"),
      "TERP_INSTRUCTIONS=avx512: this processor does not offer it\n"
      "  Without the variable Terp takes the best set that the processor offers.");
}

TEST(Instructions, AnUnknownWordIsRefusedWithThoseThatAreKnown)
{
  EXPECT_EQ(refusal(sets, "AVX2"),
      "TERP_INSTRUCTIONS=AVX2: there is no such set in this build. It has: avx512, avx2, sse2\n"
      "  Without the variable Terp takes the best set that the processor offers.");
}

TEST(Instructions, AProcessorBelowAllSetsIsRefused)
{
  EXPECT_EQ(refusal(std::span(sets).first(1), ""),
      "this processor offers none of the instruction sets of this build: avx512.");
}

TEST(Instructions, TheLastSetOfThisBuildRunsOnAnyMachine) { EXPECT_TRUE(instruction_sets().back().offered); }

TEST(Instructions, OfThisProcessAreWhatTheVariableSaysOrTheBest)
{
  const char* word = std::getenv("TERP_INSTRUCTIONS");
  EXPECT_EQ(chosen_set(), choose_instructions(instruction_sets(), word == nullptr ? "" : word));
  EXPECT_EQ(instructions(), instruction_sets()[chosen_set()].name);
}

TEST(Processor, HasANameOnOneLine)
{
  const std::string name = processor_name();  // empty where /proc/cpuinfo has no such line, as on ARM
  EXPECT_EQ(name.find('\n'), std::string::npos);
  EXPECT_TRUE(name.empty() || name.ends_with(" processors")) << name;
}

}  // namespace instructions_test
