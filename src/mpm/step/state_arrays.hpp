// The named arrays of a checkpoint: how what is saved hands them over, and how it takes them back.
#pragma once

#include "math/types.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace terp {

/// A named array of a checkpoint, or rows of it.
struct NamedArray {
  std::string name;
  std::vector<std::int64_t> shape;  ///< of the whole
  std::variant<std::vector<Real>, std::vector<std::int64_t>> values;
  std::int64_t first =
      0;  ///< row of the whole that the first values are; arrays come from their first row to their last
};

/// An array of a checkpoint, and how to read n of its rows from `first` on.
struct ArraySource {
  using Values = decltype(NamedArray::values);
  std::string name;
  std::vector<std::int64_t> shape;
  std::function<Values(std::int64_t first, std::int64_t n)> read;

  std::int64_t n_rows() const { return shape[0]; }
  std::int64_t row_length() const { return shape.size() == 2 ? shape[1] : 1; }
};

/// Collects arrays, all of whose names begin with a prefix.
class ArrayWriter {
 public:
  ArrayWriter(std::vector<ArraySource>& arrays, std::string prefix = {}) : arrays_(arrays), prefix_(std::move(prefix))
  {
  }
  ArrayWriter below(std::string_view name) const { return {arrays_, prefix_ + std::string(name) + '/'}; }

  void add(ArraySource array)
  {
    array.name = prefix_ + array.name;
    arrays_.push_back(std::move(array));
  }
  /// An array that stays where it is and unchanged until the image is read; flags become whole numbers.
  template <class T>
  void refer(std::string name, const std::vector<T>& values)
  {
    using Kept = std::conditional_t<std::is_same_v<T, Real>, Real, std::int64_t>;
    add({std::move(name), {std::ssize(values)}, [&values](std::int64_t first, std::int64_t n) {
           return std::vector<Kept>(values.begin() + first, values.begin() + first + n);
         }});
  }
  /// A few numbers.
  template <class T>
  void copy(std::string name, std::vector<T> values)
  {
    const auto size = std::ssize(values);
    add({std::move(name), {size}, [values = std::move(values)](std::int64_t first, std::int64_t n) {
           return std::vector<T>(values.begin() + first, values.begin() + first + n);
         }});
  }

 private:
  std::vector<ArraySource>& arrays_;
  std::string prefix_;
};

/// Finds arrays again. Throws FileError if one is missing, of another type, or not of `size`.
class ArrayReader {
 public:
  static constexpr std::size_t any_size = SIZE_MAX;

  explicit ArrayReader(const std::vector<NamedArray>& arrays, std::string prefix = {})
      : arrays_(arrays), prefix_(std::move(prefix))
  {
  }
  ArrayReader below(std::string_view name) const { return ArrayReader(arrays_, prefix_ + std::string(name) + '/'); }

  bool has(std::string_view name) const;
  const std::vector<Real>& reals(std::string_view name, std::size_t size = any_size) const;
  const std::vector<std::int64_t>& wholes(std::string_view name, std::size_t size = any_size) const;
  std::vector<bool> flags(std::string_view name, std::size_t size) const;

 private:
  const std::vector<NamedArray>& arrays_;
  std::string prefix_;
};

}  // namespace terp
