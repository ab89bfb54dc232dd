#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "base/stop_scope.hpp"
#include "base/temporary_file.hpp"
#include "frf/csv/csv_columns.hpp"
#include "frf/csv/csv_file.hpp"
#include "frf/csv/csv_nodes.hpp"
#include "frf/set/line_scale.hpp"

namespace jointid::frf {
namespace {

using enum CsvPart;

/// Shortest text that reads back as the same number; nothing for NaN.
void append_number(std::string& text, double value) {
  if (std::isnan(value)) return;
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), end);
}

void append_line(std::string& text, const FrfSet& set, std::size_t line) {
  const FrfHeader& header = set.header;
  const LineScale scale = LineScale::from_receptance(header.quantity, header.frequency_hz[line]);
  const auto append_complex = [&](Complex value) {
    append_number(text += ',', value.real());
    append_number(text += ',', value.imag());
  };
  append_number(text, header.frequency_hz[line]);
  for (std::size_t i = line * header.entries(); i < (line + 1) * header.entries(); ++i) {
    append_complex(scale.value(set.values[i]));
    if (!set.variance.empty()) append_complex(scale.variance(set.variance[i]));
    if (!set.coherence.empty()) append_number(text += ',', set.coherence[i]);
  }
  text += '\n';
}

std::string header_text(const FrfHeader& header) {
  std::string text = "# quantity = " + name(header.quantity) + "\n# unit = " + unit(header.quantity) + "\n";
  text += csv_nodes_text(header.nodes);
  std::vector<CsvPart> parts = {re, im};
  if (header.noise == NoiseRecord::variance) parts.insert(parts.end(), {var_re, var_im});
  if (header.noise == NoiseRecord::coherence) {
    parts.push_back(coherence);
    if (header.averages > 0.0) {
      append_number(text += "# averages = ", header.averages);
      text += '\n';
    }
  }
  text += csv_frequency_column;
  for (const Dof& response : header.response) {
    for (const Dof& reference : header.reference) {
      for (const CsvPart part : parts) {
        text += ", " + response.name() + "/" + reference.name() + " " +
                std::string(csv_part_names[static_cast<std::size_t>(part)]);
      }
    }
  }
  return text + "\n";
}

}  // namespace

void write_csv(const FrfSet& set, const std::filesystem::path& path) {
  validate(set.header);
  std::string text = header_text(set.header);
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    stop_point();
    append_line(text, set, line);
  }
  write_text(path, text);
}

}  // namespace jointid::frf
