// What stands in the data of a page: its JSON, and its chunks decoded.
#pragma once

#include "io/files/compress.hpp"
#include "page/codec.hpp"
#include "page/payload.hpp"

#include <cstring>

#include <nlohmann/json.hpp>

namespace terp::test {

inline std::string from_base64(const std::string& text)
{
  const std::string signs = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int n_bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<unsigned>(signs.find(c));
    if ((n_bits += 6) >= 8) bytes += static_cast<char>(bits >> (n_bits -= 8) & 0xff);
  }
  return bytes;
}

inline nlohmann::json data_of(const Payload& payload) { return nlohmann::json::parse(payload.json).at("data"); }

/// A column of a table of the document.
inline std::vector<float> column_of(const Payload& payload, const nlohmann::json& table, const std::string& name)
{
  const std::string bytes = unpack_words(gunzip(from_base64(payload.chunks.at(table.at("chunk").get<std::size_t>()))));
  std::vector<float> values(table.at("rows").get<std::size_t>());
  for (std::size_t c = 0; c < table.at("columns").size(); ++c)
    if (table["columns"][c]["name"] == name)
      return std::memcpy(
                 values.data(), bytes.data() + c * values.size() * sizeof(float), values.size() * sizeof(float)),
             values;
  throw std::out_of_range(name);
}

}  // namespace terp::test
