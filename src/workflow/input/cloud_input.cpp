#include "workflow/input/cloud_input.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "core/hash/checksum.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/model/cloud_points.hpp"
#include "scene/model/limits.hpp"
#include "scene/model/world_frame.hpp"
#include "scene/script/reader.hpp"
#include "workflow/input/cloud_table.hpp"

namespace sarsim::workflow {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t range_points = std::size_t{1} << 16;
constexpr std::string_view npy_mark = "\x93NUMPY";
constexpr std::string_view hdf5_mark = "\x89HDF\r\n\x1a\n";

// What a look at all points finds.
struct PointsFound {
  core::Vec3 min_m{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                   std::numeric_limits<double>::infinity()};
  core::Vec3 max_m = -1.0 * min_m;
  std::uint64_t sum = 0;
  std::size_t negative = 0;    // cross-sections
  std::size_t bad_row = none;  // of the first value that cannot be computed with
  std::size_t bad_column = 0;
  double bad_value = 0.0;

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
};

void look_at_column(PointsFound& found, const std::vector<double>& column, std::size_t number, std::size_t begin,
                    std::size_t end, double core::Vec3::*axis) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  bool sound = true;
  for (std::size_t i = begin; i < end; ++i) {
    sound = sound && scene::computable(column[i]);
    least = std::min(least, column[i]);
    most = std::max(most, column[i]);
  }
  if (axis != nullptr) {
    found.min_m.*axis = least;
    found.max_m.*axis = most;
  }
  for (std::size_t i = begin; !sound && i < std::min(end, found.bad_row); ++i)
    if (!scene::computable(column[i])) {
      found.bad_row = i;
      found.bad_column = number;
      found.bad_value = column[i];
    }
}

// Looks at some points and makes roots of their cross-sections.
PointsFound take_points(radar::PointArrays& arrays, std::size_t begin, std::size_t end) {
  PointsFound found;
  look_at_column(found, arrays.x_m, 1, begin, end, &core::Vec3::x);
  look_at_column(found, arrays.y_m, 2, begin, end, &core::Vec3::y);
  look_at_column(found, arrays.z_m, 3, begin, end, &core::Vec3::z);
  look_at_column(found, arrays.root_rcs_m, 4, begin, end, nullptr);
  core::Checksum sum;
  for (std::vector<double>* column : {&arrays.x_m, &arrays.y_m, &arrays.z_m, &arrays.root_rcs_m})
    sum.add(std::as_bytes(std::span(*column).subspan(begin, end - begin)));
  found.sum = sum.value();
  for (std::size_t i = begin; i < end; ++i) {
    const double rcs_m2 = arrays.root_rcs_m[i];
    found.negative += rcs_m2 < 0.0 ? 1 : 0;
    arrays.root_rcs_m[i] = std::sqrt(std::max(0.0, rcs_m2));
  }
  return found;
}

PointsFound take_points(radar::PointArrays& arrays, const core::WorkControl& control) {
  std::vector<PointsFound> parts((arrays.size() + range_points - 1) / range_points);
  core::parallel_ranges(arrays.size(), range_points, control, [&](std::size_t begin, std::size_t end) {
    parts[begin / range_points] = take_points(arrays, begin, end);
  });
  PointsFound all;
  core::Checksum sum;
  for (const PointsFound& part : parts) {
    for (double core::Vec3::*axis : {&core::Vec3::x, &core::Vec3::y, &core::Vec3::z}) {
      all.min_m.*axis = std::min(all.min_m.*axis, part.min_m.*axis);
      all.max_m.*axis = std::max(all.max_m.*axis, part.max_m.*axis);
    }
    all.negative += part.negative;
    if (part.bad_row < all.bad_row) {
      all.bad_row = part.bad_row;
      all.bad_column = part.bad_column;
      all.bad_value = part.bad_value;
    }
    sum.add(std::as_bytes(std::span(&part.sum, 1)));
  }
  all.sum = sum.value();
  return all;
}

std::optional<TableFault> read_table(const core::InputFile& file, PointTable& table, const core::WorkControl& control) {
  std::string mark(8, '\0');
  mark.resize(file.read_at(0, std::as_writable_bytes(std::span(mark))));
  if (mark.starts_with(npy_mark)) return read_npy_points(file, table, control);
  if (mark == hdf5_mark) return read_hdf5_points(file, table, control);
  return read_text_points(file, table, control);
}

bool is_on_world(const scene::Cloud& cloud) { return core::equal_ignoring_case(cloud.platform, "Earth"); }

// Whether what was read still holds: latitudes lie elsewhere in another world.
bool lies_there(const scene::CloudPoints& points, const scene::Cloud& cloud, const scene::World& world) {
  if (!points.anchor) return true;
  return world.frame == scene::World::Frame::earth && is_on_world(cloud) && *points.anchor == scene::anchor_of(world);
}

// What has become of one file.
struct CloudReading {
  std::shared_ptr<const scene::CloudPoints> points;
  core::Problems problems;
};

core::Problem problem_of_file(const std::string& name, TableFault fault) {
  return core::error(fmt::format("{}: {}", name, fault.message))
      .found(std::move(fault.found))
      .expected(std::move(fault.expected))
      .hint(std::move(fault.hint));
}

CloudReading read_file(const scene::Cloud& cloud, const scene::World& world, const fs::path& path,
                       const core::WorkControl& control) {
  const std::string& name = cloud.file;
  const double rcs_m2 = cloud.rcs_m2;
  CloudReading reading;
  auto opened = core::InputFile::open(path);
  if (auto* problem = std::get_if<core::Problem>(&opened)) {
    reading.problems.push_back(problem_of_file(name, {problem->message, problem->found, problem->expected, {}}));
    return reading;
  }
  PointTable table;
  table.rcs_m2 = rcs_m2;
  table.world = world;
  table.platform = cloud.platform;
  std::optional<TableFault> fault = read_table(std::get<core::InputFile>(opened), table, control);
  if (!fault && table.arrays.size() == 0) fault = TableFault{"the table has no points", {}, "a point in each row", {}};
  if (fault) {
    reading.problems.push_back(problem_of_file(name, std::move(*fault)));
    return reading;
  }
  if (!table.own_rcs) std::ranges::fill(table.arrays.root_rcs_m, rcs_m2);
  const PointsFound found = take_points(table.arrays, control);
  if (found.bad_row != PointsFound::none) {
    reading.problems.push_back(problem_of_file(
        name, fault_of_cell(table.row_word, table.first_row + found.bad_row, found.bad_column, found.bad_value)));
    return reading;
  }
  if (found.negative > 0 && table.own_rcs)
    reading.problems.push_back(
        core::warning("cloud.negative-rcs", fmt::format("{}: cross-sections are negative, which counts as zero", name))
            .found(fmt::format("{} of {} points", found.negative, table.arrays.size()))
            .expected("numbers above 0")
            .hint("They are in m2, not in dBsm; a text may name its column rcs_dbsm."));
  reading.points = std::make_shared<const scene::CloudPoints>(
      scene::CloudPoints{std::move(table.arrays), table.own_rcs, rcs_m2, found.min_m, found.max_m, name, found.sum,
                         table.geodetic ? std::optional(scene::anchor_of(world)) : std::nullopt});
  return reading;
}

}  // namespace

void resize(radar::PointArrays& arrays, std::size_t points, const core::WorkControl& control) {
  for (std::vector<double>* column : {&arrays.x_m, &arrays.y_m, &arrays.z_m, &arrays.root_rcs_m}) {
    core::reserve_touched(*column, points, control);
    column->resize(points);
  }
}

TableFault fault_of_cell(std::string_view row_word, std::uint64_t row, std::size_t column, double value) {
  return {std::isfinite(value) ? fmt::format("{} {}, column {} is too large to compute with", row_word, row, column)
                               : fmt::format("{} {}, column {} is not a number", row_word, row, column),
          core::format_number(value),
          "a finite number",
          {}};
}

TableFault fault_of_phase(std::string_view row_word, std::uint64_t row, double value) {
  return {fmt::format("{} {} has a phase, which echoes cannot have yet", row_word, row), core::format_number(value),
          "0, or no fifth column", "Leave the column out."};
}

core::Problems read_clouds(scene::Scene& scene, const fs::path& folder, const core::WorkControl& control) {
  core::Problems problems;
  std::map<std::tuple<std::string, double, bool>, CloudReading> known;
  for (std::size_t i = 0; i < scene.clouds.size(); ++i) {
    scene::Cloud& cloud = scene.clouds[i];
    if (cloud.points && cloud.points->file == cloud.file && lies_there(*cloud.points, cloud, scene.world)) continue;
    cloud.points = {};
    if (cloud.file.empty()) continue;
    const fs::path path = scene::data_file_on_disk(folder, cloud.file);
    CloudReading reading;
    if (path.empty()) {
      reading.problems.push_back(
          core::error("the file of the points is not there")
              .found(cloud.file)
              .expected(fmt::format("a file in '{}' or in the current folder", folder.empty() ? "." : folder.string()))
              .hint("Check the name and the folder; file names are case-sensitive."));
    } else {
      const auto [place, is_new] = known.try_emplace({cloud.file, cloud.rcs_m2, is_on_world(cloud)});
      if (is_new) place->second = read_file(cloud, scene.world, path, control);
      reading = place->second;
    }
    cloud.points = reading.points;
    for (core::Problem& problem : reading.problems) {
      problem.subject = {"cloud", i, "file"};
      problems.push_back(std::move(problem));
    }
  }
  return problems;
}

scene::Cloud cloud_of_points(const std::string& platform, const std::string& file, std::span<const double> positions_m,
                             std::span<const double> rcs_m2, const core::WorkControl& control) {
  const std::size_t count = positions_m.size() / 3;
  if (count == 0) throw core::InvalidRequest("a cloud needs at least one point");
  radar::PointArrays arrays;
  for (const auto column :
       {&radar::PointArrays::x_m, &radar::PointArrays::y_m, &radar::PointArrays::z_m, &radar::PointArrays::root_rcs_m})
    (arrays.*column).resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    arrays.x_m[i] = positions_m[3 * i];
    arrays.y_m[i] = positions_m[3 * i + 1];
    arrays.z_m[i] = positions_m[3 * i + 2];
    arrays.root_rcs_m[i] = rcs_m2.empty() ? 1.0 : rcs_m2[i];
  }
  const PointsFound found = take_points(arrays, control);
  if (found.bad_row != PointsFound::none)
    throw core::InvalidRequest(
        {problem_of_file(file, fault_of_cell("point", found.bad_row + 1, found.bad_column, found.bad_value))});
  scene::Cloud cloud;
  cloud.platform = platform;
  cloud.file = file;
  cloud.points = std::make_shared<const scene::CloudPoints>(scene::CloudPoints{
      std::move(arrays), !rcs_m2.empty(), 1.0, found.min_m, found.max_m, file, found.sum, std::nullopt});
  return cloud;
}

std::size_t cloud_points(const scene::Scene& scene) {
  std::size_t points = 0;
  for (const scene::Cloud& cloud : scene.clouds) points += scene::point_count(cloud);
  return points;
}

}  // namespace sarsim::workflow
