#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/maths/vector.hpp"
#include "core/report/problem.hpp"
#include "radar/earth/ellipsoid.hpp"
#include "raster/table/image_places.hpp"

/// Complex images as SICD has them (NGA.STND.0024, Volume 1; docs/formats/sicd.md): rows are ranges, columns places
/// along the track, so that shadows fall downwards.
namespace sarsim::raster {

/// c[0] + c[1] x + c[2] x^2 ...
using Polynomial = std::vector<double>;
/// c[i][j] x^i y^j: x counts rows, y columns. All rows are equally long.
using Polynomial2 = std::vector<std::vector<double>>;

/// A direction of an image: down its columns (Row) or along its rows (Col).
struct SicdDirection {
  core::Vec3 unit_ecf;             ///< Direction in which indices grow.
  double step_m = 1.0;             ///< SS.
  double width_m = 1.0;            ///< Of a point's response, between half powers.
  double bandwidth_per_m = 0.0;    ///< Of a point's spectrum, cycles per metre.
  double centre_per_m = 0.0;       ///< KCtr: wave number that the image has at its frequency 0.
  Polynomial2 offset_per_m;        ///< DeltaKCOAPoly: middle of a point's spectrum, from KCtr, over the image.
  double min_per_m = 0.0;          ///< DeltaK1: where the spectra of all points begin, from KCtr.
  double max_per_m = 0.0;          ///< DeltaK2: where they end.
  std::string window = "UNIFORM";  ///< WgtType.
  std::vector<std::pair<std::string, std::string>> window_parameters;
  std::vector<double> weights;  ///< The window over the bandwidth; empty: even.
};

/// What an image of ranges and places of closest approach says of the flight past them (RMA, INCA).
struct SicdClosestApproach {
  std::string algorithm;    ///< "OMEGA_K", "CSA" or "RG_DOP".
  Polynomial time_s;        ///< By columns, from the point below.
  double range_m = 0.0;     ///< Of the reference point.
  double carrier_hz = 0.0;  ///< FreqZero.
  Polynomial2 rate_factor;  ///< DRateSFPoly.
  Polynomial2 centroid_hz;  ///< DopCentroidPoly; empty in spotlight.
};

/// How the radar stood to the reference point when the middle of its aperture saw it (SCPCOA).
struct SicdView {
  double time_s = 0.0;
  core::Vec3 position_ecf_m;
  core::Vec3 velocity_ecf_mps;
  core::Vec3 acceleration_ecf_mps2;
  bool left = false;
  double slant_range_m = 0.0;
  double ground_range_m = 0.0;  ///< Arc over a sphere through the reference point.
  double cone_deg = 0.0;        ///< Between velocity and line of sight.
  double grazing_deg = 0.0;
  double twist_deg = 0.0;
  double slope_deg = 0.0;
  double azimuth_deg = 0.0;
  double layover_deg = 0.0;
};

/// The view from a state on a point of the Earth, by the formulas of Volume 1 of the standard.
/// @param state  position, velocity and acceleration, Earth-centred, Earth-fixed
[[nodiscard]] SicdView sicd_view(double time_s, const std::array<core::Vec3, 3>& state_ecf,
                                 const core::Vec3& point_ecf_m);

/// All that a file says of its image.
struct Sicd {
  std::string collector;
  std::string name;                                             ///< CoreName.
  std::string mode = "STRIPMAP";                                ///< "SPOTLIGHT", "STRIPMAP" or "DYNAMIC STRIPMAP".
  std::vector<std::pair<std::string, std::string>> parameters;  ///< Of the collection: name, value.
  std::string application;
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::size_t reference_row = 0;  ///< SCPPixel.
  std::size_t reference_column = 0;
  core::Vec3 reference_ecf_m;
  std::array<radar::Geodetic, 4> corners;  ///< First row first column, first row last column, last last, last first.
  bool ground = false;                     ///< A grid on the ground (PLANE); otherwise of ranges (RGZERO).
  Polynomial2 time_s;                      ///< TimeCOAPoly.
  SicdDirection row;
  SicdDirection column;
  std::string start;  ///< ISO 8601 of time 0, UTC.
  double duration_s = 0.0;
  std::size_t pulses = 0;                    ///< Evenly spaced over the duration; 0: they are not.
  std::array<Polynomial, 3> position_ecf_m;  ///< ARPPoly.
  double lowest_hz = 0.0;
  double highest_hz = 0.0;
  double pulse_width_s = 0.0;  ///< 0: no chirp of one carrier.
  double chirp_rate_hz_per_s = 0.0;
  double sample_rate_hz = 0.0;
  double window_s = 0.0;  ///< Length of reception.
  bool autofocused = false;
  std::string processing;  ///< How the image was made, in words.
  SicdView view;
  std::optional<SicdClosestApproach> approach;  ///< Of images of ranges.
};

/// The name space of the version that is written.
inline constexpr std::string_view sicd_name_space = "urn:SICD:1.3.0";

/// The XML text of an image, version 1.3.0.
[[nodiscard]] std::string sicd_xml(const Sicd& image);

/// How the pixels of a file are stored.
enum class SicdPixel {
  complex_float,  ///< RE32F_IM32F.
  complex_int16,  ///< RE16I_IM16I.
  polar_uint8,    ///< AMP8I_PHS8I: amplitude, by a table where there is one, and phase of 256 to a turn.
};

/// Bytes of a pixel.
[[nodiscard]] std::size_t bytes_of(SicdPixel pixel);

/// What a file of any version from 1.0 on says of the image that is read from it.
struct SicdDescription {
  SicdPixel pixel = SicdPixel::complex_float;
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<float> amplitudes;  ///< Of SicdPixel::polar_uint8: 256, or empty.
  FocusedPlaces places;  ///< Of rows and columns, m; of ranges where the file says them, else from its reference.
  std::vector<std::pair<std::string, std::string>> facts;  ///< For people: name, value.
};

/// Reads an XML text: a description, or what is wrong, which names the element.
/// @param file  for the problem
[[nodiscard]] std::variant<SicdDescription, core::Problem> read_sicd_xml(std::string_view text,
                                                                         const std::string& file);

}  // namespace sarsim::raster
