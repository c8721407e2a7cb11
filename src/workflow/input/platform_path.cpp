#include "workflow/input/platform_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "radar/earth/ellipsoid.hpp"
#include "radar/earth/instant.hpp"
#include "radar/orbit/j2_motion.hpp"
#include "radar/orbit/kepler.hpp"
#include "radar/orbit/sgp4.hpp"
#include "scene/ephemeris/element_choice.hpp"
#include "scene/ephemeris/read_ephemeris.hpp"
#include "scene/ephemeris/sample_accuracy.hpp"
#include "scene/model/orbit.hpp"
#include "scene/model/world_frame.hpp"
#include "workflow/input/sample_gaps.hpp"

namespace sarsim::workflow {

namespace {

using scene::Platform;

// States that are computed are this far apart, and go on so long before and behind the recordings.
constexpr double state_spacing_s = 10.0;
constexpr double state_margin_s = 60.0;
constexpr std::size_t max_states = 2'000'000;
constexpr double farthest_from_state_s = 864e3;
// A path that is less sure than this is none.
constexpr double max_error_m = 2e3;

radar::StateInterpolation interpolation_of(const Platform& platform, bool has_velocities) {
  switch (platform.interpolation) {
    case Platform::Interpolation::automatic: break;
    case Platform::Interpolation::hermite: return radar::hermite_degree_7;
    case Platform::Interpolation::lagrange: return radar::lagrange_8_points;
    case Platform::Interpolation::cubic: return radar::hermite_cubic;
  }
  return has_velocities ? radar::hermite_degree_7 : radar::lagrange_8_points;
}

// Makes the path of one platform.
class PathMaker {
 public:
  PathMaker(const scene::Scene& scene, const Platform& platform, core::Problems& problems)
      : platform_(platform), problems_(problems), needed_(scene::needed_times(scene)), axes_(scene.world) {}

  std::shared_ptr<const scene::ReadPath> of_file(const FileText& file) {
    const scene::OrbitFormat format = scene::orbit_format_of(file.text);
    switch (format) {
      case scene::OrbitFormat::tle:
      case scene::OrbitFormat::omm_kvn:
      case scene::OrbitFormat::omm_xml:
      case scene::OrbitFormat::omm_csv:
      case scene::OrbitFormat::omm_json: return of_elements(file, format);
      case scene::OrbitFormat::aem:
      case scene::OrbitFormat::other_ndm:
      case scene::OrbitFormat::unknown:
        return refuse(core::error(fmt::format("{} is not an orbit file", platform_.ephemeris_file))
                          .found(scene::what_is_no_orbit(file.text, format))
                          .expected("Sentinel-1 EOF, CCSDS OEM, SP3, a table t, x, y, z, TLE or OMM"));
      default: return of_states(file, format);
    }
  }

  // An ellipse whose node is given over the Earth as it lies at time 0.
  std::shared_ptr<const scene::ReadPath> of_orbit() {
    if (!axes_.earth()) return refuse(no_earth("an orbit"));
    const auto elements = scene::elements_of(platform_);
    if (!elements) return nullptr;  // `check` says it.
    const double perigee_m = platform_.semi_major_axis_m * (1.0 - platform_.eccentricity);
    if (!(perigee_m > radar::wgs84_semi_major_m))
      return refuse(core::error("the perigee of the orbit is inside the Earth")
                        .found(fmt::format("{:.1f} km from the centre", 1e-3 * perigee_m))
                        .expected("more than 6378.137 km")
                        .hint("change semi_major_axis or eccentricity"));
    const radar::SecularOrbit orbit(*elements);
    radar::StateSamples samples;
    for (const double time_s : computed_times()) {
      const radar::OrbitMotion motion = orbit.at(time_s);
      add(samples, time_s, axes_.from_ecef(over_earth({motion.position_m, motion.velocity_mps}, time_s)), true);
    }
    return made(samples, radar::hermite_degree_7, needed_with_margin(), "mean elements, turned by J2");
  }

  // From a state over the Earth at time 0 on.
  std::shared_ptr<const scene::ReadPath> of_state() {
    if (!axes_.earth()) return refuse(no_earth("an orbit"));
    const radar::OrbitState start = scene::inertial_state_of(platform_);
    if (!std::isfinite(core::norm(start.position_m) + core::norm(start.velocity_mps))) return nullptr;  // `check`
    if (height_of(start.position_m) < 0.0)
      return refuse(core::error("the state of the orbit is inside the Earth")
                        .found(typed_height(start.position_m))
                        .expected("a position outside it")
                        .hint("it counts from the centre of the Earth"));
    const double farthest_s = std::max(std::abs(needed_.first_s), std::abs(needed_.last_s));
    if (farthest_s > farthest_from_state_s)
      return refuse(core::error("the recordings are too far from the state of the orbit")
                        .found(fmt::format("{:.0f} s from time 0", farthest_s))
                        .expected(fmt::format("at most {:.0f} s, 10 days", farthest_from_state_s))
                        .hint("by then drag, Sun and Moon have led elsewhere: take a file, or another epoch"));
    const std::vector<double> times_s = computed_times();
    const std::vector<radar::OrbitState> states = radar::states_under_j2(start, times_s);
    radar::StateSamples samples;
    for (std::size_t i = 0; i < states.size(); ++i) {
      const radar::StateVector state = over_earth(states[i], times_s[i]);
      const bool needed = times_s[i] >= needed_.first_s && times_s[i] <= needed_.last_s;
      if (needed && height_of(state.position_m) < 0.0)
        return refuse(core::error("the orbit meets the ground within the recordings")
                          .found(fmt::format("{} at {:.0f} s", typed_height(state.position_m), times_s[i]))
                          .expected("a state that stays outside the Earth")
                          .hint(counts_over_earth));
      add(samples, times_s[i], axes_.from_ecef(state), true);
    }
    const auto ellipse = radar::osculating_elements(start);
    warn_of_ellipse(ellipse);
    return made(samples, radar::hermite_degree_7, needed_with_margin(), said_ellipse(ellipse));
  }

 private:
  static constexpr const char* counts_over_earth =
      "the velocity counts over the turning Earth: what stars see differs by up to 520 m/s on a low orbit";

  // What does not turn agrees with the Earth at time 0.
  static radar::StateVector over_earth(const radar::OrbitState& state, double time_s) {
    return radar::turning_about_z(std::remainder(radar::earth_rate_rad_per_s * time_s, 2.0 * core::pi),
                                  radar::earth_rate_rad_per_s)
        .to({state.position_m, state.velocity_mps});
  }

  static double height_of(const core::Vec3& ecef_m) { return radar::geodetic_of(ecef_m).height_m; }
  static std::string typed_height(const core::Vec3& ecef_m) {
    return fmt::format("{:.3f} km above the ellipsoid", 1e-3 * height_of(ecef_m));
  }

  static double perigee_m(const radar::KeplerElements& ellipse) {
    return ellipse.semi_major_axis_m * (1.0 - ellipse.eccentricity);
  }

  void warn_of_ellipse(const std::optional<radar::KeplerElements>& ellipse) {
    const auto warn = [&](std::string message, std::string found, std::string expected) {
      problems_.push_back(core::warning("orbit.implausible-state", std::move(message))
                              .found(std::move(found))
                              .expected(std::move(expected))
                              .hint(counts_over_earth)
                              .at("", 0, "state_velocity_mps"));
    };
    if (!ellipse)
      warn("the state belongs to no orbit: it leaves the Earth or falls straight down",
           fmt::format("{:.3f} m/s", core::norm(platform_.state_velocity_mps)), "the velocity of a satellite");
    else if (!(perigee_m(*ellipse) > radar::wgs84_semi_major_m))
      warn("the orbit comes down to the ground: its perigee is inside the Earth",
           fmt::format("{:.1f} km from the centre", 1e-3 * perigee_m(*ellipse)), "more than 6378.137 km");
  }

  static std::string said_ellipse(const std::optional<radar::KeplerElements>& ellipse) {
    if (!ellipse) return "from a state, under gravity with J2";
    return fmt::format(
        "from a state, under gravity with J2: {:.1f} to {:.1f} km from the centre, inclination {:.4f} deg",
        1e-3 * perigee_m(*ellipse), 1e-3 * ellipse->semi_major_axis_m * (1.0 + ellipse->eccentricity),
        ellipse->inclination_rad * core::deg_per_rad);
  }

  std::shared_ptr<const scene::ReadPath> refuse(core::Problem problem) {
    problems_.push_back(std::move(problem));
    return nullptr;
  }

  static core::Problem no_earth(std::string_view what) {
    return core::error(fmt::format("{} needs the Earth, but the world is flat", what))
        .expected("[world] with frame = \"earth\" and an anchor");
  }

  static void add(radar::StateSamples& samples, double time_s, const radar::StateVector& state, bool with_velocity) {
    samples.time_s.push_back(time_s);
    samples.position_m.push_back(state.position_m);
    if (with_velocity) samples.velocity_mps.push_back(state.velocity_mps);
  }

  [[nodiscard]] radar::TimeSpan needed_with_margin() const {
    return {needed_.first_s - state_margin_s, needed_.last_s + state_margin_s};
  }

  // Times for which states are computed: some more than are needed, for the polynomials at the ends.
  [[nodiscard]] std::vector<double> computed_times() const {
    const radar::TimeSpan span = needed_with_margin();
    const double spacing_s =
        std::max(state_spacing_s, (span.last_s - span.first_s) / static_cast<double>(max_states / 2));
    const auto steps = static_cast<std::size_t>(std::ceil((span.last_s - span.first_s) / spacing_s)) + 8;
    std::vector<double> times;
    for (std::size_t i = 0; i < steps; ++i) times.push_back(span.first_s + (static_cast<double>(i) - 4.0) * spacing_s);
    return times;
  }

  std::shared_ptr<const scene::ReadPath> made(const radar::StateSamples& samples,
                                              const radar::StateInterpolation& interpolation,
                                              const radar::TimeSpan& usable, std::string description) {
    auto table = radar::StateTable::from(samples, interpolation, largest_gap_s(samples.time_s));
    if (auto* const problem = std::get_if<core::Problem>(&table)) {
      problem->message = fmt::format("{}: {}", platform_.ephemeris_file, problem->message);
      return refuse(std::move(*problem));
    }
    auto path = std::make_shared<scene::ReadPath>();
    path->states = std::make_shared<const radar::StateTable>(std::get<radar::StateTable>(std::move(table)));
    const radar::TimeSpan covered{path->states->spans().front().first_s, path->states->spans().back().last_s};
    path->usable = {std::max(usable.first_s, covered.first_s), std::min(usable.last_s, covered.last_s)};
    path->description = std::move(description);
    if (const auto gap = gap_in(path->states->spans()))
      return refuse(core::error(fmt::format("the states of {} have a gap", platform_.ephemeris_file))
                        .found(said(*gap))
                        .expected("states evenly spaced over the recordings")
                        .hint(no_way_over_gaps));
    if (needed_.last_s > needed_.first_s &&
        (path->usable.first_s > needed_.first_s || path->usable.last_s < needed_.last_s))
      return refuse(core::error(fmt::format("{} does not cover the recordings", platform_.ephemeris_file))
                        .found(said(path->usable))
                        .expected(said(needed_))
                        .hint("change the epoch or the times of the recordings, or take another file"));
    return path;
  }

  // The first gap between spans that touches the times that are needed.
  [[nodiscard]] std::optional<radar::TimeSpan> gap_in(const std::vector<radar::TimeSpan>& spans) const {
    for (std::size_t i = 1; i < spans.size(); ++i) {
      const radar::TimeSpan gap{spans[i - 1].last_s, spans[i].first_s};
      if (gap.first_s <= needed_.last_s && gap.last_s >= needed_.first_s) return gap;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::string said(const radar::TimeSpan& span) const { return typed_times(span, axes_); }

  bool expect_epoch(std::string_view first) {
    if (axes_.epoch()) return true;
    problems_.push_back(core::error(fmt::format("{} has dates, but the scene has no epoch", platform_.ephemeris_file))
                            .expected("[world] with epoch = the UTC of time 0")
                            .hint(first.empty() ? std::string() : fmt::format("the file begins at {}", first)));
    return false;
  }

  std::shared_ptr<const scene::ReadPath> of_states(const FileText& file, scene::OrbitFormat format) {
    scene::EphemerisReading reading =
        scene::read_ephemeris(file.text, file.path, {platform_.satellite, !axes_.earth()});
    const bool broken = core::has_errors(reading.problems);
    core::append(problems_, std::move(reading.problems));
    if (broken) return nullptr;
    const scene::EphemerisFile& states = reading.file;
    const bool is_table = format == scene::OrbitFormat::csv;
    warn_of_satellite(format);
    if (!axes_.earth() && !is_table) return refuse(no_earth(fmt::format("the orbit in {}", platform_.ephemeris_file)));
    const bool dated = states.form == scene::TimeForm::civil;
    if (dated && !expect_epoch(radar::format_civil(states.segments.front().states.front().time))) return nullptr;
    std::vector<radar::TimeSpan> spans;
    std::shared_ptr<const scene::ReadPath> last;
    core::Problems of_segments;
    for (const scene::EphemerisSegment& segment : states.segments) {
      const auto span = usable_of(segment, states);
      if (!span) return nullptr;
      const bool fits = span->first_s <= needed_.first_s && span->last_s >= needed_.last_s;
      spans.push_back(*span);
      if (!fits && states.segments.size() > 1) continue;
      return of_segment(segment, *span, states, format);
    }
    const radar::TimeSpan all{spans.front().first_s, spans.back().last_s};
    return refuse(
        core::error(fmt::format("no segment of {} covers the recordings", platform_.ephemeris_file))
            .found(fmt::format("{} segments, {}", spans.size(), said(all)))
            .expected(said(needed_))
            .hint("segments are not interpolated into each other; change the epoch or the times of the recordings"));
  }

  // The satellite also chooses among those of a file of attitudes.
  void warn_of_satellite(scene::OrbitFormat format) {
    const bool holds_one = format == scene::OrbitFormat::csv || format == scene::OrbitFormat::eof;
    if (platform_.satellite.empty() || !holds_one || platform_.rotation_kind == Platform::Rotation::quaternions) return;
    core::Problem problem =
        core::warning("motion-file.needless-satellite",
                      fmt::format("{} holds one path, and the satellite is not looked for", platform_.ephemeris_file))
            .found(platform_.satellite)
            .expected("no satellite beside a Sentinel-1 EOF or a CSV table")
            .hint("remove satellite");
    problem.subject.field = "satellite";
    problems_.push_back(std::move(problem));
  }

  std::optional<double> time_of(const radar::CivilTime& time, radar::TimeScale scale) {
    radar::InstantReading read = radar::instant_of(time, scale, axes_.orientation().dut1_s);
    if (read.instant) return radar::seconds_between(*axes_.epoch(), *read.instant);
    problems_.push_back(core::error(fmt::format("{}: {}", platform_.ephemeris_file, read.failure)));
    return std::nullopt;
  }

  std::optional<radar::TimeSpan> usable_of(const scene::EphemerisSegment& segment, const scene::EphemerisFile& file) {
    if (file.form != scene::TimeForm::civil)
      return radar::TimeSpan{segment.states.front().since_epoch_s, segment.states.back().since_epoch_s};
    const auto first = time_of(segment.usable.start.value_or(segment.states.front().time), file.scale);
    const auto last = first ? time_of(segment.usable.stop.value_or(segment.states.back().time), file.scale) : first;
    if (!last) return std::nullopt;
    return radar::TimeSpan{*first, *last};
  }

  std::shared_ptr<const scene::ReadPath> of_segment(const scene::EphemerisSegment& segment,
                                                    const radar::TimeSpan& usable, const scene::EphemerisFile& file,
                                                    scene::OrbitFormat format) {
    const bool with_velocities = std::ranges::all_of(
        segment.states, [](const scene::EphemerisState& state) { return state.velocity_mps.has_value(); });
    const radar::StateInterpolation interpolation = interpolation_of(platform_, with_velocities);
    if (interpolation.use_velocities && !with_velocities)
      return refuse(core::error(fmt::format("{} has no velocities", platform_.ephemeris_file))
                        .hint("write interpolation = \"lagrange\""));
    radar::StateSamples samples;
    for (const scene::EphemerisState& state : segment.states) {
      std::optional<double> time_s = state.since_epoch_s;
      if (file.form == scene::TimeForm::civil) time_s = time_of(state.time, file.scale);
      if (!time_s) return nullptr;
      const radar::StateVector given{state.position_m, state.velocity_mps.value_or(core::Vec3{})};
      add(samples, *time_s, axes_.from(file.frame, given, *time_s), interpolation.use_velocities);
    }
    if (auto fault = fault_of_step(samples)) return refuse(std::move(*fault));
    auto path = made(samples, interpolation, usable,
                     fmt::format("{}, {} states, {}", scene::name_of(format), segment.states.size(),
                                 axes_.earth() ? std::string(scene::name_of(file.frame)) : std::string("world axes")));
    const auto accuracy = path ? scene::accuracy_between(samples, interpolation, needed_) : std::nullopt;
    if (!accuracy) return path;
    if (accuracy->error > max_error_m)
      return refuse(core::error(fmt::format("{}: between its states the path is not known", platform_.ephemeris_file))
                        .found(fmt::format("about {:.3g} km off near {:.6g} s, with a state every {:.6g} s",
                                           1e-3 * accuracy->error, accuracy->at_s, accuracy->spacing_s))
                        .expected(fmt::format("at most {:g} km", 1e-3 * max_error_m))
                        .hint("use a file with closer states"));
    auto known = std::make_shared<scene::ReadPath>(*path);
    known->accuracy = {accuracy->error, accuracy->at_s, accuracy->spacing_s};
    return known;
  }

  // Positions that are taken once in a while of an orbit are those of many orbits.
  [[nodiscard]] std::optional<core::Problem> fault_of_step(const radar::StateSamples& samples) const {
    constexpr double states_per_turn = 3.0;
    constexpr double min_height_m = 80e3;
    if (!axes_.earth()) return std::nullopt;
    for (std::size_t i = 1; i < samples.time_s.size(); ++i) {
      if (samples.time_s[i] < needed_.first_s || samples.time_s[i - 1] > needed_.last_s) continue;
      const core::Vec3 ecef_m = axes_.earth()->ecef_from_world(samples.position_m[i - 1]);
      if (height_of(ecef_m) < min_height_m) continue;
      const double radius_m = core::norm(ecef_m);
      const double turn_s =
          2.0 * core::pi * std::sqrt(radius_m * radius_m * radius_m / radar::EarthGravity{}.mu_m3_per_s2);
      const double step_s = samples.time_s[i] - samples.time_s[i - 1];
      if (step_s * states_per_turn <= turn_s) continue;
      return core::error(fmt::format("{}: its states are too far apart to tell the orbit", platform_.ephemeris_file))
          .found(fmt::format("a state every {:.6g} s, at a height where a turn takes {:.4g} s", step_s, turn_s))
          .expected(fmt::format("at most {:.4g} s, a third of a turn", turn_s / states_per_turn))
          .hint("use a file with closer states");
    }
    return std::nullopt;
  }

  // The set of elements nearest to time 0.
  static const scene::ElementSet& nearest(const std::vector<scene::ElementSet>& sets, const radar::Instant& epoch) {
    const auto off_s = [&](const scene::ElementSet& set) {
      const auto read = radar::instant_of(set.epoch, radar::TimeScale::utc);
      return read.instant ? std::abs(radar::seconds_between(epoch, *read.instant)) : 1e300;
    };
    return *std::ranges::min_element(sets, {}, off_s);
  }

  std::shared_ptr<const scene::ReadPath> of_elements(const FileText& file, scene::OrbitFormat format) {
    if (!axes_.earth()) return refuse(no_earth(fmt::format("the orbit in {}", platform_.ephemeris_file)));
    scene::MeanElementsReading reading = scene::read_mean_elements(file.text, file.path, {platform_.satellite});
    const bool broken = core::has_errors(reading.problems);
    core::append(problems_, std::move(reading.problems));
    if (broken) return nullptr;
    if (!expect_epoch(radar::format_civil(reading.file.sets.front().epoch))) return nullptr;
    const scene::ElementSet& set = nearest(reading.file.sets, *axes_.epoch());
    if (auto problem = scene::problem_of_other_sets(reading.file.sets, set)) {
      problem->place.file = file.path;
      problems_.push_back(*std::move(problem));
    }
    auto theory = radar::Sgp4::from(set.elements, set.epoch);
    if (auto* const problem = std::get_if<core::Problem>(&theory)) return refuse(std::move(*problem));
    const auto at_s = time_of(set.epoch, radar::TimeScale::utc);
    if (!at_s) return nullptr;
    constexpr double day_s = 86400.0;
    constexpr double usual_days = 7.0;
    const double age_days = std::max(std::abs(needed_.first_s - *at_s), std::abs(needed_.last_s - *at_s)) / day_s;
    if (age_days > usual_days)
      problems_.push_back(
          core::warning("motion-file.old-elements",
                        fmt::format("{}: the mean elements are old", platform_.ephemeris_file))
              .found(fmt::format("{:.1f} days from their epoch {}", age_days, radar::format_civil(set.epoch)))
              .expected(fmt::format("at most {:g} days", usual_days))
              .hint("SGP4 is off by some km each day"));
    radar::StateSamples samples;
    for (const double time_s : computed_times()) {
      const auto state = std::get<radar::Sgp4>(theory).state_at(time_s - *at_s);
      if (const auto* const problem = std::get_if<core::Problem>(&state)) return refuse(*problem);
      const auto& [position_m, velocity_mps] = std::get<radar::OrbitState>(state);
      add(samples, time_s, axes_.from(scene::Frame::teme, {position_m, velocity_mps}, time_s), false);
    }
    return made(samples, radar::lagrange_8_points, needed_with_margin(),
                fmt::format("{}, SGP4 from {}", scene::name_of(format), radar::format_civil(set.epoch)));
  }

  const Platform& platform_;
  core::Problems& problems_;
  radar::TimeSpan needed_;
  WorldAxes axes_;
};

}  // namespace

std::string typed_times(const radar::TimeSpan& span, const WorldAxes& axes) {
  if (!axes.epoch()) return fmt::format("{:.3f} s to {:.3f} s", span.first_s, span.last_s);
  const auto date = [&](double time_s) {
    return radar::format_instant(radar::later(*axes.epoch(), time_s), radar::TimeScale::utc, 3);
  };
  return fmt::format("{} to {} ({:.3f} s to {:.3f} s)", date(span.first_s), date(span.last_s), span.first_s,
                     span.last_s);
}

std::shared_ptr<const scene::ReadPath> path_of_platform(const scene::Scene& scene, const scene::Platform& platform,
                                                        const std::optional<FileText>& file, core::Problems& problems) {
  PathMaker maker(scene, platform, problems);
  return file                                            ? maker.of_file(*file)
         : platform.path == scene::Platform::Path::orbit ? maker.of_orbit()
                                                         : maker.of_state();
}

}  // namespace sarsim::workflow
