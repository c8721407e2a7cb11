#include "scene/language/sources.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "core/toml/parse.hpp"
#include "core/toml/values.hpp"
#include "scene/language/format_mark.hpp"
#include "scene/language/json_text.hpp"

namespace sarsim::scene::language {

namespace toml = core::toml;

namespace {

// What is read of one file.
class SourceReader {
 public:
  SourceReader(const Source& source, Reading& reading) : source_(source), reading_(reading), lines_(source.typed) {}

  void error(toml::Span at, script::Complaint complaint) {
    const toml::Position position = lines_.at(at.begin);
    reading_.log.add(core::error(std::move(complaint.message))
                         .found(std::move(complaint.found))
                         .expected(std::move(complaint.expected))
                         .hint(std::move(complaint.hint))
                         .in(source_.file, position.line, position.column));
  }

  void report_mistakes() {
    for (const toml::Mistake& mistake : source_.document.mistakes)
      error(mistake.at, {mistake.message, mistake.found, mistake.expected, mistake.hint});
  }

  [[nodiscard]] std::string_view text_of(toml::Span span) const { return toml::piece(source_.text, span); }
  [[nodiscard]] std::string string_of(const toml::Value& value) const {
    return toml::decoded_string(source_.text, value);
  }

  // The entry of a key before all headers.
  [[nodiscard]] const toml::Entry* root_entry(std::string_view key) const {
    const toml::Table& root = source_.document.tables.front();
    for (std::size_t i = 0; i < root.entries; ++i) {
      const toml::Entry& entry = source_.document.entries[root.first_entry + i];
      if (toml::key_parts(source_.text, entry.key) == std::vector<std::string>{std::string(key)}) return &entry;
    }
    return nullptr;
  }

 private:
  const Source& source_;
  Reading& reading_;
  toml::Lines lines_;
};

// What to do about a mark that is not known: "sarsim 3" may be of a later program, "sarsim2" and 2 are mistyped.
std::string remedy_of_mark(const std::string& mark, const std::string& expected) {
  constexpr std::string_view name = "sarsim ";
  const auto number = mark.starts_with(name) ? core::parse_number(mark.substr(name.size())) : std::nullopt;
  return number && *number > 2.0 ? "perhaps the file was written for a newer Sarsim" : "write " + expected;
}

bool has_mark(SourceReader& reader) {
  const toml::Entry* const mark = reader.root_entry("format");
  return mark != nullptr && mark->value.kind == toml::Kind::string && reader.string_of(mark->value) == format_2_mark;
}

// @param included  a file that may never have been meant to be read: a word of it is told
void check_mark(SourceReader& reader, bool included) {
  const toml::Entry* const mark = reader.root_entry("format");
  const std::string expected = fmt::format("format = \"{}\"", format_2_mark);
  if (mark == nullptr)
    reader.error({}, {"the format of the scene is not stated", "", expected,
                      fmt::format("write {} before the first header", expected)});
  else if (!has_mark(reader))
    reader.error(
        mark->value.span,
        {"this format is not known",
         included ? core::quoted_word(reader.text_of(mark->value.span))
                  : script::shown(reader.text_of(mark->value.span)),
         fmt::format("\"{}\"", format_2_mark),
         remedy_of_mark(mark->value.kind == toml::Kind::string ? reader.string_of(mark->value) : "", expected)});
}

// The path of a file that another one names.
std::string beside(const std::string& file, const std::string& name) {
  const std::size_t slash = file.rfind('/');
  return slash == std::string::npos || name.starts_with('/') ? name : file.substr(0, slash + 1) + name;
}

class Taking {
 public:
  Taking(Reading& reading, Sources& sources) : reading_(reading), sources_(sources) {}

  void take_first(std::string_view text, const std::string& file) {
    taken_.insert(std::filesystem::path(file).lexically_normal().string());
    take(text, file, "");
  }

  // @param name  as files beside the scene's own are named
  void take(std::string_view text, const std::string& file, const std::string& name) {
    Source source = source_of(text, file, name);
    SourceReader reader(source, reading_);
    // What an included file that is no scene says is not told: it may never have been meant to be read.
    if (!name.empty() && !has_mark(reader)) {
      reading_.names_lost = true;
      return check_mark(reader, true);
    }
    reader.report_mistakes();
    const auto is_broken = [](const toml::Table& table) { return table.broken; };
    reading_.names_lost = reading_.names_lost || std::ranges::any_of(source.document.tables, is_broken);
    check_mark(reader, !name.empty());
    if (const toml::Entry* const include = reader.root_entry("include"))
      take_included(include->value, reader, source, name);
    sources_.sources.push_back(std::move(source));
  }

 private:
  Source source_of(std::string_view text, const std::string& file, const std::string& name) {
    if (!is_json(text)) return {file, text, toml::parse(text), name, text};
    JsonText json = read_json(text);
    return {file, sources_.texts.emplace_back(std::move(json.toml)), std::move(json.document), name, text};
  }

  void take_included(const toml::Value& value, SourceReader& reader, const Source& source, const std::string& name) {
    if (value.kind != toml::Kind::array)
      return reader.error(value.span,
                          {"include is not an array", std::string(noun_of(value.kind)), "include = [\"FILE\", ...]"});
    toml::Elements elements(source.text, value);
    while (const auto element = elements.next()) {
      if (element->value.kind != toml::Kind::string) {
        reader.error(element->value.span,
                     {"an included file has no name", std::string(noun_of(element->value.kind)), "a string"});
        continue;
      }
      const std::string wanted = beside(name, reader.string_of(element->value));
      const DataFileText data =
          reading_.loader ? reading_.loader(wanted) : DataFileText{{}, {}, "files cannot be included here"};
      if (!data.failure.empty() || data.path.empty()) {
        reader.error(element->value.span, {"cannot read an included file", wanted, "", data.failure});
      } else if (!taken_.insert(data.path).second) {
        reader.error(element->value.span,
                     {"a file is included twice, or includes itself", wanted, "", "remove one of them"});
      } else if (taken_.size() > max_files) {
        return reader.error(element->value.span,
                            {"too many files are included", "", fmt::format("up to {}", max_files)});
      } else {
        take(sources_.texts.emplace_back(data.text), data.path, wanted);
      }
    }
  }

  static constexpr std::size_t max_files = 100;

  Reading& reading_;
  Sources& sources_;
  std::set<std::string> taken_;
};

// Where a name of [let] stands.
struct NamePlace {
  std::size_t source = 0;
  toml::Span key;
  toml::Value value;
};

class NamesReader {
 public:
  NamesReader(const Sources& sources, Reading& reading) : reading_(reading) {
    for (const Source& source : sources.sources) readers_.emplace_back(source, reading);
    for (std::size_t i = 0; i < sources.sources.size(); ++i) read_source(sources.sources[i], i);
  }

  void stand_in(const std::string& name, const std::string& value) {
    if (!reading_.names.contains(name) && !places_.contains(name)) {
      core::Problem problem = core::error("--let: the scene has no such name in [let]").found(name);
      std::vector<std::string_view> names = reading_.names.all();
      if (const std::string near = core::nearest_word(name, names); !near.empty())
        problem.hint = fmt::format("did you mean '{}'?", near);
      reading_.log.add(std::move(problem));
      return;
    }
    const Measured* const replaced = reading_.names.find(name);
    if (const auto number = core::parse_number(value); number && replaced != nullptr)
      reading_.names.define(name, Measured{*number, replaced->dimension});
    else
      reading_.names.define(name, value);
    replaced_[name] = value;
  }

  void resolve() {
    for (NameFault& fault : reading_.names.resolve()) {
      const auto found = places_.find(fault.name);
      if (replaced_.contains(fault.name) || found == places_.end()) {
        reading_.log.add(core::error(fmt::format("--let {}: {}", fault.name, fault.fault.message))
                             .expected(fault.fault.expected)
                             .hint(fault.fault.hint));
        continue;
      }
      const NamePlace& place = found->second;
      toml::Span at = fault.of_name ? place.key : place.value.span;
      if (!fault.of_name && place.value.kind == toml::Kind::string)
        at.begin += static_cast<std::uint32_t>(fault.fault.begin) + 1;
      readers_[place.source].error(at, {fmt::format("{} of [let]: {}", fault.name, fault.fault.message), "",
                                        fault.fault.expected, fault.fault.hint});
    }
  }

 private:
  void read_source(const Source& source, std::size_t number) {
    for (const toml::Table& table : source.document.tables) {
      const std::string_view written = toml::piece(source.text, table.name);
      if (written.find("let") == std::string_view::npos) continue;
      const std::vector<std::string> name = toml::key_parts(source.text, table.name);
      if (name.front() != "let") continue;
      if (name.size() > 1 || table.element)
        readers_[number].error(table.header, {"the names of [let] must be in one table", script::shown(written),
                                              "[let]", "write single brackets, and all names below them"});
      if (name.size() > 1) continue;
      for (std::size_t i = 0; i < table.entries; ++i)
        add(source, source.document.entries[table.first_entry + i], number);
    }
  }

  void add(const Source& source, const toml::Entry& entry, std::size_t number) {
    SourceReader& reader = readers_[number];
    const std::vector<std::string> parts = toml::key_parts(source.text, entry.key);
    const std::string& name = parts.front();
    if (name.starts_with("x-")) return;
    const auto value = toml::number(source.text, entry.value);
    if (parts.size() > 1 || (!value && entry.value.kind != toml::Kind::string))
      return reader.error(entry.key, {fmt::format("{} of [let] is neither a number nor a string", name),
                                      std::string(noun_of(entry.value.kind)), "a number or an expression in quotes"});
    if (!places_.insert({name, {number, entry.key, entry.value}}).second)
      return reader.error(entry.key,
                          {fmt::format("{} of [let] is given twice", name), "", "one value in all files", ""});
    if (value)
      reading_.names.define(name, *value);
    else
      reading_.names.define(name, reader.string_of(entry.value));
  }

  Reading& reading_;
  std::deque<SourceReader> readers_;
  std::map<std::string, NamePlace> places_;
  std::map<std::string, std::string> replaced_;
};

}  // namespace

bool includes_files(std::string_view text) {
  if (text.find("include") == std::string_view::npos) return false;
  std::string other;
  if (is_json(text)) text = other = read_json(text).toml;
  const toml::Document document = toml::parse(text);
  const toml::Table& root = document.tables.front();
  for (std::size_t i = 0; i < root.entries; ++i) {
    const std::vector<std::string> key = toml::key_parts(text, document.entries[root.first_entry + i].key);
    if (!key.empty() && key.front() == "include") return true;
  }
  return false;
}

void take_apart(std::string_view text, const std::string& file, Reading& reading, Sources& sources) {
  Taking(reading, sources).take_first(text, file);
}

void read_names(const Sources& sources, const std::vector<std::pair<std::string, std::string>>& stand_ins,
                Reading& reading) {
  NamesReader reader(sources, reading);
  if (!stand_ins.empty()) static_cast<void>(reading.names.resolve());  // What they measure; faults may be replaced.
  for (const auto& [name, value] : stand_ins) reader.stand_in(name, value);
  reader.resolve();
}

}  // namespace sarsim::scene::language
