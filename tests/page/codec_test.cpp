#include "page/codec.hpp"
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

TEST(Codec, FramesAreLowBytesThenHighBytesOfTheChanges)
{
  const std::vector<Codes> frames{{0x0102, 0xfffe}, {0x0101, 0x0001}};  // changes: -1, +3
  EXPECT_EQ(encode_frames(frames), std::string("\x02\xfe\x01\xff\xff\x03\xff\x00", 8));
}

TEST(Codec, FramesComeBack)
{
  Random random(7);
  std::vector<Codes> frames(5, Codes(101));
  for (Codes& codes : frames)
    for (auto& q : codes) q = static_cast<std::uint16_t>(random.below(65536));
  EXPECT_EQ(decode_frames(encode_frames(frames), 101), frames);
  EXPECT_THROW(decode_frames("abc", 1), std::invalid_argument);
}

}  // namespace codec_test
