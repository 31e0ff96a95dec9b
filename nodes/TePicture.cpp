#include "nodes/TePicture.h"

#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace {

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, FileCloser>;

} // namespace

TeStatus TePicture::writePng(const std::string& path) const {
  if (width < 1 || height < 1)
    return TeError{path + ": an empty picture cannot be written"};
  if (width > kMaxSide || height > kMaxSide || rgba.size() != std::size_t(4) * width * height)
    return TeError{path + ": a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                   " with " + std::to_string(rgba.size()) + " bytes cannot be written"};
  File file(std::fopen(path.c_str(), "wb"));
  if (!file)
    return TeError{path + ": cannot be written: " + std::strerror(errno)};
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = png_uint_32(width);
  image.height = png_uint_32(height);
  image.format = PNG_FORMAT_RGBA;
  errno = 0;
  const bool written = png_image_write_to_stdio(&image, file.get(), 0, rgba.data(), -4 * width, nullptr) != 0;
  const bool closed = std::fclose(file.release()) == 0;
  if (written && closed)
    return {};
  return TeError{path + ": cannot be written: " + (errno ? std::strerror(errno) : image.message)};
}

TeResult<TePicture> TePicture::readPng(const std::string& path) {
  File file(std::fopen(path.c_str(), "rb"));
  if (!file)
    return TeError{path + ": cannot be read: " + std::strerror(errno)};
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_stdio(&image, file.get()))
    return TeError{path + ": cannot be read as PNG: " + image.message};
  if (image.width > kMaxSide || image.height > kMaxSide) {
    png_image_free(&image);
    return TeError{path + ": a side of " + std::to_string(std::max(image.width, image.height)) +
                   " pixels is more than " + std::to_string(kMaxSide)};
  }
  image.format = PNG_FORMAT_RGBA;
  TePicture picture;
  picture.width = int(image.width);
  picture.height = int(image.height);
  picture.rgba.resize(PNG_IMAGE_SIZE(image));
  if (!png_image_finish_read(&image, nullptr, picture.rgba.data(), -4 * picture.width, nullptr))
    return TeError{path + ": cannot be read as PNG: " + image.message};
  return picture;
}
