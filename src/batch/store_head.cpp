// Two questions are kept apart. Whether results are of the same study follows from the digits of study and case, and
// from the version. Whether their bits are the same follows from the build and the instruction set. The format is
// compared before the words are counted, as another format may have another number of them.

#include "batch/store_head.hpp"

#include "math/errors.hpp"
#include "os/instructions.hpp"
#include "model/case/method_form.hpp"
#include "os/build_id.hpp"

#include <fmt/format.h>

#include <vector>

namespace terp {
namespace {

constexpr std::string_view begin = "terp study\t";
// 7: [method] had other defaults; 6: cases had keys that are gone; 5: no processor time; 4: no build, `still_moves` of
// floods alone
constexpr std::string_view store_format = "9";
constexpr std::size_t n_words = 7;

bool has_fused_products(const std::string& instructions) { return instructions.starts_with("avx"); }

}  // namespace

std::vector<std::string> split(std::string_view text, char at)
{
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t end = text.find(at);
    parts.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

StoreHead head_of(const Study& study)
{
  return {.version = TERP_VERSION,
      .case_digits = study.case_digits,
      .study_digits = study.study_digits,
      .build = build_id(),
      .instructions = std::string(instructions())};
}

std::string line_of(const StoreHead& head)
{
  return fmt::format("{}{}\t{}\t{}\t{}\t{}\t{}", begin, store_format, head.version, head.case_digits, head.study_digits,
      head.build, head.instructions);
}

bool is_head(std::string_view line) { return line.starts_with(begin); }

StoreHead read_head(std::string_view line, const std::string& path)
{
  const std::vector<std::string> words = split(line, '\t');
  if (!is_head(line) || (words[1] == store_format && words.size() != n_words))
    throw FileError(fmt::format("{}: this is no store of a study\n  Choose another folder: -o DIR", path));
  const bool is_older = words[1].size() == store_format.size() && words[1] < store_format;
  if (words[1] != store_format)
    throw FileError(
        fmt::format("{}: this store has format {}, and this terp reads format {}\n  Solve it anew: terp study run "
                    "STUDY.toml --force, or give it another folder, -o DIR.{}",
            path, words[1], store_format, is_older ? fmt::format("\n  {}", defaults_before) : ""));
  return {.version = words[2],
      .case_digits = words[3],
      .study_digits = words[4],
      .build = words[5],
      .instructions = words[6]};
}

std::string why_of_another_study(const StoreHead& head, const StoreHead& own)
{
  if (head.study_digits != own.study_digits) return "what is drawn, its seed or the events are others";
  if (head.case_digits != own.case_digits) return "the case is another one, or its mesh";
  if (head.version != own.version)
    return fmt::format("it was solved by terp {}, this is {}", head.version, own.version);
  return "";
}

SameBits same_bits(const StoreHead& a, const StoreHead& b)
{
  const auto is_known = [](const std::string& set) { return set == "sse2" || has_fused_products(set); };
  const bool both_known = is_known(a.instructions) && is_known(b.instructions);
  if (both_known && has_fused_products(a.instructions) != has_fused_products(b.instructions)) return SameBits::no;
  if (a.build != b.build || a.build == "unknown") return SameBits::unknown;
  return both_known || a.instructions == b.instructions ? SameBits::yes : SameBits::unknown;
}

}  // namespace terp
