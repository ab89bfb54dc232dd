#pragma once

#include <QByteArray>
#include <QImage>
#include <vector>

namespace jointid::gui {

/// Pictures of one size, one after the other without an end, as a GIF (version 89a) of 256 colours a picture.
QByteArray animated_gif(const std::vector<QImage>& pictures, int milliseconds);

}  // namespace jointid::gui
