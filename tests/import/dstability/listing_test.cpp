#include "import/dstability/listing.hpp"

#include "sections.hpp"

namespace listing_test {

TEST(Listing, IsATableThatAnEngineerReads)
{
  EXPECT_EQ(listing_of(listed_project(), always_fits), R"(hand.stix: D-Stability 2026.01, content version 2

scenario 1  ""
  stage 1  "daily"
           2 layers; x 0.0 to 20.0 m, z -10.00 to 0.00 m; phreatic line -1.00 to -1.00 m, 0 reference lines
  calculation 1  "Bishop één"  Bishop   Design         F = 1.2346    fits  bishop/bishopresult
  calculation 2  "Later"       Spencer  Deterministic  not computed

soils in use: 2 of 2
        weight [kN/m3]  strength above the phreatic line  and below it
  sand  18.00 / 20.00   c' 2.0 phi' 30.0 psi 0.0          c' 2.0 phi' 30.0 psi 0.0
  clay  15.00 / 16.00   c' 5.0 phi' 25.0 (classic)        S 0.250 (0.300; 0.0500) m 0.800
  c' in kPa, angles in degrees; (mean; standard deviation) of what is probabilistic

left out, or not understood:
  soils.json: A remark.
)");
}

TEST(Listing, HasAWordForEveryModel)
{
  EXPECT_STREQ(word_of(StixStrengthModel::shansep), "shansep");
  EXPECT_STREQ(word_of(StixStrengthModel::unknown), "unknown");
}

}  // namespace listing_test
