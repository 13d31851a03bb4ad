// Drawings: any bytes give lines whose regions are clean, or an InputError.
#include "math/errors.hpp"
#include "import/drawing/dxf_regions.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  try {
    const auto drawing = terp::read_dxf_text("d.dxf", {reinterpret_cast<const char*>(data), size});
    if (drawing.lines.size() + drawing.hatches.size() > 200) return 0;
    const auto found = terp::regions_of(drawing, 0.01);
    terp::clean_regions(found.regions, {}, {.snap = found.snap});
  } catch (const terp::InputError&) {
  }
  return 0;
}
