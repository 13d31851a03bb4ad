// A sentence for a reader of a report, in the languages of the report page.
#pragma once

#include <string>
#include <vector>

namespace terp {

struct Sentence {
  std::string en, nl;
};

inline std::vector<std::string> in_english(const std::vector<Sentence>& sentences)
{
  std::vector<std::string> texts;
  for (const Sentence& sentence : sentences) texts.push_back(sentence.en);
  return texts;
}

}  // namespace terp
