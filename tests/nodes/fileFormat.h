#pragma once

#include <Inventor/fields/SoField.h>
#include <Inventor/lists/SoFieldList.h>
#include <Inventor/nodes/SoNode.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>

/// A new node's fields and their values, as a header's comment should tell them: each after a line break, as
/// they are written to files, with one space between name and value.
inline std::string fieldsOf(SoNode* node) {
  SoFieldList fields;
  node->getFields(fields);
  std::string text;
  for (int i = 0; i < fields.getLength(); i++) {
    SbName name;
    SbString value;
    node->getFieldName(fields[i], name);
    fields[i]->get(value);
    std::string plain = value.getString();
    if (plain.front() == '[')
      plain.erase(std::remove(plain.begin(), plain.end(), ' '), plain.end());
    text += std::string("\n") + name.getString() + " " + plain;
  }
  return text;
}

/// The same of a header's comment, after FILE FORMAT.
inline std::string fileFormat(const std::string& header) {
  std::ifstream file(TERRANE_SOURCE_DIR "/" + header);
  std::string line, text;
  while (std::getline(file, line) && line.find("FILE FORMAT") == std::string::npos)
    continue;
  while (std::getline(file, line) && line.find('}') == std::string::npos) {
    const std::size_t name = line.find_first_not_of("/ ");
    if (name == std::string::npos || line.back() == '{')
      continue;
    const std::size_t end = line.find(' ', name);
    text += "\n" + line.substr(name, end - name) + " " + line.substr(line.find_first_not_of(' ', end));
  }
  EXPECT_FALSE(text.empty()) << header;
  return text;
}
