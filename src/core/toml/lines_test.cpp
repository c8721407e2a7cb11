#include "core/toml/lines.hpp"

#include <random>
#include <string>

#include <gtest/gtest.h>

#include "core/toml/parse.hpp"

namespace sarsim::core::toml {
namespace lines_test {

TEST(TomlLines, CountFromOneInBytes) {
  const std::string text = "a\r\n\xC3\xA9 b\n\nc";
  Lines lines(text);
  EXPECT_EQ(lines.at(0), (Position{1, 1}));
  EXPECT_EQ(lines.at(2), (Position{1, 3}));
  EXPECT_EQ(lines.at(3), (Position{2, 1}));
  EXPECT_EQ(lines.at(6), (Position{2, 4}));
  EXPECT_EQ(lines.at(8), (Position{3, 1}));
  EXPECT_EQ(lines.at(9), (Position{4, 1}));
  EXPECT_EQ(lines.at(99), (Position{4, 2}));
}

TEST(TomlLines, GoBothWays) {
  const std::string text = "ab\n\n\ncde\nf\n\nghijk\n";
  std::mt19937 random(1);
  Lines lines(text);
  for (int i = 0; i < 1000; ++i) {
    const auto offset = static_cast<std::uint32_t>(random() % (text.size() + 1));
    ASSERT_EQ(lines.at(offset), Lines(text).at(offset)) << offset;
  }
}

TEST(TomlComments, BeginAboveTheirLine) {
  const std::string text =
      "# head\n\n# one\n  # two\na = 1 # behind\nb = 2\n\n[c]\n# three\n  [[d]]\n# four\n\ne = '''\n# f'''\ng = 1\n";
  const Document document = parse(text);
  ASSERT_TRUE(document.mistakes.empty());
  const auto begin = [&](const std::string& line) {
    return comments_begin(text, document, static_cast<std::uint32_t>(text.find(line)));
  };
  EXPECT_EQ(begin("a = 1"), text.find("# one"));
  EXPECT_EQ(begin("b = 2"), text.find("b = 2"));
  EXPECT_EQ(begin("[c]"), text.find("[c]"));
  EXPECT_EQ(begin("[[d]]"), text.find("# three"));
  EXPECT_EQ(begin("e ="), text.find("e ="));
  EXPECT_EQ(begin("g = 1"), text.find("g = 1")) << "the line above belongs to a string";
}

TEST(TomlComments, MayBeginTheText) {
  const std::string text = "# one\n# two\n[a]\n";
  EXPECT_EQ(comments_begin(text, parse(text), static_cast<std::uint32_t>(text.find('['))), 0U);
  const std::string marked = "\xEF\xBB\xBF" + text;
  EXPECT_EQ(comments_begin(marked, parse(marked), static_cast<std::uint32_t>(marked.find('['))), 3U);
}

}  // namespace lines_test
}  // namespace sarsim::core::toml
