#include "apps/terrane-accuracy/TeLodCandidate.h"

#include "apps/terrane-accuracy/TeLayoutText.h"
#include "nodes/lod/TeLodMethods.h"
#include "nodes/lod/seamless/TeSeamlessLod.h"

#include <algorithm>

namespace {

const std::string kMorphed = TeLodCandidate::morphedName({});

bool isMorphed(const std::string& name) {
  return name.size() > kMorphed.size() &&
         name.compare(name.size() - kMorphed.size(), kMorphed.size(), kMorphed) == 0;
}

std::string plainName(const std::string& name) {
  return isMorphed(name) ? name.substr(0, name.size() - kMorphed.size()) : name;
}

} // namespace

std::string TeLodCandidate::checkName(const std::string& name) {
  const std::vector<std::string>& known = TeLodMethods::names();
  if (std::find(known.begin(), known.end(), plainName(name)) != known.end())
    return {};
  std::string all;
  for (const std::string& method : known)
    all += (all.empty() ? "" : ", ") + method;
  return "'" + name + "' is none of " + all + ", or one of them with " + kMorphed;
}

TeResult<TeLodCandidate> TeLodCandidate::create(const std::string& name, const std::string& layout,
                                                TeLodFieldPtr field) {
  TeLodCandidate candidate;
  candidate.m_name = name;
  candidate.m_geomorph = isMorphed(name);
  const std::string plain = plainName(name);
  TeSeamlessLod::Settings settings;
  const bool hasLayout = plain == "seamless";
  if (hasLayout && !teReadLayout(layout, settings.minResolution, settings.levels))
    return TeError{"--layout " + layout + " is not LOWEST/LEVELS"};
  TeResult<std::unique_ptr<TeLodMethod>> method = hasLayout
                                                      ? TeSeamlessLod::create(std::move(field), settings)
                                                      : TeLodMethods::create(plain, std::move(field));
  if (!method)
    return hasLayout ? TeError{"--layout " + layout + ": " + method.error().message} : method.error();
  if (candidate.m_geomorph && !(*method)->morphs())
    return TeError{plain + " does not morph"};
  if (hasLayout)
    candidate.m_layout = layout;
  candidate.m_method = std::move(*method);
  return candidate;
}

void TeLodCandidate::select(const TeLodView& view, TeLodAccuracy accuracy) {
  accuracy.geomorph = m_geomorph;
  m_method->select(view, accuracy);
}

std::int64_t TeLodCandidate::drawCalls() const {
  if (const auto* seamless = dynamic_cast<const TeSeamlessLod*>(m_method.get()))
    return std::int64_t(seamless->drawCalls());
  return std::int64_t(selection().parts.size());
}

std::int64_t TeLodCandidate::uploadBytes(const std::unordered_set<std::uint64_t>& known) const {
  if (dynamic_cast<const TeSeamlessLod*>(m_method.get()))
    return std::int64_t(selection().parts.size() * sizeof(TeSeamlessInstance));
  TeLodMesh added;
  for (std::size_t part = 0; part < selection().parts.size(); part++)
    if (known.count(selection().parts[part].key) == 0)
      m_method->appendPart(part, added);
  constexpr std::size_t kVertexBytes = 3 * sizeof(float);
  return std::int64_t(added.vertices.size() * kVertexBytes +
                      (added.indices.size() + added.skirts.size()) * sizeof(std::uint32_t));
}
