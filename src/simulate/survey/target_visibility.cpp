#include "simulate/survey/target_visibility.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "simulate/survey/beam_passes.hpp"
#include "simulate/survey/noise_energy.hpp"

namespace sarsim::simulate {

namespace {

constexpr std::int64_t looks_of_a_target = 64;
constexpr std::int64_t min_lit = 8;  // looks within 6 dB of the strongest that show a passage well enough
constexpr int max_zooms = 6;

bool is_isotropic(const radar::AntennaPattern& pattern) {
  return pattern.kind == radar::AntennaPattern::Kind::isotropic;
}

bool is_by_points(const radar::AntennaPattern& pattern) { return pattern.kind == radar::AntennaPattern::Kind::user; }

// Largest one-way amplitude of an antenna: cuts that are given by points may have any.
double peak_of(const radar::AntennaPattern& pattern) {
  if (pattern.kind != radar::AntennaPattern::Kind::user) return 1.0;
  const auto largest_db = [](const core::AngleFunction& cut, int last_quarter) {
    double largest = -std::numeric_limits<double>::infinity();
    for (int quarter = cut.is_even() ? 0 : -last_quarter; quarter <= last_quarter; ++quarter)
      largest = std::max(largest, cut.value(0.25 * quarter));
    return largest;
  };
  return std::pow(10.0, (largest_db(pattern.azimuth_gain_db, 720) + largest_db(pattern.elevation_gain_db, 360)) / 20.0);
}

// The part of a scene that some of its targets need.
ResolvedScene scene_of(const ResolvedScene& all, const std::vector<std::size_t>& targets, Link& radar) {
  ResolvedScene some;
  some.conventions = all.conventions;
  some.options = all.options;
  std::map<std::uint32_t, std::uint32_t> platforms;
  std::map<std::uint32_t, std::uint32_t> curves;
  const auto taken = [](auto& numbers, auto& into, const auto& from, std::uint32_t number) {
    const auto [place, fresh] = numbers.try_emplace(number, static_cast<std::uint32_t>(into.size()));
    if (fresh) into.push_back(from[number]);
    return place->second;
  };
  radar.platform = taken(platforms, some.platforms, all.platforms, radar.platform);
  for (const std::size_t target : targets) {
    Scatterer s = all.scatterers[target];
    s.jittered = false;
    s.platform = taken(platforms, some.platforms, all.platforms, s.platform);
    if (s.law == radar::ReflectivityLaw::user)
      s.gain_curve = taken(curves, some.gain_curves, all.gain_curves, s.gain_curve);
    some.scatterers.push_back(s);
  }
  return some;
}

struct PulseLook {
  std::int64_t pulse = 0;
  ScattererView view;
  radar::BeamOffset offset;
  double off_axis_rad = 0.0;
};

// Looks at one target after the other.
class Looker {
 public:
  Looker(const ResolvedScene& scene, const Link& radar, const radar::PulseRange& pulses)
      : scene_(scene),
        radar_(radar),
        pulses_(pulses),
        geometry_(scene, radar),
        isotropic_(is_isotropic(radar.transmit) && is_isotropic(radar.receive)),
        has_tables_(is_by_points(radar.transmit) || is_by_points(radar.receive)),
        peak_(peak_of(radar.transmit) * peak_of(radar.receive)) {
    for (const std::int64_t pulse : spread(pulses.first, pulses.last)) {
      whole_.push_back(geometry_);
      whole_.back().set_pulse(pulse);
    }
  }

  [[nodiscard]] TargetVisibility sight(std::size_t target) {
    TargetVisibility sight;
    std::int64_t first = pulses_.first;
    std::int64_t last = pulses_.last;
    if (is_scanning(radar_.beam)) narrow_to_a_pass(target, first, last);
    std::vector<PulseLook> looks =
        first == pulses_.first && last == pulses_.last ? looks_at(target) : looks_at(target, first, last);
    for (int zoom = 0; zoom < max_zooms; ++zoom) {
      take_in(sight, looks);
      const std::int64_t step =
          static_cast<std::int64_t>(looks.size()) < last - first + 1 ? (last - first) / (looks_of_a_target - 1) + 1 : 1;
      if (step == 1 || lit(looks) >= min_lit) break;
      // Twice as much as is lit, so that what the passage begins and ends with is there.
      const std::int64_t reach = (2 + 2 * lit(looks)) * step;
      const std::int64_t middle = nearest(looks).pulse;
      first = std::max(first, middle - reach);
      last = std::min(last, middle + reach);
      looks = looks_at(target, first, last);
    }
    take_in(sight, looks);
    add_passage(sight, looks, first, last, scene_.scatterers[target].law == radar::ReflectivityLaw::user);
    return sight;
  }

 private:
  [[nodiscard]] static std::vector<std::int64_t> spread(std::int64_t first, std::int64_t last) {
    const std::int64_t count = std::min(last - first + 1, looks_of_a_target);
    std::vector<std::int64_t> pulses;
    for (std::int64_t i = 0; i < count; ++i) {
      const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.0;
      pulses.push_back(first + std::llround(share * static_cast<double>(last - first)));
    }
    return pulses;
  }

  // A quarter of a turn before and after the pulse that points at the target.
  void narrow_to_a_pass(std::size_t target, std::int64_t& first, std::int64_t& last) const {
    const auto met = pulse_on_target(scene_, radar_, pulses_, target);
    if (!met) return;
    const double turn_s = 2.0 * core::pi / std::abs(radar_.beam.rate_rad_per_s);
    const double quarter = std::min(0.25 * turn_s / radar_.repetition.mean_interval_s(), 1e15);
    first = std::max(first, *met - static_cast<std::int64_t>(quarter));
    last = std::min(last, *met + static_cast<std::int64_t>(quarter));
  }

  [[nodiscard]] PulseLook look(const PulseGeometry& geometry, std::size_t target) const {
    const radar::Pointing pointing = geometry.pointing();
    PulseLook look{geometry.pulse(), geometry.view(target, pointing), {}, 0.0};
    if (isotropic_) return look;
    const Scatterer& s = scene_.scatterers[target];
    const core::Vec3 look_world_m =
        radar::world_position_m(geometry.pose(s.platform), s.position_m) - geometry.radar_pose().position_world_m;
    look.offset = pointing.offset(look_world_m);
    look.offset.azimuth_rad = radar::wrapped_angle(look.offset.azimuth_rad);
    look.offset.elevation_rad = radar::wrapped_angle(look.offset.elevation_rad);
    look.off_axis_rad =
        std::acos(std::clamp(std::cos(look.offset.azimuth_rad) * std::cos(look.offset.elevation_rad), -1.0, 1.0));
    return look;
  }

  [[nodiscard]] std::vector<PulseLook> looks_at(std::size_t target) const {
    std::vector<PulseLook> looks;
    for (const PulseGeometry& geometry : whole_) looks.push_back(look(geometry, target));
    return looks;
  }
  [[nodiscard]] std::vector<PulseLook> looks_at(std::size_t target, std::int64_t first, std::int64_t last) {
    std::vector<PulseLook> looks;
    for (const std::int64_t pulse : spread(first, last)) {
      geometry_.set_pulse(pulse);
      looks.push_back(look(geometry_, target));
    }
    return looks;
  }

  [[nodiscard]] static double power(const PulseLook& look) {
    return look.view.amplitude_sqrt_w * look.view.amplitude_sqrt_w;
  }
  [[nodiscard]] static double largest_power(const std::vector<PulseLook>& looks) {
    double largest = 0.0;
    for (const PulseLook& look : looks) largest = std::max(largest, power(look));
    return largest;
  }
  [[nodiscard]] static std::int64_t lit(const std::vector<PulseLook>& looks) {
    const double least = 0.25 * largest_power(looks);
    return std::ranges::count_if(looks, [&](const PulseLook& look) { return power(look) >= least; });
  }
  [[nodiscard]] static const PulseLook& nearest(const std::vector<PulseLook>& looks) {
    return *std::ranges::min_element(looks, {}, &PulseLook::off_axis_rad);
  }

  [[nodiscard]] double pattern_of(const PulseLook& look) const {
    if (isotropic_) return 1.0;
    const auto gain = [&](const radar::AntennaPattern& antenna) {
      return radar::one_way_amplitude(antenna, look.offset.azimuth_rad, look.offset.elevation_rad,
                                      scene_.conventions.pattern);
    };
    const double amplitude = gain(radar_.transmit) * gain(radar_.receive) / peak_;
    return amplitude * amplitude;
  }

  void take_in(TargetVisibility& sight, const std::vector<PulseLook>& looks) const {
    for (const PulseLook& look : looks) sight.best_pattern = std::max(sight.best_pattern, pattern_of(look));
    const PulseLook& best = largest_power(looks) > 0.0 ? *std::ranges::max_element(looks, {}, power) : nearest(looks);
    const double amplitude_v = std::abs(best.view.amplitude_sqrt_w);
    if (sight.range_m > 0.0 && amplitude_v <= sight.amplitude_v) return;
    sight.pulse = best.pulse;
    sight.range_m = radar::range_of(best.view.delay_s, scene_.conventions.light_speed_mps);
    sight.off_azimuth_rad = best.offset.azimuth_rad;
    sight.off_elevation_rad = best.offset.elevation_rad;
    sight.pattern = pattern_of(best);
    sight.amplitude_v = amplitude_v;
  }

  // What all pulses from the first to the last give, from an even choice of them.
  // @param has_curve  the target's reflectivity is one
  void add_passage(TargetVisibility& sight, const std::vector<PulseLook>& looks, std::int64_t first, std::int64_t last,
                   bool has_curve) const {
    const double noise_j = noise_energy_j(scene_.conventions, radar_);
    const double of_power = noise_j > 0.0 ? radar_.pulse.width_s / noise_j : 0.0;
    const double each =
        looks.size() > 1 ? static_cast<double>(last - first) / static_cast<double>(looks.size() - 1) : 1.0;
    const double least = 0.25 * largest_power(looks);
    const bool keeps_angles = has_tables_ || has_curve;
    sight.snr = of_power * sight.amplitude_v * sight.amplitude_v;
    sight.nearest_m = sight.farthest_m = sight.range_m;
    for (const PulseLook& look : looks) {
      const bool at_end = &look == &looks.front() || &look == &looks.back();
      sight.processed_snr += of_power * power(look) * (at_end ? 0.5 * (each + 1.0) : each);
      if (power(look) < least) continue;
      const double range_m = radar::range_of(look.view.delay_s, scene_.conventions.light_speed_mps);
      sight.nearest_m = std::min(sight.nearest_m, range_m);
      sight.farthest_m = std::max(sight.farthest_m, range_m);
      if (keeps_angles && power(look) > 0.0) sight.lit.push_back({look.offset, look.view.incidence_rad});
    }
    sight.processed_snr = std::max(sight.processed_snr, sight.snr);
  }

  const ResolvedScene& scene_;
  const Link& radar_;
  radar::PulseRange pulses_;
  PulseGeometry geometry_;
  std::vector<PulseGeometry> whole_;  // of pulses spread over the recording, the same for all targets
  bool isotropic_;
  bool has_tables_;
  double peak_;
};

}  // namespace

VisibilitySurvey::VisibilitySurvey(const Acquisition& acquisition, const std::vector<std::size_t>& targets)
    : acquisition_(&acquisition), targets_(targets), radar_(acquisition.link) {
  CORE_EXPECT(acquisition.scene != nullptr);
  for (const std::size_t target : targets) CORE_EXPECT(target < acquisition.scene->scatterers.size());
  scene_ = scene_of(*acquisition.scene, targets_, radar_);
}

std::vector<TargetVisibility> VisibilitySurvey::look(const radar::Beam& beam, const core::WorkControl& control) const {
  Link radar = radar_;
  radar.beam = beam;
  std::vector<TargetVisibility> sights;
  Looker looker(scene_, radar, acquisition_->timing.pulses);
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    if (control.stop != nullptr && control.stop->requested()) throw core::Interrupted();
    sights.push_back(looker.sight(i));
    sights.back().target = targets_[i];
  }
  return sights;
}

radar::BeamOffset VisibilitySurvey::direction() const {
  PulseGeometry geometry(scene_, radar_);
  geometry.set_pulse(acquisition_->timing.pulses.first + (acquisition_->timing.pulses.count() - 1) / 2);
  core::Vec3 middle_world_m;
  for (const Scatterer& s : scene_.scatterers)
    middle_world_m = middle_world_m + (1.0 / static_cast<double>(scene_.scatterers.size())) *
                                          radar::world_position_m(geometry.pose(s.platform), s.position_m);
  const radar::Pose& pose = geometry.radar_pose();
  const core::Vec3 line_of_sight_m =
      core::transposed(pose.world_from_platform) * (middle_world_m - pose.position_world_m);
  const double length_m = core::norm(line_of_sight_m);
  if (!(length_m > 0.0)) return {};
  return {std::atan2(line_of_sight_m.x, line_of_sight_m.y),
          std::asin(std::clamp(line_of_sight_m.z / length_m, -1.0, 1.0))};
}

const TargetVisibility& EchoSummary::strongest() const {
  CORE_EXPECT(!sights.empty());
  return *std::ranges::max_element(sights, {}, &TargetVisibility::amplitude_v);
}

const TargetVisibility& EchoSummary::weakest() const {
  CORE_EXPECT(!sights.empty());
  return *std::ranges::min_element(sights, {}, &TargetVisibility::amplitude_v);
}

}  // namespace sarsim::simulate
