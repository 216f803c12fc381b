#include <gtest/gtest.h>

#include <limits>

#include "case/input.hpp"
#include "slope/couple/document.hpp"

namespace slope::couple {
namespace {

Document parsed(const std::string& text) {
  std::vector<Problem> problems;
  Document document = parse_yaml(text, "text", problems);
  EXPECT_TRUE(problems.empty()) << text;
  return document;
}

void expect_same(const Document& a, const Document& b) {
  EXPECT_EQ(a.kind, b.kind) << a.key;
  EXPECT_EQ(a.key, b.key);
  EXPECT_EQ(a.value, b.value);
  ASSERT_EQ(a.children.size(), b.children.size()) << a.key;
  for (std::size_t i = 0; i < a.children.size(); ++i) expect_same(a.children[i], b.children[i]);
}

Document sample() {
  Document point = Document::list({Document::text("1 m"), Document::text("-0.5 m")});
  Document item = Document::map();
  item.set("name", Document::text("rain"))
      .set("on", Document::flag(true))
      .set("corners", Document::list({point, point}));
  Document root = Document::map();
  root.set("title", Document::text("A \"quoted\" title: with\na line, a \\ and a # sign"))
      .set("number as a text", Document::text("2024"))
      .set("word that is a flag elsewhere", Document::text("yes"))
      .set("greek", Document::text("\u03b1 = 3"))
      .set("blank", Document::text(" "))
      .set("pi", Document::number(3.141592653589793))
      .set("small", Document::number(1e-300))
      .set("items", Document::list({item, item}))
      .set("no items", Document::list())
      .set("path", Document::text("../reference/file.csv"));
  return root;
}

TEST(Document, YamlReadsBackTheSame) {
  expect_same(parsed(yaml_text(sample())), sample());
}

TEST(Document, JsonReadsBackTheSameAsYaml) {
  expect_same(parsed(json_text(sample())), sample());
}

TEST(Document, WhatIsNotFiniteBecomesNull) {
  Document root = Document::map();
  root.set("nan", Document::number(std::numeric_limits<double>::quiet_NaN()))
      .set("inf", Document::number(std::numeric_limits<double>::infinity()));
  EXPECT_EQ(json_text(root), "{\n  \"nan\": null,\n  \"inf\": null\n}\n");
}

TEST(Document, TextsThatReadLikeSomethingElseAreQuoted) {
  for (const char* title :
       {"- my slope", "NULL", "null", "~",  "True", "off",  "No", "1e5",   "0x10", "a: b", "# a", "[a]", "&a",
        "*a",         "!a",   "",     " a", "a ",   "a\nb", "'a", "\"a\"", "1.5",  "-",    "?",   "%a",  "@a"}) {
    Document root = Document::map();
    root.set("title", Document::text(title));
    EXPECT_EQ(parsed(yaml_text(root)).find("title")->value, title);
    EXPECT_TRUE(yaml_text(root).ends_with("\"\n")) << yaml_text(root);
  }
  Document quantity = Document::map();
  quantity.set("level", Document::text("-1.5 m")).set("title", Document::text("A slope (wet), 2"));
  EXPECT_EQ(yaml_text(quantity), "level: -1.5 m\ntitle: \"A slope (wet), 2\"\n");
}

TEST(Document, ExponentsAreNumbersForEveryYamlReader) {
  EXPECT_EQ(Document::number(1e-6).value, "1.0e-06");
  EXPECT_EQ(Document::number(1.5e-6).value, "1.5e-06");
  EXPECT_EQ(Document::number(1e300).value, "1.0e+300");
}

TEST(Document, SetReplacesAnEntryInItsPlace) {
  Document root = Document::map();
  root.set("a", Document::number(1)).set("b", Document::number(2)).set("a", Document::number(3));
  EXPECT_EQ(yaml_text(root), "a: 3\nb: 2\n");
}

TEST(Document, YamlIsLaidOutForReading) {
  EXPECT_EQ(yaml_text(parsed("{a: {b: 1 m, c: [[0 m, 1 m], [2 m, 3 m]]}, d: [{e: 1, f: {g: 2}}, {e: 3}]}")),
            "a:\n  b: 1 m\n  c: [[0 m, 1 m], [2 m, 3 m]]\nd:\n  - e: 1\n    f:\n      g: 2\n  - e: 3\n");
}

}  // namespace
}  // namespace slope::couple
