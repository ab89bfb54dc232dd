#include "gui/scene/toml_highlighter.hpp"

#include <QRegularExpression>
#include <array>

namespace jointid::gui {
namespace {

enum class Token { table, key, string, number, comment };

struct Rule {
  Token token;
  const char* pattern;  ///< what stands in its first group
};

/// Tried at each place in this order.
constexpr std::array rules = {
    Rule{Token::comment, R"((#.*))"},
    Rule{Token::string, R"(("""(?:[^"\\]|\\.|"(?!""))*(?:"""|$)|'''.*?(?:'''|$)|"(?:[^"\\]|\\.)*"?|'[^']*'?))"},
    Rule{Token::key, R"(([A-Za-z0-9_.\-]+)\s*=)"},
    Rule{Token::number, R"(([+\-]?(?:\d[\d_]*(?:\.\d+)?(?:[eE][+\-]?\d+)?|inf|nan)\b|\b(?:true|false)\b))"},
};

const QRegularExpression& expression(std::size_t rule) {
  static const auto all = [] {
    std::array<QRegularExpression, rules.size()> made;
    for (std::size_t i = 0; i < rules.size(); ++i) made[i].setPattern(QString::fromUtf8(rules[i].pattern));
    return made;
  }();
  return all[rule];
}

QTextCharFormat format_of(Token token, Theme theme) {
  QTextCharFormat format;
  const bool dark = theme == Theme::dark;
  switch (token) {
    case Token::table:
      format.setForeground(curve_colour(theme, 3));
      format.setFontWeight(QFont::Bold);
      break;
    case Token::key:
      format.setForeground(curve_colour(theme, 0));
      break;
    case Token::string:
      format.setForeground(curve_colour(theme, 2));
      break;
    case Token::number:
      format.setForeground(dark ? curve_colour(theme, 4) : curve_colour(theme, 1));
      break;
    case Token::comment:
      format.setForeground(colours(theme).weak_text);
      format.setFontItalic(true);
      break;
  }
  return format;
}

}  // namespace

TomlHighlighter::TomlHighlighter(QTextDocument* document) : QSyntaxHighlighter(document) {}

void TomlHighlighter::set_theme(Theme theme) {
  if (theme == theme_) return;
  theme_ = theme;
  rehighlight();
}

void TomlHighlighter::highlightBlock(const QString& text) {
  static const QRegularExpression header(QStringLiteral(R"(^\s*(\[\[?[^\],+ ]+\]?\]?)\s*(#|$))"));
  qsizetype at = 0;
  if (const auto match = header.match(text); match.hasMatch()) {
    setFormat(static_cast<int>(match.capturedStart(1)), static_cast<int>(match.capturedLength(1)),
              format_of(Token::table, theme_));
    at = match.capturedEnd(1);
  }
  while (at < text.size()) {
    bool found = false;
    for (std::size_t i = 0; i < rules.size() && !found; ++i) {
      const auto match =
          expression(i).match(text, at, QRegularExpression::NormalMatch, QRegularExpression::AnchorAtOffsetMatchOption);
      found = match.hasMatch() && match.capturedLength(1) > 0;
      if (!found) continue;
      setFormat(static_cast<int>(match.capturedStart(1)), static_cast<int>(match.capturedLength(1)),
                format_of(rules[i].token, theme_));
      at = match.capturedEnd(1);
    }
    if (!found) ++at;
  }
}

}  // namespace jointid::gui
