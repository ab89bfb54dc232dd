#include <gmock/gmock.h>
#include <hdf5.h>

#include <array>
#include <functional>

#include "file_fixture.hpp"
#include "frf/mat/mat_file.hpp"

namespace jointid::frf {
namespace {

using ::testing::HasSubstr;

/// Makes files as MATLAB's save -v7.3 does: a user block, dimensions reversed, classes in attributes.
class MatV73File : public FileTest {
 protected:
  void make(const std::function<void(hid_t)>& fill) const {
    const hid_t create = H5Pcreate(H5P_FILE_CREATE);
    H5Pset_userblock(create, 512);
    const hid_t file = H5Fcreate(path("a.mat").c_str(), H5F_ACC_TRUNC, create, H5P_DEFAULT);
    fill(file);
    H5Fclose(file);
    std::fstream head(path("a.mat"), std::ios::in | std::ios::out | std::ios::binary);
    head << "MATLAB 7.3 MAT-file, Platform: GLNXA64";
  }

  static void set_class(hid_t dataset, const std::string& name) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, name.size());
    const hid_t attribute = H5Acreate2(dataset, "MATLAB_class", type, H5Screate(H5S_SCALAR), H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, type, name.data());
    H5Aclose(attribute);
  }

  static void add(hid_t file, const std::string& name, const std::string& kind, hid_t type, std::vector<hsize_t> dims,
                  const void* data) {
    std::reverse(dims.begin(), dims.end());
    const hid_t space = H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr);
    const hid_t dataset = H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data);
    set_class(dataset, kind);
    H5Dclose(dataset);
  }

  static void add_text(hid_t file, const std::string& name, const std::string& text) {
    const std::vector<std::uint16_t> codes(text.begin(), text.end());
    add(file, name, "char", H5T_NATIVE_UINT16, {1, text.size()}, codes.data());
  }

  static void add_cells(hid_t file, const std::string& name, const std::vector<std::string>& texts) {
    const hid_t group = H5Gcreate2(file, ("#" + name).c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    std::vector<hobj_ref_t> references(texts.size());
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const std::string cell(1, static_cast<char>('a' + i));
      add_text(group, cell, texts[i]);
      H5Rcreate(&references[i], group, cell.c_str(), H5R_OBJECT, -1);
    }
    H5Gclose(group);
    add(file, name, "cell", H5T_STD_REF_OBJ, {texts.size(), 1}, references.data());
  }

  static hid_t complex_type() {
    const hid_t type = H5Tcreate(H5T_COMPOUND, 16);
    H5Tinsert(type, "real", 0, H5T_NATIVE_DOUBLE);
    H5Tinsert(type, "imag", 8, H5T_NATIVE_DOUBLE);
    return type;
  }

  /// 3 lines, 2 responses, 1 reference; values count up in MATLAB's order.
  static void add_set(hid_t file) {
    const std::vector<double> axis = {10.0, 20.0, 30.0};
    std::vector<Complex> values;
    for (int i = 0; i < 6; ++i) values.emplace_back(i, -i);
    add(file, "frequency", "double", H5T_NATIVE_DOUBLE, {3, 1}, axis.data());
    add(file, "FRF", "double", complex_type(), {2, 1, 3}, values.data());
    add_cells(file, "response_dof", {"1:+Y", "2:-Y"});
    add_text(file, "reference_dof", "1:+Y");
    add_text(file, "quantity", "receptance");
  }
};

TEST_F(MatV73File, ReadsWhatMatlabSaves) {
  make(add_set);
  const FrfSet set = load(*open(path("a.mat")));
  EXPECT_EQ(set.header.frequency_hz, (std::vector<double>{10.0, 20.0, 30.0}));
  EXPECT_EQ(set.header.response, dofs({"1:+Y", "2:-Y"}));
  EXPECT_EQ(set.header.reference, dofs({"1:+Y"}));
  for (int i = 0; i < 6; ++i) EXPECT_EQ(set.values[static_cast<std::size_t>(i)], Complex(i, -i));
}

/// UTF-16, NULs behind a text that was shorter.
TEST_F(MatV73File, ReadsLettersBeyondAscii) {
  make([](hid_t file) {
    add_set(file);
    const std::vector<std::uint16_t> unit = {0xB5, 'm', '/', 'N', 0, 0};
    add(file, "unit", "char", H5T_NATIVE_UINT16, {1, unit.size()}, unit.data());
  });
  EXPECT_LE(std::abs(load(*open(path("a.mat"))).values[1] - Complex(1e-6, -1e-6)), 1e-18);
}

/// A field of an array of structs: references to its elements, of which MATLAB says no class.
void add_field(hid_t file, const std::string& name, const std::vector<std::string>& elements) {
  std::vector<hobj_ref_t> references(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) H5Rcreate(&references[i], file, elements[i].c_str(), H5R_OBJECT, -1);
  const std::array<hsize_t, 2> dims = {elements.size(), 1};
  const hid_t dataset = H5Dcreate2(file, name.c_str(), H5T_STD_REF_OBJ, H5Screate_simple(2, dims.data(), nullptr), H5P_DEFAULT,
                                   H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(dataset, H5T_STD_REF_OBJ, H5S_ALL, H5S_ALL, H5P_DEFAULT, references.data());
  H5Dclose(dataset);
}

TEST_F(MatV73File, AnArrayOfStructsIsOneSet) {
  make([](hid_t file) {
    H5Gclose(H5Gcreate2(file, "#refs#", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    H5Gclose(H5Gcreate2(file, "run", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    const std::vector<double> axis = {10.0, 20.0, 30.0};
    add(file, "#refs#/f", "double", H5T_NATIVE_DOUBLE, {3, 1}, axis.data());
    for (const char k : {'a', 'b'}) {
      std::vector<Complex> values;  // [line, response], first index fastest
      for (int i = 0; i < 6; ++i) values.emplace_back(i, k == 'a' ? 1.0 : 2.0);
      const double node = k == 'a' ? 5.0 : 7.0;
      const std::string name = std::string("#refs#/") + k;
      add(file, name + "H", "double", complex_type(), {3, 2}, values.data());
      add(file, name + "n", "double", H5T_NATIVE_DOUBLE, {1, 1}, &node);
      add_text(file, name + "d", "-Y");
    }
    add_field(file, "run/f", {"#refs#/f", "#refs#/f"});
    add_field(file, "run/H", {"#refs#/aH", "#refs#/bH"});
    add_field(file, "run/refNode", {"#refs#/an", "#refs#/bn"});
    add_field(file, "run/refDir", {"#refs#/ad", "#refs#/bd"});
  });
  OpenOptions options;
  options.quantity = Quantity::receptance;
  options.response = dofs({"1:+X", "2:+X"});
  const FrfSet set = load(*open(path("a.mat"), options));
  EXPECT_EQ(set.header.reference, dofs({"5:-Y", "7:-Y"}));
  for (std::size_t l = 0; l < 3; ++l) {
    for (std::size_t r = 0; r < 2; ++r) {
      for (std::size_t c = 0; c < 2; ++c)
        EXPECT_EQ(set.values[set.index(l, r, c)], Complex(static_cast<double>(l + 3 * r), static_cast<double>(c + 1)));
    }
  }
  options.variable = "run(2).H";
  EXPECT_EQ(load(*open(path("a.mat"), options)).header.reference, dofs({"7:-Y"}));
}

TEST_F(MatV73File, CellsMustHoldText) {
  make([](hid_t file) {
    add_set(file);
    H5Ldelete(file, "reference_dof", H5P_DEFAULT);
    const hobj_ref_t nowhere = 0;
    add(file, "reference_dof", "cell", H5T_STD_REF_OBJ, {1, 1}, &nowhere);
  });
  EXPECT_THAT(message_of([&] { open(path("a.mat")); }), HasSubstr("dataset reference_dof, cell 1: cannot be opened"));
  make([](hid_t file) {
    add_set(file);
    H5Ldelete(file, "reference_dof", H5P_DEFAULT);
    hobj_ref_t number = 0;
    H5Rcreate(&number, file, "frequency", H5R_OBJECT, -1);
    add(file, "reference_dof", "cell", H5T_STD_REF_OBJ, {1, 1}, &number);
  });
  EXPECT_THAT(message_of([&] { open(path("a.mat")); }), HasSubstr("dataset reference_dof, cell 1: is not text"));
}

TEST_F(MatV73File, AnyOtherHdf5FileSaysWhatItHolds) {
  make([](hid_t file) {
    const std::vector<double> numbers(4);
    add(file, "numbers", "double", H5T_NATIVE_DOUBLE, {2, 2}, numbers.data());
  });
  EXPECT_THAT(message_of([&] { open(path("a.mat")); }),
              HasSubstr("has no vector of frequencies; its variables are numbers [2x2]"));
}

}  // namespace
}  // namespace jointid::frf
