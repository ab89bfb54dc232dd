#pragma once

#include <string>

namespace jointid::cli {

/// Whether a page goes to a file of this name as PDF.
bool is_pdf(const std::string& target);

/// Throws InputError (usage) where no browser is found that prints a page: Chromium or Chrome.
void require_browser(const std::string& option);

/// The page printed by that browser without a window. Throws InputError where it does not.
std::string printed(const std::string& html, const std::string& target);

}  // namespace jointid::cli
