#pragma once

#include <QString>
#include <filesystem>
#include <string_view>
#include <vector>

namespace jointid::gui {

/// Throws InputError where the file is one of the inputs, which no output replaces.
void check_output(const QString& file, const std::vector<std::filesystem::path>& inputs);

/// Writes by way of a temporary. Throws InputError where the disk does not take it, and for one of the inputs, which no output
/// replaces.
void write_output(const QString& file, std::string_view bytes, const std::vector<std::filesystem::path>& inputs);

}  // namespace jointid::gui
