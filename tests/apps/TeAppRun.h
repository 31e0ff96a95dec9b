#pragma once

#include "apps/TeChildProcess.h"
#include "nodes/TePicture.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// Runs of an application, each test in a scratch folder of its own.
class TeAppRun : public testing::Test {
protected:
  explicit TeAppRun(const std::string& program);
  ~TeAppRun() override;

  /// Without a display.
  TeChildResult run(const std::vector<std::string>& arguments, double seconds = 60) const;
  /// Tells of no success: the status, one line that begins with the program's name, and what it mentions.
  void expectRefused(const std::vector<std::string>& arguments, int status,
                     const std::string& mentioned) const;
  /// With --offscreen and --report, in the given context; must succeed.
  TePicture draw(std::vector<std::string> arguments, const std::string& context = "osmesa");
  /// Of the last draw().
  const nlohmann::json& report() const { return m_report; }

  std::string scratch(const std::string& name) const { return (m_folder / name).string(); }
  /// A file of the test data; empty if there is none on this machine.
  static std::string data(const std::string& name);

private:
  std::string m_program;
  std::filesystem::path m_folder;
  nlohmann::json m_report;
};

/// Share of the pixels that are not the sky.
double teGroundShare(const TePicture& picture);
/// Share of the pixels of which a channel differs by more than `most`.
double teDifferingShare(const TePicture& a, const TePicture& b, int most = 0);
