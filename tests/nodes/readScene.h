#pragma once

#include "nodes/TeNodePtr.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/nodes/SoSeparator.h>

#include <string>

/// The scene in an Inventor text; null if it cannot be read.
inline TeNodePtr<SoSeparator> readScene(const std::string& text) {
  const std::string whole = "#Inventor V2.1 ascii\n" + text;
  SoInput input;
  input.setBuffer(whole.data(), whole.size());
  return TeNodePtr<SoSeparator>(SoDB::readAll(&input));
}
