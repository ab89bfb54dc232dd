#include "frf/mat/mat_v4.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "frf/mat/mat_lookup.hpp"
#include "frf/text/number_text.hpp"

namespace jointid::frf {
namespace {

constexpr std::size_t header_bytes = 20, longest_name = 256;
constexpr std::size_t sparse_kind = 2;

/// The numbers of a type by its digit P: double, single, int32, int16, uint16, uint8.
constexpr std::array<std::size_t, 6> widths = {8, 4, 4, 2, 2, 1};

/// A number of the file, in either byte order.
template <class Number>
Number number_at(std::string_view bytes, bool big) {
  std::array<char, sizeof(Number)> own{};
  std::copy_n(bytes.begin(), own.size(), own.begin());
  if (big != (std::endian::native == std::endian::big)) std::ranges::reverse(own);
  return std::bit_cast<Number>(own);
}

/// The 20 bytes before the name of a variable.
struct V4Header {
  bool big = false, complex = false;
  std::size_t type = 0, kind = 0, rows = 0, columns = 0, name = 0;  ///< P and T of the type; bytes of the name with its NUL

  /// Of one number.
  std::size_t width() const { return widths[type]; }
};

/// Empty where the bytes are none of a variable of IEEE numbers.
std::optional<V4Header> header_of(std::string_view bytes) {
  if (bytes.size() < header_bytes) return std::nullopt;
  constexpr std::uint32_t big_endian = 1000, most_types = 53;
  for (const bool big : {false, true}) {
    std::array<std::uint32_t, 5> field{};
    for (std::size_t i = 0; i < field.size(); ++i) field[i] = number_at<std::uint32_t>(bytes.substr(4 * i), big);
    const std::uint32_t type = big ? field[0] - big_endian : field[0];
    if ((big && field[0] < big_endian) || type >= most_types || type % 10 > 2) continue;
    if (field[3] > 1 || field[4] < 2 || field[4] > longest_name) continue;
    return V4Header{.big = big,
                    .complex = field[3] == 1,
                    .type = type / 10,
                    .kind = type % 10,
                    .rows = field[1],
                    .columns = field[2],
                    .name = field[4]};
  }
  return std::nullopt;
}

bool is_name(std::string_view bytes) {
  const auto is_of_name = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return !bytes.empty() && bytes.back() == '\0' && std::isalpha(static_cast<unsigned char>(bytes.front())) != 0 &&
         std::ranges::all_of(bytes.substr(0, bytes.size() - 1), is_of_name);
}

class MatV4 final : public MatFile {
 public:
  explicit MatV4(const std::filesystem::path& path) : MatFile(path.string()), bytes_(read_text(path)) {
    for (std::string_view rest = bytes_; !rest.empty();) take(rest);
    require_distinct_names();
  }

  MatVariable read_variable(const MatInfo& info) override {
    const auto found = std::ranges::find(variables_, info.name, &MatInfo::name);
    const auto& [header, numbers] = content_[static_cast<std::size_t>(found - variables_.begin())];
    MatVariable out{.info = info, .values = {}, .texts = {}};
    if (header.kind == sparse_kind) {
      out.values = of_triplets(header, numbers, std::string_view(info.name).substr(info.name.rfind('.') + 1));
      return out;
    }
    const std::size_t count = header.rows * header.columns;
    if (info.kind == MatKind::text) {
      out.texts.resize(header.columns == 0 ? 0 : header.rows);
      for (std::size_t i = 0; i < count; ++i) out.texts[i % header.rows] += static_cast<char>(value(header, numbers, i));
      return out;
    }
    for (std::size_t i = 0; i < count; ++i)
      out.values.emplace_back(value(header, numbers, i), header.complex ? value(header, numbers, count + i) : 0.0);
    return out;
  }

 private:
  void take(std::string_view& rest) {
    const std::size_t at = bytes_.size() - rest.size();
    const auto header = header_of(rest);
    const std::string_view name = header ? rest.substr(header_bytes, header->name) : std::string_view();
    if (!header || !is_name(name))
      fail({}, "has no header of a MATLAB v4 variable at byte " + std::to_string(at), "the file is damaged; save it again");
    rest.remove_prefix(header_bytes + name.size());
    const std::string own(name.substr(0, name.size() - 1));
    const std::size_t parts = header->complex ? 2 : 1, width = header->width();
    const bool fits = header->rows == 0 || header->columns <= rest.size() / (width * parts) / header->rows;
    if (!fits)
      fail(own,
           "is " + std::to_string(header->rows) + " by " + std::to_string(header->columns) + ", and the file ends before that",
           "the file is cut off; save or copy it again");
    const std::size_t size = header->rows * header->columns * width * parts;
    list(*header, own, rest.substr(0, size));
    rest.remove_prefix(size);
  }

  void list(const V4Header& header, const std::string& name, std::string_view numbers) {
    const auto add = [&](const std::string& of, MatKind kind, const std::vector<std::size_t>& dims) {
      // Whole numbers are written as integers to save space: v4 has no other numbers than doubles.
      variables_.push_back({.name = of, .kind = kind, .dims = dims, .unit = {}, .integers = false});
      content_.emplace_back(header, numbers);
    };
    if (header.kind != sparse_kind) {
      const MatKind of_numbers = header.complex ? MatKind::complex : MatKind::real;
      return add(name, header.kind == 0 ? of_numbers : MatKind::text, {header.rows, header.columns});
    }
    if (header.rows == 0 || header.columns < 3 || header.columns > 4 || header.complex)
      fail(name, "is no sparse matrix: its elements have " + std::to_string(header.columns) + " numbers, not 3 or 4",
           "the file is damaged; save it again");
    const std::size_t count = header.rows - 1;
    for (const char* part : {".data", ".row", ".col"}) add(name + part, MatKind::sparse, {count, 1});
    add(name + ".shape", MatKind::sparse, {2, 1});
  }

  /// An array of a sparse matrix, whose elements are the rows (row from 1, column from 1, real part, imaginary part); the last of
  /// these has the numbers of rows and columns.
  static std::vector<Complex> of_triplets(const V4Header& header, std::string_view numbers, std::string_view part) {
    const std::size_t rows = header.rows;
    const auto number = [&](std::size_t i, std::size_t j) { return value(header, numbers, i + rows * j); };
    std::vector<Complex> out;
    if (part == "shape") return {number(rows - 1, 0), number(rows - 1, 1)};
    for (std::size_t i = 0; i + 1 < rows; ++i) {
      if (part == "data")
        out.emplace_back(number(i, 2), header.columns == 4 ? number(i, 3) : 0.0);
      else
        out.emplace_back(number(i, part == "row" ? 0 : 1) - 1.0);
    }
    return out;
  }

  static double value(const V4Header& header, std::string_view numbers, std::size_t i) {
    const std::string_view bytes = numbers.substr(i * header.width());
    switch (header.type) {
      case 0:
        return number_at<double>(bytes, header.big);
      case 1:
        return static_cast<double>(number_at<float>(bytes, header.big));
      case 2:
        return number_at<std::int32_t>(bytes, header.big);
      case 3:
        return number_at<std::int16_t>(bytes, header.big);
      case 4:
        return number_at<std::uint16_t>(bytes, header.big);
      default:
        return number_at<std::uint8_t>(bytes, header.big);
    }
  }

  std::string bytes_;
  std::vector<std::pair<V4Header, std::string_view>> content_;  ///< as variables_
};

}  // namespace

bool looks_like_mat_v4(std::string_view head) {
  const auto header = header_of(head);
  constexpr std::size_t most = 1'000'000'000;
  if (!header || head.size() < header_bytes + header->name || header->rows > most || header->columns > most) return false;
  return is_name(head.substr(header_bytes, header->name));
}

std::unique_ptr<MatFile> open_mat_variables_v4(const std::filesystem::path& path) { return std::make_unique<MatV4>(path); }

}  // namespace jointid::frf
