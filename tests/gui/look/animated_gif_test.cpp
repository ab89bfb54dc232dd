#include "gui/plot/animated_gif.hpp"

#include <gtest/gtest.h>

#include <QBuffer>
#include <QImageReader>

namespace jointid::gui {
namespace {

/// Pictures whose strings of pixels fill the table of codes more than once.
QImage noisy(int seed) {
  QImage picture(300, 200, QImage::Format_RGB32);
  unsigned state = static_cast<unsigned>(seed);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      state = state * 1664525U + 1013904223U;
      const int grey = static_cast<int>(state >> 28) * 16;
      picture.setPixel(x, y, qRgb(grey, 255 - grey, grey / 2));
    }
  }
  return picture;
}

TEST(AnimatedGif, EveryPictureComesBack) {
  const std::vector<QImage> pictures = {noisy(1), noisy(2), noisy(3)};
  QByteArray bytes = animated_gif(pictures, 50);
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::ReadOnly);
  QImageReader reader(&buffer, "gif");
  ASSERT_TRUE(reader.canRead()) << "Qt has no reader of GIF";
  EXPECT_EQ(reader.loopCount(), -1);
  for (const QImage& picture : pictures) {
    const QImage back = reader.read().convertToFormat(QImage::Format_RGB32);
    ASSERT_EQ(back.size(), picture.size());
    EXPECT_EQ(back, picture);
  }
  EXPECT_EQ(reader.nextImageDelay(), 50);
}

TEST(AnimatedGif, NothingIsNoFilm) { EXPECT_TRUE(animated_gif({}, 50).isEmpty()); }

}  // namespace
}  // namespace jointid::gui
