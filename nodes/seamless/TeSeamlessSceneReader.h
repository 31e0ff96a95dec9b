#pragma once

#include "nodes/seamless/TeSeamlessPictures.h"
#include "nodes/seamless/TeSeamlessScene.h"

#include <string>

class SbString;
class SoTeSeamlessPatches;

/// Makes of a node's fields how its terrain lies, how accurate it is and how it looks.
class TeSeamlessSceneReader {
public:
  /// All must outlive it. `folder`: that of the scene's file.
  TeSeamlessSceneReader(const SoTeSeamlessPatches& node, const std::string& folder,
                        TeSeamlessPictures& pictures)
      : m_node(node), m_folder(folder), m_pictures(pictures) {}

  /// All but the lodCamera. Reads what files the colouring needs. `middle`: of the terrain, in the node's
  /// coordinates. Error: a file that cannot be read, a number out of range, a node of the wrong kind; the
  /// message names the field.
  TeResult<TeSeamlessScene> read(const TeSeamlessContent& content, const glm::dvec3& middle);
  /// Whether another node has already told of the error.
  bool isReported() const { return m_isReported; }

private:
  TeStatus readAccuracy(TeSeamlessScene& scene) const;
  TeStatus readColours(TeSeamlessScene& scene);
  TeResult<TeSeamlessLook> readLook(const TeSeamlessTerrain& terrain);
  TeStatus readPicture(const char* field, const SbString& file, std::shared_ptr<const TePicture>& picture);
  TeStatus readDetails(TeSeamlessLook& look);
  TeStatus readGround(TeHeightRange range, TeSeamlessSlopeColours& ground) const;

  const SoTeSeamlessPatches& m_node;
  const std::string& m_folder;
  TeSeamlessPictures& m_pictures;
  bool m_isReported = false;
};
