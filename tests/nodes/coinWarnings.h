#pragma once

#include <Inventor/errors/SoDebugError.h>

#include <string>
#include <vector>

/// Warnings of Coin and of nodes for as long as it lives.
class CoinWarnings {
public:
  CoinWarnings() { SoDebugError::setHandlerCallback(note, this); }
  ~CoinWarnings() { SoDebugError::setHandlerCallback(m_handler, m_data); }
  CoinWarnings(const CoinWarnings&) = delete;
  CoinWarnings& operator=(const CoinWarnings&) = delete;
  std::vector<std::string> lines;

private:
  SoErrorCB* m_handler = SoDebugError::getHandlerCallback();
  void* m_data = SoDebugError::getHandlerData();
  static void note(const SoError* error, void* data) {
    static_cast<CoinWarnings*>(data)->lines.push_back(error->getDebugString().getString());
  }
};
