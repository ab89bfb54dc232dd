#include "frf/uff/uff_file.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <unordered_map>

#include "base/temporary_file.hpp"
#include "base/text.hpp"
#include "frf/text/plain_text.hpp"
#include "frf/uff/uff_catalogue.hpp"
#include "frf/uff/uff_catalogue_builder.hpp"
#include "frf/uff/uff_text.hpp"

namespace jointid::frf {
namespace {

/// What is read ahead of all records of a block together, where its lines are read one after another.
constexpr std::size_t ahead_bytes = std::size_t{32} << 20;

/// So much of text is held in memory; the numbers of larger files go through a temporary one.
constexpr std::size_t kept_bytes = std::size_t{16} << 20;

class UffSource final : public FrfSource {
 public:
  UffSource(const std::filesystem::path& path, const OpenOptions& options)
      : file_(path), catalogue_(uff::build_catalogue(file_, options)), spool_(file_.name()) {
    header_ = catalogue_.header;
    std::uint64_t text_points = 0;
    for (const auto& [entry, record] : catalogue_.grid) {
      const uff::Dataset& dataset = catalogue_.datasets[record.dataset];
      if (!dataset.binary) text_points += dataset.function->points;
    }
    is_spooled_ = text_points > kept_bytes / sizeof(Complex);
  }

 private:
  /// Values of one record at the lines of a block.
  struct Window {
    std::span<const Complex> values;
    std::size_t first = 0;
    const Complex& at(std::size_t line) const { return values[line - first]; }
  };

  /// Values of one record from a line on, as they were read last; none where they were many.
  struct Piece {
    std::size_t first = 0;
    std::vector<Complex> values;
    std::size_t end() const { return first + values.size(); }
  };

  void do_read(const Block& block, std::span<Complex> out) override {
    std::ranges::fill(out, Complex(std::nan(""), std::nan("")));
    for_each_record(block, [&](const uff::GridRecord& record, std::size_t offset, std::size_t stride) {
      read_frf(record, block.lines, out.subspan(offset), stride);
    });
  }

  void do_read_variance(const Block&, std::span<Complex>) override {}

  void do_read_coherence(const Block& block, std::span<double> out) override {
    std::ranges::fill(out, std::nan(""));
    for_each_record(block, [&](const uff::GridRecord& record, std::size_t offset, std::size_t stride) {
      const Window window = values(record.coherence, block.lines);
      for (std::size_t i = 0; i < block.lines.size(); ++i) out[offset + i * stride] = window.at(block.lines[i]).real();
    });
  }

  /// Calls use(record, place of its first line, entries from line to line) for what was measured.
  template <class Use>
  void for_each_record(const Block& block, Use use) {
    const std::size_t stride = block.responses.size() * block.references.size();
    ahead_ = ahead_bytes / sizeof(Complex) / std::max<std::size_t>(1, stride);
    for (std::size_t r = 0; r < block.responses.size(); ++r) {
      for (std::size_t c = 0; c < block.references.size(); ++c) {
        const auto found = catalogue_.grid.find(block.responses[r] * header_.reference.size() + block.references[c]);
        if (found != catalogue_.grid.end()) use(found->second, r * block.references.size() + c, stride);
      }
    }
  }

  void read_frf(const uff::GridRecord& record, std::span<const std::size_t> lines, std::span<Complex> out,
                std::size_t stride) {
    const Window window = values(record.dataset, lines);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const double frequency = header_.frequency_hz[lines[i]];
      const Complex value = record.factor * window.at(lines[i]) * to_receptance(record.quantity, frequency);
      out[i * stride] = is_infinite(value) ? Complex(std::nan(""), std::nan("")) : value;  // at 0 Hz only
    }
  }

  Window values(std::size_t index, std::span<const std::size_t> lines) {
    const uff::Dataset& dataset = catalogue_.datasets[index];
    if (!dataset.binary || !dataset.function->even) {
      check_axis(index);
      if (!dataset.binary && !is_spooled_) return {kept_.at(index), 0};
    }
    const std::size_t first = lines.front(), count = lines.back() - first + 1;
    const std::span<const Complex> values = stored_values(index, first, count);
    require_finite(dataset, values, first);
    return {values, first};
  }

  /// Records lie one after another in the file, and a chunk of lines is a few bytes of each: where a record goes on at the line
  /// at which it ended, all lines are being read, and more than is asked for is taken at once.
  std::span<const Complex> stored_values(std::size_t index, std::size_t first, std::size_t count) {
    const auto [place, is_new] = pieces_.try_emplace(index);
    Piece& piece = place->second;
    if (first >= piece.first && first + count <= piece.end()) return std::span(piece.values).subspan(first - piece.first, count);
    const uff::Dataset& dataset = catalogue_.datasets[index];
    if (count >= ahead_) {
      piece = {first + count, {}};
      buffer_ = read_piece(index, first, count);
      return buffer_;
    }
    const bool goes_on = !is_new && first == piece.end();
    const std::size_t taken = std::min<std::size_t>(goes_on ? ahead_ : count, dataset.function->points - first);
    const std::vector<Complex> read = read_piece(index, first, taken);
    piece.values.assign(read.begin(), read.end());  // in the place of the last ones
    piece.first = first;
    return std::span<const Complex>(piece.values).first(count);
  }

  /// Of a binary record, or of one whose numbers are in the spool.
  std::vector<Complex> read_piece(std::size_t index, std::size_t first, std::size_t count) {
    const uff::Dataset& dataset = catalogue_.datasets[index];
    if (dataset.binary) return uff::read_points(file_, dataset, first, count).values;
    std::vector<Complex> out(count);
    spool_.get(spooled_.at(index) + 2 * first, std::span(reinterpret_cast<double*>(out.data()), 2 * count));
    return out;
  }

  /// On the first use of a record: reads text whole and compares the axis of an uneven record with the
  /// header's.
  void check_axis(std::size_t index) {
    if (checked_.contains(index)) return;
    const uff::Dataset& dataset = catalogue_.datasets[index];
    uff::Points points = uff::read_points(file_, dataset);
    if (!dataset.function->even) uff::require_axis(catalogue_, dataset, std::move(points.abscissa));
    require_finite(dataset, points.values, 0);
    if (!dataset.binary) keep(index, std::move(points.values));
    checked_.insert(index);
  }

  void keep(std::size_t index, std::vector<Complex> values) {
    if (is_spooled_) {
      spooled_[index] = spool_.put(std::span(reinterpret_cast<const double*>(values.data()), 2 * values.size()));
    } else {
      kept_[index] = std::move(values);
    }
  }

  static bool is_infinite(const Complex& value) { return std::isinf(value.real()) || std::isinf(value.imag()); }

  /// NaN means not measured; an infinite value means nothing, but at 0 Hz, where it is what a division by ω² gave. `first`: the
  /// line of the first value.
  void require_finite(const uff::Dataset& dataset, std::span<const Complex> values, std::size_t first) const {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double frequency = header_.frequency_hz[first + i];
      if (!is_infinite(values[i]) || frequency == 0.0) continue;
      dataset.place.fail("data", "a value is infinite, at " + digits(frequency, "%.9g") + " Hz",
                         "export the FRF again, or write NaN there");
    }
  }

  uff::ByteFile file_;
  uff::Catalogue catalogue_;
  std::set<std::size_t> checked_;
  bool is_spooled_ = false;                               ///< text, by its size
  std::map<std::size_t, std::vector<Complex>> kept_;      ///< whole text records, by dataset
  NumberSpool spool_;                                     ///< or here
  std::unordered_map<std::size_t, std::size_t> spooled_;  ///< where the record begins in it
  std::unordered_map<std::size_t, Piece> pieces_;         ///< of records that are not kept
  std::size_t ahead_ = 0;                                 ///< lines of each record of the block that is read
  std::vector<Complex> buffer_;
};

}  // namespace

std::unique_ptr<FrfSource> open_uff(const std::filesystem::path& path, const OpenOptions& options) {
  return std::make_unique<UffSource>(path, options);
}

bool looks_like_uff(std::span<const char> first_bytes) {
  std::string_view rest(first_bytes.data(), first_bytes.size());
  const std::string plain = needs_plain_text(rest) ? plain_text(std::string(rest)) : std::string();
  if (!plain.empty()) rest = plain;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
  const auto next_line = [&] {
    const std::size_t end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    return line;
  };
  std::string_view line = next_line();
  while (uff::trim(line).empty() && !rest.empty()) line = next_line();
  if (!uff::is_delimiter(line)) return false;
  const auto fields = uff::words(next_line());
  if (fields.empty()) return false;
  const std::size_t digits = fields[0].find_first_not_of("+0123456789");
  const bool letter = digits != std::string_view::npos && digits > 0 && fields[0].size() == digits + 1;  // "58b", "58c"
  const std::string_view number = fields[0].substr(0, letter ? digits : std::string_view::npos);
  const auto value = uff::parse_integer(number);
  return !number.empty() && value && *value > 0;
}

}  // namespace jointid::frf
