#include "oscillation/pod/record_triangle.hpp"

#include <algorithm>
#include <string>
#include <system_error>
#include <thread>

#include "base/error.hpp"
#include "dense/qr.hpp"

namespace jointid::oscillation {
namespace {

constexpr std::size_t block_rows = 4096;  ///< of one thread

InputError other_channels() { return InputError({ErrorKind::data, "", "records", "differ in channels", ""}); }

/// Reads until the block is full or the record ends; how many rows it has then, whatever the reader hands out at once.
std::size_t fill(Samples& block, const NextSamples& next) {
  const auto channels = static_cast<std::size_t>(block.cols());
  std::size_t rows = 0;
  while (rows < block_rows) {
    const std::size_t got = next({block.data() + rows * channels, (block_rows - rows) * channels});
    if (got == 0) break;
    rows += got;
  }
  return rows;
}

}  // namespace

RecordTriangle::RecordTriangle(std::size_t channels) : rows_(channels) {
  if (channels == 0) throw InputError({ErrorKind::data, "", "record", "has no channels", ""});
}

void RecordTriangle::add(const Eigen::Ref<const Samples>& block) {
  if (static_cast<std::size_t>(block.cols()) != channels()) {
    throw InputError({ErrorKind::data, "", "record",
                      "has " + std::to_string(block.cols()) + " channels after blocks of " + std::to_string(channels()), ""});
  }
  for (Eigen::Index i = 0; i < block.rows(); ++i) ++(rows_.push(1.0, block.row(i).data()) ? samples_ : missing_);
  rows_.flush();
}

void RecordTriangle::join_rows(double corner, const double* top, const RowMatrixXd& triangle) {
  rows_.push(corner, top);
  for (Eigen::Index i = 0; i < triangle.rows(); ++i) rows_.push(0.0, triangle.row(i).data());
  rows_.flush();
}

void RecordTriangle::join(const RecordTriangle& other) {
  if (other.channels() != channels()) throw other_channels();
  samples_ += other.samples_;
  missing_ += other.missing_;
  if (other.samples_ == 0) return;
  const Eigen::VectorXd top = other.top();
  join_rows(other.rows_.corner(), top.data(), other.centred());
}

std::vector<double> RecordTriangle::numbers() const {
  std::vector<double> out = {static_cast<double>(samples_), static_cast<double>(missing_), rows_.corner()};
  const Eigen::VectorXd first = top();
  const RowMatrixXd rest = centred();
  out.insert(out.end(), first.data(), first.data() + first.size());
  out.insert(out.end(), rest.data(), rest.data() + rest.size());
  return out;
}

RecordTriangle RecordTriangle::of_numbers(std::size_t channels, const std::vector<double>& numbers) {
  RecordTriangle out(channels);
  if (numbers.size() != 3 + channels + channels * channels) throw other_channels();
  out.samples_ = static_cast<std::size_t>(numbers[0]);
  out.missing_ = static_cast<std::size_t>(numbers[1]);
  const double* top = numbers.data() + 3;
  out.join_rows(numbers[2], top, Eigen::Map<const RowMatrixXd>(top + channels, at(channels), at(channels)));
  return out;
}

Eigen::VectorXd RecordTriangle::top() const {
  Eigen::VectorXd out(at(channels()));
  for (std::size_t j = 0; j < channels(); ++j) out(at(j)) = rows_.top(j);
  return out;
}

Eigen::VectorXd RecordTriangle::mean() const {
  if (samples_ == 0) return Eigen::VectorXd::Zero(at(channels()));
  return top() / rows_.corner();
}

Eigen::MatrixXd RecordTriangle::centred() const {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(at(channels()), at(channels()));
  for (std::size_t j = 0; j < channels(); ++j) {
    for (std::size_t i = 0; i <= j; ++i) out(at(i), at(j)) = rows_(i, j);
  }
  return out;
}

Eigen::MatrixXd RecordTriangle::uncentred() const {
  Eigen::MatrixXd all(at(channels()) + 1, at(channels()));
  all << top().transpose(), centred();
  return dense::triangle_of(all);
}

namespace {

/// False where the system gives no further thread.
template <class Work>
bool begin(std::vector<std::jthread>& workers, const Work& work) {
  try {
    workers.emplace_back(work);
    return true;
  } catch (const std::system_error&) {
    return false;
  }
}

}  // namespace

RecordTriangle record_triangle(std::size_t channels, const NextSamples& next, std::size_t threads) {
  RecordTriangle whole(channels);
  threads = std::max<std::size_t>(threads, 1);
  std::vector<Samples> blocks(threads, Samples(at(block_rows), at(channels)));
  for (bool more = true; more;) {
    std::vector<RecordTriangle> parts(threads, RecordTriangle(channels));
    std::vector<std::jthread> workers;
    std::size_t used = 0;
    for (; used < threads && more; ++used) {
      const std::size_t rows = fill(blocks[used], next);
      more = rows == block_rows;
      const auto work = [&parts, &blocks, used, rows] { parts[used].add(blocks[used].topRows(at(rows))); };
      const bool alone = threads == 1 || !begin(workers, work);
      if (alone) work();
    }
    workers.clear();
    for (std::size_t k = 0; k < used; ++k) whole.join(parts[k]);
  }
  return whole;
}

}  // namespace jointid::oscillation
