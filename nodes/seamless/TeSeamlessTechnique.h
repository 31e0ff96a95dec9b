#pragma once

#include "generators/base/TeResult.h"

#include <string>
#include <vector>

/// One way to draw Seamless Patches: where heights come from, what colours the surface, and whether a list is
/// one draw call (instanced) or each part is (classic). The document names 18 of them
/// {Flat,Heightmap,Clipmaps}{Color,Texture,Detailmaps}{Classic,Instanced}; colour by height and slope
/// ("Slope") comes with any of the six others.
struct TeSeamlessTechnique {
  enum Heights { Flat, Heightmap, Clipmaps };
  enum Colours { Color, Texture, Detailmaps, Slope };

  Heights heights = Flat;
  Colours colours = Color;
  bool instanced = true;

  /// As the document writes it: "ClipmapsTextureInstanced".
  std::string name() const;
  /// Error: a name that is not one of all().
  static TeResult<TeSeamlessTechnique> named(const std::string& name);
  /// The document's 18 first, then those with Slope.
  static std::vector<TeSeamlessTechnique> all();

  friend bool operator==(const TeSeamlessTechnique& a, const TeSeamlessTechnique& b) {
    return a.heights == b.heights && a.colours == b.colours && a.instanced == b.instanced;
  }
};
