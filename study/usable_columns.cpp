#include "study/usable_columns.hpp"

#include <algorithm>

#include "study/study_row.hpp"

namespace jointid::study {
namespace {

/// A chunk of the file.
constexpr std::size_t trials_per_piece = 4096;

bool has_estimate(double status) { return is_usable(static_cast<ident::Status>(status)); }

/// Keeps the usable ones of `numbers`.
void keep_usable(const std::vector<double>& statuses, std::vector<double>& numbers) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < statuses.size(); ++i) {
    if (has_estimate(statuses[i])) numbers[kept++] = numbers[i];
  }
  numbers.resize(kept);
}

}  // namespace

std::size_t UsableColumns::count(ident::Status status) const {
  std::vector<double> statuses;
  std::size_t count = 0;
  for (std::size_t first = 0; first < table_.rows(); first += statuses.size()) {
    statuses.resize(std::min(trials_per_piece, table_.rows() - first));
    table_.read(StudyColumns::status, first, statuses);
    count += static_cast<std::size_t>(std::ranges::count(statuses, static_cast<double>(status)));
  }
  return count;
}

void UsableColumns::each_piece(std::vector<std::size_t> columns, const RowVisitor& visit) const {
  std::vector<double> statuses;
  std::vector<std::vector<double>> piece(columns.size());
  for (std::size_t first = 0; first < table_.rows(); first += statuses.size()) {
    statuses.resize(std::min(trials_per_piece, table_.rows() - first));
    table_.read(StudyColumns::status, first, statuses);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      piece[i].resize(statuses.size());
      table_.read(columns[i], first, piece[i]);
      keep_usable(statuses, piece[i]);
    }
    visit(piece);
  }
}

ColumnPass UsableColumns::pass(std::size_t column) const {
  return [this, column](const PieceVisitor& visit) {
    each_piece({column}, [&](std::span<const std::vector<double>> piece) { visit(piece.front()); });
  };
}

}  // namespace jointid::study
