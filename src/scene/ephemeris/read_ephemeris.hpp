#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "scene/ephemeris/attitude_file.hpp"
#include "scene/ephemeris/ephemeris_file.hpp"
#include "scene/ephemeris/mean_elements_file.hpp"

namespace sarsim::scene {

/// The formats of orbits and attitudes, told apart by content.
enum class OrbitFormat : std::uint8_t {
  unknown,
  eof,        ///< Sentinel-1 orbit file.
  oem,        ///< CCSDS orbit ephemeris message, keyword = value.
  oem_xml,    ///< The same in XML.
  sp3,        ///< SP3-a to SP3-d; c and d are read.
  csv,        ///< Our own table of times and positions.
  tle,        ///< Two or three lines for each satellite.
  omm_kvn,    ///< CCSDS orbit mean elements message, keyword = value.
  omm_xml,    ///< The same in XML.
  omm_csv,    ///< The same as a table.
  omm_json,   ///< The same in JSON.
  aem,        ///< CCSDS attitude ephemeris message, keyword = value.
  other_ndm,  ///< A CCSDS message of another kind or form, which is not read.
};

/// Longest text that the readers take, in bytes.
inline constexpr std::size_t longest_ephemeris_text = std::size_t{1} << 30U;
/// Most states that the readers take from one file.
inline constexpr std::size_t max_ephemeris_states = 10'000'000;

/// The format of a text by its first lines.
[[nodiscard]] OrbitFormat orbit_format_of(std::string_view text);

/// What a text seems to be that is no orbit, for a message; empty where that cannot be told.
[[nodiscard]] std::string what_is_no_orbit(std::string_view text, OrbitFormat format);

/// The name of a format in a sentence: "a CCSDS OEM".
[[nodiscard]] std::string_view name_of(OrbitFormat format);

/// Reads positions of one object: Sentinel-1 EOF, CCSDS OEM (KVN and XML, versions 1 to 3), SP3-c and SP3-d, or a CSV
/// table. All problems that can be told are reported together, with their places; not more than 20 errors. Time is
/// linear in the text. Any bytes may be given; nothing is thrown but std::bad_alloc.
///
/// A CSV table has the columns t, x, y, z and, where it likes, vx, vy, vz, in m and m/s. t is in seconds since the
/// epoch of the scene or a time of ISO 8601. It cannot name its frame and scale; they are given as ITRF and UTC.
/// @param name  of the file, for messages
[[nodiscard]] EphemerisReading read_ephemeris(std::string_view text, const std::string& name,
                                              const EphemerisOptions& options = {});

/// Reads mean elements of one satellite: TLE, or OMM in KVN, XML, CSV or JSON. As `read_ephemeris` otherwise. Sets of
/// other satellites in the file are not looked at more closely than it takes to tell whose they are.
[[nodiscard]] MeanElementsReading read_mean_elements(std::string_view text, const std::string& name,
                                                     const EphemerisOptions& options = {});

/// Reads the attitude of one body: CCSDS AEM (KVN) of version 1, whose ATTITUDE_DIR and QUATERNION_TYPE say how the
/// quaternions are meant, and version 2, where they always turn A into B and end with the scalar. As `read_ephemeris`
/// otherwise.
[[nodiscard]] AttitudeReading read_attitude(std::string_view text, const std::string& name,
                                            const EphemerisOptions& options = {});

}  // namespace sarsim::scene
