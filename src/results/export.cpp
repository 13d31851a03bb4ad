#include "results/export.hpp"

#include "input/case_file.hpp"
#include "output/files.hpp"
#include "output/run_folder.hpp"
#include "results/npz.hpp"
#include "results/vtu.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <numeric>
#include <set>

#include <fmt/format.h>

namespace terp {
namespace {

std::size_t parse_frame(std::string_view word, const std::string& text, std::size_t n_frames)
{
  if (word == "last" && n_frames > 0) return n_frames - 1;
  std::size_t k = 0;
  const auto end = std::from_chars(word.data(), word.data() + word.size(), k);
  if (!word.empty() && end.ec == std::errc() && end.ptr == word.data() + word.size() && k < n_frames) return k;
  throw CaseError(
      fmt::format("error: there is no frame `{}` in `{}`: the run has frames 0 to {}\n  Write numbers, ranges and "
                  "`last`, as in --frames 0,5,10:20,last\n",
          word, text, static_cast<long>(n_frames) - 1));
}

ExportFrame read_frame(const Frames& frames, const std::vector<std::string>& fields, std::size_t k)
{
  ExportFrame frame{.time = frames.times()[k], .step = frames.steps()[k], .x = frames.places(k), .fields = {}};
  for (const auto& name : fields) frame.fields.emplace_back(frames.field(name), frames.read(name, k));
  return frame;
}

std::string csv_text(const ExportFrame& frame)
{
  std::string text = "id,x,y";
  for (const auto& [field, values] : frame.fields)
    for (const auto& suffix : component_suffixes(field.n_components)) text += "," + field.name + suffix;
  for (std::size_t p = 0; p < static_cast<std::size_t>(frame.n_points()); ++p) {
    fmt::format_to(std::back_inserter(text), "\n{},{},{}", p, frame.x[2 * p], frame.x[2 * p + 1]);
    for (const auto& [field, values] : frame.fields) {
      const auto n = static_cast<std::size_t>(field.n_components);
      for (std::size_t c = 0; c < n; ++c) fmt::format_to(std::back_inserter(text), ",{}", values[n * p + c]);
    }
  }
  return text + '\n';
}

std::string npz_bytes(const ExportFrame& frame)
{
  NpzFile file;
  const std::int64_t n = frame.n_points();
  std::vector<std::int64_t> id(static_cast<std::size_t>(n));
  std::iota(id.begin(), id.end(), 0);
  file.add("time", {}, std::span(&frame.time, 1));
  file.add("step", {}, std::span(&frame.step, 1));
  file.add("id", {n}, id);
  file.add("x", {n, 2}, frame.x);
  for (const auto& [field, values] : frame.fields)
    file.add(field.name,
        field.n_components == 1 ? std::vector<std::int64_t>{n} : std::vector<std::int64_t>{n, field.n_components},
        values);
  return file.bytes();
}

std::string frame_text(const ExportFrame& frame, ExportFormat format)
{
  if (format == ExportFormat::vtu) return vtu_text(frame);
  return format == ExportFormat::csv ? csv_text(frame) : npz_bytes(frame);
}

std::string_view ending_of(ExportFormat format)
{
  if (format == ExportFormat::vtu) return "vtu";
  return format == ExportFormat::csv ? "csv" : "npz";
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

std::vector<std::string> export_frames(const Frames& frames, const ExportOptions& options)
{
  std::vector<std::string> fields = options.fields;
  for (const auto& name : fields) frames.field(name);  // throws
  if (fields.empty())
    for (const auto& field : frames.fields()) fields.push_back(field.name);
  const std::string spec = options.frames.empty() ? "0:last" : options.frames;
  const auto chosen = parse_frames(spec, frames.times().size());
  make_folder(options.folder);

  std::vector<std::string> paths;
  std::vector<std::pair<Real, std::string>> files;
  std::string index = "file,time,step\n";
  for (const std::size_t k : chosen) {
    const ExportFrame frame = read_frame(frames, fields, k);
    const std::string name = fmt::format("frame_{:05}.{}", k, ending_of(options.format));
    paths.push_back(path_in(options.folder, name));
    write_file_atomically(paths.back(), frame_text(frame, options.format));
    files.emplace_back(frame.time, name);
    index += fmt::format("{},{},{}\n", name, frame.time, frame.step);
  }
  const bool vtu = options.format == ExportFormat::vtu;
  paths.push_back(path_in(options.folder, vtu ? "frames.pvd" : "frames.csv"));
  write_file_atomically(paths.back(), vtu ? pvd_text(files) : index);
  return paths;
}

}  // namespace terp
