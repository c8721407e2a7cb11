#include "raster/hdf5/hdf5_points.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/task/stop_points.hpp"
#include "raster/hdf5/hdf5_attributes.hpp"
#include "raster/hdf5/hdf5_dataset.hpp"
#include "raster/hdf5/hdf5_numbers.hpp"
#include "raster/table/cf_attributes.hpp"
#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace {

constexpr const char* points_path = "/points";
constexpr const char* points_name = "the dataset /points";
constexpr const char* points_sound = "sound";
constexpr std::uint64_t points_at_once = std::uint64_t{1} << 18U;  // numbers

// The dataset of a file that stays open with it.
struct PointsDataset {
  Hdf5Handle file;
  Hdf5Dataset dataset;
  AxisMeaning meaning;
};

std::variant<PointsDataset, core::Problem> open_points(const std::filesystem::path& path, std::uint64_t file_bytes) {
  auto opened_file = open_hdf5_file(path);
  if (auto* problem = std::get_if<core::Problem>(&opened_file)) return std::move(*problem);
  Hdf5Handle file = std::move(std::get<Hdf5Handle>(opened_file));
  if (!has_object(file.get(), points_path))
    return file_problem({}, fmt::format("the file has no dataset {}", points_path), list_of_datasets(file.get()),
                        "N rows and 3 or 4 columns: x, y, z and cross-section",
                        "h5copy -i IN.h5 -s /NAME -o OUT.h5 -d /points copies a dataset to that name");
  auto opened = open_dataset(file.get(), points_path, file_bytes);
  if (auto* problem = std::get_if<core::Problem>(&opened)) return std::move(*problem);
  Hdf5Dataset& dataset = std::get<Hdf5Dataset>(opened);
  const H5T_class_t kind = H5Tget_class(dataset.type.get());
  if (kind != H5T_FLOAT && kind != H5T_INTEGER)
    return file_problem({}, fmt::format("the dataset {} does not hold numbers", points_path), {},
                        "float32, float64 or whole numbers");
  if (dataset.shape.size() != 2 || dataset.shape[0] == 0 || dataset.shape[1] == 0)
    return file_problem({}, fmt::format("the dataset {} is not a table", points_path),
                        fmt::format("{} dimension{}", dataset.shape.size(), dataset.shape.size() == 1 ? "" : "s"),
                        "rows and columns");
  // Columns are metres and square metres, so that one factor means nothing.
  const auto said = meaning_of_axis(read_attributes(dataset.id.get(), file_bytes, true), points_name, "m",
                                    kind_of_numbers(dataset.type.get()));
  if (const auto* problem = std::get_if<core::Problem>(&said)) return *problem;
  if (const auto& meaning = std::get<AxisMeaning>(said); meaning.factor != 1.0 || meaning.offset != 0.0)
    return file_problem({}, "the numbers of /points are not metres and square metres (units, scale_factor, add_offset)",
                        fmt::format("times {:g}, plus {:g}", meaning.factor, meaning.offset), "as they are",
                        "convert them and remove the attributes");
  return PointsDataset{std::move(file), std::move(dataset), std::get<AxisMeaning>(said)};
}

// Rows [first, first + count).
std::vector<double> points_of_rows(const Hdf5Dataset& dataset, std::uint64_t first, std::uint64_t count) {
  const Hdf5Numbers numbers(dataset.type.get());
  std::vector<double> points(static_cast<std::size_t>(count * dataset.shape[1]));
  std::vector<std::byte> stored(points.size() * numbers.bytes());
  const std::array<hsize_t, 2> start{first, 0};
  const std::array<hsize_t, 2> size{count, dataset.shape[1]};
  const Hdf5Handle place(H5Dget_space(dataset.id.get()), H5Sclose);
  const Hdf5Handle memory(H5Screate_simple(2, size.data(), nullptr), H5Sclose);
  if (H5Sselect_hyperslab(place.get(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr) < 0 ||
      H5Dread(dataset.id.get(), numbers.type(), memory.get(), place.get(), H5P_DEFAULT, stored.data()) < 0)
    throw std::runtime_error("HDF5: " + hdf5_error_text());
  numbers.convert(stored, points);
  return points;
}

std::uint64_t rows_at_once(const Hdf5Dataset& dataset) {
  return std::max<std::uint64_t>(points_at_once / dataset.shape[1], 1);
}

// What the child process does: the word that all is well, or what is wrong.
std::string tried_points(const std::filesystem::path& path, std::uint64_t file_bytes) {
  const Hdf5Use use;
  const auto opened = open_points(path, file_bytes);
  if (std::holds_alternative<core::Problem>(opened)) return points_sound;  // Said by the parent.
  const Hdf5Dataset& dataset = std::get<PointsDataset>(opened).dataset;
  const std::uint64_t rows = std::min(dataset.shape[0], rows_at_once(dataset));
  static_cast<void>(points_of_rows(dataset, 0, rows));
  static_cast<void>(points_of_rows(dataset, dataset.shape[0] - rows, rows));
  return points_sound;
}

std::optional<core::Problem> trial_of_points(const std::filesystem::path& path, std::uint64_t file_bytes,
                                             const core::StopFlag* stop) {
  const core::IsolatedReport trial = hdf5_trial([&] { return tried_points(path, file_bytes); }, stop);
  if (trial.result == core::IsolatedResult::passed && trial.text == points_sound) return std::nullopt;
  if (trial.result == core::IsolatedResult::too_much_work) return too_much_hdf5_work();
  const char* const what = trial.result == core::IsolatedResult::crashed ? "crashes on it" : "cannot read all of it";
  return file_problem({}, fmt::format("the file is damaged: the HDF5 library {}", what));
}

}  // namespace

std::optional<core::Problem> read_hdf5_points(const std::filesystem::path& path, std::uint64_t file_bytes,
                                              const NumberTableTaker& taker) {
  if (auto problem = trial_of_points(path, file_bytes, taker.stop)) return problem;
  const Hdf5Use use;
  const auto opened = open_points(path, file_bytes);
  if (const auto* problem = std::get_if<core::Problem>(&opened)) return *problem;
  const Hdf5Dataset& dataset = std::get<PointsDataset>(opened).dataset;
  if (auto problem = taker.begin(dataset.shape[0], dataset.shape[1])) return problem;
  const std::uint64_t step = rows_at_once(dataset);
  try {
    for (std::uint64_t first = 0; first < dataset.shape[0]; first += step) {
      core::end_if_asked(taker.stop);
      std::vector<double> points = points_of_rows(dataset, first, std::min(step, dataset.shape[0] - first));
      const AxisMeaning& meaning = std::get<PointsDataset>(opened).meaning;
      if (auto problem = problem_of_missing(meaning, points_name, points, first * dataset.shape[1])) return problem;
      taker.take(first, std::move(points));
    }
  } catch (const core::Interrupted&) {
    throw;
  } catch (const std::runtime_error& error) {
    return file_problem({}, "the file is damaged: the HDF5 library cannot read all of it", error.what());
  }
  return std::nullopt;
}

}  // namespace sarsim::raster
