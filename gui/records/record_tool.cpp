#include "gui/records/record_tool.hpp"

#include "gui/look/paths.hpp"
#include "gui/look/said.hpp"

namespace jointid::gui {

QStringList parted(const QString& texts) {
  QStringList out;
  for (const QString& text : texts.split(QLatin1Char(';'))) {
    if (!text.trimmed().isEmpty()) out << text.trimmed();
  }
  return out;
}

QString options_of(const RecordTool& tool, const ToolValues& values) {
  QString text;
  for (const ToolField& field : tool.fields) {
    const auto place = values.find(field.option);
    if (place == values.end()) continue;
    if (field.kind == ToolField::Kind::texts) {
      for (const QString& each : parted(place->second)) text += " " + q(field.option) + " " + shell_word(each);
      continue;
    }
    text += " " + q(field.option);
    if (field.kind != ToolField::Kind::flag) text += " " + shell_word(place->second);
  }
  return text;
}

}  // namespace jointid::gui
