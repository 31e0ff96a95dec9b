#include "nodes/seamless/TeSeamlessPictures.h"

TeStatus TeSeamlessPictures::read(const char* field, const std::string& path,
                                  std::shared_ptr<const TePicture>& picture) {
  if (path.empty())
    return TeError{std::string(field) + ": no file is named"};
  picture = m_pictures[path].lock();
  if (picture)
    return {};
  TeResult<TePicture> made = TePicture::readPng(path);
  if (!made)
    return TeError{std::string(field) + ": " + made.error().message};
  picture = std::make_shared<const TePicture>(std::move(*made));
  m_pictures[path] = picture;
  return {};
}
