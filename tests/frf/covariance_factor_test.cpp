// Covariances of low rank: jointid-frf version 2 with covariance_factor and covariance_diagonal.
#include <gmock/gmock.h>
#include <hdf5.h>

#include <functional>

#include "file_fixture.hpp"
#include "frf/hdf5/hdf5_file.hpp"
#include "frf/hdf5/hdf5_writer.hpp"
#include "frf/set/corrections.hpp"
#include "frf/set/kept_source.hpp"
#include "frf/set/merged_set.hpp"
#include "frf/set/scaled_source.hpp"

namespace jointid::frf {
namespace {

using ::testing::HasSubstr;

constexpr std::size_t lines = 4, rows = 7, columns = 2, rank = 2;

/// Covariances L Lᴴ + diag(d) and their variances; nothing is known of response 3 on line 1.
FrfSet factored_set(Quantity quantity, bool diagonal, unsigned seed = 17) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return Complex{1e-7 * normal(random), 1e-7 * normal(random)}; };
  FrfSet set;
  set.header.quantity = quantity;
  set.header.noise = NoiseRecord::variance;
  set.header.frequency_hz = {5.0, 10.0, 20.0, 21.0};
  set.header.response = dofs({"1:+X", "2:-Y", "3:+RZ", "4:+X", "5:+X", "6:+X", "7:+X"});
  set.header.reference = dofs({"1:+X", "9:+Z"});
  set.factor.rank = rank;
  for (std::size_t i = 0; i < lines * rows * columns; ++i) {
    set.values.push_back(draw());
    if (diagonal) set.factor.diagonal.push_back(std::norm(draw()));
  }
  for (std::size_t i = 0; i < lines * rows * rank * columns; ++i) set.factor.rows.push_back(draw());
  for (std::size_t c = 0; c < columns; ++c) {
    for (std::size_t k = 0; k < rank; ++k) set.factor.rows[((rows + 3) * rank + k) * columns + c] = {nan(""), nan("")};
    if (diagonal) set.factor.diagonal[set.index(1, 3, c)] = nan("");
  }
  const std::vector<Complex> pairs = covariance_pairs(set);
  for (std::size_t i = 0; i < set.values.size(); ++i) {
    const std::size_t line = i / (rows * columns), r = i / columns % rows, c = i % columns;
    set.variance.push_back(0.5 * pairs[(line * pair_count(rows) + pair_index(r, r)) * columns + c].real() * Complex{1.0, 1.0});
  }
  return set;
}

/// The same with its covariances as pairs.
FrfSet packed(FrfSet set) {
  set.covariance = covariance_pairs(set);
  set.factor = {};
  return set;
}

void expect_pairs(const std::vector<Complex>& read, const std::vector<Complex>& expected, double share) {
  ASSERT_EQ(read.size(), expected.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    if (std::isnan(expected[i].real())) {
      EXPECT_TRUE(std::isnan(read[i].real())) << i;
    } else {
      EXPECT_LE(std::abs(read[i] - expected[i]), share * 1e-14) << i;
    }
  }
}

class CovarianceFactorFile : public FileTest {
 protected:
  std::string message_after(const std::function<void(hid_t)>& edit, const FrfSet& set) const {
    write_hdf5(set, path("a.h5"));
    const hid_t file = H5Fopen(path("a.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    edit(file);
    H5Fclose(file);
    return message_of([&] { load_with_covariance(*open_hdf5(path("a.h5"))); });
  }
  std::string message_after(const std::function<void(hid_t)>& edit) const {
    return message_after(edit, factored_set(Quantity::receptance, true));
  }

  bool has_dataset(const char* name) const {
    const hid_t file = H5Fopen(path("a.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const bool has = H5Lexists(file, name, H5P_DEFAULT) > 0;
    H5Fclose(file);
    return has;
  }
};

void set_version(hid_t file, int version) {
  H5Adelete(file, "version");
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t attribute = H5Acreate2(file, "version", H5T_NATIVE_INT, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, H5T_NATIVE_INT, &version);
  H5Aclose(attribute);
  H5Sclose(space);
}

/// A dataset of zeros, of complex or of real numbers; chunked ones are not written.
void replace(hid_t file, const char* name, const std::array<hsize_t, 3>& dims, bool complex, bool chunked = false) {
  if (H5Lexists(file, name, H5P_DEFAULT) > 0) H5Ldelete(file, name, H5P_DEFAULT);
  const hid_t space = H5Screate_simple(3, dims.data(), nullptr), type = H5Tcreate(H5T_COMPOUND, 16), create = H5Pcreate(H5P_DATASET_CREATE);
  H5Tinsert(type, "r", 0, H5T_NATIVE_DOUBLE);
  H5Tinsert(type, "i", 8, H5T_NATIVE_DOUBLE);
  const std::array<hsize_t, 3> chunk = {1, dims[1], dims[2]};
  if (chunked) H5Pset_chunk(create, 3, chunk.data());
  const hid_t of = complex ? type : H5T_NATIVE_DOUBLE;
  const hid_t dataset = H5Dcreate2(file, name, of, space, H5P_DEFAULT, create, H5P_DEFAULT);
  const std::vector<double> zeros(2 * dims[0] * dims[1] * dims[2]);
  if (!chunked) H5Dwrite(dataset, of, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data());
  H5Dclose(dataset);
  H5Pclose(create);
  H5Tclose(type);
  H5Sclose(space);
}

TEST_F(CovarianceFactorFile, ComesBackFromEveryStoredQuantity) {
  for (const Quantity quantity : all_quantities) {
    for (const bool diagonal : {false, true}) {
      const FrfSet set = factored_set(quantity, diagonal);
      write_hdf5(set, path("a.h5"));
      EXPECT_TRUE(has_dataset("covariance_factor"));
      EXPECT_EQ(has_dataset("covariance_diagonal"), diagonal);
      EXPECT_FALSE(has_dataset("covariance"));
      const auto source = open_hdf5(path("a.h5"));
      EXPECT_TRUE(source->has_covariance());
      EXPECT_EQ(source->factor_shape().rank, rank);
      EXPECT_EQ(source->factor_shape().diagonal, diagonal);
      const FrfSet read = load_with_covariance(*source);
      validate(read);
      ASSERT_EQ(read.factor.rows.size(), set.factor.rows.size());
      EXPECT_EQ(read.factor.diagonal.size(), set.factor.diagonal.size());
      expect_pairs(covariance_pairs(read), covariance_pairs(set), 1e-13);
      // The same numbers as from a file of pairs, whatever is asked for.
      write_hdf5(packed(set), path("b.h5"));
      const auto other = open_hdf5(path("b.h5"));
      const std::vector<std::size_t> some_lines = {0, 1, 3}, responses = {5, 0, 3}, references = {1};
      std::vector<Complex> of_factor(27), of_pairs(27);
      source->read_covariance({some_lines, responses, references}, of_factor);
      other->read_covariance({some_lines, responses, references}, of_pairs);
      expect_pairs(of_factor, of_pairs, 1e-13);
    }
  }
}

/// A factor of K columns, with a diagonal K + ½ in the size of the pairs' R + 1 over 2.
TEST_F(CovarianceFactorFile, IsWrittenWhereItIsSmaller) {
  EXPECT_TRUE((FactorShape{3, true}.is_smaller(7)));
  EXPECT_FALSE((FactorShape{4, false}.is_smaller(7)));
  EXPECT_TRUE((FactorShape{4, false}.is_smaller(8)));
  EXPECT_FALSE((FactorShape{4, true}.is_smaller(8)));
  EXPECT_FALSE((FactorShape{0, true}.is_smaller(9)));
  const FrfSet set = factored_set(Quantity::receptance, false);
  write_hdf5(set, path("a.h5"));
  write_hdf5(packed(set), path("b.h5"));
  EXPECT_LT(std::filesystem::file_size(path("a.h5")), std::filesystem::file_size(path("b.h5")));
  // Of two responses the pairs are.
  FrfSet two = set;
  two.header.response.resize(2);
  two.values.resize(2 * columns * lines);
  two.variance.assign(two.values.size(), {1.0, 1.0});
  two.factor.rows.assign(two.values.size() * rank, {1.0, 2.0});
  write_hdf5(two, path("a.h5"));
  EXPECT_FALSE(has_dataset("covariance_factor"));
  expect_pairs(load_with_covariance(*open_hdf5(path("a.h5"))).covariance, covariance_pairs(two), 1.0);
}

TEST_F(CovarianceFactorFile, IsHandedOnByEverySource) {
  const FrfSet set = factored_set(Quantity::receptance, true);
  KeptSource kept(from_memory(set));
  const FrfSet from_kept = load_with_covariance(kept);
  EXPECT_TRUE(from_kept.covariance.empty());
  EXPECT_EQ(from_kept.factor.diagonal.size(), set.factor.diagonal.size());
  expect_pairs(covariance_pairs(from_kept), covariance_pairs(set), 1e-13);
  Corrections corrections;
  corrections.conjugate = true;
  corrections.delay = 1e-3;
  corrections.gain = 3.0;
  corrections.flip = dofs({"2:+Y"});
  corrections.response_gain = {{Dof::parse("3:+RZ"), 0.5}};
  corrections.reference_gain = {{Dof::parse("9:+Z"), 2.0}};
  const FrfSet of_factor = load_with_covariance(*corrected(from_memory(set), corrections));
  const FrfSet of_pairs = load_with_covariance(*corrected(from_memory(packed(set)), corrections));
  ASSERT_TRUE(of_factor.factor.any());
  expect_pairs(covariance_pairs(of_factor), of_pairs.covariance, 1e-12);
}

/// With references of one measurement; nothing is known of line 2.
FrfSet correlated_set(FrfSet set) {
  for (std::size_t line = 0; line < lines; ++line) {
    const Complex value = line == 2 ? Complex(nan(""), nan("")) : Complex(0.1 * static_cast<double>(line), -0.6);
    const std::array<Complex, 4> all = {line == 2 ? value : 1.0, value, std::conj(value), line == 2 ? value : 1.0};
    set.reference_correlation.insert(set.reference_correlation.end(), all.begin(), all.end());
  }
  return set;
}

TEST_F(CovarianceFactorFile, ReferencesOfOneMeasurementStayBesideEitherForm) {
  for (const bool pairs : {false, true}) {
    const FrfSet factored = factored_set(Quantity::accelerance, true);
    const FrfSet set = correlated_set(pairs ? packed(factored) : factored);
    write_hdf5(set, path("a.h5"));
    const auto source = open_hdf5(path("a.h5"));
    EXPECT_TRUE(source->has_reference_correlation());
    const FrfSet read = load_with_covariance(*source);
    validate(read);
    expect_pairs(read.reference_correlation, set.reference_correlation, 1e-14);
    const std::vector<std::size_t> some = {1, 3}, turned = {1, 0};
    std::vector<Complex> out(8);
    KeptSource kept(from_memory(set));
    ASSERT_TRUE(kept.has_reference_correlation());
    kept.read_reference_correlation(some, turned, out);
    EXPECT_EQ(out[1], std::conj(set.reference_correlation[4 + 1]));
    EXPECT_EQ(out[4 + 2], set.reference_correlation[12 + 1]);
    write_hdf5(factored, path("b.h5"));
    EXPECT_FALSE(open_hdf5(path("b.h5"))->has_reference_correlation());
  }
}

/// The errors turn with the FRFs: by a sign of one reference, to the conjugate.
TEST_F(CovarianceFactorFile, FactorsTurnWhatReferencesHaveInCommon) {
  const FrfSet set = correlated_set(factored_set(Quantity::receptance, true));
  EntryScale scale{.conjugate = true, .line = std::vector<Complex>(lines, {0.0, 1.5}), .response = std::vector<double>(rows, 1.0),
                   .reference = {2.0, -3.0}};
  const FrfSet read = load_with_covariance(*scaled_source(from_memory(set), set.header, std::move(scale)));
  for (const std::size_t line : {0u, 1u, 3u}) {
    const Complex before = set.reference_correlation[4 * line + 1], after = read.reference_correlation[4 * line + 1];
    EXPECT_LE(std::abs(after + std::conj(before)), 1e-14);
    EXPECT_EQ(read.reference_correlation[4 * line + 3], 1.0);
  }
}

TEST_F(CovarianceFactorFile, CorrelationsThatAreNoneAreOneClearError) {
  const auto message = [&](std::size_t at, Complex value) {
    FrfSet set = correlated_set(factored_set(Quantity::receptance, true));
    set.reference_correlation[at] = value;
    write_hdf5(set, path("a.h5"));
    return message_of([&] { load_with_covariance(*open_hdf5(path("a.h5"))); });
  };
  EXPECT_THAT(message(0, 0.9), HasSubstr("correlation of references 1:+X and 1:+X, line 1: 0.9 + 0i is none"));
  EXPECT_THAT(message(4 + 2, {0.0, 3.0}), HasSubstr("correlation of references 9:+Z and 1:+X, line 2: 0 + 3i is none"));
  EXPECT_THAT(message(4 + 2, {0.1, -0.6}), HasSubstr("it must be Hermitian"));
  const FrfSet set = correlated_set(factored_set(Quantity::receptance, true));
  EXPECT_THAT(message_after(
                  [](hid_t file) {
                    H5Ldelete(file, "covariance_factor", H5P_DEFAULT);
                    H5Ldelete(file, "covariance_diagonal", H5P_DEFAULT);
                  },
                  set),
              HasSubstr("has a dataset reference_correlation without covariances; write the covariances, too"));
  EXPECT_THAT(message_after(
                  [](hid_t file) {
                    replace(file, "reference_correlation", {lines, columns, 3}, true);
                  },
                  set),
              HasSubstr("dataset reference_correlation: has dimensions [4,2,3] where"));
  FrfSet alone = factored_set(Quantity::receptance, true);
  alone.reference_correlation = set.reference_correlation;
  alone.factor = {};
  EXPECT_THAT(message_of([&] { validate(alone); }), HasSubstr("and there are no covariances"));
}

TEST_F(CovarianceFactorFile, ThatIsBrokenIsOneClearError) {
  const auto real = [](hid_t file, const std::array<hsize_t, 3>& dims) { replace(file, "covariance_diagonal", dims, false); };
  EXPECT_THAT(message_after([](hid_t file) { replace(file, "covariance", {lines, 28, columns}, true); }),
              HasSubstr("has both covariance and covariance_factor"));
  EXPECT_THAT(message_after([](hid_t file) { replace(file, "covariance", {lines, 28, columns}, true); },
                            packed(factored_set(Quantity::receptance, true))),
              HasSubstr("nothing was thrown"));
  EXPECT_THAT(message_after([&](hid_t file) { real(file, {lines, rows, columns}); }, packed(factored_set(Quantity::receptance, true))),
              HasSubstr("has both covariance and covariance_diagonal"));
  EXPECT_THAT(message_after([](hid_t file) { H5Ldelete(file, "covariance_factor", H5P_DEFAULT); }),
              HasSubstr("has a dataset covariance_diagonal without covariance_factor; write both, or neither"));
  EXPECT_THAT(message_after([](hid_t file) { H5Ldelete(file, "variance", H5P_DEFAULT); }),
              HasSubstr("has a dataset covariance_factor without variance; write the variances, too"));
  EXPECT_THAT(message_after([](hid_t file) { set_version(file, 1); }),
              HasSubstr("has a dataset covariance_factor and is of version 1; write version = 2"));
  EXPECT_THAT(message_after([](hid_t file) { replace(file, "covariance_factor", {lines, 15, columns}, true); }),
              HasSubstr("dataset covariance_factor: has 15 rows, which 7 responses do not divide; store it as [lines, responses · K"));
  EXPECT_THAT(message_after([](hid_t file) { replace(file, "covariance_factor", {3, 14, columns}, true); }),
              HasSubstr("dataset covariance_factor: has dimensions [3,14,2] where"));
  EXPECT_THAT(message_after([](hid_t file) { replace(file, "covariance_factor", {lines, 14, columns}, false); }),
              HasSubstr("dataset covariance_factor: does not hold complex numbers"));
  EXPECT_THAT(message_after([](hid_t file) { replace(file, "covariance_factor", {lines, 14, columns}, true, true); }),
              HasSubstr("the file was not written to its end"));
  EXPECT_THAT(message_after([&](hid_t file) { real(file, {lines, rows, 1}); }),
              HasSubstr("dataset covariance_diagonal: has dimensions [4,7,1] where"));
  EXPECT_THAT(message_after([](hid_t file) { replace(file, "covariance_diagonal", {lines, rows, columns}, true); }),
              HasSubstr("dataset covariance_diagonal: does not hold real numbers"));
}

TEST_F(CovarianceFactorFile, NamesTheFrfWhoseNumbersAreWrong) {
  const auto message = [&](const std::function<void(FrfSet&)>& change) {
    FrfSet set = factored_set(Quantity::receptance, true);
    change(set);
    write_hdf5(set, path("a.h5"));
    const auto source = open_hdf5(path("a.h5"));
    load(*source);  // whoever reads FRFs and variances sees nothing of it
    std::vector<Complex> out(rows * rows);
    const std::vector<std::size_t> line = {2}, all = {0, 1, 2, 3, 4, 5, 6}, c = {1};
    const std::string of_pairs = message_of([&] { source->read_covariance({line, all, c}, out); });
    EXPECT_EQ(of_pairs, message_of([&] { load_with_covariance(*source); }));
    return of_pairs;
  };
  const std::size_t at = (2 * rows + 4) * columns + 1;
  EXPECT_THAT(message([&](FrfSet& set) { set.factor.diagonal[at] = -1e-14; }),
              HasSubstr("covariance of 5:+X/9:+Z, line 3: its diagonal part -1e-14 is no variance; export the covariances again"));
  EXPECT_THAT(message([&](FrfSet& set) { set.factor.diagonal[at] = HUGE_VAL; }), HasSubstr("its diagonal part inf is no variance"));
  EXPECT_THAT(message([&](FrfSet& set) { set.factor.diagonal[at] = nan(""); }),
              HasSubstr("5:+X/9:+Z, line 3: 1 of the 3 numbers of its factor and diagonal are NaN"));
  const std::size_t first_column = (2 * rows + 4) * rank * columns + 1;
  EXPECT_THAT(message([&](FrfSet& set) { set.factor.rows[first_column] = {0.0, nan("")}; }), HasSubstr("1 of the 3 numbers"));
  EXPECT_THAT(message([&](FrfSet& set) { set.factor.rows[first_column] = HUGE_VAL; }), HasSubstr("its factor has an infinite number"));
}

TEST_F(CovarianceFactorFile, ThatIsCutShortIsAnErrorAtEveryLength) {
  write_hdf5(factored_set(Quantity::receptance, true), path("a.h5"));
  const auto size = std::filesystem::file_size(path("a.h5"));
  for (std::uintmax_t keep = 0; keep < size; keep += 97) {
    std::filesystem::copy_file(path("a.h5"), path("b.h5"), std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(path("b.h5"), keep);
    EXPECT_THAT(message_of([&] { load_with_covariance(*open_hdf5(path("b.h5"))); }), HasSubstr("b.h5")) << keep;
  }
}

TEST(CovarianceFactor, OfAnotherLengthOrBesidePairsIsAnError) {
  FrfSet set = factored_set(Quantity::receptance, true);
  validate(set);
  FrfSet other = set;
  other.factor.rows.pop_back();
  EXPECT_THAT(message_of([&] { validate(other); }), HasSubstr("factor of the covariance: 111 numbers, where"));
  other = set;
  other.factor.diagonal.pop_back();
  EXPECT_THAT(message_of([&] { validate(other); }), HasSubstr("diagonal of the covariance: 55 numbers, where"));
  other = set;
  other.covariance = covariance_pairs(set);
  EXPECT_THAT(message_of([&] { validate(other); }), HasSubstr("covariance: it is given, and a factor of it, too; give one of them"));
}

/// Responses of a set, renamed to others where asked.
FrfSet part_of(const FrfSet& set, const std::vector<std::size_t>& responses, const std::vector<std::string>& references) {
  FrfSet out;
  out.header = set.header;
  out.header.response.clear();
  out.header.reference = dofs(references);
  for (const std::size_t r : responses) out.header.response.push_back(set.header.response[r]);
  out.factor.rank = set.factor.rank;
  for (std::size_t line = 0; line < lines; ++line) {
    for (const std::size_t r : responses) {
      const auto take = [&](const auto& from, std::size_t count, auto& to) {
        const auto begin = from.begin() + static_cast<std::ptrdiff_t>(set.index(line, r, 0) * count);
        if (!from.empty()) to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(columns * count));
      };
      take(set.values, 1, out.values);
      take(set.variance, 1, out.variance);
      take(set.factor.rows, rank, out.factor.rows);
      take(set.factor.diagonal, 1, out.factor.diagonal);
    }
  }
  return out;
}

/// Three sets, two of which share a reference: columns side by side say what pairs say.
TEST(CovarianceFactor, OfMergedSetsIsThatOfTheirPairs) {
  for (const bool diagonal : {false, true}) {
    const FrfSet a = part_of(factored_set(Quantity::receptance, diagonal, 1), {0, 1, 3}, {"1:+X", "9:+Z"});
    const FrfSet b = part_of(factored_set(Quantity::receptance, false, 2), {2, 4, 5, 6}, {"8:+Z", "9:+Z"});
    FrfSet c = part_of(factored_set(Quantity::receptance, false, 3), {6, 3, 0}, {"12:+Z", "13:+Z"});
    c.header.response[0].sign = -1;
    FrfSet variances_alone = c;
    variances_alone.factor = {};
    for (const FrfSet& last : {c, variances_alone}) {
      const FrfSet out = merged({a, b, last});
      validate(out);
      EXPECT_EQ(out.factor.rank, 2 * rank);
      EXPECT_TRUE(out.covariance.empty());
      EXPECT_EQ(!out.factor.diagonal.empty(), diagonal || !last.factor.any());
      const FrfSet of_pairs = merged({packed(a), b, last.factor.any() ? packed(last) : last});
      ASSERT_FALSE(of_pairs.covariance.empty());
      // Where an error is not known pairs put zero between it and others: nobody asks for that.
      std::vector<Complex> expected = of_pairs.covariance, pairs = covariance_pairs(out);
      const std::size_t all_rows = out.header.response.size(), all = out.header.reference.size();
      for (std::size_t i = 0; i < expected.size(); ++i) {
        const std::size_t line = i / (pair_count(all_rows) * all), pair = i / all % pair_count(all_rows), column = i % all;
        for (std::size_t r = 0; r < all_rows; ++r) {
          const Complex own = expected[(line * pair_count(all_rows) + pair_index(r, r)) * all + column];
          if (pair >= pair_count(r) && pair < pair_count(r + 1) && std::isnan(own.real())) expected[i] = {nan(""), nan("")};
          for (std::size_t s = r; s < all_rows; ++s) {
            if (pair == pair_index(s, r) && std::isnan(own.real())) expected[i] = {nan(""), nan("")};
          }
        }
      }
      expect_pairs(pairs, expected, 1e-13);
    }
  }
}

}  // namespace
}  // namespace jointid::frf
