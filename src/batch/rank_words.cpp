#include "batch/rank_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>

namespace terp {
namespace {

constexpr std::string_view file_begin = "terp ranks 1", hello_begin = "hello 1";

}  // namespace

std::string text_of(const RankPlace& place)
{
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n", file_begin, place.job, place.machine, place.token, place.port,
      fmt::join(place.addresses, "\n"));
}

std::optional<RankPlace> rank_place_of(std::string_view text)
{
  std::vector<std::string> lines = split(text, '\n');
  if (lines.size() < 7 || lines[0] != file_begin) return std::nullopt;
  RankPlace place{.job = lines[1], .machine = lines[2], .token = lines[3]};
  const std::string& port = lines[4];
  if (std::from_chars(port.data(), port.data() + port.size(), place.port).ec != std::errc()) return std::nullopt;
  place.addresses.assign(lines.begin() + 5, lines.end() - 1);
  return place;
}

std::string line_of(const RankHello& hello)
{
  return fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}", hello_begin, hello.token, hello.name, hello.head.version,
      hello.head.case_digits, hello.head.study_digits, hello.head.build, hello.head.instructions);
}

std::optional<RankHello> rank_hello_of(std::string_view line)
{
  const std::vector<std::string> words = split(line, '\t');
  if (words.size() != 8 || words[0] != hello_begin) return std::nullopt;
  return RankHello{.token = words[1],
      .name = words[2],
      .head = {.version = words[3],
          .case_digits = words[4],
          .study_digits = words[5],
          .build = words[6],
          .instructions = words[7]}};
}

}  // namespace terp
