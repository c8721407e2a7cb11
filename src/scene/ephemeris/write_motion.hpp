#pragma once

#include <array>
#include <span>
#include <string>

#include "core/maths/sampled_function.hpp"
#include "scene/ephemeris/attitude_file.hpp"
#include "scene/ephemeris/motion_sample.hpp"

namespace sarsim::scene {

/// The table t, x, y, z, vx, vy, vz that `read_ephemeris` reads, in s, m and m/s; t is the time of the samples. With an
/// Earth the axes are Earth-fixed (ECEF, ITRF); without one they are those of the world, which `read_ephemeris` refuses
/// because its positions are orbits. Numbers read back as the same doubles; ECEF itself is rounded to 4.7e-10 m.
///
/// Refuses no samples, too many of them, numbers that are not finite, times that do not ascend, and, with an Earth,
/// what `read_ephemeris` would refuse: places 900 m below the ellipsoid or 1e9 m from its centre.
[[nodiscard]] MotionText write_motion_csv(std::span<const MotionSample> samples, const MotionFacts& facts);

/// A CCSDS orbit ephemeris message 2.0 (502.0-B-2, keyword = value) of one segment: Earth-fixed axes (ITRF), UTC, km
/// and km/s. Reading it gives the same doubles of ECEF in m and m/s; times of whole femtoseconds, which are
/// within 1e-12 s of the samples' up to two hours from the epoch.
///
/// Refuses what `write_motion_csv` refuses, and: no epoch or no Earth, times before 1972 or after 9999, a leap second
/// between the first and the last sample, times less than 1e-12 s apart, fewer samples than the interpolation needs, a
/// creation date that is none, and names that cannot stand in such a message.
[[nodiscard]] MotionText write_motion_oem(std::span<const MotionSample> samples, const MotionFacts& facts);

/// A CCSDS attitude ephemeris message 1.0 (504.0-B-1, keyword = value) of quaternions with the scalar last, from ITRF
/// to SC_BODY_1, which are the axes of the platform as they are. Neighbours have one sign. Read back, an attitude is
/// within 1e-15 of the one given, as far as that is a rotation. Refuses what `write_motion_oem` refuses, where it
/// concerns attitudes, and matrices that are no rotations within 1e-6.
/// @param interpolation  by which attitudes should be read; nothing is said about it as a rule
[[nodiscard]] MotionText write_attitude_aem(std::span<const AttitudeSample> samples, const MotionFacts& facts,
                                            InterpolationHint interpolation = {});

/// The functions x, y and z of time in the world frame: what `write_data_file` writes for the block `trajectory` of a
/// script.
[[nodiscard]] std::array<core::SampledFunction, 3> trajectory_functions(
    std::span<const MotionSample> samples, core::Interpolation method = core::Interpolation::cubic);

/// The quaternion of a rotation, with w >= 0: `turned_from_first` of it gives the matrix back. From the largest of the
/// four squares, so that no precision is lost at any angle (Shepperd 1978). Expects a rotation.
[[nodiscard]] Quaternion quaternion_of(const core::Mat3& turned_from_first);

}  // namespace sarsim::scene
