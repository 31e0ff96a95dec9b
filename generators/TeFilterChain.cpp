#include "generators/TeFilterChain.h"

TeFilterChain::TeFilterChain(std::unique_ptr<TeGenerator> generator,
                             std::vector<std::unique_ptr<TeFilter>> filters)
    : m_generator(std::move(generator)), m_filters(std::move(filters)) {
  assert(m_generator);
}

std::string TeFilterChain::name() const {
  std::string name = m_generator->name();
  for (const auto& filter : m_filters)
    name += "+" + filter->name();
  return name;
}

TeParameters TeFilterChain::parameters() {
  TeParameters all = m_generator->parameters();
  for (std::size_t i = 0; i < m_filters.size(); ++i) {
    std::size_t same = 1;
    for (std::size_t before = 0; before < i; ++before)
      same += m_filters[before]->name() == m_filters[i]->name();
    const std::string prefix = m_filters[i]->name() + (same > 1 ? std::to_string(same) : "") + ".";
    for (TeParameter parameter : m_filters[i]->parameters()) {
      parameter.name = prefix + parameter.name;
      all.push_back(std::move(parameter));
    }
  }
  return all;
}

TeResult<TeHeightSourcePtr> TeFilterChain::makeSource() const {
  if (TeStatus ok = m_generator->updateParams(); !ok)
    return ok.error();
  TeHeightSourcePtr source = m_generator->source();
  for (const auto& filter : m_filters) {
    TeResult<TeHeightSourcePtr> filtered = filter->apply(std::move(source));
    if (!filtered)
      return filtered;
    source = std::move(*filtered);
  }
  return source;
}
