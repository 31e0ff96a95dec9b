#pragma once

#include "nodes/TePicture.h"

#include <map>
#include <memory>
#include <string>

/// PNG files as pictures, each read once for as long as somebody has it.
class TeSeamlessPictures {
public:
  /// Errors of TePicture::readPng(), with the name of the field that names the file.
  TeStatus read(const char* field, const std::string& path, std::shared_ptr<const TePicture>& picture);

private:
  std::map<std::string, std::weak_ptr<const TePicture>> m_pictures;
};
