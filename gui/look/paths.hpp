#pragma once

#include <QString>
#include <filesystem>

namespace jointid::gui {

/// Between the names of Qt and those of the library; bytes that are no UTF-8 survive.
std::filesystem::path as_path(const QString& name);
QString as_name(const std::filesystem::path& path);

/// As one word of a shell: 'it'\''s.toml'.
QString shell_word(QString text);

}  // namespace jointid::gui
