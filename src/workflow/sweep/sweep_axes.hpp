#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/report/problem.hpp"
#include "scene/model/scene.hpp"
#include "scene/schema/field_names.hpp"

namespace sarsim::workflow {

/// More variations are taken for a mistake.
inline constexpr std::size_t most_variations = 100000;

/// A field and the values that it takes, one after the other.
struct SweepAxis {
  std::string name;  ///< As typed: "Radar1.bandwidth".
  scene::NamedField field;
  std::vector<std::string> values;  ///< As `set_named_field` takes them.
  std::vector<std::string> words;   ///< The values as parts of file names; no two are alike.

  /// "Hz"; empty for pure numbers and for what is no number.
  [[nodiscard]] std::string unit() const;
  /// Whether the values are numbers of a quantity.
  [[nodiscard]] bool is_number() const { return field.field->kind == scene::FieldKind::quantity; }
  /// A value for tables: a number in the base unit, or the word itself.
  [[nodiscard]] std::string table_text(std::size_t value) const;
  /// Whether this is the seed, which `check` does not look at.
  [[nodiscard]] bool is_seed() const { return field.objects.empty() && field.field->id == "seed"; }
};

/// The variations of a scene: every combination of the values of the axes, the last axis varying fastest, or, paired,
/// the first values of all axes, then the second ones and so on.
class Sweep {
 public:
  /// @param settings  texts "OBJECT.FIELD=VALUES" (scene/schema/field_names.hpp, scene/schema/value_list.hpp)
  /// @throws core::Refused with everything that is wrong with them
  Sweep(const scene::Scene& scene, const std::vector<std::string>& settings, bool paired);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const std::vector<SweepAxis>& axes() const { return axes_; }
  /// Which value an axis has in a variation.
  [[nodiscard]] std::size_t value_of(std::size_t variation, std::size_t axis) const;
  /// "Radar1.bandwidth=10MHz seed=1".
  [[nodiscard]] std::string label(std::size_t variation) const;
  /// The file of a product in a variation, from its file in the script: "sim1_Radar1.bandwidth=10MHz_seed=1.bin". Holds
  /// nothing but letters, digits and "._+=-"; depends on the values of this variation alone. Names that would be
  /// longer than a file system takes end in a number made from the values instead.
  [[nodiscard]] std::string file_name(const std::string& stem, const std::string& extension,
                                      std::size_t variation) const;
  /// The scene with the values of a variation; where they cannot be set, `problems` says why.
  [[nodiscard]] scene::Scene scene(const scene::Scene& base, std::size_t variation, core::Problems& problems) const;
  /// Whether a problem is about a field that varies, so that the script is not to blame.
  [[nodiscard]] bool varies(const core::Subject& subject) const;

  /// The first of the variations that differ from this one by the seed alone.
  [[nodiscard]] std::size_t first_alike(std::size_t variation) const;

 private:
  void add_axis(const scene::Scene& scene, const std::string& setting, core::Problems& problems);
  void set_size(bool paired, core::Problems& problems);

  std::vector<SweepAxis> axes_;
  std::vector<std::size_t> strides_;  // Of each axis in the number of a variation; paired: all 1.
  bool paired_ = false;
  std::size_t size_ = 0;
};

/// Text with nothing but letters, digits, bytes of other alphabets and "._+=-": others become '-'.
[[nodiscard]] std::string safe_word(const std::string& text);

}  // namespace sarsim::workflow
