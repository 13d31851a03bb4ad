// Case files: any bytes give a Case, or a CaseError that says why. What follows a zero byte is a change by --set.
#include "io/case/case_file.hpp"

#include <string>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  std::string text(reinterpret_cast<const char*>(data), size);
  std::vector<std::string> changes;
  if (const auto end = text.rfind('\0'); end != std::string::npos && end + 1 < size) {
    changes.push_back(text.substr(end + 1));
    text.resize(end);
  }
  try {
    const terp::CaseFile file = terp::read_case_text(text, "case.toml", changes);
    terp::render_warnings(file);
  } catch (const terp::CaseError&) {
  }
  return 0;
}
