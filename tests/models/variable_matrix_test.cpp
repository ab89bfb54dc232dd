// Matrices among the arrays of files that scipy and numpy wrote (tests/models/foreign/make.py).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <fstream>
#include <iterator>

#include "base/error.hpp"
#include "frf/file/columns.hpp"
#include "frf/file/variables.hpp"
#include "frf/mat/mat_module.hpp"
#include "models/files/matrix_file.hpp"
#include "models/model_file.hpp"
#include "tests/require.hpp"
#include "tests/test_folder.hpp"

namespace jointid::models {
namespace {

using testing::HasSubstr;

std::filesystem::path foreign(const std::string& name) { return std::filesystem::path(JOINTID_FOREIGN_MATRICES) / name; }

Eigen::MatrixXd sample() {
  Eigen::MatrixXd m(4, 4);
  m << 2.0, -1.0, 0.0, 5.0, -1.0, 3.0, 0.0, 0.0, 0.0, 0.0, 4.0, 0.5, 5.0, 0.0, 0.5, 6.0;
  return m;
}

void expect_sample(const std::string& file, const std::string& variable = {}, double factor = 1.0) {
  const FileMatrix read = read_file_matrix(foreign(file), variable);
  EXPECT_EQ(Eigen::MatrixXd(read.real), factor * sample()) << file << ' ' << variable;
  EXPECT_EQ(read.imaginary.rows(), 0) << file << ' ' << variable;
  EXPECT_TRUE(read.labels.empty());
}

void expect_lossy(const std::string& file, const std::string& variable) {
  const FileMatrix read = read_file_matrix(foreign(file), variable);
  EXPECT_EQ(Eigen::MatrixXd(read.real), sample()) << file << ' ' << variable;
  EXPECT_LT((Eigen::MatrixXd(read.imaginary) - 0.02 * sample()).cwiseAbs().maxCoeff(), 1e-15) << file << ' ' << variable;
}

std::string error(const std::filesystem::path& file, const std::string& variable = {}) {
  try {
    read_file_matrix(file, variable);
  } catch (const InputError& refused) {
    return refused.what();
  }
  return "accepted";
}

TEST(VariableMatrix, SparseOfMatlabV5) {
  if (!frf::has_matio()) JOINTID_SKIP("this build lacks matio");
  expect_sample("sparse_v5.mat", "K");
  expect_sample("sparse_v5.mat", "model.M", 2.0);
  expect_sample("packed_v5.mat");
  expect_lossy("sparse_v5.mat", "D");
  expect_lossy("sparse_v5.mat", "full");
  const Eigen::MatrixXd flags = read_file_matrix(foreign("sparse_v5.mat"), "flags").real;
  EXPECT_EQ(flags, sample().unaryExpr([](double value) { return value != 0.0 ? 1.0 : 0.0; }));
  EXPECT_THAT(error(foreign("sparse_v5.mat"), "wide"), HasSubstr("the matrix is not square: 2 × 4"));
  EXPECT_THAT(error(foreign("sparse_v5.mat")), HasSubstr("the file holds several matrices: D, K, flags, model.M, wide, full"));
  EXPECT_THAT(error(foreign("sparse_v5.mat"), "frequency"), HasSubstr("the matrix is not square: 1 × 3"));
  EXPECT_THAT(error(foreign("sparse_v5.mat"), "k"), HasSubstr("there is no such matrix"));
}

/// Its elements may be fewer than the file has room for, and are no samples.
TEST(VariableMatrix, SparseArraysAreNoChannels) {
  if (!frf::has_matio()) JOINTID_SKIP("this build lacks matio");
  for (const std::string name : {"sparse_v5.mat", "sparse_v4.mat"}) {
    const auto file = frf::open_variables(foreign(name));
    for (const frf::MatInfo& info : file->variables()) {
      const std::string part = info.name.substr(std::min(info.name.find_last_of('.'), info.name.size()));
      const bool sparse =
          part == ".data" || part == ".ir" || part == ".jc" || part == ".row" || part == ".col" || part == ".shape";
      EXPECT_EQ(info.kind == frf::MatKind::sparse, sparse) << name << ' ' << info.name;
    }
  }
  std::vector<std::string> names;
  for (const frf::NumberColumn& column : frf::read_columns(foreign("sparse_v5.mat")).columns) names.push_back(column.name);
  EXPECT_EQ(names, (std::vector<std::string>{"frequency"}));
}

TEST(VariableMatrix, SparseOfMatlabV4) {
  expect_sample("sparse_v4.mat", "K");
  expect_lossy("sparse_v4.mat", "D");
  EXPECT_THAT(error(foreign("sparse_v4.mat"), "wide"), HasSubstr("not square: 2 × 4"));
}

/// As MATLAB writes them, a group of data, ir and jc whose attribute MATLAB_sparse has the rows.
TEST(VariableMatrix, SparseOfMatlabV73) {
  expect_sample("sparse_v73.mat", "K");
  expect_sample("sparse_v73.mat", "model.M", 2.0);
  expect_sample("sparse_v73.mat", "full");
  expect_lossy("sparse_v73.mat", "D");
  const Eigen::MatrixXd flags = read_file_matrix(foreign("sparse_v73.mat"), "flags").real;
  EXPECT_EQ(flags, sample().unaryExpr([](double value) { return value != 0.0 ? 1.0 : 0.0; }));
  EXPECT_EQ(Eigen::MatrixXd(read_file_matrix(foreign("sparse_v73.mat"), "zero").real), Eigen::MatrixXd::Zero(4, 4));
  EXPECT_THAT(error(foreign("sparse_v73.mat"), "wide"), HasSubstr("variable wide: the matrix is not square: 2 × 4"));
  EXPECT_THAT(error(foreign("sparse_v73.mat"), "tall"), HasSubstr("the matrix is not square: 4 × 2"));
  EXPECT_THAT(error(foreign("sparse_v73.mat"), "none"), HasSubstr("there is no such matrix"));
  EXPECT_THAT(error(foreign("sparse_v73.mat"), "cut"), HasSubstr("it is a sparse matrix without numbers ir"));
}

TEST(VariableMatrix, SparseOfScipy) {
  expect_sample("csc.npz");
  expect_sample("coo.npz");
  expect_sample("twice.npz");
  for (const std::string name : {"bsr.npz", "dia.npz"})
    EXPECT_THAT(error(foreign(name)), HasSubstr("in Python by tocsc()")) << name;
  if (!frf::has_matio()) JOINTID_SKIP("this build lacks matio, with which zlib comes");
  expect_sample("csr.npz");
}

TEST(VariableMatrix, FullOfNumpy) {
  expect_sample("K.npy");
  expect_sample("K.npy", "K");
  expect_sample("model.npz", "M", 2.0);
  expect_lossy("model.npz", "lossy");
  EXPECT_THAT(error(foreign("model.npz")), HasSubstr("several matrices: K, M, lossy"));
}

TEST(VariableMatrix, CutOffFilesAreErrors) {
  const TestFolder folder;
  for (const std::string name : {"sparse_v5.mat", "packed_v5.mat", "sparse_v4.mat", "csc.npz", "K.npy"}) {
    std::ifstream in(foreign(name), std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(in), {}};
    for (std::size_t size = 1; size < whole.size(); size += 7) {
      std::ofstream(folder / name, std::ios::binary) << whole.substr(0, size);
      EXPECT_THROW(read_file_matrix(folder / name, name[0] == 's' ? "wide" : ""), InputError) << name << ' ' << size;
    }
  }
}

/// A part whose matrices, shapes and names of DOFs are arrays of numpy.
TEST(VariableMatrix, ModelOfNumpy) {
  const TestFolder folder;
  std::ofstream(folder / "part.toml") << "stiffness = \"" << foreign("part.npz").string() << ":lossy\"\nmass = \""
                                      << foreign("part.npz").string() << ":M\"\ndofs = \"" << foreign("part.npz").string()
                                      << "\"\n";
  const NamedModel model = read_model(folder / "part.toml");
  EXPECT_EQ(frf::names(model.coordinates.dofs), (std::vector<std::string>{"4:+Y", "5:+Y", "6:+Y", "7:+Y"}));
  const double omega = 0.3;
  const std::vector<std::size_t> all = {0, 1, 2, 3};
  const auto h = model.model->receptance(omega, all, all);
  ASSERT_TRUE(h);
  const Eigen::MatrixXcd z = (Complex(1.0, 0.02) - 2.0 * omega * omega) * (sample() + 4.0 * Eigen::MatrixXd::Identity(4, 4));
  EXPECT_LT((z * *h - Eigen::MatrixXcd::Identity(4, 4)).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace jointid::models
