#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "scene/check/check_objects.hpp"
#include "scene/model/function_role.hpp"
#include "scene/model/scene_index.hpp"

namespace sarsim::scene {

namespace {

constexpr double rounding = 1e-9;          // of the span of a table
constexpr double noticed_fraction = 1e-3;  // of a pulse's width
constexpr std::size_t min_bent_path = 3;   // points: through two there is a straight line, which is meant to go on

struct Span {
  double first = 0.0;
  double last = 0.0;
};

bool is_sound(const core::SampledFunction& function) {
  return std::ranges::all_of(function.knots,
                             [](const core::Knot& k) { return std::isfinite(k.x) && std::isfinite(k.y); }) &&
         std::ranges::adjacent_find(function.knots, std::ranges::greater_equal{}, &core::Knot::x) ==
             function.knots.end();
}

// Where a function is used and not given: the end that is farther out, and by how much.
struct Outside {
  double at = 0.0;
  double by = 0.0;
};

std::optional<Outside> outside(const core::SampledFunction& function, const Span& used, double tolerance) {
  if (function.knots.size() < 2 || !is_sound(function) || !(used.first <= used.last)) return std::nullopt;
  const double before = function.knots.front().x - used.first;
  const double after = used.last - function.knots.back().x;
  const double by = std::max(before, after);
  const double least = std::max(tolerance, rounding * (function.knots.back().x - function.knots.front().x));
  if (!(by > least)) return std::nullopt;
  return Outside{after >= before ? used.last : used.first, by};
}

// Words for one function of a field.
struct Told {
  std::string_view field;
  std::string_view what;  ///< "sensitivity-time control"
  std::string_view part;  ///< "X"; empty for a function that stands alone
  std::string_view x_unit;
  FunctionRole role;
  std::string used;  ///< "the recording begins at 9 km and ends at 11 km"
};

class EndRules {
 public:
  EndRules(Findings& findings, const Scene& scene) : findings_(findings), scene_(scene) {}

  void check() {
    SceneIndex names(scene_);
    Span times{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};  // of all recordings
    for (const Simulation& simulation : scene_.simulations) {
      if (!(simulation.time_start_s <= simulation.time_end_s)) continue;
      times = {std::min(times.first, simulation.time_start_s), std::max(times.last, simulation.time_end_s)};
      const std::size_t radar = names.radar(simulation.radar);
      if (radar != not_found) check_radar_of(scene_.radars[radar], radar, simulation);
    }
    for (std::size_t i = 0; i < scene_.platforms.size(); ++i) check_motion_of(scene_.platforms[i], i, times);
    for (std::size_t i = 0; i < scene_.radars.size(); ++i) check_fractions_of(scene_.radars[i], i);
  }

 private:
  [[nodiscard]] bool is_classic() const { return scene_.options.profile == Profile::classic; }

  // The value at the farthest place outside.
  [[nodiscard]] double value_at(FunctionRole role, const core::SampledFunction& function, double x) const {
    const core::InterpolationRules usual(is_classic() ? core::LowPassRule::origin : core::LowPassRule::first_knot,
                                         scene_.options.cubic_ends);
    return evaluated(role, function, usual, !is_classic())(x);
  }

  [[nodiscard]] std::string_view words_beyond(const Told& told, const core::SampledFunction& function) const {
    if (is_classic()) return "goes on as its interpolation does";
    const FunctionEnds& ends = function_ends(told.role);
    const bool holds = ends.beyond == core::Beyond::extended && function.method == core::Interpolation::low_pass;
    return holds ? "keeps the value of the nearer end, as low-pass filters do" : ends.words;
  }

  void tell(const Told& told, const core::SampledFunction& function, const Outside& found, bool loudly) {
    const std::string name = told.part.empty() ? std::string(told.what) : fmt::format("{} {}", told.what, told.part);
    Finding finding{
        .id = "function.beyond-points",
        .message = fmt::format("the {} is used beyond its points, where it {}", name, words_beyond(told, function)),
        .found = fmt::format(
            "points from {} to {}; {}; there it is {:.6g}", value_text(function.knots.front().x, told.x_unit),
            value_text(function.knots.back().x, told.x_unit), told.used, value_at(told.role, function, found.at)),
        .expected = fmt::format("points as far as {}", value_text(found.at, told.x_unit)),
        .hint = "Give more points, or points with the same value at both ends for a constant end."};
    if (loudly)
      findings_.warning(Consequence::surprise, told.field, std::move(finding));
    else
      findings_.note(told.field, std::move(finding));
  }

  // The worst of several functions of one field, which share what they are used for.
  template <std::size_t N>
  void check_times(const Told& told, const UserFunction<N>& functions, const Span& used) {
    std::optional<Outside> worst;
    std::size_t which = 0;
    for (std::size_t part = 0; part < N; ++part) {
      if (functions.part[part].knots.size() < min_bent_path) continue;
      const auto found = outside(functions.part[part], used, 0.0);
      if (!found || (worst && found->by <= worst->by)) continue;
      worst = found;
      which = part;
    }
    if (!worst) return;
    Told named = told;
    named.part = coordinate_parts[which];
    const auto& knots = functions.part[which].knots;
    const double spacing = (knots.back().x - knots.front().x) / static_cast<double>(knots.size() - 1);
    tell(named, functions.part[which], *worst, worst->by > spacing);
  }

  static std::string times_text(const Span& times) {
    return fmt::format("recordings last from {} to {}", value_text(times.first, "s"), value_text(times.last, "s"));
  }

  void check_motion_of(const Platform& platform, std::size_t index, const Span& times) {
    findings_.about("platform", index);
    if (platform.path == Platform::Path::trajectory)
      check_times({"trajectory_m", "trajectory", {}, "s", FunctionRole::trajectory, times_text(times)},
                  platform.trajectory_m, times);
    if (platform.rotation_kind == Platform::Rotation::user)
      check_times({"rotation_deg", "rotation", {}, "s", FunctionRole::rotation, times_text(times)},
                  platform.rotation_deg, times);
  }

  void check_radar_of(const Radar& radar, std::size_t index, const Simulation& simulation) {
    findings_.about("radar", index);
    const Span times{simulation.time_start_s, simulation.time_end_s};
    if (radar.beam == Radar::Beam::user)
      check_times(
          {"beam_target_world_m", "point the beam is held on", {}, "s", FunctionRole::beam_target, times_text(times)},
          radar.beam_target_world_m, times);
    if (radar.stc != Radar::Stc::user) return;
    const auto found = outside(radar.stc_gain.part[0], {simulation.range_start_m, simulation.range_end_m}, 0.0);
    if (!found) return;
    tell({"stc_gain",
          "sensitivity-time control",
          {},
          "m",
          FunctionRole::stc,
          fmt::format("a recording begins at {} and ends at {}", value_text(simulation.range_start_m, "m"),
                      value_text(simulation.range_end_m, "m"))},
         radar.stc_gain.part[0], *found, true);
  }

  // Functions of the fraction of the pulse's width.
  void check_fractions_of(const Radar& radar, std::size_t index) {
    findings_.about("radar", index);
    const auto check_one = [&](std::string_view field, std::string_view what, std::string_view part, FunctionRole role,
                               const core::SampledFunction& function) {
      const auto found = outside(function, {0.0, 1.0}, noticed_fraction);
      if (found) tell({field, what, part, "", role, "a pulse lasts from 0 to 1"}, function, *found, true);
      if (!found) tell_unmet(field, what, part, function);
    };
    if (radar.pulse == Radar::Pulse::user) {
      check_one("pulse_iq", "user-defined pulse's", "I", FunctionRole::pulse, radar.pulse_iq.part[0]);
      check_one("pulse_iq", "user-defined pulse's", "Q", FunctionRole::pulse, radar.pulse_iq.part[1]);
    }
    if (radar.envelope == Radar::Envelope::user)
      check_one("envelope_gain", "pulse envelope", {}, FunctionRole::pulse_envelope, radar.envelope_gain.part[0]);
    if (radar.window == Radar::Window::user)
      check_one("window_gain", "matched-filter window", {}, FunctionRole::window, radar.window_gain.part[0]);
  }

  // Points that count in per cent or in microseconds lie beyond the pulse, but for the first few.
  void tell_unmet(std::string_view field, std::string_view what, std::string_view part,
                  const core::SampledFunction& function) {
    constexpr double max_share = 0.5;
    if (function.knots.size() < 2 || !is_sound(function)) return;
    const double first = function.knots.front().x, last = function.knots.back().x;
    const double met = std::max(0.0, std::min(1.0, last) - std::max(0.0, first));
    if (met >= max_share * (last - first)) return;
    const std::string name = part.empty() ? std::string(what) : fmt::format("{} {}", what, part);
    findings_.warning(Consequence::surprise, field,
                      {.id = "function.never-met",
                       .message = fmt::format("most of the {} is never used: a pulse lasts from 0 to 1", name),
                       .found = fmt::format("points from {:g} to {:g}, {:.3g} % of them within", first, last,
                                            100.0 * met / (last - first)),
                       .expected = "fractions of the pulse width, from 0 to 1",
                       .hint = fmt::format("Divide x by {:g} where the pulse ends there.", last)});
  }

  Findings& findings_;
  const Scene& scene_;
};

}  // namespace

void check_function_ends(Findings& findings, const Scene& scene) { EndRules(findings, scene).check(); }

}  // namespace sarsim::scene
