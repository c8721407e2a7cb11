#include "raster/parts/join_parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace sarsim::raster {
namespace join_parts_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

// Names that vanish from a folder, in order; its own at last, as "".
class Vanishing {
 public:
  explicit Vanishing(const fs::path& folder) : queue_(inotify_init1(IN_NONBLOCK)) {
    EXPECT_GE(inotify_add_watch(queue_, folder.c_str(), IN_DELETE | IN_MOVE_SELF), 0);
  }
  Vanishing(const Vanishing&) = delete;
  Vanishing& operator=(const Vanishing&) = delete;
  ~Vanishing() { ::close(queue_); }

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> names;
    alignas(inotify_event) char buffer[16384];
    const ssize_t size = ::read(queue_, buffer, sizeof buffer);
    for (ssize_t at = 0; at < size;) {
      inotify_event event{};
      std::memcpy(&event, buffer + at, sizeof event);
      if ((event.mask & (IN_DELETE | IN_MOVE_SELF)) != 0)
        names.emplace_back(event.len > 0 ? buffer + at + sizeof event : "");
      at += static_cast<ssize_t>(sizeof event + event.len);
    }
    return names;
  }

 private:
  int queue_;
};

fs::path folder_with(const std::vector<std::string>& names) {
  const fs::path folder = fs::path(testing::TempDir()) / ("sarsim-" + std::to_string(::getpid()) + ".parts");
  fs::create_directories(folder);
  for (const std::string& name : names) std::ofstream(folder / name) << name;
  return folder;
}

// A process may be killed between any two of them: what is left must tell whose it is.
TEST(RemoveParts, TakesTheDescriptionLastAndWithTheNameOfTheFolder) {
  for (const bool slash : {false, true}) {
    const fs::path folder = folder_with({"lock", "product", "samples", "a.rows", "a.journal", "b.rows", "b.journal"});
    const Vanishing vanishing(folder);
    remove_parts(slash ? folder / "" : folder);
    const std::vector<std::string> names = vanishing.names();
    ASSERT_EQ(names.size(), 8u);
    EXPECT_THAT(std::vector(names.begin(), names.begin() + 5),
                UnorderedElementsAre("samples", "a.rows", "a.journal", "b.rows", "b.journal"));
    EXPECT_THAT(std::vector(names.begin() + 5, names.end()), ElementsAre("", "product", "lock"));
    EXPECT_FALSE(fs::exists(folder));
    EXPECT_TRUE(std::ranges::none_of(fs::directory_iterator(folder.parent_path()), [&](const auto& entry) {
      return entry.path().filename().string().starts_with("." + folder.filename().string());
    }));
  }
}

TEST(RemoveParts, LeavesTheFolderWithWhatOthersPutThere) {
  const fs::path folder = folder_with({"lock", "product", "a.rows", "notes.txt"});
  remove_parts(folder);
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  EXPECT_THAT(names, ElementsAre("notes.txt"));
  fs::remove_all(folder);
}

}  // namespace join_parts_test
}  // namespace sarsim::raster
