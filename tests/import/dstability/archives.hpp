// D-Stability files for tests: the samples, and samples with something changed.
#pragma once

#include "import/dstability/read_stix.hpp"
#include "io/files/files.hpp"
#include "support/paths.hpp"

#include <nlohmann/json.hpp>

namespace terp::test {

inline std::string sample_path(const std::string& name)
{
  return source_path("tests/import/dstability/samples/" + name + ".stix");
}

using Members = std::vector<std::pair<std::string, std::string>>;

inline Members members_of_sample(const std::string& name)
{
  ZipMembers zip(name, read_file(sample_path(name)));
  Members members;
  for (std::size_t k = 0; k < zip.names().size(); ++k) members.emplace_back(zip.names()[k], zip.text(k));
  return members;
}

/// The same with the JSON texts on one line each, without spaces.
inline Members compact_sample(const std::string& name)
{
  Members members = members_of_sample(name);
  for (auto& [member, text] : members)
    if (member.ends_with(".json")) text = nlohmann::ordered_json::parse(text).dump();
  return members;
}

/// The members with `from` replaced by `to` in one of them, once. Fails the test if `from` is not there.
inline Members changed(Members members, const std::string& name, const std::string& from, const std::string& to)
{
  for (auto& [member, text] : members)
    if (const std::size_t at = member == name ? text.find(from) : std::string::npos; at != std::string::npos)
      return text.replace(at, from.size(), to), members;
  ADD_FAILURE() << name << " has no " << from;
  return members;
}

inline std::string refusal_of(const Members& members)
{
  return refusal<InputError>([&] { read_stix_bytes(zip_of(members), "dike.stix"); });
}

/// The smallest sample.
inline const std::string berm = "berm-fragility-2023";

inline std::string refusal_after(const std::string& member, const std::string& from, const std::string& to)
{
  return refusal_of(changed(compact_sample(berm), member, from, to));
}

inline std::vector<std::string> remarks_of(const StixProject& project)
{
  std::vector<std::string> texts;
  for (const StixRemark& remark : project.remarks) texts.push_back(remark.where + ": " + remark.what);
  return texts;
}

inline StixProject read_changed(const std::string& member, const std::string& from, const std::string& to)
{
  return read_stix_bytes(zip_of(changed(compact_sample(berm), member, from, to)), "dike.stix");
}

}  // namespace terp::test
