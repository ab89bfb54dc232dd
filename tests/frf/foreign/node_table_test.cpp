#include "frf/file/node_table.hpp"

#include <gmock/gmock.h>

#include "tests/frf/file_fixture.hpp"

namespace jointid::frf {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class NodeTable : public FileTest {
 protected:
  std::vector<Node> read(const std::string& text, const std::string& name = "nodes.csv") const {
    return read_node_table(write_file(name, text));
  }
  std::string error(const std::string& text) const {
    return message_of([&] { read(text); });
  }
};

TEST_F(NodeTable, HasPositionsInTheUnitOfItsTitles) {
  for (const std::string text :
       {"node,x [mm],y [mm],z [mm]\n4,900,0,-25\n11,0,12.5,0\n", "Node;X;Y;Z\n;mm;mm;mm\n4;900;0;-25\n11;0;12,5;0\n",
        "# sensors\nPoint\tX (m)\tY (m)\tZ (m)\n4\t0.9\t0\t-0.025\n11\t0\t0.0125\t0\n",
        "id,x,y,z\n4,0.9,0,-0.025\n11,0,0.0125,0\n"}) {
    const std::vector<Node> nodes = read(text);
    ASSERT_EQ(nodes.size(), 2U) << text;
    EXPECT_EQ(nodes[0].id, 4);
    EXPECT_THAT(nodes[0].position, ElementsAre(testing::DoubleEq(0.9), 0.0, testing::DoubleEq(-0.025))) << text;
    EXPECT_THAT(nodes[1].position, ElementsAre(0.0, testing::DoubleEq(0.0125), 0.0)) << text;
  }
}

TEST_F(NodeTable, OfAUniversalFileIsDataset2411) {
  const std::vector<Node> nodes = read(
      "    -1\n  2411\n         4         1         1        11\n   9.0000000000000000D-01   0.0000000000000000D+00  "
      "-2.5000000000000001D-02\n    -1\n",
      "nodes.unv");
  ASSERT_EQ(nodes.size(), 1U);
  EXPECT_EQ(nodes[0].id, 4);
  EXPECT_THAT(nodes[0].position, ElementsAre(0.9, 0.0, -0.025));
}

TEST_F(NodeTable, ColumnsToAreLines) {
  const auto lines = [&](const std::string& text) { return read_node_lines(write_file("lines.csv", text)); };
  EXPECT_THAT(lines("node,x [mm],y [mm],z [mm],to,To2\n4,900,0,0,11,12\n11,0,0,0,,4\n12,0,1,0,0,\n"),
              ElementsAre(NodeLine{4, 11}, NodeLine{4, 12}, NodeLine{11, 4}));
  EXPECT_THAT(lines("Label,x,y,z,to\n4,1,0,0,11\n"), ElementsAre(NodeLine{4, 11}));
  EXPECT_TRUE(lines("node,x,y,z,torque\n4,1,0,0,11\n").empty());
  EXPECT_THAT(message_of([&] { lines("node,x,y,z,to\n4,1,0,0,1.5\n"); }), HasSubstr("no whole number"));
  EXPECT_EQ(read("node,x,y,z,to\n4,1,0,0,11\n").size(), 1U) << "positions are as without lines";
}

TEST_F(NodeTable, WhatIsNoneIsRefused) {
  EXPECT_THAT(error("a,x,y,z\n4,1,0,0\n"), HasSubstr("has no column node; the columns are a, x, y, z; give titles node, x [mm]"));
  EXPECT_THAT(error("node,x,y\n4,1,0\n"), HasSubstr("has no column z"));
  EXPECT_THAT(error("node,x [g],y,z\n4,1,0,0\n"), HasSubstr("column x: 'g' is no length"));
  EXPECT_THAT(error("node,x,y,z\n4.5,1,0,0\n"), HasSubstr("row 1 of numbers: the node is no whole number"));
  EXPECT_THAT(error("node,x,y,z\n4,1,0,0\n4,2,0,0\n"), HasSubstr("row 2 of numbers: node 4 is there twice"));
  EXPECT_THAT(error("node,x,y,z\n4,1,,0\n"), HasSubstr("row 1 of numbers: y is no number"));
  EXPECT_THAT(error("node,x,y,z\n4,900,0,0\n5,0,0,0\n"),
              HasSubstr("more than 100 m apart, and no unit is stated; write the unit"));
}

TEST_F(NodeTable, ARowForEachDofIsRefusedWithARemedy) {
  for (const char* title : {"dof", "node", "DOF"})
    EXPECT_THAT(error(title + std::string(",x,y,z\n21:+X,0.1,0.2,0\n21:+Y,0.1,0.2,0\n")),
                HasSubstr("'21:+X' is not a number; of a table of nodes give each node one row, with its number"));
  EXPECT_THAT(error("node,dof,x,y,z\n21,+X,0.1,0.2,0\n21,+Y,0.1,0.2,0\n"), HasSubstr("'+X' is not a number; of a table of nodes"));
}

}  // namespace
}  // namespace jointid::frf
