#include "scene/edit/document_data.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "scene/edit/text_file.hpp"
#include "scene/language/format_mark.hpp"
#include "scene/language/scene_writer.hpp"
#include "scene/script/reader.hpp"
#include "scene/script/writer.hpp"

namespace sarsim::scene {

namespace fs = std::filesystem;

namespace {

template <class Object>
void add_names(const std::vector<Object>& objects, std::set<std::string>& names) {
  for (const Object& object : objects) {
    if constexpr (std::is_same_v<Object, Target>)
      if (object.traits->gain_db.file.empty()) continue;  // there may be millions of targets
    const SharedObject kept(object);
    for (const FunctionUse& function : functions_of(kept))
      if (!function.file->empty()) names.insert(*function.file);
  }
}

std::set<std::string> files_of(const Scene& scene) {
  std::set<std::string> names;
  add_names(scene.platforms, names);
  add_names(scene.targets, names);
  add_names(scene.clouds, names);
  for (const Cloud& cloud : scene.clouds)
    if (!cloud.file.empty()) names.insert(cloud.file);
  add_names(scene.radars, names);
  return names;
}

// Points of functions are written into the script; those of clouds stay where they are.
// @param folder  of the script
void forget_files(Scene& scene, const fs::path& folder) {
  for (Platform& p : scene.platforms)
    for (auto* function : {&p.trajectory_m, &p.rotation_deg, &p.position_envelope, &p.rotation_envelope})
      function->file.clear();
  for (Target& target : scene.targets)
    if (!target.traits->gain_db.file.empty()) target.traits.edit().gain_db.file.clear();
  for (Cloud& cloud : scene.clouds) {
    cloud.traits.gain_db.file.clear();
    std::error_code failure;
    const fs::path found = fs::absolute(data_file_on_disk(folder, cloud.file), failure);
    if (!failure && !cloud.file.empty()) cloud.file = found.string();
  }
  for (Radar& r : scene.radars)
    for (std::string* file : {&r.pulse_iq.file, &r.envelope_gain.file, &r.pri_s.file, &r.carrier_list_hz.file,
                              &r.transmit_antenna.gain_db.file, &r.receive_antenna.gain_db.file,
                              &r.beam_target_world_m.file, &r.window_gain.file, &r.stc_gain.file})
      file->clear();
}

// Where a reader of the script looks first; names from systems that part folders with a backslash may mean either.
fs::path place_of(const fs::path& folder, const std::string& name) {
  std::error_code ignored;
  fs::path as_typed = (folder / name).lexically_normal();
  if (name.find('\\') == std::string::npos || fs::exists(as_typed, ignored)) return as_typed;
  std::string slashed = name;
  std::ranges::replace(slashed, '\\', '/');
  return (folder / slashed).lexically_normal();
}

// "" and "." and what they stand for are one folder.
fs::path folder_of(const fs::path& script) {
  std::error_code unknown;
  const fs::path whole = fs::weakly_canonical(fs::absolute(script, unknown), unknown);
  return (unknown ? script : whole).parent_path();
}

}  // namespace

std::vector<DataFileWrite> data_to_write(const Document& document, const fs::path& script) {
  const auto& pending = document.pending_data();
  const bool moves = document.path().empty() || folder_of(document.path()) != folder_of(script);
  if (pending.empty() && !moves) return {};
  const DataFileLoader at_old = disk_loader(document.path().parent_path());
  const DataFileLoader at_new = disk_loader(script.parent_path());
  std::vector<DataFileWrite> files;
  std::set<std::string> names = files_of(document.scene());
  for (const IncludedText& included : document.included()) names.insert(included.name);
  for (const std::string& name : names) {
    const auto edited = pending.find(name);
    if (edited == pending.end() && !moves) continue;
    DataFileText wanted = edited != pending.end() ? DataFileText{name, edited->second, {}} : at_old(name);
    if (!wanted.failure.empty()) continue;
    if (const DataFileText found = at_new(name); found.failure.empty() && found.text == wanted.text) continue;
    fs::path path = place_of(script.parent_path(), name);
    std::error_code ignored;
    const bool replaces = fs::exists(path, ignored);
    files.push_back({name, std::move(path), std::move(wanted.text), replaces});
  }
  return files;
}

std::string self_contained_script(const Document& document) {
  const bool alone = files_of(document.scene()).empty() && document.included().empty();
  if (alone || document.text_broken() || core::has_errors(document.problems())) return document.text();
  Scene scene = document.scene();
  forget_files(scene, document.path().parent_path());
  return is_format_2(document.text()) ? write_format_2(scene) : write_script(scene);
}

void write_data(const std::vector<DataFileWrite>& files) {
  for (const DataFileWrite& file : files) {
    const fs::path folder = file.path.parent_path();
    std::error_code failure;
    if (!folder.empty() && !fs::is_directory(folder, failure)) {
      fs::create_directories(folder, failure);
      if (failure)
        throw std::runtime_error(fmt::format("cannot make the folder {}: {}", folder.string(), failure.message()));
    }
    write_text_file(file.path, file.text);
  }
}

}  // namespace sarsim::scene
