#pragma once

#include "workflow/verify/record.hpp"

/// What `sarsim verify` measures, one function for each group. All work on scenes that are made here.
namespace sarsim::workflow::verify {

/// Radar equation, phase, Doppler, pulses and their compression, antenna, converter: each against its formula.
void measure_closed_forms(Record& record);

/// Frames, rotations and paths: the phase of echoes compared with the light time of `own_path.hpp`.
void measure_geometry(Record& record);

/// Echoes of satellites, missiles and cars compared with the light-time equation of every sample.
void measure_light_time(Record& record);

/// Beams held on points, turning, on platforms that roll; antennas and targets given by points; sensitivity-time
/// control.
void measure_beams_and_targets(Record& record);

/// Samples of band-limited pulses compared with the integral that defines them.
void measure_band_limit(Record& record);

/// The numbers that the thesis prints, in both profiles.
void measure_thesis(Record& record);

/// The fast engines against the plain sum in double precision, and recordings against themselves with other threads
/// and windows.
void measure_engines(Record& record);

/// Moments, spectrum and independence of noise and jitter, within five standard deviations of what they must be.
void measure_statistics(Record& record);

/// A point focused to an image by synthetic aperture: place, phase, amplitude, widths and side lobes.
void measure_focusing(Record& record);

/// Thresholds and false alarms of detectors.
void measure_detection(Record& record);

/// Stepped frequencies: range profiles, images of a turning target.
void measure_stepped(Record& record);

/// The time of the engines against that of a textbook's loop on one thread.
void measure_speed(Record& record);

/// All of them in this order; without speed where the rules say quick.
[[nodiscard]] Record verify_all(const Rules& rules);

}  // namespace sarsim::workflow::verify
