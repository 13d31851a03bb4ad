// The sizes that the archive claims are held against the limits before memory is asked for. Reading one byte beyond the
// end makes libzip compare the checksum.

#include "import/dstability/zip_members.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include <zip.h>

namespace terp {
namespace {

constexpr std::uint64_t small_member = std::uint64_t{1} << 20U;  // below this, a ratio says nothing
constexpr double bytes_per_mb = 1e6;

std::string in_mb(std::uint64_t bytes) { return fmt::format("{:.1f} MB", static_cast<double>(bytes) / bytes_per_mb); }

std::string words_of(zip_t* archive) { return zip_error_strerror(zip_get_error(archive)); }

struct CloseMember {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

}  // namespace

struct ZipMembers::Archive {
  std::string path, bytes;
  ZipLimits limits;
  zip_t* zip = nullptr;
  std::vector<std::string> names;
  std::vector<zip_uint64_t> numbers;  ///< in the archive, as `names`
  std::uint64_t n_read = 0;           ///< bytes unpacked so far

  ~Archive()
  {
    if (zip != nullptr) zip_discard(zip);
  }
  [[noreturn]] void fail(const std::string& member, const std::string& what, const std::string& detail) const
  {
    throw InputError(
        {.key = member.empty() ? path : path + ", " + member, .what = what, .detail = detail, .topic = ""});
  }
  void open();
  void list();
  zip_stat_t look_at(std::size_t number);
};

void ZipMembers::Archive::open()
{
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (source != nullptr) zip = zip_open_from_source(source, ZIP_RDONLY, &error);
  const std::string why = zip == nullptr ? zip_error_strerror(&error) : "";
  if (zip == nullptr && source != nullptr) zip_source_free(source);
  zip_error_fini(&error);
  if (zip == nullptr)
    fail("", "is no sound zip file, which a .stix file is",
        fmt::format("{} ({} bytes). Save it anew in D-Stability, or copy it again.", why, bytes.size()));
}

void ZipMembers::Archive::list()
{
  const auto n = static_cast<std::uint64_t>(std::max<zip_int64_t>(0, zip_get_num_entries(zip, 0)));
  if (n > limits.members)
    fail("", "has too many members",
        fmt::format("{}, at most {}. D-Stability writes a few hundred.", n, limits.members));
  std::set<std::string> seen;
  for (zip_uint64_t k = 0; k < n; ++k) {
    const char* const raw = zip_get_name(zip, k, ZIP_FL_ENC_GUESS);
    if (raw == nullptr) fail(fmt::format("member {}", k + 1), "has no name", words_of(zip));
    std::string name = raw;
    std::ranges::replace(name, '\\', '/');
    for (std::size_t at = 0; (at = name.find("//", at)) != std::string::npos;) name.erase(at, 1);
    if (name.empty() || name.ends_with('/')) continue;
    if (!seen.insert(name).second)
      fail(name, "is there twice", "Which one holds cannot be known. Save the file anew in D-Stability.");
    names.push_back(name);
    numbers.push_back(k);
  }
}

zip_stat_t ZipMembers::Archive::look_at(std::size_t number)
{
  const std::string& name = names[number];
  zip_stat_t info;
  zip_stat_init(&info);
  if (zip_stat_index(zip, numbers[number], 0, &info) != 0 || (info.valid & ZIP_STAT_SIZE) == 0)
    fail(name, "cannot be looked at", words_of(zip));
  if (info.size > limits.member_bytes)
    fail(name, "is too large", fmt::format("{} unpacked, at most {}.", in_mb(info.size), in_mb(limits.member_bytes)));
  if (n_read + info.size > limits.total_bytes)
    fail(name, "is one too many", fmt::format("The file unpacks to more than {}.", in_mb(limits.total_bytes)));
  if (info.size > small_member && info.size / std::max<std::uint64_t>(info.comp_size, 1) > limits.ratio)
    fail(name, "unpacks to far more than text does",
        fmt::format("{} from {} bytes; at most {} times as much.", in_mb(info.size), info.comp_size, limits.ratio));
  return info;
}

ZipMembers::ZipMembers(std::string path, std::string bytes, ZipLimits limits) : archive_(std::make_unique<Archive>())
{
  archive_->path = std::move(path);
  archive_->bytes = std::move(bytes);
  archive_->limits = limits;
  archive_->open();
  archive_->list();
}

ZipMembers::~ZipMembers() = default;
ZipMembers::ZipMembers(ZipMembers&&) noexcept = default;

const std::vector<std::string>& ZipMembers::names() const { return archive_->names; }

std::string ZipMembers::text(std::size_t number)
{
  Archive& a = *archive_;
  const std::string& name = a.names[number];
  const zip_stat_t info = a.look_at(number);
  const std::unique_ptr<zip_file_t, CloseMember> file(zip_fopen_index(a.zip, a.numbers[number], 0));
  if (!file) a.fail(name, "cannot be unpacked", words_of(a.zip) + ". Save the file anew in D-Stability.");
  std::string text(info.size, '\0');
  std::uint64_t have = 0;
  while (have < info.size) {
    const zip_int64_t n = zip_fread(file.get(), text.data() + have, info.size - have);
    if (n <= 0) break;
    have += static_cast<std::uint64_t>(n);
  }
  char beyond = '\0';  // libzip compares the checksum when it comes to the end
  if (have != info.size || zip_fread(file.get(), &beyond, 1) != 0)
    a.fail(name, "is damaged",
        fmt::format("{} of {} bytes could be unpacked ({}). Copy the file again, or save it anew in D-Stability.", have,
            info.size, zip_error_strerror(zip_file_get_error(file.get()))));
  a.n_read += info.size;
  return text;
}

std::string zip_of(const std::vector<std::pair<std::string, std::string>>& members)
{
  constexpr time_t first_day = 315532800;  // 1980-01-01: a zip file knows none before
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const source = zip_source_buffer_create(nullptr, 0, 0, &error);
  zip_t* const zip = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_TRUNCATE, &error);
  zip_error_fini(&error);
  if (zip == nullptr) throw FileError("no zip file can be made");
  zip_source_keep(source);
  for (const auto& [name, contents] : members) {
    const zip_int64_t number =
        zip_file_add(zip, name.c_str(), zip_source_buffer(zip, contents.data(), contents.size(), 0), ZIP_FL_ENC_UTF_8);
    if (number >= 0) zip_file_set_mtime(zip, static_cast<zip_uint64_t>(number), first_day, 0);
  }
  if (zip_close(zip) != 0) throw FileError("no zip file can be made");
  zip_stat_t info;
  zip_source_stat(source, &info);
  std::string bytes(info.size, '\0');
  zip_source_open(source);
  zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  zip_source_free(source);
  return bytes;
}

}  // namespace terp
