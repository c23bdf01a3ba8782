// Text files line by line: mbd_solver/base/text_reader.h.
#include "mbd_solver/base/text_reader.h"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/support/refused.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

using Words = std::vector<std::string>;

class TextFile : public ::testing::Test, protected TemporaryFolder {
 protected:
  TextReader of(const std::string& text) { return {write("file.txt", text), code::kTableCell, "a list"}; }
};

Words lines_of(TextReader reader) {
  Words lines;
  while (reader.next()) lines.push_back(reader.line());
  EXPECT_FALSE(reader.next()) << "the end remains";
  return lines;
}

// Files are read in pieces of 65536 bytes: lines and their ends lie on either side of an end of a piece, and over several.
TEST_F(TextFile, HasTheLinesOfGetline) {
  std::string text = "\n\nshort\n" + std::string("with\0zero", 9) + "\n";
  for (const std::size_t length : {65510u, 65535u, 65536u, 65537u, 200000u, 65534u})
    text += std::string(length, 'x') + "\n";
  for (const std::string& end : {std::string(), std::string("last"), std::string(65536, 'y'), std::string("\n")}) {
    std::istringstream reference(text + end);
    Words expected;
    for (std::string line; std::getline(reference, line);) expected.push_back(line);
    EXPECT_EQ(lines_of(of(text + end)), expected);
    EXPECT_EQ(lines_of(TextReader(text + end, "text", code::kTableCell)), expected);
  }
}

TEST_F(TextFile, EndsItsLinesInAnyWay) {
  EXPECT_EQ(lines_of(of("a\nb\r\nc\rd\r\r\n\ne")), (Words{"a", "b", "c", "d", "", "", "e"}));
  for (const std::size_t length : {65534u, 65535u, 65536u}) {  // CR LF around the end of a piece
    const std::string line(length, 'x');
    EXPECT_EQ(lines_of(of(line + "\r\nnext\r\n")), (Words{line, "next"})) << length;
    EXPECT_EQ(lines_of(of(line + "\r")), (Words{line})) << length;
  }
  TextReader text = of("a\r\nb\nc\rd");
  for (const char* const ending : {"\r\n", "\n", "\r", ""}) {
    ASSERT_TRUE(text.next());
    EXPECT_STREQ(text.ending(), ending);
  }
}

// LIGGGHTS ends a line of a script at LF alone: a command behind CR is no command.
TEST_F(TextFile, OfLiggghtsEndsItsLinesAtNewlinesOnly) {
  const std::string path = write("script", "# a\rshell x\r\nrun 1");
  EXPECT_EQ(lines_of(TextReader::if_there(path, TextReader::Ends::kNewline)), (Words{"# a\rshell x\r", "run 1"}));
}

TEST_F(TextFile, HasNoByteOrderMark) {
  EXPECT_EQ(lines_of(of("\xEF\xBB\xBF"
                        "a\n\xEF\xBB\xBF\n")),
            (Words{"a", "\xEF\xBB\xBF"}));
}

TEST_F(TextFile, HasFieldsBySeparators) {
  TextReader text = of(" a b,, c;d \t\n");
  ASSERT_TRUE(text.next());
  const auto fields = [&](Separators separators) {
    const std::vector<std::string_view>& views = text.fields(separators);
    return Words(views.begin(), views.end());
  };
  EXPECT_EQ(fields(Separators::kComma), (Words{"a b", "", "c;d"}));
  EXPECT_EQ(fields(Separators::kBlanks), (Words{"a", "b,,", "c;d"}));
  EXPECT_EQ(fields(Separators::kAny), (Words{"a", "b", "c", "d"}));
}

TEST_F(TextFile, GivesItsWordsAcrossLines) {
  TextReader text = of("1 2\n\n 3\n4\n");
  std::string_view word;
  Words words;
  while (text.next_word(word)) words.emplace_back(word);
  EXPECT_EQ(words, (Words{"1", "2", "3", "4"}));
  EXPECT_EQ(text.place(), file("file.txt") + ":4");
}

TEST_F(TextFile, NamesThePlaceOfAFault) {
  TextReader text = of("1\n2\n+7 1.5 1e999 nan 0x10 9\n");
  while (text.next() && text.line().size() == 1) {
  }
  text.back();
  EXPECT_EQ(text.number_of_line(), 2) << "the line will be read again";
  ASSERT_TRUE(text.next());
  const std::vector<std::string_view> fields = text.fields(Separators::kBlanks);
  EXPECT_EQ(text.whole(fields[0], 0, 7), 7);
  EXPECT_EQ(text.number(fields[0]), 7.0);
  EXPECT_EQ(text.number(fields[1]), 1.5);
  const std::string place = file("file.txt") + ":3: ";
  for (const std::size_t i : {2u, 3u, 4u})
    EXPECT_TRUE(test::names(test::error_of([&] { text.number(fields[i]); }),
                            {place + "\"" + std::string(fields[i]) + "\"", "finite number", "E0251"}));
  for (const std::size_t i : {0u, 1u, 4u})
    EXPECT_TRUE(test::names(test::error_of([&] { text.whole(fields[i], 8, 9); }),
                            {place + "\"" + std::string(fields[i]) + "\"", "whole number from 8 to 9", "E0251"}));
}

TEST_F(TextFile, ThatIsNotThereIsNamedOrHasNoLines) {
  EXPECT_TRUE(test::names(test::error_of([&] { TextReader(file("none"), code::kTableCell, "a list"); }),
                          {file("none"), "expected a list", "E0251"}));
  EXPECT_TRUE(test::names(test::error_of([&] { TextReader("/dev/null", code::kTableCell, "a list"); }), {"/dev/null"}));
  for (const std::string& path : {file("none"), std::string("/dev/null"), file(".")}) {
    TextReader text = TextReader::if_there(path);
    EXPECT_FALSE(text.opened());
    EXPECT_FALSE(text.next());
    EXPECT_EQ(TextReader::last_line_of(path), "");
  }
}

TEST_F(TextFile, HasALastLineWithText) {
  EXPECT_EQ(TextReader::last_line_of(write("short", "one\ntwo \r\n\n  \n")), "two");
  EXPECT_EQ(TextReader::last_line_of(write("long", std::string(100000, 'x') + "\nend")), "end");
  EXPECT_EQ(TextReader::last_line_of(write("empty", "")), "");
}

}  // namespace
}  // namespace footfall
