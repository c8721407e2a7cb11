#pragma once

#include <array>
#include <string>

#include "core/maths/angle.hpp"
#include "core/maths/vector.hpp"
#include "scene/model/shared.hpp"
#include "scene/model/user_function.hpp"

namespace sarsim::scene {

struct CloudPoints;

/// How a point reflects and jitters: what many points have in common.
struct TargetTraits {
  /// The same cross-section from all sides, or one that depends on the angle from a normal.
  enum class Reflectivity { isotropic, directional };
  /// That dependence: the cosine, or points.
  enum class Gain { cosine, user };

  core::Vec3 position_stddev_m;
  double rcs_stddev_m2 = 0.0;
  Reflectivity reflectivity = Reflectivity::isotropic;
  core::Angle azimuth;  ///< Of the reflecting normal in the platform's frame; Reflectivity::directional.
  core::Angle elevation;
  core::Angle azimuth_stddev;
  core::Angle elevation_stddev;
  Gain gain = Gain::cosine;
  UserFunction<1> gain_db;  ///< Reflectivity [dB] against incidence angle [deg]; Gain::user.

  friend bool operator==(const TargetTraits&, const TargetTraits&) = default;
};

/// Whether they are equal to the last bit, for scripts keep a zero with the sign it was typed with.
[[nodiscard]] bool identical(const TargetTraits& a, const TargetTraits& b);

/// What the world itself is called where a platform is named.
inline std::string world_name() { return "Earth"; }
/// The name of the platform that carries a point.
using SharedName = Shared<std::string, world_name>;

/// A point that reflects (script `$TARGET`, thesis 4.2). There may be millions, so that it is as small as can be.
struct Target {
  using Reflectivity = TargetTraits::Reflectivity;
  using Gain = TargetTraits::Gain;

  SharedName platform;
  core::Vec3 position_m;  ///< In the platform's frame.
  double rcs_m2 = 1.0;
  Shared<TargetTraits> traits;

  friend bool operator==(const Target&, const Target&) = default;
};

/// Many points that reflect alike, from a table in a file (script `$CLOUD`); docs/formats/point-tables.md.
struct Cloud {
  std::string platform = "Earth";
  std::string file = "points.npy";  ///< NPY, CSV or HDF5: x, y, z and perhaps cross-sections.
  double rcs_m2 = 1.0;              ///< Of each point, where the table has no cross-sections.
  TargetTraits traits;              ///< Of each point.

  FileContents<CloudPoints> points;  ///< What the file holds; null until it is read (workflow/input/cloud_input.hpp).

  friend bool operator==(const Cloud&, const Cloud&) = default;
};

/// A triangle that reflects (script `$SURFACE`); its front is where (corner 2 - corner 1) x (corner 3 - corner 1)
/// points.
struct Surface {
  std::string platform = "Earth";
  std::array<core::Vec3, 3> corner_m{core::Vec3{1000.0, 10.0, 0.0}, core::Vec3{1000.0, -10.0, 0.0},
                                     core::Vec3{1000.0, 0.0, 10.0}};

  friend bool operator==(const Surface&, const Surface&) = default;
};

}  // namespace sarsim::scene
