#include "virtualpoint/transformation.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "interface.hpp"

namespace jointid::virtualpoint {
namespace {

using testing::HasSubstr;

template <class Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Transformation, RowsAreThoseOfARigidBody) {
  const Interface in(1);
  const Transformation sensors = transformation(in.point, Side::sensors, in.set.header);
  const Transformation impacts = transformation(in.point, Side::impacts, in.set.header);
  EXPECT_LT((sensors.modes - in.sensor_rows()).norm(), 1e-14);
  EXPECT_LT((impacts.modes - in.impact_rows()).norm(), 1e-14);
}

TEST(Transformation, WeightedInverseSolvesTheNormalEquations) {
  Interface in(2);
  for (Channel& sensor : in.point.sensors) sensor.weight = 1.5 + in.number();
  const Transformation of = transformation(in.point, Side::sensors, in.set.header);
  Eigen::VectorXd weights(at(in.point.sensors.size()));
  for (std::size_t i = 0; i < in.point.sensors.size(); ++i) weights[at(i)] = in.point.sensors[i].weight;
  const Eigen::MatrixXd rtw = of.modes.transpose() * weights.asDiagonal();
  EXPECT_LT((rtw * of.modes * of.to_virtual - rtw).norm(), 1e-12 * rtw.norm());
  EXPECT_LT((of.to_virtual * of.modes - Eigen::MatrixXd::Identity(6, 6)).norm(), 1e-12);
}

TEST(Transformation, AnotherOriginTransportsTheMotionRigidly) {
  const Interface in(3);
  VirtualPoint moved = in.point;
  const Eigen::Vector3d step(0.05, -0.2, 0.4);
  for (std::size_t k = 0; k < 3; ++k) moved.position[k] += step[at(k)];
  const Transformation here = transformation(in.point, Side::sensors, in.set.header);
  const Transformation there = transformation(moved, Side::sensors, in.set.header);
  // x' = x + θ × step, θ' = θ
  Eigen::MatrixXd transport = Eigen::MatrixXd::Identity(6, 6);
  for (int k = 0; k < 3; ++k) transport.block<3, 1>(0, 3 + k) = Eigen::Vector3d::Unit(k).cross(step);
  EXPECT_LT((there.to_virtual - transport * here.to_virtual).norm(), 1e-11 * there.to_virtual.norm());
  EXPECT_LT((there.filter() - here.filter()).norm(), 1e-11);
}

TEST(Transformation, FlexibleModesAreRecovered) {
  Interface in(4, 6);
  in.point.modes.insert(in.point.modes.end(), {InterfaceMode::ex, InterfaceMode::tz, InterfaceMode::sxy});
  const Transformation of = transformation(in.point, Side::sensors, in.set.header);
  const Eigen::VectorXd q = Eigen::VectorXd::LinSpaced(9, -1.0, 2.0);
  Eigen::VectorXd u(of.modes.rows());
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    const frf::Dof& dof = in.set.header.response[static_cast<std::size_t>(i)];
    const Eigen::Vector3d r = in.lever(dof);
    const Eigen::Vector3d x = q.head<3>() + q.segment<3>(3).cross(r) + q[6] * Eigen::Vector3d(r[0], 0.0, 0.0) +
                              q[7] * Eigen::Vector3d(-r[1] * r[2], r[0] * r[2], 0.0) +
                              q[8] * Eigen::Vector3d(r[0] * r[1], 0.0, 0.0);
    u[i] = x[static_cast<int>(dof.direction) - 1];
  }
  EXPECT_LT((of.to_virtual * u - q).norm(), 1e-11);
  EXPECT_THAT(frf::names(dofs(in.point)), testing::ElementsAre("VP1:+X", "VP1:+Y", "VP1:+Z", "VP1:+RX", "VP1:+RY", "VP1:+RZ",
                                                               "VP1E:+X", "VP1E:+RZ", "VP1S:+X"));
}

TEST(Transformation, RotationalSensorsTellTheRotation) {
  Interface in(5, 1);
  for (const auto direction : {frf::Direction::rx, frf::Direction::ry, frf::Direction::rz}) {
    const frf::Dof dof{.node = 1, .direction = direction};
    in.point.sensors.push_back({.dof = dof});
    in.set.header.response.push_back(dof);
  }
  const Transformation of = transformation(in.point, Side::sensors, in.set.header);
  EXPECT_LT((of.modes.bottomRightCorner<3, 3>() - Eigen::Matrix3d::Identity()).norm(), 1e-15);
  EXPECT_EQ(of.modes.bottomLeftCorner(3, 3).norm(), 0.0);
}

TEST(Transformation, NamesTheMotionThatIsNotSeen) {
  Interface in(6, 2);
  const std::string error = error_of([&] { transformation(in.point, Side::sensors, in.set.header); });
  EXPECT_THAT(error, HasSubstr("VP1: its 6 sensors in the file determine 5 of its 6 motions"));
  // Three sensors along z on a line along x.
  for (std::int64_t node = 1; node <= 4; ++node) {
    in.set.header.nodes[static_cast<std::size_t>(node - 1)].position = {0.1 * static_cast<double>(node), -0.2, 0.1};
  }
  EXPECT_THAT(error_of([&] { transformation(in.point, Side::sensors, in.set.header); }),
              HasSubstr("VP1:+RX cannot be separated"));
}

TEST(Transformation, AsksForAPosition) {
  Interface in(7);
  in.set.header.nodes.erase(in.set.header.nodes.begin());
  const std::string error = error_of([&] { transformation(in.point, Side::sensors, in.set.header); });
  EXPECT_THAT(error, HasSubstr("has no position"));
  EXPECT_THAT(error, HasSubstr("[nodes] \"1\" = [x, y, z]"));
  in.point.positions[1] = {0.3, -0.1, 0.1};
  EXPECT_NO_THROW(transformation(in.point, Side::sensors, in.set.header));
}

TEST(Transformation, OfAFileWithoutItsChannelsIsEmpty) {
  Interface in(8);
  for (Channel& sensor : in.point.sensors) sensor.dof.node += 100;
  EXPECT_FALSE(transformation(in.point, Side::sensors, in.set.header).any());
}

}  // namespace
}  // namespace jointid::virtualpoint
