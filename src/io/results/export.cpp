// Fields are checked first, as that is cheap. Then damaged frames are left out, and only then numbers of frames are
// looked up. So these count only frames that can be read. The list of frames, frames.csv, is written after all the
// files that it names.

#include "io/results/export.hpp"

#include "math/number_from.hpp"
#include "io/case/case_file.hpp"
#include "io/files/files.hpp"
#include "io/files/run_folder.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include <fmt/format.h>

namespace terp {
namespace {

std::size_t parse_frame(std::string_view word, const std::string& text, std::size_t n_frames)
{
  if (word == "last" && n_frames > 0) return n_frames - 1;
  if (const auto k = number_from<std::size_t>(word); k && *k < n_frames) return *k;
  throw CaseError(
      fmt::format("error: there is no frame `{}` in `{}`: the run has frames 0 to {}\n  Write numbers, ranges and "
                  "`last`, as in --frames 0,5,10:20,last\n",
          word, text, static_cast<long>(n_frames) - 1));
}

std::vector<std::string> component_suffixes(int n_components)
{
  if (n_components == 1) return {""};
  if (n_components == 3) return {"_x", "_y", "_z"};
  if (n_components == 4) return {"_xx", "_yy", "_zz", "_xy"};
  std::vector<std::string> suffixes;
  for (int c = 0; c < n_components; ++c) suffixes.push_back(fmt::format("_{}", c));
  return suffixes;
}

/// Values as shown: those of single precision by the shortest number that reads back to them.
std::string csv_text(const Frames& frames, const std::vector<std::string>& names, std::size_t k)
{
  const std::vector<Real> x = frames.places(k);
  std::string text = "id,x,y";
  std::vector<std::vector<Real>> fields;
  for (const auto& name : names) {
    for (const auto& suffix : component_suffixes(frames.field(name).n_components)) text += "," + name + suffix;
    fields.push_back(frames.read(name, k));
  }
  for (std::size_t p = 0; p < x.size() / 2; ++p) {
    if (!is_soil(x, p)) continue;
    fmt::format_to(std::back_inserter(text), "\n{},{},{}", p, x[2 * p], x[2 * p + 1]);
    for (const auto& values : fields) {
      const std::size_t n = values.size() / (x.size() / 2);
      for (std::size_t c = 0; c < n; ++c)
        fmt::format_to(std::back_inserter(text), ",{}", static_cast<float>(values[n * p + c]));
    }
  }
  return text + '\n';
}

}  // namespace

std::vector<std::size_t> parse_frames(const std::string& text, std::size_t n_frames)
{
  std::set<std::size_t> chosen;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view word = std::string_view(text).substr(begin, end - begin);
    const std::size_t colon = word.find(':');
    const std::size_t first = parse_frame(word.substr(0, colon), text, n_frames);
    const std::size_t last =
        colon == std::string_view::npos ? first : parse_frame(word.substr(colon + 1), text, n_frames);
    if (first > last)
      throw CaseError(fmt::format(
          "error: the frames `{}` in `{}` run backwards\n  Write the smaller number first, as in 10:20\n", word, text));
    for (std::size_t k = first; k <= last; ++k) chosen.insert(k);
    begin = end + 1;
  }
  return {chosen.begin(), chosen.end()};
}

std::vector<std::string> export_frames(Frames& frames, const ExportOptions& options)
{
  std::vector<std::string> fields = options.fields;
  for (const auto& name : fields) frames.field(name);  // throws
  if (fields.empty())
    for (const auto& field : frames.fields()) fields.push_back(field.name);
  frames.leave_out_damaged();
  const auto chosen = parse_frames(options.frames.empty() ? "0:last" : options.frames, frames.times().size());
  make_folder(options.folder);
  std::vector<std::string> paths;
  std::string index = "file,time,step\n";
  for (const std::size_t k : chosen) {
    const std::string name = fmt::format("frame_{:05}.csv", k);
    paths.push_back(path_in(options.folder, name));
    write_file_atomically(paths.back(), csv_text(frames, fields, k));
    index += fmt::format("{},{},{}\n", name, frames.times()[k], frames.steps()[k]);
  }
  paths.push_back(path_in(options.folder, "frames.csv"));
  write_file_atomically(paths.back(), index);
  return paths;
}

}  // namespace terp
