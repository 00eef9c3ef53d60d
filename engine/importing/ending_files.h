#pragma once
// Files as assimp reads them, that end: some of its readers ask for more for ever, once a damaged file is at
// its end.

#include <assimp/DefaultIOSystem.h>

namespace fulcrum::importing {

class EndingFiles final : public Assimp::DefaultIOSystem {
public:
  Assimp::IOStream* Open(const char* file, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;
};

}  // namespace fulcrum::importing
