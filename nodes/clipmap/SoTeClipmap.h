#pragma once

#include "nodes/clipmap/TeClipFormat.h"
#include "nodes/clipmap/TeClipWindows.h"

#include <Inventor/fields/SoSFEnum.h>
#include <Inventor/fields/SoSFInt32.h>
#include <Inventor/fields/SoSFString.h>
#include <Inventor/nodes/SoSubNode.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

/// A pyramid of heights or colours on disk, to be drawn through a clipmap: the value of fields of other nodes
/// (SoTeSeamlessPatches); as a child in a scene it does nothing. The files are opened when they are first
/// needed and again after a field has changed. What cannot be used gives one warning through SoDebugError; a
/// level that is missing or wrong, a line in TeLog (TePyramidReader).
///
/// FILE FORMAT/DEFAULTS:
///
///     TeClipmap {
///       name          ""
///       size          513
///       kind          HEIGHT
///       format        SHORT
///       maxLevel      -1
///       uploadBudget  1048576
///       cacheBytes    16777216
///     }
class SoTeClipmap : public SoNode {
  typedef SoNode inherited;
  SO_NODE_HEADER(SoTeClipmap);

public:
  enum Kind { HEIGHT, COLOR };
  enum Format { SHORT, HALF, FLOAT };

  static void initClass();
  SoTeClipmap();

  SoSFString name;        ///< of the level files NAME_i.raw; relative: beside the scene's file
  SoSFInt32 size;         ///< samples a side of a window (TeClipWindows)
  SoSFEnum kind;          ///< HEIGHT: 16 bits a sample; COLOR: 3 or 4 bytes, as the files' sizes tell
  SoSFEnum format;        ///< texels of heights (TeClipFormat); of no effect on colours
  SoSFInt32 maxLevel;     ///< levels above are not used; -1: all that there are
  SoSFInt32 uploadBudget; ///< bytes of samples a frame and context; 0: as many as are wanted
  SoSFInt32 cacheBytes;   ///< main memory for tiles of the files

  /// The files' samples, opened if necessary; null if they cannot be. Replaced after a field has changed that
  /// has to do with the files: users that hold another pointer than this have to begin anew.
  std::shared_ptr<TePyramidTiles> getTiles();
  /// Windows over getTiles(), for one context. `highestLevel`: levels above are not held, -1 for all. Error:
  /// getError(), or what TeClipWindows::create() says.
  TeResult<std::unique_ptr<TeClipWindows>> makeWindows(int highestLevel = -1);
  /// Of the textures.
  TeClipFormat getFormat() const;
  /// What TeClipWindows::update() takes; a negative field counts as 0.
  std::size_t getUploadBudget() const;
  /// The field `name` with the folder of the scene's file.
  std::string getPath() const;
  /// Why there are no tiles; empty if there are.
  const std::string& getError();

  void copyContents(const SoFieldContainer* from, SbBool copyConnections) override;
  void notify(SoNotList* list) override;
  SbBool affectsState() const override { return FALSE; }

protected:
  ~SoTeClipmap() override;
  SbBool readInstance(SoInput* input, unsigned short flags) override;

private:
  void update();
  TeResult<TePyramidReader> open() const;

  std::shared_ptr<TePyramidTiles> m_tiles;
  std::string m_error;
  std::string m_folder; ///< of the file that the node was read from
  bool m_isCurrent = false;
};
