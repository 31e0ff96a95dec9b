#pragma once

/// Registers the node class of a file that names a TeClipmap in a program that is not linked with Terrane:
/// Coin looks for libTeClipmap.so and calls this by its mangled name. May be called again.
class TeClipmap {
public:
  static void initClass();
};
