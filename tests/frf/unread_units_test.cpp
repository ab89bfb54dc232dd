// Units that stand where nothing reads them: in comments and titles of tables, in texts and attributes beside arrays.
#include <gmock/gmock.h>
#include <hdf5.h>

#include <array>

#include "file_fixture.hpp"

namespace jointid::frf {
namespace {

using ::testing::HasSubstr;

const std::string key = "# quantity = accelerance\n", titles = "frequency_hz,1:+Z/2:+Z re,1:+Z/2:+Z im\n", numbers = "10,2,-1\n20,3,4\n";
constexpr double one_gravity = 9.80665;

class UnreadUnits : public FileTest {
 protected:
  FrfSet read(const std::string& text, const OpenOptions& options = {}) const { return load(*open(write_file("a.csv", text), options)); }
  std::string error(const std::string& text, const OpenOptions& options = {}) const {
    return message_of([&] { read(text, options); });
  }
  /// That of 2 − 1i at 10 Hz and 3 + 4i at 20 Hz, in `unit` m/s²/N.
  static void expect_frf(const FrfSet& set, double unit) {
    ASSERT_EQ(set.header.lines(), 2U);
    const double omega = 2.0 * 3.141592653589793 * 20.0;
    EXPECT_NEAR(set.header.frequency_hz[1], 20.0, 1e-9);
    EXPECT_LE(std::abs(set.values[1] + unit * Complex(3.0, 4.0) / (omega * omega)), 1e-9 * std::abs(set.values[1]));
  }
};

OpenOptions of_point(std::optional<Quantity> quantity = Quantity::accelerance) {
  OpenOptions options;
  options.quantity = quantity;
  options.response = {Dof::parse("1:+Z")};
  options.reference = {Dof::parse("2:+Z")};
  return options;
}

TEST_F(UnreadUnits, InCommentsAreErrors) {
  for (const char* line :
       {"# Einheit = g/N", "# unité: g/N", "# y-axis: (g)/(lbf)", "# EU: m/s²/N", "# unit g/N", "# g/lbf", "% scale = g/N"})
    EXPECT_THAT(error(key + line + "\n" + titles + numbers), HasSubstr("line 2: ")) << line;
  EXPECT_THAT(error(key + "# Einheit = g/N\n" + titles + numbers),
              HasSubstr("the unit 'g/N' of the key 'Einheit' is not read; did you mean # unit = g/N?"));
  for (const char* line : {"# operator: N", "# dB reference: 1", "# a comment", "# sensor: 352C22"})
    expect_frf(read(key + line + "\n" + titles + numbers), 1.0);
}

TEST_F(UnreadUnits, TitlesOfOtherPrograms) {
  const auto tabbed = [](std::string text) {
    std::ranges::replace(text, ',', '\t');
    return text;
  };
  expect_frf(read("f (Hz),Re(H) (g/N),Im(H) (g/N)\n" + numbers, of_point({})), one_gravity);
  expect_frf(read("Frequency,Re(H11),Im(H11)\n" + numbers, of_point()), 1.0);
  expect_frf(read("Frequency (Hz),H1 Real (g/N),H1 Imag (g/N)\n" + numbers, of_point({})), one_gravity);
  expect_frf(read("Frequency (Hz),Real [(g)/(N)],Imaginary [(g)/(N)]\n" + numbers, of_point({})), one_gravity);
  expect_frf(read("Frequenz [Hz],Realteil [g/N],Imagin\xE4rteil [g/N]\n" + numbers, of_point({})), one_gravity);
  expect_frf(read(tabbed("Frequency [kHz],Real [g/N],Imaginary [g/N]\n0.01,2,-1\n0.02,3,4\n"), of_point()), one_gravity);
  EXPECT_THAT(error(tabbed("Frequency [Hz],Real [V/N],Imaginary [V/N]\n" + numbers), of_point()), HasSubstr("V is a voltage"));
  EXPECT_THAT(error("Frequency,H1 Real,H1 Imag\n" + numbers), HasSubstr("--response"));
  EXPECT_THAT(error("Frequency,2X/1X Real,2X/1X Imag\n" + numbers, of_point()), HasSubstr("is of 2:+X by its title, and 1:+Z was given for it; give 2:+X, which a scene may rename"));
}

TEST_F(UnreadUnits, TitlesInTheCommentAboveTheNumbers) {
  expect_frf(read(key + "# " + titles + numbers), 1.0);
  expect_frf(read("% frequency_hz,1:+Z/2:+Z re [g/N],1:+Z/2:+Z im [g/N]\n" + numbers), one_gravity);
}

TEST_F(UnreadUnits, AUnitThatIsGivenReplacesThatOfATable) {
  OpenOptions options;
  options.unit = "g/N";
  expect_frf(read(titles + numbers, options), one_gravity);
  expect_frf(read("frequency_hz,1:+Z/2:+Z re [m/s^2/N],1:+Z/2:+Z im [m/s^2/N]\n" + numbers, options), one_gravity);
}

/// HDF5 as other programs write it, with a text beside the FRFs.
class UnreadAttributes : public UnreadUnits {
 protected:
  /// `where`: the path of the object that has the attribute.
  std::filesystem::path file(const std::string& name, const std::string& text, const std::string& where) const {
    const std::filesystem::path at = path("a.h5");
    const hid_t file = H5Fcreate(at.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    H5Gclose(H5Gcreate2(file, "run", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    write(file, "run/frf_real", {2.0, 3.0});
    write(file, "run/frf_imag", {-1.0, 4.0});
    write(file, "run/frequency", {10.0, 20.0});
    const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR), object = H5Oopen(file, where.c_str(), H5P_DEFAULT);
    H5Tset_size(type, text.size());
    const hid_t attribute = H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, type, text.data());
    H5Aclose(attribute);
    H5Oclose(object);
    H5Sclose(space);
    H5Tclose(type);
    H5Fclose(file);
    return at;
  }

 private:
  static void write(hid_t file, const char* name, const std::array<double, 2>& values) {
    const hsize_t size = values.size();
    const hid_t space = H5Screate_simple(1, &size, nullptr);
    const hid_t dataset = H5Dcreate2(file, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(dataset);
    H5Sclose(space);
  }
};

TEST_F(UnreadAttributes, OfAGroupAreRead) { expect_frf(load(*open(file("Units", "g/N", "run"), of_point())), one_gravity); }

TEST_F(UnreadAttributes, UnderAnotherNameAreErrors) {
  for (const char* where : {"/", "run", "run/frf_real"})
    EXPECT_THAT(message_of([&] { open(file("EU", "g/lbf", where), of_point()); }),
                HasSubstr("@EU: states the unit 'g/lbf' and is not read; did you mean unit?"))
        << where;
  EXPECT_THAT(message_of([&] { open(file("ylabel", "Accelerance [g/N]", "run"), of_point()); }), HasSubstr("states the unit 'g/N'"));
  expect_frf(load(*open(file("title", "a beam", "run"), of_point())), 1.0);
}

}  // namespace
}  // namespace jointid::frf
