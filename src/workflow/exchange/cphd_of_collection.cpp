#include "workflow/exchange/cphd_of_collection.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/build/version.hpp"
#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"
#include "radar/waveform/pulse.hpp"
#include "workflow/exchange/image_area.hpp"
#include "workflow/exchange/reference_geometry.hpp"
#include "workflow/focus/sar_rows.hpp"
#include "workflow/input/earth_place.hpp"

namespace sarsim::workflow {

namespace {

raster::TransmittedPulse pulse_of(const simulate::Acquisition& acquisition) {
  return {
      .width_s = acquisition.link.pulse.width_s,
      .band_hz = std::abs(radar::bandwidth_hz(acquisition.link.pulse)),
      .rate_hz_per_s = acquisition.link.pulse.sweep_rate_hz_per_s(),
      .window_s = static_cast<double>(acquisition.reception.raw_grid.count) * acquisition.reception.raw_grid.interval_s,
      .sample_rate_hz = 1.0 / acquisition.reception.raw_grid.interval_s,
      .carrier_hz = 0.5 * (acquisition.link.carrier.lowest_hz() + acquisition.link.carrier.highest_hz())};
}

std::vector<std::pair<std::string, std::string>> parameters_of(const Collection& collection) {
  const simulate::Acquisition& acquisition = *collection.acquisition;
  const bool limited = acquisition.scene->options.pulse == scene::PulseDefinition::band_limited;
  return {{"Software", fmt::format("Sarsim {}", core::program_version)},
          {"Simulation", std::to_string(collection.simulation + 1)},
          {"Pulse", limited ? "band-limited" : "ideal"},
          {"Seed", std::to_string(acquisition.scene->options.seed)},
          {"World", collection.flat ? "a plane that rests, laid on the Earth" : "the Earth"},
          {"Anchor", anchor_text(collection.earth.anchor())}};
}

// When the points of the area are seen, and for how long: while the antenna passes them; all of the time where the beam
// follows them or sees everything, or where the recording ends before it has passed all of the area.
void put_dwell(const Collection& collection, const raster::PhaseVector& middle, raster::CphdDescription& d) {
  const simulate::Acquisition& acquisition = *collection.acquisition;
  d.centre_time_s = {0.5 * (d.tx_time1_s + d.tx_time2_s), 0.0, 0.0};
  d.dwell_s = d.tx_time2_s - d.tx_time1_s;
  const radar::AntennaPattern& antenna = acquisition.link.transmit;
  if (acquisition.link.beam.kind == radar::Beam::Kind::spot || antenna.kind != radar::AntennaPattern::Kind::sinx)
    return;
  const core::Vec3 way = d.scene.origin_m - middle.tx_m;
  const double speed_mps = core::norm(middle.tx_mps);
  const double passed_s = antenna.azimuth_beamwidth_rad * core::norm(way) / speed_mps;
  if (!(passed_s < d.dwell_s)) return;
  const double per_m = 1.0 / (speed_mps * speed_mps);
  const double x_slope = per_m * core::dot(middle.tx_mps, d.scene.x_axis);
  const double y_slope = per_m * core::dot(middle.tx_mps, d.scene.y_axis);
  const raster::AreaRectangle& area = d.scene.area;
  const double off_s =
      std::abs(x_slope) * std::max(-area.x1, area.x2) + std::abs(y_slope) * std::max(-area.y1, area.y2);
  if (off_s + 0.5 * passed_s > 0.5 * d.dwell_s) return;
  d.dwell_s = passed_s;
  d.centre_time_s.x_slope = x_slope;
  d.centre_time_s.y_slope = y_slope;
}

core::Vec3 in_area(const raster::SceneCoordinates& scene, const core::Vec3& ecf_m) {
  const core::Vec3 way = ecf_m - scene.origin_m;
  return {core::dot(way, scene.x_axis), core::dot(way, scene.y_axis),
          core::dot(way, core::cross(scene.x_axis, scene.y_axis))};
}

void put_geometry(const raster::PhaseVector& middle, raster::CphdDescription& d) {
  raster::ReferenceGeometry g = reference_geometry(middle, d.bistatic);
  g.srp_in_area_m = in_area(d.scene, middle.srp_m);
  g.centre_time_s = d.centre_time_s.constant + d.centre_time_s.x_slope * g.srp_in_area_m.x +
                    d.centre_time_s.y_slope * g.srp_in_area_m.y;
  g.dwell_s = d.dwell_s;
  d.geometry = g;
}

}  // namespace

raster::CphdDescription cphd_of(const Collection& collection, const CollectionExtent& extent, const HistoryShape& shape,
                                raster::SignalEncoding encoding) {
  const simulate::Acquisition& acquisition = *collection.acquisition;
  PhaseHistory history(collection, shape);
  const std::size_t reference = acquisition.timing.rows / 2;
  const raster::PhaseVector middle = history.vector_of(reference);
  const double from_carrier_hz = static_cast<double>(shape.grid.first_bin) * shape.grid.step_hz;
  raster::CphdDescription d;
  d.collector = acquisition.link.name;
  d.core_name = collection.name;
  d.mode = acquisition.link.beam.kind == radar::Beam::Kind::spot ? "SPOTLIGHT" : "STRIPMAP";
  d.parameters = parameters_of(collection);
  d.start = collection.start_text();
  d.tx_time1_s = extent.first_tx_s;
  d.tx_time2_s = extent.last_tx_s;
  d.fx_min_hz = extent.min_carrier_hz + from_carrier_hz;
  d.fx_max_hz = extent.max_carrier_hz + from_carrier_hz + (middle.fx2_hz - middle.fx1_hz);
  d.toa_min_s = shape.toa1_s;
  d.toa_max_s = shape.toa2_s;
  d.encoding = encoding;
  CollectionGeometry geometry(collection);
  d.scene = image_area_of(collection, geometry.reference_m(reference), middle);
  raster::PhaseChannel channel;
  channel.id = "1";
  channel.vectors = acquisition.timing.rows;
  channel.samples = shape.grid.samples;
  channel.reference = reference;
  channel.fx_fixed = extent.min_carrier_hz == extent.max_carrier_hz;
  channel.srp_fixed = collection.reference.kind != ReferencePoint::Kind::moving;
  channel.centre_hz = 0.5 * (d.fx_min_hz + d.fx_max_hz);
  channel.band_hz = d.fx_max_hz - d.fx_min_hz;
  channel.toa_s = shape.toa2_s - shape.toa1_s;
  d.channels = {channel};
  d.pulse = pulse_of(acquisition);
  put_dwell(collection, middle, d);
  put_geometry(middle, d);
  return d;
}

}  // namespace sarsim::workflow
