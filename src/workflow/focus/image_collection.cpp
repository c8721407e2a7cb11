#include "workflow/focus/image_collection.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/maths/sinc.hpp"
#include "radar/path/path.hpp"
#include "signal/measure/response.hpp"
#include "signal/sar/image_spectrum.hpp"
#include "workflow/focus/azimuth_ambiguities.hpp"
#include "workflow/focus/sar_rows.hpp"
#include "workflow/focus/target_aspects.hpp"

namespace sarsim::workflow {

namespace {

// The plan with points of 1 m^2 that rest in the world in place of its targets.
simulate::Acquisition plan_with_points(const simulate::Acquisition& acquisition,
                                       const std::vector<core::Vec3>& points) {
  simulate::Acquisition other = acquisition;
  auto scene = std::make_shared<simulate::ResolvedScene>(*acquisition.scene);
  scene->scatterers = {};
  scene->sheets.clear();
  for (const core::Vec3& point : points) {
    simulate::Scatterer scatterer;
    scatterer.platform = static_cast<std::uint32_t>(scene->platforms.size() - 1);  // The world itself.
    scatterer.position_m = point;
    scene->scatterers.push_back(scatterer);
  }
  other.scene = std::move(scene);
  return other;
}

// The point at a place that lies in the direction of the scene: of ranges that do not reach the ground.
core::Vec3 point_towards(const signal::ImageFrame& frame, const core::Vec3& scene_m, const signal::ImagePlace& at) {
  const core::Vec3 foot_m = frame.origin_m + at.azimuth_m * frame.along;
  const core::Vec3 across = scene_m - foot_m - core::dot(scene_m - foot_m, frame.along) * frame.along;
  return foot_m + at.range_m / std::max(core::norm(across), 1.0) * across;
}

// What one place is to the pulses.
struct PlaceView {
  double time_s = 0.0;  // mean, from the track's middle
  std::vector<signal::SeenDirection> directions;
};

PlaceView view_of(std::span<const TargetAspect> seen, const DopplerBand& band, double sine_per_hz, bool all) {
  PlaceView view;
  double sum = 0.0;
  double moment = 0.0;
  for (const TargetAspect& look : seen) {
    const double weight = all ? 1.0 : look.amplitude * look.share;
    const double sine = sine_per_hz * look.doppler_hz;
    if (!(weight > 0.0) || !(std::abs(sine) < 1.0)) continue;
    if (!all && std::abs(look.doppler_hz - band.centroid_hz) > 0.5 * band.width_hz) continue;
    view.directions.push_back({sine, weight});
    // By power, as the middle of a spectrum is measured: amplitudes have tails, which the ends of the record cut off.
    sum += weight * weight;
    moment += weight * weight * look.time_s;
  }
  if (sum > 0.0) view.time_s = moment / sum;
  // Nothing of it was recorded: all pulses count alike.
  if (!(sum > 0.0) && !all) return view_of(seen, band, sine_per_hz, true);
  return view;
}

// The bandwidth of an even spectrum whose response is as wide between half powers as this one: 0.886 over the width. A
// pulse that sees the point at the sine s ahead fills the wave numbers about `middle` for it, `width` wide.
double bandwidth_per_m(const PlaceView& view, const std::function<double(double sine)>& middle,
                       const std::function<double(double sine)>& width) {
  double sum = 0.0;
  double mean = 0.0;
  double square = 0.0;
  for (const auto& [sine, weight] : view.directions) {
    const double at = middle(sine);
    sum += weight;
    mean += weight * at;
    square += weight * (at * at + width(sine) * width(sine) / 12.0);
  }
  mean /= sum;
  const double spread_per_m = std::sqrt(std::max(square / sum - mean * mean, 0.0));
  if (!(spread_per_m > 0.0)) return 0.0;
  const auto power = [&](double place_m) {
    std::complex<double> response;
    for (const auto& [sine, weight] : view.directions)
      response += weight * core::sinc(width(sine) * place_m) *
                  std::polar(1.0, 2.0 * core::pi * (middle(sine) - mean) * place_m);
    return std::norm(response) / (sum * sum);
  };
  // The response begins like 1 - (2 pi spread x)^2/2 and is at half its power near x = 0.13/spread.
  double inside_m = 0.0;
  double outside_m = 0.0;
  for (const double step_m = 0.02 / spread_per_m; power(outside_m) > 0.5; outside_m += step_m) inside_m = outside_m;
  for (int halving = 0; halving < 40; ++halving) {
    const double middle_m = 0.5 * (inside_m + outside_m);
    (power(middle_m) > 0.5 ? inside_m : outside_m) = middle_m;
  }
  return signal::even_response_width / (2.0 * inside_m);
}

// Of a point in the middle of the image (docs/theory/focusing.md, "The grid").
void set_bandwidths(ImageCollection& collection, const PlaceView& view) {
  const double light_speed = collection.waveform.light_speed_mps;
  const double carrier = radar::turns_per_m(collection.waveform.carrier_hz, light_speed);
  const double band = radar::turns_per_m(collection.highest_hz - collection.lowest_hz, light_speed);
  const auto cosine = [](double sine) { return std::sqrt(1.0 - sine * sine); };
  collection.azimuth_bandwidth_per_m = bandwidth_per_m(
      view, [&](double sine) { return carrier * sine; }, [&](double sine) { return band * std::abs(sine); });
  collection.range_bandwidth_per_m = bandwidth_per_m(
      view, [&](double sine) { return carrier * cosine(sine); }, [&](double sine) { return band * cosine(sine); });
}

}  // namespace

ImageCollection collection_of(const FocusInput& input, const ImageMaking& making, const EarthPlace& place,
                              const core::WorkControl& control) {
  const signal::FocusedImage& image = making.image;
  ImageCollection collection{.earth = place.earth,
                             .epoch = place.epoch,
                             .track = input.echoes.track,
                             .waveform = input.echoes.waveform,
                             .lowest_hz = 0.0,
                             .highest_hz = 0.0,
                             .window_s = 0.0,
                             .scene_m = scene_middle_m(*input.acquisition),
                             .autofocused = making.autofocused,
                             .seen = {},
                             .range_bandwidth_per_m = 0.0,
                             .azimuth_bandwidth_per_m = 0.0};
  const signal::SarWaveform& waveform = collection.waveform;
  const double half_hz = 0.5 * std::abs(waveform.bandwidth_hz);
  collection.lowest_hz = waveform.carrier_hz - half_hz;
  collection.highest_hz = waveform.carrier_hz + half_hz;
  if (!input.echoes.carriers_hz.empty()) {
    const auto [low, high] = std::ranges::minmax(input.echoes.carriers_hz);
    collection.lowest_hz = low - half_hz;
    collection.highest_hz = high + half_hz;
  }
  collection.window_s = static_cast<double>(input.echoes.columns) / waveform.sample_rate_hz;
  if (image.frame.plane == signal::ImagePlane::ground_grid)
    collection.scene_m =
        image.frame.origin_m + image.range.at(0.5 * static_cast<double>(image.range.count)) * image.frame.across;

  const std::vector<signal::ImagePlace> places = places_to_look_at(image);
  std::vector<core::Vec3> points;
  for (const signal::ImagePlace& at : places)
    points.push_back(ground_point(image, collection.earth, collection.scene_m, at)
                         .value_or(point_towards(image.frame, collection.scene_m, at)));
  const simulate::Acquisition acquisition = plan_with_points(*input.acquisition, points);
  signal::EchoRows echoes = input.echoes;
  echoes.compensated = image.frame.plane == signal::ImagePlane::slant_range;
  const TargetAspects looks(acquisition, echoes);
  DopplerBand band{making.options.doppler_centroid_hz, std::numeric_limits<double>::infinity()};
  if (!making.in_time) band.width_hz = 1.0 / looks.track().interval_s;
  if (making.options.doppler_bandwidth_hz > 0.0)
    band.width_hz = std::min(band.width_hz, making.options.doppler_bandwidth_hz);
  const double sine_per_hz =
      radar::range_of_cycle(waveform.carrier_hz, waveform.light_speed_mps) / looks.track().speed_mps;
  const double middle_s = echoes.track[looks.track().middle_pulse].time_s;
  collection.seen.resize(places.size());
  looks.each(control, [&](std::size_t i, std::span<const TargetAspect> seen) {
    const PlaceView view = view_of(seen, band, sine_per_hz, false);
    collection.seen[i] = {places[i], middle_s + view.time_s};
    if (i == places.size() / 2) set_bandwidths(collection, view);
  });
  return collection;
}

}  // namespace sarsim::workflow
