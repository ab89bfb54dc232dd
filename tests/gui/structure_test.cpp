#include "gui/geometry/structure.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "frf/set/frf_set.hpp"
#include "gui/geometry/camera.hpp"
#include "tests/test_folder.hpp"

namespace jointid::gui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<frf::Dof> dofs(const std::vector<const char*>& names) {
  std::vector<frf::Dof> out;
  for (const char* name : names) out.push_back(frf::Dof::parse(name));
  return out;
}

LoadedFile file_with(std::vector<frf::Node> nodes, const std::vector<const char*>& responses) {
  LoadedFile file;
  file.header.nodes = std::move(nodes);
  file.header.response = dofs(responses);
  file.header.reference = {file.header.response.front()};
  return file;
}

TEST(Structure, NodesOfAllFilesStandTogether) {
  const Structure found = structure_of({file_with({{2, {1, 0, 0}}, {1, {0, 0, 0}}}, {"1:+Y", "2:-Z", "9:+X"}),
                                        file_with({{2, {7, 7, 7}}, {3, {2, 0, 0}}}, {"2:+Z", "3:+Y"})},
                                       {{1, 2}, {2, 4}});
  ASSERT_EQ(found.nodes.size(), 3U);
  EXPECT_THAT(found.nodes[1].position, ElementsAre(1.0, 0.0, 0.0));
  EXPECT_THAT(found.lines, ElementsAre(frf::NodeLine{1, 2}));
  EXPECT_THAT(frf::names(found.dofs), ElementsAre("1:+Y", "2:-Z", "3:+Y"));
  EXPECT_THAT(frf::names(found.unplaced), ElementsAre("9:+X"));
}

/// X of node 1 is the global Y, Y its −X; of node 2 nobody knows; node 3 is along the global axes.
TEST(Structure, DofsAndMotionsAreAlongTheAxesOfTheirNode) {
  const double unknown = std::nan("");
  const frf::Axes turned{{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}}, lost{{{unknown, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const Structure found = structure_of(
      {file_with({{1, {0, 0, 0}, turned}, {2, {1, 0, 0}, lost}, {3, {2, 0, 0}}}, {"1:-X", "1:+Y", "2:+X", "3:+X"})}, {});
  EXPECT_THAT(frf::names(found.dofs), ElementsAre("1:-X", "1:+Y", "3:+X"));
  EXPECT_THAT(frf::names(found.unplaced), ElementsAre("2:+X"));
  EXPECT_THAT(direction_of(found.nodes[0], found.dofs[0]), ElementsAre(0.0, -1.0, 0.0));
  EXPECT_THAT(direction_of(found.nodes[0], found.dofs[1]), ElementsAre(-1.0, 0.0, 0.0));
  EXPECT_THAT(direction_of(found.nodes[2], found.dofs[2]), ElementsAre(1.0, 0.0, 0.0));
  const Shape shape = {{1, {Complex(2.0, 1.0), 3.0, 5.0}}, {2, {1.0, 1.0, 1.0}}, {3, {7.0, 0.0, 0.0}}, {9, {1.0, 0.0, 0.0}}};
  const Shape global = in_global_axes(shape, found.nodes);
  ASSERT_EQ(global.size(), 2U);
  EXPECT_THAT(global.at(1), ElementsAre(Complex(-3.0), Complex(2.0, 1.0), Complex(5.0)));
  EXPECT_EQ(global.at(3), shape.at(3));
}

TEST(Structure, LinesOfAUniversalFileAreDrawnWhateverItsName) {
  const TestFolder folder;
  const std::filesystem::path path = folder / "export.dat";
  std::ofstream(path) << "    -1\n    82\n         1         3         0\nbeam\n         1         2         5\n    -1\n";
  ident::DataSection data;
  data.assembly.push_back({path, {}});
  EXPECT_THAT(drawn_lines(data, {}), ElementsAre(frf::NodeLine{1, 2}, frf::NodeLine{2, 5}));
  std::ofstream(path) << "Frequency [Hz];1:+X\n";
  EXPECT_THAT(drawn_lines(data, {}), IsEmpty());
}

TEST(Structure, WithoutLinesThoseOfStraightPartsAreJoined) {
  const auto straight = file_with({{1, {0, 0, 0}}, {2, {1, 1, 0}}, {3, {3, 3, 0}}}, {"3:+Z", "1:+Z", "2:+Z"});
  EXPECT_THAT(structure_of({straight}, {}).lines, ElementsAre(frf::NodeLine{1, 2}, frf::NodeLine{2, 3}));
  auto bent = straight;
  bent.header.nodes[1].position = {1, 0, 0};
  EXPECT_THAT(structure_of({bent}, {}).lines, IsEmpty());
}

TEST(Structure, ItsExtentIsHalfTheDiagonalRoundIt) {
  const Structure found = structure_of({file_with({{1, {0, 0, 0}}, {2, {6, 8, 0}}}, {"1:+Z"})}, {});
  EXPECT_DOUBLE_EQ(extent_of(found).radius, 5.0);
  EXPECT_THAT(extent_of(found).middle, ElementsAre(3.0, 4.0, 0.0));
  EXPECT_DOUBLE_EQ(extent_of(Structure()).radius, 1.0);
}

TEST(Camera, KeepsTheMiddleInTheMiddleAndTheWholeInThePicture) {
  Camera camera;
  camera.look_at({{1.0, 2.0, 3.0}, 2.0});
  camera.set_size({400.0, 300.0});
  for (int i = 0; i < 20; ++i) {
    camera.turn(0.37, i % 2 == 0 ? 0.4 : -0.7);
    EXPECT_EQ(camera.project({1.0, 2.0, 3.0}), QPointF(200.0, 150.0));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Vector end = {1.0, 2.0, 3.0};
      end[axis] += 2.0;
      const QPointF off = camera.project(end) - QPointF(200.0, 150.0);
      EXPECT_LE(std::hypot(off.x(), off.y()), 170.0 + 1e-9);
    }
  }
  const double before = camera.pixels();
  camera.zoom(2.0);
  EXPECT_DOUBLE_EQ(camera.pixels(), 2.0 * before);
  camera.show_all();
  EXPECT_DOUBLE_EQ(camera.pixels(), before);
}

/// From straight above x is to the right and y up, and heights do not matter.
TEST(Camera, LooksStraightDown) {
  Camera camera;
  camera.look_at({{0.0, 0.0, 0.0}, 1.0});
  camera.set_size({200.0, 100.0});
  camera.turn(0.6, 10.0);
  EXPECT_NEAR(camera.project({1.0, 0.0, 0.0}).x(), 185.0, 1e-9);
  EXPECT_NEAR(camera.project({0.0, 1.0, 0.0}).y(), -35.0, 1e-9);
  EXPECT_NEAR(camera.project({0.0, 0.0, 1.0}).y(), 50.0, 1e-9);
}

TEST(Distance, OfAPointFromALine) {
  EXPECT_DOUBLE_EQ(distance_to({5.0, 3.0}, {0.0, 0.0}, {10.0, 0.0}), 3.0);
  EXPECT_DOUBLE_EQ(distance_to({13.0, 4.0}, {0.0, 0.0}, {10.0, 0.0}), 5.0);
  EXPECT_DOUBLE_EQ(distance_to({3.0, 4.0}, {0.0, 0.0}, {0.0, 0.0}), 5.0);
}

TEST(Camera, LooksAlongTheAxes) {
  Camera camera;
  camera.set_size({200.0, 200.0});
  camera.look_at({{0.0, 0.0, 0.0}, 1.0});
  const auto moves = [&camera](Camera::Side side, const Vector& axis) {
    camera.look_from(side);
    const QPointF off = camera.project(axis) - camera.project({0.0, 0.0, 0.0});
    return std::pair(std::round(off.x() / camera.pixels()), std::round(-off.y() / camera.pixels()));
  };
  using Off = std::pair<double, double>;
  EXPECT_EQ(moves(Camera::Side::front, {1, 0, 0}), Off(1, 0));
  EXPECT_EQ(moves(Camera::Side::front, {0, 0, 1}), Off(0, 1));
  EXPECT_EQ(moves(Camera::Side::side, {0, 1, 0}), Off(1, 0));
  EXPECT_EQ(moves(Camera::Side::side, {0, 0, 1}), Off(0, 1));
  EXPECT_EQ(moves(Camera::Side::top, {1, 0, 0}), Off(1, 0));
  EXPECT_EQ(moves(Camera::Side::top, {0, 1, 0}), Off(0, 1));
}

}  // namespace
}  // namespace jointid::gui
