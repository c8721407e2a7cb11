#include "scene/script/order.hpp"

#include <algorithm>

namespace sarsim::scene::script {

namespace {

template <auto First, auto... Rest>
auto order() {
  return Order<field_values::OwnerOf<decltype(First)>>{&field_of<First>(), &field_of<Rest>()...};
}

template <class Object>
Order<Object> joined(std::initializer_list<Order<Object>> orders) {
  Order<Object> all;
  for (const Order<Object>& part : orders) all.insert(all.end(), part.begin(), part.end());
  return all;
}

template <class Object>
Order<Object> with_rows(Order<Object> first, const std::vector<Row<Object>>& rows) {
  for (const Row<Object>& row : rows) first.insert(first.end(), row.fields.begin(), row.fields.end());
  return first;
}

// What a target and a cloud have alike.
template <class Object>
std::vector<Row<Object>> traits_rows(const char* deviation_comment) {
  constexpr auto in = &Object::traits;
  using Traits = TargetTraits;
  return {{{&field_of<in, &Traits::position_stddev_m>()}, deviation_comment},
          {{&field_of<&Object::rcs_m2>(), &field_of<in, &Traits::rcs_stddev_m2>()},
           "Radar cross-section and its standard deviation"},
          {{&field_of<in, &Traits::reflectivity>()}},
          {{&field_of<in, &Traits::azimuth>(), &field_of<in, &Traits::elevation>(),
            &field_of<in, &Traits::azimuth_stddev>(), &field_of<in, &Traits::elevation_stddev>()},
           "Azimuth and elevation of the face, their standard deviations"},
          {{&field_of<in, &Traits::gain>(), &field_of<in, &Traits::gain_db>()}}};
}

}  // namespace

const PlatformOrder& platform_order() {
  static const PlatformOrder made{
      .path = order<&Platform::path, &Platform::position_m, &Platform::trajectory_m, &Platform::aligned>(),
      .rotation =
          order<&Platform::rotation_kind, &Platform::rotation, &Platform::rotation_deg, &Platform::rotation_rate>(),
      .errors = order<&Platform::position_error, &Platform::position_stddev_m, &Platform::position_envelope,
                      &Platform::rotation_error, &Platform::rotation_stddev, &Platform::rotation_envelope>()};
  return made;
}

const std::vector<Row<Target>>& target_rows() {
  static const std::vector<Row<Target>> made = [] {
    std::vector<Row<Target>> rows = traits_rows<Target>("Standard deviation of the position: x, y, z");
    rows.insert(rows.begin(), {order<&Target::position_m>(), "Position: x, y, z"});
    return rows;
  }();
  return made;
}

const std::vector<Row<Cloud>>& cloud_rows() {
  static const std::vector<Row<Cloud>> made = traits_rows<Cloud>("Standard deviation of the positions: x, y, z");
  return made;
}

const std::vector<Row<Surface>>& surface_rows() {
  static const std::vector<Row<Surface>> made{{{&field_of<&Surface::corner_m, 0>()}, "Corner 1: x, y, z"},
                                              {{&field_of<&Surface::corner_m, 1>()}, "Corner 2: x, y, z"},
                                              {{&field_of<&Surface::corner_m, 2>()}, "Corner 3: x, y, z"}};
  return made;
}

const RadarOrder& radar_order() {
  static const RadarOrder made{
      .up_to_power = order<&Radar::platform, &Radar::pulse, &Radar::bandwidth_hz, &Radar::pulse_iq, &Radar::barker_code,
                           &Radar::pulse_width_s, &Radar::envelope, &Radar::rise_s, &Radar::fall_s,
                           &Radar::envelope_gain, &Radar::repetition, &Radar::prf_hz, &Radar::pri_s, &Radar::carrier,
                           &Radar::carrier_hz, &Radar::carrier_step_hz, &Radar::carrier_steps, &Radar::pulses_per_step,
                           &Radar::carrier_list_hz, &Radar::power_w>(),
      .gains = order<&Radar::transmit_gain, &Radar::receive_gain>(),
      .losses = order<&Radar::losses, &Radar::noise_temperature_k>(),
      .transmit_antenna = {&field_of<&Radar::transmit_antenna, &Antenna::pattern>(),
                           &field_of<&Radar::transmit_antenna, &Antenna::elevation_beamwidth>(),
                           &field_of<&Radar::transmit_antenna, &Antenna::azimuth_beamwidth>(),
                           &field_of<&Radar::transmit_antenna, &Antenna::gain_db>()},
      .receive_antenna = {&field_of<&Radar::receive_antenna, &Antenna::elevation_beamwidth>(),
                          &field_of<&Radar::receive_antenna, &Antenna::azimuth_beamwidth>(),
                          &field_of<&Radar::receive_antenna, &Antenna::gain_db>()},
      .direction_and_window =
          order<&Radar::beam, &Radar::beam_elevation, &Radar::beam_azimuth, &Radar::beam_rate, &Radar::spot_world_m,
                &Radar::beam_target_world_m, &Radar::window, &Radar::hanning_pedestal, &Radar::window_gain>(),
      .stc = order<&Radar::stc_gain>()};
  return made;
}

const SimulationOrder& simulation_order() {
  static const SimulationOrder made{
      .always = order<&Simulation::range_start_m, &Simulation::range_end_m, &Simulation::time_start_s,
                      &Simulation::time_end_s, &Simulation::bits, &Simulation::sample_rate_hz, &Simulation::lsb_v,
                      &Simulation::format, &Simulation::processing, &Simulation::file, &Simulation::pulse_position>(),
      .since_1998 = order<&Simulation::oversampling, &Simulation::width_factor>()};
  return made;
}

const Order<GeometryTable>& geometry_order() {
  static const auto made =
      order<&GeometryTable::range_start_m, &GeometryTable::range_end_m, &GeometryTable::time_start_s,
            &GeometryTable::time_end_s, &GeometryTable::separator, &GeometryTable::columns, &GeometryTable::file>();
  return made;
}

template <>
Order<Platform> script_order() {
  const PlatformOrder& parts = platform_order();
  return joined({order<&Platform::name>(), parts.path, parts.rotation, parts.errors});
}

template <>
Order<Target> script_order() {
  return with_rows(order<&Target::platform>(), target_rows());
}

template <>
Order<Cloud> script_order() {
  return with_rows(order<&Cloud::platform, &Cloud::file>(), cloud_rows());
}

template <>
Order<Surface> script_order() {
  return with_rows(order<&Surface::platform>(), surface_rows());
}

template <>
Order<Radar> script_order() {
  const RadarOrder& parts = radar_order();
  const Order<Radar> patterns{&field_of<&Radar::same_antenna>(),
                              &field_of<&Radar::receive_antenna, &Antenna::pattern>()};
  return joined({order<&Radar::name>(), parts.up_to_power, parts.gains, parts.losses, parts.transmit_antenna, patterns,
                 parts.receive_antenna, parts.direction_and_window, order<&Radar::stc>(), parts.stc});
}

template <>
Order<Simulation> script_order() {
  const SimulationOrder& parts = simulation_order();
  return joined({order<&Simulation::radar>(), parts.always, parts.since_1998});
}

template <>
Order<GeometryTable> script_order() {
  return joined({order<&GeometryTable::radar>(), geometry_order()});
}

template <>
Order<RunOptions> script_order() {
  return order<&RunOptions::profile, &RunOptions::seed, &RunOptions::pulse, &RunOptions::tolerance,
               &RunOptions::cubic_ends, &RunOptions::ambiguous_echoes, &RunOptions::eclipsing>();
}

std::string option_key(const FieldSpec& spec) {
  std::string key(spec.id);
  std::ranges::transform(key, key.begin(), [](char c) { return c == '_' ? c : static_cast<char>(c - 'a' + 'A'); });
  return key;
}

const Field& parameter(const FieldOf<Radar>& field, const Radar& radar) {
  static const Field first_carrier = [] {
    Field made = field_of<&Radar::carrier_hz>().in_script;
    made.words = "first carrier frequency";
    return made;
  }();
  const bool first = &field == &field_of<&Radar::carrier_hz>() && radar.carrier == Radar::Carrier::stepped;
  return first ? first_carrier : field.in_script;
}

}  // namespace sarsim::scene::script
