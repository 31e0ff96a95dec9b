// A program that knows Coin and nothing of Terrane: reads a scene, counts what it draws, writes it back.
// readByName SCENE.iv CLASS OUT.iv; exit status 0 if a node of the class was there and drew triangles.

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/SoOutput.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/actions/SoWriteAction.h>
#include <Inventor/nodes/SoSeparator.h>

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 4)
    return 2;
  SoDB::init();
  SoInput input;
  if (!input.openFile(argv[1]))
    return 2;
  SoSeparator* root = SoDB::readAll(&input);
  if (!root)
    return 1;
  root->ref();
  const SoType type = SoType::fromName(argv[2]);
  if (type == SoType::badType()) {
    std::printf("no class %s\n", argv[2]);
    return 1;
  }
  SoSearchAction search;
  search.setType(type);
  search.apply(root);
  if (!search.getPath()) {
    std::printf("no node of class %s\n", argv[2]);
    return 1;
  }
  SoGetPrimitiveCountAction count;
  count.apply(root);
  std::printf("%s: %d triangles\n", argv[2], count.getTriangleCount());
  SoOutput output;
  if (!output.openFile(argv[3]))
    return 2;
  SoWriteAction write(&output);
  write.apply(root);
  output.closeFile();
  root->unref();
  return count.getTriangleCount() > 0 ? 0 : 1;
}
