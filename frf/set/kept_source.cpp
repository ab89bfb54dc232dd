#include "frf/set/kept_source.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <unordered_map>

namespace jointid::frf {

/// Values of some FRFs on some lines: those that were read.
template <class T>
class KeptSource::Values {
 public:
  using Reader = std::function<void(const Block&, std::span<T>)>;

  explicit Values(const FrfHeader& header) : columns_(header.reference.size()), slot_(header.entries(), none) {}

  /// Reads what is not there by `reader`, in blocks that hold nothing else, and keeps it while there is room.
  void read(const Block& block, std::span<T> out, const Reader& reader, std::size_t& room) {
    const std::size_t size = block.responses.size() * block.references.size();
    for (std::size_t first = 0; first < block.lines.size();) {
      const std::vector<bool> missing = missing_of(block, first);
      std::size_t end = first + 1;
      while (end < block.lines.size() && missing_of(block, end) == missing) ++end;
      const Block part{block.lines.subspan(first, end - first), block.responses, block.references};
      const std::span<T> values = out.subspan(first * size, (end - first) * size);
      if (std::ranges::find(missing, false) == missing.end()) {
        reader(part, values);
        keep(part, values, room);
      } else {
        copy_known(part, values);
        read_missing(part, missing, values, reader, room);
      }
      first = end;
    }
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  struct Line {
    std::vector<T> value;
    std::vector<bool> known;
  };

  std::size_t entry(const Block& block, std::size_t r, std::size_t c) const {
    return block.responses[r] * columns_ + block.references[c];
  }

  bool is_known(const Line& line, std::size_t entry) const {
    const std::uint32_t slot = slot_[entry];
    return slot < line.known.size() && line.known[slot];
  }

  std::vector<bool> missing_of(const Block& block, std::size_t i) const {
    std::vector<bool> missing(block.responses.size() * block.references.size(), true);
    const auto line = lines_.find(block.lines[i]);
    if (line == lines_.end()) return missing;
    for (std::size_t k = 0; k < missing.size(); ++k) {
      missing[k] = !is_known(line->second, entry(block, k / block.references.size(), k % block.references.size()));
    }
    return missing;
  }

  void copy_known(const Block& block, std::span<T> out) const {
    std::size_t next = 0;
    for (const std::size_t l : block.lines) {
      const auto line = lines_.find(l);
      for (std::size_t r = 0; r < block.responses.size(); ++r) {
        for (std::size_t c = 0; c < block.references.size(); ++c, ++next) {
          const std::size_t at = entry(block, r, c);
          if (line != lines_.end() && is_known(line->second, at)) out[next] = line->second.value[slot_[at]];
        }
      }
    }
  }

  /// Rows that lack the same columns in one go.
  void read_missing(const Block& block, const std::vector<bool>& missing, std::span<T> out, const Reader& reader,
                    std::size_t& room) {
    const std::size_t rows = block.responses.size(), columns = block.references.size();
    std::map<std::vector<std::size_t>, std::vector<std::size_t>> rows_that_lack;
    for (std::size_t r = 0; r < rows; ++r) {
      std::vector<std::size_t> lacks;
      for (std::size_t c = 0; c < columns; ++c) {
        if (missing[r * columns + c]) lacks.push_back(c);
      }
      if (!lacks.empty()) rows_that_lack[lacks].push_back(r);
    }
    for (const auto& [some_columns, some_rows] : rows_that_lack) {
      std::vector<std::size_t> responses, references;
      for (const std::size_t r : some_rows) responses.push_back(block.responses[r]);
      for (const std::size_t c : some_columns) references.push_back(block.references[c]);
      const Block part{block.lines, responses, references};
      std::vector<T> values(part.size());
      reader(part, values);
      keep(part, values, room);
      std::size_t next = 0;
      for (std::size_t l = 0; l < block.lines.size(); ++l) {
        for (const std::size_t r : some_rows) {
          for (const std::size_t c : some_columns) out[(l * rows + r) * columns + c] = values[next++];
        }
      }
    }
  }

  void keep(const Block& block, std::span<const T> values, std::size_t& room) {
    if (values.size_bytes() > room) return;
    room -= values.size_bytes();
    for (const std::size_t r : block.responses) {
      for (const std::size_t c : block.references) {
        std::uint32_t& slot = slot_[r * columns_ + c];
        if (slot == none) slot = slots_++;
      }
    }
    std::size_t next = 0;
    for (const std::size_t l : block.lines) {
      Line& line = lines_[l];
      line.value.resize(slots_);
      line.known.resize(slots_, false);
      for (std::size_t r = 0; r < block.responses.size(); ++r) {
        for (std::size_t c = 0; c < block.references.size(); ++c) {
          const std::uint32_t slot = slot_[entry(block, r, c)];
          line.value[slot] = values[next++];
          line.known[slot] = true;
        }
      }
    }
  }

  std::size_t columns_;
  std::vector<std::uint32_t> slot_;  ///< of an FRF, in the order in which they were first read
  std::uint32_t slots_ = 0;
  std::unordered_map<std::size_t, Line> lines_;
};

KeptSource::KeptSource(std::unique_ptr<FrfSource> source) : source_(std::move(source)) { header_ = source_->header(); }

KeptSource::~KeptSource() = default;

void KeptSource::keep(std::size_t bytes) {
  if (frfs_) return;
  room_ = bytes;
  frfs_ = std::make_unique<Values<Complex>>(header_);
  if (header_.noise == NoiseRecord::variance) variances_ = std::make_unique<Values<Complex>>(header_);
  if (header_.noise == NoiseRecord::coherence) coherences_ = std::make_unique<Values<double>>(header_);
}

void KeptSource::do_read(const Block& block, std::span<Complex> out) {
  if (!frfs_) return source_->read(block, out);
  frfs_->read(
      block, out, [this](const Block& part, std::span<Complex> values) { source_->read(part, values); }, room_);
}

void KeptSource::do_read_variance(const Block& block, std::span<Complex> out) {
  if (!variances_) return source_->read_variance(block, out);
  variances_->read(
      block, out, [this](const Block& part, std::span<Complex> values) { source_->read_variance(part, values); }, room_);
}

void KeptSource::do_read_coherence(const Block& block, std::span<double> out) {
  if (!coherences_) return source_->read_coherence(block, out);
  coherences_->read(
      block, out, [this](const Block& part, std::span<double> values) { source_->read_coherence(part, values); }, room_);
}

}  // namespace jointid::frf
