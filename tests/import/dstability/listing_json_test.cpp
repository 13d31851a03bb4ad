#include "import/dstability/listing.hpp"
#include "sections.hpp"

#include <nlohmann/json.hpp>

namespace listing_json_test {

TEST(ListingJson, IsTheSameForAProgram)
{
  const auto json = nlohmann::json::parse(listing_json(listed_project(), always_fits));
  EXPECT_EQ(json["application"], "D-Stability 2026.01");
  const auto& calculations = json["scenarios"][0]["calculations"];
  EXPECT_EQ(calculations[0]["result"]["factor_of_safety"], 1.23456);
  EXPECT_EQ(calculations[0]["result"]["verdict"], "fits");
  EXPECT_TRUE(calculations[1]["result"].is_null());
  EXPECT_EQ(json["soils"][1]["shansep"]["S"]["mean"], 0.30);
  EXPECT_EQ(json["soils"][1]["unit_weight_below"], 16e3);
  EXPECT_TRUE(json["soils"][1]["classic"]["dilatancy"]["value"].is_null());  // not given
  EXPECT_EQ(json["remarks"][0]["what"], "A remark.");
}

}  // namespace listing_json_test
