// A sentence for a reader of a report, in the languages of the report page. Numbers in Dutch have a decimal comma.
// Not for: what is said of a file and its section (reported_texts.hpp).
#pragma once

#include "math/types.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

namespace terp {

struct Sentence {
  std::string en, nl;

  bool empty() const { return en.empty(); }
};

/// A sentence with places to fill in, {} as of fmt, the same ones in both languages.
struct SentenceForm {
  const char *en, *nl;
};

struct DutchNumber {
  Real value;
};

/// A number as Dutch text has it; all else as it is.
template <class T>
auto in_dutch(const T& value)
{
  if constexpr (std::is_floating_point_v<T>)
    return DutchNumber{value};
  else if constexpr (std::is_same_v<T, Sentence>)
    return value.nl;
  else
    return value;
}

template <class T>
const auto& in_english(const T& value)
{
  if constexpr (std::is_same_v<T, Sentence>)
    return value.en;
  else
    return value;
}

/// The form with its places filled in: numbers, texts, or sentences, of which each language takes its own. The compiler
/// compares the places with what fills them.
template <const SentenceForm& form, class... Args>
Sentence filled(const Args&... args)
{
  const auto text = []<class... T>(
                        fmt::format_string<const T&...> in, const T&... values) { return fmt::format(in, values...); };
  return {text.template operator()<std::decay_t<decltype(in_english(args))>...>(form.en, in_english(args)...),
      text.template operator()<std::decay_t<decltype(in_dutch(args))>...>(form.nl, in_dutch(args)...)};
}

inline std::vector<std::string> in_english(const std::vector<Sentence>& sentences)
{
  std::vector<std::string> texts;
  for (const Sentence& sentence : sentences) texts.push_back(sentence.en);
  return texts;
}

}  // namespace terp

template <>
struct fmt::formatter<terp::DutchNumber> : fmt::formatter<terp::Real> {
  template <class Context>
  auto format(const terp::DutchNumber& number, Context& context) const
  {
    fmt::memory_buffer text;
    fmt::format_context into(fmt::appender(text), {}, {});
    fmt::formatter<terp::Real>::format(number.value, into);
    return std::ranges::replace_copy(text, context.out(), '.', ',').out;
  }
};
