#pragma once

#include "nodes/lod/TeLodMethod.h"
#include "nodes/seamless/TeSeamlessLists.h"
#include "nodes/seamless/TeSeamlessTerrain.h"

#include <memory>
#include <vector>

/// Seamless Patches (docs/seamless-patches.md) as one of the methods; the dial is the document's precision
/// factor, from 1. SoTeSeamlessPatches draws the same with heights on the GPU.
class TeSeamlessLod final : public TeLodMethod {
public:
  struct Settings {
    int minResolution = 16; ///< of a patch; less where the terrain is smaller
    int levels = 3;
  };

  /// Error: settings that do not fit the terrain, one without an error bound (TeSeamlessBounds::create).
  static TeResult<std::unique_ptr<TeLodMethod>> create(TeLodFieldPtr field, const Settings& settings);
  static TeResult<std::unique_ptr<TeLodMethod>> create(TeLodFieldPtr field) {
    return create(std::move(field), Settings());
  }

  std::string name() const override { return "seamless"; }
  const TeLodDial& dial() const override;
  bool morphs() const override { return true; }
  double bytesPerSample() const override;
  void appendPart(std::size_t part, TeLodMesh& mesh) const override;

  const TeSeamlessSelector& selector() const { return m_terrain->selector; }
  /// Draw calls that the lists of the last selection take.
  std::size_t drawCalls() const { return m_lists.draws().size(); }

protected:
  void choose(const TeLodView& view, const TeLodAccuracy& accuracy, TeAllowance& allowance,
              TeLodSelection& selection) override;

private:
  TeSeamlessLod(TeLodFieldPtr field, TeSeamlessTerrainPtr terrain);
  std::uint64_t keyOf(const TeSeamlessPatch& patch);
  std::int64_t trianglesOf(const TeSeamlessPatch& patch) const;

  TeSeamlessTerrainPtr m_terrain;
  TeSeamlessPlacement m_placement;
  TeSeamlessSelection m_chosen;
  TeSeamlessLists m_lists;
  std::uint64_t m_morphedParts = 0; ///< so far: each has a key of its own
};
