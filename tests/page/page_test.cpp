#include "page/page.hpp"
#include "support/test.hpp"

namespace page_test {

const Payload payload{.json = R"({"format":1})", .chunks = {"QUJD", "Zg=="}, .notes = {}, .warnings = {}};

TEST(Page, HasTheDataWhereTheMarkerStood)
{
  EXPECT_EQ(make_page("<body><!--terp-data--><p></body>", payload),
      "<body><script id=\"terp-report\" type=\"application/json\">{\"format\":1}</script>\n"
      "<script type=\"application/octet-stream\" data-chunk=\"0\">QUJD</script>\n"
      "<script type=\"application/octet-stream\" data-chunk=\"1\">Zg==</script>\n<p></body>");
}

TEST(Page, WithoutTheMarkerOrWithTwoIsRefused)
{
  EXPECT_THROW(make_page("<body></body>", payload), std::invalid_argument);
  EXPECT_THROW(make_page("<!--terp-data--><!--terp-data-->", payload), std::invalid_argument);
}

TEST(Page, ThatIsBuiltInTakesTheData)
{
  EXPECT_NO_THROW(make_page(page_template(), payload));
  EXPECT_EQ(!has_page(), page_template().find("built without its report page") != std::string_view::npos);
}

}  // namespace page_test
