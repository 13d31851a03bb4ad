#include "io/case/key_text.hpp"
#include "support/test.hpp"

namespace key_text_test {

TEST(KeyText, SaysRangesWithUnits)
{
  EXPECT_EQ(range_text(positive, "s"), "more than 0 s");
  EXPECT_EQ(range_text(not_negative, "-"), "at least 0");
  EXPECT_EQ(range_text(between_open(0.0, 0.5), "-"), "more than 0 and less than 0.5");
  EXPECT_EQ(range_text(between(1.0, 2.0), "m"), "at least 1 and at most 2 m");
  EXPECT_EQ(range_text(any_number, "m"), "");
  EXPECT_EQ(usual_text(between(500.0, 5000.0), "kg/m^3"), "500 to 5000 kg/m^3");
}

TEST(KeyText, TakesDefaultsFromTheStructs)
{
  EXPECT_EQ(find_key("time.courant")->default_text, "0.98");
  EXPECT_EQ(find_key("scheme")->default_text, "\"mpm_gp\"");
  EXPECT_EQ(find_key("body[].points_per_cell")->default_text, "[5, 5]");
  EXPECT_EQ(find_key("method.b_bar")->default_text, "true");
  EXPECT_EQ(find_key("output.history.every")->default_text, "0.01 s");
  EXPECT_EQ(find_key("boundary.SIDE")->default_text, "\"free\"");
  EXPECT_EQ(find_key("boundary.SIDE.contact")->default_text, "");
  EXPECT_EQ(find_key("time.end")->default_text, "");
  EXPECT_EQ(find_key("mesh.grading")->default_text, "[1, 1]");
  EXPECT_EQ(find_key("mesh.follow_bodies")->default_text, "true");
  EXPECT_EQ(find_key("mesh.edges")->default_text, "none");
  EXPECT_EQ(find_key("mesh.size")->default_text, "");
  EXPECT_EQ(find_key("body[].region")->default_text, "");
}

TEST(KeyText, SaysWhatIsAllowed)
{
  EXPECT_EQ(allowed_text(*find_key("mesh.origin")), "two numbers [x, y] in m");
  EXPECT_EQ(
      allowed_text(*find_key("mesh.cells")), "an integer or two integers [nx, ny], at least 1 and at most 100000");
  EXPECT_EQ(allowed_text(*find_key("mesh.sides.top")), "at least two places [[x, y], [x, y]] in m");
  EXPECT_EQ(allowed_text(*find_key("mesh.edges")), "a table { NAME = [k, ...] } of edge numbers, at least 0");
  EXPECT_EQ(allowed_text(*find_key("mesh.refine[].box")), "two corners [[x0, y0], [x1, y1]] in m");
  EXPECT_EQ(allowed_text(*find_key("body[].holes")),
      "a list of polygons [[[x, y], [x, y], [x, y]], ...], each of three or more in m");
  EXPECT_EQ(allowed_text(*find_key("initial.stress")), "\"none\", \"k0\", \"equilibrium\"");
  EXPECT_EQ(allowed_text(*find_key("mesh.cell")), "a number or two numbers [x, y], more than 0 m");
}

TEST(KeyText, TakesPathsApart)
{
  EXPECT_EQ(last_part("body[].box"), "box");
  EXPECT_EQ(last_part("material.NAME"), "material");
  EXPECT_EQ(parent_path("body[].box"), "body[]");
  EXPECT_EQ(parent_path("material.NAME.density"), "material.NAME");
  EXPECT_EQ(parent_path("material.NAME"), "");
  EXPECT_EQ(topic_of("body[].box"), "body.box");
  EXPECT_EQ(topic_of("material.NAME.density"), "material.density");
  EXPECT_EQ(header_of("body[]"), "[[body]]");
}

}  // namespace key_text_test
