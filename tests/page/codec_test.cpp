#include "page/codec.hpp"
#include "io/files/compress.hpp"
#include "support/random.hpp"

namespace codec_test {

TEST(Codec, ACodeIsWithinHalfAStepOfItsValue)
{
  const Scale scale = make_scale(-3.0, 5.0, 0.001);
  EXPECT_EQ(scale.step, 0.001);
  for (Real v = -3.0; v <= 5.0; v += 0.00137) {
    const Real back =
        scale.lo + (scale.hi() - scale.lo) * quantise(v, scale) / 65535.0;  // as docs/report_format.md has it
    EXPECT_NEAR(back, v, 0.0005 + 1e-12);
  }
}

TEST(Codec, AStepThatIsTooFineForTheRangeBecomesCoarser)
{
  const Scale scale = make_scale(0.0, 65534.0, 0.1);
  EXPECT_EQ(scale.step, 1.0);
  EXPECT_EQ(quantise(65534.0, scale), 65534);
}

TEST(Codec, WhatIsNoNumberHasTheCodeThatNoValueHas)
{
  const Scale scale = make_scale(0.0, 1.0, 0.001);
  EXPECT_EQ(quantise(std::nan(""), scale), no_value);
  EXPECT_EQ(quantise(1e9, scale), 65534);
  EXPECT_EQ(quantise(-1e9, scale), 0);
}

TEST(Codec, CoarseCodesAreTheNearestOfLongerSteps)
{
  Codes codes{0, 1, 2, 3, 4, 65534, no_value};
  coarsen(codes, 4);
  EXPECT_THAT(codes, ElementsAre(0, 0, 1, 1, 1, 16384, no_value));
}

// Changes of three points: 258, 258, -1, then 1, 0, 0. Less those of the point before: 258, 0, -259, then 1, -1, 0.
// Folded: 516, 0, 517, then 2, 1, 0. In two bits, the first lowest: 3, 0, 3, 2 and 1, 0; listed: 513, 514.
TEST(Codec, FramesAreChangesLessThoseOfTheNeighbour)
{
  const std::vector<Codes> frames{{258, 258, no_value}, {259, 258, no_value}};
  EXPECT_EQ(encode_frames(frames, Layout::by_frame), std::string("\xb3\x01\x01\x02\x02\x02", 6));
}

TEST(Codec, OrCodesPointByPoint)
{
  const std::vector<Codes> frames{{0x0102, 0x00ff}, {0x0001, 0xff04}};
  EXPECT_EQ(encode_frames(frames, Layout::by_point), std::string("\x02\x01\xff\x04\x01\x00\x00\xff", 8));
}

TEST(Codec, FramesComeBack)
{
  Random random(7);
  std::vector<Codes> frames(5, Codes(101));
  for (Codes& codes : frames)
    for (auto& q : codes) q = static_cast<std::uint16_t>(random.below(65536));
  for (const Layout layout : {Layout::by_frame, Layout::by_point}) {
    EXPECT_EQ(decode_frames(encode_frames(frames, layout), 5, 101, layout), frames);
    EXPECT_THROW(decode_frames("abc", 5, 101, layout), std::invalid_argument);
  }
}

TEST(Codec, TheBestPackingIsThatOfAllPoints)
{
  Random random(7);
  std::vector<Codes> smooth(9, Codes(40000)), of_cells = smooth, histories(9, Codes(50));
  for (std::size_t f = 0; f < 9; ++f) {
    for (auto& q : histories[f]) q = static_cast<std::uint16_t>(random.below(65535));
    for (std::size_t p = 0; p < 40000; ++p) {
      smooth[f][p] = static_cast<std::uint16_t>(random.below(2) + p / 100 * f);
      of_cells[f][p] = histories[f][p * p % 50];
    }
  }
  const Packing packing = best_packing(smooth);
  EXPECT_EQ(packing.layout, Layout::by_frame);
  const auto all = static_cast<double>(gzip(encode_frames(smooth, Layout::by_frame)).size());
  EXPECT_NEAR(static_cast<double>(packing.bytes), all, 0.15 * all);
  EXPECT_EQ(best_packing(of_cells).layout, Layout::by_point);
}

TEST(Codec, WordsAreDifferencesByBytes)
{
  const std::vector<std::uint32_t> words{0x01020304, 0x01020303, 0x01020305};
  const std::string packed = pack_words(bytes_of(std::span<const std::uint32_t>(words)));
  EXPECT_EQ(packed, std::string("\x04\xff\x02\x03\xff\x00\x02\xff\x00\x01\xff\x00", 12));
  EXPECT_EQ(unpack_words(packed), bytes_of(std::span<const std::uint32_t>(words)));
}

}  // namespace codec_test
