#include "models/files/file_matrix.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "models/files/failure.hpp"

namespace jointid::models {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

std::string place_of(int row, int column) {
  return "element (" + std::to_string(row + 1) + ", " + std::to_string(column + 1) + ")";
}

}  // namespace

Sparse FileElements::filled(const Triplets& from, std::size_t n, Mirror mirror) const {
  const auto size = static_cast<Eigen::Index>(n);
  Sparse listed(size, size), counts(size, size);
  listed.setFromTriplets(from.begin(), from.end());
  if (static_cast<std::size_t>(listed.nonZeros()) != from.size()) {
    Triplets ones;
    for (const auto& each : from) ones.emplace_back(each.row(), each.col(), 1.0);
    counts.setFromTriplets(ones.begin(), ones.end());
    for (Eigen::Index j = 0; j < size; ++j) {
      for (Sparse::InnerIterator entry(counts, j); entry; ++entry) {
        if (entry.value() > 1.5)
          refuse_file(file_, place_of(static_cast<int>(entry.row()), static_cast<int>(j)), "it is listed twice",
                      "write the file again");
      }
    }
  }
  if (mirror == Mirror::none) return listed;
  const Sparse transposed = listed.transpose();
  Triplets missing;
  for (Eigen::Index j = 0; j < size; ++j) {
    Sparse::InnerIterator own(listed, j);
    for (Sparse::InnerIterator other(transposed, j); other; ++other) {
      while (own && own.row() < other.row()) ++own;
      const bool there = own && own.row() == other.row();
      if (there && mirror == Mirror::always && other.row() != j)
        refuse_file(file_, place_of(static_cast<int>(other.row()), static_cast<int>(j)),
                    "a symmetric matrix lists it in both triangles", "list one of them");
      if (!there) missing.emplace_back(static_cast<int>(other.row()), static_cast<int>(j), other.value());
    }
  }
  Sparse rest(size, size);
  rest.setFromTriplets(missing.begin(), missing.end());
  return listed + rest;
}

FileMatrix FileElements::matrix(std::size_t n, Mirror mirror, std::vector<RowLabel> labels) const {
  FileMatrix out{filled(real_, n, mirror), {}, std::move(labels)};
  if (!imaginary_.empty()) out.imaginary = filled(imaginary_, n, mirror);
  return out;
}

bool parse_real(std::string text, double& value) {
  std::erase(text, ' ');
  if (text.starts_with('+')) text.erase(0, 1);
  std::ranges::replace_if(
      text, [](char c) { return c == 'D' || c == 'd' || c == 'e'; }, 'E');
  const std::size_t sign = text.find_first_of("+-", 1);
  if (text.find('E') == std::string::npos && sign != std::string::npos) text.insert(sign, "E");
  if (const std::size_t plus = text.find("E+"); plus != std::string::npos) text.erase(plus + 1, 1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

}  // namespace jointid::models
