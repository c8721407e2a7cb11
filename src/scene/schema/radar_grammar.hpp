#pragma once

#include "scene/model/limits.hpp"
#include "scene/model/scene.hpp"
#include "scene/schema/grammar.hpp"

/// Fields and keywords of `$RADAR`.
namespace sarsim::scene::script::radar_grammar {

/// The receive antenna's own choice: the transmit antenna's patterns, or that antenna itself.
enum class ReceivePattern { isotropic, sinx, same, user };

inline constexpr Field name{"name", "name of the radar"};
inline constexpr Field platform{"platform", "name of its platform"};
inline constexpr Field pulse{"pulse", "kind of pulse"};
inline constexpr Field bandwidth{"bandwidth_hz", "chirp bandwidth", "GHz", 9, any_value, "negative sweeps down"};
inline constexpr Field pulse_iq{"pulse_iq", "pulse"};
inline constexpr Field barker_code{
    "barker_code", "Barker code", "", 0, {0.0, 6.0}, "0 to 6 stand for lengths 2, 3, 4, 5, 7, 11, 13"};
inline constexpr Field pulse_width{"pulse_width_s", "pulse width", "ns", -9, zero_or_more, "from edge to edge"};
inline constexpr Field envelope{"envelope", "pulse envelope"};
inline constexpr Field rise{"rise_s", "rise time", "ns", -9, zero_or_more};
inline constexpr Field fall{"fall_s", "fall time", "ns", -9, zero_or_more};
inline constexpr Field envelope_gain{"envelope_gain", "pulse envelope"};
inline constexpr Field repetition{"repetition", "kind of pulse repetition"};
inline constexpr Field prf{"prf_hz", "pulse repetition frequency", "Hz", 0, {1e-5}};
inline constexpr Field pri{"pri_s", "pulse repetition intervals"};
inline constexpr Field carrier{"carrier", "kind of carrier"};
inline constexpr Field carrier_single{"carrier_hz", "carrier frequency", "GHz", 9, zero_or_more};
inline constexpr Field carrier_start{"carrier_hz", "first carrier frequency", "GHz", 9, zero_or_more};
inline constexpr Field carrier_step{"carrier_step_hz", "frequency step", "GHz", 9, zero_or_more};
inline constexpr Field carrier_steps{"carrier_steps", "number of frequencies", "", 0, {1.0, 1000.0}};
inline constexpr Field pulses_per_step{"pulses_per_step", "pulses at each frequency", "", 0, {1.0, 100.0}};
inline constexpr Field carrier_list{"carrier_list_hz", "carrier frequencies"};
inline constexpr Field power{"power_w", "transmitted power", "kW", 3, zero_or_more};
inline constexpr Field transmit_gain{"transmit_gain", "gain of the transmitter", "dB", 0, {0.0, largest_gain_db}};
inline constexpr Field receive_gain{"receive_gain", "gain of the receiver", "dB", 0, {0.0, largest_gain_db}};
inline constexpr Field losses{"losses", "losses of the system", "dB", 0, zero_or_more};
inline constexpr Field noise_temperature{"noise_temperature_k", "noise temperature", "K", 0, zero_or_more};
inline constexpr Field transmit_antenna{"transmit_antenna", "transmit antenna"};
inline constexpr Field transmit_elevation{"transmit_antenna.elevation_beamwidth", "beam width in elevation", "deg"};
inline constexpr Field transmit_azimuth{"transmit_antenna.azimuth_beamwidth", "beam width in azimuth", "deg"};
inline constexpr Field transmit_user{"transmit_antenna.gain_db", "gain of the transmit antenna"};
inline constexpr Field receive_antenna{"receive_antenna", "receive antenna"};
inline constexpr Field receive_elevation{"receive_antenna.elevation_beamwidth", "beam width in elevation", "deg"};
inline constexpr Field receive_azimuth{"receive_antenna.azimuth_beamwidth", "beam width in azimuth", "deg"};
inline constexpr Field receive_user{"receive_antenna.gain_db", "gain of the receive antenna"};
inline constexpr Field beam{"beam", "direction of the beam"};
inline constexpr Field beam_elevation{"beam_elevation", "elevation of the beam", "deg"};
inline constexpr Field beam_azimuth{"beam_azimuth", "azimuth of the beam", "deg"};
inline constexpr Field beam_rate{"beam_rate", "rotation rate of the beam", "deg/s", 0, zero_or_more};
inline constexpr Field spot{"spot_world_m", "spot", "m"};
inline constexpr Field beam_target{"beam_target_world_m", "point the beam looks at"};
inline constexpr Field window{"window", "matched-filter window"};
inline constexpr Field hanning_pedestal{
    "hanning_pedestal", "Hanning constant", "", 0, {0.0, 1.0}, "1 is no weighting, 0 falls to zero at the ends"};
inline constexpr Field window_gain{"window_gain", "matched-filter window"};
inline constexpr Field stc{"stc", "sensitivity-time control"};
inline constexpr Field stc_law{"stc", "law of the sensitivity-time control"};
inline constexpr Field stc_gain{"stc_gain", "sensitivity-time control"};

inline constexpr Alternatives<Radar::Pulse, 4> pulses{
    {{"MONO", Radar::Pulse::mono, "pulse of a single frequency"},
     {"CHIRP", Radar::Pulse::chirp, "pulse of linearly swept frequency"},
     {"OTHER_PULSE", Radar::Pulse::user, "pulse given by its I and Q"},
     {"BARKER", Radar::Pulse::barker, "pulse with a Barker phase code"}}};
inline constexpr Alternatives<Radar::Envelope, 3> envelopes{
    {{"RECT", Radar::Envelope::rectangular, "constant amplitude within the pulse"},
     {"LINEAR", Radar::Envelope::linear, "straight rise and fall"},
     {"OTHER", Radar::Envelope::user, "envelope given by points"}}};
inline constexpr Alternatives<Radar::Repetition, 2> repetitions{
    {{"CONSTANT", Radar::Repetition::constant, "evenly spaced pulses"},
     {"OTHER", Radar::Repetition::user, "list of intervals between pulses"}}};
inline constexpr Alternatives<Radar::Carrier, 3> carriers{
    {{"SINGLE", Radar::Carrier::single, "one carrier"},
     {"STEPPED", Radar::Carrier::stepped, "carrier stepped from pulse to pulse"},
     {"OTHER", Radar::Carrier::user, "list of carriers"}}};
inline constexpr Alternatives<Antenna::Pattern, 4> transmit_patterns{
    {{"ISOTROPIC", Antenna::Pattern::isotropic, "transmit antenna: the same in all directions"},
     {"SINX", Antenna::Pattern::sinx, "transmit antenna: sin(x)/x"},
     {"SIMPLE", Antenna::Pattern::sinx, "transmit antenna: sin(x)/x"},
     {"OTHER", Antenna::Pattern::user, "transmit antenna: gain given by points"}}};
inline constexpr Alternatives<ReceivePattern, 5> receive_patterns{
    {{"ISOTROPIC", ReceivePattern::isotropic, "receive antenna: the same in all directions"},
     {"SINX", ReceivePattern::sinx, "receive antenna: sin(x)/x"},
     {"SIMPLE", ReceivePattern::sinx, "receive antenna: sin(x)/x"},
     {"SAME", ReceivePattern::same, "receive antenna: the transmit antenna"},
     {"OTHER", ReceivePattern::user, "receive antenna: gain given by points"}}};
inline constexpr Alternatives<Radar::Beam, 4> beams{
    {{"FIXED", Radar::Beam::fixed, "beam fixed to the platform"},
     {"ROTATING", Radar::Beam::rotating, "beam turning about the vertical"},
     {"SPOT", Radar::Beam::spot, "beam held on a point of the world"},
     {"OTHER", Radar::Beam::user, "beam held on a moving point of the world"}}};
inline constexpr Alternatives<Radar::Window, 5> windows{
    {{"RECT", Radar::Window::rectangular, "matched filter without weighting"},
     {"HANNING", Radar::Window::hanning, "matched filter with a Hanning window"},
     {"BARTLETT", Radar::Window::bartlett, "matched filter with a triangular window"},
     {"HAMMING", Radar::Window::hamming, "matched filter with a Hamming window"},
     {"OTHER", Radar::Window::user, "matched filter with a window given by points"}}};
inline constexpr Alternatives<bool, 2> stc_switches{
    {{"NO_STC", false, "no sensitivity-time control"}, {"APPLY_STC", true, "sensitivity-time control"}}};
inline constexpr Alternatives<Radar::Stc, 2> stc_laws{
    {{"1OVERR4", Radar::Stc::range_law, "takes the loss with range out of the echoes"},
     {"OTHER", Radar::Stc::user, "gain given by points"}}};

}  // namespace sarsim::scene::script::radar_grammar
