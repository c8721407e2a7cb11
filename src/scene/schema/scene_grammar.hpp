#pragma once

#include "scene/model/scene.hpp"
#include "scene/schema/grammar.hpp"

/// Fields and keywords of `$PLATFORM`, `$TARGET`, `$SURFACE`, `$SIMULATION`, `$GEOMETRY` and `$OPTIONS`.
namespace sarsim::scene::script {

inline constexpr std::array<std::string_view, 7> command_words{"TARGET",  "PLATFORM", "RADAR",  "SIMULATION",
                                                               "SURFACE", "GEOMETRY", "OPTIONS"};

inline constexpr Alternatives<core::Interpolation, 3> interpolations{
    {{"CUBIC", core::Interpolation::cubic, "cubic pieces"},
     {"MFILTER", core::Interpolation::low_pass, "low-pass filter"},
     {"LINEAR", core::Interpolation::linear, "straight lines"}}};

namespace platform_grammar {

inline constexpr Field name{"name", "name of the platform"};
inline constexpr Field path{"path", "kind of path"};
inline constexpr Field position{"position_m", "position", "m"};
inline constexpr Field trajectory{"trajectory_m", "trajectory"};
inline constexpr Field aligned{"aligned", "alignment with the path"};
inline constexpr Field rotation_kind{"rotation_kind", "kind of rotation"};
inline constexpr Field rotation{"rotation", "rotation about", "deg"};
inline constexpr Field rotation_user{"rotation_deg", "rotation"};
inline constexpr Field rotation_rate{"rotation_rate", "rotation rate about", "deg/s"};
inline constexpr Field position_error{"position_error", "kind of position errors"};
inline constexpr Field position_stddev{"position_stddev_m", "standard deviation of position", "m", 0, zero_or_more};
inline constexpr Field position_envelope{"position_envelope", "envelope of the position errors"};
inline constexpr Field rotation_error{"rotation_error", "kind of rotation errors"};
inline constexpr Field rotation_stddev{"rotation_stddev", "standard deviation of the rotation about", "deg", 0,
                                       zero_or_more};
inline constexpr Field rotation_envelope{"rotation_envelope", "envelope of the rotation errors"};

inline constexpr Alternatives<Platform::Path, 2> paths{
    {{"STATIONARY", Platform::Path::stationary, "the platform stays where it is"},
     {"TRAJECTORY", Platform::Path::trajectory, "the platform follows a path"}}};
inline constexpr Alternatives<bool, 2> alignments{
    {{"NOT_ALIGNED", false, "keeps its own attitude"}, {"ALIGNED", true, "x axis along the velocity"}}};
inline constexpr Alternatives<Platform::Rotation, 2> rotations{
    {{"CONST", Platform::Rotation::constant, "rotation given by angles and rates"},
     {"OTHER", Platform::Rotation::user, "rotation given by functions of time"}}};
inline constexpr Alternatives<Platform::MotionError, 2> position_errors{
    {{"STDDEV", Platform::MotionError::gaussian, "position errors drawn anew for each pulse"},
     {"OTHER", Platform::MotionError::envelope, "position errors of a given correlation"}}};
inline constexpr Alternatives<Platform::MotionError, 2> rotation_errors{
    {{"STDDEV", Platform::MotionError::gaussian, "rotation errors drawn anew for each pulse"},
     {"OTHER", Platform::MotionError::envelope, "rotation errors of a given correlation"}}};

}  // namespace platform_grammar

namespace target_grammar {

inline constexpr Field platform{"platform", "name of the platform"};
inline constexpr Field position{"position_m", "position", "m"};
inline constexpr Field position_stddev{"position_stddev_m", "standard deviation of position", "m", 0, zero_or_more};
inline constexpr Field rcs{"rcs_m2", "radar cross-section", "m^2"};
inline constexpr Field rcs_stddev{"rcs_stddev_m2", "standard deviation of the radar cross-section", "m^2", 0,
                                  zero_or_more};
inline constexpr Field reflectivity{"reflectivity", "kind of reflectivity"};
inline constexpr Field azimuth{"azimuth", "azimuth of the target's face", "deg"};
inline constexpr Field elevation{"elevation", "elevation of the target's face", "deg"};
inline constexpr Field azimuth_stddev{"azimuth_stddev", "standard deviation of the azimuth", "deg", 0, zero_or_more};
inline constexpr Field elevation_stddev{"elevation_stddev", "standard deviation of the elevation", "deg", 0,
                                        zero_or_more};
inline constexpr Field gain{"gain", "law of reflectivity"};
inline constexpr Field gain_user{"gain_db", "reflectivity"};

inline constexpr Alternatives<Target::Reflectivity, 2> reflectivities{
    {{"ISOTROPIC", Target::Reflectivity::isotropic, ""}, {"DIRECTIONAL", Target::Reflectivity::directional, ""}}};
inline constexpr Alternatives<Target::Gain, 2> gains{
    {{"COS_GAIN", Target::Gain::cosine, "cosine of the incidence angle"},
     {"OTHER_GAIN", Target::Gain::user, "function of the incidence angle"}}};

}  // namespace target_grammar

namespace surface_grammar {

inline constexpr Field platform{"platform", "name of the platform"};
inline constexpr Field corner{"corner_m", "corner", "m"};

}  // namespace surface_grammar

namespace simulation_grammar {

inline constexpr Field radar{"radar", "name of the radar"};
inline constexpr Field range_start{"range_start_m", "slant range of the first sample", "m"};
inline constexpr Field range_end{"range_end_m", "slant range of the end", "m"};
inline constexpr Field time_start{"time_start_s", "slow time of the start", "s"};
inline constexpr Field time_end{"time_end_s", "slow time of the end", "s"};
inline constexpr Field bits{"bits", "bits of the A/D converter", "", 0, {1.0, 64.0}};
inline constexpr Field sample_rate{"sample_rate_hz", "sampling frequency", "GHz", 9, above_zero};
inline constexpr Field lsb{"lsb_v", "value of the least significant bit", "mV", -3, any_value, "0 = estimated"};
inline constexpr Field format{"format", "file format"};
inline constexpr Field processing{"processing", "processing"};
inline constexpr Field file{"file", "name of the output file"};
inline constexpr Field pulse_position{"pulse_position", "place of a target within its pulse"};
inline constexpr Field oversampling{"oversampling",
                                    "pulse over-sampling factor",
                                    "",
                                    0,
                                    {1.0, 100.0},
                                    "above 1 a band-limited pulse keeps its own band only"};
inline constexpr Field width_factor{
    "width_factor", "kept length of a band-limited pulse in pulse widths", "", 0, {1.0, 100.0}};

inline constexpr Alternatives<FileFormat, 6> formats{
    {{"ASCII", FileFormat::ascii, "text, a line for each sample: I Q"},
     {"BINARY", FileFormat::binary, "unsigned little-endian integers"},
     {"BRACKET", FileFormat::bracket, "text, a line for each pulse: (I,Q)"},
     {"HDF5", FileFormat::hdf5, "HDF5 file"},
     {"CSV", FileFormat::csv, "text, a line for each pulse: I,Q"},
     {"NPY", FileFormat::npy, "NumPy array"}}};
inline constexpr Alternatives<Processing, 3> processings{
    {{"RAW", Processing::raw, "samples as received"},
     {"MATCHED_FILTER", Processing::matched_filter, "compressed in range"},
     {"SRP", Processing::srp, "synthetic range profiles of stepped carriers"}}};
inline constexpr Alternatives<Simulation::PulsePosition, 2> pulse_positions{
    {{"BEGIN", Simulation::PulsePosition::begin, "a target's range is where its pulse begins"},
     {"CENTRE", Simulation::PulsePosition::centre, "a target's range is the centre of its pulse"}}};

}  // namespace simulation_grammar

namespace geometry_grammar {

inline constexpr Field radar{"radar", "name of the radar"};
inline constexpr Field range_start{"range_start_m", "slant range of the start", "m"};
inline constexpr Field range_end{"range_end_m", "slant range of the end", "m"};
inline constexpr Field time_start{"time_start_s", "slow time of the start", "s"};
inline constexpr Field time_end{"time_end_s", "slow time of the end", "s"};
inline constexpr Field separator{"separator", "separator of columns"};
inline constexpr Field columns{"columns",
                               "sum of the column bits",
                               "",
                               0,
                               {0.0, 255.0},
                               "1 time, 2 frequency, 4 position, 8 velocity, 16 rotation, 32 delay, 64 amplitude, "
                               "128 radial speed"};
inline constexpr Field file{"file", "name of the output file"};

inline constexpr Alternatives<GeometryTable::Separator, 2> separators{
    {{"SPACE", GeometryTable::Separator::space, "columns separated by blanks"},
     {"COMMA", GeometryTable::Separator::comma, "columns separated by commas"}}};

}  // namespace geometry_grammar

namespace options_grammar {

/// What `$OPTIONS` can say.
enum class Key { profile, seed, pulse, tolerance };

inline constexpr Field key{"", "option"};
inline constexpr Field profile{"profile", "profile"};
inline constexpr Field seed{"seed", "seed of the random numbers"};
inline constexpr Field pulse{"pulse", "definition of the pulse"};
inline constexpr Field tolerance{"tolerance", "tolerated relative error of the echoes", "", 0, above_zero};

inline constexpr Alternatives<Key, 4> keys{{{"PROFILE", Key::profile, ""},
                                            {"SEED", Key::seed, ""},
                                            {"PULSE", Key::pulse, ""},
                                            {"TOLERANCE", Key::tolerance, ""}}};
inline constexpr Alternatives<Profile, 2> profiles{
    {{"CLASSIC", Profile::classic, "conventions of the 1998 programs"},
     {"PHYSICAL", Profile::physical, "conventions of radar engineering"}}};
inline constexpr Alternatives<PulseDefinition, 2> pulses{
    {{"IDEAL", PulseDefinition::ideal, "hard edges, sampled where they are"},
     {"BAND_LIMITED", PulseDefinition::band_limited, "confined to the sampled band"}}};

}  // namespace options_grammar

}  // namespace sarsim::scene::script
