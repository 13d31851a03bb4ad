// D-Stability files: any bytes give a project that can be evaluated, or an InputError. After `=` they are the members
// as plain text, each below a line `=NAME`, and packed first, so that the fuzzer need not find checksums.
#include "math/errors.hpp"
#include "import/dstability/listing.hpp"
#include "import/dstability/read_stix.hpp"
#include "import/dstability/section.hpp"
#include "import/dstability/slices.hpp"

#include <list>
#include <zip.h>

namespace {

std::string packed(const std::string& members)
{
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const target = zip_source_buffer_create(nullptr, 0, 0, &error);
  zip_source_keep(target);
  zip_t* const zip = zip_open_from_source(target, ZIP_TRUNCATE, &error);
  std::list<std::string> texts;  // must outlive zip_close
  for (std::size_t at = 0; at < members.size();) {
    const std::size_t line = std::min(members.find('\n', at), members.size());
    const std::size_t next = std::min(members.find("\n=", line), members.size());
    texts.push_back(members.substr(line, next - line));
    const std::string name = members.substr(at + 1, line - at - 1);
    zip_source_t* const text = zip_source_buffer(zip, texts.back().data(), texts.back().size(), 0);
    if (zip_file_add(zip, name.c_str(), text, 0) < 0) zip_source_free(text);
    at = next + 1;
  }
  std::string bytes;
  zip_stat_t info;
  if (zip_close(zip) != 0)
    zip_discard(zip);
  else if (zip_source_stat(target, &info) == 0 && zip_source_open(target) == 0) {
    bytes.resize(info.size);
    zip_source_read(target, bytes.data(), bytes.size());
    zip_source_close(target);
  }
  zip_source_free(target);
  return bytes;
}

void evaluate(const terp::StixProject& project)
{
  terp::slices_csv(terp::compare_slices(project));
  for (std::size_t s = 0; s < project.scenarios.size(); ++s) {
    const terp::StixSection section(project, s, project.scenarios[s].stages.size() - 1, terp::StixBasis::design);
    for (const double x : {-1e9, 20.0, 40.0, 50.5, 1e9})
      for (const double z : {-1e9, -8.0, 0.0, 1e9}) section.at({x, z});
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  std::string bytes(reinterpret_cast<const char*>(data), size);
  if (bytes.starts_with('=')) bytes = packed(bytes);
  const terp::ZipLimits limits{.members = 100, .member_bytes = 1 << 20, .total_bytes = 1 << 22, .ratio = 200};
  try {
    const terp::StixProject project = terp::read_stix_bytes(std::move(bytes), "f.stix", limits);
    const terp::StixVerdict verdict = [](std::size_t, std::size_t) { return ""; };
    terp::listing_of(project, verdict);
    terp::listing_json(project, verdict);
    evaluate(project);
  } catch (const terp::InputError&) {
  }
  return 0;
}
