// The content decides, as files are renamed; the ending where the content has no mark of its own. Members of a zip file
// have their names in it as they are.

#include "import/dstability/foreign_file.hpp"

#include "math/errors.hpp"
#include "math/utf8.hpp"
#include "os/read_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace terp {
namespace {

const char* const draw_it =
    "Terp reads D-Stability files (.stix), drawings (ASCII .dxf) and ground profiles (.csv). Export the section as "
    "DXF.";
const char* const save_as_dxf = "Save the drawing as ASCII DXF.";

const char* const table_of_sounding =
    "A table of S_u of a cone penetration test: python3 -m terp.soundings FILE -o su.csv (docs/strength.md). Draw the "
    "section as DXF.";

struct ForeignKind {
  const char* mark;     ///< at the start of the content, or anywhere in a zip file; "": none
  const char* endings;  ///< with a space after each; "": none
  const char* what;
  const char* cure;
};

const ForeignKind foreign_kinds[] = {
    {"AC10", ".dwg ", "is a DWG file", save_as_dxf},
    {"AutoCAD Binary DXF", "", "is a binary DXF file", save_as_dxf},
    {"", ".dgn ", "is a drawing of MicroStation", save_as_dxf},
    {"xl/", ".xlsx .xlsm ", "is a workbook of Excel", "Save a ground profile as .csv, or draw the section as DXF."},
    {"opendocument.spreadsheet", ".ods ", "is a spreadsheet",
        "Save a ground profile as .csv, or draw the section as DXF."},
    {"\xD0\xCF\x11\xE0", ".xls ", "is a file of an old Office program",
        "Save a ground profile as .csv, or draw the section as DXF."},
    {"word/", ".docx ", "is a text of Word", draw_it},
    {"", ".gsz .gsx ", "is a file of GeoStudio (SLOPE/W)", "Export its regions there as DXF: terp import section.dxf."},
    {"", ".slmd .slim .sli .s2z ", "is a file of Slide",
        "Export its boundaries there as DXF: terp import section.dxf."},
    {"", ".gst .gp5 ", "is a file of GEO5", "Export its interfaces there as DXF: terp import section.dxf."},
    {"", ".p2dx .p2d .plx .plxmat ", "is a file of PLAXIS",
        "Export its section there as DXF: terp import section.dxf."},
    {"Input file for a slope program", ".sti ", "is a file of the old D-Geo Stability",
        "Open it in D-Stability and save it there: terp import section.stix."},
    {"#GEFID", ".gef ", "is a GEF file, a sounding or boring", table_of_sounding},
    {"$$START", ".gom ", "is a mesh of another program (GOM)",
        "Terp reads the meshes that gmsh reads (mesh.file of a case), and draws none of this one. Export the section "
        "as "
        "DXF."},
    {"SQLite format 3", ".gpkg ", "is a data base (GeoPackage)", draw_it},
    {"", ".geojson .json .topojson ", "is a JSON file (GeoJSON), a map", draw_it},
    {"", ".shp .shx .dbf .kml .gml .landxml ", "is a map", draw_it},
    {"%PDF", ".pdf ", "is a PDF file", draw_it},
    {"\x89PNG", ".png ", "is a picture", draw_it},
    {"\xFF\xD8\xFF", ".jpg .jpeg ", "is a picture", draw_it},
    {"$MeshFormat", ".msh .unv .bdf .nas ", "is a mesh",
        "Name it in a case: [mesh] file = \"...\" (docs/methods.md), then terp check case.toml."},
    {"", ".inp ", "is a file of Abaqus",
        "Save its mesh as .msh or .unv, and name that in a case: [mesh] file = \"...\"."},
    {"", ".toml ", "is a case of Terp", "It needs no import: terp check case.toml."},
};

std::string lower_ending(const std::string& path)
{
  std::string end = std::filesystem::path(path).extension().string();
  std::ranges::transform(end, end.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return end;
}

[[noreturn]] void refuse(const std::string& path, const char* what, const char* cure)
{
  throw InputError({path, what, cure, ""});
}

std::string_view next_line(std::string_view& text)
{
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return trimmed(line);
}

/// Pairs of a group code and a value; comments (999) may stand first.
bool is_drawing(std::string_view text)
{
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  for (int pair = 0; pair < 100 && !text.empty(); ++pair) {
    const std::string_view code = next_line(text), value = next_line(text);
    if (code != "999") return code == "0" && value == "SECTION";
  }
  return false;
}

/// A table has two numbers in one of its first lines.
bool is_profile(std::string_view text)
{
  for (int k = 0; k < 20 && !text.empty(); ++k) {
    std::string_view line = next_line(text);
    int n_numbers = 0;
    while (!line.empty()) {
      const std::size_t end = std::min(line.find_first_of(";,\t "), line.size());
      const std::string_view cell = line.substr(0, end);
      n_numbers += !cell.empty() && cell.find_first_not_of("0123456789.+-eE\"") == std::string_view::npos;
      line.remove_prefix(std::min(end + 1, line.size()));
    }
    if (n_numbers >= 2) return true;
  }
  return false;
}

}  // namespace

SectionFile kind_of_section(const std::string& path)
{
  std::error_code none;
  if (std::filesystem::is_directory(path, none))
    refuse(path, "is a folder", "Give the .stix, .dxf or .csv file in it.");
  return kind_of_section(path, read_file(path));
}

SectionFile kind_of_section(const std::string& path, std::string_view content)
{
  const std::string end = lower_ending(path);
  const bool is_zip = content.starts_with("PK");
  if (is_zip && content.find("soils.json") != std::string_view::npos) return SectionFile::dstability;
  if (is_drawing(content)) return SectionFile::drawing;
  for (const ForeignKind& kind : foreign_kinds) {
    const bool has_mark = *kind.mark != '\0' &&
                          (is_zip ? content.find(kind.mark) != std::string_view::npos : content.starts_with(kind.mark));
    if (has_mark || (end.size() > 1 && std::string_view(kind.endings).find(end + " ") != std::string_view::npos))
      refuse(path, kind.what, kind.cure);
  }
  if (end == ".dxf" && !is_zip) return SectionFile::drawing;
  if (content.empty()) refuse(path, "is empty", "Copy it again from where it comes.");
  if (end == ".stix") return SectionFile::dstability;  // whose reader says what is wrong in it
  if ((end == ".csv" || end == ".txt" || end == ".tsv" || end == ".xyz" || end.empty()) && is_profile(content))
    return SectionFile::profile;
  if (is_zip) refuse(path, "is a zip file, and no section of D-Stability", draw_it);
  if (content.substr(0, 200).find_first_of("{[") == 0) refuse(path, "is a JSON file, a map perhaps", draw_it);
  if (content.starts_with("<") && content.find("CPT_O") != std::string_view::npos)
    refuse(path, "is a sounding of the BRO", table_of_sounding);
  if (content.starts_with("<")) refuse(path, "is an XML file", draw_it);
  refuse(path, "is no section that Terp reads", draw_it);
}

}  // namespace terp
