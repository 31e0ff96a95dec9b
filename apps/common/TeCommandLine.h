#pragma once

#include "apps/common/TeCommonOptions.h"

#include <CLI/CLI.hpp>
#include <glm/vec2.hpp>

#include <optional>
#include <string>

/// The command line of an application: the common options, to which it adds its own through cli().
class TeCommandLine {
public:
  /// Without `draws` it has only those common options that do not concern drawing.
  TeCommandLine(const std::string& application, const std::string& description, bool draws = true);

  CLI::App& cli() { return m_cli; }
  const TeCommonOptions& common() const { return m_common; }
  const std::string& application() const { return m_application; }
  /// The arguments as given, for the report.
  const std::string& commandText() const { return m_commandText; }

  /// Reads the arguments. A value means that the application is to end with it: help or version were printed,
  /// or one line about what is wrong.
  std::optional<int> parse(int argc, char** argv);

  /// `--option NUMBER` with a finite value within [minimum, maximum].
  CLI::Option* addNumber(const std::string& name, double& value, double minimum, double maximum,
                         const std::string& help);
  CLI::Option* addInteger(const std::string& name, int& value, int minimum, int maximum,
                          const std::string& help);
  /// `--option X,Y`, both finite.
  CLI::Option* addPoint(const std::string& name, glm::dvec2& value, const std::string& help);

  /// Accepts numbers from minimum to maximum. (CLI11's own range check lets NaN pass.)
  static CLI::Validator within(double minimum, double maximum);
  /// Accepts decimal whole numbers from minimum to maximum. (CLI11 takes 010 for 8.) Give it to an option's
  /// transform(), for it rewrites the number.
  static CLI::Validator wholeWithin(int minimum, int maximum);
  static CLI::Validator notEmpty();

private:
  void addDrawing(const std::string& group);

  CLI::App m_cli;
  TeCommonOptions m_common;
  std::string m_application;
  std::string m_commandText;
  std::string m_size = "1024x768";
};
