#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/report/problem.hpp"
#include "raster/table/array_attributes.hpp"
#include "raster/table/value_rule.hpp"

/// Attributes of arrays that define their numbers (NetCDF Climate and Forecast Metadata Conventions), interpreted in
/// one place for all formats that have them (HDF5, Zarr). A key is honoured, or refused by name;
/// docs/formats/samples.md.
namespace sarsim::raster {

/// What the numbers of an array are as they are stored.
struct NumberKind {
  bool whole = false;
  bool has_sign = true;
};

/// A unit of samples.
struct SampleUnit {
  bool counts = false;  ///< Counts of the converter; otherwise multiples of a volt.
  double volts = 1.0;   ///< How many volts it is; 1 for counts.
};

/// The unit of samples that a word means: V, mV, uV, nV, volts, count and the like; nothing for others.
[[nodiscard]] std::optional<SampleUnit> unit_of_samples(std::string_view word);

/// The attributes of the samples: how their numbers become samples, and whether these are counts.
struct SampleMeaning {
  ValueRule rule;
  bool counts = false;
};

/// Understands `units`, `scale_factor`, `_FillValue`, `missing_value`, `valid_range`, `valid_min`, `valid_max`;
/// `add_offset` other than 0 is refused, as it is not said what it means for I and Q, and `_Unsigned` where it
/// contradicts the type. Any of them that cannot be read is refused by its name. A problem without a place.
/// @param what  the array, for the problems: "/samples"
/// @param kind  of its numbers; whole ones without units and scale are counts
[[nodiscard]] std::variant<SampleMeaning, core::Problem> meaning_of_samples(const ArrayAttributes& attributes,
                                                                            const std::string& what, NumberKind kind);

/// How the numbers of an axis become those of its SI unit: number * factor + offset.
struct AxisMeaning {
  double factor = 1.0;
  double offset = 0.0;
  ValueRule valid = {};  ///< Stored numbers that stand for none, or lie outside what is valid; its scale means nothing.
};

/// Understands `units`, `scale_factor` and `add_offset` of an axis, and which numbers are missing by the same
/// attributes as for samples. Units of the same kind are converted, others refused. Without units the numbers have
/// those of the axis' name.
/// @param what   the axis, for the problems: "/pulse_time_s"
/// @param units  what it is measured in, as `axis_words` and `pose_axes` write it
[[nodiscard]] std::variant<AxisMeaning, core::Problem> meaning_of_axis(const ArrayAttributes& attributes,
                                                                       const std::string& what, std::string_view units,
                                                                       NumberKind kind);

/// The first number of an axis that stands for none by its attributes: an axis has to be there as a whole. A problem
/// without a place.
/// @param stored  numbers as they are stored
/// @param first   position of the first of them
[[nodiscard]] std::optional<core::Problem> problem_of_missing(const AxisMeaning& meaning, const std::string& what,
                                                              std::span<const double> stored, std::size_t first = 0);

/// The error of dimensions whose names show that the array is transposed: an axis of columns along the rows, or the
/// reverse. All other names are accepted. A problem without a place.
/// @param names  of the dimensions in order; an empty text for one without a name
[[nodiscard]] std::optional<core::Problem> problem_of_dimensions(const std::vector<std::string>& names,
                                                                 const std::string& what);

/// A unit as a multiple of that of SI: "km" is 1000 "m". Nothing for unknown ones.
[[nodiscard]] std::optional<std::pair<double, std::string_view>> si_unit_of(std::string_view word);

}  // namespace sarsim::raster
