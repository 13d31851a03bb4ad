#include "output/json_text.hpp"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace terp {
namespace {

/// In quotation marks, with what JSON or HTML would misread escaped.
std::string quoted(std::string_view text)
{
  std::string out = "\"";
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '"' || c == '\\')
      out += {'\\', c};
    else if (c == '<')
      out += "\\u003c";
    else if (c == '\n')
      out += "\\n";
    else if (static_cast<unsigned char>(c) < 0x20)
      fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<int>(c));
    else
      out += c;
  }
  return out + '"';
}

}  // namespace

void JsonText::separate()
{
  if (!first_) text_ += ',';
  first_ = false;
}

JsonText& JsonText::put(std::string_view token)
{
  separate();
  text_ += token;
  return *this;
}

JsonText& JsonText::open(char bracket)
{
  separate();
  text_ += bracket;
  first_ = true;
  return *this;
}

JsonText& JsonText::close(char bracket)
{
  text_ += bracket;
  first_ = false;
  return *this;
}

JsonText& JsonText::key(std::string_view name)
{
  separate();
  text_ += quoted(name) + ":";
  first_ = true;
  return *this;
}

JsonText& JsonText::value(Real number) { return std::isfinite(number) ? put(fmt::format("{}", number)) : null(); }

JsonText& JsonText::value(std::string_view text) { return put(quoted(text)); }

JsonText& JsonText::raw(std::string_view json)
{
  separate();
  for (const char c : json) {
    if (c == '<')
      text_ += "\\u003c";  // only inside a text can it stand
    else
      text_ += c;
  }
  return *this;
}

}  // namespace terp
