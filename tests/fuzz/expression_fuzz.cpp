// The reader of formulas on arbitrary text: it evaluates, or refuses with an ExpressionError.
#include "io/case/expression.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const terp::Expression formula(text, {"x", "y"}, {{"a", 2.5}});
    formula(std::vector<terp::Real>{0.5, -3.0});
  } catch (const terp::ExpressionError&) {
    // refused, as it should be
  }
  return 0;
}
