#include "workflow/stepped/isar_scene.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "radar/path/path.hpp"
#include "signal/sar/autofocus.hpp"
#include "signal/stepped/stepped_limits.hpp"
#include "signal/stepped/stepped_overlay.hpp"
#include "signal/stepped/velocity_search.hpp"

namespace sarsim::workflow {

namespace {

// Below this the turning during all bursts is taken for none.
constexpr double min_turn_rad = 1e-6;
constexpr double max_pixels = 0x1p26;

// What the image is made from, besides the echoes.
struct IsarPlan {
  std::vector<signal::TrackPoint> seen;
  signal::IsarPlane plane;
  signal::ImageAxis cross_range;
  double from_m = 0.0;  // of the profiles
  double to_m = 0.0;
};

// A turning that is given takes the place of the scene's: the same plane, another angle for each pulse.
void take_turn_rate(signal::IsarPlane& plane, const std::vector<signal::TrackPoint>& seen, double rate_radps) {
  const double middle_s = seen[seen.size() / 2].time_s;
  for (std::size_t p = 0; p < seen.size(); ++p) plane.lever[p] = std::sin(rate_radps * (seen[p].time_s - middle_s));
  plane.rate_radps = std::abs(rate_radps);
  plane.turn_rad = plane.rate_radps * (seen.back().time_s - seen.front().time_s);
}

// Where the first-order image shows a point of the target's frame: the straight line through its distances, less those
// of the centre, against the lever.
signal::ImagePlace first_order_place(const IsarPlan& plan, const core::Vec3& point_m) {
  double n = 0.0, sx = 0.0, sxx = 0.0, sy = 0.0, sxy = 0.0;
  for (std::size_t p = 0; p < plan.seen.size(); ++p) {
    const core::Vec3& antenna = plan.seen[p].position_m;
    const double x = plan.plane.lever[p];
    const double y = core::norm(antenna - point_m) - core::norm(antenna);
    n += 1.0, sx += x, sxx += x * x, sy += y, sxy += x * y;
  }
  const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  return {slope, (sy - slope * sx) / n};
}

signal::ImagePlace place_in_plane(const IsarPlan& plan, const IsarOptions& options, const core::Vec3& point_m) {
  if (options.algorithm == IsarOptions::Algorithm::range_doppler && plan.plane.turn_rad > min_turn_rad)
    return first_order_place(plan, point_m);
  return {core::dot(point_m, plan.plane.cross_range), core::dot(point_m, plan.plane.range)};
}

// Half of the size of the picture that holds all points of the target, with some room.
signal::ImagePlace half_size(const SteppedRows& rows, const IsarPlan& plan, const IsarOptions& options, double cell_x_m,
                             double cell_y_m) {
  // Where the target is across the line of sight is not known without its path.
  const double aside_m = (options.motion == IsarOptions::Motion::estimated ? 36.0 : 12.0) * cell_x_m;
  signal::ImagePlace half{aside_m, 12.0 * cell_y_m};
  const simulate::ResolvedScene& scene = *rows.acquisition->scene;
  const auto include = [&](const core::Vec3& point_m) {
    half.azimuth_m = std::max(half.azimuth_m, std::abs(core::dot(point_m, plan.plane.cross_range)) + aside_m);
    half.range_m = std::max(half.range_m, std::abs(core::dot(point_m, plan.plane.range)) + 12.0 * cell_y_m);
  };
  for (const simulate::Scatterer& s : scene.scatterers)
    if (s.platform == options.platform) include(s.position_m);
  for (const simulate::ScattererSheet& sheet : scene.sheets)
    if (sheet.platform == options.platform)
      for (const core::Vec3& point : sheet.points_m) include(point);
  if (options.cross_range_m) half.azimuth_m = 0.5 * *options.cross_range_m;
  if (options.range_m) half.range_m = 0.5 * *options.range_m;
  return half;
}

void add_remarks(IsarImage& made, const IsarPlan& plan, const IsarOptions& options, const signal::ImagePlace& half,
                 double wavelength_m) {
  if (plan.plane.turn_rad <= min_turn_rad) {
    made.problems.push_back(
        core::error("the target does not rotate relative to the line of sight: there is no cross-range resolution")
            .found(fmt::format("{:.3g} degrees", core::deg_per_rad * plan.plane.turn_rad))
            .expected("a target that turns or flies past")
            .hint("choose the target's --platform, record for longer, or give --turn-rate"));
    return;
  }
  const double pixels = 4.0 * half.azimuth_m * half.range_m /
                        (made.cross_range_resolution_m * made.range_resolution_m) *
                        static_cast<double>(options.oversampling * options.oversampling);
  if (!(half.azimuth_m > 0.0 && half.range_m > 0.0) || !(pixels < max_pixels)) {
    made.problems.push_back(core::error("the image cannot be made this large")
                                .found(fmt::format("{:.4g} m x {:.4g} m", 2.0 * half.azimuth_m, 2.0 * half.range_m))
                                .expected("above 0, and fewer than 67 million pixels")
                                .hint("choose another --cross-range, --range or --oversampling"));
    return;
  }
  if (2.0 * half.azimuth_m > made.unambiguous_cross_range_m)
    made.problems.push_back(core::warning("isar.cross-range-ambiguous",
                                          "the image exceeds the unambiguous cross-range: points appear more than once")
                                .found(fmt::format("{:.4g} m", 2.0 * half.azimuth_m))
                                .expected(fmt::format("up to {:.4g} m", made.unambiguous_cross_range_m))
                                .hint("repeat bursts faster, or choose a smaller --cross-range"));
  const double quadratic = 0.5 * half.range_m * plan.plane.turn_rad * plan.plane.turn_rad / wavelength_m;
  if (options.algorithm == IsarOptions::Algorithm::range_doppler && quadratic > 0.5)
    made.problems.push_back(
        core::warning("isar.turns-too-far", "the target rotates so far that points away from its centre blur")
            .found(fmt::format("{:.3g} degrees, {:.3g} pi of phase at the edge",
                               core::deg_per_rad * plan.plane.turn_rad, quadratic))
            .expected("half of pi")
            .hint("use fewer --bursts, or --algorithm back-projection"));
}

IsarPlan plan_of(const SteppedRows& rows, std::size_t first, std::size_t count, const IsarOptions& options,
                 IsarImage& made) {
  const signal::SteppedBand& band = *rows.band;
  IsarPlan plan;
  plan.seen = seen_from_platform(rows, options.platform, first, count);
  plan.plane = signal::plane_of(plan.seen);
  if (options.turn_rate_radps) take_turn_rate(plan.plane, plan.seen, *options.turn_rate_radps);
  const double c = band.waveform().light_speed_mps;
  const double wavelength_m = radar::wavelength_of(band.centre_hz(), c);
  const std::vector<signal::PulseMotion> motion = signal::motion_of_origin(plan.seen, c);
  made.from_s = plan.seen.front().time_s;
  made.to_s = plan.seen.back().time_s;
  made.speed_mps = motion[motion.size() / 2].speed_mps;
  made.range_m = plan.plane.range_m;
  made.turn_rad = plan.plane.turn_rad;
  made.range_resolution_m = radar::range_of_cycle(band.band_hz(), c);
  const auto bursts = static_cast<double>(count);
  // Each burst stands for its part of the turning.
  made.cross_range_resolution_m = 0.5 * wavelength_m / (plan.plane.turn_rad * bursts / std::max(1.0, bursts - 1.0));
  made.unambiguous_cross_range_m = made.cross_range_resolution_m * bursts;
  signal::ImagePlace half = half_size(rows, plan, options, made.cross_range_resolution_m, made.range_resolution_m);
  if (options.motion == IsarOptions::Motion::estimated && !options.cross_range_m)
    half.azimuth_m = std::min(half.azimuth_m, 0.5 * made.unambiguous_cross_range_m);
  add_remarks(made, plan, options, half, wavelength_m);
  if (core::has_errors(made.problems)) return plan;
  const double pixel_m = made.cross_range_resolution_m / static_cast<double>(options.oversampling);
  const double rows_aside = std::ceil(half.azimuth_m / pixel_m);
  plan.cross_range = {-rows_aside * pixel_m, pixel_m, static_cast<std::size_t>(2.0 * rows_aside) + 1, 0.0};
  plan.from_m = made.range_m - half.range_m;
  plan.to_m = made.range_m + half.range_m;
  for (std::size_t t = 0; t < rows.acquisition->scene->scatterers.size(); ++t) {
    const simulate::Scatterer& s = rows.acquisition->scene->scatterers[t];
    if (s.platform == options.platform)
      made.points.push_back({t, place_in_plane(plan, options, s.position_m), 0.0, {}});
  }
  return plan;
}

void set_amplitudes(IsarImage& made, const SteppedRows& rows, std::size_t first, std::size_t count) {
  const std::vector<BurstTruth> truth = truth_of_burst(rows, first + count / 2);
  for (HeldPoint& point : made.points) point.amplitude = truth[point.target].amplitude;
}

// Without the path only differences of places are known.
void lay_upon_image(IsarImage& made) {
  std::vector<signal::OverlayPoint> points;
  points.reserve(made.points.size());
  for (const HeldPoint& point : made.points) points.push_back({point.expected, point.amplitude});
  const auto shift =
      signal::shift_upon_image(made.image, points, {made.cross_range_resolution_m, made.range_resolution_m});
  if (!shift) return;
  for (HeldPoint& point : made.points) {
    point.expected.azimuth_m += shift->azimuth_m;
    point.expected.range_m += shift->range_m;
  }
}

bool is_within(const signal::ImageAxis& axis, double place_m) {
  const double at = axis.index_of(place_m);
  return at >= -0.5 && at < static_cast<double>(axis.count) - 0.5;
}

void find_points(IsarImage& made) {
  made.points.resize(std::min(made.points.size(), max_held_targets));
  const signal::ImageReader reader = signal::reader_of(made.image);
  for (HeldPoint& point : made.points) {
    point.outside = !is_within(made.image.azimuth, point.expected.azimuth_m) ||
                    !is_within(made.image.range, point.expected.range_m);
    if (point.outside) continue;
    double search_m = 3.0 * std::min(made.cross_range_resolution_m, made.range_resolution_m);
    for (const HeldPoint& other : made.points)
      if (other.target != point.target)
        search_m = std::min(search_m, 0.5 * std::hypot(other.expected.azimuth_m - point.expected.azimuth_m,
                                                       other.expected.range_m - point.expected.range_m));
    point.found =
        signal::measure_point(made.image, reader, point.expected,
                              std::max(search_m, std::max(made.image.azimuth.step_m, made.image.range.step_m)));
  }
}

// Whether no other point as strong as a tenth of it is within two cells.
bool stands_alone(const IsarImage& made, const HeldPoint& point) {
  constexpr double cells = 2.0;
  return std::ranges::none_of(made.points, [&](const HeldPoint& other) {
    return other.target != point.target && other.amplitude > 0.1 * point.amplitude &&
           std::abs(other.expected.azimuth_m - point.expected.azimuth_m) < cells * made.cross_range_resolution_m &&
           std::abs(other.expected.range_m - point.expected.range_m) < cells * made.range_resolution_m;
  });
}

// What the estimate of the motion leaves shows at the strongest point that was found, if it is one alone.
void remark_on_loss(IsarImage& made) {
  constexpr double max_db = 0.1;
  const HeldPoint* strongest = nullptr;
  for (const HeldPoint& point : made.points)
    if (point.found && (strongest == nullptr || point.amplitude > strongest->amplitude)) strongest = &point;
  if (strongest == nullptr || !(strongest->amplitude > 0.0) || !stands_alone(made, *strongest)) return;
  const double lost_db = -core::amplitude_db(strongest->found->amplitude / strongest->amplitude);
  if (!(lost_db > max_db)) return;
  made.losses.push_back(
      core::warning(
          "isar.motion-residual",
          fmt::format("the estimated motion leaves target {}, the strongest, {:.2g} dB below its expected peak",
                      strongest->target + 1, lost_db))
          .expected(fmt::format("at most {:g} dB", max_db))
          .hint("use --motion scene, or fewer or more --bursts"));
}

signal::WindowFunction over_unit(const signal::SarWindow& window) {
  if (window.kind == signal::SarWindow::Kind::rectangular) return {};
  return [weight = signal::weight_of(window)](double x) { return weight(x - 0.5); };
}

// A window of few cells smooths the phase over much of the aperture: it sees little of a phase that bends slowly, such
// as an acceleration that changes leaves, and each round corrects a small part of it.
signal::AutofocusOptions autofocus_of(const IsarOptions& options) {
  constexpr std::size_t cells = 8;
  return {.rounds = 40, .enough_rad = 0.002, .min_window = cells * options.oversampling + 1};
}

std::vector<signal::PulseMotion> motion_for(const signal::ProfileMaker& maker, const signal::BurstEchoes& echoes,
                                            const IsarPlan& plan, const IsarOptions& options, IsarImage& made,
                                            const core::WorkControl& control) {
  const double c = maker.band().waveform().light_speed_mps;
  if (options.motion == IsarOptions::Motion::scene) return signal::motion_of_origin(plan.seen, c);
  made.speed_mps =
      signal::estimate_velocity(maker, echoes, -options.fastest_mps, options.fastest_mps, control).speed_mps;
  return signal::motion_of_speed(echoes.time_s, plan.seen[plan.seen.size() / 2].time_s, made.speed_mps, c);
}

}  // namespace

IsarImage plan_isar_image(const SteppedRows& rows, std::size_t first, std::size_t count, const IsarOptions& options) {
  IsarImage made;
  const IsarPlan plan = plan_of(rows, first, count, options, made);
  made.image.azimuth = plan.cross_range;
  return made;
}

IsarImage make_isar_image(const SteppedRows& rows, std::size_t first, std::size_t count, const IsarOptions& options,
                          const core::WorkControl& control, const core::ProgressReport& progress) {
  IsarImage made;
  const IsarPlan plan = plan_of(rows, first, count, options, made);
  if (core::has_errors(made.problems)) throw std::invalid_argument(made.problems.front().message);
  const signal::ProfileMaker maker(*rows.band, over_unit(options.range_window), plan.from_m, plan.to_m,
                                   options.oversampling);
  const signal::BurstEchoes echoes = read_bursts(rows, first, count, control);
  const std::vector<signal::PulseMotion> motion = motion_for(maker, echoes, plan, options, made, control);
  const signal::IsarEchoes all{echoes.values, motion, over_unit(options.azimuth_window)};
  made.image =
      options.algorithm == IsarOptions::Algorithm::back_projection
          ? signal::isar_back_projection(maker, all, plan.seen, plan.plane, plan.cross_range, control, progress)
          : signal::isar_range_doppler(maker, all, plan.plane, plan.cross_range, control, progress);
  if (options.autofocus) made.image = signal::autofocus(made.image, autofocus_of(options), control).image;
  set_amplitudes(made, rows, first, count);
  if (options.motion == IsarOptions::Motion::estimated) lay_upon_image(made);
  find_points(made);
  if (options.motion == IsarOptions::Motion::estimated) remark_on_loss(made);
  return made;
}

}  // namespace sarsim::workflow
