#pragma once

#include <string_view>

#include "scene/ephemeris/attitude_file.hpp"
#include "scene/ephemeris/ephemeris_file.hpp"
#include "scene/ephemeris/file_problems.hpp"
#include "scene/ephemeris/mean_elements_file.hpp"
#include "scene/ephemeris/satellite_choice.hpp"

/// The readers of single formats, each in a file of its name, for `read_ephemeris.cpp`.
namespace sarsim::scene::ephemeris {

/// What a reader reads and to whom it tells what is wrong.
struct ReaderInput {
  std::string_view text;
  SatelliteChoice& choice;
  FileProblems& problems;
  bool without_earth = false;  ///< `EphemerisOptions::without_earth`.
};

/// Reads positions of one format; incomplete where it has reported an error.
[[nodiscard]] EphemerisFile read_eof(const ReaderInput& input);
/// As above.
[[nodiscard]] EphemerisFile read_oem(const ReaderInput& input);
/// As above.
[[nodiscard]] EphemerisFile read_oem_xml(const ReaderInput& input);
/// As above.
[[nodiscard]] EphemerisFile read_sp3(const ReaderInput& input);
/// As above.
[[nodiscard]] EphemerisFile read_csv(const ReaderInput& input);

/// Reads mean elements of one format; incomplete where it has reported an error.
[[nodiscard]] MeanElementsFile read_tle(const ReaderInput& input);
/// As above.
[[nodiscard]] MeanElementsFile read_omm_kvn(const ReaderInput& input);
/// As above.
[[nodiscard]] MeanElementsFile read_omm_xml(const ReaderInput& input);
/// As above.
[[nodiscard]] MeanElementsFile read_omm_csv(const ReaderInput& input);
/// As above.
[[nodiscard]] MeanElementsFile read_omm_json(const ReaderInput& input);

/// Reads attitudes; incomplete where it has reported an error.
[[nodiscard]] AttitudeFile read_aem(const ReaderInput& input);

}  // namespace sarsim::scene::ephemeris
