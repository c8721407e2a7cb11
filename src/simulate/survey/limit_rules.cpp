#include "simulate/survey/limit_rules.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"
#include "radar/earth/earth_depth.hpp"
#include "radar/earth/ellipsoid_height.hpp"
#include "radar/path/path.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "simulate/survey/beam_passes.hpp"

namespace sarsim::simulate {

namespace {

constexpr double max_aliased_share = 0.05;       // of the spectrum of an echo
constexpr double max_below_ground_m = 1.0;       // of a flat world
constexpr double max_below_ellipsoid_m = 120.0;  // the deepest geoid is 107 m below it
constexpr double max_dispersion_cells = 0.5;     // a quadratic phase of 0.4 rad at the ends of the band
constexpr double max_bending_wavelengths = 1.0 / 16.0;
constexpr double max_blind_share = 0.02;              // of the PRF, beside a multiple of it
constexpr double min_ambiguous_ratio = 0.1;           // amplitude, of the strongest target
constexpr std::size_t max_compared = 64;              // targets, each with each other
constexpr std::size_t max_compared_places = 100'000;  // targets whose positions are compared
constexpr std::int64_t min_aperture_pulses = 16;

// One target at the middle pulse.
struct Placed {
  std::size_t target = 0;
  core::Vec3 from_radar_m;  // world
  double distance_m = 0.0;
  double doppler_hz = 0.0;
  double amplitude = 0.0;  // the largest of the survey
};

std::string text_of(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

class LimitRules {
 public:
  LimitRules(const Acquisition& acquisition, const EchoSurvey& survey, std::size_t index, const std::string& scope,
             core::Problems& problems)
      : acquisition_(acquisition),
        survey_(survey),
        index_(index),
        scope_(scope),
        problems_(problems),
        light_mps_(acquisition.light_speed_mps()),
        bandwidth_hz_(radar::bandwidth_hz(acquisition.link.pulse)),
        geometry_(*acquisition.scene, acquisition.link) {
    geometry_.set_pulse(acquisition.timing.pulses.first + acquisition.timing.pulses.count() / 2);
    for (const std::size_t target : targets_in_window(survey, max_compared)) place(target);
  }

  void check() {
    check_sampled_band();
    check_same_positions();
    check_below_ground();
    if (placed_.empty()) return;
    check_dispersion();
    check_bending();
    check_sides();
    check_cells();
    check_blind_speeds();
  }

 private:
  void place(std::size_t target) {
    const Scatterer& scatterer = acquisition_.scene->scatterers[target];
    const TargetSurvey& seen = survey_.targets[target];
    if (!(seen.largest_amplitude_v > 0.0)) return;
    const core::Vec3 from_radar_m = radar::world_position_m(geometry_.pose(scatterer.platform), scatterer.position_m) -
                                    geometry_.radar_pose().position_world_m;
    placed_.push_back({target, from_radar_m, core::norm(from_radar_m),
                       radar::doppler_of(geometry_.view(target).speed_mps, geometry_.carrier_hz(), light_mps_),
                       seen.largest_amplitude_v});
  }

  void add(const char* field, core::Problem problem) {
    problem.message += scope_;
    problem.subject = {"simulation", index_, field};
    problems_.push_back(std::move(problem));
  }

  // Sampling slower than the band is reported by `check`.
  void check_sampled_band() {
    if (acquisition_.reception.profiler || survey_.targets.empty() || !survey_.totals.any_in_window) return;
    const double rate_hz = 1.0 / acquisition_.reception.raw_grid.interval_s;
    const double doppler_hz = std::max(std::abs(survey_.lowest_doppler_hz), std::abs(survey_.highest_doppler_hz));
    const double aliased_hz = doppler_hz - 0.5 * std::max(0.0, rate_hz - bandwidth_hz_);
    if (!(aliased_hz > max_aliased_share * bandwidth_hz_)) return;
    add("sample_rate_hz",
        core::warning(
            "doppler.beyond-sampled-band",
            fmt::format(
                "the Doppler shift moves {:.0f} % of the echo spectrum out of the sampled band, where it aliases",
                100.0 * std::min(1.0, aliased_hz / bandwidth_hz_)))
            .found(fmt::format("a shift of {} at a sampling frequency of {}", core::with_prefix(doppler_hz, "Hz", 4),
                               core::with_prefix(rate_hz, "Hz", 4)))
            .expected(fmt::format("a sampling frequency of at least {}",
                                  core::with_prefix(bandwidth_hz_ + 2.0 * doppler_hz, "Hz", 4)))
            .hint("A receiver would shift its centre frequency by the Doppler centroid; sample faster instead."));
  }

  // Places of all scatterers in the world while a pulse is sent.
  [[nodiscard]] std::vector<core::Vec3> places(std::int64_t pulse) const {
    PulseGeometry geometry(*acquisition_.scene, acquisition_.link);
    geometry.set_pulse(pulse);
    const ScattererList& all = acquisition_.scene->scatterers;
    std::vector<core::Vec3> places_m;
    places_m.reserve(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      places_m.push_back(radar::world_position_m(geometry.pose(all[i].platform), all[i].position_m));
    return places_m;
  }

  // Numbers of the places that are there more than once, ascending; a table of hashes, since most scenes have none.
  [[nodiscard]] static std::vector<std::size_t> not_alone(const std::vector<core::Vec3>& places_m) {
    std::vector<std::size_t> found;
    std::vector<std::uint32_t> table(std::bit_ceil(2 * places_m.size()), 0);  // Numbers from 1; 0: free.
    const std::size_t mask = table.size() - 1;
    for (std::size_t i = 0; i < places_m.size(); ++i) {
      std::size_t slot = hash_of(places_m[i]) & mask;
      while (table[slot] != 0 && !(places_m[table[slot] - 1] == places_m[i])) slot = (slot + 1) & mask;
      if (table[slot] == 0) {
        table[slot] = static_cast<std::uint32_t>(i + 1);
        continue;
      }
      found.push_back(table[slot] - 1);
      found.push_back(i);
    }
    std::ranges::sort(found);
    found.erase(std::ranges::unique(found).begin(), found.end());
    return found;
  }
  static std::size_t hash_of(const core::Vec3& place_m) {
    std::uint64_t hash = 0;
    for (const double part : {place_m.x, place_m.y, place_m.z}) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(part + 0.0)) * 0x9E3779B97F4A7C15U;  // -0 is 0.
      hash ^= hash >> 32U;
    }
    return hash;
  }

  // In the world, at two pulses: whatever platforms they are on.
  void check_same_positions() {
    const std::size_t targets = acquisition_.scene->scatterers.size();
    if (targets < 2 || targets > max_compared_places) return;
    const std::vector<core::Vec3> first_m = places(acquisition_.timing.pulses.first);
    std::vector<std::size_t> order = not_alone(first_m);
    if (order.empty()) return;
    const std::vector<core::Vec3> middle_m =
        places(acquisition_.timing.pulses.first + acquisition_.timing.pulses.count() / 2);
    const auto key = [&](std::size_t i) {
      return std::tuple(first_m[i].x, first_m[i].y, first_m[i].z, middle_m[i].x, middle_m[i].y, middle_m[i].z);
    };
    std::ranges::stable_sort(order, {}, key);
    std::size_t count = 0, first = targets, other = targets;
    for (std::size_t i = 1; i < order.size(); ++i) {
      if (key(order[i - 1]) != key(order[i])) continue;
      ++count;
      if (order[i] < other) std::tie(first, other) = std::tuple(order[i - 1], order[i]);
    }
    if (count == 0) return;
    add("",
        core::warning("targets.same-position",
                      fmt::format("targets {} and {} are at the same position: their echoes sum to those of one target",
                                  first + 1, other + 1))
            .found(fmt::format("{} at the position of another one", text_of(count, "target", "targets")))
            .expected("positions that differ")
            .hint("Remove the copy, or give one target the sum of the amplitudes."));
  }

  // The lowest place of the radar in the flight, and its height.
  struct Lowest {
    core::Vec3 radar_m;
    double height_m = std::numeric_limits<double>::infinity();
    std::int64_t pulse = 0;
  };

  // Leaves the geometry at the middle pulse, where the other rules expect it.
  [[nodiscard]] Lowest lowest() {
    constexpr std::int64_t max_steps = 16;
    const radar::TurningAxes& turning = acquisition_.scene->turning;
    const double rate = core::norm(turning.rotation_rad_per_s);
    Lowest lowest;
    const std::int64_t flown = acquisition_.timing.pulses.count() - 1;
    const std::int64_t steps = std::clamp<std::int64_t>(flown, 1, max_steps);
    for (std::int64_t i = 0; i <= steps; ++i) {
      const std::int64_t after = flown / steps * i + flown % steps * i / steps;
      geometry_.set_pulse(acquisition_.timing.pulses.first + after);
      const core::Vec3 radar_m = geometry_.radar_pose().position_world_m;
      const double height_m = rate == 0.0 ? radar_m.z
                                          : radar::height_over_ellipsoid_m(radar_m - turning.centre_m,
                                                                           (1.0 / rate) * turning.rotation_rad_per_s);
      if (height_m < lowest.height_m) lowest = {radar_m, height_m, after};
    }
    geometry_.set_pulse(acquisition_.timing.pulses.first + acquisition_.timing.pulses.count() / 2);
    return lowest;
  }

  void check_below_ground() {
    if (acquisition_.timing.pulses.count() < 1) return;
    const bool flat = core::norm(acquisition_.scene->turning.rotation_rad_per_s) == 0.0;
    const Lowest low = lowest();
    if (low.height_m > -(flat ? max_below_ground_m : max_below_ellipsoid_m)) return;
    const double radar_z_m = geometry_.radar_pose().position_world_m.z;
    if (flat && std::ranges::any_of(
                    placed_, [&](const Placed& target) { return radar_z_m + target.from_radar_m.z <= low.radar_m.z; }))
      return;
    const bool impossible = !flat && low.height_m < radar::deepest_place_m;
    add("radar",
        core::ProblemBuilder(
            impossible ? core::Severity::error : core::Severity::warning, "radar.below-ground",
            flat ? "the radar is below the ground and below its targets" : "the radar is below the ellipsoid")
            .found(fmt::format("a height of {:.6g} m{}, at pulse {} of {}", low.height_m,
                               flat ? ", z of the world" : "", low.pulse + 1, acquisition_.timing.pulses.count()))
            .expected(flat ? "z above 0"
                           : fmt::format("above -{:g} m, the lowest level of the sea", max_below_ellipsoid_m))
            .hint(impossible ? "Heights are positive upwards: is the sign wrong?"
                             : "Heights are positive upwards: is the sign wrong? Echoes are computed all the same."));
  }

  void check_dispersion() {
    if (!acquisition_.link.air) return;
    double worst_m = 0.0;
    std::size_t target = 0;
    const core::Vec3 radar_m = geometry_.radar_pose().position_world_m;
    for (const Placed& placed : placed_) {
      const radar::PathEffect way = acquisition_.link.air->one_way(radar_m, radar_m + placed.from_radar_m);
      // The group is late by as much as the phase is early; it falls with the square of the frequency.
      const double spread_m = (way.delay_m - way.phase_m) * bandwidth_hz_ / geometry_.carrier_hz();
      if (spread_m > worst_m) std::tie(worst_m, target) = std::tuple(spread_m, placed.target);
    }
    const double cell_m = radar::range_of_cycle(bandwidth_hz_, light_mps_);
    if (!(worst_m > max_dispersion_cells * cell_m)) return;
    add("radar",
        core::warning(
            "air.dispersion",
            "dispersion by the ionosphere within the band of the pulse is not modelled: real echoes would be wider")
            .found(fmt::format("a range spread of {:.3g} m over the band, for target {}", worst_m, target + 1))
            .expected(
                fmt::format("at most {:.3g} m, half a range cell of {:.3g} m", max_dispersion_cells * cell_m, cell_m))
            .hint("All frequencies are delayed like the carrier. Reduce the bandwidth or raise the carrier."));
  }

  void check_bending() {
    if (!acquisition_.link.air) return;
    double worst_m = 0.0;
    Placed worst;
    const core::Vec3 radar_m = geometry_.radar_pose().position_world_m;
    for (const Placed& placed : placed_) {
      const double bending_m = acquisition_.link.air->bending_m(radar_m, radar_m + placed.from_radar_m);
      if (bending_m > worst_m) std::tie(worst_m, worst) = std::tuple(bending_m, placed);
    }
    const double wavelength_m = radar::wavelength_of(geometry_.carrier_hz(), light_mps_);
    if (!(worst_m > max_bending_wavelengths * wavelength_m)) return;
    const double elevation_rad = acquisition_.link.air->elevation_rad(radar_m, radar_m + worst.from_radar_m);
    add("radar",
        core::warning("air.bending",
                      "rays bend at low elevation, which is not modelled: echoes follow the straight line")
            .found(fmt::format(
                "target {} at an elevation of {:.3g} deg: the bent ray is {:.3g} mm shorter, {:.2g} rad two-way",
                worst.target + 1, core::deg_per_rad * elevation_rad, 1e3 * worst_m,
                4.0 * core::pi * worst_m / wavelength_m))
            .expected(fmt::format("at most {:.2g} mm, a sixteenth of the wavelength",
                                  1e3 * max_bending_wavelengths * wavelength_m))
            .hint("Phases have this error, and the direction at the antenna is off by the bending angle."));
  }

  // Whether the flight makes an aperture: its length squared exceeds half a wavelength times the range.
  [[nodiscard]] bool makes_aperture() {
    if (acquisition_.timing.pulses.count() < min_aperture_pulses || is_scanning(acquisition_.link.beam)) return false;
    PulseGeometry ends(*acquisition_.scene, acquisition_.link);
    ends.set_pulse(acquisition_.timing.pulses.first);
    const core::Vec3 first_m = ends.radar_pose().position_world_m;
    ends.set_pulse(acquisition_.timing.pulses.last);
    // A flight around the scene ends where it began.
    const double flown_m = std::max(core::norm(ends.radar_pose().position_world_m - first_m),
                                    core::norm(geometry_.radar_pose().position_world_m - first_m));
    const double wavelength_m = radar::wavelength_of(geometry_.carrier_hz(), light_mps_);
    return 2.0 * flown_m * flown_m > wavelength_m * placed_.front().distance_m;
  }

  // Sides of the vertical plane through the velocity have the same ranges and Doppler frequencies.
  void check_sides() {
    if (!makes_aperture()) return;
    const radar::TurningAxes& turning = acquisition_.scene->turning;
    const core::Vec3 radar_m = geometry_.radar_pose().position_world_m;
    const core::Vec3 up =
        turning.rotation_rad_per_s == core::Vec3{} ? core::Vec3{0.0, 0.0, 1.0} : radar_m - turning.centre_m;
    const core::Vec3 right = core::cross(geometry_.radar_pose().velocity_world_mps, up);
    double strongest = 0.0;
    for (const Placed& placed : placed_) strongest = std::max(strongest, placed.amplitude);
    std::size_t on_right = 0, on_left = 0;
    for (const Placed& placed : placed_) {
      if (placed.amplitude < min_ambiguous_ratio * strongest) continue;
      const double side = core::dot(right, placed.from_radar_m);
      const double min_side = 1e-3 * core::norm(right) * placed.distance_m;
      on_right += side > min_side ? 1 : 0;
      on_left += side < -min_side ? 1 : 0;
    }
    if (on_right == 0 || on_left == 0) return;
    add("radar",
        core::warning(
            "image.sides-ambiguous",
            "both sides of the track are illuminated: left and right are ambiguous in an image, as range and Doppler "
            "frequency are the same")
            .found(fmt::format("{} on the left and {} on the right of the track", text_of(on_left, "target", "targets"),
                               on_right))
            .expected("targets on one side, or an antenna that points to one side")
            .hint("Give the radar a beam that points to one side, or remove the targets of the other."));
  }

  // Pairs of one cell of range, which all carriers resolve together, and, while the beam rests, of Doppler.
  void check_cells() {
    if (is_scanning(acquisition_.link.beam) || acquisition_.reception.profiler ||
        survey_.totals.in_window > max_compared)
      return;
    const double band_hz =
        acquisition_.link.carrier.highest_hz() - acquisition_.link.carrier.lowest_hz() + bandwidth_hz_;
    const double cell_m = radar::range_of_cycle(band_hz, light_mps_);
    const double cell_hz = 1.0 / (acquisition_.link.repetition.mean_interval_s() *
                                  static_cast<double>(acquisition_.timing.pulses.count()));
    std::size_t count = 0;
    std::pair<std::size_t, std::size_t> first;
    double range_m = 0.0, doppler_hz = 0.0;
    for (std::size_t i = 0; i < placed_.size(); ++i)
      for (std::size_t k = i + 1; k < placed_.size(); ++k) {
        const double apart_m = std::abs(placed_[i].distance_m - placed_[k].distance_m);
        const double apart_hz = std::abs(placed_[i].doppler_hz - placed_[k].doppler_hz);
        if (!(apart_m < cell_m && apart_hz < cell_hz)) continue;
        if (placed_[i].from_radar_m == placed_[k].from_radar_m && apart_hz == 0.0) continue;  // Reported as such.
        if (count++ > 0) continue;
        first = {placed_[i].target + 1, placed_[k].target + 1};
        std::tie(range_m, doppler_hz) = std::tuple(apart_m, apart_hz);
      }
    if (count == 0) return;
    add("", core::note("targets.unresolved",
                       fmt::format("targets {} and {} are unresolved: they share one range-Doppler cell", first.first,
                                   first.second))
                .found(fmt::format("{}; the first {:.3g} m and {} apart", text_of(count, "pair", "pairs"), range_m,
                                   core::with_prefix(doppler_hz, "Hz", 3)))
                .expected(
                    fmt::format("more than {:.3g} m, c/(2 B), or {}, 1/T", cell_m, core::with_prefix(cell_hz, "Hz", 3)))
                .hint("Their echoes interfere: peaks differ from those of single targets."));
  }

  // Of a radar at rest, to whose pulses such targets look like clutter.
  void check_blind_speeds() {
    if (core::norm(geometry_.radar_pose().velocity_world_mps) > 0.0 || acquisition_.timing.pulses.count() < 2 ||
        acquisition_.reception.profiler)
      return;
    const double prf_hz = 1.0 / acquisition_.link.repetition.mean_interval_s();
    if (1.0 / acquisition_.link.repetition.shortest_interval_s() > prf_hz * (1.0 + 1e-6)) return;  // Staggered.
    if (acquisition_.link.carrier.lowest_hz() != acquisition_.link.carrier.highest_hz()) return;
    std::size_t count = 0;
    std::optional<Placed> first;
    for (const Placed& placed : placed_) {
      if (std::abs(placed.doppler_hz) < 0.5 * prf_hz) continue;
      if (std::abs(std::remainder(placed.doppler_hz, prf_hz)) > max_blind_share * prf_hz) continue;
      ++count;
      if (!first) first = placed;
    }
    if (!first) return;
    const double wavelength_m = radar::wavelength_of(geometry_.carrier_hz(), light_mps_);
    add("radar", core::warning("targets.blind-speed",
                               fmt::format("{} at a blind speed, target {} the first: it appears stationary",
                                           text_of(count, "target moves", "targets move"), first->target + 1))
                     .found(fmt::format("a Doppler frequency of {}, which aliases to {}",
                                        core::with_prefix(first->doppler_hz, "Hz", 5),
                                        core::with_prefix(std::remainder(first->doppler_hz, prf_hz), "Hz", 3)))
                     .expected(fmt::format("radial speeds away from multiples of {:.4g} m/s, lambda PRF/2",
                                           0.5 * wavelength_m * prf_hz))
                     .hint("Change the PRF or the carrier, or stagger the pulse intervals."));
  }

  const Acquisition& acquisition_;
  const EchoSurvey& survey_;
  std::size_t index_;
  const std::string& scope_;
  core::Problems& problems_;
  double light_mps_;
  double bandwidth_hz_;
  PulseGeometry geometry_;
  std::vector<Placed> placed_;
};

}  // namespace

void check_limits(const Acquisition& acquisition, const EchoSurvey& survey, std::size_t index, const std::string& scope,
                  core::Problems& problems) {
  LimitRules(acquisition, survey, index, scope, problems).check();
}

}  // namespace sarsim::simulate
