#include "scene/language/scene_reader.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/toml/values.hpp"
#include "radar/earth/read_geoid.hpp"
#include "scene/language/format_mark.hpp"
#include "scene/language/json_text.hpp"
#include "scene/language/keys.hpp"
#include "scene/language/path_line.hpp"
#include "scene/language/sources.hpp"
#include "scene/model/object.hpp"
#include "scene/schema/trade_words.hpp"
#include "scene/script/foreign_text.hpp"

namespace sarsim::scene {

namespace {

using namespace language;
namespace toml = core::toml;

// More problems than this help nobody.
constexpr std::size_t problem_limit = 1000;

template <class Table>
const std::vector<std::string>& paths_of_single() {
  static const std::vector<std::string> paths = [] {
    std::vector<std::string> made;
    for (const FieldOf<Table>& field : table_of<Table>().fields()) made.emplace_back(field.spec.key);
    return made;
  }();
  return paths;
}

std::string headers_listed() {
  std::string text;
  for_each_kind([&](const auto& kind) {
    if (kind.kind != ObjectKind::cloud) text += fmt::format("[[{}]], ", header_of(kind.kind));
  });
  for_each_single([&](const auto& single) { text += fmt::format("[{}], ", single.header); });
  text.replace(text.rfind(", "), 2, " or ");
  return text + "[let]";
}

const std::vector<std::string>& header_words() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> made{"let"};
    for_each_single([&](const auto& single) { made.emplace_back(single.header); });
    for (const ObjectKind kind : all_object_kinds) made.emplace_back(header_of(kind));
    return made;
  }();
  return words;
}

// Reads the objects of all texts into a scene.
class SceneReader {
 public:
  SceneReader(Reading& reading, Scene& scene) : reading_(reading), scene_(scene) {}

  /// The worlds of all texts, before anything that lies in them.
  void read_worlds(const language::Source& source) {
    toml::Lines lines(source.typed);
    ObjectTexts texts(source.text, source.document);
    ObjectText text;
    while (!reading_.log.full() && texts.next(text))
      if (text.kind == "world") read_singles(source, lines, text);
  }

  /// Warns of an anchor on the Earth that the texts leave out; one that is said may be anywhere.
  void warn_of_anchor() {
    if (scene_.world.frame != World::Frame::earth || (says_latitude_ && says_longitude_)) return;
    const bool neither = !says_latitude_ && !says_longitude_;
    reading_.log.add(core::warning(neither ? "the world has no anchor: it lies at latitude 0 and longitude 0"
                                           : fmt::format("the anchor has no {0}: it lies at {0} 0",
                                                         says_latitude_ ? "longitude" : "latitude"))
                         .expected("anchor = { latitude = \"47.2 deg\", longitude = \"11.4 deg\" }")
                         .hint("write both, even where they are 0")
                         .at("world", 0, "latitude")
                         .in(reading_.places.find({"world", 0,
                                                   neither          ? "frame"
                                                   : says_latitude_ ? "latitude"
                                                                    : "longitude"})));
  }

  /// What the places of the texts are turned into positions by.
  void set_earth() {
    const World& world = scene_.world;
    if (world.frame != World::Frame::earth) return;
    if (world.geoid.empty()) {
      reading_.earth.emplace(world, std::nullopt);
      return;
    }
    const DataFileText data =
        reading_.loader ? reading_.loader(world.geoid) : DataFileText{{}, {}, "data files cannot be read here"};
    core::Problem problem;
    if (!data.failure.empty() || data.path.empty()) {
      problem = core::error("cannot read the grid of the geoid").found(world.geoid).hint(data.failure);
    } else {
      auto grid = radar::read_geoid(data.text, world.geoid);
      if (auto* const read = std::get_if<radar::GeoidGrid>(&grid)) {
        reading_.earth.emplace(world, std::move(*read));
        return;
      }
      problem = std::get<core::Problem>(std::move(grid));
    }
    problem.subject = {"world", 0, "geoid"};
    problem.place = reading_.places.find(problem.subject);
    reading_.log.add(std::move(problem));
    reading_.earth.emplace(world, std::nullopt);
  }

  void read(const language::Source& source) {
    toml::Lines lines(source.typed);
    ObjectTexts texts(source.text, source.document);
    ObjectText text;
    for (bool root = true; !reading_.log.full() && texts.next(text); root = false) {
      if (root)
        read_root(source, lines, text);
      else
        read_table(source, lines, text);
    }
  }

 private:
  void read_root(const language::Source& source, toml::Lines& lines, ObjectText& text) {
    ObjectReader reader(reading_, source, lines, text, "", 0);
    for (const std::string_view key : {"format", "include"}) text.use_all_below(key);
    static const std::vector<std::string> known{"format", "include"};
    for (Leaf& leaf : text.leaves) {
      const std::string_view word = leaf.path.substr(0, leaf.path.find('.'));
      if (std::ranges::find(header_words(), word) == header_words().end() || leaf.used) continue;
      reader.error(leaf.key, "",
                   {fmt::format("'{}' is not a table of its own", word), "",
                    is_single(word) || word == "let" ? fmt::format("[{}]", word) : fmt::format("[[{}]]", word),
                    "write it as a header with its fields below"});
      text.use_all_below(word);
    }
    reader.finish(known);
  }

  void read_table(const language::Source& source, toml::Lines& lines, ObjectText& text) {
    if (text.kind == "let" || text.kind.starts_with("x-")) return;
    if (text.kind == "world") return;  // read before
    if (is_single(text.kind)) return read_singles(source, lines, text);
    const bool names_others = text.kind != "platform" && text.kind != "radar";
    const auto kind = kind_of(text);
    ObjectReader anonymous(reading_, source, lines, text, "", 0);
    reading_.names_lost = reading_.names_lost || !kind || (!names_others && !text.is_element);
    if (!kind) return report_unknown(anonymous, text);
    if (!text.is_element && anonymous.text_of(text.header).find('.') != std::string_view::npos)
      return anonymous.error(text.header, "",
                             {"the table comes after another object", script::shown(anonymous.text_of(text.header)), "",
                              fmt::format("move it directly below its [[{}]]", text.kind)});
    if (!text.is_element)
      return anonymous.error(
          text.header, "",
          {fmt::format("there can be many of the kind {}", text.kind), std::string(anonymous.text_of(text.header)),
           fmt::format("[[{}]]", text.kind), "write double brackets"});
    visit_kind(*kind, [&]<class Object>(const Kind<Object>& of) { read_object(of, source, lines, text); });
  }

  [[nodiscard]] static std::optional<ObjectKind> kind_of(ObjectText& text) {
    for (const ObjectKind kind : all_object_kinds)
      if (header_of(kind) == text.kind) {
        const bool is_cloud = kind == ObjectKind::target && text.find("positions.file") != nullptr;
        return is_cloud ? ObjectKind::cloud : kind;
      }
    return std::nullopt;
  }

  static std::string advice_of(const TradeHeader& word) {
    if (word.header.empty()) return std::string(word.note);
    const std::string write =
        is_list_header(word.header) ? fmt::format("write [[{}]]", word.header) : fmt::format("write [{}]", word.header);
    return word.note.empty() ? write : fmt::format("{} ({})", write, word.note);
  }
  static bool is_list_header(std::string_view header) {
    return std::ranges::any_of(all_object_kinds, [&](ObjectKind kind) { return header_of(kind) == header; });
  }

  static void report_unknown(ObjectReader& reader, const ObjectText& text) {
    const std::string near = core::nearest_word(text.kind, header_words());
    const auto in_script = kind_called(text.kind);
    if (in_script && header_of(*in_script) != text.kind)
      return reader.error(text.header, "",
                          {"unknown kind of object", std::string(reader.text_of(text.header)), "",
                           fmt::format("write [[{}]]", header_of(*in_script))});
    if (const TradeHeader* const word = trade_header(text.kind); word != nullptr && near.empty())
      return reader.error(
          text.header, "",
          {"unknown kind of object", script::shown(reader.text_of(text.header)), headers_listed(), advice_of(*word)});
    reader.error(text.header, "",
                 {"unknown kind of object", script::shown(reader.text_of(text.header)), headers_listed(),
                  near.empty() ? "your own tables must begin with x-; or the file was written for a newer Sarsim"
                               : fmt::format("did you mean '{}'?", near)});
  }

  void read_singles(const language::Source& source, toml::Lines& lines, ObjectText& text) {
    for_each_single([&](const auto& single) {
      if (single.header == text.kind) read_single(single, source, lines, text);
    });
  }

  template <class Table>
  void read_single(const Single<Table>& single, const language::Source& source, toml::Lines& lines, ObjectText& text) {
    ObjectReader reader(reading_, source, lines, text, single.header, 0);
    if (text.is_element)
      reader.error(text.header, "",
                   {fmt::format("there is one table {}", single.header), fmt::format("[[{}]]", single.header),
                    fmt::format("[{}]", single.header), "write single brackets"});
    reader.note_place("", text.header);
    reader.read(scene_.*single.member);
    if constexpr (std::is_same_v<Table, World>) {
      says_latitude_ = says_latitude_ || text.find("anchor.latitude") != nullptr;
      says_longitude_ = says_longitude_ || text.find("anchor.longitude") != nullptr;
    }
    reader.finish(paths_of_single<Table>());
  }

  // A place on the Earth is a position in the world, and not in the frame of something that moves.
  template <class Object>
  static void expect_world(ObjectReader& reader, const Object& object) {
    if (reader.geodetic_at() == toml::Span{}) return;
    const std::string* carrier = nullptr;
    if constexpr (requires { object.parent; }) carrier = object.parent.empty() ? nullptr : &object.parent;
    if constexpr (
        requires { object.platform; } && !requires { object.beam; })
      carrier = *carrier_in(object) == world_name() ? nullptr : carrier_in(object);
    if (carrier != nullptr)
      reader.error(reader.geodetic_at(), "",
                   {"a place on the Earth is a world position, but this one is in the frame of a platform",
                    script::shown(*carrier), "", "give [x, y, z] in that frame, or leave the platform out"});
  }

  template <class Object>
  void read_object(const Kind<Object>& kind, const language::Source& source, toml::Lines& lines, ObjectText& text) {
    std::vector<Object>& list = scene_.*kind.list;
    ObjectReader reader(reading_, source, lines, text, kind.name, list.size());
    reader.note_place("", text.header);
    Object object;
    if constexpr (std::is_same_v<Object, Platform>) read_line_path(reader, text, object);
    reader.read(object);
    if constexpr (std::is_same_v<Object, Cloud>) use_positions(reader, text);
    Leaf* const positions = kind.kind == ObjectKind::target ? reader.find("positions") : nullptr;
    reader.finish(kind.kind);
    expect_world(reader, object);
    if constexpr (std::is_same_v<Object, Target>)
      if (positions != nullptr) return read_alike(object, *positions, source, lines, text);
    if (!list.empty()) share_equal(object, list.back());
    list.push_back(std::move(object));
  }

  static void use_positions(ObjectReader& reader, ObjectText& text) {
    if (Leaf* const table = text.find("positions")) table->used = true;
    if (const Leaf* const one = reader.find("position"))
      reader.error(one->key, "file", {"a target has either position or positions", "", "one of them"});
  }

  // For as many more rows as there seem to be: most are about as long as those before.
  void make_room(std::size_t at, const toml::Span& rows, std::size_t read) {
    constexpr std::size_t least = 100;
    constexpr double spare = 1.05;
    if (read < least) return;
    const double row_bytes = static_cast<double>(at - rows.begin) / static_cast<double>(read);
    scene_.targets.reserve(scene_.targets.size() +
                           static_cast<std::size_t>(spare * static_cast<double>(rows.end - at) / row_bytes) + least);
  }

  // Targets that differ in their position alone.
  void read_alike(const Target& alike, const Leaf& positions, const language::Source& source, toml::Lines& lines,
                  ObjectText& text) {
    const FieldSpec& spec = table_of<Target>().field<&Target::position_m>().spec;
    ObjectReader reader(reading_, source, lines, text, "target", scene_.targets.size());
    if (text.find("position") != nullptr)
      reader.error(positions.key, spec.id, {"a target has either position or positions", "", "one of them"});
    if (positions.value.kind != toml::Kind::array)
      return reader.error(positions.value.span, spec.id,
                          {"positions is not an array", std::string(noun_of(positions.value.kind)),
                           "[[x, y, z], [x, y, z], ...] or { file = \"FILE\" }"});
    toml::Elements rows(source.text, positions.value);
    const std::size_t before = scene_.targets.size();
    constexpr std::size_t max_points = 10'000'000;
    const std::size_t points_each = alike.traits->gain_db.part[0].knots.size();
    while (const auto row = rows.next()) {
      if (reading_.log.full()) return;
      if (scene_.targets.size() == scene_.targets.capacity())
        make_room(row->value.span.begin, positions.value.span, scene_.targets.size() - before);
      if ((scene_.targets.size() - before) * points_each > max_points)
        return reader.error(
            positions.key, spec.id,
            {"these targets are too many for a reflectivity of so many points", "",
             fmt::format("up to {} points in all", max_points), "put the positions into a file, or give fewer points"});
      ObjectReader one(reading_, source, lines, text, "target", scene_.targets.size());
      one.note_place("", row->value.span);
      scene_.targets.push_back(alike);
      static_cast<void>(one.read_vector(spec, row->value, scene_.targets.back().position_m));
    }
    if (scene_.targets.size() == before)
      reader.warning(positions.value.span, spec.id, {"positions is empty: there is no such target", "", ""});
  }

  Reading& reading_;
  Scene& scene_;
  bool says_latitude_ = false;  // Of the anchor, in any text.
  bool says_longitude_ = false;
};

// References by exact name: what only begins alike, or differs in case, is not meant.
class References {
 public:
  References(const Scene& scene, const Reading& reading) : reading_(reading) {
    platforms_.insert("Earth");
    take_names("platform", scene.platforms, platforms_);
    take_names("radar", scene.radars, radars_);
    for_each_kind([&](const auto& kind) { check(kind, scene.*kind.list); });
    for (std::size_t i = 0; i < scene.platforms.size() && !reading.names_lost && !full(); ++i)
      for (const auto& [field, name] : {std::pair<const char*, const std::string&>("parent", scene.platforms[i].parent),
                                        {"leader", scene.platforms[i].leader}})
        if (!name.empty() && !platforms_.contains(name)) report("platform", i, "platform", field, name, platforms_);
  }

  [[nodiscard]] core::Problems take() { return std::move(problems_); }

 private:
  // Names are looked up without regard to case when echoes are computed, so that two must not differ in it alone.
  template <class Object>
  void take_names(std::string_view kind, const std::vector<Object>& list, std::set<std::string, std::less<>>& known) {
    std::map<std::string, std::string> seen;
    for (const std::string& name : known) seen.emplace(core::lower_case(name), "");
    for (std::size_t i = 0; i < list.size() && !full(); ++i) {
      const std::string& name = list[i].name;
      const auto [before, is_new] = seen.emplace(core::lower_case(name), name);
      const bool is_world = !is_new && before->second.empty() && before->first == "earth";
      if (is_world) before->second = name;
      known.insert(name);
      if (is_new || (is_world && name == "Earth")) continue;
      core::Problem problem = is_world
                                  ? core::warning("the world is called Earth")
                                        .found(script::shown(name))
                                        .expected("Earth")
                                        .hint("this is taken for the same platform; write its usual name everywhere")
                                  : core::error(fmt::format("another {} has this name{}", kind,
                                                            before->second == name ? "" : ", but for capital letters"))
                                        .found(script::shown(name))
                                        .hint("give it another name");
      report_at(std::move(problem), kind, i, "name");
    }
  }

  void report_at(core::Problem problem, std::string_view kind, std::size_t index, std::string_view field) {
    problem.subject = {std::string(kind), index, std::string(field)};
    problem.place = reading_.places.find(problem.subject);
    problems_.push_back(std::move(problem));
  }

  [[nodiscard]] bool full() const { return reading_.log.full() || problems_.size() >= problem_limit; }

  template <class Object>
  void check(const Kind<Object>& kind, const std::vector<Object>& list) {
    const std::string* last = nullptr;
    if (reading_.names_lost) return;
    for (std::size_t i = 0; i < list.size() && !full(); ++i) {
      const std::string* const name = carrier_in(list[i]);
      if (name == nullptr || (last != nullptr && *last == *name)) continue;
      last = name;
      const bool of_radar = Kind<Object>::belongs_to_radar;
      const auto& known = of_radar ? radars_ : platforms_;
      if (known.contains(*name) || (of_radar && name->empty())) continue;
      const char* const refers = of_radar ? "radar" : "platform";
      report(kind.name, i, refers, refers, *name, known);
    }
  }

  void report(std::string_view kind, std::size_t index, const char* refers, const char* field, const std::string& name,
              const std::set<std::string, std::less<>>& known) {
    core::Problem problem =
        core::error(fmt::format("the scene has no {} of this name", refers)).found(script::shown(name));
    const auto alike =
        std::ranges::find_if(known, [&](const auto& word) { return core::equal_ignoring_case(word, name); });
    const std::string near = alike != known.end() ? *alike : core::nearest_word(name, known);
    if (!near.empty())
      problem.hint = fmt::format("did you mean \"{}\"?{}", near, alike != known.end() ? " Capital letters count" : "");
    report_at(std::move(problem), kind, index, field);
  }

  const Reading& reading_;
  core::Problems problems_;
  std::set<std::string, std::less<>> platforms_;
  std::set<std::string, std::less<>> radars_;
};

ScriptReading refuse_names(ScriptReading reading, const ReadControl& control) {
  for (const auto& [name, value] : control.let)
    reading.problems.push_back(core::error("--let: a script of the language of 1998 has no [let]")
                                   .found(name + "=" + value)
                                   .hint("convert it: sarsim convert A.scr A.toml"));
  return reading;
}

// Whether a text that might be TOML is something else: lines that begin with '#' or hold '=' are found in many files.
bool is_foreign(std::string_view text) {
  if (is_json(text) || states_format(text)) return false;
  const std::string kind = guess_of_content(text);
  return !kind.empty() && kind != "an INI file" && kind != "an empty file";
}

}  // namespace

ScriptReading read_format_2(std::string_view text, const std::string& file_name, const DataFileLoader& loader,
                            const ReadControl& control) {
  Reading reading{script::ProblemLog(problem_limit), {}, loader, {}};
  Sources sources;
  take_apart(text, file_name, reading, sources);
  read_names(sources, control.let, reading);
  Scene scene;
  SceneReader reader(reading, scene);
  for (const language::Source& source : sources.sources) reader.read_worlds(source);
  reader.warn_of_anchor();
  reader.set_earth();
  for (const language::Source& source : sources.sources) reader.read(source);
  core::Problems of_names = References(scene, reading).take();
  ScriptReading result{std::move(scene),   reading.log.take(), std::move(reading.places),
                       Language::format_2, is_json(text),      std::move(reading.names)};
  result.of_names = std::move(of_names);
  if (!control.draft) core::append(result.problems, std::exchange(result.of_names, {}));
  for (const language::Source& source : sources.sources)
    if (!source.name.empty()) result.included.emplace_back(source.file);
  return result;
}

ScriptReading read_scene_text(std::string_view text, const std::string& file_name, const DataFileLoader& loader,
                              const ReadControl& control) {
  const bool is_text = text.find('\0') == std::string_view::npos;  // UTF-16 is refused as what it is.
  const bool named_so = file_name.ends_with(".toml") && text.find('$') == std::string_view::npos;
  if (is_text && (is_json(text) || is_format_2(text) || named_so)) {
    if (is_foreign(text)) {
      ScriptReading reading;
      reading.problems.push_back(no_scene(text, file_name));
      return reading;
    }
    return read_format_2(text, file_name, loader, control);
  }
  return refuse_names(read_script(text, file_name, loader, control), control);
}

ScriptReading read_scene_file(const std::filesystem::path& path, const ReadControl& control) {
  return read_text_of_file(path, control, read_scene_text);
}

}  // namespace sarsim::scene
