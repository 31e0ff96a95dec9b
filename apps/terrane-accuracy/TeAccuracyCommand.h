#pragma once

#include "apps/common/TeCommandLine.h"
#include "apps/terrane-accuracy/TeAccuracyOutput.h"
#include "apps/terrane-accuracy/TeFlightStage.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

/// A sub-command of terrane-accuracy: its options, and the frame in which it reads its input, measures and
/// writes NAME.csv, NAME.json, NAME.md and diagrams into one folder.
class TeAccuracyCommand {
public:
  virtual ~TeAccuracyCommand() = default;
  TeAccuracyCommand(const TeAccuracyCommand&) = delete;
  TeAccuracyCommand& operator=(const TeAccuracyCommand&) = delete;

  /// Whether the command line has named it.
  bool isChosen() const { return m_cli->parsed(); }
  /// Once, after parsing. Returns the exit status.
  int run();

protected:
  TeAccuracyCommand(TeCommandLine& commandLine, const std::string& name, const std::string& description);

  /// Reads and checks what is measured. Error: bad usage or bad input; nothing has been written then.
  virtual TeStatus read() { return {}; }
  /// Measures, and describes it all in `output` but for the table that it returns, which becomes NAME.csv.
  /// Error: the work failed.
  virtual TeResult<TeTable> measure(TeAccuracyOutput& output) = 0;
  /// After all is written. Error: the work failed.
  virtual TeStatus finish() { return {}; }

  // Options are listed in the order in which they are added.
  CLI::App& cli() { return *m_cli; }
  static constexpr const char* kGroup = "Measuring"; ///< of all that these add
  CLI::Option* addInteger(const std::string& name, int& value, int minimum, int maximum,
                          const std::string& help);
  CLI::Option* addNumber(const std::string& name, double& value, double minimum, double maximum,
                         const std::string& help);
  CLI::Option* addFlag(const std::string& name, bool& value, const std::string& help);
  /// `--name A,B,C`, each as `check` wants it.
  template <class Value>
  CLI::Option* addList(const std::string& name, std::vector<Value>& values, const CLI::Validator& check,
                       const std::string& help) {
    return m_cli->add_option(name, values, help)
        ->delimiter(',')
        ->check(check)
        ->option_text("LIST")
        ->group(kGroup);
  }
  void addNoDraw(const std::string& help) { addFlag("--no-draw", m_noDraw, help); }
  CLI::Option* addFolder(const std::string& name, std::string& folder, const std::string& help);
  /// The folder of what is measured.
  void addOutput(const std::string& name = "--out",
                 const std::string& help = "Folder for what is written (default: accuracy)") {
    addFolder(name, m_folder, help);
  }

  const TeCommandLine& commandLine() const { return m_commandLine; }
  const TeCommonOptions& common() const { return m_commandLine.common(); }
  const std::string& folder() const { return m_folder; }
  bool draws() const { return !m_noDraw; }
  int framesOr(int byDefault) const { return common().frames > 0 ? common().frames : byDefault; }
  /// A stage as the common options say; null with --no-draw.
  TeResult<std::unique_ptr<TeFlightStage>> makeStage() const;
  /// Puts what read() made in a place for measure().
  template <class Value> static TeStatus keep(TeResult<Value> made, std::optional<Value>& place) {
    if (!made)
      return made.error();
    place.emplace(std::move(*made));
    return {};
  }

private:
  TeCommandLine& m_commandLine;
  CLI::App* m_cli;
  bool m_noDraw = false;
  std::string m_folder = "accuracy";
};
