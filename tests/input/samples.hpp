// Small case files for the tests of this room.
#pragma once

#include "input/case_file.hpp"

#include <cctype>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace terp::test {

/// A complete case with nothing but required keys, 16 lines.
inline const std::string small_case = R"([time]
end = 4.0
[mesh]
size = [16.0, 3.0]
cell = 0.5
[[body]]
material = "clay"
box = [[0.0, 0.0], [8.0, 2.0]]
[material.clay]
model = "tresca_softening"
density = 1990.0
shear_modulus = 2.0e6
poisson_ratio = 0.48
su_peak = 8.0e3
su_residual = 2.0e3
eta = 50.0
)";

/// `text` with the first `from` replaced; an unchanged text would be a mistake of the test and throws.
inline std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);  // find fails: std::out_of_range
}

/// small_case on another mesh: `keys` stand in [mesh] from line 4 on.
inline std::string small_case_on(const std::string& keys)
{
  return replaced(small_case, "size = [16.0, 3.0]\ncell = 0.5\n", keys + '\n');
}

/// One change of small_case and a part of what the user then reads.
struct Change {
  const char* line;
  const char* instead;
  const char* message;
};

/// The letters of the message, as the name of the test.
inline void PrintTo(const Change& change, std::ostream* out)
{
  const std::string_view message = change.message;
  for (const char c : message.substr(0, 60)) *out << (std::isalnum(static_cast<unsigned char>(c)) ? c : '_');
}

/// What the user sees for this text; "accepted" if it is read, followed by its warnings.
inline std::string message_for(const std::string& text, const std::vector<std::string>& overrides = {})
{
  try {
    return "accepted\n" + render_warnings(read_case_text(text, "case.toml", overrides));
  } catch (const CaseError& error) {
    return error.what();
  }
}

}  // namespace terp::test
