#include "workflow/sweep/sweep_axes.hpp"

#include <algorithm>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "core/hash/fnv1a.hpp"
#include "core/report/refused.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/schema/value_list.hpp"

namespace sarsim::workflow {

namespace {

// Room for the temporary name and for the file system's own limit of 255 bytes.
constexpr std::size_t longest_name = 200;

core::Problem mistake(const std::string& setting, std::string message, std::string hint = {}) {
  core::Problem problem;
  problem.message = fmt::format("--set {}: {}", setting.substr(0, 80), message);
  problem.hint = std::move(hint);
  return problem;
}

std::vector<std::string> distinct_words(const std::vector<std::string>& values) {
  std::vector<std::string> words;
  std::set<std::string> taken;
  for (const std::string& value : values) {
    const std::string word = safe_word(value);
    std::string unique = word;
    for (int number = 2; !taken.insert(unique).second; ++number) unique = fmt::format("{}-{}", word, number);
    words.push_back(std::move(unique));
  }
  return words;
}

}  // namespace

std::string safe_word(const std::string& text) {
  std::string word;
  for (const char c : text) {
    const bool plain = (c >= '0' && c <= '9') || ((c | 0x20) >= 'a' && (c | 0x20) <= 'z') ||
                       static_cast<unsigned char>(c) >= 0x80 ||
                       std::string_view("._+=-").find(c) != std::string_view::npos;
    if (c == ' ') continue;
    word += plain ? c : '-';
  }
  return word.empty() ? "-" : word;
}

std::string SweepAxis::unit() const {
  if (!is_number()) return {};
  const auto units = scene::units_of(field.field->quantity);
  return units.empty() ? std::string() : std::string(units.front());
}

std::string SweepAxis::table_text(std::size_t value) const {
  const std::string& text = values.at(value);
  if (!is_number() || is_seed()) return text;
  const scene::QuantityReading reading = scene::read_quantity(text, field.field->quantity);
  return reading.value ? core::format_number(*reading.value) : text;
}

Sweep::Sweep(const scene::Scene& scene, const std::vector<std::string>& settings, bool paired) : paired_(paired) {
  core::Problems problems;
  for (const std::string& setting : settings) add_axis(scene, setting, problems);
  if (settings.empty())
    throw core::Refused("sweep: nothing varies", "say what does with --set, for instance --set seed=1..10");
  if (problems.empty()) set_size(paired, problems);
  if (!problems.empty()) throw core::Refused(std::move(problems));
}

void Sweep::add_axis(const scene::Scene& scene, const std::string& setting, core::Problems& problems) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos) {
    problems.push_back(
        mistake(setting, "there is no '='", "write OBJECT.FIELD=VALUES, as in Radar1.bandwidth=10MHz,20MHz"));
    return;
  }
  SweepAxis axis;
  axis.name = core::trimmed(std::string_view(setting).substr(0, equals));
  const std::string values(core::trimmed(std::string_view(setting).substr(equals + 1)));
  axis.field = scene::find_named_field(scene, axis.name, values);
  if (axis.field.field == nullptr) {
    problems.push_back(mistake(setting, axis.field.failure));
    return;
  }
  for (const SweepAxis& other : axes_)
    if (other.field.field == axis.field.field &&
        (axis.field.objects.empty() || std::ranges::any_of(axis.field.objects, [&](scene::ObjectId id) {
           return std::ranges::find(other.field.objects, id) != other.field.objects.end();
         })))
      problems.push_back(mistake(setting, fmt::format("this field is set by {} already", other.name)));
  scene::ValueList list = scene::read_value_list(values, *axis.field.field, most_variations);
  if (!list.failure.empty()) {
    problems.push_back(mistake(setting, list.failure));
    return;
  }
  std::set<std::string_view> met;
  for (const std::string& value : list.texts)
    if (!met.insert(value).second) {
      problems.push_back(mistake(setting, fmt::format("the value {} is given twice", value)));
      break;
    }
  axis.values = std::move(list.texts);
  axis.words = distinct_words(axis.values);
  axes_.push_back(std::move(axis));
}

void Sweep::set_size(bool paired, core::Problems& problems) {
  strides_.assign(axes_.size(), 1);
  if (paired) {
    size_ = axes_.front().values.size();
    for (const SweepAxis& axis : axes_)
      if (axis.values.size() != size_)
        problems.push_back(
            mistake(axis.name,
                    fmt::format("with --zip all lists are of one length; this one has {} values and that of {} has {}",
                                axis.values.size(), axes_.front().name, size_)));
    return;
  }
  double size = 1.0;
  for (const SweepAxis& axis : axes_) size *= static_cast<double>(axis.values.size());
  if (size > static_cast<double>(most_variations)) {
    core::Problem problem;
    problem.message = fmt::format("the sweep would have {:.0f} variations", size);
    problem.expected = fmt::format("{} at most", most_variations);
    problem.hint = "vary less at once, or pair the values with --zip";
    problems.push_back(std::move(problem));
    return;
  }
  size_ = 1;
  for (std::size_t axis = axes_.size(); axis-- > 0;) {
    strides_[axis] = size_;
    size_ *= axes_[axis].values.size();
  }
}

std::size_t Sweep::value_of(std::size_t variation, std::size_t axis) const {
  return variation / strides_[axis] % axes_[axis].values.size();
}

std::string Sweep::label(std::size_t variation) const {
  std::string text;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    text += fmt::format("{}{}={}", i == 0 ? "" : " ", axes_[i].name, axes_[i].values[value_of(variation, i)]);
  return text;
}

std::string Sweep::file_name(const std::string& stem, const std::string& extension, std::size_t variation) const {
  std::string values;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    values += fmt::format("_{}={}", safe_word(axes_[i].name), axes_[i].words[value_of(variation, i)]);
  const std::string safe = safe_word(stem);
  if (safe.size() + values.size() + extension.size() <= longest_name) return safe + values + extension;
  return fmt::format("{}_{:016x}{}", safe.substr(0, longest_name / 2), core::fnv1a(values, core::fnv1a(safe)),
                     extension);
}

scene::Scene Sweep::scene(const scene::Scene& base, std::size_t variation, core::Problems& problems) const {
  scene::Scene scene = base;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const std::string& value = axes_[i].values[value_of(variation, i)];
    if (const std::string failure = scene::set_named_field(scene, axes_[i].field, value); !failure.empty())
      problems.push_back(mistake(axes_[i].name + "=" + value, failure));
  }
  return scene;
}

bool Sweep::varies(const core::Subject& subject) const {
  return std::ranges::any_of(axes_, [&](const SweepAxis& axis) {
    const std::string_view id = axis.field.field->id;
    const bool field = id == subject.field || (id.starts_with(subject.field) && id.size() > subject.field.size() &&
                                               id[subject.field.size()] == '.' && !subject.field.empty());
    if (axis.field.objects.empty()) return field && subject.kind == "options";
    return field && std::ranges::any_of(axis.field.objects, [&](scene::ObjectId object) {
             return scene::name_of(object.kind) == subject.kind && object.index == subject.index;
           });
  });
}

std::size_t Sweep::first_alike(std::size_t variation) const {
  if (paired_) return variation;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (axes_[i].is_seed()) return variation - value_of(variation, i) * strides_[i];
  return variation;
}

}  // namespace sarsim::workflow
