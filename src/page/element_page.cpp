#include "page/element_page.hpp"

#include "page/document.hpp"

namespace terp {
namespace {

constexpr std::size_t most_increments = 1000;  // of a material; a chart is no wider

std::vector<PageColumn> columns_on_page(const ElementResult& result)
{
  const std::size_t n = result.columns.front().values.size(), stride = 1 + n / most_increments;
  std::vector<PageColumn> columns;
  for (const ElementColumn& column : result.columns) {
    PageColumn& on_page = columns.emplace_back(PageColumn{column.name, column.label, column.unit, {}});
    for (std::size_t k = 0; k < n; k += stride) on_page.values.push_back(column.values[k]);
    if ((n - 1) % stride != 0) on_page.values.push_back(column.values.back());
  }
  return columns;
}

}  // namespace

Payload element_payload(
    const std::string& title, const std::vector<ElementOnPage>& elements, const std::string& written)
{
  PageDocument page("{}");
  page.data["title"] = title;
  page.data["elements"] = nlohmann::ordered_json::array();
  for (const ElementOnPage& element : elements) {
    nlohmann::ordered_json entry{{"material", element.material}, {"law", element.law}, {"fault", element.result.fault}};
    entry["rows"] = page.table(columns_on_page(element.result));
    page.data["elements"].push_back(std::move(entry));
  }
  return page.payload("element", written);
}

}  // namespace terp
