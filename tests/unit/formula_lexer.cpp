// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Words, signs and places.
#include <gtest/gtest.h>

#include "formula/language/lexer.h"

namespace findspace::formula {
namespace formula_lexer {

using K = Token::Kind;

/// All up to the end or the first fault.
std::vector<Token> tokenize(std::string_view text) {
  Lexer lexer(text);
  std::vector<Token> result;
  do result.push_back(lexer.next());
  while (result.back().kind != K::kEnd && result.back().kind != K::kFault);
  return result;
}

std::vector<K> kinds(std::string_view text) {
  std::vector<K> result;
  for (const Token& token : tokenize(text)) result.push_back(token.kind);
  return result;
}

TEST(Lexer, EmptyAndBlankTextsEnd) {
  EXPECT_EQ(kinds(""), std::vector<K>{K::kEnd});
  EXPECT_EQ(kinds(" \t\r\n\u00a0\u2009"), std::vector<K>{K::kEnd});
}

TEST(Lexer, SignsOfTheLiteratureAreTheAsciiOnes) {
  EXPECT_EQ(kinds("∧ ∨ ¬ → −"), (std::vector<K>{K::kAnd, K::kOr, K::kNot, K::kArrow, K::kMinus, K::kEnd}));
  const auto symbols = tokenize("≤≥≠"), ascii = tokenize("<=>=!=");
  ASSERT_EQ(symbols.size(), 4u);
  ASSERT_EQ(ascii.size(), 4u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(symbols[i].kind, K::kRelation);
    EXPECT_EQ(symbols[i].relation, ascii[i].relation);
  }
}

TEST(Lexer, ArrowIsNotAMinus) {
  EXPECT_EQ(kinds("->"), (std::vector<K>{K::kArrow, K::kEnd}));
  EXPECT_EQ(kinds(">-1"), (std::vector<K>{K::kRelation, K::kMinus, K::kNumber, K::kEnd}));
  EXPECT_EQ(kinds("<-1"), (std::vector<K>{K::kRelation, K::kMinus, K::kNumber, K::kEnd}));
}

TEST(Lexer, Numbers) {
  for (const char* text : {"0", "12", "0.5", "1e3", "2.5E-3", "1e+2"}) {
    const auto tokens = tokenize(text);
    ASSERT_EQ(tokens.size(), 2u) << text;
    EXPECT_EQ(tokens[0].kind, K::kNumber) << text;
    EXPECT_EQ(tokens[0].text, text);
  }
  EXPECT_EQ(tokenize(".5")[0].text, "0.5");
  EXPECT_EQ(kinds("20mil"), (std::vector<K>{K::kNumber, K::kName, K::kEnd}));
  EXPECT_EQ(tokenize("2em")[1].text, "em");
  EXPECT_EQ(tokenize("2e-m")[1].text, "e");
  EXPECT_EQ(kinds("5.").back(), K::kFault);
  EXPECT_EQ(kinds("1.2.3"), (std::vector<K>{K::kNumber, K::kFault}));
}

TEST(Lexer, NamesOfAnyScript) {
  for (const char* text : {"board", "_x1", "Küche", "γ₁", "部品", "B2", "U3.14"}) {
    const auto tokens = tokenize(text);
    ASSERT_EQ(tokens.size(), 2u) << text;
    EXPECT_EQ(tokens[0].kind, K::kName) << text;
    EXPECT_TRUE(is_identifier(text));
  }
  for (const char* text : {"", "2x", "my part", "a-b", "a.", ".b", "a..b", "≤", "\xff"})
    EXPECT_FALSE(is_identifier(text)) << text;
}

TEST(Lexer, QuotedNames) {
  EXPECT_EQ(tokenize("\"my part\"")[0].text, "my part");
  EXPECT_EQ(tokenize("'my part'")[0].text, "my part");
  EXPECT_EQ(tokenize(R"("a\"b\\c")")[0].text, R"(a"b\c)");
  EXPECT_EQ(kinds("\"open"), std::vector<K>{K::kFault});
  EXPECT_EQ(kinds("\"two\nlines\""), std::vector<K>{K::kFault});
  for (const char* name : {"my part", "a\"b\\c", "2x4", ""}) {
    EXPECT_EQ(tokenize(quoted_if_needed(name))[0].text, name);
    EXPECT_EQ(tokenize(quoted_if_needed(name))[0].kind, K::kQuoted);
  }
}

TEST(Lexer, FaultsEndTheTokens) {
  for (const char* text :
       {"a $ b", "a == b", "a && b", "a ! b", "a \xff b", "a \xed\xa0\x80", "a \xc0\x80", "a \x01"}) {
    EXPECT_EQ(kinds(text), (std::vector<K>{K::kName, K::kFault})) << text;
  }
}

TEST(Source, PlacesCountCharactersAndLines) {
  const Source source("γ₁ and\r\n  bad");
  EXPECT_EQ(source.place({6, 9}), "1:4");
  EXPECT_EQ(source.place({13, 16}), "2:3");
  const Error error = source.error(ErrorCode::kSyntax, {13, 16}, "no");
  EXPECT_EQ(error.message(), "no\n    bad\n    ^~~");
  EXPECT_EQ(error.place(), "2:3");
}

TEST(Source, LongLinesAreCut) {
  const std::string text(1000, 'x');
  const Error error = Source(text).error(ErrorCode::kSyntax, {500, 501}, "no");
  const std::string message = error.message();
  EXPECT_EQ(message, "no\n  ..." + std::string(100, 'x') + "...\n     " + std::string(60, ' ') + "^");
}

TEST(Source, MessagesAreCleanUtf8) {
  const Error error = Source("a\xff\tb\x1b c").error(ErrorCode::kSyntax, {1, 2}, "no");
  EXPECT_EQ(error.message(), "no\n  a? b? c\n   ^");
}

}  // namespace formula_lexer
}  // namespace findspace::formula
