#include "apps/terrane-accuracy/TeAccuracyCommand.h"

#include "apps/common/TeExit.h"

TeAccuracyCommand::TeAccuracyCommand(TeCommandLine& commandLine, const std::string& name,
                                     const std::string& description)
    : m_commandLine(commandLine), m_cli(commandLine.cli().add_subcommand(name, description)) {
  m_cli->fallthrough();
}

CLI::Option* TeAccuracyCommand::addInteger(const std::string& name, int& value, int minimum, int maximum,
                                           const std::string& help) {
  return m_cli->add_option(name, value, help)
      ->transform(TeCommandLine::wholeWithin(minimum, maximum))
      ->option_text("N")
      ->group(kGroup);
}

CLI::Option* TeAccuracyCommand::addNumber(const std::string& name, double& value, double minimum,
                                          double maximum, const std::string& help) {
  return m_cli->add_option(name, value, help)
      ->check(TeCommandLine::within(minimum, maximum))
      ->option_text("X")
      ->group(kGroup);
}

CLI::Option* TeAccuracyCommand::addFlag(const std::string& name, bool& value, const std::string& help) {
  return m_cli->add_flag(name, value, help)->group(kGroup);
}

CLI::Option* TeAccuracyCommand::addFolder(const std::string& name, std::string& folder,
                                          const std::string& help) {
  return m_cli->add_option(name, folder, help)
      ->check(TeCommandLine::notEmpty())
      ->option_text("DIR")
      ->group(kGroup);
}

TeResult<std::unique_ptr<TeFlightStage>> TeAccuracyCommand::makeStage() const {
  if (!draws())
    return std::unique_ptr<TeFlightStage>();
  return TeFlightStage::create(*teContextKind(common().context), common().width, common().height);
}

int TeAccuracyCommand::run() {
  const auto fail = [&](TeExit status, const TeError& error) {
    return teExitWith(status, m_commandLine.application(), error.message);
  };
  TeAccuracyOutput output(m_commandLine, m_cli->get_name(), m_folder);
  if (const TeStatus ok = read(); !ok)
    return fail(TeExitUsage, ok.error());
  if (const TeStatus ok = output.prepare(); !ok)
    return fail(TeExitFailure, ok.error());
  const TeResult<TeTable> table = measure(output);
  if (!table)
    return fail(TeExitFailure, table.error());
  if (const TeStatus ok = output.write(*table); !ok)
    return fail(TeExitFailure, ok.error());
  if (const TeStatus ok = finish(); !ok)
    return fail(TeExitFailure, ok.error());
  return TeExitSuccess;
}
