#include "scene/edit/document.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "scene/check/check.hpp"
#include "scene/edit/splice.hpp"
#include "scene/edit/splice_format_2.hpp"
#include "scene/edit/splice_tables.hpp"
#include "scene/edit/text_file.hpp"
#include "scene/language/format_mark.hpp"
#include "scene/language/scene_reader.hpp"
#include "scene/language/scene_writer.hpp"
#include "scene/script/tokens.hpp"
#include "scene/script/writer.hpp"

namespace sarsim::scene {

namespace fs = std::filesystem;

namespace {

// What ends a line, and with it a comment, depends on the whole text; an edit must not tip that over.
bool keeps_line_ends(std::string_view before, std::string_view after) {
  return line_end_of(before).back() == line_end_of(after).back() || after.find('\r') == std::string_view::npos;
}

}  // namespace

Document::Document() {
  Scene scene;
  scene.platforms.emplace_back();
  load(write_script(scene));
}

Document Document::open(const fs::path& path) {
  Document document;
  std::optional<std::string> bytes = read_text_file(path);
  if (!bytes || script::find_control_byte(*bytes) != std::string_view::npos) {
    ScriptReading reading = read_scene_file(path);
    if (!core::has_errors(reading.problems)) {
      core::Problem problem;
      problem.message = "cannot read the script";
      problem.place.file = path.string();
      reading.problems.push_back(std::move(problem));
    }
    document.findings_ = {core::ranked(std::move(reading.problems)), document.places()};
    return document;
  }
  document.path_ = path;
  document.text_on_disk_ = *bytes;
  document.load(*std::move(bytes));
  return document;
}

Document Document::from_text(std::string text) {
  Document document;
  document.load(std::move(text));
  return document;
}

// Takes up a text as the beginning of the history.
void Document::load(std::string text) {
  text_ = std::move(text);
  ScriptReading reading = read(text_);
  scene_ = std::move(reading.scene);
  commands_.reset();
  findings_ = found_in(std::move(reading));
}

void Document::read_clouds_with(CloudReader reader) {
  cloud_reader_ = std::move(reader);
  read_clouds();
}

void Document::read_clouds() {
  if (!cloud_reader_ || (scene_.clouds.empty() && of_clouds_.empty())) return;
  of_clouds_ = cloud_reader_(scene_, path_.parent_path());
  findings_.reset();
}

bool Document::changed() const { return history_.changed(); }

DataFileLoader Document::disk() const { return disk_loader(path_.parent_path()); }

ScriptReading Document::read(const std::string& text) const {
  return read_scene_text(text, path_.string(), data_.loader(disk()));
}

Document::Findings Document::found_in(ScriptReading reading) const {
  if (!core::has_errors(reading.problems)) {
    core::Problems of_scene = check(scene_);
    std::ranges::copy(of_clouds_, std::back_inserter(of_scene));
    locate(of_scene, reading.places);
    std::ranges::move(of_scene, std::back_inserter(reading.problems));
  }
  return {core::ranked(std::move(reading.problems)), std::move(reading.places)};
}

const Document::Findings& Document::findings() const {
  if (!findings_) findings_ = found_in(read(text_));
  return *findings_;
}

const CommandPlaces& Document::commands() const {
  if (!commands_) {
    const std::string text = last_sound_text().value_or("");
    commands_ = is_format_2(text) ? find_objects(text) : find_commands(text);
  }
  return *commands_;
}

// The last text that could be read; nothing where it is not known.
std::optional<std::string> Document::last_sound_text() const {
  return text_broken_ ? sound_text_ : std::optional(text_);
}

// That of the last text that could be read, or of the present one.
Language Document::language() const {
  return is_format_2(text_broken_ && sound_text_ ? *sound_text_ : text_) ? Language::format_2 : Language::script;
}

// The text that says what the edit makes of the scene.
Document::NewText Document::text_after(const Edit& edit, const DataFileLoader& loader) const {
  const bool is_2 = language() == Language::format_2;
  std::optional<std::string> base = last_sound_text();
  if (!base) base = is_2 ? write_format_2(scene_) : write_script(scene_);
  if (!is_2) return script_after(*base, edit, loader);
  Format2Splice spliced = splice_format_2(*base, scene_, edit, path_.string(), loader);
  TextChanges changes = text_broken_ ? text_difference(text_, spliced.text) : std::move(spliced.changes);
  return {std::move(spliced.text), std::nullopt, std::move(changes)};
}

// The same in the language of 1998.
Document::NewText Document::script_after(const std::string& base, const Edit& edit,
                                         const DataFileLoader& loader) const {
  const bool unknown = text_broken_ && !sound_text_;
  const CommandPlaces found = unknown ? find_commands(base) : CommandPlaces{};
  const CommandPlaces& places = unknown ? found : commands();
  if (places.fits(scene_)) {
    Splice spliced = splice(base, places, edit, loader);
    if (keeps_line_ends(base, spliced.text)) {
      TextChanges changes = text_broken_ ? text_difference(text_, spliced.text) : std::move(spliced.changes);
      return {std::move(spliced.text), std::move(spliced.places), std::move(changes)};
    }
  }
  Scene after = scene_;
  apply(edit, after);
  std::string text = write_script(after);
  TextChanges changes = text_difference(text_, text);
  return {std::move(text), std::nullopt, std::move(changes)};
}

void Document::perform(Edit edit) {
  PendingData data = data_;
  data.follow(edit, true, disk());
  const DataFileLoader loader = data.loader(disk());
  settle_values(edit, loader, language());
  if (changes_nothing(edit)) return;
  NewText next = text_after(edit, loader);
  edit.script = {std::move(next.changes), text_broken_, false};
  history_.perform(edit, scene_);
  note_edit(std::move(edit), true);
  text_ = std::move(next.text);
  commands_ = std::move(next.commands);
  text_broken_ = false;
  sound_text_.reset();
  data_ = std::move(data);
  findings_.reset();
  read_clouds();
}

void Document::type_text(std::string text) {
  if (text == text_) return;
  ScriptReading reading = read(text);
  const bool broken = core::has_errors(reading.problems);
  Edit edit = broken ? Edit{} : difference(scene_, reading.scene, "");
  edit.label = "Edit script";
  edit.merge_key = "script";
  edit.script = {text_difference(text_, text), text_broken_, broken};
  history_.perform(edit, scene_);
  note_edit(std::move(edit), true);
  if (!broken) {
    sound_text_.reset();
    commands_.reset();
  } else if (!text_broken_) {
    sound_text_ = std::move(text_);
  }
  text_ = std::move(text);
  text_broken_ = broken;
  findings_ = found_in(std::move(reading));
  read_clouds();
}

void Document::undo() { follow_history(history_.undo(scene_), false); }

void Document::redo() { follow_history(history_.redo(scene_), true); }

void Document::note_edit(Edit edit, bool forwards) {
  last_edit_ = LastEdit{std::move(edit), forwards};
  ++revision_;
}

// Does to the text what a step of the history has done to the scene.
void Document::follow_history(const Edit& edit, bool forwards) {
  text_ = forwards ? apply_changes(text_, edit.script.changes) : revert_changes(text_, edit.script.changes);
  text_broken_ = forwards ? edit.script.broken_after : edit.script.broken_before;
  sound_text_.reset();
  commands_.reset();
  data_.follow(edit, forwards, disk());
  note_edit(edit, forwards);
  findings_.reset();
  read_clouds();
}

void Document::save(const fs::path& path) {
  write_text_file(path, text_);
  path_ = path;
  text_on_disk_ = text_;
  history_.mark_saved();
  findings_.reset();  // they name the file, and data files are looked for beside it
  read_clouds();
}

bool Document::changed_on_disk() const { return !path_.empty() && read_text_file(path_) != text_on_disk_; }

}  // namespace sarsim::scene
