#include "oscillation/pod/fraction_error.hpp"

#include <cmath>
#include <string>

#include "base/error.hpp"

namespace jointid::oscillation {

Fractions square_fractions(const Eigen::Ref<const Samples>& record, std::size_t blocks, const PodOptions& options) {
  const Eigen::Index size = blocks < 2 ? 0 : record.rows() / at(blocks);
  if (size == 0) {
    throw InputError({ErrorKind::usage, "", "record",
                      "has " + std::to_string(record.rows()) + " samples for errors of its shares", "take at least 20"});
  }
  std::vector<RecordTriangle> parts(blocks, RecordTriangle(static_cast<std::size_t>(record.cols())));
  for (std::size_t b = 0; b < blocks; ++b) {
    const Eigen::Index first = at(b) * size;
    parts[b].add(record.middleRows(first, b + 1 == blocks ? record.rows() - first : size));
  }
  const auto without = [&](std::size_t left) {
    RecordTriangle joined(static_cast<std::size_t>(record.cols()));
    for (std::size_t b = 0; b < blocks; ++b) {
      if (b != left) joined.join(parts[b]);
    }
    return pod(joined, options).square_fractions();
  };
  Fractions out{without(blocks), {}};
  Eigen::MatrixXd shares(record.cols(), at(blocks));
  for (std::size_t b = 0; b < blocks; ++b) shares.col(at(b)) = without(b);
  const double share = static_cast<double>(blocks - 1) / static_cast<double>(blocks);
  out.error = ((shares.colwise() - shares.rowwise().mean().eval()).array().square().rowwise().sum() * share).sqrt();
  return out;
}

}  // namespace jointid::oscillation
