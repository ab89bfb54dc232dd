#include "frf/set/corrections.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "file_fixture.hpp"
#include "frf/file/write.hpp"
#include "frf/set/h1.hpp"
#include "frf/set/recorded_variance.hpp"

namespace jointid::frf {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double rounding = 1e-13;

/// Every kind of set of three sizes.
template <class Check>
void for_each_set(Check check) {
  std::mt19937 random(14);
  for (int trial = 0; trial < 3; ++trial) {
    for (const Quantity quantity : all_quantities) {
      for (const NoiseRecord noise : all_noise_records) {
        FrfSet set = random_set(random, quantity, noise);
        for (Complex& variance : set.variance) variance.imag(variance.real());  // a delay mixes the two parts
        SCOPED_TRACE(name(quantity) + ", noise " + std::to_string(static_cast<int>(noise)) + ", trial " + std::to_string(trial));
        check(set);
      }
    }
  }
}

/// plant(values of an FRF, frequency, r, c) with the factor that the variances take.
template <class Plant>
FrfSet planted(FrfSet set, Plant plant) {
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    for (std::size_t r = 0; r < set.header.response.size(); ++r) {
      for (std::size_t c = 0; c < set.header.reference.size(); ++c) {
        const std::size_t at = set.index(line, r, c);
        set.values[at] = plant(set.values[at], set.header.frequency_hz[line], r, c);
      }
    }
  }
  return set;
}

void scale_variance(FrfSet& set, std::size_t response, double squared) {
  for (std::size_t line = 0; !set.variance.empty() && line < set.header.lines(); ++line) {
    for (std::size_t c = 0; c < set.header.reference.size(); ++c) set.variance[set.index(line, response, c)] *= squared;
  }
}

FrfSet mended(const FrfSet& set, const Corrections& corrections) { return load(*corrected(from_memory(set), corrections)); }

TEST(Corrections, AFlippedSensorIsARowAndAFlippedHammerIsAColumn) {
  for_each_set([](const FrfSet& set) {
    const FrfSet row = planted(set, [](Complex h, double, std::size_t r, std::size_t) { return r == 0 ? -h : h; });
    expect_same(mended(row, {.flip = {set.header.response[0]}}), set, 0.0);
    const FrfSet column = planted(set, [](Complex h, double, std::size_t, std::size_t c) { return c == 0 ? -h : h; });
    Dof other_way = set.header.reference[0];
    other_way.sign = -other_way.sign;
    expect_same(mended(column, {.flip_reference = {other_way}}), set, 0.0);
  });
}

TEST(Corrections, SwappedLabelsAreSwappedBack) {
  std::size_t swapped = 0;
  for_each_set([&](const FrfSet& set) {
    if (set.header.response.size() < 2) return;
    ++swapped;
    FrfSet wrong = set;
    std::swap(wrong.header.response[0], wrong.header.response[1]);
    const Dof first = wrong.header.response[0], second = wrong.header.response[1];
    const Corrections corrections{.rename = {{first, second}, {second, first}}};
    const FrfSet found = mended(wrong, corrections);
    expect_same(found, set, 0.0);
  });
  EXPECT_GT(swapped, 0u);
}

TEST(Corrections, TheSignOfANewNameIsThatOfTheTransducer) {
  FrfSet set{.header = {}, .values = {1.0, 2.0}, .variance = {}, .coherence = {}};
  set.header.frequency_hz = {1.0};
  set.header.response = dofs({"1:-Y", "2:+Y"});
  set.header.reference = dofs({"1:+Y"});
  const auto renamed_to = [&](const char* from, const char* to) {
    return mended(set, {.rename = {{Dof::parse(from), Dof::parse(to)}}}).header.response[0].name();
  };
  EXPECT_EQ(renamed_to("1:-Y", "3:-X"), "3:-X");
  EXPECT_EQ(renamed_to("1:-Y", "3:+X"), "3:+X");
  EXPECT_EQ(renamed_to("1:+Y", "3:+X"), "3:-X");
}

TEST(Corrections, GainsAreUndoneWithTheirVariances) {
  for_each_set([](const FrfSet& set) {
    FrfSet row = planted(set, [](Complex h, double, std::size_t r, std::size_t) { return r == 0 ? h / 1.02 : h; });
    scale_variance(row, 0, 1.0 / (1.02 * 1.02));
    expect_same(mended(row, {.response_gain = {{set.header.response[0], 1.02}}}), set, rounding);
    FrfSet all = planted(set, [](Complex h, double, std::size_t, std::size_t) { return h / 9.80665; });
    for (std::size_t r = 0; r < set.header.response.size(); ++r) scale_variance(all, r, 1.0 / (9.80665 * 9.80665));
    expect_same(mended(all, {.gain = 9.80665}), set, rounding);
    const FrfSet column = mended(set, {.reference_gain = {{set.header.reference[0], 2.0}}});
    expect_same(mended(column, {.reference_gain = {{set.header.reference[0], 0.5}}}), set, rounding);
  });
}

TEST(Corrections, ADelayIsUndone) {
  constexpr double delay = 20e-6;
  for_each_set([](const FrfSet& set) {
    const FrfSet late = planted(set, [](Complex h, double f, std::size_t, std::size_t) {
      return h * std::polar(1.0, -2.0 * std::numbers::pi * f * delay);
    });
    expect_same(mended(late, {.delay = delay}), set, rounding);
  });
}

TEST(Corrections, VariancesOfThePartsTurnWithADelay) {
  FrfSet set{.header = {}, .values = {1.0}, .variance = {{4.0, 1.0}}, .coherence = {}};
  set.header.frequency_hz = {250.0};
  set.header.response = set.header.reference = dofs({"1:+Y"});
  set.header.noise = NoiseRecord::variance;
  const FrfSet quarter = mended(set, {.delay = 1e-3});
  EXPECT_NEAR(quarter.variance[0].real(), 1.0, rounding);
  EXPECT_NEAR(quarter.variance[0].imag(), 4.0, rounding);
  const FrfSet eighth = mended(set, {.delay = 0.5e-3});
  EXPECT_NEAR(eighth.variance[0].real(), 2.5, rounding);
  EXPECT_NEAR(eighth.variance[0].imag(), 2.5, rounding);
}

/// The file's own quantity is conjugated: a mobility iωH becomes −iωH*.
TEST(Corrections, ConjugatesOfAnyQuantityAreUndone) {
  for_each_set([](const FrfSet& set) {
    const Quantity quantity = set.header.quantity;
    const FrfSet wrong = planted(set, [&](Complex h, double f, std::size_t, std::size_t) {
      return std::conj(h * from_receptance(quantity, f)) * to_receptance(quantity, f);
    });
    expect_same(mended(wrong, {.conjugate = true}), set, rounding);
  });
}

/// The clock ran wrong: the stored values are right, the axis is not.
TEST(Corrections, AStretchedAxisIsUndone) {
  for_each_set([](const FrfSet& set) {
    const Quantity quantity = set.header.quantity;
    const double scale = 0.99, power = std::pow(scale, 2.0 * static_cast<int>(quantity));
    FrfSet wrong = planted(set, [&](Complex h, double f, std::size_t, std::size_t) {
      return h * from_receptance(quantity, f) * to_receptance(quantity, f / scale);
    });
    for (Complex& variance : wrong.variance) variance *= power;
    for (double& frequency : wrong.header.frequency_hz) frequency /= scale;
    FrfSet found = mended(wrong, {.frequency_scale = scale});
    for (std::size_t line = 0; line < set.header.lines(); ++line) {
      EXPECT_NEAR(found.header.frequency_hz[line], set.header.frequency_hz[line], 1e-12);
    }
    found.header.frequency_hz = set.header.frequency_hz;
    expect_same(found, set, rounding);
  });
}

class CorrectedFile : public FileTest {};

/// A file that calls its numbers by the wrong quantity, in each format.
TEST_F(CorrectedFile, AQuantityIsTakenEvenWhereTheFileSaysAnother) {
  std::mt19937 random(15);
  for (const std::string format : {"h5", "csv", "uff"}) {
    for (const Quantity stated : all_quantities) {
      for (const Quantity true_quantity : all_quantities) {
        FrfSet set = random_set(random, true_quantity, NoiseRecord::none);
        for (Dof& dof : set.header.response) dof = {dof.node, Direction::y, 1};  // UFF takes signs from its first record
        for (Dof& dof : set.header.reference) dof = {dof.node, Direction::y, 1};
        for (Complex& value : set.values) value = std::isnan(value.real()) ? Complex(1e-6, 1e-6) : value;
        FrfSet wrong = planted(set, [&](Complex h, double f, std::size_t, std::size_t) {
          return h * from_receptance(true_quantity, f) * to_receptance(stated, f);
        });
        wrong.header.quantity = stated;
        write(wrong, path("a." + format), format);
        OpenOptions options;
        options.quantity = true_quantity;
        const auto source = open(path("a." + format), options);
        expect_same(load(*source), set, 1e-12);
        EXPECT_EQ(source->header().changes.size(), stated == true_quantity ? 0u : 1u);
      }
    }
  }
}

using Square = std::vector<std::vector<Complex>>;

/// By Gauss and Jordan, for small well-conditioned matrices.
Square inverse(Square a) {
  const std::size_t n = a.size();
  Square b(n, std::vector<Complex>(n));
  for (std::size_t i = 0; i < n; ++i) b[i][i] = 1.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Complex pivot = a[i][i];
    for (std::size_t k = 0; k < n; ++k) a[i][k] /= pivot, b[i][k] /= pivot;
    for (std::size_t r = 0; r < n; ++r) {
      const Complex factor = r == i ? 0.0 : a[r][i];
      for (std::size_t k = 0; k < n; ++k) a[r][k] -= factor * a[i][k], b[r][k] -= factor * b[i][k];
    }
  }
  return b;
}

constexpr SensorsOn all_sensors[] = {SensorsOn::roving, SensorsOn::triaxial, SensorsOn::fixed};

/// A damped structure of five coordinates, at node 3 two of them, whose first reference points the other way.
struct Loaded {
  FrfSet clean;
  std::vector<DofNumber> masses = {{Dof::parse("1:+Y"), 0.02}, {Dof::parse("3:+Y"), 0.03}, {Dof::parse("3:+Z"), 0.03}};

  explicit Loaded(NoiseRecord noise) {
    FrfHeader& header = clean.header;
    header.frequency_hz = {20.0, 45.0, 90.0};
    header.response = dofs({"1:+Y", "2:+Y", "3:+Y", "3:+Z", "4:+Y"});
    header.reference = dofs({"3:+Z", "1:-Y", "2:+Y", "4:+Y", "3:+Y"});
    header.noise = noise;
    header.averages = noise == NoiseRecord::coherence ? 8.0 : 0.0;
    clean.values = frfs([](std::size_t) { return std::vector<double>(5, 0.0); });
    std::mt19937 random(16);
    std::uniform_real_distribution<double> part(0.5, 2.0);
    for (const Complex h : clean.values) {
      if (noise == NoiseRecord::variance)
        clean.variance.push_back({1e-4 * part(random) * std::norm(h), 1e-4 * part(random) * std::norm(h)});
      if (noise == NoiseRecord::coherence) clean.coherence.push_back(1.0 - 0.01 * part(random));
    }
  }

  /// FRFs when the coordinates carry loads(r) kg while response r is measured.
  template <class Loads>
  std::vector<Complex> frfs(Loads loads) const {
    std::vector<Complex> values;
    for (const double f : clean.header.frequency_hz) {
      const double omega = 2.0 * std::numbers::pi * f;
      for (std::size_t r = 0; r < 5; ++r) {
        const std::vector<double> mass = loads(r);
        Square z(5, std::vector<Complex>(5));
        for (std::size_t i = 0; i < 5; ++i) {
          z[i][i] = Complex(4e4 + 1e4 * static_cast<double>(i), 3e3) - omega * omega * (0.4 + mass[i]);
          if (i > 0) z[i][i - 1] = z[i - 1][i] = Complex(-1.5e4, -1e3);
        }
        const Square h = inverse(z);
        for (const Dof& reference : clean.header.reference) {
          const std::size_t c = find_coordinate(clean.header.response, reference);
          values.push_back(static_cast<double>(reference.sign) * h[r][c]);
        }
      }
    }
    return values;
  }

  FrfSet with(std::vector<Complex> values) const {
    FrfSet set = clean;
    set.values = std::move(values);
    return set;
  }
  FrfSet fixed() const {
    return with(frfs([](std::size_t) { return std::vector<double>{0.02, 0.0, 0.03, 0.03, 0.0}; }));
  }
  FrfSet triaxial() const {
    return with(frfs([](std::size_t r) {
      std::vector<double> mass(5, 0.0);
      if (r == 0) mass[0] = 0.02;
      if (r == 2 || r == 3) mass[2] = mass[3] = 0.03;
      return mass;
    }));
  }
  FrfSet roving() const {
    return with(frfs([](std::size_t r) {
      std::vector<double> mass(5, 0.0);
      if (r < 4 && r != 1) mass[r] = r == 0 ? 0.02 : 0.03;
      return mass;
    }));
  }
  FrfSet of(SensorsOn sensors) const {
    if (sensors == SensorsOn::fixed) return fixed();
    return sensors == SensorsOn::roving ? roving() : triaxial();
  }
  Corrections corrections(SensorsOn sensors) const { return {.sensor_mass = masses, .sensors = sensors}; }
};

TEST(Corrections, MassesOfSensorsAreRemoved) {
  const Loaded test(NoiseRecord::none);
  for (const SensorsOn sensors : all_sensors) expect_same(mended(test.of(sensors), test.corrections(sensors)), test.clean, 1e-11);
  EXPECT_GT(std::abs(mended(test.fixed(), test.corrections(SensorsOn::roving)).values[7] / test.clean.values[7] - 1.0), 1e-3);
}

/// Blocks with any rows and columns are those of the whole.
TEST(Corrections, AnyBlockIsFreeOfTheMasses) {
  const Loaded test(NoiseRecord::variance);
  for (const SensorsOn sensors : all_sensors) {
    const auto source = corrected(from_memory(test.of(sensors)), test.corrections(sensors));
    const FrfSet whole = load(*source);
    const std::vector<std::size_t> lines = {0, 2}, responses = {4, 3, 0}, references = {2, 0};
    const FrfSet part = load(*source, {lines, responses, references});
    for (std::size_t i = 0; i < part.values.size(); ++i) {
      const std::size_t at = whole.index(lines[i / 6], responses[i / 2 % 3], references[i % 2]);
      EXPECT_TRUE(near(part.values[i], whole.values[at], 1e-13));
      EXPECT_TRUE(near(part.variance[i], whole.variance[at], 1e-12));
    }
  }
}

/// Against the derivatives of the corrected FRFs by every real and imaginary part that was measured.
TEST(Corrections, VariancesFollowTheRemovalOfMassesToFirstOrder) {
  const Loaded test(NoiseRecord::variance);
  for (const SensorsOn sensors : all_sensors) {
    const FrfSet measured = test.of(sensors);
    const FrfSet found = mended(measured, test.corrections(sensors));
    std::vector<Complex> expected(found.values.size());
    for (std::size_t i = 0; i < measured.values.size(); ++i) {
      const double step = 1e-6 * std::abs(measured.values[i]);
      for (const Complex direction : {Complex(1.0, 0.0), Complex(0.0, 1.0)}) {
        FrfSet up = measured, down = measured;
        up.values[i] += step * direction;
        down.values[i] -= step * direction;
        const FrfSet high = mended(up, test.corrections(sensors)), low = mended(down, test.corrections(sensors));
        const double variance = direction.real() > 0.0 ? measured.variance[i].real() : measured.variance[i].imag();
        for (std::size_t k = 0; k < expected.size(); ++k) {
          const Complex slope = (high.values[k] - low.values[k]) / (2.0 * step);
          expected[k] += variance * Complex(slope.real() * slope.real(), slope.imag() * slope.imag());
        }
      }
    }
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_NEAR(found.variance[k].real(), expected[k].real(), 1e-6 * expected[k].real()) << k;
      EXPECT_NEAR(found.variance[k].imag(), expected[k].imag(), 1e-6 * expected[k].imag()) << k;
    }
  }
}

/// A coherence after the removal tells the same variance as the variances that it stands for.
TEST(Corrections, CoherencesTellTheVarianceThatIsLeft) {
  const Loaded test(NoiseRecord::coherence);
  for (const SensorsOn sensors : all_sensors) {
    const FrfSet measured = test.of(sensors);
    FrfSet as_variances = measured;
    as_variances.header.noise = NoiseRecord::variance;
    as_variances.coherence.clear();
    for (std::size_t i = 0; i < measured.values.size(); ++i) as_variances.variance.push_back(recorded_variance(measured, i));
    const FrfSet found = mended(measured, test.corrections(sensors)), expected = mended(as_variances, test.corrections(sensors));
    for (std::size_t i = 0; i < found.values.size(); ++i) {
      EXPECT_TRUE(near(recorded_variance(found, i), expected.variance[i], 1e-10)) << i;
    }
  }
}

TEST(Corrections, AMassWithoutItsDrivingPointSaysWhatIsMissing) {
  FrfSet set{.header = {}, .values = {1.0, 2.0}, .variance = {}, .coherence = {}};
  set.header.frequency_hz = {1.0};
  set.header.file = "part.h5";
  set.header.response = dofs({"1:+Y", "2:+Y"});
  set.header.reference = dofs({"1:+Y"});
  const auto error = [&](const Corrections& corrections) {
    return message_of([&] { corrected(from_memory(set), corrections); }, ErrorKind::usage);
  };
  EXPECT_THAT(error({.sensor_mass = {{Dof::parse("2:+Y"), 0.003}}}),
              HasSubstr("part.h5: sensor_mass: the mass at 2:+Y cannot be removed: the file has no driving-point FRF there, 2:+Y is no "
                        "reference; excite 2:+Y, too, or leave its mass out"));
  EXPECT_THAT(error({.flip = {Dof::parse("12:+Y")}}), HasSubstr("flip: the file has no response 12:+Y; did you mean 1:+Y?"));
  EXPECT_THAT(error({.flip_reference = {Dof::parse("2:+Y")}}), HasSubstr("flip_reference: the file has no reference 2:+Y"));
  EXPECT_THAT(message_of([&] { corrected(from_memory(set), {.rename = {{Dof::parse("2:+Y"), Dof::parse("1:+Y")}}}); }),
              HasSubstr("DOF 1:+Y appears twice"));
}

TEST(Corrections, NothingIsConstructedWithoutAndOnlyWhatIsAskedForIsRead) {
  const Loaded test(NoiseRecord::none);
  auto plain = from_memory(test.roving());
  const FrfSource* const before = plain.get();
  auto same = corrected(std::move(plain), {});
  EXPECT_EQ(same.get(), before);
  EXPECT_TRUE(same->header().changes.empty());
  const auto source = corrected(std::move(same), {.flip = {Dof::parse("1:+Y")}});
  const std::vector<std::size_t> lines = {1}, responses = {0}, references = {1, 2};
  load(*source, {lines, responses, references});
  EXPECT_EQ(before->count().entries, 2u);
  EXPECT_THAT(source->header().changes, ElementsAre("flip 1:+Y"));
}

TEST(Corrections, AfterARenameTheOtherKeysUseTheNewNames) {
  FrfSet set{.header = {}, .values = {1.0, 2.0}, .variance = {}, .coherence = {}};
  set.header.frequency_hz = {1.0};
  set.header.response = dofs({"1:+Y", "2:+Y"});
  set.header.reference = dofs({"9:+Y"});
  const Dof one = Dof::parse("1:+Y"), two = Dof::parse("2:+Y");
  const FrfSet found = mended(set, {.rename = {{one, two}, {two, one}}, .response_gain = {{one, 10.0}}, .flip = {one}});
  EXPECT_THAT(found.values, ElementsAre(Complex(1.0), Complex(-20.0)));
  EXPECT_EQ(found.header.response, dofs({"2:+Y", "1:+Y"}));
  EXPECT_THAT(found.header.changes, ElementsAre("rename 1:+Y to 2:+Y 2:+Y to 1:+Y", "gain 1:+Y 10", "flip 1:+Y"));
}

}  // namespace
}  // namespace jointid::frf
