#include "apps/terrane-view/TeLodNodes.h"

#include <Inventor/SoPath.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/nodes/SoCamera.h>

#include <algorithm>

namespace {

using Node = SoTeSeamlessPatches;

/// Whether a node has what a colouring needs.
bool hasPictures(const Node& node, int colouring) {
  constexpr int kDetails = 4;
  if (colouring == Node::TEXTURE)
    return node.texture.getValue().getLength() > 0 || node.colors.getValue();
  if (colouring == Node::DETAIL)
    return node.mask.getValue().getLength() > 0 && node.detailTextures.getNum() == kDetails;
  return true;
}

/// All nodes of a class, each once.
template <class Type> std::vector<TeNodePtr<Type>> allOf(SoNode* scene) {
  SoSearchAction search;
  search.setType(Type::getClassTypeId());
  search.setInterest(SoSearchAction::ALL);
  search.setSearchingAll(TRUE);
  search.apply(scene);
  std::vector<TeNodePtr<Type>> nodes;
  for (int i = 0; i < search.getPaths().getLength(); ++i) {
    Type* node = static_cast<Type*>(search.getPaths()[i]->getTail());
    const auto same = [&](const TeNodePtr<Type>& other) { return other.get() == node; };
    if (std::none_of(nodes.begin(), nodes.end(), same))
      nodes.emplace_back(node);
  }
  return nodes;
}

/// Only where it differs, so that nothing is redrawn without need.
template <class Field, class Value> void set(Field& field, const Value& value) {
  if (field.getValue() != value)
    field = value;
}

} // namespace

TeLodNodes::TeLodNodes(SoNode* scene, const TeViewOptions& options)
    : m_nodes(allOf<Node>(scene)), m_lodTerrains(allOf<SoTeLodTerrain>(scene)),
      m_shapes(allOf<SoTeLodShape>(scene)) {
  if (options.precision)
    setPrecision(*options.precision);
  if (options.pixelError)
    setPixelError(*options.pixelError);
  if (options.geomorph)
    setGeomorph(true);
  if (options.classic)
    setInstancing(false);
}

TeSeamlessStatistics TeLodNodes::seamlessStatistics() const {
  TeSeamlessStatistics sum;
  for (const TeNodePtr<Node>& node : m_nodes) {
    const TeSeamlessStatistics& one = node->statistics();
    sum.faces += one.faces;
    sum.drawCalls += one.drawCalls;
    sum.traversed += one.traversed;
    sum.culled += one.culled;
    sum.rendered += one.rendered;
    sum.bytesUploaded += one.bytesUploaded;
    sum.selectionSeconds += one.selectionSeconds;
    sum.errorBound = std::max(sum.errorBound, one.errorBound);
    sum.precision = std::max(sum.precision, one.precision);
    sum.heightBytes += one.heightBytes;
    sum.clipTextureBytes += one.clipTextureBytes;
  }
  return sum;
}

TeSeamlessStatistics TeLodNodes::statistics() const {
  TeSeamlessStatistics sum = seamlessStatistics();
  for (const TeNodePtr<SoTeLodTerrain>& node : m_lodTerrains) {
    const TeLodStatistics& one = node->statistics();
    sum.faces += one.triangles;
    sum.drawCalls += one.drawCalls;
    sum.traversed += one.visited;
    sum.culled += one.culled;
    sum.rendered += one.parts;
    sum.bytesUploaded += one.bytesUploaded;
    sum.selectionSeconds += one.selectionSeconds;
    sum.errorBound = std::max(sum.errorBound, one.errorBound);
  }
  return sum;
}

bool TeLodNodes::areLoading() const {
  return std::any_of(m_nodes.begin(), m_nodes.end(),
                     [](const TeNodePtr<Node>& node) { return node->isLoading(); });
}

bool TeLodNodes::instancing() const { return !anySeamless() || m_nodes.front()->instancing.getValue(); }

bool TeLodNodes::geomorph() const { return any() && m_shapes.front()->geomorph.getValue(); }

double TeLodNodes::precision() const {
  return anySeamless() ? double(m_nodes.front()->precision.getValue()) : 2;
}

double TeLodNodes::pixelError() const { return any() ? double(m_shapes.front()->pixelError.getValue()) : 0; }

std::string TeLodNodes::colouring() const {
  if (!anySeamless())
    return {};
  SbString name;
  m_nodes.front()->coloring.get(name);
  std::string text = name.getString();
  for (char& letter : text)
    letter = char(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

void TeLodNodes::setInstancing(bool on) {
  for (const TeNodePtr<Node>& node : m_nodes)
    set(node->instancing, SbBool(on));
}

void TeLodNodes::setGeomorph(bool on) {
  for (const TeNodePtr<SoTeLodShape>& node : m_shapes)
    set(node->geomorph, SbBool(on));
}

void TeLodNodes::setPrecision(double precision) {
  for (const TeNodePtr<Node>& node : m_nodes) {
    set(node->precision, float(precision));
    set(node->pixelError, 0.0f);
  }
}

void TeLodNodes::setPixelError(double pixels) {
  for (const TeNodePtr<SoTeLodShape>& node : m_shapes)
    set(node->pixelError, float(pixels));
}

void TeLodNodes::setWireframe(bool on) {
  for (const TeNodePtr<SoTeLodShape>& node : m_shapes)
    set(node->wireframe, SbBool(on));
}

void TeLodNodes::nextColouring() {
  constexpr int kColourings = Node::HEIGHT + 1;
  for (const TeNodePtr<Node>& node : m_nodes) {
    int next = node->coloring.getValue();
    do
      next = (next + 1) % kColourings;
    while (!hasPictures(*node, next));
    set(node->coloring, next);
  }
}

void TeLodNodes::setLodCamera(SoCamera* camera) {
  for (const TeNodePtr<SoTeLodShape>& node : m_shapes)
    set(node->lodCamera, static_cast<SoNode*>(camera));
}
