// Ground profiles: any bytes give a section whose regions are clean, or an InputError. What follows a zero byte is a
// table of soils; before `=` at the begin stands the name of a profile.
#include "import/drawing/ground_profile.hpp"
#include "math/errors.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  std::string_view text(reinterpret_cast<const char*>(data), size), soils;
  if (const auto end = text.find('\0'); end != std::string_view::npos)
    soils = text.substr(end + 1), text = text.substr(0, end);
  terp::ProfileOptions options;
  if (const auto end = text.substr(0, 20).find('='); end != std::string_view::npos)
    options.name = text.substr(0, end), text.remove_prefix(end + 1);
  try {
    terp::DxfRegions found = terp::read_profile("p.csv", text, options);
    if (!soils.empty()) found = terp::with_soils(found, "soils.csv", soils, options.name);
    if (text.size() < 2000) terp::clean_regions(found.regions, {}, {});
  } catch (const terp::InputError&) {
  }
  return 0;
}
