#include "frf/csv/csv_row_names.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "frf/csv/csv_titles.hpp"
#include "frf/text/number_text.hpp"

namespace jointid::frf {
namespace {

class RowNames {
 public:
  explicit RowNames(char separator) : separator_(separator) {}

  /// Takes the next line; false where the text is no such table.
  bool take(std::string_view line) {
    const std::string_view bare = line.substr(0, line.find_last_not_of('\r') + 1);
    if (trimmed(bare).empty() || bare.front() == '#' || bare.front() == '%') {
      add({bare});
      return true;
    }
    const std::vector<std::string_view> cells = csv_cells(bare, separator_);
    const bool titles = titles_ == 0;
    if (titles && !take_titles(bare, cells)) return false;
    if (!titles && !take_row(bare, cells)) return false;
    add({cells.begin() + (named_ && !titles ? 1 : 0), cells.end()});
    return true;
  }

  std::optional<std::string> text() { return rows_ > 0 ? std::optional(std::move(text_)) : std::nullopt; }

 private:
  bool take_titles(std::string_view line, const std::vector<std::string_view>& cells) {
    titles_ = cells.size();
    quoted_ = line.front() == '"' && line.back() == '"';
    return titles_ > 1 && std::ranges::none_of(cells, [](std::string_view cell) { return cell.empty(); });
  }

  bool take_row(std::string_view line, const std::vector<std::string_view>& cells) {
    ++rows_;
    if (rows_ == 1) named_ = cells.size() == titles_ + 1;
    if (!named_) return separator_ == ' ' && quoted_ && cells.size() == titles_;
    return cells.size() == titles_ + 1 && !cells.back().empty() &&
           (line.front() == '"' || cells.front() == std::to_string(rows_));
  }

  void add(const std::vector<std::string_view>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) text_.append(i > 0 ? "\t" : "").append(cells[i]);
    text_ += '\n';
  }

  char separator_;
  std::string text_;
  std::size_t titles_ = 0, rows_ = 0;
  bool named_ = false, quoted_ = false;
};

}  // namespace

std::optional<std::string> without_row_names(std::string_view text) {
  for (const char separator : {'\t', ';', ',', ' '}) {
    RowNames table(separator);
    std::string_view rest = text;
    bool fits = true;
    while (fits && !rest.empty()) fits = table.take(take_until(rest, '\n'));
    if (!fits) continue;
    if (auto found = table.text()) return found;
  }
  return std::nullopt;
}

}  // namespace jointid::frf
