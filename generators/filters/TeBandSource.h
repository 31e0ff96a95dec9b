#pragma once

#include "generators/TeHeightSource.h"

/// What TeBandFilter makes: the maps of another source, band-filtered.
class TeBandSource final : public TeHeightSource {
public:
  TeBandSource(TeHeightSourcePtr input, float k, int passes)
      : m_input(std::move(input)), m_k(k), m_passes(passes) {}

  std::string name() const override { return m_input->name() + "+band"; }
  std::uint64_t fingerprint() const override;
  TeStatus accepts(int columns, int rows) const override;
  std::unique_ptr<TeHeightJob> start(const TeMapRequest& request) const override;

private:
  TeHeightSourcePtr m_input;
  float m_k;
  int m_passes;
};
