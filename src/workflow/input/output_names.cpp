#include "workflow/input/output_names.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/os/output_file.hpp"
#include "core/report/invalid_request.hpp"
#include "raster/format/envi.hpp"
#include "raster/format/zarr_store.hpp"
#include "raster/table/formats.hpp"
#include "workflow/input/recording_hints.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

std::string without_drive(const std::string& name) {
  const bool drive = name.size() >= 2 && name[1] == ':' && ((name[0] | 0x20) >= 'a') && ((name[0] | 0x20) <= 'z');
  return drive ? name.substr(2) : name;
}

// One product's name on its way to a path.
class Namer {
 public:
  explicit Namer(const OutputRules& rules, core::Problems& problems) : rules_(rules), problems_(problems) {}

  // @param format  of a recording; nothing for a table
  fs::path place(const std::string& name, const core::Subject& subject, std::optional<scene::FileFormat> format) {
    const std::string base = base_name(name);
    if (base.empty() || base == "." || base == "..") {
      problems_.push_back(
          core::error("the output has no file name").found(name).expected("a name such as out.asc").at(subject));
      return {};
    }
    fs::path path = base;
    if (rules_.keep_paths) {
      std::string kept = without_drive(name);
      std::ranges::replace(kept, '\\', '/');
      path = kept;
      if (leads_out(path)) {
        problems_.push_back(core::error("the output's name leads out of the folder of the run")
                                .found(name)
                                .expected("a name below that folder")
                                .hint("write the name without a slash at its beginning and without ..")
                                .at(subject));
        return {};
      }
    }
    path = (rules_.folder / path).lexically_normal();
    if (format && rules_.format) path.replace_extension(raster::extension_of(*rules_.format));
    // `check` has warned of names that are alike in the script.
    const bool told = !met_.insert(name.substr(name.find_last_of("/\\") + 1)).second;
    const auto written = format && rules_.format ? rules_.format : format;
    return distinct(path, subject, told, written ? &raster::format_of(*written) : nullptr);
  }

 private:
  static bool leads_out(const fs::path& name) {
    return name.is_absolute() || name.lexically_normal().begin()->string() == "..";
  }

  // Takes all files that a product of this name becomes, unless one of them is that of another product.
  bool take(const fs::path& path, const raster::Format* format) {
    std::vector<fs::path> files = raster::files_of(format, path);
    files.push_back(path);
    if (std::ranges::any_of(files, [this](const fs::path& file) { return taken_.contains(file); })) return false;
    taken_.insert(files.begin(), files.end());
    return true;
  }

  fs::path distinct(const fs::path& path, const core::Subject& subject, bool told, const raster::Format* format) {
    fs::path result = path;
    // Where the last of this name found a free one, so that many of one name are not all tried again.
    int& number = numbers_.try_emplace(path.string(), 2).first->second;
    for (; !take(result, format); ++number)
      result.replace_filename(fmt::format("{}-{}{}", path.stem().string(), number, path.extension().string()));
    if (result != path && !told)
      problems_.push_back(
          core::warning("output.name-taken",
                        fmt::format("another product of the scene is written to '{}'; this one becomes '{}'",
                                    path.filename().string(), result.filename().string()))
              .hint("give each product a name of its own")
              .at(subject));
    return result;
  }

  const OutputRules& rules_;
  core::Problems& problems_;
  std::set<fs::path> taken_;
  std::map<std::string, int> numbers_;
  std::set<std::string> met_;
};

// A folder that is missing has no links in it.
bool is_linked_out_of(const fs::path& folder, const fs::path& path) {
  std::error_code failure;
  const fs::path inside = fs::canonical(folder, failure);
  if (failure) return false;
  const fs::path end = fs::weakly_canonical(core::end_of_links(path), failure);
  return !failure && std::ranges::mismatch(inside, end).in1 != inside.end();
}

// The Zarr store of this program that a file is a part of; empty where there is none.
fs::path store_around(const fs::path& path) {
  fs::path folder = file_place(path).parent_path();
  for (int depth = 0; depth < 2 && folder.has_relative_path(); ++depth, folder = folder.parent_path())
    if (raster::is_own_zarr_store(folder)) return folder;
  return {};
}

// What to do where an output cannot have the name that an option or a word of the command line gave it.
std::string another_file(const std::string& option) {
  return fmt::format("name another file {} {}", option.starts_with('-') ? "with" : "as", option);
}

// Images of one name and different endings share the name of their header, which can only be that of one of them.
core::Problems problems_of_header(const fs::path& path, const std::vector<fs::path>& outputs) {
  core::Problems problems;
  if (path.extension() != ".hdr") return problems;
  for (const fs::path& image : raster::images_of_header(path)) {
    const bool replaced =
        std::ranges::any_of(outputs, [&](const fs::path& output) { return file_place(output) == file_place(image); });
    if (replaced) continue;
    problems.push_back(
        core::error(fmt::format("the header of the image '{}' would be replaced; without it, the image cannot be read",
                                image.string()))
            .found(path.string())
            .hint("give the output a name that differs before its ending, too"));
  }
  return problems;
}

}  // namespace

std::string base_name(const std::string& name) {
  const std::string bare = without_drive(name);
  const std::size_t slash = bare.find_last_of("/\\");
  return slash == std::string::npos ? bare : bare.substr(slash + 1);
}

OutputNames output_names(const scene::Scene& scene, const OutputRules& rules) {
  OutputNames names;
  Namer namer(rules, names.problems);
  for (std::size_t i = 0; i < scene.simulations.size(); ++i)
    names.simulations.push_back(
        namer.place(scene.simulations[i].file, {"simulation", i, "file"}, scene.simulations[i].format));
  for (std::size_t i = 0; i < scene.geometries.size(); ++i)
    names.tables.push_back(namer.place(scene.geometries[i].file, {"geometry", i, "file"}, std::nullopt));
  return names;
}

std::optional<std::size_t> simulation_that_writes(const fs::path& file, const scene::Scene& scene,
                                                  const std::string& hint) {
  const auto alike = [&](std::optional<scene::FileFormat> format) {
    std::vector<std::string> names;
    for (const fs::path& path : output_names(scene, {".", false, format}).simulations)
      names.push_back(path.filename().string());
    return std::pair(names_alike(names, file), names);
  };
  const auto [found, names] = alike({});
  if (found.found.size() > 1 && !found.whole)
    throw core::InvalidRequest(fmt::format("'{}' could come from {} or from {}", file.filename().string(),
                                           names[found.found[0]], names[found.found[1]]),
                               hint);
  if (!found.found.empty()) return found.found.front();
  const auto with_format = alike(raster::format_from_path(file)).first;
  if (with_format.found.empty() || !with_format.whole) return std::nullopt;
  return with_format.found.front();
}

RunOutput run_output(const fs::path& out) {
  // A slash at the end says that it is a folder.
  if (!out.has_filename() || !raster::format_from_path(out)) return {out, std::nullopt};
  if (fs::is_directory(out) && !raster::is_own_zarr_store(out)) return {out, std::nullopt};
  return {out.has_parent_path() ? out.parent_path() : fs::path("."), out};
}

void expect_output_folder(const fs::path& out) {
  if (fs::is_directory(out)) return;
  if (fs::exists(out))
    throw core::InvalidRequest("'" + out.string() + "' is not a folder",
                               "name a folder with --out; it is made when missing");
  if (out.has_filename() && raster::format_from_path(out))
    throw core::InvalidRequest(fmt::format("--out takes a folder, and '{}' is the name of a file", out.string()),
                               "name a folder; the files in it have the names that the scene gives them");
}

fs::path chosen_folder(const fs::path& out) { return out == "." ? fs::path() : out; }

void expect_free_outputs(const std::vector<fs::path>& paths, const OutputCare& care) {
  core::Problems problems;
  std::map<fs::path, fs::path> taken;  // File, and the output that is it.
  for (const fs::path& path : paths) {
    core::append(problems, problems_of_output(path, care));
    core::append(problems, problems_of_header(path, paths));
    const auto [known, is_new] = taken.emplace(file_place(path), path);
    if (is_new) continue;
    problems.push_back({});
    if (known->second.lexically_normal() != path.lexically_normal()) {
      problems.back().message =
          fmt::format("two outputs are one file through a link: '{}' and '{}'", known->second.string(), path.string());
      problems.back().hint = "remove the link, or name another file";
      continue;
    }
    problems.back().message = fmt::format("'{}' is the name of two outputs", path.string());
    problems.back().hint = path.extension() == ".hdr" ? "the header of an image has this ending; name the image .img"
                                                      : "give each of them a name of its own";
  }
  if (!problems.empty()) throw core::InvalidRequest(std::move(problems));
}

void expect_free_outputs(const std::vector<fs::path>& paths, const fs::path& source, bool force) {
  expect_free_outputs(paths, OutputCare{{source}, force, "--out"});
}

core::Problems problems_of_output(const fs::path& path, const OutputCare& care) {
  std::error_code ignored;
  if (!care.folder.empty() && is_linked_out_of(care.folder, path)) {
    return {core::error(fmt::format("a symbolic link leads this output out of the folder '{}'", care.folder.string()))
                .found(path.string())
                .hint("remove the link, or choose with --out the folder that it leads to")};
  }
  const std::string another =
      care.option.empty() ? "give the output another name, or another folder with --out" : another_file(care.option);
  const fs::file_status status = fs::status(path, ignored);
  if (auto harm = care.sources.harm_of(path, care.force)) {
    harm->hint = another;
    return {*std::move(harm)};
  }
  if (!fs::exists(status)) return {};
  core::Problem problem;
  problem.found = path.string();
  problem.hint = another;
  const auto format = raster::format_from_path(path);
  const bool to_folder = format && raster::format_of(*format).folder;
  if (fs::is_directory(status) && !raster::is_own_zarr_store(path)) {
    problem.message = to_folder ? "the output's name belongs to a folder that is not a Zarr store of this program"
                                : "the output's name belongs to a folder";
  } else if (to_folder && !fs::is_directory(status)) {
    problem.message = "the output's name belongs to a file, and a Zarr store is a folder";
  } else if (const fs::path store = store_around(path); !store.empty()) {
    problem.message = fmt::format("the output would replace a part of the Zarr store '{}'", store.string());
  } else if (!care.force) {
    problem.message = "the output exists already";
    problem.hint = "replace it with --force, or " +
                   (care.option.empty() ? std::string("choose another folder with --out") : another_file(care.option));
  } else {
    return {};
  }
  return {problem};
}

core::Problems problems_of_output(const fs::path& path, const fs::path& source, bool force) {
  return problems_of_output(path, OutputCare{{source}, force, "--out"});
}

}  // namespace sarsim::workflow
