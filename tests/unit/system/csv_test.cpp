// SPDX-License-Identifier: MIT
#include "system/csv.hpp"

#include <gtest/gtest.h>

namespace mirocup::system {
namespace {

using namespace std::string_view_literals;
using Cells = std::vector<std::string>;

// The same table as Excel, LibreOffice and editors write it.
TEST(Csv, ReadsWhatSpreadsheetsWrite) {
  for (const std::string text :
       {"team,display\na,\"M, \"\"Z\"\"\"\n", "\xef\xbb\xbfteam;display\r\na;\"M, \"\"Z\"\"\"\r\n",
        "team\tdisplay\r a \t M, \"Z\" \xc2\xa0",
        "sep=;\r\nteam;display\r\n;\r\na;M, \"Z\"\r\n\r\n"}) {
    const auto table = read_csv(text);
    ASSERT_TRUE(table) << text;
    ASSERT_EQ(table->rows.size(), 2u) << text;
    EXPECT_EQ(table->rows[0].cells, (Cells{"team", "display"})) << text;
    EXPECT_EQ(table->rows[1].cells, (Cells{"a", "M, \"Z\""})) << text;
    EXPECT_FALSE(table->was_windows_1252);
  }
  const auto lines = read_csv("a\r\n\r\n\"two\r\nlines\",b\n\nc");
  ASSERT_TRUE(lines);
  EXPECT_EQ(lines->rows[1].line, 3);
  EXPECT_EQ(lines->rows[1].cells, (Cells{"two\nlines", "b"}));
  EXPECT_EQ(lines->rows[2].line, 6);
}

// Catches a cell that is looked through again for each of its quotation marks, which takes minutes.
TEST(Csv, TakesQuotationMarksForLettersInABareCell) {
  const std::size_t many = std::size_t{2} << 20;
  std::string blanks;
  for (std::size_t i = 0; i < many / 2; ++i) blanks += "\xc2\xa0";
  for (const std::string& begin :
       {std::string("a"), std::string(many, ' ') + "a", blanks + "\xc3\xa0"}) {
    const auto table = read_csv(begin + std::string(many, '"'));
    ASSERT_TRUE(table);
    ASSERT_EQ(table->rows.size(), 1u);
    EXPECT_EQ(table->rows[0].cells.size(), 1u);
    EXPECT_TRUE(table->rows[0].cells[0].ends_with(std::string(many, '"')));
  }
  const auto closed = read_csv(" \xc2\xa0\t\"a\"\"\", \xc2\xa9\"b\"\n\xc2\xa0\"c,\"");
  ASSERT_TRUE(closed);
  EXPECT_EQ(closed->rows[0].cells, (Cells{"a\"", "\xc2\xa9\"b\""}));
  EXPECT_EQ(closed->rows[1].cells, (Cells{"c,"}));
}

TEST(Csv, ReadsWindows1252) {
  const auto table = read_csv("M\xfcller;\x80;\x81");
  ASSERT_TRUE(table);
  EXPECT_TRUE(table->was_windows_1252);
  EXPECT_EQ(table->rows[0].cells, (Cells{"Müller", "€", "\x81"}));
}

// As Excel's "Unicode Text" and PowerShell write it, with and without a mark.
TEST(Csv, ReadsUtf16) {
  for (const std::string_view text :
       {"\xff\xfe"
        "L\0\xf6\0\t\0\x3d\xd8\x00\xde\r\0\n\0"sv,
        "L\0\xf6\0\t\0\x3d\xd8\x00\xde"sv, "\xfe\xff\0L\0\xf6\0\t\xd8\x3d\xde\x00"sv,
        "\0L\0\xf6\0\t\xd8\x3d\xde\x00"sv}) {
    const auto table = read_csv(text);
    ASSERT_TRUE(table);
    EXPECT_FALSE(table->was_windows_1252);
    EXPECT_EQ(table->rows[0].cells, (Cells{"Lö", "😀"}));
  }
}

TEST(Csv, RefusesWhatIsNoTable) {
  EXPECT_EQ(read_csv("\xff\xfe"
                     "a")
                .error()
                .what,
            "line 1: it is damaged text in UTF-16: save it as \"CSV UTF-8\"");
  EXPECT_EQ(read_csv("PK\x03\x04").error().what,
            "line 1: it is a workbook: save the sheet as \"CSV UTF-8\"");
  EXPECT_EQ(read_csv("a\nb,\"c\nd").error().what,
            "line 2: a quotation mark begins a cell and no other one ends it");
}

// A name must not become a formula in the computer of whoever grades.
TEST(Csv, MarksFormulas) {
  EXPECT_EQ(csv_line({"=1+2", "@SUM(A1)", "-2+3", "+49 170", "\t=1", "-inf"}),
            "'=1+2,'@SUM(A1),'-2+3,'+49 170,'\t=1,'-inf\r\n");
  EXPECT_EQ(csv_line({"-5", "-0.25", "+3", "-", "", "a=b", "-1e3"}), "-5,-0.25,+3,-,,a=b,-1e3\r\n");
}

}  // namespace
}  // namespace mirocup::system
