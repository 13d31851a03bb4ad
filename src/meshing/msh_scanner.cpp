// Text and bytes are read by the same calls. `last_` is where the number read last began: faults point there. A count
// is compared with what the rest of the file can hold before memory is asked for.

#include "meshing/msh_scanner.hpp"

#include "mesh/mesh_error.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr std::size_t most_quoted = 40;  // characters of the file in a message

/// Part of the file as it may be printed: short, no control characters.
std::string printable(std::string_view text)
{
  std::string out(text.substr(0, most_quoted));
  for (char& c : out)
    if (c < 32 || c > 126) c = '?';
  return text.size() > most_quoted ? out + "..." : out;
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view without_end_blanks(std::string_view text)
{
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace

MshScanner::MshScanner(std::string path, std::string text) : path_(std::move(path)), text_(std::move(text)) {}

void MshScanner::fail(const std::string& what) const
{
  if (binary_) throw MeshError(fmt::format("{}: byte {}: {}", path_, last_, what));
  const auto line =
      1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(std::min(last_, text_.size())), '\n');
  throw MeshError(fmt::format("{}:{}: {}", path_, line, what));
}

std::string_view MshScanner::rest_of_line() const { return rest().substr(0, rest().find('\n')); }

void MshScanner::skip_blanks()
{
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
}

std::string MshScanner::next_section()
{
  for (; at_ < text_.size(); at_ = std::min(text_.size(), at_ + rest_of_line().size() + 1)) {
    skip_blanks();
    const std::string_view line = without_end_blanks(rest_of_line());
    if (!line.starts_with('$')) continue;
    last_ = at_;
    at_ = std::min(text_.size(), at_ + rest_of_line().size() + 1);
    return printable(line.substr(1));
  }
  return {};
}

void MshScanner::end_section(const std::string& name)
{
  while (at_ < text_.size() && (is_blank(text_[at_]) || text_[at_] == '\n')) ++at_;
  last_ = at_;
  const std::string expected = "$End" + name;
  if (at_ == text_.size()) fail(fmt::format("the file ends before `{}`: it is cut off", expected));
  if (without_end_blanks(rest_of_line()) != expected)
    fail(fmt::format("`{}` is expected, got `{}`", expected, printable(rest_of_line())));
  at_ += rest_of_line().size();
}

void MshScanner::skip_section(const std::string& name)
{
  const std::size_t end = text_.find("\n$End" + name, at_ == 0 ? 0 : at_ - 1);
  if (end == std::string::npos) fail(fmt::format("section ${0} has no `$End{0}`: the file is cut off", name));
  at_ = end + 1;
  end_section(name);
}

template <class T>
T MshScanner::bytes(const char* what)
{
  last_ = at_;
  if (rest().size() < sizeof(T)) fail(fmt::format("the file ends where {} is expected: it is cut off", what));
  T value;
  std::memcpy(&value, text_.data() + at_, sizeof(T));
  at_ += sizeof(T);
  return value;
}

std::string_view MshScanner::token(const char* what)
{
  skip_blanks();
  last_ = at_;
  if (at_ == text_.size()) fail(fmt::format("the file ends where {} is expected: it is cut off", what));
  if (text_[at_] == '\n') fail(fmt::format("the line ends where {} is expected", what));
  const std::size_t end = std::min(text_.find_first_of(" \t\r\n", at_), text_.size());
  const std::string_view found = std::string_view(text_).substr(at_, end - at_);
  at_ = end;
  return found;
}

std::int64_t MshScanner::integer(Width width, const char* what)
{
  if (binary_) return width == Width::four ? bytes<std::int32_t>(what) : bytes<std::int64_t>(what);
  const std::string_view text = token(what);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    fail(fmt::format("{} is expected, got `{}`", what, printable(text)));
  if (width == Width::four && value != static_cast<std::int32_t>(value))
    fail(fmt::format("{} is out of range: {}", what, value));
  return value;
}

Real MshScanner::real(const char* what)
{
  if (binary_) return bytes<double>(what);
  const std::string_view text = token(what);
  Real value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool too_small = error == std::errc::result_out_of_range &&
                         std::abs(std::strtod(std::string(text).c_str(), nullptr)) < 1.0;  // a zero
  if ((error != std::errc{} && !too_small) || end != text.data() + text.size())
    fail(fmt::format("{} is expected, got `{}`", what, printable(text)));
  return value;
}

std::string MshScanner::quoted(const char* what)
{
  skip_blanks();
  last_ = at_;
  const std::string_view line = without_end_blanks(rest_of_line());
  if (line.size() < 2 || line.front() != '"' || line.back() != '"')
    fail(fmt::format("{} in double quotes is expected, got `{}`", what, printable(line)));
  at_ += line.size();
  return std::string(line.substr(1, line.size() - 2));
}

std::int64_t MshScanner::count(Width width, int numbers, const char* what)
{
  const std::int64_t n = integer(width, what);
  const auto bytes_left = static_cast<std::int64_t>(rest().size()) + 1;
  const std::int64_t least_bytes = 2 * std::int64_t{numbers};  // a digit and a blank; bytes take more
  if (n < 0 || n > bytes_left / least_bytes)
    fail(fmt::format("{} is {}, more than the rest of the file can hold", what, n));
  return n;
}

void MshScanner::end_record()
{
  if (binary_) return;
  skip_blanks();
  last_ = at_;
  if (at_ < text_.size() && text_[at_] != '\n')
    fail(fmt::format("the end of the line is expected, got `{}`", printable(rest_of_line())));
  if (at_ < text_.size()) ++at_;
}

}  // namespace terp
