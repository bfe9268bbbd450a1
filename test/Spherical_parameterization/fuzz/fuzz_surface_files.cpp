// A fuzzer for files of cortical surfaces. The first byte chooses the format, the others are the file. Whatever they are, they are
// refused with a message for a person, or what is read is consistent, and the same after it has been written and read again. Whatever
// is written in any format can be read.

#include "Fuzzed_bytes.h"
#include "require.h"

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Cortex/FreeSurfer.h>
#include <CGAL/Spherical_parameterization/Cortex/GIFTI.h>
#include <CGAL/Spherical_parameterization/Cortex/MGH.h>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using SP::IO::Surface_file;

struct Format
{
  SP::Error_code (*read)(std::istream&, Surface_file&, std::string&);
  SP::Error_code (*write)(std::ostream&, const Surface_file&, std::string&); // what has been read; null for labels
};

SP::Error_code write_curv(std::ostream& out, const Surface_file& file, std::string& message)
{
  message = "There is no column.";
  return file.columns.empty() ? SP::ERROR_WRONG_PARAMETER
                              : SP::IO::write_FreeSurfer_curv(out, file.columns.front(), 0, message);
}

SP::Error_code write_mgh(std::ostream& out, const Surface_file& file, std::string& message)
{
  return SP::IO::write_MGH(out, file, message, false);
}

SP::Error_code write_gifti(std::ostream& out, const Surface_file& file, std::string& message)
{
  return SP::IO::write_GIFTI(out, file, message);
}

const Format formats[] = {{SP::IO::read_FreeSurfer_surface, SP::IO::write_FreeSurfer_surface},
                          {SP::IO::read_FreeSurfer_curv, write_curv},
                          {SP::IO::read_FreeSurfer_annotation, SP::IO::write_FreeSurfer_annotation},
                          {SP::IO::read_FreeSurfer_label, nullptr},
                          {SP::IO::read_MGH, write_mgh},
                          {SP::IO::read_GIFTI, write_gifti}};

void check_consistency(const Surface_file& file)
{
  for(const auto& t : file.triangles)
    for(const std::uint32_t v : t)
      require(v < file.points.size(), "a corner is no point");
  for(const auto& column : file.columns)
    require(column.values.size() == file.columns.front().values.size(), "columns have different lengths");
}

// rounded to 32 bits, as they are written
bool are_same(const std::vector<double>& a, const std::vector<double>& b)
{
  bool result = a.size() == b.size();
  for(std::size_t k = 0; result && k < a.size(); ++k)
    result = a[k] == b[k] || static_cast<float>(a[k]) == static_cast<float>(b[k]) || (a[k] != a[k] && b[k] != b[k]);
  return result;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Fuzzed_bytes bytes(data, size);
  const Format& format = formats[bytes.below(sizeof formats / sizeof *formats)];
  std::istringstream in(bytes.rest());
  Surface_file file;
  std::string message;
  if(const SP::Error_code error = format.read(in, file, message))
  {
    require(error == SP::ERROR_INVALID_SURFACE_FILE && is_message(message), message.c_str());
    return 0;
  }
  check_consistency(file);
  for(const Format& other : formats)
  {
    std::stringstream written;
    if(other.write == nullptr)
      continue;
    if(other.write(written, file, message) != SP::OK)
    {
      require(is_message(message) && written.str().empty(), message.c_str());
      continue;
    }
    Surface_file again;
    require(other.read(written, again, message) == SP::OK, message.c_str());
    if(&other != &format)
      continue;
    require(again.triangles == file.triangles && again.columns.size() == file.columns.size() &&
                again.points.size() == file.points.size() && again.vertices == file.vertices,
            "what is written is read otherwise");
    for(std::size_t k = 0; k < file.columns.size(); ++k)
      require(are_same(file.columns[k].values, again.columns[k].values), "values are read otherwise");
  }
  return 0;
}
