#include "run/report/state_arrays.hpp"

#include "math/errors.hpp"

#include <algorithm>

namespace terp {
namespace {

template <class T>
const std::vector<T>& find_array(const StateImage& image, const std::string& name, std::size_t size)
{
  for (const NamedArray& array : image.arrays) {
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
  return std::ranges::find(image_.arrays, prefix_ + std::string(name), &NamedArray::name) != image_.arrays.end();
}

const std::vector<Real>& ArrayReader::reals(std::string_view name, std::size_t size) const
{
  return find_array<Real>(image_, prefix_ + std::string(name), size);
}

const std::vector<std::int64_t>& ArrayReader::wholes(std::string_view name, std::size_t size) const
{
  return find_array<std::int64_t>(image_, prefix_ + std::string(name), size);
}

std::vector<bool> ArrayReader::flags(std::string_view name, std::size_t size) const
{
  const auto& values = wholes(name, size);
  return {values.begin(), values.end()};
}

}  // namespace terp
