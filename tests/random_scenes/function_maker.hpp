#pragma once

#include <string>

#include "random_scenes/chance.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::test {

/// Makes user-defined functions; some of them are to be kept in data files.
class FunctionMaker {
 public:
  explicit FunctionMaker(Chance& chance) : chance_(chance) {}

  /// `count` points, x ascending from about `low` to about `high`, y by `value(x)`; any interpolation.
  template <class Value>
  core::SampledFunction points(int count, double low, double high, const Value& value) {
    core::SampledFunction function;
    function.method = chance_.one_of<core::Interpolation>(3);
    const double step = (high - low) / std::max(1, count - 1);
    double previous = low - step;
    for (int i = 0; i < count; ++i) {
      double x = low + step * i;
      if (i > 0) x += step * chance_.between(-0.4, 0.4);
      if (x <= previous) x = previous + step * 0.1;
      previous = x;
      function.knots.push_back({x, value(x)});
    }
    return function;
  }

  /// A function whose values lie between two bounds.
  core::SampledFunction curve(int most, double low, double high, double smallest, double largest) {
    return points(chance_.integer(1, most), low, high, [&](double) { return chance_.between(smallest, largest); });
  }

  /// Values in turn, whose x means nothing.
  core::SampledFunction list(int most, double smallest, double largest) {
    core::SampledFunction function;
    function.method = chance_.one_of<core::Interpolation>(3);
    for (int i = chance_.integer(1, most); i > 0; --i)
      function.knots.push_back({chance_.between(-10.0, 10.0), chance_.between(smallest, largest)});
    return function;
  }

  /// Gives some functions the name of a data file; one that holds an empty list cannot be kept in a file.
  template <std::size_t N>
  void name_file(scene::UserFunction<N>& function) {
    for (const core::SampledFunction& part : function.part)
      if (part.knots.empty()) return;
    if (chance_.one_in(5))
      function.file = (chance_.coin() ? "data file " : "curve-") + std::to_string(files_++) + ".dat";
  }

 private:
  Chance& chance_;
  int files_ = 1;
};

}  // namespace sarsim::test
