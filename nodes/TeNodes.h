#pragma once

/// Makes Coin ready and registers all of Terrane's nodes and details with it; may be called again.
class TeNodes {
public:
  static void init();
};
