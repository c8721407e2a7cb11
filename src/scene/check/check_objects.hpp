#pragma once

#include <cstddef>
#include <optional>

#include "radar/waveform/schedule.hpp"
#include "scene/check/check_findings.hpp"
#include "scene/check/check_names.hpp"
#include "scene/model/scene.hpp"

/// The parts of `check`, one for each kind of object. Each expects `findings.about` to have named the object.
namespace sarsim::scene {

void check_platform(Findings& findings, const Platform& platform);
void check_target(Findings& findings, NameCheck& platforms, const Target& target);
void check_cloud(Findings& findings, NameCheck& platforms, const Cloud& cloud);
/// How many points will fill a surface, about: its area in square metres, of a thin one its length in metres.
[[nodiscard]] double points_of(const Surface& surface);
void check_surface(Findings& findings, NameCheck& platforms, const Surface& surface);
void check_radar(Findings& findings, NameCheck& platforms, const Radar& radar);
void check_simulation(Findings& findings, NameCheck& radars, const Scene& scene, const Simulation& simulation);
void check_geometry_table(Findings& findings, NameCheck& radars, const Scene& scene, const GeometryTable& table);
/// Warns of paths that may deviate, between their points, from the smooth path the points were taken from by more than
/// a sixteenth of the wavelength of a radar that looks: a quarter of pi in the phase of an echo.
void check_paths_between_points(Findings& findings, const Scene& scene);
/// Reports functions given by points that are used beyond their points, with their values there (FunctionEnds): gains
/// of the receiver at ranges of a recording, pulses and windows, and motions of more than two points at times of a
/// recording. simulate/survey/table_rules.hpp covers those that depend on the positions of targets.
void check_function_ends(Findings& findings, const Scene& scene);
void check_options(Findings& findings, const RunOptions& options);

/// Warns of values of a radar that can be simulated but are probably mistakes.
void check_plausible_radar(Findings& findings, const Radar& radar);
/// The same of a simulation by this radar. @param pulses  of its window; none if that is not sound
void check_plausible_simulation(Findings& findings, const Scene& scene, const Simulation& simulation,
                                const Radar& radar, const radar::PulseRange& pulses);

/// Warns of products whose files would have one name.
void check_file_names(Findings& findings, const Scene& scene);

/// When a radar's pulses leave; nothing where its repetition is faulty.
[[nodiscard]] std::optional<radar::Repetition> repetition_of(const Radar& radar);

/// Bandwidth by which a radar's sampling is judged [Hz], the same that `bandwidth_hz` has for its pulse (decision 7);
/// nothing where the pulse is faulty.
[[nodiscard]] std::optional<double> nominal_bandwidth_hz(const Radar& radar);

}  // namespace sarsim::scene
