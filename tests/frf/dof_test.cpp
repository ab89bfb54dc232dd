#include "frf/set/dof.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace jointid::frf {
namespace {

TEST(Dof, NameIsTheInverseOfParse) {
  for (const char* text : {"4:+Y", "4:-RZ", "9999999999:+X", "0:-RX"}) {
    EXPECT_EQ(Dof::parse(text).name(), text);
  }
}

TEST(Dof, AMissingSignIsPlus) { EXPECT_EQ(Dof::parse("4:Y"), Dof::parse("4:+Y")); }

TEST(Dof, TheSignDoesNotMakeAnotherCoordinate) {
  const Dof plus = Dof::parse("4:+Y");
  const Dof minus = Dof::parse("4:-Y");
  EXPECT_NE(plus, minus);
  EXPECT_TRUE(plus.same_coordinate(minus));
  EXPECT_EQ(coordinate_key(plus), coordinate_key(minus));
  EXPECT_FALSE(plus.same_coordinate(Dof::parse("4:+RY")));
}

TEST(Dof, WhatMayBeMeantIsProposed) {
  const std::vector<std::pair<std::string, std::string>> labels = {{"12X+", "12:+X"},
                                                                   {"12+X", "12:+X"},
                                                                   {"12:x", "12:+X"},
                                                                   {"12X", "12:+X"},
                                                                   {"12-X", "12:-X"},
                                                                   {"12 : -rz", "12:-RZ"},
                                                                   {"12:X-", "12:-X"},
                                                                   {"12.3", "12:+Z"},
                                                                   {"12:-6", "12:-RZ"},
                                                                   {"Pt1Z-", "1:-Z"},
                                                                   {"Node 7 Y", "7:+Y"},
                                                                   {"12:\u2212Y", "12:-Y"},
                                                                   {"\"4\"/+ry", "4:+RY"},
                                                                   {"H1 2Z+", "2:+Z"},
                                                                   {"FRF plate:1:+Z", "1:+Z"},
                                                                   {"plate:12:-x", "12:-X"},
                                                                   {"21:T3", "21:+Z"},
                                                                   {"21:U3", "21:+Z"},
                                                                   {"PART-1-1.21:UR1", "21:+RX"},
                                                                   {"21 R3", "21:+RZ"},
                                                                   {"U2 at node 21", "21:+Y"},
                                                                   {"GRID 21 COMP 3", "21:+Z"},
                                                                   {"UZ_21", "21:+Z"},
                                                                   {"U:U3 PI: PART-1-1 N: 21", "21:+Z"},
                                                                   {"N21_ROTX", "21:+RX"},
                                                                   {"Assembly.21:+Z", "21:+Z"},
                                                                   {"'12:-X'", "12:-X"}};
  for (const auto& [text, near] : labels) {
    try {
      Dof::parse(text);
      FAIL() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("did you mean " + near + "? Write node:direction"), std::string::npos)
          << error.what();
    }
  }
  for (const char* text : {"X", "12", "12:Q", "1X2", "12:+-X", "12XY", "force", "21-U3", "U1 U2 5", "5 6 U1"}) {
    try {
      Dof::parse(text);
      FAIL() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find("did you mean"), std::string::npos) << error.what();
    }
  }
}

TEST(Dof, WhatIsNotADofIsAnErrorThatNamesIt) {
  for (const char* text : {"", "4", "4:", ":+Y", "4:+Q", "x:+Y", "-4:+Y", "4:++Y", "4.5:+Y", "10000000000:+Y"}) {
    try {
      Dof::parse(text);
      FAIL() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("'" + std::string(text) + "'"), std::string::npos) << error.what();
      EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
  }
}

}  // namespace
}  // namespace jointid::frf
