#pragma once

#include "nodes/seamless/TeSeamlessLook.h"
#include "nodes/seamless/TeSeamlessPictures.h"
#include "nodes/seamless/TeSeamlessTerrain.h"

#include <string>

class SbString;
class SoTeSeamlessPatches;

/// Makes of a node's fields how its terrain is to look.
class TeSeamlessLookReader {
public:
  /// All must outlive it. `folder`: that of the scene's file.
  TeSeamlessLookReader(const SoTeSeamlessPatches& node, const std::string& folder,
                       TeSeamlessPictures& pictures)
      : m_node(node), m_folder(folder), m_pictures(pictures) {}

  /// Reads what files the colouring needs. Error: a file that cannot be read, a number out of range; the
  /// message names the field.
  TeResult<TeSeamlessLook> read(const TeSeamlessTerrain& terrain);

private:
  TeStatus readPicture(const char* field, const SbString& file, std::shared_ptr<const TePicture>& picture);
  TeStatus readDetails(TeSeamlessLook& look);
  TeStatus readGround(TeHeightRange range, TeSeamlessSlopeColours& ground) const;

  const SoTeSeamlessPatches& m_node;
  const std::string& m_folder;
  TeSeamlessPictures& m_pictures;
};
