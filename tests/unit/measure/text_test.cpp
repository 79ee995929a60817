#include "core/error.hpp"
#include "measure/text.hpp"

#include <gtest/gtest.h>

namespace {

using namespace platen;
using measure::decode;

std::string refusal(std::string bytes) {
  try {
    (void)decode(std::move(bytes), "f");
  } catch (const core::InvalidInput& error) { return error.what(); }
  return "";
}

TEST(Text, EncodingsAreToldByTheirBytes) {
  EXPECT_EQ(decode("s,N\n", "f").encoding, "ASCII");
  EXPECT_EQ(decode("\xEF\xBB\xBFµm", "f").utf8, "µm");
  EXPECT_EQ(decode("Pr\xFC"
                   "fkraft \xB5m",
                   "f")
                .utf8,
            "Prüfkraft µm");
  const std::string wide("\xFF\xFE"
                         "N\0;\0\xB5\0",
                         8);
  EXPECT_EQ(decode(wide, "f").utf8, "N;µ");
  const std::string big("\xFE\xFF\0N\0;", 6);
  EXPECT_EQ(decode(big, "f").utf8, "N;");
  EXPECT_EQ(decode("\x8E\x8E\x8C\xB1\x97\xCD[mN]", "f").utf8, "試験力[mN]"); // Shift-JIS
}

TEST(Text, WhatIsNoTextIsNamed) {
  EXPECT_NE(refusal("\x89PNG\r\n").find("a picture (PNG)"), std::string::npos);
  EXPECT_NE(refusal("PK\x03\x04......xl/workbook.xml").find("a spreadsheet"), std::string::npos);
  EXPECT_NE(refusal("%PDF-1.4").find("a PDF document"), std::string::npos);
  EXPECT_NE(refusal(std::string("TEST\0\x01\x02\x03\x04\x05", 10)).find("a binary file"), std::string::npos);
  EXPECT_EQ(refusal(" \n"), "f: the file is empty");
}

} // namespace
