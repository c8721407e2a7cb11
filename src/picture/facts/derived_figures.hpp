#pragma once

#include <string>
#include <vector>

#include "scene/model/object_id.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::picture {

/// A figure that follows from an object: "Wavelength", "5.66 cm", with its formula.
struct DerivedFigure {
  std::string label;
  std::string text;
  std::string formula;
};
/// Derived values of an object: of a radar wavelength, resolutions, unambiguous range and velocity, duty cycle, mean
/// power, noise; of a target range, delay, radial speed and SNR as each radar sees it at `time_s`, without random
/// errors; of a simulation its pulses, samples, size and sampling ratio; of a platform where it is and how fast at
/// `time_s`; of a surface its area and points. Figures that errors of the scene stand in the way of are left out. Never
/// throws; quick enough for every keystroke, because only the objects concerned are looked at.
[[nodiscard]] std::vector<DerivedFigure> derived_figures(const scene::Scene& scene, scene::ObjectId id, double time_s);

}  // namespace sarsim::picture
