#include "batch/case_refusal.hpp"

namespace terp {
namespace {

std::string indented_message(const std::string& message)
{
  std::string out;
  std::size_t begin = 0;
  while (begin < message.size()) {
    const std::size_t end = std::min(message.find('\n', begin), message.size());
    const std::string line = message.substr(begin, end - begin);
    if (line.find("nothing was run") == std::string::npos && !line.empty()) out += line + '\n';
    begin = end + 1;
  }
  if (!out.empty()) out.pop_back();
  return out;
}

}  // namespace

std::string refusal_of(const Study& study, const std::vector<std::string>& changes)
{
  try {
    read_case_text(study.case_text, study.case_path, changes);
    return "";
  } catch (const CaseError& error) {
    return indented_message(error.what());
  }
}

std::vector<std::string> changes_with(const Study& study, const std::vector<std::string>& changes)
{
  std::vector<std::string> all = study.settings.set;
  all.insert(all.end(), changes.begin(), changes.end());
  return all;
}

}  // namespace terp
