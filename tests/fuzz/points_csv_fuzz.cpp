// Tables of points: any bytes give points, or a CsvError.
#include "model/bodies/points_csv.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  try {
    terp::read_points_csv_text("p.csv", {reinterpret_cast<const char*>(data), size});
  } catch (const terp::CsvError&) {
  }
  return 0;
}
