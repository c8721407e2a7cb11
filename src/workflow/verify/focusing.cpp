#include <cmath>
#include <complex>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "signal/measure/image_quality.hpp"
#include "signal/sar/back_projection.hpp"
#include "workflow/focus/sar_rows.hpp"
#include "workflow/focus/sar_theory.hpp"
#include "workflow/focus/seen_spectrum.hpp"
#include "workflow/verify/groups.hpp"
#include "workflow/verify/response.hpp"
#include "workflow/verify/scenes.hpp"

namespace sarsim::workflow::verify {

namespace {

constexpr double focusing_carrier_hz = 5.3e9;
constexpr double prf_hz = 600.0;
constexpr core::Vec3 target_m{3.0, -31.0, 0.0};

// Thesis 7.1: an aircraft 2000 m high at 200 m/s along y, the target 10 km away along x; 100 MHz and 800 ns.
scene::Scene strip() {
  scene::Scene scene = radar_at_origin();
  add_mover(scene, "Plane", {-10000.0, 0.0, 2000.0}, {0.0, 200.0, 0.0});
  scene::Radar& radar = scene.radars[0];
  radar.platform = "Plane";
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.bandwidth_hz = 100e6;
  radar.pulse_width_s = 800e-9;
  radar.prf_hz = prf_hz;
  radar.carrier_hz = focusing_carrier_hz;
  add_target(scene, target_m);
  set_window(scene, 10098.0, 10298.0, 150e6);
  scene.simulations[0].time_start_s = -1.0;
  scene.simulations[0].time_end_s = 1.0 - 0.5 / prf_hz;
  return scene;
}

struct Echoes {
  std::shared_ptr<const simulate::Acquisition> acquisition;
  signal::EchoRows rows;
};

// The same flight, climbing by 5 degrees, blown to and fro by 3 m and up and down by 2 m.
scene::Scene blown_strip() {
  scene::Scene scene = strip();
  auto& path = scene.platforms.back().trajectory_m.part;
  for (auto& part : path) part = {core::Interpolation::cubic, {}};
  for (int i = -30; i <= 30; ++i) {
    const double t = 0.05 * i;
    path[0].knots.push_back({t, -10000.0 + 3.0 * std::sin(4.1 * t)});
    path[1].knots.push_back({t, 200.0 * t});
    path[2].knots.push_back({t, 2000.0 + 200.0 * std::tan(5.0 / core::deg_per_rad) * t + 2.0 * std::cos(5.3 * t)});
  }
  return scene;
}

// A drone's radar of 300 MHz and half of that as bandwidth, 500 m from the target and past it by 300 m on both sides.
scene::Scene low_band(double nearest_m) {
  constexpr double low_prf_hz = 400.0;
  scene::Scene scene = radar_at_origin();
  add_mover(scene, "Drone", {0.0, 0.0, 0.0}, {100.0, 0.0, 0.0});
  scene::Radar& radar = scene.radars[0];
  radar.platform = "Drone";
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.bandwidth_hz = 150e6;
  radar.pulse_width_s = 1e-6;
  radar.prf_hz = low_prf_hz;
  radar.carrier_hz = 300e6;
  add_target(scene, {0.0, 500.0, 0.0});
  set_window(scene, nearest_m, 1000.0, 300e6);
  scene.simulations[0].time_start_s = -3.0;
  scene.simulations[0].time_end_s = 3.0;
  return scene;
}

Echoes recorded_echoes(scene::Scene scene) {
  const simulate::Acquisition window = simulate::acquisition_of(scene, 0);
  scene.simulations[0] = recorded_for_sar(scene.simulations[0], window);
  auto acquisition = std::make_shared<const simulate::Acquisition>(simulate::acquisition_of(scene, 0));
  signal::EchoRows rows = sar_rows_of_scene(acquisition, window.reception.columns);
  return {std::move(acquisition), std::move(rows)};
}

void measure_cut(Record& record, const std::string& name, const std::optional<signal::ResponseFigures>& theory,
                 const signal::ResponseFigures& found) {
  if (!theory) throw std::runtime_error("there is no theory of the " + name);
  record.near(name + ": half-power width", "m", theory->width, found.width, 0.01 * theory->width,
              "docs/theory/focusing.md");
  record.near(name + ": peak side lobe", "dB", theory->pslr_db, found.pslr_db, 0.2, "docs/theory/focusing.md");
  record.near(name + ": integrated side lobes", "dB", theory->islr_db, found.islr_db, 0.3, "docs/theory/focusing.md");
}

// As many samples on either side of a place.
signal::ImageAxis about(const signal::ImageAxis& axis, double place_m, std::size_t reach) {
  signal::ImageAxis part = axis;
  part.first_m = axis.at(std::round(axis.index_of(place_m)) - static_cast<double>(reach));
  part.count = 2 * reach + 1;
  return part;
}

signal::FocusedImage back_projected_strip(const Echoes& echoes, signal::FocusedImage axes, const core::Vec3& point_m,
                                          const core::WorkControl& control) {
  const signal::ImagePlace place = signal::place_of(axes.frame, point_m);
  const core::Vec3 across = point_m - axes.frame.origin_m - place.azimuth_m * axes.frame.along;
  axes.frame.across = (1.0 / core::norm(across)) * across;
  return signal::back_project(signal::sar_echoes(echoes.rows, control), axes.frame,
                              about(axes.azimuth, place.azimuth_m, 80), about(axes.range, place.range_m, 40), {},
                              control);
}

// A slant grid is made of points of level ground, off the middle of the scene too.
void measure_ground(Record& record) {
  const Echoes echoes = recorded_echoes(blown_strip());
  const TargetTheory theory = theory_of_targets(*echoes.acquisition, echoes.rows, {}, true).at(0);
  const core::WorkControl control{2, record.rules().stop};
  signal::FocusedImage axes = signal::image_of(echoes.rows, {});
  axes.frame.across = {1.0, 0.0, 0.0};
  const signal::ImagePlace place = signal::place_of(axes.frame, target_m);
  // 160 m of swath: in a plane through its middle the target would be off by metres.
  signal::ImageAxis range = axes.range;
  range.first_m = place.range_m - 160.0 * range.step_m;
  range.count = 190;
  signal::ImageAxis azimuth = axes.azimuth;
  azimuth.first_m = place.azimuth_m - 40.0 * azimuth.step_m;
  azimuth.count = 81;
  signal::BackProjectionOptions options;
  options.ground_m = 0.0;
  const signal::FocusedImage image =
      signal::back_project(signal::sar_echoes(echoes.rows, control), axes.frame, azimuth, range, options, control);
  const std::complex<double> found(image.values[40 * range.count + 160]);
  const double expected_rad =
      wrapped_rad(-4.0 * core::pi * focusing_carrier_hz * place.range_m / core::exact_light_speed_mps);
  const std::string name = "Back-projection from a track that climbs and sways";
  record.near(name + ": error of the phase", "rad", 0.0, wrapped_rad(std::arg(found) - expected_rad), 0.01,
              "docs/theory/back-projection.md");
  record.near(name + ": amplitude over the mean of the echoes", "", 1.0, std::abs(found) / theory.amplitude, 0.01,
              "docs/theory/back-projection.md");
}

void measure_method(Record& record, const Echoes& echoes, std::optional<signal::FocusMethod> method,
                    const TargetTheory& theory, const std::string& name) {
  const signal::FocusOptions options{.method = method.value_or(signal::FocusMethod::omega_k)};
  const core::WorkControl control{2, record.rules().stop};
  const signal::FocusedImage image =
      method ? signal::focus(signal::sar_echoes(echoes.rows, control), options, control)
             : back_projected_strip(echoes, signal::image_of(echoes.rows, {}), target_m, control);
  const signal::ImagePlace place = signal::place_of(image.frame, target_m);
  // The track passes the target at this distance, whatever the frame says.
  const double closest_m = std::hypot(10000.0 + target_m.x, 2000.0);
  const auto found = signal::measure_point(image, signal::reader_of(image), place, 2.0);
  if (!found) throw std::runtime_error("the target is not in the image made by " + name);
  record.near(name + ": range of the target", "m", closest_m, found->place.range_m, 0.03, "closest approach");
  // A hundredth of the width: what a radar that stops while its pulse travels would shift is twice that.
  record.near(name + ": azimuth of the target", "m", place.azimuth_m, found->place.azimuth_m, 0.0064,
              "where the track passes it");
  const double expected_rad =
      wrapped_rad(-4.0 * core::pi * focusing_carrier_hz * closest_m / core::exact_light_speed_mps);
  record.near(name + ": error of the phase", "rad", 0.0, wrapped_rad(found->phase_rad - expected_rad), 0.01,
              "-4 pi f R0/c");
  record.near(name + ": amplitude over the mean of the echoes", "", 1.0, found->amplitude / theory.amplitude, 0.01,
              "docs/theory/focusing.md");
  measure_cut(record, name + ", range", theory.range, found->range);
  measure_cut(record, name + ", azimuth", theory.azimuth, found->azimuth);
}

// The near edge of the window decides which directions the nearest column is seen in: not how strong an image is.
void measure_near_edges(Record& record) {
  constexpr double most = 0.0116;  // 0.1 dB
  const core::WorkControl control{2, record.rules().stop};
  for (const double nearest_m : {490.0, 300.0, 20.0}) {
    const Echoes echoes = recorded_echoes(low_band(nearest_m));
    signal::FocusOptions options;
    options.spectrum = seen_spectrum(*echoes.acquisition, echoes.rows, {}, SeenPulses::sampled, control);
    const double expected = theory_of_targets(*echoes.acquisition, echoes.rows, options).at(0).amplitude;
    const signal::FocusedImage image = signal::focus(signal::sar_echoes(echoes.rows, control), options, control);
    const auto found = signal::measure_point(image, signal::reader_of(image), {0.0, 500.0}, 2.0);
    if (!found) throw std::runtime_error("the target is not in the image of a wide band");
    record.near(
        fmt::format("Omega-k, half the carrier as bandwidth, window from {} m: amplitude over the mean of the echoes",
                    nearest_m),
        "", 1.0, found->amplitude / expected, most, "docs/theory/focusing.md");
  }
}

// An aperture of 26 degrees at 1 GHz, a band of 10 MHz: the angles fill three times the range of wave numbers that the
// band does.
constexpr double wide_carrier_hz = 1e9;
constexpr double wide_band_hz = 10e6;
constexpr double wide_closest_m = 2000.0;
constexpr double wide_half_rad = 13.0 * core::pi / 180.0;
constexpr core::Vec3 wide_target_m{0.0, 0.0, 0.0};

scene::Scene wide_strip() {
  scene::Scene scene = radar_at_origin();
  constexpr double speed_mps = 100.0;
  constexpr double wide_prf_hz = 400.0;
  add_mover(scene, "Plane", {-0.8 * wide_closest_m, 0.0, 0.6 * wide_closest_m}, {0.0, speed_mps, 0.0});
  scene::Radar& radar = scene.radars[0];
  radar.platform = "Plane";
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.bandwidth_hz = wide_band_hz;
  radar.pulse_width_s = 10e-6;
  radar.prf_hz = wide_prf_hz;
  radar.carrier_hz = wide_carrier_hz;
  add_target(scene, wide_target_m);
  set_window(scene, wide_closest_m - 600.0, wide_closest_m + 900.0, 1.5 * wide_band_hz);
  const double half_s = wide_closest_m * std::tan(wide_half_rad) / speed_mps;
  scene.simulations[0].time_start_s = -half_s;
  scene.simulations[0].time_end_s = half_s;
  return scene;
}

// The range response of an even band seen from places evenly along the line, by its definition: the sum of
// exp(2 pi j K cos(a) r) over the wave numbers 2 f/c of the band and the directions a of the places.
Response annulus_response() {
  constexpr int looks = 801;
  constexpr int frequencies = 65;
  constexpr int half = 1500;
  constexpr double step_m = 0.02;
  Response response;
  response.peak = half;
  response.step_s = step_m;  // of range here
  for (int i = -half; i <= half; ++i) {
    std::complex<double> sum;
    for (int l = 0; l < looks; ++l) {
      const double along = std::tan(wide_half_rad) * (2.0 * l / (looks - 1.0) - 1.0);
      const double cosine = 1.0 / std::sqrt(1.0 + along * along);
      const auto wave_number = [&](double share) {
        return 2.0 * (wide_carrier_hz + (share - 0.5) * wide_band_hz) / core::exact_light_speed_mps * cosine;
      };
      const double way_m = step_m * i;
      std::complex<double> term = std::polar(1.0, 2.0 * core::pi * wave_number(0.5 / frequencies) * way_m);
      const std::complex<double> turn =
          std::polar(1.0, 2.0 * core::pi * (wave_number(1.0 / frequencies) - wave_number(0.0)) * way_m);
      for (int f = 0; f < frequencies; ++f, term *= turn) sum += term;
    }
    response.amplitude.push_back(std::abs(sum));
  }
  return response;
}

void measure_wide_aperture(Record& record) {
  const core::WorkControl control{2, record.rules().stop};
  const Echoes echoes = recorded_echoes(wide_strip());
  signal::FocusedImage axes = signal::image_of(echoes.rows, {});
  axes.range.step_m *= 0.25;  // The directions widen the band four times.
  axes.range.count *= 4;
  const signal::ImagePlace place = signal::place_of(axes.frame, wide_target_m);
  const double middle_cosine = 0.5 * (1.0 + std::cos(wide_half_rad));
  axes.range.spectrum_centre_per_m = 2.0 * wide_carrier_hz / core::exact_light_speed_mps * (middle_cosine - 1.0);
  const signal::FocusedImage image = back_projected_strip(echoes, std::move(axes), wide_target_m, control);
  const auto found = signal::measure_point(image, signal::reader_of(image), place, 2.0);
  if (!found) throw std::runtime_error("the target is not in the image of a wide aperture");
  const TargetTheory theory =
      theory_on_image({*echoes.acquisition, echoes.rows, {}, true, false}, image, control).at(0);
  const Response definition = annulus_response();
  const double width_m = half_power_width_s(definition);
  record.near("Aperture of 26 degrees, theory of range: half-power width", "m", width_m,
              theory.range ? theory.range->width : 0.0, 0.01 * width_m, "sum over the polar annulus");
  record.near("Aperture of 26 degrees, theory of range: peak side lobe", "dB", side_lobe_db(definition),
              theory.range ? theory.range->pslr_db : 0.0, 0.5, "sum over the polar annulus");
  measure_cut(record, "Aperture of 26 degrees, range", theory.range, found->range);
  measure_cut(record, "Aperture of 26 degrees, azimuth", theory.azimuth, found->azimuth);
}

}  // namespace

void measure_focusing(Record& record) {
  const Echoes echoes = recorded_echoes(strip());
  const TargetTheory theory = theory_of_targets(*echoes.acquisition, echoes.rows, {}).at(0);
  measure_method(record, echoes, signal::FocusMethod::omega_k, theory, "Omega-k");
  measure_method(record, echoes, {}, theory, "Back-projection");
  measure_near_edges(record);
  measure_ground(record);
  measure_wide_aperture(record);
  if (record.quick()) return;
  measure_method(record, echoes, signal::FocusMethod::range_doppler, theory, "Range-Doppler");
  measure_method(record, echoes, signal::FocusMethod::chirp_scaling, theory, "Chirp scaling");
}

}  // namespace sarsim::workflow::verify
