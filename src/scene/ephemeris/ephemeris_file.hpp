#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/maths/vector.hpp"
#include "core/report/problem.hpp"
#include "radar/earth/civil_time.hpp"
#include "radar/earth/instant.hpp"

namespace sarsim::scene {

/// The axes of positions and attitudes; their origin is the centre of the Earth.
enum class Frame : std::uint8_t {
  itrf,     ///< Turns with the Earth; any realisation of ITRF, IGS and WGS 84, which agree to a few centimetres.
  teme,     ///< True equator, mean equinox of date; the frame of SGP4.
  eme2000,  ///< Mean equator and equinox of J2000.
  gcrf,     ///< Geocentric celestial frame; ICRF has the same axes.
};

/// How times stand in a file.
enum class TimeForm : std::uint8_t {
  civil,        ///< Dates and times of day: `EphemerisState::time`.
  since_epoch,  ///< Seconds since the epoch of the scene: `EphemerisState::since_epoch_s`.
};

/// Name of a frame as CCSDS messages spell it: "EME2000".
[[nodiscard]] std::string_view name_of(Frame frame);

/// Where an object was at one time.
struct EphemerisState {
  radar::CivilTime time;       ///< In the file's scale; as constructed where times are seconds since the epoch.
  double since_epoch_s = 0.0;  ///< 0 where times are dates.
  core::Vec3 position_m;
  std::optional<core::Vec3> velocity_mps;  ///< Relative to the frame, in its axes.
};

/// How a file says that its states should be interpolated.
enum class InterpolationMethod : std::uint8_t { unsaid, linear, lagrange, hermite };

/// A wish of the file, not an order: method and degree of the polynomials.
struct InterpolationHint {
  InterpolationMethod method = InterpolationMethod::unsaid;
  int degree = 0;  ///< 0 where the file gives none.
};

/// The times between which data may be used; a missing end is that of the data.
struct UsableRange {
  std::optional<radar::CivilTime> start;
  std::optional<radar::CivilTime> stop;
};

/// States between which one may interpolate. Nothing may be interpolated from one segment to the next.
struct EphemerisSegment {
  std::vector<EphemerisState> states;  ///< Times ascend; at least one.
  UsableRange usable;                  ///< Within the times of the states.
  InterpolationHint interpolation;
};

/// The orbit of one object as a file gives it, in SI units, not interpolated and not converted.
struct EphemerisFile {
  std::string object_name;  ///< Empty where the file has none.
  Frame frame = Frame::itrf;
  radar::TimeScale scale = radar::TimeScale::utc;
  TimeForm form = TimeForm::civil;
  std::vector<EphemerisSegment> segments;  ///< By time; usable ranges touch at most.
};

/// What was read, and what is wrong with it. Where `problems` holds an error, `file` is incomplete.
struct EphemerisReading {
  EphemerisFile file;
  core::Problems problems;
};

/// What readers of files need to be told.
struct EphemerisOptions {
  /// Which satellite of the file: its name, whatever the case, its catalogue number, or its mark in SP3 ("L51"). Empty
  /// for the only one.
  std::string satellite;
  /// The positions of a table are those of a world of its own, without an Earth: they may be anything.
  bool without_earth = false;
};

}  // namespace sarsim::scene
