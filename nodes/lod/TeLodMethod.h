#pragma once

#include "generators/base/TeAllowance.h"
#include "nodes/lod/TeLodField.h"
#include "nodes/lod/TeLodSelection.h"
#include "nodes/lod/TeLodView.h"

#include <string>

/// What the document of a method turns to make it finer or coarser.
struct TeLodDial {
  std::string name; ///< with its unit: "triangles", "threshold"; empty: there is none
  bool finerIsLarger = true;
  double least = 0; ///< of its range
  double most = 0;
};

/// A way to draw a large terrain by as few triangles as a view needs.
///
/// Contract. Vertices lie on samples. What is selected covers every sample in view exactly once and fits
/// without cracks (skirts cover them, if the method has any); triangles may be left out only where nothing of
/// them is in view. No sample in view deviates by more than selection().errorBound pixels, which is at most
/// the wanted error wherever samples and budget suffice; with a pixelError of 0 the surface is that of all
/// samples. TeLodView::slack counts: the true eye may be nearer to everything by that.
/// The same view, accuracy and history give the same selection; methods that keep no mesh from frame to frame
/// have no history.
///
/// No Coin, no OpenGL. One thread at a time; what methods share is immutable.
class TeLodMethod {
public:
  explicit TeLodMethod(TeLodFieldPtr field) : m_field(std::move(field)) {}
  virtual ~TeLodMethod() = default;
  TeLodMethod(const TeLodMethod&) = delete;
  TeLodMethod& operator=(const TeLodMethod&) = delete;

  const TeLodField& field() const { return *m_field; }
  virtual std::string name() const = 0; ///< as in options and tables: "seamless"
  virtual const TeLodDial& dial() const = 0;
  virtual bool morphs() const { return false; }
  /// Main memory for one sample, with the sample itself and what the last selections took.
  virtual double bytesPerSample() const = 0;

  /// Replaces the selection. `allowance`: how much may be done (a unit is a small change of the mesh);
  /// methods that choose anew each time do not look at it. Returns selection().complete.
  bool select(const TeLodView& view, const TeLodAccuracy& accuracy, TeAllowance& allowance);
  bool select(const TeLodView& view, const TeLodAccuracy& accuracy);
  const TeLodSelection& selection() const { return m_selection; }

  /// Appends the triangles of selection().parts[part]. Their vertices are shared within the part only.
  virtual void appendPart(std::size_t part, TeLodMesh& mesh) const = 0;
  /// Of all parts.
  void appendMesh(TeLodMesh& mesh) const;

protected:
  /// Chooses with an accuracy that is in range. `selection` is as made by default. May stop early once it has
  /// more triangles than the budget: it is then asked again, for less accuracy.
  virtual void choose(const TeLodView& view, const TeLodAccuracy& accuracy, TeAllowance& allowance,
                      TeLodSelection& selection) = 0;
  /// False: choose() keeps the budget itself, or nothing can.
  virtual bool coarsens() const { return true; }

private:
  TeLodFieldPtr m_field;
  TeLodSelection m_selection;
};
