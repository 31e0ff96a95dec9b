#pragma once

/// Registers the node class of a file that names a TeSeamlessPatches in a program that is not linked with
/// Terrane: Coin looks for libTeSeamlessPatches.so and calls this by its mangled name. May be called again.
class TeSeamlessPatches {
public:
  static void initClass();
};
