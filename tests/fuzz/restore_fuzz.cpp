// Checkpoints whose file is sound and whose arrays are not: any of them gives a state, or a FileError. Every three
// bytes of the input are a change to the arrays of a good checkpoint: which array, what, where.
#include "math/errors.hpp"
#include "io/case/case_file.hpp"
#include "model/parts/setup.hpp"
#include "run/report/state_image.hpp"

#include <cmath>

namespace {

using namespace terp;

constexpr const char* small_case = R"(
scheme = "mpm_gp"
time.end = 1
mesh = { size = [2, 1], cell = 0.5 }
body = [{ material = "clay", box = [[0, 0], [1, 1]], points_per_cell = [2, 2] }]
boundary = { left = "roller", right = "open", bottom = "roller" }
[material.clay]
model = "linear_elastic"
density = 2e3
shear_modulus = 1e6
poisson_ratio = 0.3
)";

struct Start {
  Model model = build_model(read_case_text(small_case, "small.toml").values, 1);
  StateImage image = make_image(build_state(model));
};

template <class T>
T strange_value(unsigned char which)
{
  if constexpr (std::is_same_v<T, Real>) {
    const Real values[] = {NAN, INFINITY, -INFINITY, -1.0, 0.5, 1e300, -0.0, 0.0, 1.0, 15.0, 16.0};
    return values[which % std::size(values)];
  } else {
    const std::int64_t values[] = {-1, INT64_MAX, INT64_MIN, INT64_C(1) << 32, INT32_MAX, 0, 1, 2, 3, 15, 16};
    return values[which % std::size(values)];
  }
}

void change(NamedArray& array, unsigned char what, unsigned char where)
{
  const auto act = [&]<class T>(std::vector<T>& values) {
    if (what >= 250)
      values.clear();
    else if (what >= 240)
      values.resize(values.size() + where, strange_value<T>(where));
    else if (what >= 230)
      values.resize(values.size() - std::min<std::size_t>(values.size(), where));
    else if (!values.empty())
      values[where * 7919u % values.size()] = strange_value<T>(what);
  };
  if (what == 239)
    array.name += 'x';
  else if (what == 238 && array.values.index() == 0)
    array.values = std::vector<std::int64_t>(where);
  else
    std::visit(act, array.values);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  static const Start start;
  StateImage image = start.image;
  for (std::size_t k = 0; k + 3 <= size; k += 3)
    change(image.arrays[data[k] % image.arrays.size()], data[k + 1], data[k + 2]);
  try {
    const State state = restore(start.model, image);
    make_image(state);
  } catch (const FileError&) {
  }
  return 0;
}
