#include "scene/edit/document.hpp"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <utility>

#include "core/toml/scan.hpp"
#include "scene/check/check.hpp"
#include "scene/edit/splice.hpp"
#include "scene/edit/splice_format_2.hpp"
#include "scene/edit/splice_tables.hpp"
#include "scene/edit/text_file.hpp"
#include "scene/language/format_mark.hpp"
#include "scene/language/json_text.hpp"
#include "scene/language/scene_reader.hpp"
#include "scene/language/scene_writer.hpp"
#include "scene/model/orbit.hpp"
#include "scene/script/tokens.hpp"
#include "scene/script/writer.hpp"

namespace sarsim::scene {

namespace fs = std::filesystem;

namespace {

// A text in either language, also one that is typed half.
ScriptReading read_draft(const std::string& text, const fs::path& path, PendingData& data) {
  ReadControl control;
  control.draft = true;
  return read_scene_text(text, path.string(), data.loader(disk_loader(path.parent_path())), control);
}

// What reading a text has shown, and what is wrong with its scene and with the files that this reads.
Document::Findings findings_of(ScriptReading reading, const Scene& scene, const core::Problems& of_files) {
  if (!core::has_errors(reading.problems)) {
    core::Problems of_scene = check(scene);
    std::erase_if(of_scene, [&](const core::Problem& problem) {
      return std::ranges::find(reading.of_names, problem.subject, &core::Problem::subject) != reading.of_names.end();
    });
    core::append(of_scene, std::move(reading.of_names));
    core::append(of_scene, of_files);
    locate(of_scene, reading.places);
    core::append(reading.problems, std::move(of_scene));
  }
  return {core::ranked(std::move(reading.problems)), std::move(reading.places), std::move(reading.names)};
}

// What ends a line, and with it a comment, depends on the whole text; an edit must not tip that over.
bool keeps_line_ends(std::string_view before, std::string_view after) {
  return line_end_of(before).back() == line_end_of(after).back() || after.find('\r') == std::string_view::npos;
}

}  // namespace

Document::Document() {
  Scene scene;
  scene.platforms.emplace_back();
  load(write_format_2(scene));
}

Document Document::open(const fs::path& path) {
  Document document;
  // Whoever has the document on a screen cannot wait for the other end of a pipe.
  std::error_code ignored;
  if (fs::is_fifo(path, ignored)) {
    document.findings_ = {{core::error("cannot read the script: it is a pipe")
                               .hint("write what comes out of it into a file")
                               .in(path.string())},
                          document.places(),
                          {}};
    return document;
  }
  std::optional<std::string> bytes = read_text_file(path);
  const bool json = bytes && language::is_json(*bytes);
  if (!bytes || json || script::find_control_byte(*bytes) != std::string_view::npos) {
    ScriptReading reading = read_scene_file(path);
    if (json && !core::has_errors(reading.problems)) {
      document.load(write_format_2(reading.scene));
      return document;
    }
    if (!core::has_errors(reading.problems)) {
      reading.problems.push_back(core::error("cannot read the script").in(path.string()));
    }
    document.findings_ = {core::ranked(std::move(reading.problems)), document.places(), {}};
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
  scene_ = std::make_shared<Scene>(std::move(reading.scene));
  forget_places();
  findings_ = found_in(std::move(reading));
}

void Document::read_files_with(FileReader reader) {
  file_reader_ = std::move(reader);
  read_files();
}

bool Document::reads_files() const {
  const auto reads = [](const Platform& platform) {
    return is_orbit(platform.path) || platform.rotation_kind == Platform::Rotation::quaternions || platform.read_path;
  };
  return !scene_->clouds.empty() || std::ranges::any_of(scene_->platforms, reads);
}

void Document::read_files() {
  if (!file_reader_ || (!reads_files() && of_files_.empty())) return;
  of_files_ = file_reader_(own_scene(), path_.parent_path());
  findings_.reset();
}

bool Document::changed() const { return history_.changed(); }

// The scene, to be changed: what others see stays as it is.
Scene& Document::own_scene() {
  if (scene_.use_count() > 1)
    scene_ = std::make_shared<Scene>(*scene_);
  else
    std::atomic_thread_fence(std::memory_order_acquire);  // another thread has read it to the end
  return *scene_;
}

// The same for an edit, which may be one of the text alone, or none.
Scene& Document::scene_for(const Edit* edit) {
  const bool changes =
      edit != nullptr && (!edit->changes.empty() || edit->options_after || edit->world_after || edit->air_after);
  return changes ? own_scene() : *scene_;
}

DataFileLoader Document::disk() const { return disk_loader(path_.parent_path()); }

ScriptReading Document::read(const std::string& text) const {
  if (language::is_json(text)) {
    ScriptReading reading;
    reading.problems.push_back(
        core::error("a scene in JSON cannot be edited").hint("open its file: it then goes on in TOML"));
    return reading;
  }
  return read_draft(text, path_, data_);
}

Document::Findings Document::found_in(ScriptReading reading) const {
  return findings_of(std::move(reading), *scene_, of_files_);
}

// The scene of a text is the one that is edited, as far as its problems go.
std::function<Document::Findings()> Document::search() const {
  if (findings_ || reads_files() || !of_files_.empty() || language::is_json(text_)) return {};
  return [text = text_, path = path_, data = data_]() mutable {
    ScriptReading reading = read_draft(text, path, data);
    const Scene scene = std::move(reading.scene);
    return findings_of(std::move(reading), scene, {});
  };
}

void Document::take(Findings found, std::uint64_t revision) {
  if (revision == revision_ && !findings_) findings_ = std::move(found);
}

const Document::Findings& Document::findings() const {
  if (!findings_) findings_ = found_in(read(text_));
  return *findings_;
}

const CommandPlaces& Document::commands() const {
  if (!commands_) {
    static const std::string nothing;
    const std::string& text = sound_text() != nullptr ? *sound_text() : nothing;
    commands_ = is_format_2(text) ? find_objects(text, tables()) : find_commands(text);
  }
  return *commands_;
}

// The last text that could be read; null where it is not known.
const std::string* Document::sound_text() const {
  if (!text_broken_) return &text_;
  return sound_text_ ? &*sound_text_ : nullptr;
}

// Of the last text that could be read, which is in format 2.
const format_2::ObjectTables& Document::tables() const {
  if (!tables_) tables_ = format_2::find_tables(*sound_text());
  return *tables_;
}

void Document::forget_places() {
  commands_.reset();
  tables_.reset();
  included_.reset();
}

std::vector<IncludedText> Document::included() const {
  const std::string* const text = sound_text();
  if (text == nullptr || !is_format_2(*text)) return {};
  return included_texts(*text, path_.string(), data_.loader(disk()));
}

bool Document::touches_included(const Edit& edit) const {
  if (language() != Language::format_2 || sound_text() == nullptr) return false;
  return std::ranges::any_of(edit.changes, [&](const ObjectChange& change) {
    const std::size_t all = count_of(*scene_, change.id.kind);
    return change.before && change.id.index + std::min(all, commands()[change.id.kind].size()) < all;
  });
}

// What another program has changed meanwhile stays as it is.
void Document::change_included(const ScriptChange& change, bool forwards, PendingData& data) const {
  const DataFileLoader loader = data.loader(disk());
  for (const auto& [name, changes] : change.included) {
    const std::string now = loader(name).text;
    try {
      data.put(name, forwards ? apply_changes(now, changes) : revert_changes(now, changes));
    } catch (const std::logic_error&) {
    }
  }
}

namespace {

TypedFields typed_of(format_2::TypedObject said, ObjectId id, const Scene& scene) {
  TypedFields fields;
  const AnyObject object = object_of(scene, id);
  for (const Field& field : fields_of(id.kind))
    if (has_default(field)) fields[field.id] = said.typed(object, field);
  return fields;
}

}  // namespace

TypedFields Document::typed_fields(std::optional<ObjectId> id) const {
  const std::string* const text = sound_text();
  TypedFields fields;
  if (text == nullptr || !is_format_2(*text)) return fields;
  if (!id) {
    std::optional<format_2::TypedObject> said;
    if (tables().options) said.emplace(*text, tables(), *tables().options);
    for (const Field& field : option_fields())
      if (has_default(field)) fields[field.id] = said ? said->typed(scene_->options, field) : TypedField{false};
    return fields;
  }
  const std::vector<TextStretch>& places = commands()[id->kind];
  const std::size_t included = count_of(*scene_, id->kind) - std::min(places.size(), count_of(*scene_, id->kind));
  if (!has_object(*scene_, *id)) return fields;
  if (id->index < included) return typed_in_included(*id);
  const std::size_t index = id->index - included;
  const format_2::ObjectTable* const table = format_2::table_with(tables(), id->kind, index);
  if (table == nullptr) return fields;
  std::optional<core::toml::Value> row;
  if (table->positions) row = {core::toml::Kind::array, core::toml::span_of(places[index].begin, places[index].end)};
  return typed_of(format_2::TypedObject(*text, tables(), *table, row), *id, *scene_);
}

// The same of an object of an included file, as the files were when they were first asked for since the last change.
TypedFields Document::typed_in_included(ObjectId id) const {
  if (!included_) included_ = included();
  std::size_t before = 0;
  for (const IncludedText& file : *included_) {
    const std::size_t own = counts_of(file.tables)[static_cast<std::size_t>(id.kind)];
    const std::size_t index = id.index - before;
    before += own;
    if (index >= own) continue;
    const format_2::ObjectTable* const table = format_2::table_with(file.tables, id.kind, index);
    std::optional<core::toml::Value> row;
    if (table->positions) row = format_2::rows_of(file.text, *table->positions).at(index - table->preceding);
    return typed_of(format_2::TypedObject(file.text, file.tables, *table, row), id, *scene_);
  }
  return {};
}

const LetNames* Document::let_names() const { return language() == Language::format_2 ? &findings().names : nullptr; }

// The expressions of fields whose values an edit changes, but for those that were typed into.
std::vector<ReplacedExpression> Document::expressions_at_stake(const Edit& edit) const {
  constexpr std::size_t max_objects = 1000;
  std::vector<ReplacedExpression> found;
  const auto look = [&](std::optional<ObjectId> id, const auto& before, const auto& after) {
    for (auto& [field_id, typed] : typed_fields(id)) {
      if (typed.expression.empty() || field_text(before, field_id) == field_text(after, field_id)) continue;
      const std::vector<Field>& fields = id ? fields_of(id->kind) : option_fields();
      const Field* const field = &*std::ranges::find(fields, field_id, &Field::id);
      const auto is_it = [&](const TypedText& text) { return text.object == id && text.field == field; };
      if (std::ranges::none_of(edit.typed, is_it)) found.push_back({id, field, typed.expression});
    }
  };
  const auto replaces = [](const ObjectChange& change) { return change.before && change.after; };
  if (!std::ranges::all_of(edit.changes, replaces)) return found;
  for (std::size_t i = 0; i < std::min(edit.changes.size(), max_objects); ++i) {
    const ObjectChange& change = edit.changes[i];
    look(change.id, *change.before, *change.after);
  }
  if (edit.options_before && edit.options_after) look(std::nullopt, *edit.options_before, *edit.options_after);
  return found;
}

void Document::drop_those_kept(std::vector<ReplacedExpression>& expressions) const {
  std::erase_if(expressions, [&](const ReplacedExpression& was) {
    const TypedFields now = typed_fields(was.object);
    const auto typed = now.find(was.field->id);
    return typed != now.end() && typed->second.expression == was.expression;
  });
}

Language Document::language() const {
  return is_format_2(sound_text() != nullptr ? *sound_text() : text_) ? Language::format_2 : Language::script;
}

// The text that says what the edit makes of the scene.
Document::NewText Document::text_after(const Edit& edit, const DataFileLoader& loader) const {
  const bool is_2 = language() == Language::format_2;
  const bool known = sound_text() != nullptr;
  const std::string written = known ? "" : is_2 ? write_format_2(*scene_) : write_script(*scene_);
  const std::string& base = known ? *sound_text() : written;
  if (!is_2) return script_after(base, edit, loader);
  Format2Splice spliced =
      known ? splice_format_2(base, tables(), touches_included(edit) ? included() : std::vector<IncludedText>{},
                              *scene_, edit, path_.string(), loader)
            : splice_format_2(base, format_2::find_tables(base), {}, *scene_, edit, path_.string(), loader);
  NewText next{std::move(spliced.text), std::nullopt, {}, std::move(spliced.included)};
  if (spliced.rows_alone && known) {
    next.tables = format_2::after_changes(tables(), spliced.changes);
    if (commands_) next.commands = after_changes(*commands_, spliced.changes);
  }
  next.changes = text_broken_ ? text_difference(text_, next.text) : std::move(spliced.changes);
  return next;
}

// The same in the language of 1998.
Document::NewText Document::script_after(const std::string& base, const Edit& edit,
                                         const DataFileLoader& loader) const {
  const bool unknown = text_broken_ && !sound_text_;
  const CommandPlaces found = unknown ? find_commands(base) : CommandPlaces{};
  const CommandPlaces& places = unknown ? found : commands();
  if (places.fits(*scene_)) {
    Splice spliced = splice(base, places, edit, loader);
    if (keeps_line_ends(base, spliced.text)) {
      TextChanges changes = text_broken_ ? text_difference(text_, spliced.text) : std::move(spliced.changes);
      return {std::move(spliced.text), std::move(spliced.places), std::move(changes), {}};
    }
  }
  Scene after = *scene_;
  apply(edit, after);
  std::string text = write_script(after);
  TextChanges changes = text_difference(text_, text);
  return {std::move(text), std::nullopt, std::move(changes), {}};
}

void Document::perform(Edit edit) {
  PendingData data = data_;
  data.follow(edit, true, disk());
  const DataFileLoader loader = data.loader(disk());
  settle_values(edit, loader, language());
  replaced_.clear();
  if (changes_nothing(edit) && edit.typed.empty()) return;
  std::vector<ReplacedExpression> at_stake = expressions_at_stake(edit);
  NewText next = text_after(edit, loader);
  if (edit.world_after) follow_world(edit, next.text);
  edit.script = {std::move(next.changes), std::move(next.included), text_broken_, false};
  edit.typed.clear();
  if (changes_nothing(edit)) return;
  change_included(edit.script, true, data);
  Scene& scene = scene_for(&edit);
  note_edit(history_.perform(std::move(edit), scene), true);
  text_ = std::move(next.text);
  forget_places();
  commands_ = std::move(next.commands);
  tables_ = std::move(next.tables);
  text_broken_ = false;
  sound_text_.reset();
  drop_those_kept(at_stake);
  replaced_ = std::move(at_stake);
  data_ = std::move(data);
  findings_.reset();
  read_files();
}

std::string Document::world_objection(const World& world) const {
  const Edit edit = change_world(*scene_, world);
  if (changes_nothing(edit)) return {};
  const ScriptReading reading = read(text_after(edit, data_.loader(disk())).text);
  const auto error = std::ranges::find(reading.problems, core::Severity::error, &core::Problem::severity);
  return error == reading.problems.end() ? std::string() : error->message;
}

// What stands on the Earth by its latitude has other coordinates in another world.
void Document::follow_world(Edit& edit, const std::string& text) const {
  Edit whole = difference(*scene_, read(text).scene, edit.label);
  whole.merge_key = std::move(edit.merge_key);
  edit = std::move(whole);
}

void Document::type_text(std::string text) {
  if (text == text_) return;
  ScriptReading reading = read(text);
  const bool broken = core::has_errors(reading.problems);
  Edit edit = broken ? Edit{} : difference(*scene_, reading.scene, "");
  edit.label = "Edit script";
  edit.merge_key = "script";
  edit.script = {text_difference(text_, text), {}, text_broken_, broken};
  Scene& scene = scene_for(&edit);
  note_edit(history_.perform(std::move(edit), scene), true);
  if (!broken) {
    sound_text_.reset();
    forget_places();
  } else if (!text_broken_) {
    sound_text_ = std::move(text_);
  }
  text_ = std::move(text);
  text_broken_ = broken;
  findings_ = found_in(std::move(reading));
  read_files();
}

void Document::undo() { follow_history(history_.undo(scene_for(history_.next_undo())), false); }

void Document::take_back() {
  undo();
  history_.forget_undone();
}

void Document::redo() { follow_history(history_.redo(scene_for(history_.next_redo())), true); }

void Document::note_edit(std::shared_ptr<const Edit> edit, bool forwards) {
  last_edit_ = LastEdit{std::move(edit), forwards};
  ++revision_;
}

// Does to the text what a step of the history has done to the scene.
void Document::follow_history(std::shared_ptr<const Edit> edit, bool forwards) {
  const ScriptChange& script = edit->script;
  text_ = forwards ? apply_changes(text_, script.changes) : revert_changes(text_, script.changes);
  text_broken_ = forwards ? script.broken_after : script.broken_before;
  sound_text_.reset();
  forget_places();
  data_.follow(*edit, forwards, disk());
  change_included(script, forwards, data_);
  note_edit(std::move(edit), forwards);
  findings_.reset();
  read_files();
}

void Document::save(const fs::path& path) {
  write_text_file(path, text_);
  path_ = path;
  text_on_disk_ = text_;
  history_.mark_saved();
  findings_.reset();  // they name the file, and data files are looked for beside it
  read_files();
}

bool Document::changed_on_disk() const { return !path_.empty() && read_text_file(path_) != text_on_disk_; }

}  // namespace sarsim::scene
