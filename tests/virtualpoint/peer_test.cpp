#include <fstream>
#include <iomanip>

#include "interface.hpp"
#include "tests/require.hpp"
#include "tests/test_folder.hpp"
#include "virtualpoint/consistency.hpp"
#include "virtualpoint/virtual_source.hpp"

namespace jointid::virtualpoint {
namespace {

void write_channels(std::ostream& out, const Transformation& of, const std::vector<Channel>& channels) {
  for (std::size_t i = 0; i < channels.size(); ++i) {
    out << of.positions.row(at(i)) << ' ' << of.directions.row(at(i)) * of.signs[at(i)] << ' ' << channels[i].weight << '\n';
  }
}

/// All numbers of bench/peer/virtual_points.py, in numpy, against those of the library.
TEST(Peer, NumpyGivesTheSameNumbers) {
  if (std::system("/usr/bin/python3 -c 'import numpy' 2>/dev/null") != 0) JOINTID_SKIP("numpy is missing (python3-numpy)");
  const TestFolder folder;
  for (const bool flexible : {false, true}) {
    Interface in(11, 6, 18);
    if (flexible) in.point.modes.insert(in.point.modes.end(), {InterfaceMode::ey, InterfaceMode::tx, InterfaceMode::szy});
    for (Channel& sensor : in.point.sensors) sensor.weight = flexible ? 1.5 + in.number() : 1.0;
    for (Channel& impact : in.point.impacts) impact.weight = flexible ? 1.5 + in.number() : 1.0;
    for (Complex& value : in.set.values) value += 0.3 * Complex(in.number(), in.number());
    const Transformation sensors = transformation(in.point, Side::sensors, in.set.header);
    const Transformation impacts = transformation(in.point, Side::impacts, in.set.header);
    {
      std::ofstream file(folder / "interface.txt");
      file << std::setprecision(17) << in.point.sensors.size() << ' ' << in.point.impacts.size() << ' ' << Interface::lines
           << '\n';
      for (const InterfaceMode mode : in.point.modes) file << mode_names()[static_cast<std::size_t>(mode)] << ' ';
      file << '\n';
      write_channels(file, sensors, in.point.sensors);
      write_channels(file, impacts, in.point.impacts);
      for (const Complex& value : in.set.values) file << value.real() << ' ' << value.imag() << '\n';
    }
    const std::string command = std::string("/usr/bin/python3 ") + JOINTID_PEER_DIR + "/virtual_points.py " +
                                (folder / "interface.txt").string() + " > " + (folder / "out.txt").string();
    ASSERT_EQ(std::system(command.c_str()), 0);
    std::ifstream answer(folder / "out.txt");
    const auto expect = [&](double value, double scale) {
      double peer = 0.0;
      ASSERT_TRUE(answer >> peer);
      EXPECT_NEAR(value, peer, 1e-12 * scale);
    };
    const Eigen::MatrixXd tf = impacts.to_virtual.transpose();
    for (Eigen::Index r = 0; r < sensors.to_virtual.rows(); ++r) {
      for (const double value : sensors.to_virtual.row(r)) expect(value, sensors.to_virtual.norm());
    }
    for (Eigen::Index r = 0; r < tf.rows(); ++r) {
      for (const double value : tf.row(r)) expect(value, tf.norm());
    }
    const frf::FrfSet q = load(*virtual_source(frf::from_memory(in.set), {in.point}));
    double largest = 0.0;
    for (const Complex& value : q.values) largest = std::max(largest, std::abs(value));
    for (const Complex& value : q.values) {
      expect(value.real(), largest);
      expect(value.imag(), largest);
    }
    const std::vector<std::size_t> lines = {0, 1, 2, 3, 4};
    const Consistency of = consistency(*frf::from_memory(in.set), in.point, lines);
    for (const SideConsistency* side : {&of.sensors, &of.impacts}) {
      for (const double value : side->specific) expect(value, 1.0);
      for (const double value : side->overall) expect(value, 1.0);
    }
    std::string rest;
    EXPECT_FALSE(answer >> rest);
  }
}

}  // namespace
}  // namespace jointid::virtualpoint
