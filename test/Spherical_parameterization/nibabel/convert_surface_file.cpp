// Reads files of cortical surfaces and writes what is in them in another format, for check_surface_files.py, which compares
// both with what nibabel reads.

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Cortex/FreeSurfer.h>
#include <CGAL/Spherical_parameterization/Cortex/GIFTI.h>
#include <CGAL/Spherical_parameterization/Cortex/MGH.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace SP = CGAL::Spherical_parameterization;

namespace {

SP::Error_code read(const std::string& format, std::istream& in, SP::IO::Surface_file& file, std::string& message)
{
  if(format == "surface")
    return SP::IO::read_FreeSurfer_surface(in, file, message);
  if(format == "curv")
    return SP::IO::read_FreeSurfer_curv(in, file, message);
  if(format == "annot")
    return SP::IO::read_FreeSurfer_annotation(in, file, message);
  if(format == "label")
    return SP::IO::read_FreeSurfer_label(in, file, message);
  if(format == "gifti")
    return SP::IO::read_GIFTI(in, file, message);
  return SP::IO::read_MGH(in, file, message);
}

SP::Error_code write(const std::string& format, std::ostream& out, const SP::IO::Surface_file& file)
{
  if(format == "surface")
    return SP::IO::write_FreeSurfer_surface(out, file);
  if(format == "curv")
    return SP::IO::write_FreeSurfer_curv(out, file.columns.front(), 0);
  if(format == "annot")
    return SP::IO::write_FreeSurfer_annotation(out, file);
  if(format == "gifti")
    return SP::IO::write_GIFTI(out, file);
  return SP::IO::write_MGH(out, file, format == "mgz");
}

} // namespace

// The arguments are a format, a file, another format and a file to be written, and so on. Prints what is to be told of each.
int main(int argc, char** argv)
{
  int status = EXIT_SUCCESS;
  for(int i = 1; i + 3 < argc; i += 4)
  {
    SP::IO::Surface_file file;
    std::string message;
    std::ifstream in(argv[i + 1], std::ios::binary);
    SP::Error_code error = read(argv[i], in, file, message);
    if(error == SP::OK)
    {
      std::ofstream out(argv[i + 3], std::ios::binary);
      error = write(argv[i + 2], out, file);
      if(error != SP::OK)
        message = SP::get_error_message(error);
    }
    if(error != SP::OK)
      status = EXIT_FAILURE;
    if(!message.empty())
      std::cout << argv[i + 1] << ": " << message << std::endl;
  }
  return status;
}
