#include "series/pod/record_triangle.hpp"

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

#include "base/error.hpp"
#include "dense/qr.hpp"
#include "series/pod/tall_triangle.hpp"

namespace jointid::series {
namespace {

constexpr Eigen::Index block_rows = 4096;  ///< of one thread
constexpr Eigen::Index step_rows = 1024;   ///< of one decomposition: what it works on stays near the processor

}  // namespace

RecordTriangle::RecordTriangle(std::size_t channels) : triangle_(Eigen::MatrixXd::Zero(at(channels) + 1, at(channels) + 1)) {
  if (channels == 0) throw InputError({ErrorKind::data, "", "record", "has no channels", ""});
}

void RecordTriangle::add(const Eigen::Ref<const Samples>& block) {
  if (block.cols() + 1 != triangle_.cols()) {
    throw InputError({ErrorKind::data, "", "record",
                      "has " + std::to_string(block.cols()) + " channels after blocks of " + std::to_string(channels()), ""});
  }
  const Eigen::Index size = triangle_.cols();
  for (Eigen::Index first = 0; first < block.rows(); first += step_rows) {
    const Eigen::Index count = std::min(step_rows, block.rows() - first);
    const auto rows = block.middleRows(first, count);
    Eigen::MatrixXd stacked(size + count, size);
    Eigen::Index kept = count;
    if (rows.allFinite()) {
      stacked.bottomRightCorner(count, block.cols()) = rows;
    } else {
      kept = 0;
      for (Eigen::Index i = 0; i < count; ++i) {
        if (rows.row(i).allFinite()) stacked.row(size + kept++).tail(block.cols()) = rows.row(i);
      }
    }
    samples_ += static_cast<std::size_t>(kept);
    missing_ += static_cast<std::size_t>(count - kept);
    if (kept == 0) continue;
    stacked.topRows(size) = triangle_;
    stacked.col(0).segment(size, kept).setOnes();
    if (kept < count) stacked.conservativeResize(size + kept, Eigen::NoChange);
    triangle_ = tall_triangle(stacked);
  }
}

void RecordTriangle::join(const RecordTriangle& other) {
  if (other.triangle_.cols() != triangle_.cols()) throw InputError({ErrorKind::data, "", "records", "differ in channels", ""});
  samples_ += other.samples_;
  missing_ += other.missing_;
  if (other.samples_ == 0) return;
  Eigen::MatrixXd stacked(2 * triangle_.rows(), triangle_.cols());
  stacked << triangle_, other.triangle_;
  triangle_ = tall_triangle(stacked);
}

std::vector<double> RecordTriangle::numbers() const {
  std::vector<double> out = {static_cast<double>(samples_), static_cast<double>(missing_)};
  out.insert(out.end(), triangle_.data(), triangle_.data() + triangle_.size());
  return out;
}

RecordTriangle RecordTriangle::of_numbers(std::size_t channels, const std::vector<double>& numbers) {
  RecordTriangle out(channels);
  if (at(numbers.size()) != out.triangle_.size() + 2)
    throw InputError({ErrorKind::data, "", "records", "differ in channels", ""});
  out.samples_ = static_cast<std::size_t>(numbers[0]);
  out.missing_ = static_cast<std::size_t>(numbers[1]);
  std::copy(numbers.begin() + 2, numbers.end(), out.triangle_.data());
  return out;
}

Eigen::VectorXd RecordTriangle::mean() const {
  if (samples_ == 0) return Eigen::VectorXd::Zero(at(channels()));
  return triangle_.row(0).tail(at(channels())).transpose() / triangle_(0, 0);
}

Eigen::MatrixXd RecordTriangle::centred() const { return triangle_.bottomRightCorner(at(channels()), at(channels())); }

Eigen::MatrixXd RecordTriangle::uncentred() const { return dense::triangle_of(triangle_.rightCols(at(channels()))); }

RecordTriangle record_triangle(std::size_t channels, const NextSamples& next, std::size_t threads) {
  RecordTriangle whole(channels);
  threads = std::max<std::size_t>(threads, 1);
  std::vector<Samples> blocks(threads, Samples(block_rows, at(channels)));
  for (bool more = true; more;) {
    std::vector<RecordTriangle> parts(threads, RecordTriangle(channels));
    std::vector<std::jthread> workers;
    std::size_t used = 0;
    for (; used < threads && more; ++used) {
      Eigen::Index rows = 0;
      while (rows < block_rows) {  // whole blocks, whatever the reader hands out
        Samples rest(block_rows - rows, at(channels));
        const auto got = at(next(rest));
        if (got == 0) break;
        blocks[used].middleRows(rows, got) = rest.topRows(got);
        rows += got;
      }
      more = rows == block_rows;
      const auto work = [&parts, &blocks, used, rows] { parts[used].add(blocks[used].topRows(rows)); };
      if (threads == 1) {
        work();
      } else {
        workers.emplace_back(work);
      }
    }
    workers.clear();
    for (std::size_t k = 0; k < used; ++k) whole.join(parts[k]);
  }
  return whole;
}

}  // namespace jointid::series
