#include "virtualpoint/virtual_source.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "base/error.hpp"
#include "frf/noise/noise.hpp"
#include "frf/set/h1.hpp"
#include "interface.hpp"
#include "virtualpoint/transformation.hpp"

namespace jointid::virtualpoint {
namespace {

using testing::HasSubstr;

/// FRFs of the sensors and of another response, to the impacts and another reference.
Interface with_others(unsigned seed) {
  Interface in(seed);
  const frf::Dof other{.node = 50, .direction = frf::Direction::y};
  in.set.header.response.insert(in.set.header.response.begin() + 2, other);
  in.set.header.reference.push_back(other);
  in.set.values.assign(in.set.header.lines() * in.set.header.entries(), 0.0);
  for (Complex& value : in.set.values) value = {in.number(), in.number()};
  return in;
}

Eigen::MatrixXd whole_matrix(const Transformation& of, std::size_t measured, std::size_t other) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(7, at(measured));
  out(0, at(other)) = 1.0;
  for (std::size_t i = 0; i < of.channels.size(); ++i) out.col(at(of.channels[i])).tail(6) = of.to_virtual.col(at(i));
  return out;
}

TEST(VirtualSource, GivesTheMotionOfARigidInterface) {
  const Interface in(1);
  frf::FrfSet out = load(*virtual_source(frf::from_memory(in.set), {in.point}));
  EXPECT_THAT(frf::names(out.header.response),
              testing::ElementsAre("VP1:+X", "VP1:+Y", "VP1:+Z", "VP1:+RX", "VP1:+RY", "VP1:+RZ"));
  EXPECT_EQ(out.header.reference, out.header.response);
  for (std::size_t line = 0; line < Interface::lines; ++line) {
    const Eigen::Map<const RowMatrixXc> h(out.values.data() + 36 * line, 6, 6);
    EXPECT_LT((h - in.motion[line]).norm(), 1e-10 * in.motion[line].norm());
  }
}

TEST(VirtualSource, KeepsOtherFrfsAndReadsWhatItIsAskedFor) {
  const Interface in = with_others(2);
  const Eigen::MatrixXd left = whole_matrix(transformation(in.point, Side::sensors, in.set.header), 13, 2);
  const Eigen::MatrixXd right = whole_matrix(transformation(in.point, Side::impacts, in.set.header), 10, 9);
  const auto source = virtual_source(frf::from_memory(in.set), {in.point});
  EXPECT_EQ(source->header().response.front().name(), "50:+Y");
  EXPECT_THAT(source->header().changes, testing::ElementsAre("VP1 from 12 sensors and 9 impacts"));
  const std::vector<std::size_t> lines = {1, 3}, responses = {5, 0}, references = {0, 6, 2};
  std::vector<Complex> values(12);
  source->read({lines, responses, references}, values);
  for (std::size_t l = 0; l < 2; ++l) {
    const Eigen::MatrixXcd h = left.cast<Complex>() * in.line(lines[l]) * right.transpose().cast<Complex>();
    for (std::size_t r = 0; r < 2; ++r) {
      for (std::size_t c = 0; c < 3; ++c) {
        const Complex wanted = h(at(responses[r]), at(references[c]));
        EXPECT_LT(std::abs(values[(l * 2 + r) * 3 + c] - wanted), 1e-11 * h.norm());
      }
    }
  }
}

TEST(VirtualSource, AFlippedFileIsTheSame) {
  Interface in(3);
  frf::FrfSet flipped = in.set;
  flipped.header.response[4].sign = -1;
  for (std::size_t line = 0; line < Interface::lines; ++line) {
    for (std::size_t c = 0; c < 9; ++c) flipped.values[flipped.index(line, 4, c)] *= -1.0;
  }
  const frf::FrfSet one = load(*virtual_source(frf::from_memory(in.set), {in.point}));
  const frf::FrfSet two = load(*virtual_source(frf::from_memory(flipped), {in.point}));
  for (std::size_t i = 0; i < one.values.size(); ++i) EXPECT_LT(std::abs(one.values[i] - two.values[i]), 1e-11);
}

/// Sensors along axes that the file has for their nodes are those that the scene says the directions of.
TEST(VirtualSource, DirectionsAreThoseOfTheFilesAxes) {
  const Interface in(5);
  frf::FrfSet turned = in.set;
  VirtualPoint told = in.point;
  const double c = 0.6, s = 0.8;
  const frf::Axes axes{{{c, s, 0.0}, {-s, c, 0.0}, {0.0, 0.0, 1.0}}};
  for (frf::Node& node : turned.header.nodes) node.axes = axes;
  for (Channel& sensor : told.sensors) {
    Vector d = axes[static_cast<std::size_t>(sensor.dof.direction) - 1];
    for (double& component : d) component *= sensor.dof.sign;
    sensor.direction = d;
  }
  const frf::FrfSet one = load(*virtual_source(frf::from_memory(turned), {in.point}));
  const frf::FrfSet two = load(*virtual_source(frf::from_memory(in.set), {told}));
  const frf::FrfSet plain = load(*virtual_source(frf::from_memory(in.set), {in.point}));
  EXPECT_EQ(one.values, two.values);
  EXPECT_NE(one.values, plain.values);
  turned.header.nodes[2].axes->fill({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0});
  try {
    (void)virtual_source(frf::from_memory(turned), {in.point});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("node 3 measures in a coordinate system that the file does not define"));
  }
}

/// Variances and covariances of the source against those of the Kronecker product of both sides.
TEST(VirtualSource, CarriesVariancesAndCovariances) {
  Interface in = with_others(4);
  const std::size_t rows = 13, columns = 10;
  in.set.header.noise = frf::NoiseRecord::variance;
  in.set.header.averages = 8.0;
  in.set.variance.resize(in.set.values.size());
  in.set.covariance.resize(in.set.header.lines() * frf::pair_count(rows) * columns);
  std::vector<Eigen::MatrixXcd> of;  // [line, reference]
  for (std::size_t line = 0; line < in.set.header.lines(); ++line) {
    for (std::size_t c = 0; c < columns; ++c) {
      const Eigen::MatrixXcd root = in.random_matrix(at(rows), 3);
      of.emplace_back(root * root.adjoint() + 0.1 * Eigen::MatrixXcd::Identity(at(rows), at(rows)));
      for (std::size_t r = 0; r < rows; ++r) {
        const double variance = of.back()(at(r), at(r)).real();
        in.set.variance[in.set.index(line, r, c)] = {0.5 * variance, 0.5 * variance};
        for (std::size_t s = 0; s <= r; ++s) {
          in.set.covariance[(line * frf::pair_count(rows) + frf::pair_index(r, s)) * columns + c] = of.back()(at(r), at(s));
        }
      }
    }
  }
  const Eigen::MatrixXcd left = whole_matrix(transformation(in.point, Side::sensors, in.set.header), rows, 2).cast<Complex>();
  const Eigen::MatrixXd right = whole_matrix(transformation(in.point, Side::impacts, in.set.header), columns, 9);
  frf::FrfSet out = load_with_covariance(*virtual_source(frf::from_memory(in.set), {in.point}));
  EXPECT_EQ(out.header.averages, 0.0);
  for (std::size_t line = 0; line < in.set.header.lines(); ++line) {
    for (std::size_t c = 0; c < 7; ++c) {
      Eigen::MatrixXcd wanted = Eigen::MatrixXcd::Zero(7, 7);
      for (std::size_t k = 0; k < columns; ++k) {
        wanted += std::pow(right(at(c), at(k)), 2) * left * of[line * columns + k] * left.adjoint();
      }
      for (std::size_t r = 0; r < 7; ++r) {
        const Complex variance = out.variance[out.index(line, r, c)];
        EXPECT_NEAR(variance.real() + variance.imag(), wanted(at(r), at(r)).real(), 1e-11 * wanted.norm());
        for (std::size_t s = 0; s <= r; ++s) {
          const Complex got = out.covariance[(line * frf::pair_count(7) + frf::pair_index(r, s)) * 7 + c];
          EXPECT_LT(std::abs(got - wanted(at(r), at(s))), 1e-11 * wanted.norm());
        }
      }
    }
  }
}

/// Errors of all impacts alike but for their size: those of two virtual references as the Kronecker product of both sides has
/// them.
TEST(VirtualSource, ReferencesShareTheErrorsOfTheirImpacts) {
  Interface in = with_others(8);
  const std::size_t rows = 13, columns = 10;
  in.set.header.noise = frf::NoiseRecord::variance;
  const Eigen::MatrixXcd root = in.random_matrix(at(rows), 20), common = root * root.adjoint();
  Eigen::VectorXd size(at(columns));
  for (std::size_t c = 0; c < columns; ++c) size[at(c)] = 1.0 + std::abs(in.number());
  in.set.covariance.resize(in.set.header.lines() * frf::pair_count(rows) * columns);
  for (std::size_t line = 0; line < in.set.header.lines(); ++line) {
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t c = 0; c < columns; ++c) {
        const double part = 0.5 * size[at(c)] * common(at(r), at(r)).real();
        in.set.variance.emplace_back(part, part);
        for (std::size_t s = 0; s <= r; ++s) {
          in.set.covariance[(line * frf::pair_count(rows) + frf::pair_index(r, s)) * columns + c] =
              size[at(c)] * common(at(r), at(s));
        }
      }
    }
  }
  const Eigen::MatrixXd right = whole_matrix(transformation(in.point, Side::impacts, in.set.header), columns, 9);
  const Eigen::MatrixXd between = right * size.asDiagonal() * right.transpose();
  ASSERT_GT(between.cwiseAbs()(1, 6) + between.cwiseAbs()(2, 4), 1e-3);
  const auto source = virtual_source(frf::from_memory(in.set), {in.point});
  ASSERT_TRUE(source->has_reference_correlation());
  const frf::FrfSet out = load_with_covariance(*source);
  validate(out);
  for (std::size_t line = 0; line < in.set.header.lines(); ++line) {
    for (std::size_t m = 0; m < 7; ++m) {
      for (std::size_t n = 0; n < 7; ++n) {
        const double wanted = between(at(m), at(n)) / std::sqrt(between(at(m), at(m)) * between(at(n), at(n)));
        EXPECT_LT(std::abs(out.reference_correlation[(line * 7 + m) * 7 + n] - wanted), 1e-12) << m << " " << n;
      }
    }
  }
}

/// The scatter of simulated errors is what the variances say, part by part.
TEST(VirtualSource, VariancesAreThoseOfSimulatedErrors) {
  const Interface in(5);
  frf::NoiseModel noise{.kind = frf::NoiseKind::circular, .level = 0.02, .record_variance = true, .reciprocal = false};
  const frf::FrfSet exact = load(*virtual_source(frf::from_memory(in.set), {in.point}));
  constexpr std::size_t trials = 200;
  std::vector<double> squares(exact.values.size(), 0.0), stated(exact.values.size(), 0.0);
  for (std::size_t trial = 0; trial < trials; ++trial) {
    const frf::FrfSet drawn = load(*virtual_source(frf::from_memory(frf::polluted(in.set, noise, 1, trial, 0)), {in.point}));
    for (std::size_t i = 0; i < squares.size(); ++i) {
      squares[i] += std::norm(drawn.values[i] - exact.values[i]);
      stated[i] += drawn.variance[i].real() + drawn.variance[i].imag();
    }
  }
  double mean = 0.0;
  for (std::size_t i = 0; i < squares.size(); ++i) mean += squares[i] / stated[i] / static_cast<double>(squares.size());
  EXPECT_NEAR(mean, 1.0, 0.03);  // 180 FRFs × 200 trials, which share errors
}

TEST(VirtualSource, TakesCoherencesAndTheLawOfNoise) {
  Interface in(6);
  in.set.header.noise = frf::NoiseRecord::coherence;
  in.set.header.averages = 5.0;
  in.set.coherence.assign(in.set.values.size(), 0.99);
  frf::FrfSet with_variance = in.set;
  with_variance.header.noise = frf::NoiseRecord::variance;
  with_variance.coherence.clear();
  for (const Complex& value : in.set.values) with_variance.variance.push_back(frf::h1_part_variances(value, 0.99, 5.0));
  const frf::FrfSet by_coherence = load(*virtual_source(frf::from_memory(in.set), {in.point}));
  const frf::FrfSet by_variance = load(*virtual_source(frf::from_memory(with_variance), {in.point}));
  frf::FrfSet without = in.set;
  without.header.noise = frf::NoiseRecord::none;
  without.coherence.clear();
  const double level = std::sqrt(frf::h1_variance(1.0, 0.99, 5.0));
  const frf::NoiseModel law{.kind = frf::NoiseKind::circular, .level = level};
  const frf::FrfSet by_law = load(*virtual_source(frf::from_memory(without), {in.point}, law));
  ASSERT_EQ(by_coherence.variance.size(), by_variance.variance.size());
  ASSERT_EQ(by_law.variance.size(), by_variance.variance.size());
  for (std::size_t i = 0; i < by_variance.variance.size(); ++i) {
    EXPECT_LT(std::abs(by_coherence.variance[i] - by_variance.variance[i]), 1e-12 * std::abs(by_variance.variance[i]));
    EXPECT_LT(std::abs(by_law.variance[i] - by_variance.variance[i]), 1e-12 * std::abs(by_variance.variance[i]));
  }
  EXPECT_FALSE(virtual_source(frf::from_memory(without), {in.point})->has_covariance());
}

TEST(VirtualSource, AnFrfThatIsMissingMakesNothingElseMissing) {
  Interface in = with_others(7);
  in.set.values[in.set.index(0, 0, 9)] =
      std::numeric_limits<double>::quiet_NaN();  // first sensor, to the reference beside the impacts
  const frf::FrfSet out = load(*virtual_source(frf::from_memory(in.set), {in.point}));
  EXPECT_TRUE(std::isnan(out.values[out.index(0, 1, 0)].real()));
  EXPECT_FALSE(std::isnan(out.values[out.index(0, 1, 1)].real()));
  EXPECT_FALSE(std::isnan(out.values[out.index(0, 0, 0)].real()));
}

TEST(VirtualSource, RefusesNamesThatAreThereAlready) {
  Interface in = with_others(8);
  in.set.header.response[2] = frf::Dof::parse("VP1:+RX");
  try {
    virtual_source(frf::from_memory(in.set), {in.point});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("VP1: VP1:+RX is there already; give the virtual point another name, VP2"));
  }
}

TEST(VirtualSource, IsTheFileItselfWithoutItsChannels) {
  Interface in(9);
  VirtualPoint other = in.point;
  other.sensors.clear();
  for (Channel& impact : other.impacts) impact.dof.node += 1000;
  auto file = frf::from_memory(in.set);
  const frf::FrfSource* address = file.get();
  EXPECT_EQ(virtual_source(std::move(file), {other}).get(), address);
}

}  // namespace
}  // namespace jointid::virtualpoint
