#include <gmock/gmock.h>
#include <hdf5.h>

#include <array>
#include <complex>
#include <functional>

#include "file_fixture.hpp"
#include "frf/hdf5/hdf5_file.hpp"
#include "frf/hdf5/hdf5_writer.hpp"

namespace jointid::frf {
namespace {

using ::testing::HasSubstr;

/// A valid file of 3 lines, responses 1:+X 2:+X, reference 1:+X, values line + i·r, to be spoilt by each
/// test.
class Hdf5Layout : public FileTest {
 protected:
  void SetUp() override {
    FileTest::SetUp();
    FrfSet set;
    set.header.frequency_hz = {1.0, 2.0, 3.0};
    set.header.response = dofs({"1:+X", "2:+X"});
    set.header.reference = dofs({"1:+X"});
    set.header.nodes = {{1, {}}, {2, {}}};
    for (int i = 0; i < 6; ++i) set.values.emplace_back(i / 2, i % 2);
    write_hdf5(set, path("a.h5"));
    set_ = set;
  }

  /// Opens the file for writing and lets `edit` have it.
  void spoil(const std::function<void(hid_t)>& edit) const {
    const hid_t file = H5Fopen(path("a.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    ASSERT_GE(file, 0);
    edit(file);
    H5Fclose(file);
  }

  std::string message() const {
    return message_of([&] { load(*open_hdf5(path("a.h5"))); });
  }

  /// What is said of the file spoilt by `edit`.
  std::string message_after(const std::function<void(hid_t)>& edit) const {
    spoil(edit);
    return message();
  }

  FrfSet set_;
};

void replace_dataset(hid_t file, const char* name, hid_t type, const std::vector<hsize_t>& dims,
                     const void* data, hid_t memory_type, hid_t create = H5P_DEFAULT) {
  if (H5Lexists(file, name, H5P_DEFAULT) > 0) H5Ldelete(file, name, H5P_DEFAULT);
  const hid_t space = H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr);
  const hid_t dataset = H5Dcreate2(file, name, type, space, H5P_DEFAULT, create, H5P_DEFAULT);
  if (data != nullptr) H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data);
  H5Dclose(dataset);
  H5Sclose(space);
}

void replace_doubles(hid_t file, const char* name, const std::vector<hsize_t>& dims,
                     const std::vector<double>& data) {
  replace_dataset(file, name, H5T_NATIVE_DOUBLE, dims, data.data(), H5T_NATIVE_DOUBLE);
}

hid_t compound(hid_t real, const char* first = "r", const char* second = "i") {
  const hid_t type = H5Tcreate(H5T_COMPOUND, 2 * H5Tget_size(real));
  H5Tinsert(type, first, 0, real);
  H5Tinsert(type, second, H5Tget_size(real), real);
  return type;
}

hid_t fixed_text(std::size_t width, H5T_str_t padding = H5T_STR_NULLPAD) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, width);
  H5Tset_strpad(type, padding);
  return type;
}

/// Replaces an attribute of `object` ("/" or a dataset) by fixed-length text, as one element or as a scalar.
void replace_text(hid_t file, const char* object, const char* name, const std::string& text,
                  bool scalar = true) {
  if (H5Aexists_by_name(file, object, name, H5P_DEFAULT) > 0)
    H5Adelete_by_name(file, object, name, H5P_DEFAULT);
  const hsize_t one = 1;
  const hid_t space = scalar ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &one, nullptr);
  const hid_t type = fixed_text(text.size());
  const hid_t attribute =
      H5Acreate_by_name(file, object, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, type, text.data());
  H5Aclose(attribute);
}

void replace_number(hid_t file, const char* object, const char* name, const std::vector<double>& values) {
  if (H5Aexists_by_name(file, object, name, H5P_DEFAULT) > 0)
    H5Adelete_by_name(file, object, name, H5P_DEFAULT);
  const hsize_t count = values.size();
  const hid_t space = H5Screate_simple(1, &count, nullptr);
  const hid_t attribute =
      H5Acreate_by_name(file, object, name, H5T_IEEE_F64BE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, H5T_NATIVE_DOUBLE, values.data());
  H5Aclose(attribute);
}

/// frf anew, with `create` and numbers of type `real`, its attributes as before.
void replace_frf(hid_t file, const FrfSet& set, hid_t real, hid_t create = H5P_DEFAULT) {
  replace_dataset(file, "frf", compound(real), {3, 2, 1}, set.values.data(), compound(H5T_NATIVE_DOUBLE),
                  create);
  replace_text(file, "frf", "quantity", "receptance");
  replace_text(file, "frf", "unit", "m/N");
}

hid_t chunks(hsize_t lines, hsize_t rows, bool compressed) {
  const hid_t create = H5Pcreate(H5P_DATASET_CREATE);
  const std::array<hsize_t, 3> chunk = {lines, rows, 1};
  H5Pset_chunk(create, 3, chunk.data());
  if (compressed) H5Pset_deflate(create, 6);
  return create;
}

TEST_F(Hdf5Layout, OtherStorageOfTheSameNumbersReadsTheSame) {
  const std::vector<hid_t> storages = {H5P_DEFAULT, chunks(2, 2, false), chunks(2, 1, false),
                                       chunks(2, 2, true), chunks(3, 1, true)};
  for (const hid_t real : {H5T_IEEE_F64LE, H5T_IEEE_F64BE, H5T_IEEE_F32LE}) {
    for (const hid_t storage : storages) {
      spoil([&](hid_t file) { replace_frf(file, set_, real, storage); });
      expect_same(load(*open_hdf5(path("a.h5"))), set_, 0.0);
    }
  }
}

TEST_F(Hdf5Layout, TextOfEveryKindReadsTheSame) {
  for (const H5T_str_t padding : {H5T_STR_NULLPAD, H5T_STR_SPACEPAD}) {
    spoil([&](hid_t file) {
      const char* names = padding == H5T_STR_NULLPAD ? "1:+X\0\0\0002:+X\0\0" : "1:+X  2:+X  ";
      const std::size_t width = padding == H5T_STR_NULLPAD ? 7 : 6;
      const hid_t type = fixed_text(width, padding);
      const std::string bytes(names, padding == H5T_STR_NULLPAD ? 13 : 12);
      replace_dataset(file, "response_dof", type, {2}, (bytes + '\0').data(), type);
      replace_text(file, "/", "format", "jointid-frf", false);
      replace_number(file, "/", "version", {1.0});
    });
    expect_same(load(*open_hdf5(path("a.h5"))), set_, 0.0);
  }
}

TEST_F(Hdf5Layout, UnitsScaleTheValues) {
  spoil([](hid_t file) { replace_text(file, "frf", "unit", "mm/N"); });
  const FrfSet read = load(*open_hdf5(path("a.h5")));
  EXPECT_EQ(read.values[5], 1e-3 * set_.values[5]);
}

TEST_F(Hdf5Layout, WhatIsNoHdf5IsAnError) {
  const auto file = write_file("b.h5", "\x89HDF\r\n\x1a\n and nothing more");
  EXPECT_THAT(message_of([&] { open_hdf5(file); }), HasSubstr("b.h5: cannot be opened as HDF5"));
}

TEST_F(Hdf5Layout, ATruncatedFileIsAnError) {
  for (const double part : {0.3, 0.6, 0.9, 0.99}) {
    const auto size = static_cast<double>(std::filesystem::file_size(path("a.h5")));
    std::filesystem::copy_file(path("a.h5"), path("b.h5"), std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(path("b.h5"), static_cast<std::uintmax_t>(part * size));
    EXPECT_THAT(message_of([&] { load(*open_hdf5(path("b.h5"))); }),
                HasSubstr("b.h5: cannot be opened as HDF5"));
  }
}

TEST_F(Hdf5Layout, RootAttributesAreChecked) {
  EXPECT_THAT(message_after([](hid_t f) { replace_number(f, "/", "version", {3.0}); }),
              HasSubstr("is of jointid-frf version 3; this program reads versions 1 and 2"));
  EXPECT_THAT(message_after([](hid_t f) {
                replace_number(f, "/", "version", {1.0, 2.0});
              }),
              HasSubstr("root attribute version: is not a single value"));
  EXPECT_THAT(message_after([](hid_t f) { replace_text(f, "/", "version", "1"); }),
              HasSubstr("root attribute version: is not a number"));
  EXPECT_THAT(message_after([](hid_t f) { H5Adelete(f, "version"); }),
              HasSubstr("has no root attribute version"));
  EXPECT_THAT(message_after([](hid_t f) { replace_text(f, "/", "format", "other"); }),
              HasSubstr("root attribute format is 'other', not 'jointid-frf'"));
  EXPECT_THAT(message_after([](hid_t f) { replace_number(f, "/", "format", {1.0}); }),
              HasSubstr("root attribute format: is not text"));
  EXPECT_THAT(message_after([](hid_t f) { H5Adelete(f, "format"); }),
              HasSubstr("has no root attribute format"));
}

TEST_F(Hdf5Layout, AttributesOfFrfAreChecked) {
  EXPECT_THAT(message_after([](hid_t f) { replace_text(f, "frf", "unit", "V/N"); }),
              HasSubstr("dataset frf: unknown unit 'V/N'; write m/N"));
  EXPECT_THAT(message_after([](hid_t f) { H5Adelete_by_name(f, "frf", "unit", H5P_DEFAULT); }),
              HasSubstr("dataset frf: has no attribute unit"));
  EXPECT_THAT(message_after([](hid_t f) { replace_text(f, "frf", "quantity", "mobilty"); }),
              HasSubstr("dataset frf: unknown FRF quantity 'mobilty'; did you mean mobility?"));
  EXPECT_THAT(message_after([](hid_t f) { H5Adelete_by_name(f, "frf", "quantity", H5P_DEFAULT); }),
              HasSubstr("dataset frf: has no attribute quantity"));
}

TEST_F(Hdf5Layout, TheFrequencyAxisIsChecked) {
  EXPECT_THAT(message_after([](hid_t f) { replace_text(f, "frequency", "unit", "rad/s"); }),
              HasSubstr("dataset frequency: is in 'rad/s'; store frequencies in Hz"));
  EXPECT_THAT(message_after([](hid_t f) {
                replace_doubles(f, "frequency", {3}, {1.0, 3.0, 2.0});
              }),
              HasSubstr("frequencies must increase"));
  EXPECT_THAT(message_after([](hid_t f) {
                replace_doubles(f, "frequency", {3, 1}, {1.0, 2.0, 3.0});
              }),
              HasSubstr("dataset frequency: has 2 dimensions instead of 1"));
  EXPECT_THAT(message_after([](hid_t f) {
                replace_doubles(f, "frequency", {4}, {1.0, 2.0, 3.0, 4.0});
              }),
              HasSubstr("dataset frf: has dimensions [3,2,1] where frequency, response_dof and reference_dof "
                        "make [4,2,1]"));
  EXPECT_THAT(message_after([](hid_t f) { replace_doubles(f, "frequency", {0}, {}); }),
              HasSubstr("no lines"));
  EXPECT_THAT(message_after([](hid_t f) {
                replace_dataset(f, "frequency", compound(H5T_NATIVE_DOUBLE), {1}, nullptr, 0);
              }),
              HasSubstr("dataset frequency"));
  EXPECT_THAT(message_after([](hid_t f) { H5Ldelete(f, "frequency", H5P_DEFAULT); }),
              HasSubstr("dataset frequency: is missing"));
}

TEST_F(Hdf5Layout, DofsAreChecked) {
  const auto names = [](const std::string& bytes) {
    return [bytes](hid_t f) {
      replace_dataset(f, "response_dof", fixed_text(4), {2}, bytes.data(), fixed_text(4));
    };
  };
  EXPECT_THAT(message_after(names("1:+X1:-X")), HasSubstr("response DOFs: DOF 1:-X appears twice"));
  EXPECT_THAT(message_after(names("1:+Xnone")), HasSubstr("dataset response_dof: 'none' is not a DOF"));
  EXPECT_THAT(message_after([](hid_t f) {
                replace_doubles(f, "response_dof", {2}, {1.0, 2.0});
              }),
              HasSubstr("dataset response_dof: does not hold text"));
}

TEST_F(Hdf5Layout, AxesOfNodesAreChecked) {
  EXPECT_THAT(message_after([](hid_t f) {
                replace_doubles(f, "node_axes", {2, 3}, std::vector<double>(6));
              }),
              HasSubstr("dataset node_axes: is not [2,3,3] as node_id asks"));
}

TEST_F(Hdf5Layout, NodesAreChecked) {
  EXPECT_THAT(message_after([](hid_t f) {
                replace_doubles(f, "node_position", {2, 2}, {1.0, 2.0, 3.0, 4.0});
              }),
              HasSubstr("dataset node_position: is not [2,3] as node_id asks"));
  EXPECT_THAT(message_after([](hid_t f) {
                replace_doubles(f, "node_id", {1}, {1.5});
                replace_doubles(f, "node_position", {1, 3}, {1.0, 2.0, 3.0});
              }),
              HasSubstr("dataset node_id: 1.5 is not a node number"));
}

TEST_F(Hdf5Layout, FrfMustBeComplexAndHere) {
  EXPECT_THAT(message_after([](hid_t f) {
                replace_doubles(f, "frf", {3, 2, 1}, std::vector<double>(6));
              }),
              HasSubstr("dataset frf: does not hold complex numbers"));
  EXPECT_THAT(message_after([](hid_t f) {
                const hid_t type = compound(H5T_NATIVE_DOUBLE, "real", "imag");
                replace_dataset(f, "frf", type, {3, 2, 1}, std::vector<double>(12).data(), type);
              }),
              HasSubstr("dataset frf: does not hold complex numbers"));
  EXPECT_THAT(message_after([](hid_t f) {
                H5Ldelete(f, "frf", H5P_DEFAULT);
                H5Lcreate_external("other.h5", "/frf", f, "frf", H5P_DEFAULT, H5P_DEFAULT);
              }),
              HasSubstr("dataset frf: is a link to somewhere else"));
  EXPECT_THAT(message_after([](hid_t f) {
                H5Ldelete(f, "frf", H5P_DEFAULT);
                H5Gclose(H5Gcreate2(f, "frf", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
              }),
              HasSubstr("dataset frf: is not a dataset"));
}

TEST_F(Hdf5Layout, DataInOtherFilesAreRefused) {
  EXPECT_THAT(message_after([&](hid_t f) {
                const hid_t create = H5Pcreate(H5P_DATASET_CREATE);
                H5Pset_external(create, "/etc/passwd", 0, H5F_UNLIMITED);
                replace_dataset(f, "frf", compound(H5T_NATIVE_DOUBLE), {3, 2, 1}, nullptr, 0, create);
              }),
              HasSubstr("dataset frf: its data lie in other files"));
}

TEST_F(Hdf5Layout, DeclaredSizesAreHeldAgainstWhatIsStored) {
  for (const bool compressed : {false, true}) {
    spoil([&](hid_t f) {
      const hid_t create = H5Pcreate(H5P_DATASET_CREATE);
      const hsize_t chunk = 1000;
      H5Pset_chunk(create, 1, &chunk);
      if (compressed) H5Pset_deflate(create, 1);
      replace_dataset(f, "frequency", H5T_NATIVE_DOUBLE, {hsize_t{1} << 50}, nullptr, 0, create);
    });
    EXPECT_THAT(message(),
                HasSubstr("dataset frequency: declares 9007199254.740992 MB and stores 0.000000 MB"));
  }
}

TEST_F(Hdf5Layout, LinesThatWereNeverWrittenAreAnError) {
  EXPECT_THAT(
      message_after([](hid_t f) {
        replace_dataset(f, "frf", compound(H5T_NATIVE_DOUBLE), {3, 2, 1}, nullptr, 0, chunks(1, 2, true));
      }),
      HasSubstr("dataset frf: declares"));
}

TEST_F(Hdf5Layout, ADamagedCompressedChunkIsAnError) {
  EXPECT_THAT(message_after([&](hid_t f) {
                replace_frf(f, set_, H5T_NATIVE_DOUBLE, chunks(1, 2, true));
                const hid_t dataset = H5Dopen2(f, "frf", H5P_DEFAULT);
                const std::array<hsize_t, 3> corner = {1, 0, 0};
                H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, corner.data(), 4, "oops");
                H5Dclose(dataset);
              }),
              HasSubstr("dataset frf: line 1 cannot be read: inflate() failed"));
}

TEST_F(Hdf5Layout, NoiseRecordsAreChecked) {
  EXPECT_THAT(message_after([](hid_t f) {
                replace_doubles(f, "coherence", {3, 2, 1}, std::vector<double>(6));
                replace_number(f, "coherence", "averages", {0.5});
              }),
              HasSubstr("dataset coherence: attribute averages is 0.5"));
  EXPECT_THAT(message_after([](hid_t f) {
                replace_doubles(f, "variance", {3, 2, 1}, std::vector<double>(6));
              }),
              HasSubstr("has both variance and coherence"));
  EXPECT_THAT(message_after([](hid_t f) { H5Ldelete(f, "coherence", H5P_DEFAULT); }),
              HasSubstr("dataset variance: does not hold complex numbers"));
}

}  // namespace
}  // namespace jointid::frf
