// Any calls of the C interface with any words: scenes as text, names and values of fields, options, objects and points
// by the hundred. No crash, no exception, a status that is one, and a list wherever a call was refused.
//
// The input is a sequence of calls: a byte that says which, then its words, each up to the next zero byte.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "capi/sarsim.h"

namespace {

void expect(bool holds) {
  if (!holds) std::abort();
}

// The bytes that are left, taken word by word.
class Words {
 public:
  Words(const std::uint8_t* data, std::size_t size) : rest_(reinterpret_cast<const char*>(data), size) {}

  [[nodiscard]] bool empty() const { return rest_.empty(); }
  std::uint8_t byte() {
    if (rest_.empty()) return 0;
    const auto first = static_cast<std::uint8_t>(rest_.front());
    rest_.remove_prefix(1);
    return first;
  }
  std::string word() {
    const std::size_t end = std::min(rest_.find('\0'), rest_.size());
    std::string word(rest_.substr(0, end));
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return word;
  }
  double number() {
    double value = 0.0;
    const std::size_t size = std::min(sizeof value, rest_.size());
    std::memcpy(&value, rest_.data(), size);
    rest_.remove_prefix(size);
    return value;
  }
  std::vector<double> numbers(std::size_t count) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(number());
    return values;
  }

 private:
  std::string_view rest_;
};

// What each call has to keep: where it was refused, the list says why.
void judge(sarsim_status status, sarsim_problems* problems) {
  expect(std::string_view(sarsim_status_word(status)) != "unknown status");
  expect(status == SARSIM_OK || sarsim_problems_count(problems) > 0);
  for (std::size_t i = 0; i < sarsim_problems_count(problems); ++i) {
    sarsim_problem problem = SARSIM_INIT(sarsim_problem);
    expect(sarsim_problems_get(problems, i, &problem) == SARSIM_OK);
    expect(std::strlen(problem.text) > 0);
    expect(status != SARSIM_OK || problem.severity != SARSIM_ERROR);
  }
  sarsim_problems_free(problems);
}

void judge_text(sarsim_status status, sarsim_text* text, sarsim_problems* problems) {
  expect((status == SARSIM_OK) == (text != nullptr));
  expect(std::strlen(sarsim_text_chars(text)) <= sarsim_text_length(text));
  sarsim_text_free(text);
  judge(status, problems);
}

struct SceneDeleter {
  void operator()(sarsim_scene* scene) const { sarsim_scene_free(scene); }
};
using ScenePointer = std::unique_ptr<sarsim_scene, SceneDeleter>;

// Work that is to stop at once looks at its options and its scene, and computes nothing.
void work_stopped(const sarsim_scene* scene, Words& words) {
  using Work = sarsim_status (*)(const sarsim_source*, const char* const*, size_t, const sarsim_work*, sarsim_result**,
                                 sarsim_problems**);
  static constexpr Work all[] = {sarsim_focus,  sarsim_profiles, sarsim_isar,    sarsim_doppler,
                                 sarsim_search, sarsim_theory,   sarsim_geometry};
  const Work chosen = all[words.byte() % std::size(all)];
  std::vector<std::string> options(words.byte() % 4);
  std::vector<const char*> pointers;
  for (std::string& option : options) pointers.push_back((option = words.word()).c_str());
  // Nothing is written, read or simulated for long.
  for (const std::string& option : options)
    if (option.find('/') != std::string::npos || option.starts_with("out") || option.starts_with("detections")) return;
  sarsim_source* source = nullptr;
  sarsim_stop* stop = nullptr;
  sarsim_result* result = nullptr;
  sarsim_problems* problems = nullptr;
  expect(sarsim_source_scene(scene, words.byte() % 3, &source, nullptr) == SARSIM_OK);
  expect(sarsim_stop_new(&stop, nullptr) == SARSIM_OK);
  sarsim_stop_request(stop);
  sarsim_work work = SARSIM_INIT(sarsim_work);
  work.stop = stop;
  work.threads = 1;
  const sarsim_status status = chosen(source, pointers.data(), pointers.size(), &work, &result, &problems);
  expect((status == SARSIM_OK) == (result != nullptr));
  judge(status, problems);
  sarsim_result_free(result);
  sarsim_stop_free(stop);
  sarsim_source_free(source);
}

void call_one(ScenePointer& scene, Words& words) {
  static constexpr const char* kinds[] = {"platform", "target", "cloud", "surface", "radar", "simulation", "geometry"};
  sarsim_problems* problems = nullptr;
  sarsim_text* text = nullptr;
  switch (words.byte() % 14) {
    case 0: {
      const std::string all = words.word();
      sarsim_scene* read = nullptr;
      const sarsim_status status =
          sarsim_scene_read_text(all.data(), all.size(), "/nowhere/fuzz.toml", nullptr, &read, &problems);
      expect((status == SARSIM_OK) == (read != nullptr));
      if (read != nullptr) scene.reset(read);
      return judge(status, problems);
    }
    case 1: {
      const std::string field = words.word();
      const sarsim_status status = sarsim_scene_set(scene.get(), field.c_str(), words.word().c_str(), &problems);
      return judge(status, problems);
    }
    case 2: {
      const sarsim_status status = sarsim_scene_get(scene.get(), words.word().c_str(), &text, &problems);
      return judge_text(status, text, problems);
    }
    case 3: {
      const std::string field = words.word();
      const sarsim_status status = sarsim_scene_set_number(scene.get(), field.c_str(), words.number(), &problems);
      return judge(status, problems);
    }
    case 4: {
      double value = 0.0;
      const sarsim_status status = sarsim_scene_get_number(scene.get(), words.word().c_str(), &value, &problems);
      return judge(status, problems);
    }
    case 5: {
      const std::size_t count = words.byte() % 5;
      const std::size_t parts = words.byte() % 4;
      const std::vector<double> x = words.numbers(count);
      const std::vector<double> y = words.numbers(count * parts);
      const std::string field = words.word();
      const sarsim_status status = sarsim_scene_set_points(scene.get(), field.c_str(), count, parts, x.data(), y.data(),
                                                           words.word().c_str(), &problems);
      return judge(status, problems);
    }
    case 6: {
      const char* const kind = kinds[words.byte() % std::size(kinds)];
      size_t index = 0;
      const sarsim_status status = sarsim_scene_add(scene.get(), kind, words.word().c_str(), &index, &problems);
      return judge(status, problems);
    }
    case 7: {
      const char* const kind = kinds[words.byte() % std::size(kinds)];
      const sarsim_status status = sarsim_scene_remove(scene.get(), kind, words.byte() % 4, &problems);
      return judge(status, problems);
    }
    case 8: {
      const std::size_t count = words.byte() % 8;
      const std::vector<double> positions = words.numbers(3 * count);
      const std::vector<double> rcs = words.numbers(count);
      const std::string platform = words.word();
      const bool cloud = words.byte() % 2 == 1;
      const sarsim_status status = cloud ? sarsim_scene_add_cloud(scene.get(), platform.c_str(), words.word().c_str(),
                                                                  count, positions.data(), rcs.data(), &problems)
                                         : sarsim_scene_add_targets(scene.get(), platform.c_str(), count,
                                                                    positions.data(), rcs.data(), &problems);
      return judge(status, problems);
    }
    case 9: {
      const sarsim_language language = words.byte() % 2 == 0 ? SARSIM_FORMAT_2 : SARSIM_SCRIPT;
      const sarsim_status status = sarsim_scene_text(scene.get(), language, &text, &problems);
      return judge_text(status, text, problems);
    }
    case 10: {
      const std::string word = words.word();
      const sarsim_status status = sarsim_explain(word.c_str(), words.byte() % 2, &text, &problems);
      return judge_text(status, text, problems);
    }
    case 11: {
      const char* const kind = kinds[words.byte() % std::size(kinds)];
      const sarsim_status status = sarsim_scene_fields(scene.get(), kind, words.byte() % 4, &text, &problems);
      return judge_text(status, text, problems);
    }
    case 12: {
      sarsim_scene* copy = nullptr;
      expect(sarsim_scene_copy(scene.get(), &copy, &problems) == SARSIM_OK);
      scene.reset(copy);
      return judge(SARSIM_OK, problems);
    }
    default: return work_stopped(scene.get(), words);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Words words(data, size);
  sarsim_scene* made = nullptr;
  expect(sarsim_scene_new("/nowhere/fuzz.toml", &made, nullptr) == SARSIM_OK);
  ScenePointer scene(made);
  constexpr int max_calls = 64;
  for (int call = 0; call < max_calls && !words.empty(); ++call) call_one(scene, words);
  return 0;
}
