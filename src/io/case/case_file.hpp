// Reads a case file, with the changes of the command line, into a Case; or says exactly what is wrong.
// Not for: anything that needs the mesh or the points (model/parts/setup).
#pragma once

#include "math/errors.hpp"
#include "io/case/document.hpp"
#include "model/case/case.hpp"
#include "model/case/input_file.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace terp {

struct CaseFile {
  Case values;
  std::string path;  ///< as the user wrote it
  std::string text;  ///< TOML of the case as it runs, with every --set, and the files that it names beside it
  std::vector<InputFile> inputs;   ///< those files, and what they are called there
  std::vector<Problem> warnings;   ///< doubtful, but it may run
  std::vector<std::string> notes;  ///< numbers with a unit: "material.clay.su_peak: "8 kPa", 8000 Pa"
  Document source;                 ///< what the user wrote, and where
  std::string run;                 ///< folder of the run, which warnings name; empty: none
};

/// The case cannot be read. what() is the full message for the user; exit status 2.
class CaseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Where the run of a case file goes unless told otherwise: runs/NAME of NAME.toml, and of NAME/case.toml. Throws
/// CaseError where NAME is `.` or `..`, as of the file `...toml`: its run would be written beside or above runs/.
std::string default_run_folder(const std::string& case_path);

/// Reads a file. overrides: "KEY=VALUE" each, applied in order. Throws CaseError.
CaseFile read_case(const std::string& path, const std::vector<std::string>& overrides = {});

/// The same for a text that is already in memory; `path` is what messages call it.
CaseFile read_case_text(
    const std::string& text, const std::string& path, const std::vector<std::string>& overrides = {});

/// Problems found later (InputError), shown at the keys of this file.
std::string render(const std::vector<Problem>& problems, const CaseFile& file);

/// Warnings found later, shown at the keys of this file.
std::string render_warnings(const std::vector<Problem>& warnings, const CaseFile& file);

/// The file's own warnings as the user sees them; empty if there are none.
std::string render_warnings(const CaseFile& file);

}  // namespace terp
