#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <string>

#include "core/maths/angle.hpp"
#include "core/maths/vector.hpp"

namespace sarsim::test {

/// Random choices that follow from one seed.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t below(std::uint64_t limit) { return engine_() % limit; }
  std::uint64_t bits() { return engine_(); }
  bool one_in(std::uint64_t many) { return below(many) == 0; }
  bool coin() { return one_in(2); }
  int integer(int low, int high) { return low + static_cast<int>(below(static_cast<std::uint64_t>(high - low + 1))); }
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return typed(low + (high - low) * uniform()); }
  /// Spread evenly over the decades from `low` to `high`, both above 0.
  double size(double low, double high) { return typed(low * std::pow(high / low, uniform())); }
  double signed_size(double low, double high) { return coin() ? size(low, high) : -size(low, high); }
  /// 0 one time in three.
  double size_or_zero(double low, double high) { return one_in(3) ? 0.0 : size(low, high); }

  template <class Enum>
  Enum one_of(int count) {
    return static_cast<Enum>(below(static_cast<std::uint64_t>(count)));
  }

  core::Angle angle(double largest_deg) { return core::Angle::from_deg(between(-largest_deg, largest_deg)); }
  core::Vec3 vector(double largest) {
    return {between(-largest, largest), between(-largest, largest), between(-largest, largest)};
  }
  /// Zeros or a vector of positive numbers, some of them zero.
  core::Vec3 magnitudes(double low, double high) {
    if (coin()) return {};
    return {size_or_zero(low, high), size_or_zero(low, high), size_or_zero(low, high)};
  }
  core::Vec3 direction() {
    const double z = 2.0 * uniform() - 1.0;
    const double turn = 2.0 * core::pi * uniform();
    const double r = std::sqrt(1.0 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
  }

 private:
  // A number as people type it, or one with all of its digits.
  double typed(double value) {
    if (value == 0.0 || one_in(4)) return value;
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - static_cast<double>(below(5)));
    return std::round(value / unit) * unit;
  }

  std::mt19937_64 engine_;
};

}  // namespace sarsim::test
