// A head holds for the lines below it, until the next one. A line that does not fit its checksum was cut by a kill, and
// is counted; one that does and cannot be read is an error. A realisation may stand in several files: then all must be
// the same but for the clock.

#include "batch/store.hpp"

#include "math/checksum.hpp"
#include "math/errors.hpp"
#include "math/number_from.hpp"
#include "io/files/run_folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

namespace terp {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t n_digits = 16;  // of a checksum
constexpr const char* ending = ".rows";
constexpr std::string_view screening_letters = "-xas";  // in the order of Screening

std::string with_checksum(const std::string& line) { return digits_of(line) + '\t' + line + '\n'; }

/// The line without its checksum; none if it does not fit.
std::optional<std::string_view> checked(std::string_view line)
{
  if (line.size() <= n_digits + 1 || line[n_digits] != '\t') return std::nullopt;
  const std::string_view text = line.substr(n_digits + 1);
  return digits_of(text) == line.substr(0, n_digits) ? std::optional(text) : std::nullopt;
}

bool to_numbers(std::string_view text, std::size_t n, std::vector<Real>& values)
{
  if (text.empty()) return n == 0;
  for (const std::string& part : split(text, ' ')) {
    const auto value = number_from<Real>(part);
    if (!value) return false;
    values.push_back(*value);
  }
  return values.size() == n;
}

StoreHead check_head(const Study& study, const std::string& path, std::string_view line)
{
  const StoreHead head = read_head(line, path);
  if (const std::string why = why_of_another_study(head, head_of(study)); !why.empty())
    throw FileError(fmt::format(
        "{}: this is the store of another study: {}\n  Give it a folder of its own, -o DIR, or remove what is there.",
        path, why));
  return head;
}

SolvedUnder& solved_under(const StoreHead& head, StoredStudy& stored)
{
  const auto there = std::ranges::find(stored.solvers, head, &SolvedUnder::head);
  return there != stored.solvers.end() ? *there : stored.solvers.emplace_back(SolvedUnder{head});
}

void take(const std::string& path, Realisation row, StoredStudy& stored)
{
  const Index number = row.number;
  const auto there = stored.rows.find(number);
  if (there != stored.rows.end() && !there->second.same_as(row))
    throw FileError(
        fmt::format("{}: realisation {} has two results that differ\n  They were solved by different "
                    "programs or machines. Remove one of the files.",
            path, number));
  stored.rows.try_emplace(number, std::move(row));
}

void read_part(const Study& study, const std::string& path, StoredStudy& stored)
{
  const std::string text = read_file(path);
  const std::size_t n_inputs = study.input_names().size();
  std::optional<StoreHead> head;
  for (const std::string& line : split(text, '\n')) {
    if (line.empty()) continue;
    const auto content = checked(line);
    if (!content) {
      ++stored.n_broken;
      continue;
    }
    if (!head || is_head(*content)) {
      head = check_head(study, path, *content);
      continue;
    }
    auto row = realisation_of(*content, n_inputs);
    if (!row) throw FileError(fmt::format("{}: a line is whole, but no realisation of this study", path));
    SolvedUnder& under = solved_under(*head, stored);
    if (row->solved() && !under.first_solved) under.first_solved = row->number;
    take(path, std::move(*row), stored);
  }
}

}  // namespace

std::string StudyPart::name() const { return fmt::format("part_{}_of_{}", number, n_all); }

std::string StudyPart::file() const { return name() + ending; }

bool is_part_of_store(std::string_view name) { return name.starts_with("part_") && name.ends_with(ending); }

std::string line_of(const Realisation& r)
{
  return fmt::format("{}\t{:.3f} {:.4g}\t{}\t{}{}{}{}\t{}\t{}", r.number, r.wall_s, r.processor_s,
      fmt::join(r.inputs, " "), r.slid ? 'I' : '-', r.flooded ? 'F' : '-', r.judges_flood ? 'w' : '-',
      screening_letters[static_cast<std::size_t>(r.screening)], fmt::join(r.outcomes, " "), r.fault);
}

std::optional<Realisation> realisation_of(std::string_view line, std::size_t n_inputs)
{
  const auto parts = split(line, '\t');
  Realisation r;
  if (parts.size() != 6 || parts[3].size() != 4) return std::nullopt;
  const std::size_t screening = screening_letters.find(parts[3][3]);
  if (screening == std::string_view::npos) return std::nullopt;
  r.fault = parts[5], r.screening = static_cast<Screening>(screening);
  const std::size_t n_outcomes = r.solved() ? study_outcomes().size() : 0;
  std::vector<Real> times;
  const auto number = number_from<Index>(parts[0]);
  if (!number || !to_numbers(parts[1], 2, times) || !to_numbers(parts[2], n_inputs, r.inputs) ||
      !to_numbers(parts[4], n_outcomes, r.outcomes))
    return std::nullopt;
  r.number = *number, r.wall_s = times[0], r.processor_s = times[1];
  r.slid = parts[3][0] == 'I', r.flooded = parts[3][1] == 'F', r.judges_flood = parts[3][2] == 'w';
  return r;
}

StoredStudy read_store(const Study& study, const std::string& folder)
{
  StoredStudy stored;
  std::error_code none;
  if (!fs::is_directory(folder, none)) return stored;
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (is_part_of_store(entry.path().filename().string())) files.push_back(entry.path().string());
  std::ranges::sort(files);
  for (const std::string& file : files) read_part(study, file, stored);
  stored.n_files = static_cast<int>(files.size());
  return stored;
}

StoreWriter::StoreWriter(const Study& study, const std::string& folder, const StudyPart& part)
    : file_(path_in(folder, part.file()))
{
  const std::string text = read_file(path_in(folder, part.file()));
  if (!text.empty() && text.back() != '\n') file_.append("\n");  // a line that a kill has cut
  const std::string own = line_of(head_of(study));
  std::string last;
  for (const std::string& line : split(text, '\n'))
    if (const auto content = checked(line); content && is_head(*content)) last = *content;
  if (last != own) file_.append(with_checksum(own));
}

void StoreWriter::append(const Realisation& realisation) { file_.append(with_checksum(line_of(realisation))); }

}  // namespace terp
