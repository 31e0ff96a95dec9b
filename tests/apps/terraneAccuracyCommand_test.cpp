// The frame of terrane-accuracy's sub-commands, around one that measures nothing.

#include "apps/TeAppRun.h"
#include "apps/terrane-accuracy/TeAccuracyCommand.h"

#include <fstream>

namespace {

class Command : public TeAccuracyCommand {
public:
  explicit Command(TeCommandLine& commandLine)
      : TeAccuracyCommand(commandLine, "nothing", "Measures nothing") {
    addInteger("--count", count, 1, 9, "How many");
    addNumber("--factor", factor, 0, 1, "How much");
    addList("--list", list, TeCommandLine::within(1, 4), "Which");
    addNoDraw("Draws nothing");
    addOutput();
  }

  int count = 3;
  double factor = 0.5;
  std::vector<double> list;
  std::string fails; ///< in which step
  std::vector<std::string> steps;
  bool hasStage = false;
  int framesOfEight = 0;

private:
  TeStatus done(const std::string& step) {
    steps.push_back(step);
    return fails == step ? TeStatus(TeError{step + " failed"}) : TeStatus();
  }
  TeStatus read() override { return done("read"); }
  TeResult<TeTable> measure(TeAccuracyOutput& output) override {
    if (const TeStatus ok = done("measure"); !ok)
      return ok.error();
    const auto stage = makeStage();
    if (!stage)
      return stage.error();
    hasStage = *stage != nullptr;
    framesOfEight = framesOr(8);
    TeTable table({"count"});
    table.addRow({std::int64_t(count)});
    output.addTable(table);
    return table;
  }
  TeStatus finish() override { return done("finish"); }
};

class TerraneAccuracyCommand : public TeAppRun {
protected:
  TerraneAccuracyCommand() : TeAppRun("terrane-accuracy") {}

  /// The exit status.
  int runWith(std::vector<std::string> words) { return runInto(scratch("out"), std::move(words)); }
  int runInto(const std::string& folder, std::vector<std::string> words) {
    words.insert(words.begin(), {"program", "nothing", "--out", folder});
    std::vector<char*> arguments;
    for (std::string& word : words)
      arguments.push_back(word.data());
    if (const std::optional<int> status = m_line.parse(int(arguments.size()), arguments.data()))
      return *status;
    EXPECT_TRUE(command.isChosen());
    return command.run();
  }
  bool isWritten(const std::string& file) const { return std::filesystem::exists(scratch("out/" + file)); }

private:
  TeCommandLine m_line{"program", "Has one sub-command"};

public:
  Command command{m_line};
};

using Steps = std::vector<std::string>;

TEST_F(TerraneAccuracyCommand, ReadsMeasuresAndWrites) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(runWith({"--count", "7", "--factor", "0.25", "--list", "1,2.5", "--no-draw", "--frames", "5"}),
            0);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "| count |\n|---|\n| 7 |\n");
  EXPECT_EQ(command.steps, (Steps{"read", "measure", "finish"}));
  EXPECT_EQ(command.factor, 0.25);
  EXPECT_EQ(command.list, (std::vector<double>{1, 2.5}));
  EXPECT_FALSE(command.hasStage);
  EXPECT_EQ(command.framesOfEight, 5);
  std::ifstream csv(scratch("out/nothing.csv"));
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(csv), {}), "count\n7\n");
  EXPECT_TRUE(isWritten("nothing.json") && isWritten("nothing.md"));
}

TEST_F(TerraneAccuracyCommand, QuietSaysNothing) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(runWith({"--quiet", "--no-draw"}), 0);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(command.framesOfEight, 8);
}

TEST_F(TerraneAccuracyCommand, BadInputIsBadUsageAndWritesNothing) {
  command.fails = "read";
  EXPECT_EQ(runWith({"--no-draw"}), 2);
  EXPECT_EQ(command.steps, Steps{"read"});
  EXPECT_FALSE(isWritten(""));
}

TEST_F(TerraneAccuracyCommand, WorkThatFailsLeavesNoTable) {
  command.fails = "measure";
  EXPECT_EQ(runWith({"--no-draw"}), 1);
  EXPECT_EQ(command.steps, (Steps{"read", "measure"}));
  EXPECT_TRUE(isWritten(""));
  EXPECT_FALSE(isWritten("nothing.csv"));
}

TEST_F(TerraneAccuracyCommand, WhatFailsInTheEndLeavesTheTable) {
  command.fails = "finish";
  EXPECT_EQ(runWith({"--no-draw", "--quiet"}), 1);
  EXPECT_TRUE(isWritten("nothing.csv"));
}

TEST_F(TerraneAccuracyCommand, AFolderThatCannotBeMadeIsSeenBeforeTheWork) {
  EXPECT_EQ(runInto("/dev/null/x", {"--no-draw"}), 1);
  EXPECT_EQ(command.steps, Steps{"read"});
}

TEST_F(TerraneAccuracyCommand, OptionsRefuseWhatIsOutOfRange) {
  EXPECT_EQ(runWith({"--count", "0"}), 2);
  EXPECT_EQ(runWith({"--factor", "1.5"}), 2);
  EXPECT_EQ(runWith({"--list", "1,5"}), 2);
  EXPECT_EQ(runInto("", {}), 2);
  EXPECT_TRUE(command.steps.empty());
}

} // namespace
