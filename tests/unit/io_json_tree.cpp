// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The JSON reader: what values hold and where they stand, and every way in which a text is refused, with its place.

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "findspace/error.h"
#include "io/text/json_tree.h"

namespace findspace::io {
namespace io_json_tree {

using Kind = JsonValue::Kind;

JsonTree parsed(std::string_view text) {
  plane::WorkBudget work;
  return parse_json(text, "n", work);
}

/// "line:column message".
std::string refusal(std::string_view text) {
  try {
    parsed(text);
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kSyntax);
    return e.place().substr(std::min<std::size_t>(2, e.place().size())) + " " + e.message();
  }
  return "read";
}

TEST(JsonTree, HoldsValuesWithTheirPlaces) {
  const JsonTree tree =
      parsed("\xEF\xBB\xBF{\"a\": [1.10, -2e3, true], // why\n \"b\" : null,\r\n\t\"c\":\"\" /* \n*/}\n");
  const JsonValue& root = tree.root();
  ASSERT_TRUE(root.is(Kind::kObject));
  EXPECT_EQ(root.size(), 3u);
  EXPECT_EQ(root.keys()[1], "b");
  EXPECT_EQ(root.column, 4);  // the byte order mark counts
  const JsonValue& list = *root.find("a");
  ASSERT_TRUE(list.is(Kind::kArray));
  EXPECT_EQ(list.items()[0].text(), "1.10");
  EXPECT_EQ(list.items()[1].text(), "-2e3");
  EXPECT_TRUE(list.items()[2].is(Kind::kBoolean) && list.items()[2].boolean);
  EXPECT_EQ(list.items()[1].line, 1);
  EXPECT_EQ(list.items()[1].column, 17);
  EXPECT_EQ(root.find("b")->line, 2);
  EXPECT_EQ(root.find("b")->column, 8);
  EXPECT_EQ(root.find("c")->line, 3);
  EXPECT_TRUE(root.find("c")->is(Kind::kString) && root.find("c")->text().empty());
  EXPECT_EQ(root.find("d"), nullptr);
  EXPECT_TRUE(list.text().empty() && list.keys().empty() && root.find("b")->items().empty());
}

TEST(JsonTree, CountsValuesBeforeItReadsThem) {
  const auto code = [](std::string_view text) -> std::optional<ErrorCode> {
    plane::WorkBudget work(8 * kJsonValue);
    try {
      parse_json(text, "n", work);
    } catch (const Error& e) {
      return e.code();
    }
    return std::nullopt;
  };
  EXPECT_EQ(code("[1, [], {}, {\"a\": \",,,,,,,,\\\",\"}, [2] /* ,,,,,,,, */ ] // ,,,,,,,,\n"), std::nullopt);
  EXPECT_EQ(code("[0, 1, 2, 3, 4, 5, 6]"), std::nullopt);
  EXPECT_EQ(code("[0, 1, 2, 3, 4, 5, 6, 7]"), ErrorCode::kLimit);
  EXPECT_EQ(code("[x, 1, 2, 3, 4, 5, 6, 7]"), ErrorCode::kLimit);
  EXPECT_EQ(code("[x, 1, 2, 3, 4, 5, 6]"), ErrorCode::kSyntax);
}

TEST(JsonTree, ReadsTexts) {
  const JsonTree tree = parsed(R"(["\"\\\/\b\f\n\r\t", "\u00e9\u20AC", "\ud83d\ude00", "é", "a\u0000b"])");
  const auto items = tree.root().items();
  EXPECT_EQ(items[0].text(), "\"\\/\b\f\n\r\t");
  EXPECT_EQ(items[1].text(), "é€");
  EXPECT_EQ(items[2].text(), "\xf0\x9f\x98\x80");
  EXPECT_EQ(items[3].text(), "é");
  EXPECT_EQ(items[4].text(), std::string_view("a\0b", 3));
}

TEST(JsonTree, KeepsTheKeysOfEveryObject) {
  const JsonTree tree = parsed(R"([{"a":1,"b":2},{"a":3,"b":4},{"b":5,"a":6},{"a":7},{},{"a":8,"b":{"a":9,"b":10}}])");
  const auto items = tree.root().items();
  const auto value = [&](std::size_t k, std::string_view key) { return std::string(items[k].find(key)->text()); };
  EXPECT_EQ(value(0, "a") + value(0, "b"), "12");
  EXPECT_EQ(value(1, "a") + value(1, "b"), "34");
  EXPECT_EQ(value(2, "a") + value(2, "b"), "65");
  EXPECT_EQ(items[2].keys()[0], "b");
  EXPECT_EQ(items[3].size(), 1u);
  EXPECT_EQ(items[4].size(), 0u);
  EXPECT_EQ(items[5].find("b")->find("b")->text(), "10");
  EXPECT_EQ(items[0].keys().data(), items[1].keys().data());  // kept once
}

TEST(JsonTree, OutlivesItsTextAndMoves) {
  std::string text = R"({"key": ["value", 12]})";
  JsonTree tree = parsed(text);
  text.assign(text.size(), '?');
  const JsonTree moved = std::move(tree);
  EXPECT_EQ(moved.root().find("key")->items()[0].text(), "value");
  EXPECT_EQ(moved.root().find("key")->items()[1].text(), "12");
}

TEST(JsonTree, SaysWhatIsWrongAndWhere) {
  const std::string begin = "this is not JSON: ", early = begin + "the end comes too early; ";
  const std::string value =
      "a value is expected: a number, a text in double quotes, a list, an object, true, false or null";
  const std::vector<std::pair<std::string, std::string>> all{
      {"", "1:1 " + early + "there is no value"},
      {" // only this", "1:14 " + early + "there is no value"},
      {"[1,\n2", "2:2 " + early + "',' or ']' is expected"},
      {"[1 2]", "1:4 " + begin + "',' or ']' is expected"},
      {"[1,]", "1:4 " + begin + value},
      {"{\"a\":1,}", "1:8 " + begin + "a name in double quotes is expected"},
      {"{a:1}", "1:2 " + begin + "a name in double quotes is expected"},
      {"{\"a\" 1}", "1:6 " + begin + "':' is expected after the name"},
      {"{\"a\":1 \"b\":2}", "1:8 " + begin + "',' or '}' is expected"},
      {"[1] 2", "1:5 " + begin + "text stands after the end"},
      {"[tru]", "1:5 " + begin + value},
      {"[NaN]", "1:2 " + begin + value},
      {"[-]", "1:3 " + begin + value},
      {"[−1]", "1:2 " + begin + "stray character '−'; the minus is '-'"},
      {"[1.]", "1:4 " + begin + "digits are expected after the decimal point"},
      {"[1e+]", "1:5 " + begin + "digits are expected after the exponent's letter"},
      {"[0, 1e309]", "1:5 " + begin + "the number is beyond 1e308"},
      {"[" + std::string(310, '9') + "]", "1:2 " + begin + "the number is beyond 1e308"},
      {"[\"a", "1:4 " + early + "a text without its closing '\"'"},
      {"[\"a\nb\"]", "1:4 " + begin + "no such escape in a text"},
      {"[\"a\\x\"]", "1:4 " + begin + "no such escape in a text"},
      {"[\"\\u12g4\"]", "1:3 " + begin + "four hexadecimal digits are expected after '\\u'"},
      {"[\"\\ud800x\"]", "1:3 " + begin + "half of a surrogate pair"},
      {"[\"\xed\xa0\x80\"]", "1:3 " + begin + "a control character or no UTF-8 in a text"},
      {"[\"\xc3\"]", "1:3 " + begin + "a control character or no UTF-8 in a text"},
      {"[1, /* 2]\n ", "2:2 " + early + "a comment without its end"},
      {"[1, / 2]", "1:6 " + begin + "a comment without its end"},
      {std::string("[1, \0]", 6), "1:5 " + begin + "a NUL byte"},
      {"{\"a\": 1, \"b\": 2,\n \"a\": 3}", "2:2 the key 'a' stands twice in one object"},
      {R"({"1":1,"2":2,"3":3,"4":4,"5":5,"6":6,"7":7,"8":8,"9":9,"3":0})",
       "1:56 the key '3' stands twice in one object"},
      {std::string(201, '['), "1:201 more than 200 levels of nesting"},
  };
  for (const auto& [text, why] : all) EXPECT_EQ(refusal(text), why) << text;
  EXPECT_EQ(refusal("1e308"), "read");
  EXPECT_EQ(refusal(std::string(200, '[') + std::string(200, ']')), "read");
}

TEST(JsonTree, CountsItsValuesAsWork) {
  plane::WorkBudget enough(4 * kJsonValue), too_little(4 * kJsonValue - 1);
  parse_json("[1, [2]]", "n", enough);
  EXPECT_EQ(enough.left(), 0u);
  EXPECT_THROW(parse_json("[1, [2]]", "n", too_little), Error);
}

}  // namespace io_json_tree
}  // namespace findspace::io
