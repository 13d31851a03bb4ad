// The oldest form that all programs read, release 12: polylines with their vertices.

#include "import/drawing/dxf_file.hpp"

#include <fmt/format.h>

#include <cctype>
#include <set>

namespace terp {
namespace {

/// Release 12 knows letters, digits, $, - and _ in names of layers.
std::string layer_name(const std::string& name)
{
  std::string text;
  for (const char c : name)
    text += std::isalnum(static_cast<unsigned char>(c)) || c == '$' || c == '-' || c == '_' ? c : '_';
  return text.empty() ? "0" : text.substr(0, 31);
}

}  // namespace

std::string dxf_text(const std::vector<DxfLine>& lines)
{
  std::string text = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n9\n$INSUNITS\n70\n6\n0\nENDSEC\n";
  std::set<std::string> layers;
  for (const DxfLine& line : lines) layers.insert(layer_name(line.layer));
  text += fmt::format("0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n70\n{}\n", layers.size());
  int colour = 0;
  for (const std::string& layer : layers)
    text += fmt::format("0\nLAYER\n2\n{}\n70\n0\n62\n{}\n6\nCONTINUOUS\n", layer, 1 + colour++ % 7);
  text += "0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  for (const DxfLine& line : lines) {
    const std::string layer = layer_name(line.layer);
    text += fmt::format("0\nPOLYLINE\n8\n{}\n66\n1\n10\n0.0\n20\n0.0\n30\n0.0\n70\n{}\n", layer, line.closed ? 1 : 0);
    for (const Vec<2>& x : line.places)
      text += fmt::format("0\nVERTEX\n8\n{}\n10\n{:.6f}\n20\n{:.6f}\n30\n0.0\n", layer, x[0], x[1]);
    text += fmt::format("0\nSEQEND\n8\n{}\n", layer);
  }
  return text + "0\nENDSEC\n0\nEOF\n";
}

}  // namespace terp
