#include "page/document.hpp"
#include "support/page_data.hpp"
#include "support/test.hpp"

namespace document_test {

TEST(PageDocument, HasItsKindItsHeadAndTablesColumnByColumn)
{
  PageDocument page(R"({"title": "a </script> of <b>"})");
  page.data["table"] = page.table({{"x", "place", "m", {1.0, 2.5}}, {"p", "", "-", {0.25, std::nan("")}}});
  const Payload payload = page.payload("study", "2026-01-02T03:04:05Z", "nl");
  EXPECT_THAT(payload.json, Not(HasSubstr("<")));
  const auto document = nlohmann::json::parse(payload.json);
  EXPECT_EQ(document["format"], 2);
  EXPECT_EQ(document["kind"], "study");
  EXPECT_EQ(document["written"], "2026-01-02T03:04:05Z");
  EXPECT_EQ(document["language"], "nl");
  EXPECT_EQ(document["data"]["title"], "a </script> of <b>");
  const auto table = document["data"]["table"];
  EXPECT_EQ(table["columns"][0], (nlohmann::json{{"name", "x"}, {"label", "place"}, {"unit", "m"}}));
  EXPECT_THAT(test::column_of(payload, table, "x"), testing::ElementsAre(1.0f, 2.5f));
  EXPECT_THAT(test::column_of(payload, table, "p"), testing::ElementsAre(0.25f, testing::IsNan()));
}

}  // namespace document_test
