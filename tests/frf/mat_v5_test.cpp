#include <gmock/gmock.h>
#include <matio.h>

#include <functional>
#include <numbers>

#include "file_fixture.hpp"
#include "frf/file/columns.hpp"
#include "frf/mat/mat_file.hpp"
#include "tests/require.hpp"

namespace jointid::frf {
namespace {

using ::testing::HasSubstr;

/// Variables of a v5 file, made by matio itself.
class Maker {
 public:
  explicit Maker(const std::filesystem::path& path)
      : mat_(Mat_CreateVer(path.c_str(), nullptr, MAT_FT_MAT5)) {}
  ~Maker() { Mat_Close(mat_); }

  void reals(const char* name, std::vector<std::size_t> dims, std::vector<double> values) {
    add(Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, static_cast<int>(dims.size()), dims.data(),
                      values.data(), 0));
  }
  /// Complex 1, 2, 3, … in MATLAB's order, imaginary part the negative.
  void counting(const char* name, std::vector<std::size_t> dims) {
    std::vector<float> re;
    std::size_t size = 1;
    for (const std::size_t extent : dims) size *= extent;
    for (std::size_t i = 1; i <= size; ++i) re.push_back(static_cast<float>(i));
    std::vector<float> im(re);
    for (float& value : im) value = -value;
    mat_complex_split_t split{re.data(), im.data()};
    add(Mat_VarCreate(name, MAT_C_SINGLE, MAT_T_SINGLE, static_cast<int>(dims.size()), dims.data(), &split,
                      MAT_F_COMPLEX));
  }
  /// Characters [rows, columns], given column by column.
  void characters(const char* name, std::size_t rows, std::string columns) {
    std::size_t dims[] = {rows, columns.size() / rows};
    add(Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UTF8, 2, dims, columns.data(), 0));
  }

 private:
  void add(matvar_t* variable) {
    Mat_VarWrite(mat_, variable, MAT_COMPRESSION_ZLIB);
    Mat_VarFree(variable);
  }
  mat_t* mat_;
};

class MatV5File : public FileTest {
 protected:
  void make(const std::function<void(Maker&)>& fill) const {
    Maker maker(path("a.mat"));
    fill(maker);
  }
  FrfSet read(const OpenOptions& options = {}) const { return load(*open_mat_v5(path("a.mat"), options)); }
  std::string error(const std::function<void(Maker&)>& fill, const OpenOptions& options = {}) const {
    make(fill);
    return message_of([&] { read(options); });
  }
  static OpenOptions given(const std::vector<std::string>& response,
                           const std::vector<std::string>& reference) {
    OpenOptions options;
    options.quantity = Quantity::receptance;
    options.response = dofs(response);
    options.reference = dofs(reference);
    return options;
  }
};

TEST_F(MatV5File, RealVectorsAreColumns) {
  make([](Maker& maker) {
    maker.reals("u", {1, 3}, {1.0, 2.0, 3.0});
    maker.counting("frf", {3, 1});
    maker.reals("F", {3, 2}, {4.0, 5.0, 6.0, 7.0, 8.0, 9.0});
  });
  const Columns read = read_columns(path("a.mat"));
  ASSERT_EQ(read.columns.size(), 3u);
  EXPECT_THAT(read.column("u").values, testing::ElementsAre(1.0, 2.0, 3.0));
  EXPECT_THAT(read.column("F(1)").values, testing::ElementsAre(4.0, 5.0, 6.0));
  EXPECT_THAT(read.column("F(2)").values, testing::ElementsAre(7.0, 8.0, 9.0));
}

TEST_F(MatV5File, RoundTripsEveryQuantityAndNoiseRecord) {
  std::mt19937 random(21);
  for (int trial = 0; trial < 5; ++trial) {
    for (const Quantity quantity : all_quantities) {
      for (const NoiseRecord noise : all_noise_records) {
        const FrfSet set = random_set(random, quantity, noise, trial % 2 == 0);
        write_mat(set, path("a.mat"));
        expect_same(read(), set, quantity == Quantity::receptance ? 0.0 : 1e-15);
      }
    }
  }
  EXPECT_EQ(files_in_folder(), 1u);
}

TEST_F(MatV5File, AxesOfEveryOrderReadTheSame) {
  // Value 1 + r + 2 c + 6 line for lines last, 1 + line + 4 r + 8 c for lines first; 4 lines, 2 responses, 3
  // references.
  const OpenOptions options = given({"1:X", "2:X"}, {"1:X", "2:X", "3:X"});
  const auto value = [&](const std::vector<std::size_t>& dims) {
    make([&](Maker& m) {
      m.reals("Freq", {1, 4}, {1, 2, 3, 4});
      m.counting("H", dims);
    });
    const FrfSet set = read(options);
    return set.values[set.index(3, 1, 2)];
  };
  EXPECT_EQ(value({4, 2, 3}), Complex(1 + 3 + 4 + 16, -(1 + 3 + 4 + 16)));
  EXPECT_EQ(value({4, 6}), Complex(24, -24));
  EXPECT_EQ(value({2, 3, 4}), Complex(24, -24));
  EXPECT_EQ(value({6, 4}), Complex(24, -24));
  make([&](Maker& m) {
    m.reals("freq", {1, 4}, {1, 2, 3, 4});
    m.counting("H", {2, 3, 4});
  });
  const FrfSet set = read(options);
  EXPECT_EQ(set.values[set.index(1, 0, 1)], Complex(1 + 2 + 6, -9));
}

TEST_F(MatV5File, AVectorIsOneFrf) {
  for (const std::vector<std::size_t>& dims : {std::vector<std::size_t>{3, 1}, {1, 3}}) {
    make([&](Maker& m) {
      m.reals("omega", dims, {2 * std::numbers::pi, 4 * std::numbers::pi, 6 * std::numbers::pi});
      m.counting("H", dims);
    });
    const FrfSet set = read(given({"1:X"}, {}));
    EXPECT_DOUBLE_EQ(set.header.frequency_hz[2], 3.0);
    EXPECT_EQ(set.values[2], Complex(3, -3));
    EXPECT_EQ(set.header.reference, dofs({"1:X"}));
  }
}

TEST_F(MatV5File, SizesThatLeaveTheAxesOpenNeedAWord) {
  const OpenOptions options = given({"1:X", "2:X"}, {});
  const auto fill = [](Maker& m) {
    m.reals("f", {2, 1}, {1, 2});
    m.counting("H", {2, 2, 2});
  };
  EXPECT_THAT(error(fill, options),
              HasSubstr("variable H: [2x2x2] may be [F,R,C] or [R,C,F]; add a text axes = 'FRC' or 'RCF'"));
  for (const char* axes : {"FRC", "RCF"}) {
    make([&](Maker& m) {
      fill(m);
      m.characters("axes", 1, axes);
    });
    const FrfSet set = read(options);
    EXPECT_EQ(set.values[set.index(1, 0, 0)].real(), axes[0] == 'F' ? 2.0 : 5.0);
  }
}

TEST_F(MatV5File, DofsMayBeRowsOfCharacters) {
  make([](Maker& m) {
    m.reals("frequency", {1, 1}, {1});
    m.counting("frf", {2, 1});
    m.characters("response_dof", 2, "11:1++YY ");
    m.characters("reference_dof", 1, "7:-RZ");
    m.characters("quantity", 1, "mobility");
    m.characters("unit", 1, "m/s/N");
  });
  const std::string message = message_of([&] { read(); });
  EXPECT_THAT(message, HasSubstr("variable response_dof: '1"));
  make([](Maker& m) {
    m.reals("frequency", {1, 1}, {1});
    m.counting("frf", {1, 2});
    m.characters("response_dof", 2, "11:1+:Y+ Y");
    m.characters("reference_dof", 1, "7:-RZ");
    m.characters("quantity", 1, "mobility");
    m.characters("unit", 1, "m/s/N");
  });
  const FrfSet set = read();
  EXPECT_EQ(set.header.response, dofs({"1:+Y", "11:Y"}));
  EXPECT_EQ(set.header.reference, dofs({"7:-RZ"}));
  EXPECT_TRUE(near(set.values[1], Complex(2, -2) / Complex(0, 2 * std::numbers::pi), 1e-15));
}

TEST_F(MatV5File, WhatIsMissingOrDoubtfulIsNamed) {
  const OpenOptions options = given({"1:X"}, {});
  const auto axis = [](Maker& m) { m.reals("f", {3, 1}, {1, 2, 3}); };
  EXPECT_THAT(error(
                  [](Maker& m) {
                    m.counting("H", {3, 1});
                  },
                  options),
              HasSubstr("has no vector of frequencies; its variables are H [3x1]"));
  EXPECT_THAT(error([&](Maker& m) { axis(m); }, options),
              HasSubstr("has no complex array with an axis of 3 lines"));
  const auto two = [&](Maker& m) {
    axis(m);
    m.counting("H", {3, 1});
    m.counting("G", {3, 1});
  };
  EXPECT_THAT(error(two, options),
              HasSubstr("several variables may be the FRFs: H [3x1], G [3x1]; name one of them"));
  OpenOptions named = options;
  named.variable = "G";
  make(two);
  EXPECT_EQ(read(named).values.size(), 3u);
  named.variable = "K";
  EXPECT_THAT(error(two, named), HasSubstr("has no variable K; there are f [3x1], H [3x1], G [3x1]"));
  EXPECT_THAT(error(two, OpenOptions{}), HasSubstr("several variables"));
  const auto one = [&](Maker& m) {
    axis(m);
    m.counting("H", {3, 1});
  };
  OpenOptions none;
  EXPECT_THAT(error(one, none), HasSubstr("does not state which quantity it holds"));
  none.quantity = Quantity::receptance;
  EXPECT_THAT(error(one, none), HasSubstr("does not state at which DOFs H was measured"));
  EXPECT_THAT(error(one, given({"1:X", "2:X"}, {})),
              HasSubstr("variable H: is [3x1] where 3 lines, 2 responses and 2 references are expected"));
  const auto with = [&](const std::function<void(Maker&)>& more) {
    return [&, more](Maker& m) {
      one(m);
      more(m);
    };
  };
  OpenOptions unstated = options;
  unstated.quantity.reset();
  EXPECT_THAT(error(with([](Maker& m) { m.characters("quantity", 1, "force"); }), unstated),
              HasSubstr("variable quantity: unknown FRF quantity 'force'"));
  EXPECT_THAT(error(with([](Maker& m) { m.characters("unit", 1, "bar"); }), options),
              HasSubstr("variable unit: unknown unit 'bar'"));
  EXPECT_THAT(error(with([](Maker& m) {
                      m.reals("response_dof", {1, 1}, {1});
                    }),
                    options),
              HasSubstr("variable response_dof: is not text"));
  EXPECT_THAT(error(with([](Maker& m) {
                      m.counting("coherence", {3, 1});
                    }),
                    options),
              HasSubstr("variable coherence: is not real"));
  EXPECT_THAT(error(with([](Maker& m) {
                      m.reals("coherence", {3, 1}, {1, 1, 1});
                      m.reals("averages", {1, 1}, {0});
                    }),
                    options),
              HasSubstr("variable averages: is not a number of averages"));
  EXPECT_THAT(error(with([](Maker& m) {
                      m.reals("coherence", {1, 1}, {1});
                    }),
                    options),
              HasSubstr("variable coherence: is [1x1] and H [3x1]"));
  EXPECT_THAT(error(with([](Maker& m) {
                      m.reals("variance", {3, 1}, {1, 1, 1});
                    }),
                    options),
              HasSubstr("variable variance: is not complex"));
}

TEST_F(MatV5File, DamagedFilesAreErrorsAndNothingIsPrinted) {
  std::mt19937 random(22);
  write_mat(random_set(random, Quantity::receptance, NoiseRecord::variance), path("good.mat"));
  std::ifstream in(path("good.mat"), std::ios::binary);
  const std::string good{std::istreambuf_iterator<char>(in), {}};
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  std::vector<std::string> messages;
  for (std::size_t size = 4; size < good.size();
       size += 8 + good.size() / 600 * 8) {  // between elements, not at their ends
    write_file("a.mat", good.substr(0, size));
    messages.push_back(message_of([&] { read(); }));
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_THAT(messages, ::testing::Each(HasSubstr("is damaged or truncated")));
}

TEST_F(MatV5File, AFolderThatIsNotThereIsAnError) {
  std::mt19937 random(23);
  const FrfSet set = random_set(random, Quantity::receptance, NoiseRecord::none);
  EXPECT_THAT(message_of([&] { write_mat(set, path("none/a.mat")); }), HasSubstr("cannot be written"));
}

TEST_F(MatV5File, ADiskThatFillsAtTheEndIsNoticed) {
  std::mt19937 random(24);
  const FrfSet set = random_set(random, Quantity::receptance, NoiseRecord::coherence);
  write_mat(set, path("a.mat"));
  const rlim_t size = std::filesystem::file_size(path("a.mat"));
  for (rlim_t lacking = 1; lacking < std::min<rlim_t>(size, 400); ++lacking) {
    const SmallDisk disk(size - lacking);
    EXPECT_THAT(message_of([&] { write_mat(set, path("a.mat")); }), HasSubstr("cannot be written"));
  }
  expect_same(read(), set, 0.0);
}

class MeasuredMat : public MatV5File {
 protected:
  void SetUp() override {
    MatV5File::SetUp();
    if (!std::filesystem::exists(data_)) JOINTID_SKIP("no measured data at " << data_);
  }
  const std::filesystem::path data_ = std::filesystem::path(JOINTID_EXTERNAL_DATA);
};

TEST_F(MeasuredMat, ASisoFrfHasItsModeWhereItWasMeasured) {
  OpenOptions options = given({"1:+Z"}, {});
  options.quantity = Quantity::accelerance;
  const auto file = data_ / "siso-coherence/case1.mat";
  EXPECT_THAT(
      message_of([&] { open_mat_v5(file, options); }),
      HasSubstr("several variables may be the FRFs: Hf_chan_2 [1601x1], Hf_Cross_Spec_chan_2 [1601x1]"));
  options.variable = "Hf_chan_2";
  const FrfSet set = load(*open_mat_v5(file, options));
  ASSERT_EQ(set.header.lines(), 1601u);
  EXPECT_EQ(set.header.frequency_hz[0], 0.0);
  EXPECT_EQ(set.header.frequency_hz[1600], 500.0);
  EXPECT_TRUE(std::isnan(set.values[0].real()));
  std::size_t peak = 480;
  for (std::size_t i = 480; i < 960; ++i) {
    if (std::abs(set.values[i]) > std::abs(set.values[peak])) peak = i;
  }
  EXPECT_NEAR(set.header.frequency_hz[peak], 212.0925, 0.35);
}

TEST_F(MeasuredMat, SteppedSinesInAStructureAreNoFrfSet) {
  const auto file = data_ / "brake-reuss/ForcedFrequencyResponses.mat";
  EXPECT_THAT(message_of([&] { open_mat_v5(file); }), HasSubstr("several variables may be the FRFs: FRdata.ForceControl(1).amplitude"));
  OpenOptions options;
  options.variable = "FRdata.ForceControl(1).amplitude";
  EXPECT_THAT(message_of([&] { open_mat_v5(file, options); }), HasSubstr("'Hz, N, m/s^2, rad' is no unit of motion over force"));
}

}  // namespace
}  // namespace jointid::frf
