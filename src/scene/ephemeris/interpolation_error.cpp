#include "scene/ephemeris/interpolation_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/maths/interpolator.hpp"
#include "core/report/expect.hpp"
#include "core/text/number_text.hpp"
#include "radar/orbit/state_table.hpp"

namespace sarsim::scene {

namespace {

using core::Problem;
using radar::OrbitState;

constexpr double infinite = std::numeric_limits<double>::infinity();

// The motion that a reader sees.
using Rebuilt = std::function<OrbitState(double time_s)>;

std::optional<radar::StateInterpolation> polynomial_of(Reconstruction reconstruction) {
  switch (reconstruction) {
    case Reconstruction::hermite_degree_7: return radar::hermite_degree_7;
    case Reconstruction::hermite_cubic: return radar::hermite_cubic;
    case Reconstruction::lagrange_8_points: return radar::lagrange_8_points;
    default: return std::nullopt;
  }
}

bool finite(const core::Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::optional<Problem> fault_of_times(std::span<const double> time_s, Reconstruction reconstruction) {
  if (time_s.size() < fewest_samples(reconstruction))
    return core::error("there are too few samples to interpolate")
        .found(fmt::format("{} samples", time_s.size()))
        .expected(fmt::format("{} or more", fewest_samples(reconstruction)));
  const auto out_of_order = [](double a, double b) { return !(a < b); };
  const bool whole = std::isfinite(time_s.front()) && std::isfinite(time_s.back());
  if (whole && std::adjacent_find(time_s.begin(), time_s.end(), out_of_order) == time_s.end()) return std::nullopt;
  return core::error("the times of samples do not ascend").expected("finite times, each above the one before");
}

Rebuilt spline_of(const radar::StateSamples& samples, Reconstruction reconstruction) {
  core::SampledFunction function;
  function.method =
      reconstruction == Reconstruction::straight_lines ? core::Interpolation::linear : core::Interpolation::cubic;
  core::InterpolationRules rules;
  rules.cubic_ends =
      reconstruction == Reconstruction::spline_chords ? core::CubicEnds::chords : core::CubicEnds::not_a_knot;
  std::array<core::Interpolator, 3> parts;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    function.knots.clear();
    for (std::size_t i = 0; i < samples.time_s.size(); ++i) {
      const core::Vec3& p = samples.position_m[i];
      function.knots.push_back({samples.time_s[i], std::array{p.x, p.y, p.z}[part]});
    }
    parts[part] = core::Interpolator(function, rules);
  }
  return [parts = std::move(parts)](double time_s) -> OrbitState {
    const core::Jet x = parts[0].jet(time_s);
    const core::Jet y = parts[1].jet(time_s);
    const core::Jet z = parts[2].jet(time_s);
    return {{x.value, y.value, z.value}, {x.slope, y.slope, z.slope}};
  };
}

std::variant<Rebuilt, Problem> rebuilt(const radar::StateSamples& samples, Reconstruction reconstruction) {
  const std::optional<radar::StateInterpolation> polynomial = polynomial_of(reconstruction);
  if (!polynomial) return spline_of(samples, reconstruction);
  auto made = radar::StateTable::from(samples, *polynomial);
  if (auto* const problem = std::get_if<Problem>(&made)) return std::move(*problem);
  return Rebuilt([table = std::get<radar::StateTable>(std::move(made))](double time_s) -> OrbitState {
    const std::optional<radar::OrbitMotion> motion = table.at(time_s);
    return motion ? OrbitState{motion->position_m, motion->velocity_mps}
                  : OrbitState{{infinite, infinite, infinite}, {infinite, infinite, infinite}};
  });
}

// Which intervals are looked into, and at how many places each.
struct Probes {
  std::size_t every = 1;
  std::size_t places = 4;
};

// A place within an interval, from 0 to 1: the middle, then one in each of the other parts by multiples of the golden
// section.
double place_of(std::size_t interval, std::size_t place, std::size_t places) {
  constexpr double golden = 0.61803398874989485;
  if (place == 0) return 0.5;
  const double turns = golden * static_cast<double>(interval * places + place);
  return (static_cast<double>(place - 1) + (turns - std::floor(turns))) / static_cast<double>(places - 1);
}

class Comparison {
 public:
  Comparison(const MotionPath& path, std::span<const double> time_s) : path_(path), time_s_(time_s) {}

  std::variant<InterpolationError, Problem> run(Reconstruction reconstruction, const Probes& probes) {
    constexpr std::size_t at_ends = 8;
    if (std::optional<Problem> fault = fault_of_times(time_s_, reconstruction)) return *std::move(fault);
    if (std::optional<Problem> fault = take_samples()) return *std::move(fault);
    const std::variant<Rebuilt, Problem> made = rebuilt(samples_, reconstruction);
    if (const auto* const problem = std::get_if<Problem>(&made)) return *problem;
    const std::size_t count = time_s_.size() - 1;
    for (std::size_t i = 0; i < count; ++i)
      if (i < at_ends || i + at_ends >= count || i % probes.every == 0)
        for (std::size_t place = 0; place < probes.places; ++place)
          compare(std::get<Rebuilt>(made), i, place_of(i, place, probes.places));
    if (std::isfinite(error_.position_m) && std::isfinite(error_.velocity_mps)) return error_;
    const double at_s = std::isfinite(error_.position_m) ? error_.velocity_at_s : error_.position_at_s;
    return not_finite(at_s);
  }

  // The distance of the farthest sample from the origin.
  [[nodiscard]] double farthest_m() const {
    double farthest = 0.0;
    for (const core::Vec3& position_m : samples_.position_m) farthest = std::max(farthest, core::norm(position_m));
    return farthest;
  }

 private:
  static Problem not_finite(double time_s) {
    return core::error("the motion is not finite at " + core::format_number(time_s) + " s")
        .expected("a position and a velocity at every time")
        .hint("choose other times");
  }

  std::optional<Problem> take_samples() {
    samples_.time_s.assign(time_s_.begin(), time_s_.end());
    samples_.position_m.reserve(time_s_.size());
    samples_.velocity_mps.reserve(time_s_.size());
    for (const double time_s : time_s_) {
      const radar::PathState state = path_(time_s);
      if (!finite(state.position_world_m) || !finite(state.velocity_world_mps)) return not_finite(time_s);
      samples_.position_m.push_back(state.position_world_m);
      samples_.velocity_mps.push_back(state.velocity_world_mps);
    }
    return std::nullopt;
  }

  void compare(const Rebuilt& motion, std::size_t interval, double place) {
    const double time_s = time_s_[interval] + place * (time_s_[interval + 1] - time_s_[interval]);
    const radar::PathState truth = path_(time_s);
    const OrbitState found = motion(time_s);
    keep(core::norm(found.position_m - truth.position_world_m), time_s, error_.position_m, error_.position_at_s);
    keep(core::norm(found.velocity_mps - truth.velocity_world_mps), time_s, error_.velocity_mps, error_.velocity_at_s);
  }

  static void keep(double error, double time_s, double& largest, double& at_s) {
    if (!std::isfinite(error)) error = infinite;
    if (!(error > largest)) return;
    largest = error;
    at_s = time_s;
  }

  const MotionPath& path_;
  std::span<const double> time_s_;
  radar::StateSamples samples_;
  InterpolationError error_;
};

// 1, 2 or 5 times a power of ten.
double spacing_of(int step) {
  constexpr std::array<double, 3> digits{1.0, 2.0, 5.0};
  const int exponent = step >= 0 ? step / 3 : -((2 - step) / 3);
  const double digit = digits[static_cast<std::size_t>(step - 3 * exponent)];
  // Powers above 0 are exact, so that either way the result is the double nearest to the decimal number.
  return exponent >= 0 ? digit * std::pow(10.0, exponent) : digit / std::pow(10.0, -exponent);
}

// The widest of the series that does not exceed a length.
int widest_step(double length_s) {
  int step = 3 * static_cast<int>(std::floor(std::log10(length_s))) + 3;
  while (spacing_of(step) > length_s) --step;
  return step;
}

}  // namespace

std::size_t fewest_samples(Reconstruction reconstruction) {
  const std::optional<radar::StateInterpolation> polynomial = polynomial_of(reconstruction);
  return polynomial ? polynomial->states : 2;
}

std::variant<InterpolationError, Problem> interpolation_error(const MotionPath& path, std::span<const double> time_s,
                                                              Reconstruction reconstruction, std::size_t every) {
  return Comparison(path, time_s).run(reconstruction, {std::max<std::size_t>(every, 1), 4});
}

std::vector<double> sample_times(double first_s, double last_s, double spacing_s) {
  constexpr double rounding = 1e-9;
  core::expect(first_s < last_s && spacing_s > 0.0 && (last_s - first_s) / spacing_s < 1e9,
               "sample times: the times do not ascend, or there is no spacing");
  const double intervals = (last_s - first_s) / spacing_s;
  const auto whole = static_cast<std::size_t>(std::floor(intervals + rounding));
  const double rest = intervals - static_cast<double>(whole);
  std::vector<double> time_s;
  time_s.reserve(whole + 2);
  for (std::size_t i = 0; i < whole; ++i) time_s.push_back(first_s + static_cast<double>(i) * spacing_s);
  if (whole == 0) time_s.push_back(first_s);
  // What remains is shared with the interval before it, so that none is much shorter than its neighbour.
  if (rest > rounding && whole > 0) time_s.push_back(0.5 * (time_s.back() + last_s));
  time_s.push_back(last_s);
  return time_s;
}

std::variant<SpacingChoice, Problem> spacing_for(const MotionPath& path, const SpacingRequest& wish) {
  constexpr std::size_t fewest_places = 4000;
  const double length_s = wish.last_s - wish.first_s;
  if (!(length_s > 0.0) || !std::isfinite(length_s) || !(wish.error_m > 0.0))
    return core::error("no spacing can be chosen")
        .found(fmt::format("{} s, below {} m", length_s, wish.error_m))
        .expected("times that ascend, and a limit above 0");
  std::optional<SpacingChoice> tried;
  const auto most = static_cast<double>(std::min<std::size_t>(wish.max_samples, 1'000'000'000));
  for (int step = widest_step(length_s); length_s / spacing_of(step) + 2.0 <= most; --step) {
    const double spacing_s = spacing_of(step);
    const std::vector<double> time_s = sample_times(wish.first_s, wish.last_s, spacing_s);
    if (time_s.size() < fewest_samples(wish.reconstruction)) continue;
    const std::size_t places = std::max<std::size_t>(4, fewest_places / (time_s.size() - 1));
    Comparison comparison(path, time_s);
    const auto found = comparison.run(wish.reconstruction, {1, places});
    if (const auto* const problem = std::get_if<Problem>(&found)) return *problem;
    tried = SpacingChoice{spacing_s, std::get<InterpolationError>(found)};
    if (tried->error.position_m < wish.error_m) return *tried;
    // Below a few units of the last place of the coordinates nothing gets better.
    if (tried->error.position_m <= 8.0 * std::numeric_limits<double>::epsilon() * comparison.farthest_m()) break;
  }
  return core::error(fmt::format("no spacing keeps the error below {} m", core::format_number(wish.error_m)))
      .found(tried ? fmt::format("{:.3g} m with {} s", tried->error.position_m, core::format_number(tried->spacing_s))
                   : fmt::format("{} samples at most", wish.max_samples))
      .expected(fmt::format("a limit that {} samples and the rounding of coordinates allow", wish.max_samples))
      .hint("choose a larger limit, a shorter time, or another interpolation");
}

}  // namespace sarsim::scene
