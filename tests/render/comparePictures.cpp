// comparePictures FOLDER FOLDER: two contexts must have drawn the same pictures. Equal to the bit if the same
// renderer drew them, else at most one pixel in a hundred may differ by more than 8 of 255.

#include "nodes/TePicture.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace {

std::string renderer(const std::filesystem::path& folder) {
  std::ifstream file(folder / "renderer.txt");
  std::string name;
  std::getline(file, name);
  return name;
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 3)
    return 2;
  const std::filesystem::path first = argv[1];
  const std::filesystem::path second = argv[2];
  const bool same = renderer(first) == renderer(second);
  int pictures = 0;
  long long differing = 0;
  long long pixels = 0;
  bool good = true;
  for (const auto& entry : std::filesystem::directory_iterator(first)) {
    if (entry.path().extension() != ".png")
      continue;
    const TeResult<TePicture> a = TePicture::readPng(entry.path().string());
    const TeResult<TePicture> b = TePicture::readPng((second / entry.path().filename()).string());
    if (!a || !b || a->width != b->width || a->height != b->height) {
      std::printf("%s: not drawn by both\n", entry.path().filename().c_str());
      return 1;
    }
    const int tolerance = same ? 0 : 8;
    int different = 0;
    for (std::size_t pixel = 0; pixel < a->rgba.size(); pixel += 4) {
      int worst = 0;
      for (int channel = 0; channel < 4; channel++)
        worst = std::max(worst, std::abs(int(a->rgba[pixel + channel]) - int(b->rgba[pixel + channel])));
      different += worst > tolerance;
    }
    if (different > (same ? 0 : a->width * a->height / 100)) {
      std::printf("%s: %d pixels differ\n", entry.path().filename().c_str(), different);
      good = false;
    }
    pictures++;
    differing += different;
    pixels += std::int64_t(a->width) * a->height;
  }
  std::printf("%d pictures of %lld pixels, drawn by \"%s\" and \"%s\": %lld pixels differ\n", pictures,
              pixels, renderer(first).c_str(), renderer(second).c_str(), differing);
  return good && pictures > 0 ? 0 : 1;
}
