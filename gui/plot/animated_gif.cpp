#include "gui/plot/animated_gif.hpp"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

namespace jointid::gui {
namespace {

constexpr int colour_bits = 8, palette_size = 1 << colour_bits, most_codes = 4096;

void put(QByteArray& out, std::initializer_list<int> bytes) {
  for (const int byte : bytes) out.append(static_cast<char>(byte));
}

/// Little end first.
void put_16(QByteArray& out, int number) { put(out, {number & 255, (number >> 8) & 255}); }

/// Codes of growing width, in blocks of at most 255 bytes.
class CodeStream {
 public:
  void put_code(int code, int width) {
    bits_ |= static_cast<std::uint32_t>(code) << count_;
    for (count_ += width; count_ >= 8; count_ -= 8) {
      bytes_.append(static_cast<char>(bits_ & 255U));
      bits_ >>= 8;
    }
  }
  void end(QByteArray& out) {
    if (count_ > 0) bytes_.append(static_cast<char>(bits_ & 255U));
    for (qsizetype i = 0; i < bytes_.size(); i += 255) {
      const QByteArray block = bytes_.mid(i, 255);
      put(out, {static_cast<int>(block.size())});
      out += block;
    }
    put(out, {0});
  }

 private:
  std::uint32_t bits_ = 0;
  int count_ = 0;
  QByteArray bytes_;
};

/// Lempel, Ziv and Welch: each string of pixels that was met before is one code.
void put_pixels(QByteArray& out, const QImage& picture) {
  constexpr int clear = palette_size, stop = palette_size + 1;
  put(out, {colour_bits});
  CodeStream codes;
  std::unordered_map<int, int> known;  // string and next pixel, to the code of both
  int next = stop + 1, width = colour_bits + 1, string = -1;
  codes.put_code(clear, width);
  for (int y = 0; y < picture.height(); ++y) {
    const uchar* const line = picture.constScanLine(y);
    for (int x = 0; x < picture.width(); ++x) {
      const int pixel = line[x];
      if (string < 0) {
        string = pixel;
        continue;
      }
      const int both = (string << colour_bits) | pixel;
      if (const auto found = known.find(both); found != known.end()) {
        string = found->second;
        continue;
      }
      codes.put_code(string, width);
      string = pixel;
      if (next < most_codes) {
        known[both] = next;
        if (next++ == 1 << width) ++width;
      } else {
        codes.put_code(clear, width);
        known.clear();
        next = stop + 1;
        width = colour_bits + 1;
      }
    }
  }
  if (string >= 0) codes.put_code(string, width);
  codes.put_code(stop, width);
  codes.end(out);
}

void put_picture(QByteArray& out, const QImage& whole, int hundredths) {
  const QImage picture = whole.convertToFormat(QImage::Format_Indexed8, Qt::AvoidDither | Qt::ThresholdDither);
  put(out, {0x21, 0xF9, 4, 0});
  put_16(out, hundredths);
  put(out, {0, 0, 0x2C, 0, 0, 0, 0});
  put_16(out, picture.width());
  put_16(out, picture.height());
  put(out, {0x80 | (colour_bits - 1)});
  for (int i = 0; i < palette_size; ++i) {
    const QRgb colour = i < picture.colorCount() ? picture.color(i) : 0;
    put(out, {qRed(colour), qGreen(colour), qBlue(colour)});
  }
  put_pixels(out, picture);
}

}  // namespace

QByteArray animated_gif(const std::vector<QImage>& pictures, int milliseconds) {
  if (pictures.empty()) return {};
  QByteArray out = "GIF89a";
  put_16(out, pictures.front().width());
  put_16(out, pictures.front().height());
  put(out, {0x70, 0, 0, 0x21, 0xFF, 11});
  out += "NETSCAPE2.0";
  put(out, {3, 1, 0, 0, 0});
  for (const QImage& picture : pictures) put_picture(out, picture, std::max(2, milliseconds / 10));
  put(out, {0x3B});
  return out;
}

}  // namespace jointid::gui
