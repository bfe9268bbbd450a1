// Reads files of cortical surfaces and writes what is in them in another format, for check_surface_files.py, which compares
// both with what nibabel reads.

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Cortex/FreeSurfer.h>
#include <CGAL/Spherical_parameterization/Cortex/GIFTI.h>
#include <CGAL/Spherical_parameterization/Cortex/MGH.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <string>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using SP::IO::Surface_file;

const std::map<std::string, SP::Error_code (*)(std::istream&, Surface_file&, std::string&)> readers = {
    {"surface", SP::IO::read_FreeSurfer_surface},
    {"curv", SP::IO::read_FreeSurfer_curv},
    {"annot", SP::IO::read_FreeSurfer_annotation},
    {"label", SP::IO::read_FreeSurfer_label},
    {"gifti", SP::IO::read_GIFTI},
    {"mgh", SP::IO::read_MGH}};

const std::map<std::string, SP::Error_code (*)(std::ostream&, const Surface_file&, std::string&)> writers = {
    {"surface", SP::IO::write_FreeSurfer_surface},
    {"curv", [](auto& out, const auto& file,
                auto& message) { return SP::IO::write_FreeSurfer_curv(out, file.columns.front(), 0, message); }},
    {"annot", SP::IO::write_FreeSurfer_annotation},
    {"gifti", [](auto& out, const auto& file, auto& message) { return SP::IO::write_GIFTI(out, file, message); }},
    {"mgh", [](auto& out, const auto& file, auto& message) { return SP::IO::write_MGH(out, file, message, false); }},
    {"mgz", [](auto& out, const auto& file, auto& message) { return SP::IO::write_MGH(out, file, message, true); }}};

} // namespace

// The arguments are a format, a file, another format and a file to be written, and so on. Prints the warnings of each.
int main(int argc, char** argv)
{
  int status = EXIT_SUCCESS;
  for(int i = 1; i + 3 < argc; i += 4)
  {
    Surface_file file;
    std::string message;
    std::ifstream in(argv[i + 1], std::ios::binary);
    SP::Error_code error = readers.at(argv[i])(in, file, message);
    if(error == SP::OK)
    {
      std::ofstream out(argv[i + 3], std::ios::binary);
      std::string problem;
      error = writers.at(argv[i + 2])(out, file, problem);
      message += problem;
    }
    if(error != SP::OK)
      status = EXIT_FAILURE;
    if(!message.empty())
      std::cout << argv[i + 1] << ": " << message << std::endl;
  }
  return status;
}
