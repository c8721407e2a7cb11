#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/maths/sampled_function.hpp"
#include "core/report/problem.hpp"
#include "scene/model/function_role.hpp"
#include "scene/model/object.hpp"
#include "scene/script/data_file.hpp"

namespace sarsim::scene {

/// What the function editor needs to know of one user-defined function of a field (thesis 4.6).
struct FunctionInfo {
  /// One of the functions that belong together.
  struct Part {
    std::string name;  ///< "Position X", "Gain (azimuth)".
    std::string y_unit;
    std::array<double, 2> y_range;  ///< Shown at first.
    FunctionRole role;              ///< Decides its values beyond its points.
  };
  std::string title;  ///< "Trajectory of Ship".
  std::vector<Part> parts;
  std::string x_name;  ///< "Time", "Offset".
  std::string x_unit;
  std::array<double, 2> x_range;
  std::array<double, 2> x_limits;  ///< What is legal; infinities where all is.
  std::array<double, 2> y_limits;
  bool per_pulse = false;  ///< y of each pulse in turn: bars, x is only the number.
};

/// The function held by a field of kind `function`; std::invalid_argument for another field.
[[nodiscard]] FunctionInfo function_info(const AnyObject& object, std::string_view field);

/// A function of one to three parts as it is edited. Knots stay sorted by x; at least one stays.
struct FunctionDraft {
  std::vector<core::SampledFunction> parts;
  std::string file;  ///< Empty: INLINE.

  friend bool operator==(const FunctionDraft&, const FunctionDraft&) = default;
};

/// The function as the object holds it; setting it again changes nothing. std::invalid_argument for a field of another
/// kind and, of the second, for a draft with another number of parts.
[[nodiscard]] FunctionDraft function_of(const AnyObject& object, std::string_view field);
void set_function(AnyObject& object, std::string_view field, const FunctionDraft& draft);

/// Puts a knot halfway between knot `at` and the next (one unit behind the last), on the line between them; returns its
/// number. The first knot of an empty function is (0, 0).
std::size_t insert_knot(core::SampledFunction& function, std::size_t at);
/// Removes a knot unless it is the last one left.
void remove_knot(core::SampledFunction& function, std::size_t at);
/// Moves a knot, keeping x between the neighbours' (a hundredth of the decade of the axis away from them where there is
/// room) and both inside the limits; returns its number. Of a function of the pulse number only y moves.
std::size_t move_knot(core::SampledFunction& function, std::size_t at, core::Knot to, const FunctionInfo& info);
/// Rounds to about a hundredth of the decade of an axis's range, as a dragged point is.
[[nodiscard]] double rounded_to_range(double value, double range);

/// Points of the curve for drawing, `count` of them evenly from x0 to x1, by the method given; beyond the knots by the
/// rules of the profile `physical`. Knots that do not ascend are taken in order of x, the first of equals alone.
[[nodiscard]] std::vector<core::Knot> curve_points(const core::SampledFunction& function, FunctionRole role,
                                                   core::Interpolation method, double x0, double x1, std::size_t count);

/// Text of a `.dat` file with the header of comments (scene/script/data_file.hpp), and back. A file that was read is
/// the draft's `file`; interpolation is no part of it and stays that of the object. With an error among the problems
/// the draft is the object's function as it was. Points must be finite.
[[nodiscard]] std::string function_file_text(const AnyObject& object, std::string_view field,
                                             const FunctionDraft& draft);
struct FunctionReading {
  FunctionDraft draft;
  core::Problems problems;
};
/// @param data  what the file has for the function's block: `read_data_file`, or the table of an HDF5 file
[[nodiscard]] FunctionReading read_function_file(const AnyObject& object, std::string_view field, DataFileReading data,
                                                 const std::string& file_name);
/// Reads CSV: x in the first column, one column for each part; a first line of names is skipped, but its units in
/// brackets are taken ("f [GHz]"), else the units of FunctionInfo. A function of the pulse number may do without the
/// first column. Empty cells give no point; lines need not be in order. The draft is INLINE. With an error among the
/// problems the draft is the object's function as it was.
[[nodiscard]] FunctionReading import_function_csv(const AnyObject& object, std::string_view field,
                                                  std::string_view text, const std::string& file_name);

}  // namespace sarsim::scene
