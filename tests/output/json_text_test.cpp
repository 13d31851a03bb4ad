// JSON written piece by piece, read by another reader.
#include "output/json_text.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace terp {
namespace {

TEST(JsonText, HasCommasOnlyBetweenValues)
{
  JsonText json;
  json.begin_object()
      .key("a")
      .begin_array()
      .value(1)
      .value(true)
      .null()
      .begin_object()
      .end_object()
      .begin_array()
      .end_array()
      .end_array();
  json.entry("b", "text").entry("c", -2.5).end_object();
  EXPECT_EQ(json.text(), R"({"a":[1,true,null,{},[]],"b":"text","c":-2.5})");
}

TEST(JsonText, NumbersComeBackToTheBitAndWhatIsNoneIsNull)
{
  JsonText json;
  json.begin_array()
      .value(0.1 + 0.2)
      .value(1e-300)
      .value(std::nan(""))
      .value(INFINITY)
      .value(std::optional<Real>())
      .value(std::optional<Real>(3.5))
      .end_array();
  const auto read = nlohmann::json::parse(json.text());
  EXPECT_EQ(read[0].get<Real>(), 0.1 + 0.2);
  EXPECT_EQ(read[1].get<Real>(), 1e-300);
  for (int k = 2; k < 5; ++k) EXPECT_TRUE(read[k].is_null());
  EXPECT_EQ(read[5].get<Real>(), 3.5);
}

TEST(JsonText, TextsComeBackAndEndNoScriptOfAPage)
{
  const std::string hard = "a \"b\" \\ </script> <!-- \n\t\x01 ε";
  JsonText json;
  json.begin_array().value(hard).raw(R"({"case": "</script>"})").end_array();
  EXPECT_EQ(json.text().find("</"), std::string::npos);
  const auto read = nlohmann::json::parse(json.text());
  EXPECT_EQ(read[0].get<std::string>(), hard);
  EXPECT_EQ(read[1].at("case").get<std::string>(), "</script>");
}

}  // namespace
}  // namespace terp
