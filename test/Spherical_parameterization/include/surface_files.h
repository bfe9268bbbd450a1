#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_SURFACE_FILES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_SURFACE_FILES_H

// What the tests of files of cortical surfaces have in common: reading from texts, and what has to hold for each reader.

#include "Binary_file.h"

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Cortex/Surface_file.h>

#include <gtest/gtest.h>

namespace surface_files {

namespace SP = CGAL::Spherical_parameterization;
using SP::IO::Surface_file;
using SP::IO::Vertex_values;

using Reader = std::function<SP::Error_code(std::istream&, Surface_file&, std::string&)>;

struct Reading
{
  Reading(const Reader& reader, const std::string& content)
  {
    std::istringstream in(content);
    error = reader(in, file, message);
  }

  SP::Error_code error;
  Surface_file file;
  std::string message;
};

// Returns what is read, which has to be in order.
inline Surface_file read(const Reader& reader, const std::string& content, const std::string& message = "")
{
  const Reading reading(reader, content);
  EXPECT_EQ(reading.error, SP::OK) << reading.message;
  EXPECT_EQ(reading.message, message);
  return reading.file;
}

inline void expect_refused(const Reader& reader, const std::string& content, const std::string& part_of_message)
{
  Surface_file file;
  file.origin.created_by = "as it was";
  std::string message;
  std::istringstream in(content);
  EXPECT_EQ(reader(in, file, message), SP::ERROR_INVALID_SURFACE_FILE) << part_of_message;
  EXPECT_NE(message.find(part_of_message), std::string::npos) << message << "\nhas not: " << part_of_message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_EQ(file.origin.created_by, "as it was");
}

// What holds for whatever has been read.
inline void expect_consistent(const Surface_file& file)
{
  for(const auto& t : file.triangles)
    for(const std::uint32_t v : t)
      EXPECT_LT(v, file.points.size());
  for(const Vertex_values& column : file.columns)
    EXPECT_EQ(column.values.size(), file.columns.front().values.size());
}

// A file that ends early is refused wherever it ends, but for the sizes where it is complete as well; and a file with any
// byte changed is refused, or something that is consistent.
inline void expect_robust(const Reader& reader, const std::string& content, const std::set<std::size_t>& complete = {})
{
  for(std::size_t n = 0; n < content.size(); ++n)
  {
    const Reading reading(reader, content.substr(0, n));
    EXPECT_EQ(reading.error == SP::OK, complete.count(n) > 0) << n << ' ' << reading.message;
    EXPECT_TRUE(reading.error == SP::OK || !reading.message.empty()) << n;
  }
  for(std::size_t k = 0; k < content.size(); ++k)
    for(const int change : {1, 0x20, 0x80, 0xFF})
    {
      std::string changed = content;
      changed[k] = static_cast<char>(changed[k] ^ change);
      const Reading reading(reader, changed);
      expect_consistent(reading.file);
      EXPECT_TRUE(reading.error == SP::OK || (!reading.message.empty() && reading.message.size() < 500)) << k;
    }
}

// Returns what write(out, message) writes, which has to succeed.
template <class Write>
std::string written(const Write& write)
{
  std::ostringstream out;
  std::string message = "of an earlier call";
  EXPECT_EQ(write(out, message), SP::OK) << message;
  EXPECT_EQ(message, "");
  std::ostringstream broken;
  broken.setstate(std::ios_base::badbit);
  EXPECT_EQ(write(broken, message), SP::ERROR_CANNOT_WRITE_FILE);
  EXPECT_NE(message.find("could not be written"), std::string::npos);
  return out.str();
}

// What cannot be written is refused before the first byte.
template <class Write>
void expect_not_written(const Write& write, SP::Error_code error, const std::string& part_of_message)
{
  std::ostringstream out;
  std::string message;
  EXPECT_EQ(write(out, message), error) << part_of_message;
  EXPECT_NE(message.find(part_of_message), std::string::npos) << message << "\nhas not: " << part_of_message;
  EXPECT_EQ(out.str(), "");
}

// whether numbers have the same bits; those that are none as well
inline bool are_same(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

} // namespace surface_files

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_SURFACE_FILES_H
