#include "tasks/response/level_state.hpp"

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace jointid::tasks {
namespace {

class Written {
 public:
  std::string bytes;

 protected:
  void raw(const void* value, std::size_t size) { bytes.append(static_cast<const char*>(value), size); }
  bool holds(std::uint64_t) const { return true; }
};

class Read {
 public:
  std::string_view bytes;
  bool whole = true;  ///< until a value is missing: then it and all that follow are 0

 protected:
  void raw(void* value, std::size_t size) {
    whole = whole && bytes.size() >= size;
    if (!whole) {
      std::memset(value, 0, size);
      return;
    }
    std::memcpy(value, bytes.data(), size);
    bytes.remove_prefix(size);
  }
  /// Whether so many things may follow, of a byte at least.
  bool holds(std::uint64_t count) {
    whole = whole && count <= bytes.size();
    return whole;
  }
};

/// Visits every value of what it is called with, in one order for both ways.
template <class Way>
class Archive : public Way {
 public:
  template <class T>
    requires std::is_arithmetic_v<T> || std::is_enum_v<T> || std::same_as<T, Complex>
  void operator()(T& value) {
    this->raw(&value, sizeof value);
  }

  void operator()(std::string& text) { each(text); }

  template <class T>
  void operator()(std::vector<T>& values) {
    each(values);
  }

  template <class T>
  void operator()(std::optional<T>& value) {
    auto there = static_cast<std::uint8_t>(value.has_value());
    (*this)(there);
    if (there == 0) return;
    if (!value) value.emplace();
    (*this)(*value);
  }

  template <class T, int Rows, int Columns>
  void operator()(Eigen::Matrix<T, Rows, Columns>& matrix) {
    auto rows = static_cast<std::uint64_t>(matrix.rows()), columns = static_cast<std::uint64_t>(matrix.cols());
    all(rows, columns);
    if ((columns > 0 && rows > UINT64_MAX / columns) || !this->holds(rows * columns)) return;
    matrix.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
    for (T& value : matrix.reshaped()) (*this)(value);
  }

  void operator()(response::DroppedHarmonic& it) { all(it.harmonic, it.force, it.motion); }
  void operator()(response::HarmonicSolution& it) {
    all(it.converged, it.start, it.steps, it.residual, it.omega, it.level, it.harmonics, it.joint_motion, it.joint_force, it.response,
        it.loss, it.next, it.dropped);
  }
  void operator()(response::ResponseDeviations& it) { all(it.parts, it.amplitude); }
  void operator()(response::PeakMode& it) { all(it.omega, it.ratio); }
  void operator()(response::JointLoop& it) { all(it.displacement, it.force); }
  void operator()(PointStability& it) {
    all(it.known, it.stable, it.another, it.largest, it.difference, it.multipliers, it.residual_force_free);
  }
  void operator()(LevelResponse& it) {
    all(it.level, it.points, it.deviations, it.left_out, it.peak_deviation, it.peak, it.refined, it.peak_mode, it.line_spacing_hz,
        it.stability, it.peak_stability, it.loops, it.turning_points, it.complete);
  }
  void operator()(LevelsSoFar& it) { all(it.finished, it.begun); }

 private:
  template <class... T>
  void all(T&... values) {
    ((*this)(values), ...);
  }

  template <class Container>
  void each(Container& values) {
    auto count = static_cast<std::uint64_t>(values.size());
    (*this)(count);
    if (!this->holds(count)) return;
    values.resize(count);
    for (auto& value : values) (*this)(value);
  }
};

}  // namespace

std::string packed_levels(LevelsSoFar levels) {
  Archive<Written> archive;
  archive(levels);
  return std::move(archive.bytes);
}

std::optional<LevelsSoFar> unpacked_levels(std::string_view bytes) {
  Archive<Read> archive;
  archive.bytes = bytes;
  LevelsSoFar levels;
  archive(levels);
  if (!archive.whole || !archive.bytes.empty()) return std::nullopt;
  return levels;
}

}  // namespace jointid::tasks
