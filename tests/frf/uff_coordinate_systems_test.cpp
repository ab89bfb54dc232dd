#include <gmock/gmock.h>

#include <cmath>
#include <string>

#include "frf/uff/uff_file.hpp"
#include "uff_samples.hpp"

namespace jointid::frf {
namespace {

using namespace samples;
using testing::HasSubstr;

FrfSet loaded(const std::string& bytes) {
  const TemporaryUff file(bytes);
  return load(*open_uff(file));
}

std::string three(double x, double y, double z) { return format("%25.16E%25.16E%25.16E\n", x, y, z); }

std::string integers(std::initializer_list<int> values) {
  std::string out;
  for (const int value : values) out += format("%10d", value);
  return out + "\n";
}

/// x' along (0.6, 0.8, 0), y' along (−0.8, 0.6, 0); origin (100, 200, 300) of the file's lengths. Its name is blank.
std::string system(int label, int kind) {
  return integers({label, kind, 0}) + "\n" + three(0.6, 0.8, 0.0) + three(-0.8, 0.6, 0.0) + three(0.0, 0.0, 1.0) +
         three(100.0, 200.0, 300.0);
}

std::string systems(const std::string& of) { return "    -1\n  2420\n         1\nPart\n" + of + "    -1\n"; }

std::string node(int id, int defined_in, int displaced_in, double x, double y, double z) {
  return "    -1\n  2411\n" + integers({id, defined_in, displaced_in, 11}) + three(x, y, z) + "    -1\n";
}

/// In millimetres.
Node node_of(const std::string& geometry) {
  const FrfSet set = loaded(units_164(1000.0, 1.0) + geometry + simple_record().str());
  if (set.header.nodes.size() != 1) throw std::runtime_error("not one node");
  return set.header.nodes.front();
}

void expect_near(const std::array<double, 3>& one, const std::array<double, 3>& other) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(one[i], other[i], 1e-14) << i;
}

TEST(UffCoordinateSystems, TurnNodesAndTheirDofs) {
  const Node found = node_of(node(7, 5, 5, 10.0, 20.0, 30.0) + systems(system(5, 0)));  // the systems may come behind
  expect_near(found.position, {0.1 + 0.006 - 0.016, 0.2 + 0.008 + 0.012, 0.33});
  ASSERT_TRUE(found.axes);
  expect_near((*found.axes)[0], {0.6, 0.8, 0.0});
  expect_near((*found.axes)[1], {-0.8, 0.6, 0.0});
  expect_near((*found.axes)[2], {0.0, 0.0, 1.0});
}

/// r = 50 mm at 90° is along y'; there r is along y', θ along −x'.
TEST(UffCoordinateSystems, CylindricalAxesGoWithTheNode) {
  const Node found = node_of(systems(system(5, 1)) + node(7, 5, 5, 50.0, 90.0, -10.0));
  expect_near(found.position, {0.1 - 0.04, 0.2 + 0.03, 0.29});
  ASSERT_TRUE(found.axes);
  expect_near((*found.axes)[0], {-0.8, 0.6, 0.0});
  expect_near((*found.axes)[1], {-0.6, -0.8, 0.0});
  expect_near((*found.axes)[2], {0.0, 0.0, 1.0});
}

/// r = 50 mm, 90° from Z, 90° round Z: along y'; θ is along −Z, φ along −x'.
TEST(UffCoordinateSystems, SphericalAxesGoWithTheNode) {
  const Node found = node_of(systems(system(5, 2)) + node(7, 5, 5, 50.0, 90.0, 90.0));
  expect_near(found.position, {0.1 - 0.04, 0.2 + 0.03, 0.3});
  ASSERT_TRUE(found.axes);
  expect_near((*found.axes)[0], {-0.8, 0.6, 0.0});
  expect_near((*found.axes)[1], {0.0, 0.0, -1.0});
  expect_near((*found.axes)[2], {-0.6, -0.8, 0.0});
}

TEST(UffCoordinateSystems, GlobalOnesAreSilentAndUnknownOnesAreKnownToBe) {
  EXPECT_FALSE(node_of(node(7, 0, 1, 1.0, 2.0, 3.0)).axes);
  const std::string identity = integers({1, 0, 0}) + "Global\n" + three(1.0, 0.0, 0.0) + three(0.0, 1.0, 0.0) +
                               three(0.0, 0.0, 1.0) + three(0.0, 0.0, 0.0);
  EXPECT_FALSE(node_of(systems(identity) + node(7, 1, 1, 1.0, 2.0, 3.0)).axes);
  const Node undefined = node_of(systems(identity) + node(7, 1, 9, 1.0, 2.0, 3.0));
  ASSERT_TRUE(undefined.axes);
  EXPECT_TRUE(std::isnan((*undefined.axes)[0][0]));
  EXPECT_TRUE(loaded(systems(identity) + node(7, 9, 1, 1.0, 2.0, 3.0) + simple_record().str()).header.nodes.empty());
  EXPECT_TRUE(node_of(systems(system(1, 0)) + node(7, 1, 1, 1.0, 2.0, 3.0)).axes);  // label 1, but not the global one
}

TEST(UffCoordinateSystems, SpoiltDatasetsAreToldWithTheirPlace) {
  const auto error = [](const std::string& of) { return error_of([&] { loaded(systems(of) + simple_record().str()); }); };
  EXPECT_THAT(error(integers({5, 0, 0}) + "name\n" + three(1.0, 0.0, 0.0)),
              HasSubstr("are not two of the part and six of each system"));
  EXPECT_THAT(error(integers({5, 3, 0}) + system(5, 0).substr(31)), HasSubstr("is not a label and a kind"));
  std::string skew = system(5, 0);
  skew.replace(skew.find("-8.0"), 4, "-9.0");
  EXPECT_THAT(error(skew), HasSubstr("the axes of coordinate system 5 are not three unit vectors at right angles"));
  std::string words = system(5, 0);
  words.replace(words.find("-8.0"), 4, "-oh ");
  EXPECT_THAT(error(words), HasSubstr("is not three numbers of 25 columns"));
}

}  // namespace
}  // namespace jointid::frf
