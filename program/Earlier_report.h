#ifndef PROGRAM_EARLIER_REPORT_H
#define PROGRAM_EARLIER_REPORT_H

#include "Options.h"

#include <boost/property_tree/ptree.hpp>

#include <string>

namespace Program {

/// The report that an earlier run has left for a mesh, as `Run_report` writes it.
class Earlier_report
{
public:
  /// reads the report, if there is one.
  explicit Earlier_report(const File_names& names);

  /// returns whether the mesh is done: its map is there as it was written, and made by this program with these options
  /// from the input as it is now. A map that was interrupted is not done.
  bool tells_the_same_run(const Options& options) const;

  /// returns a file that the results of the mesh would replace, and that is of no run of this program; empty if there is none.
  std::string foreign_file() const;

  /// returns whether the map was certified.
  bool is_one_to_one() const { return text("one_to_one") == "true"; }

private:
  std::string text(const std::string& name) const { return m_tree.get<std::string>(name, ""); }

  bool is_as_it_was(const std::string& name, const std::string& path) const;

  bool has_its_sphere() const;

  File_names m_names;
  boost::property_tree::ptree m_tree;
};

} // namespace Program

#endif // PROGRAM_EARLIER_REPORT_H
