#include "core/xml/xml.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "core/text/number_text.hpp"

namespace sarsim::core::xml_test {

using testing::HasSubstr;

std::string fault(std::string_view text) {
  pugi::xml_document document;
  std::string wrong = parse_xml(text, document);
  EXPECT_TRUE(wrong.empty() || !document.first_child()) << "half a document is left of '" << text.substr(0, 80) << "'";
  return wrong;
}

TEST(Xml, ReadsWhatItWrote) {
  pugi::xml_document document;
  const pugi::xml_node root = document.append_child("CPHD");
  append_text(root, "Name", "a < b & \"c\" \xc3\xa4");
  append_number(root, "Value", 0.1 + 0.2);
  append_number(root, "Small", -std::numeric_limits<double>::denorm_min());
  append_count(root, "Count", 1LL << 60);
  const std::string text = xml_text(document);
  EXPECT_THAT(text, HasSubstr("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<CPHD>\n  <Name>a &lt; b"));
  pugi::xml_document again;
  ASSERT_EQ(parse_xml(text, again), "");
  const pugi::xml_node read = again.child("CPHD");
  EXPECT_STREQ(read.child_value("Name"), "a < b & \"c\" \xc3\xa4");
  EXPECT_EQ(parse_number(read.child_value("Value")), 0.1 + 0.2);
  EXPECT_EQ(parse_number(read.child_value("Small")), -std::numeric_limits<double>::denorm_min());
  EXPECT_STREQ(read.child_value("Count"), "1152921504606846976");
  EXPECT_EQ(xml_text(again), text);
}

TEST(Xml, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(fault(""), HasSubstr("no document element"));
  EXPECT_THAT(fault("\0\0\0\0"), HasSubstr("no document element"));
  EXPECT_THAT(fault("<a>\n<b>\n</a>"), HasSubstr("line 3: start-end tags mismatch"));
  EXPECT_THAT(fault("<a>\n<b"), HasSubstr("line 2"));
}

TEST(Xml, ComparesWhatElementsHold) {
  const auto alike = [](const char* a, const char* b) {
    pugi::xml_document of_a;
    pugi::xml_document of_b;
    EXPECT_EQ(parse_xml(a, of_a) + parse_xml(b, of_b), "");
    return same_content(of_a.document_element(), of_b.document_element());
  };
  EXPECT_TRUE(alike("<a> 1\n<b/><c>x</c></a>", "<n:a m='2'>1<!-- so --><n:b></n:b> <c>\tx</c></n:a>"));
  for (const char* const other : {"<a>2</a>", "<a>1<b/></a>", "<a>1<b/><d>x</d></a>", "<a>1<b/><c>y</c></a>",
                                  "<a>1<b/><c>x</c><c>x</c></a>", "<a>1<c>x</c><b/></a>"})
    EXPECT_FALSE(alike("<a>1<b/><c>x</c></a>", other)) << other;
  pugi::xml_document document;
  ASSERT_EQ(parse_xml("<p:a/>", document), "");
  EXPECT_EQ(local_name(document.document_element()), "a");
}

TEST(Xml, RefusesEntities) {
  // The "billion laughs" and a file of the machine.
  EXPECT_THAT(fault("<!DOCTYPE a [<!ENTITY b \"ha\"><!ENTITY c \"&b;&b;\">]><a>&c;</a>"), HasSubstr("<!DOCTYPE"));
  EXPECT_THAT(fault("<!DOCTYPE a [<!ENTITY b SYSTEM \"file:///etc/passwd\">]><a>&b;</a>"), HasSubstr("<!DOCTYPE"));
  pugi::xml_document document;
  ASSERT_EQ(parse_xml("<a>&b;&amp;&#65;</a>", document), "");
  EXPECT_STREQ(document.child_value("a"), "&b;&A") << "an entity that nobody defined stays as it is";
}

TEST(Xml, RefusesWhatIsTooLongManyOrDeep) {
  EXPECT_THAT(fault(std::string(longest_xml + 1, ' ')), HasSubstr("at most 67108864"));
  std::string many = "<a>";
  for (std::size_t part = 0; part < max_xml_parts; ++part) many += "<b/>";
  EXPECT_THAT(fault(many + "</a>"), HasSubstr("tags and attributes"));
  std::string deep;
  for (std::size_t depth = 0; depth < deepest_xml; ++depth) deep += "<a>";
  std::string ends;
  for (std::size_t depth = 0; depth < deepest_xml; ++depth) ends += "</a>";
  EXPECT_EQ(fault(deep + ends), "");
  EXPECT_THAT(fault(deep + "\n<a/>" + ends), HasSubstr("line 2: elements are nested more than 100 deep"));
  std::string very_deep;
  for (std::size_t depth = 0; depth < 1'000'000; ++depth) very_deep += "<a>";
  EXPECT_NE(fault(very_deep), "");
}

}  // namespace sarsim::core::xml_test
