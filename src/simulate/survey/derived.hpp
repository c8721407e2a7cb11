#pragma once

#include "simulate/plan/acquisition.hpp"
#include "simulate/survey/survey_echoes.hpp"

/// Figures that follow from what a script says and that a radar engineer checks first.
namespace sarsim::simulate {

/// What a radar can do by itself, before any scene. c is the profile's speed of light.
struct RadarFigures {
  double lowest_carrier_hz = 0.0;
  double highest_carrier_hz = 0.0;
  double longest_wavelength_m = 0.0;   ///< c/f at the lowest carrier.
  double shortest_wavelength_m = 0.0;  ///< c/f at the highest.
  double bandwidth_hz = 0.0;           ///< B of one pulse, see bandwidth_hz(const Pulse&); of a chirp of 0 Hz 1/Tp.
  double range_resolution_m = 0.0;     ///< c/(2 B); of a user-defined pulse c/2 times the half-power width of its
                                       ///< autocorrelation.
  double synthetic_range_resolution_m = 0.0;  ///< c/(2 S df) of S frequency steps; 0 where the carrier is not stepped.
  double pulse_length_m = 0.0;                ///< c Tp, the pulse in space.
  double time_bandwidth = 0.0;                ///< B Tp.
  double shortest_pri_s = 0.0;
  double mean_prf_hz = 0.0;          ///< Of one cycle of the repetition intervals.
  double unambiguous_range_m = 0.0;  ///< c PRI/2 of the shortest interval, one way.
  double unambiguous_speed_mps =
      0.0;                    ///< lambda PRF/4 at the shortest wavelength: speeds from -v to +v are told apart.
  double duty_cycle = 0.0;    ///< Tp times the mean PRF.
  double mean_power_w = 0.0;  ///< Peak power, duty cycle and the mean of |pulse|^2 over Tp.
  double noise_density_w_per_hz = 0.0;  ///< k T of the receiver.
  double noise_power_w = 0.0;           ///< k T B.
};

/// @param peak_power_w  transmitted, without gains
[[nodiscard]] RadarFigures radar_figures(const Link& radar, double peak_power_w, const Conventions& conventions);

/// What one simulation will record.
struct SimulationFigures {
  double first_delay_s = 0.0;     ///< Two-way delay of the first column; of the first gate for synthetic profiles.
  double last_delay_s = 0.0;      ///< Of the last.
  double column_spacing_m = 0.0;  ///< One way, between columns.
  double sampling_ratio = 0.0;    ///< Sampling rate over the pulse's bandwidth; below 1 the echoes alias.
  double noise_power_w = 0.0;     ///< Of a raw sample, before STC: 2 sigma^2.
  double pulse_motion_rad = 0.0;  ///< What echoes leave out of the motion within a pulse (`motion_left_in_pulse`).
  double largest_echo_v = 0.0;    ///< Strongest single echo in the product: a lower estimate of the largest magnitude.
  double largest_sum_v = 0.0;     ///< All echoes of a pulse in phase, with 3 sigma of noise: an upper estimate.
  double suggested_lsb_v =
      0.0;  ///< largest_sum_v/(2^(bits-1) - 1): uses the converter without clipping; 0 when silent.
};

/// Figures of a recording from its plan and a survey of its echoes.
[[nodiscard]] SimulationFigures simulation_figures(const Acquisition& acquisition, const EchoSurvey& survey);

/// Largest magnitude in the product of a lone echo of amplitude 1 that lies whole in the raw window: 1 for raw data and
/// synthetic profiles; for compressed data what the filter makes of a pulse on the sampling grid. Costs one row.
[[nodiscard]] double processing_gain(const Acquisition& acquisition);

}  // namespace sarsim::simulate
