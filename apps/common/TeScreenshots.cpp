#include "apps/common/TeScreenshots.h"

#include "generators/base/TeLog.h"
#include "generators/base/TeText.h"

#include <filesystem>

namespace {

constexpr int kMostPictures = 1000;

} // namespace

void teSaveScreenshot(const TeResult<TePicture>& picture, const std::string& folder,
                      const std::string& name) {
  if (!picture)
    return TeLog::error("picture: " + picture.error().message);
  for (int number = 1; number < kMostPictures; ++number) {
    const std::filesystem::path path = std::filesystem::path(folder) / (name + teFormat("-%03d.png", number));
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored))
      continue;
    if (const TeStatus ok = picture->writePng(path.string()); !ok)
      return TeLog::error(ok.error().message);
    return TeLog::info("picture written: " + path.string());
  }
  TeLog::error(folder + ": holds " + std::to_string(kMostPictures - 1) + " pictures already; delete some");
}

TeStatus teKeepPicture(const TePicture& picture, const TeCommonOptions& common, TeReport& report) {
  if (picture.rgba.empty())
    return {};
  report.addPicture(picture);
  return common.offscreen.empty() ? TeStatus() : picture.writePng(common.offscreen);
}
