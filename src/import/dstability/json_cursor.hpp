// Typed access to a JSON tree, with the path of every value for messages. Faults are collected, not thrown, so that a
// user sees several at once; keys that nobody asked for are reported in the end.
// Not for: reading the text (json_tree.hpp), what a key means.
#pragma once

#include "math/errors.hpp"
#include "import/dstability/json_tree.hpp"
#include "import/dstability/project.hpp"
#include "import/dstability/reported_texts.hpp"

#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace terp {

class StixNotes {
 public:
  explicit StixNotes(std::string path) : path_(std::move(path)) {}

  /// where: member and path of the value. Throws InputError as soon as there are ten.
  void fault(const std::string& where, const std::string& what, const std::string& detail);
  void remark(const std::string& where, const Sentence& what)
  {
    remarks_.push_back({where, what.en, false, {}, what.nl});
  }
  void remark(StixRemark of) { remarks_.push_back(std::move(of)); }
  /// Of a member, key or version that the reader does not know.
  void remark_on_format(const std::string& where, const std::string& what) { remarks_.push_back({where, what, true}); }
  /// A key that the reader does not know; reported once for all members of a kind and all entries of a list.
  void unknown_key(const std::string& where, const std::string& key);
  /// Throws InputError if there are faults. Else the remarks.
  std::vector<StixRemark> finish();

 private:
  std::string path_;
  std::vector<Problem> faults_;
  std::vector<StixRemark> remarks_;
  std::map<std::string, int> unknown_;  ///< place without numbers -> how often
};

class JsonCursor {
 public:
  /// where: the member. The tree and the notes must outlive the cursor.
  JsonCursor(const JsonNode& node, std::string where, StixNotes& notes)
      : node_(&node), where_(std::move(where)), notes_(&notes)
  {
  }

  const std::string& where() const { return where_; }
  bool has(std::string_view key) const;  ///< with a value that is not null

  /// A finite number. "NaN", "Infinity", "-", null and no such key: not given.
  Real number(const char* key);
  /// The same times `unit`, which must be given in the file.
  Real required(const char* key, Real unit = 1.0);
  bool flag(const char* key);                         ///< null and no such key: false
  std::string text(const char* key);                  ///< null and no such key: empty
  std::string id(const char* key);                    ///< a text that is not empty
  JsonCursor object(const char* key);                 ///< null and no such key: an empty object
  std::vector<JsonCursor> list(const char* key);      ///< null and no such key: an empty list
  Vec<2> place(const char* key);                      ///< an object with X and Z [m]; required
  StixLine line(const char* key, std::size_t least);  ///< of at least so many places
  Vec<2> place_if_given(const char* key);             ///< the same, not given where there is none
  StixLine places_given(const char* key);             ///< those that have X and Z
  StixLine line_to_the_right(const char* key);        ///< turned round if it runs to the left

  /// Keys that are known and have no meaning here.
  void pass_over(std::initializer_list<const char*> keys) { asked_.insert(keys.begin(), keys.end()); }
  /// Tells of all keys that nobody asked for.
  void tell_unknown() const;
  void fault(const char* key, const std::string& what, const std::string& detail) const;
  void remark(const Sentence& what) const { notes_->remark(where_, what); }
  void remark_on_format(const std::string& what) const { notes_->remark_on_format(where_, what); }

 private:
  const JsonNode* find(const char* key);
  /// The value, if it is of a kind; a fault if it is of another.
  const JsonNode* find(const char* key, JsonKind kind, const char* wanted);
  Vec<2> as_place();

  const JsonNode* node_;
  std::string where_;
  StixNotes* notes_;
  std::set<std::string, std::less<>> asked_;
};

}  // namespace terp
