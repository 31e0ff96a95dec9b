#pragma once

class TeGeneratorRegistry;

/// Adds our own generators and filters; called once for TeGeneratorRegistry::instance().
void teAddBuiltInGenerators(TeGeneratorRegistry& registry);
