#include "mpm/step/state_arrays.hpp"

#include "math/errors.hpp"

#include <algorithm>

namespace terp {
namespace {

template <class T>
const std::vector<T>& find_array(const std::vector<NamedArray>& arrays, const std::string& name, std::size_t size)
{
  for (const NamedArray& array : arrays) {
    if (array.name != name) continue;
    const auto* values = std::get_if<std::vector<T>>(&array.values);
    if (values == nullptr || (size != ArrayReader::any_size && values->size() != size)) break;
    return *values;
  }
  throw FileError("the checkpoint does not fit this case: array `" + name + "` is missing or has another size");
}

}  // namespace

bool ArrayReader::has(std::string_view name) const
{
  return std::ranges::find(arrays_, prefix_ + std::string(name), &NamedArray::name) != arrays_.end();
}

const std::vector<Real>& ArrayReader::reals(std::string_view name, std::size_t size) const
{
  return find_array<Real>(arrays_, prefix_ + std::string(name), size);
}

const std::vector<std::int64_t>& ArrayReader::wholes(std::string_view name, std::size_t size) const
{
  return find_array<std::int64_t>(arrays_, prefix_ + std::string(name), size);
}

std::vector<bool> ArrayReader::flags(std::string_view name, std::size_t size) const
{
  const auto& values = wholes(name, size);
  return {values.begin(), values.end()};
}

}  // namespace terp
