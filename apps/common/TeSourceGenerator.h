#pragma once

#include "generators/TeGenerator.h"

/// A source that was made already, such as an elevation file that is open, as a generator for TeEngine.
class TeSourceGenerator : public TeGenerator {
public:
  explicit TeSourceGenerator(TeHeightSourcePtr source) : m_made(std::move(source)) {}
  std::string name() const override { return m_made->name(); }
  TeParameters parameters() override { return {}; }

protected:
  void setDefaults() override {}
  TeResult<TeHeightSourcePtr> makeSource() const override { return m_made; }

private:
  TeHeightSourcePtr m_made;
};
