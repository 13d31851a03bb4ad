// The tree with the changes of --set gives the values; libraries need the values, the checks need libraries, and
// stages, which are read last, need a case without problems. The polygon of the mesh is turned after that, since
// messages count its edges as the user does.

#include "io/case/case_file.hpp"

#include "io/case/check_case.hpp"
#include "io/case/other_files.hpp"
#include "io/case/overrides.hpp"
#include "io/case/printable.hpp"
#include "io/case/reader.hpp"
#include "io/case/render.hpp"
#include "io/case/syntax_advice.hpp"
#include "os/read_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace terp {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_file(const std::string& path, const std::string& what, const std::string& detail)
{
  const std::string lines = detail.empty() ? "" : "  " + detail + "\n";
  throw CaseError(printable(fmt::format("error: {}: {}\n{}\n1 error; nothing was run.\n", path, what, lines)));
}

std::string read_text(const std::string& path)
{
  const std::string fault = fault_of_file(path);
  if (fault.empty()) return read_file(path);
  std::error_code ignored;
  if (fs::exists(fs::path(path) / "ledger.csv", ignored))
    refuse_file(path, fault,
        fmt::format("It holds a run. To go on with it: terp resume {0}. To solve its case anew: {0}/case.toml", path));
  if (fs::is_regular_file(path, ignored)) refuse_file(path, fault, "");
  if (fs::exists(path, ignored)) refuse_file(path, fault, "Give a .toml file.");
  const std::string similar = similar_file(path, ".toml");
  refuse_file(path, fault, similar.empty() ? "" : fmt::format("Did you mean `{}`?", similar));
}

Document parse_document(const std::string& text, const std::string& path)
{
  if (is_utf16(text))
    refuse_file(path, "this is text in UTF-16", "Save it as UTF-8: in the editor, \"Save as\", encoding UTF-8.");
  if (text.find('\0') != std::string::npos)
    refuse_file(path, "this is not a text file", "A case file is text in the TOML format: https://toml.io");
  try {
    return {path, text, parse_toml(text)};
  } catch (const SyntaxError& error) {
    const SyntaxAdvice advice = advise_on_syntax(text, error);
    const std::string what = advice.what.empty() ? "this is not valid TOML" : "this is not valid TOML: " + advice.what;
    throw CaseError(render_at(path, text, advice.place, {"", what, advice.cure + "\nThe format: https://toml.io", ""}) +
                    "\n1 error; nothing was run.\n");
  }
}

/// The text that stands for the whole case in a run folder: the user's own, or written anew if anything was changed by
/// --set or if a file has another name there.
std::string text_for_the_record(const Document& document, std::vector<InputFile>& inputs, const std::string& folder,
    const std::vector<std::string>& overrides)
{
  Node root = document.root;
  const bool renamed = name_copies(root, folder, inputs);
  if (!renamed && overrides.empty()) return document.text;
  std::string head = fmt::format(
      "# {}, {}\n", document.path, overrides.empty() ? "with copies of the files that it names" : "changed by");
  for (std::string change : overrides) {
    std::ranges::replace_if(
        change, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    head += "#   --set " + change + '\n';
  }
  if (renamed && !overrides.empty()) head += "# and with copies of the files that it names\n";
  return head + '\n' + write_toml(root);
}

/// The name of a case: that of its file; of a file that is just called case.toml that of its folder.
std::string name_of_case(const std::string& case_path)
{
  const std::string name = fs::path(case_path).stem().string();
  if (name != "case") return name;
  const std::string folder = fs::absolute(case_path).lexically_normal().parent_path().filename().string();
  return folder.empty() ? name : folder;
}

/// A warning of what nothing uses: beside an error it mostly follows from it.
bool is_of_no_use(const Problem& warning)
{
  return warning.what.find("has no effect") != std::string::npos || warning.what.starts_with("no body uses") ||
         warning.what.starts_with("no reference line uses");
}

}  // namespace

std::string default_run_folder(const std::string& case_path)
{
  const std::string name = name_of_case(case_path);
  if (name == "." || name == "..")
    refuse_file(case_path, fmt::format("its run would be named `{0}`, and runs/{0} is no folder of its own", name),
        fmt::format("Rename the case file, or say where the results go: terp run {} -o DIR", case_path));
  return "runs/" + name;
}

CaseFile read_case_text(const std::string& text, const std::string& path, const std::vector<std::string>& overrides)
{
  CaseFile file;
  file.path = path;
  file.source = parse_document(text, path);
  Findings findings;
  for (const std::string& change : overrides)
    if (auto problem = apply_override(file.source.root, change)) findings.problems.push_back(*problem);
  if (findings.problems.empty()) doubt_replaced(file.source.root, overrides, findings.warnings);
  file.values.name = name_of_case(path);
  file.values.folder = fs::path(path).has_parent_path() ? fs::path(path).parent_path().string() : ".";
  read_values(file.source.root, file.values, findings);
  check_case(file.source.root, file.values, findings);
  file.notes = findings.notes;
  if (findings.problems.empty()) read_stages(file.source, file.values, findings.warnings);
  if (!findings.problems.empty()) std::erase_if(findings.warnings, is_of_no_use);
  file.warnings = findings.warnings;  // shown with errors too: a wrong unit is often what an error comes from
  if (!findings.problems.empty()) throw CaseError(render_warnings(file) + render(findings.problems, file));
  turn_counter_clockwise(file.values.mesh);  // not before: messages speak of the edges as the user counts them
  file.text = text_for_the_record(file.source, file.inputs, file.values.folder, overrides);
  return file;
}

CaseFile read_case(const std::string& path, const std::vector<std::string>& overrides)
{
  return read_case_text(read_text(path), path, overrides);
}

std::string render(const std::vector<Problem>& problems, const CaseFile& file)
{
  return render_errors(problems, file.source);
}

std::string render_warnings(const std::vector<Problem>& warnings, const CaseFile& file)
{
  return render_warnings(warnings, file.source, file.run);
}

std::string render_warnings(const CaseFile& file) { return render_warnings(file.warnings, file.source, file.run); }

}  // namespace terp
