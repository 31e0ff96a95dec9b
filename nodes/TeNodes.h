#pragma once

/// Registers all of Terrane's nodes and details with Coin (after SoDB::init()); may be called again.
class TeNodes {
public:
  static void init();
};
