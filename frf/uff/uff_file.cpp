#include "frf/uff/uff_file.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "frf/uff/uff_catalogue.hpp"
#include "frf/uff/uff_catalogue_builder.hpp"
#include "frf/uff/uff_text.hpp"

namespace jointid::frf {
namespace {

class UffSource final : public FrfSource {
 public:
  UffSource(const std::filesystem::path& path, const OpenOptions& options)
      : file_(path), catalogue_(uff::build_catalogue(file_, options)) {
    header_ = catalogue_.header;
  }

 private:
  /// Values of one record at the lines of a block; text records are kept once they have been read.
  struct Window {
    std::span<const Complex> values;
    std::size_t first = 0;
    const Complex& at(std::size_t line) const { return values[line - first]; }
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
  void for_each_record(const Block& block, Use use) const {
    const std::size_t stride = block.responses.size() * block.references.size();
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
      out[i * stride] = record.factor * window.at(lines[i]) * to_receptance(record.quantity, frequency);
    }
  }

  Window values(std::size_t index, std::span<const std::size_t> lines) {
    const uff::Dataset& dataset = catalogue_.datasets[index];
    if (!dataset.binary || !dataset.function->even) {
      check_axis(index);
      if (!dataset.binary) return {kept_.at(index), 0};
    }
    const std::size_t first = lines.front();
    buffer_ = uff::read_points(file_, dataset, first, lines.back() - first + 1).values;
    require_finite(dataset, buffer_);
    return {buffer_, first};
  }

  /// On the first use of a record: reads text whole and compares the axis of an uneven record with the
  /// header's.
  void check_axis(std::size_t index) {
    if (checked_.contains(index)) return;
    const uff::Dataset& dataset = catalogue_.datasets[index];
    uff::Points points = uff::read_points(file_, dataset);
    if (!dataset.function->even) uff::require_axis(catalogue_, dataset, std::move(points.abscissa));
    require_finite(dataset, points.values);
    if (!dataset.binary) kept_[index] = std::move(points.values);
    checked_.insert(index);
  }

  /// NaN means not measured; an infinite value means nothing.
  static void require_finite(const uff::Dataset& dataset, std::span<const Complex> values) {
    const auto infinite = std::find_if(values.begin(), values.end(), [](const Complex& value) {
      return std::isinf(value.real()) || std::isinf(value.imag());
    });
    if (infinite != values.end()) dataset.place.fail("data", "a value is infinite", "export the FRF again");
  }

  uff::ByteFile file_;
  uff::Catalogue catalogue_;
  std::set<std::size_t> checked_;
  std::map<std::size_t, std::vector<Complex>> kept_;
  std::vector<Complex> buffer_;
};

}  // namespace

std::unique_ptr<FrfSource> open_uff(const std::filesystem::path& path, const OpenOptions& options) {
  return std::make_unique<UffSource>(path, options);
}

bool looks_like_uff(std::span<const char> first_bytes) {
  std::string_view rest(first_bytes.data(), first_bytes.size());
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
  const std::string_view number = fields[0].substr(0, fields[0].find_first_of("bB"));
  const auto value = uff::parse_integer(number);
  return !number.empty() && value && *value > 0;
}

}  // namespace jointid::frf
