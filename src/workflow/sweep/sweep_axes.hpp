#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/report/problem.hpp"
#include "scene/model/scene.hpp"
#include "scene/schema/field_names.hpp"
#include "workflow/input/scene_input.hpp"
#include "workflow/sweep/swept_field.hpp"

namespace sarsim::workflow {

/// More variations are taken for a mistake.
inline constexpr std::size_t max_variations = 100000;

/// What varies in a sweep, in words.
struct SweepValues {
  /// "OBJECT.FIELD=VALUES" (scene/schema/field_names.hpp) or "let.NAME=VALUES", with values as of
  /// scene/schema/value_list.hpp or random ones (workflow/sweep/random_values.hpp).
  std::vector<std::string> settings{};
  bool paired = false;             ///< All values are paired instead of combined, see Sweep.
  std::filesystem::path table{};   ///< CSV file of values: a column for each field, a line for each variation.
  std::size_t draws = 0;           ///< Of random values; 0: as many as there are other values, where they are paired.
  std::filesystem::path folder{};  ///< Of the script: where data files are looked for.
};

/// The text of a scene, which is read anew where names of [let] vary.
struct SceneSource {
  std::string file;
  SceneOverrides overrides{};                  ///< That it is read with.
  scene::LetNames names{};                     ///< As they were read.
  std::vector<std::filesystem::path> files{};  ///< Of which it is made; they must stay as they are.
};

/// A field and the values that it takes, one after the other.
struct SweepAxis {
  std::string name;  ///< As typed: "Radar1.bandwidth", "let.speed".
  scene::NamedField field;
  std::shared_ptr<const scene::Field> let{};  ///< See `SweptField`.
  std::vector<std::string> values{};          ///< As `set_named_field` takes them.
  std::vector<std::string> words{};           ///< The values as parts of file names; no two values have one word.
  std::vector<std::uint64_t> stamps{};        ///< Of the files that the values name; empty where they name none.
  std::string law{};       ///< That values are drawn by, as "normal(1, 0.2)"; empty where they are given.
  bool of_table = false;   ///< From the table of values.
  std::size_t stride = 1;  ///< So many variations have the same value before the next one follows.

  /// "Hz"; empty for pure numbers and for what is no number.
  [[nodiscard]] std::string unit() const;
  /// Whether the values are numbers of a quantity.
  [[nodiscard]] bool is_number() const { return field.field->kind == scene::FieldKind::quantity; }
  /// A value for tables: a number in the base unit, or the word itself.
  [[nodiscard]] std::string table_text(std::size_t value) const;
  /// Whether this is the seed, which `check` does not look at.
  [[nodiscard]] bool is_seed() const { return field.objects.empty() && field.field->id == "seed"; }
  /// "speed=200m/s": what the reader takes in place of a name of [let].
  [[nodiscard]] std::string let_word(std::size_t value) const;
  /// Whether the values are names of files: of the points of a function, or of a cloud.
  [[nodiscard]] bool names_files() const;
};

/// The variations of a scene: every combination of the values of the axes, the last axis varying fastest. Axes whose
/// values are paired go through them together: all axes, where that is asked for, else those of a table, and those that
/// are random.
class Sweep {
 public:
  /// @param source  of the scene, where names of [let] may vary
  /// @throws core::InvalidRequest with everything that is wrong with the values
  Sweep(const scene::Scene& scene, const SweepValues& values, SceneSource source = {});

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const std::vector<SweepAxis>& axes() const { return axes_; }
  /// Which value an axis has in a variation.
  [[nodiscard]] std::size_t value_of(std::size_t variation, std::size_t axis) const;
  /// "Radar1.bandwidth=10MHz seed=1".
  [[nodiscard]] std::string label(std::size_t variation) const;
  /// The same as stand-ins for values of the scene's text: names of [let] and settings of fields.
  void add_to(SceneOverrides& overrides, std::size_t variation) const;
  /// The file of a product in a variation, from its file in the script: "sim1_Radar1.bandwidth=10MHz_seed=1.bin". Holds
  /// nothing but letters, digits and "._+=-"; depends on the values of this variation alone. Names that would be
  /// longer than a file system takes end in a number made from the values instead.
  [[nodiscard]] std::string file_name(const std::string& stem, const std::string& extension,
                                      std::size_t variation) const;
  /// The scene with the values of a variation, and what they name read; where they cannot be set, `problems` says why.
  /// A requested stop throws Interrupted.
  [[nodiscard]] scene::Scene scene(const scene::Scene& base, std::size_t variation, core::Problems& problems,
                                   const core::StopFlag* stop = nullptr) const;
  /// Of what a variation is made of besides the scene and the words of its values: the files that these name.
  [[nodiscard]] std::uint64_t stamp(std::size_t variation) const;
  /// The files that values name, and the table of values.
  [[nodiscard]] std::vector<std::filesystem::path> sources() const;
  /// Whether a problem is about a field that varies, so that the script is not to blame.
  [[nodiscard]] bool varies(const core::Subject& subject) const;
  /// The line of the table of values that a field's value in a variation comes from; no place where it does not come
  /// from there.
  [[nodiscard]] core::Place place_of(const core::Subject& subject, std::size_t variation) const;
  /// What is allowed but probably not meant, of values as they were typed.
  [[nodiscard]] core::Problems remarks(const scene::Scene& scene) const;

  /// The first of the variations that differ from this one by the seed alone.
  [[nodiscard]] std::size_t first_alike(std::size_t variation) const;

 private:
  void read_axes(const scene::Scene& scene, const SweepValues& values, core::Problems& problems);
  void look_at_source();
  [[nodiscard]] scene::Scene read_anew(std::size_t variation, core::Problems& problems,
                                       const core::StopFlag* stop) const;
  void group_axes(bool paired);
  void draw(std::uint64_t seed, const SweepValues& values, core::Problems& problems);
  void set_size(core::Problems& problems);
  void name_values(core::Problems& problems);
  void refuse_repetition(const std::vector<std::size_t>& group, core::Problems& problems) const;
  [[nodiscard]] core::Problem repetition(const std::vector<std::size_t>& group, std::size_t first,
                                         std::size_t second) const;
  [[nodiscard]] core::Problem mistake_of(const SweepAxis& axis, std::size_t value, const std::string& message) const;
  [[nodiscard]] core::Place place_of_value(const SweepAxis& axis, std::size_t value) const;

  std::vector<SweepAxis> axes_;
  std::vector<std::vector<std::size_t>>
      groups_;  // Axes that go through their values together; the last varies fastest.
  SceneSource source_;
  std::uint64_t source_stamp_ = 0;  // Of its files; 0: it need not be read again.
  std::filesystem::path folder_;
  std::filesystem::path table_;
  std::size_t heading_line_ = 0;          // Of the table: the names of its columns.
  std::vector<std::size_t> table_lines_;  // Of each value of an axis from the table.
  std::size_t size_ = 0;
};

/// Text with nothing but letters, digits, bytes of other alphabets and "._+=-": others become '-'.
[[nodiscard]] std::string safe_word(const std::string& text);

}  // namespace sarsim::workflow
