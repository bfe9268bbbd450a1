// Runs a fuzzer's function on files that are there already, in place of the fuzzer, with any compiler: on each file and on
// the files in each folder that are given.

#include "standard_library.h"

#include <cstdio>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fs = std::filesystem;

int main(int argc, char** argv)
{
  std::vector<fs::path> files;
  try
  {
    for(int i = 1; i < argc; ++i)
    {
      if(!fs::is_directory(argv[i]))
        files.emplace_back(argv[i]);
      else
        for(const fs::directory_entry& entry : fs::directory_iterator(argv[i]))
          files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for(const fs::path& file : files)
    {
      std::printf("%s\n", file.string().c_str()); // the last one before a crash is the one
      std::fflush(stdout);
      std::ifstream in(file, std::ios::binary);
      const std::string content((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
      if(!in)
      {
        std::fprintf(stderr, "The file cannot be read.\n");
        return EXIT_FAILURE;
      }
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(content.data()), content.size());
    }
  }
  catch(const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
  }
  std::printf("%zu files\n", files.size());
  return files.empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}
