// Drawings: any bytes give lines whose regions are clean, or an InputError.
#include "math/errors.hpp"
#include "import/drawing/dxf_regions.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  try {
    const auto drawing = terp::read_dxf_text("d.dxf", {reinterpret_cast<const char*>(data), size});
    if (drawing.lines.size() < 200) terp::clean_regions(terp::regions_of(drawing, 0.01).regions, {}, {});
  } catch (const terp::InputError&) {
  }
  return 0;
}
