#include "nodes/clipmap/SoTeClipmap.h"

#include <Inventor/SoInput.h>
#include <Inventor/errors/SoDebugError.h>
#include <Inventor/misc/SoNotification.h>

#include <algorithm>
#include <filesystem>

SO_NODE_SOURCE(SoTeClipmap)

void SoTeClipmap::initClass() {
  if (classTypeId == SoType::badType())
    PRIVATE_COMMON_INIT_CODE(SoTeClipmap, "TeClipmap", &SoTeClipmap::createInstance, SoNode);
}

SoTeClipmap::SoTeClipmap() {
  SO_NODE_CONSTRUCTOR(SoTeClipmap);
  SO_NODE_ADD_FIELD(name, (""));
  SO_NODE_ADD_FIELD(size, (513));
  SO_NODE_DEFINE_ENUM_VALUE(Kind, HEIGHT);
  SO_NODE_DEFINE_ENUM_VALUE(Kind, COLOR);
  SO_NODE_SET_SF_ENUM_TYPE(kind, Kind);
  SO_NODE_ADD_FIELD(kind, (HEIGHT));
  SO_NODE_DEFINE_ENUM_VALUE(Format, SHORT);
  SO_NODE_DEFINE_ENUM_VALUE(Format, HALF);
  SO_NODE_DEFINE_ENUM_VALUE(Format, FLOAT);
  SO_NODE_SET_SF_ENUM_TYPE(format, Format);
  SO_NODE_ADD_FIELD(format, (SHORT));
  SO_NODE_ADD_FIELD(maxLevel, (-1));
  SO_NODE_ADD_FIELD(uploadBudget, (1 << 20));
  SO_NODE_ADD_FIELD(cacheBytes, (int(TePyramidTiles::kDefaultCacheBytes)));
}

SoTeClipmap::~SoTeClipmap() = default;

std::shared_ptr<TePyramidTiles> SoTeClipmap::getTiles() {
  update();
  return m_tiles;
}

TeResult<std::unique_ptr<TeClipWindows>> SoTeClipmap::makeWindows(int highestLevel) {
  update();
  if (!m_tiles)
    return TeError{m_error};
  return TeClipWindows::create(m_tiles, size.getValue(), highestLevel);
}

TeClipFormat SoTeClipmap::getFormat() const {
  if (kind.getValue() == COLOR)
    return TeClipFormat::Colour;
  switch (format.getValue()) {
  case HALF:
    return TeClipFormat::Half;
  case FLOAT:
    return TeClipFormat::Float;
  default:
    return TeClipFormat::Short;
  }
}

std::size_t SoTeClipmap::getUploadBudget() const { return std::size_t(std::max(0, uploadBudget.getValue())); }

std::string SoTeClipmap::getPath() const {
  const std::string prefix = name.getValue().getString();
  if (prefix.empty() || std::filesystem::path(prefix).is_absolute() || m_folder.empty())
    return prefix;
  return (std::filesystem::path(m_folder) / prefix).string();
}

const std::string& SoTeClipmap::getError() {
  update();
  return m_error;
}

void SoTeClipmap::update() {
  if (m_isCurrent)
    return;
  m_isCurrent = true;
  m_tiles.reset();
  m_error.clear();
  TeResult<TePyramidReader> reader = open();
  if (reader) {
    const std::size_t bytes = std::size_t(std::max(0, cacheBytes.getValue()));
    m_tiles = std::make_shared<TePyramidTiles>(std::move(*reader), bytes);
    return;
  }
  m_error = reader.error().message;
  SoDebugError::postWarning("TeClipmap", "%s", m_error.c_str());
}

TeResult<TePyramidReader> SoTeClipmap::open() const {
  const std::string path = getPath();
  const int windows = size.getValue();
  if (windows < TeClipWindows::kMinSize || windows > TeClipWindows::kMaxSize)
    return TeError{path + ": clip size " + std::to_string(windows) + " is not from " +
                   std::to_string(TeClipWindows::kMinSize) + " to " +
                   std::to_string(TeClipWindows::kMaxSize)};
  const int whole = TeClipWindows::wholeLevel(windows);
  const int highest = maxLevel.getValue();
  if (kind.getValue() == HEIGHT)
    return TePyramidReader::open(path, 2, whole, highest);
  const TeResult<int> bytes = TePyramidReader::colourBytes(path, whole);
  if (!bytes)
    return bytes.error();
  return TePyramidReader::open(path, *bytes, whole, highest);
}

SbBool SoTeClipmap::readInstance(SoInput* input, unsigned short flags) {
  if (const char* file = input->getCurFileName())
    m_folder = std::filesystem::path(file).parent_path().string();
  return inherited::readInstance(input, flags);
}

void SoTeClipmap::copyContents(const SoFieldContainer* from, SbBool copyConnections) {
  inherited::copyContents(from, copyConnections);
  m_folder = static_cast<const SoTeClipmap*>(from)->m_folder;
  m_isCurrent = false;
}

void SoTeClipmap::notify(SoNotList* list) {
  // The texels' format and the budget are asked for at each use.
  const SoField* field = list->getLastField();
  if (field != &uploadBudget && field != &format)
    m_isCurrent = false;
  inherited::notify(list);
}
