#pragma once

/// Registers the node class of a file that names a TeLodTerrain in a program that is not linked with Terrane:
/// Coin looks for libTeLodTerrain.so and calls this by its mangled name. May be called again.
class TeLodTerrain {
public:
  static void initClass();
};
