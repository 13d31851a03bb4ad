#include "page/document.hpp"

#include "io/files/compress.hpp"
#include "page/codec.hpp"

namespace terp {

nlohmann::ordered_json PageDocument::table(const std::vector<PageColumn>& columns)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::vector<float> numbers;
  for (const PageColumn& column : columns) {
    list.push_back({{"name", column.name}, {"label", column.label}, {"unit", column.unit}});
    for (const Real value : column.values) numbers.push_back(static_cast<float>(value));
  }
  chunks_.push_back(base64(gzip(pack_words(bytes_of(std::span<const float>(numbers))))));
  return {{"columns", std::move(list)}, {"chunk", chunks_.size() - 1},
      {"rows", columns.empty() ? 0 : columns.front().values.size()}};
}

Payload PageDocument::payload(const std::string& kind, const std::string& written, const std::string& language) const
{
  const nlohmann::ordered_json document{{"format", report_format}, {"kind", kind}, {"terp", TERP_VERSION},
      {"written", written}, {"language", language}, {"data", data}};
  return {.json = text_for_a_page(document.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)),
      .chunks = chunks_,
      .notes = {},
      .warnings = {}};
}

}  // namespace terp
