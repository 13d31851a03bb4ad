#include "results/vtu.hpp"

#include "output/compress.hpp"
#include "output/vtkhdf_steps.hpp"

#include <numeric>

#include <fmt/format.h>

namespace terp {
namespace {

/// Values as VTK's inline binary data: number of bytes, then the bytes, in base64.
template <class T>
std::string data_array(
    const char* type, const std::string& name, const std::string& attributes, const std::vector<T>& values)
{
  const std::uint64_t n_bytes = values.size() * sizeof(T);
  const std::string bytes = std::string(reinterpret_cast<const char*>(&n_bytes), sizeof(n_bytes)) +
                            std::string(bytes_of(std::span<const T>(values)));
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\"{} format=\"binary\">{}</DataArray>\n", type, name, attributes, base64(bytes));
}

/// NumberOfComponents and their names.
std::string components(int n)
{
  if (n == 1) return "";
  std::string text = fmt::format(" NumberOfComponents=\"{}\"", n);
  const auto suffixes = component_suffixes(n);
  for (std::size_t c = 0; c < suffixes.size(); ++c)
    text += fmt::format(" ComponentName{}=\"{}\"", c, suffixes[c].substr(1));
  return text;
}

}  // namespace

std::vector<std::string> component_suffixes(int n_components)
{
  switch (n_components) {
    case 1: return {""};
    case 2: return {"_x", "_y"};
    case 3: return {"_x", "_y", "_z"};
    case 4: return {"_xx", "_yy", "_zz", "_xy"};
    default: return {"_xx", "_yy", "_zz", "_xy", "_yz", "_zx"};
  }
}

std::string vtu_text(const ExportFrame& frame)
{
  const auto n = static_cast<std::size_t>(frame.n_points());
  std::vector<std::int64_t> id(n), offsets(n);
  std::iota(id.begin(), id.end(), 0);
  std::iota(offsets.begin(), offsets.end(), 1);
  const std::vector<std::uint8_t> types(n, 1);  // VTK_VERTEX
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<UnstructuredGrid>\n";
  text += "<FieldData>\n" + data_array("Float64", "TimeValue", " NumberOfTuples=\"1\"", std::vector<Real>{frame.time}) +
          "</FieldData>\n";
  text += fmt::format("<Piece NumberOfPoints=\"{0}\" NumberOfCells=\"{0}\">\n<PointData>\n", n) +
          data_array("Int64", "id", "", id);
  for (const auto& [field, values] : frame.fields)
    text += data_array("Float64", field.name, components(field.n_components), values);
  text += "</PointData>\n<Points>\n" +
          data_array("Float64", "Points", " NumberOfComponents=\"3\"", vtkhdf::with_z(frame.x)) +
          "</Points>\n<Cells>\n";
  text += data_array("Int64", "connectivity", "", id) + data_array("Int64", "offsets", "", offsets) +
          data_array("UInt8", "types", "", types);
  return text + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

std::string pvd_text(const std::vector<std::pair<Real, std::string>>& files)
{
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
      "byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const auto& [time, file] : files)
    text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time, file);
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace terp
