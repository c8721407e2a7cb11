#include "random_scenes/radar_maker.hpp"

namespace sarsim::test {

namespace {

class RadarMaker {
 public:
  RadarMaker(Chance& chance, FunctionMaker& functions, const Layout& layout, const core::Vec3& position_m)
      : chance_(chance), functions_(functions), layout_(layout), position_m_(position_m) {}

  scene::Radar make() {
    set_pulse();
    set_envelope();
    set_repetition();
    set_carrier();
    set_power();
    set_antenna(radar_.transmit_antenna);
    radar_.same_antenna = chance_.coin();
    if (!radar_.same_antenna) set_antenna(radar_.receive_antenna);
    set_beam();
    set_receiver();
    return radar_;
  }

 private:
  void set_pulse() {
    radar_.pulse = chance_.one_of<scene::Radar::Pulse>(4);
    const double samples = chance_.one_in(4) ? chance_.integer(1, 100) : chance_.size(0.3, 200.0);
    radar_.pulse_width_s = samples / layout_.sample_rate_hz;
    if (radar_.pulse == scene::Radar::Pulse::chirp)
      radar_.bandwidth_hz = chance_.one_in(20) ? 0.0 : chance_.signed_size(0.01, 1.2) * layout_.sample_rate_hz;
    if (radar_.pulse == scene::Radar::Pulse::barker) radar_.barker_code = chance_.integer(0, 6);
    if (radar_.pulse != scene::Radar::Pulse::user) return;
    for (core::SampledFunction& part : radar_.pulse_iq.part) part = over_pulse(12, -1.0, 1.0);
    if (chance_.one_in(4)) radar_.pulse_iq.part[chance_.below(2)].knots.clear();
    functions_.name_file(radar_.pulse_iq);
  }

  // Points from 0 to 1, sometimes with a first or last one outside or missing.
  core::SampledFunction over_pulse(int most, double smallest, double largest) {
    const double low = chance_.one_in(3) ? chance_.between(-0.3, 0.3) : 0.0;
    const double high = chance_.one_in(3) ? chance_.between(0.7, 1.3) : 1.0;
    return functions_.curve(most, low, high, smallest, largest);
  }

  void set_envelope() {
    radar_.envelope = chance_.one_of<scene::Radar::Envelope>(3);
    if (radar_.envelope == scene::Radar::Envelope::linear) {
      radar_.rise_s = chance_.one_in(4) ? 0.0 : radar_.pulse_width_s * chance_.between(0.01, 0.7);
      radar_.fall_s = chance_.one_in(4) ? 0.0 : radar_.pulse_width_s * chance_.between(0.01, 0.7);
    } else if (radar_.envelope == scene::Radar::Envelope::user) {
      radar_.envelope_gain.part[0] = over_pulse(8, 0.0, 2.0);
      functions_.name_file(radar_.envelope_gain);
    }
  }

  void set_repetition() {
    radar_.repetition = chance_.one_of<scene::Radar::Repetition>(2);
    if (radar_.repetition == scene::Radar::Repetition::constant) {
      radar_.prf_hz = 1.0 / layout_.interval_s;
      return;
    }
    radar_.pri_s.part[0] = functions_.list(6, 0.5 * layout_.interval_s, 1.5 * layout_.interval_s);
    functions_.name_file(radar_.pri_s);
  }

  void set_carrier() {
    radar_.carrier = layout_.stepped ? scene::Radar::Carrier::stepped : chance_.one_of<scene::Radar::Carrier>(3);
    if (radar_.carrier == scene::Radar::Carrier::user) {
      const double about_hz = chance_.size(1e7, 1e11);
      radar_.carrier_list_hz.part[0] = functions_.list(6, 0.7 * about_hz, 1.3 * about_hz);
      functions_.name_file(radar_.carrier_list_hz);
      return;
    }
    radar_.carrier_hz = chance_.size(1e7, 1e11);
    if (radar_.carrier != scene::Radar::Carrier::stepped) return;
    radar_.carrier_step_hz = !layout_.stepped && chance_.one_in(5) ? 0.0 : chance_.size(1e4, 1e8);
    radar_.carrier_steps = chance_.integer(layout_.stepped ? 2 : 1, 6);
    radar_.pulses_per_step = chance_.integer(1, 3);
  }

  void set_power() {
    radar_.power_w = chance_.one_in(30) ? 0.0 : chance_.size(1e-3, 1e7);
    if (chance_.coin())
      radar_.transmit_gain = core::PowerRatio::from_db(chance_.between(0.0, chance_.one_in(9) ? 290.0 : 60.0));
    if (chance_.coin())
      radar_.receive_gain = core::PowerRatio::from_db(chance_.between(0.0, chance_.one_in(9) ? 290.0 : 60.0));
    if (chance_.coin())
      radar_.losses = core::PowerRatio::from_db(chance_.between(0.0, chance_.one_in(9) ? 350.0 : 40.0));
    if (chance_.coin()) radar_.noise_temperature_k = chance_.size(1.0, 1e5);
  }

  void set_antenna(scene::Antenna& antenna) {
    antenna.pattern = chance_.one_of<scene::Antenna::Pattern>(3);
    if (antenna.pattern == scene::Antenna::Pattern::sinx) {
      antenna.elevation_beamwidth = core::Angle::from_deg(chance_.size(0.2, 360.0));
      antenna.azimuth_beamwidth = core::Angle::from_deg(chance_.size(0.2, 360.0));
    } else if (antenna.pattern == scene::Antenna::Pattern::user) {
      for (core::SampledFunction& cut : antenna.gain_db.part)
        cut = functions_.curve(8, chance_.coin() ? 0.0 : -180.0, chance_.between(10.0, 180.0), -60.0, 20.0);
      functions_.name_file(antenna.gain_db);
    }
  }

  // Half of the beams look about where the targets are, as long as the platform does not turn.
  void set_beam() {
    radar_.beam = chance_.one_of<scene::Radar::Beam>(4);
    const core::Vec3 look = -1.0 * position_m_;
    const bool aimed = chance_.coin();
    const double elevation_deg = aimed ? std::asin(look.z / core::norm(look)) * 180.0 / core::pi : 0.0;
    const double azimuth_deg = aimed ? std::atan2(look.x, look.y) * 180.0 / core::pi : 0.0;
    const double off_deg = aimed ? 5.0 : 180.0;
    if (radar_.beam == scene::Radar::Beam::fixed || radar_.beam == scene::Radar::Beam::rotating)
      radar_.beam_elevation = core::Angle::from_deg(elevation_deg + chance_.between(-off_deg, off_deg));
    if (radar_.beam == scene::Radar::Beam::fixed)
      radar_.beam_azimuth = core::Angle::from_deg(azimuth_deg + chance_.between(-off_deg, off_deg));
    if (radar_.beam == scene::Radar::Beam::rotating)
      radar_.beam_rate = core::Angle::from_deg(chance_.size_or_zero(0.1, 1000.0));
    const double near_m = 2.0 * layout_.spread_m;
    if (radar_.beam == scene::Radar::Beam::spot) radar_.spot_world_m = chance_.vector(near_m);
    if (radar_.beam != scene::Radar::Beam::user) return;
    for (core::SampledFunction& axis : radar_.beam_target_world_m.part)
      axis = functions_.curve(4, layout_.start_s, layout_.start_s + layout_.duration_s, -near_m, near_m);
    if (chance_.one_in(4)) radar_.beam_target_world_m.part[chance_.below(3)].knots.clear();
    functions_.name_file(radar_.beam_target_world_m);
  }

  void set_receiver() {
    radar_.window = chance_.one_of<scene::Radar::Window>(5);
    if (radar_.window == scene::Radar::Window::hanning) radar_.hanning_pedestal = chance_.between(0.0, 1.0);
    if (radar_.window == scene::Radar::Window::user) {
      radar_.window_gain.part[0] = over_pulse(8, 0.1, 1.0);
      functions_.name_file(radar_.window_gain);
    }
    radar_.stc = chance_.one_of<scene::Radar::Stc>(3);
    if (radar_.stc != scene::Radar::Stc::user) return;
    radar_.stc_gain.part[0] = functions_.curve(6, std::max(1.0, layout_.range_m - layout_.window_m),
                                               layout_.range_m + 2.0 * layout_.window_m, 0.1, 10.0);
    functions_.name_file(radar_.stc_gain);
  }

  Chance& chance_;
  FunctionMaker& functions_;
  const Layout& layout_;
  core::Vec3 position_m_;
  scene::Radar radar_;
};

}  // namespace

scene::Radar random_radar(Chance& chance, FunctionMaker& functions, const Layout& layout,
                          const core::Vec3& position_m) {
  return RadarMaker(chance, functions, layout, position_m).make();
}

}  // namespace sarsim::test
