#include "workflow/input/function_tables.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "raster/format/load_hdf5.hpp"
#include "scene/schema/field_table.hpp"
#include "scene/script/reader.hpp"
#include "scene/script/table_file.hpp"

namespace sarsim::workflow {

namespace {

namespace fs = std::filesystem;

scene::DataFileReading read_hdf5_table(const scene::DataFileText& file, const scene::FunctionBlock& block,
                                       const core::WorkControl& control) {
  std::size_t columns = 0;
  std::vector<double> numbers;
  raster::NumberTableTaker taker;
  taker.stop = control.stop;
  taker.begin = [&](std::uint64_t, std::uint64_t wide) -> std::optional<core::Problem> {
    columns = static_cast<std::size_t>(wide);
    return std::nullopt;
  };
  taker.take = [&](std::uint64_t, std::span<const double> rows) {
    numbers.insert(numbers.end(), rows.begin(), rows.end());
  };
  if (auto problem = raster::hdf5_module(file.path).read_points(file.path, file.text.size(), taker)) {
    problem->place.file = file.path;
    scene::DataFileReading failed;
    failed.problems.push_back(*std::move(problem));
    return failed;
  }
  return scene::functions_of_table(numbers, std::max<std::size_t>(columns, 1), file.path, block);
}

// Of one function that names a file and has no points yet.
core::Problems read_table(const scene::FieldSpec& spec, const scene::FunctionRef& function,
                          const scene::DataFileLoader& loader, const core::WorkControl& control) {
  const bool is_read = std::ranges::any_of(function.parts, [](const auto& part) { return !part.knots.empty(); });
  if (function.file->empty() || is_read) return {};
  const scene::DataFileText file = loader(*function.file);
  if (!file.failure.empty() || !scene::is_hdf5(file.text)) return {};
  scene::DataFileReading read = read_function_data(file, *spec.block, control);
  if (core::has_errors(read.problems)) return std::move(read.problems);
  for (std::size_t i = 0; i < function.parts.size(); ++i) function.parts[i].knots = std::move(read.functions[i]);
  return std::move(read.problems);
}

template <class Object>
core::Problems read_tables_of(std::vector<Object>& objects, std::string_view kind, const scene::DataFileLoader& loader,
                              const core::WorkControl& control) {
  core::Problems all;
  const scene::FieldTable<Object>& table = scene::table_of<Object>();
  for (std::size_t i = 0; i < objects.size(); ++i)
    for (const scene::FieldOf<Object>& field : table.fields()) {
      if (field.function == nullptr || !table.applies(objects[i], field)) continue;
      for (core::Problem& problem : read_table(field.spec, field.function(objects[i]), loader, control)) {
        problem.subject = {std::string(kind), i, std::string(field.spec.problem_place())};
        all.push_back(std::move(problem));
      }
    }
  return all;
}

// A million targets share what they have in common, and the table that is read for the first of them.
core::Problems read_tables_of_targets(std::vector<scene::Target>& targets, const scene::DataFileLoader& loader,
                                      const core::WorkControl& control) {
  core::Problems all;
  scene::Shared<scene::TargetTraits> before, after;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (targets[i].traits->gain_db.file.empty()) continue;
    if (&*before != &*targets[i].traits) {
      before = targets[i].traits;
      std::vector<scene::Target> one{targets[i]};
      core::Problems problems = read_tables_of(one, "target", loader, control);
      for (core::Problem& problem : problems) problem.subject.index = i;
      core::append(all, std::move(problems));
      after = one.front().traits;
    }
    targets[i].traits = after;
  }
  return all;
}

}  // namespace

scene::DataFileReading read_function_data(const scene::DataFileText& file, const scene::FunctionBlock& block,
                                          const core::WorkControl& control) {
  return scene::is_hdf5(file.text) ? read_hdf5_table(file, block, control)
                                   : scene::read_data_file(file.text, file.path, block);
}

core::Problems read_function_tables(scene::Scene& scene, const fs::path& folder, const core::WorkControl& control) {
  const scene::DataFileLoader loader = scene::disk_loader(folder);
  core::Problems all;
  core::append(all, read_tables_of(scene.platforms, "platform", loader, control));
  core::append(all, read_tables_of(scene.radars, "radar", loader, control));
  core::append(all, read_tables_of_targets(scene.targets, loader, control));
  core::append(all, read_tables_of(scene.clouds, "cloud", loader, control));
  return all;
}

}  // namespace sarsim::workflow
