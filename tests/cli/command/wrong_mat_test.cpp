#include <matio.h>

#include "wrong_input.hpp"

namespace jointid::cli {
namespace {

/// A complex 3×2 matrix in a MATLAB file; a vector of three frequencies under the name f.
void add_complex(mat_t* file, const char* name) {
  std::size_t dims[] = {3, 2};
  std::vector<double> re = {1, 2, 3, 4, 5, 6}, im = re;
  mat_complex_split_t split{re.data(), im.data()};
  matvar_t* variable = Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, &split, MAT_F_COMPLEX);
  Mat_VarWrite(file, variable, MAT_COMPRESSION_NONE);
  Mat_VarFree(variable);
}

void add_frequencies(mat_t* file) {
  std::size_t dims[] = {3, 1};
  std::vector<double> hz = {10, 20, 30};
  matvar_t* variable = Mat_VarCreate("f", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, hz.data(), 0);
  Mat_VarWrite(file, variable, MAT_COMPRESSION_NONE);
  Mat_VarFree(variable);
}

/// a.mat with these complex matrices, with frequencies or without.
Spoil mat(std::vector<const char*> matrices, bool frequencies = true) {
  return [=](const InputFolder& folder) {
    mat_t* file = Mat_CreateVer(folder.path("a.mat").c_str(), nullptr, MAT_FT_MAT5);
    if (frequencies) add_frequencies(file);
    for (const char* name : matrices) add_complex(file, name);
    Mat_Close(file);
  };
}

/// Reading a.mat with all that the file does not say, but `without` (an option) and its value.
std::vector<std::string> convert_mat(const std::string& without = "") {
  std::vector<std::string> words = convert("a.mat");
  for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{
           {"--quantity", "receptance"}, {"--response", "1:+Y,2:+Y"}, {"--reference", "1:+Y"}}) {
    if (option != without) words.insert(words.end(), {option, value});
  }
  return words;
}

const Wrong mat_files[] = {
    {"NoFrfs", mat({}), convert_mat(), 3, {"a.mat: ", "no complex array with an axis of 3 lines", "f [3x1]", "add one named frf"}},
    {"SeveralMatrices", mat({"H", "G"}), convert_mat(), 3, {"a.mat: ", "several variables", "H", "G", "name one of them"}},
    {"NoFrequencies", mat({"H"}, false), convert_mat(), 3, {"a.mat: ", "no vector of frequencies", "H"}},
    {"NoQuantity", mat({"H"}), convert_mat("--quantity"), 3, {"a.mat: ", "does not state which quantity", "quantity"}},
    {"NoDofs", mat({"H"}), convert_mat("--response"), 3, {"a.mat: ", "does not state at which DOFs H was measured"}},
    {"Truncated", both(mat({"H"}), cut("a.mat", 300)), convert_mat(), 3, {"a.mat: ", "damaged or truncated"}},
};
INSTANTIATE_TEST_SUITE_P(Mat, WrongInput, testing::ValuesIn(mat_files), name_of);

}  // namespace
}  // namespace jointid::cli
