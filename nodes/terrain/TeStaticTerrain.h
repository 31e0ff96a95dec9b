#pragma once

/// Registers the node class of a file that names a TeStaticTerrain in a program that is not linked with
/// Terrane: Coin looks for libTeStaticTerrain.so and calls this by its mangled name. May be called again.
class TeStaticTerrain {
public:
  static void initClass();
};
