#pragma once

#include <string>

#include "report/page/contents.hpp"
#include "report/text/table.hpp"

/// What can be read without the page's program, as HTML.
namespace jointid::report {

std::string to_html(const Text& text);
std::string to_html(const Facts& facts);
std::string to_html(const StatusBanner& banner);
/// The first `most` rows.
std::string to_html(const Table& table, const std::string& title, std::size_t most);
std::string to_html(const HeatMap& map);
std::string to_html(const MatrixTable& matrix);
std::string to_html(const ComparedTable& table);
std::string to_html(const Bars& bars);

}  // namespace jointid::report
