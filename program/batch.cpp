#include "Interrupt_guard.h"
#include "Mesh_run.h"
#include "find_batch.h"
#include "for_each_mesh.h"
#include "system.h"

#include <fstream>
#include <iomanip>
#include <iostream>
#include <mutex>

namespace Program {

namespace {

// The report of an earlier run for a mesh, if there is one. Its checksum guarantees that it is unchanged since `Run_report` wrote it, so
// its members can be compared as texts.
class Earlier_report
{
public:
  explicit Earlier_report(const File_names& names)
    : m_names(names)
  {
    constexpr std::uintmax_t max_size = std::uintmax_t(64) << 20;
    try
    {
      if(std::filesystem::file_size(path_of(names.json)) <= max_size)
        m_text = read_file(names.json);
    }
    catch(const std::exception&) // an unreadable report is ignored
    {}
    if(m_text != Run_report::sealed(m_text.substr(0, m_text.rfind(Run_report::seal))))
      m_text.clear();
  }

  // returns whether the mesh is done: its map exists unchanged, and was computed by this program version with these options from the
  // current input. An interrupted map is not done.
  bool matches_run(const Options& options) const
  {
    const std::string begin = "\n  \"input\": \"";
    const std::size_t found = (std::min)(m_text.find(begin) + begin.size(), m_text.size());
    const auto file_name = [](const std::string& path) { return path_of(path).filename(); };
    return has_value("program", program_version()) && has_value("method", options.description) &&
           file_name(m_text.substr(found, m_text.find(",\n", found) - found)) ==
               file_name(Json(m_names.input).text().substr(1)) &&
           !has_value("stop_reason", Run_report::stop_reason_interrupted) && has_stamp("input_stamp", m_names.input) &&
           (options.start_or_template().empty() || has_stamp("start_stamp", options.start_or_template())) &&
           matches_sphere();
  }

  bool is_one_to_one() const { return has_value("one_to_one", true); }

  // removes the report and its map if they belong to another input or other options and no other run has replaced them since.
  void remove_outdated_files(const Options& options) const
  {
    const Folder_lock lock(path_of(m_names.json).parent_path());
    if(m_text.empty() || Earlier_report(m_names).m_text != m_text || matches_run(options))
      return;
    std::error_code ignored;
    if(matches_sphere())
      std::filesystem::remove(path_of(m_names.sphere), ignored);
    std::filesystem::remove(path_of(m_names.json), ignored);
  }

private:
  // Returns whether a member has this value.
  bool has_value(const std::string& name, const Json& value) const
  {
    std::string member = Json{{name, value}}.text();
    member.replace(member.rfind('\n'), member.npos, ",\n"); // instead of the end of the object
    return m_text.find(member.substr(1)) != m_text.npos;
  }

  bool has_stamp(const std::string& name, const std::string& path) const
  {
    const File_stamp stamp(path);
    return !stamp.is_empty() && has_value(name, stamp.json());
  }

  bool matches_sphere() const
  {
    std::error_code error;
    if(!std::filesystem::is_regular_file(path_of(m_names.sphere), error) ||
       !has_value("sphere_bytes", std::filesystem::file_size(path_of(m_names.sphere), error)))
      return false;
    Checksum checksum;
    std::ifstream in(path_of(m_names.sphere), std::ios::binary);
    std::array<char, 1 << 16> block;
    while(in.read(block.data(), block.size()) || in.gcount() > 0)
      checksum.add(block.data(), static_cast<std::size_t>(in.gcount()));
    return has_value("sphere_bytes", checksum.bytes) && has_value("sphere_crc32", checksum.crc.checksum());
  }

  const File_names& m_names;
  std::string m_text; // empty if there is no report
};

// Maps many meshes, each as if it were the only one. Prints a line for each mesh, and a summary.
class Batch
{
public:
  // makes all checks that are possible before the first mesh is mapped.
  explicit Batch(const Options& options)
    : m_options(options)
    , m_meshes(find_batch(options))
  {}

  // maps all meshes that are not done. A mesh that fails does not stop the others. Returns the exit status.
  int run()
  {
    look_at_earlier_results();
    std::vector<std::uintmax_t> sizes;
    for(const File_names& names : m_meshes)
    {
      std::error_code error; // reading fails later and reports why
      const std::uintmax_t size = std::filesystem::file_size(path_of(names.input), error);
      sizes.push_back(error ? 0 : size);
    }
    if(m_options.has("template") && !m_meshes.empty())
      m_template.emplace(m_options, m_options.text("template"));
    {
      const Interrupt_guard guard;
      for_each_mesh(sizes, [&](std::size_t i) { run(m_meshes[i]); });
    }
    print_summary();
    if(m_mapped < m_meshes.size())
      return EXIT_FAILURE;
    return m_not_bijective > 0 ? exit_status_folded : EXIT_SUCCESS;
  }

private:
  // Skips meshes that are done, with --resume.
  void look_at_earlier_results()
  {
    if(!m_options.has("resume"))
      return;
    const auto is_done = [&](const File_names& names) {
      const Earlier_report report(names);
      if(!report.matches_run(m_options))
        return false;
      ++m_skipped;
      if(!report.is_one_to_one())
      {
        ++m_not_bijective;
        print_error(printable(names.input) + ": the map of an earlier run is not bijective");
      }
      return true;
    };
    m_meshes.erase(std::remove_if(m_meshes.begin(), m_meshes.end(), is_done), m_meshes.end());
  }

  // An interrupted mesh writes nothing: every map in the output folder has all the sweeps that the options request. Existing files
  // remain until they are replaced; but if a mesh fails, its outdated map is removed, as it could be mistaken for that of this run.
  void run(const File_names& names)
  {
    if(Interrupt_guard::is_interrupted())
      return;
    const Earlier_report earlier(names);
    std::optional<Mesh_run> run; // none until all files are known to be replaceable
    try
    {
      const std::filesystem::path folder = path_of(names.json).parent_path();
      std::error_code error;
      if(!std::filesystem::create_directories(folder, error) && error)
        throw error_in(name_of(folder), "cannot be created: ", error.message());
      run.emplace(m_options, names);
      run->read();
      run->map();
      if(!run->report().is_interrupted())
        run->match(m_template ? &*m_template : nullptr);
      if(run->report().is_interrupted())
        return;
      run->write();
      report_map(run->report());
    }
    catch(const std::exception& error)
    {
      if(run)
        earlier.remove_outdated_files(m_options);
      report_failure(printable(names.input), message_of(error));
    }
  }

  // Called by several threads; the lock keeps lines intact.
  void report_map(const Run_report& report)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    ++m_mapped;
    print_line(printable(report.input()), report.short_text());
    std::istringstream warnings(report.warnings());
    for(std::string line; std::getline(warnings, line);)
      print_error(with_name(printable(report.input()), line));
    if(report.result.is_one_to_one)
      return;
    ++m_not_bijective;
    print_error(report.explain_fault());
  }

  static std::string with_name(const std::string& input, const std::string& text)
  {
    return text.compare(0, input.size() + 1, input + ':') == 0 ? text : input + ": " + text;
  }

  void report_failure(const std::string& input, const std::string& message)
  {
    const std::string text = with_name(input, message);
    const std::size_t begin = (std::min)(input.size() + 2, text.size());
    const std::lock_guard<std::mutex> lock(m_mutex);
    ++m_failed;
    print_line(input, "failed: " + text.substr(begin, text.find('\n', begin) - begin));
    print_error(text);
  }

  void print_line(const std::string& input, const std::string& text)
  {
    if(!m_options.has("quiet"))
      std::cout << '[' << m_mapped + m_failed << '/' << m_meshes.size() << "] " << input << ": " << text << std::endl;
  }

  static void print_error(const std::string& message)
  {
    std::cerr << "spherical_parameterization: " + message + "\n" << std::flush;
  }

  void print_summary() const
  {
    const std::size_t n_missed = m_meshes.size() - m_mapped - m_failed;
    if(n_missed > 0)
      print_error("interrupted: " + std::to_string(n_missed) + " of " + std::to_string(m_meshes.size()) +
                  " meshes have not been mapped; --resume continues with them");
    if(m_options.has("quiet"))
      return;
    constexpr double minute = 60.;
    const double seconds = seconds_now() - m_start;
    std::cout << "Mapped " << m_mapped << ", skipped " << m_skipped << ", not bijective " << m_not_bijective
              << ", failed " << m_failed;
    if(n_missed > 0)
      std::cout << ", interrupted " << n_missed;
    std::cout << std::fixed << std::setprecision(1) << "; " << seconds << " seconds";
    if(m_mapped > 0 && seconds > 0.)
      std::cout << ", " << minute * static_cast<double>(m_mapped) / seconds << " meshes per minute";
    std::cout << std::endl;
  }

  const Options& m_options;
  std::vector<File_names> m_meshes;
  std::optional<Mapped_mesh> m_template;
  double m_start = seconds_now();
  std::mutex m_mutex;
  std::size_t m_skipped = 0, m_mapped = 0, m_not_bijective = 0, m_failed = 0;
};

} // namespace

int run_batch(const Options& options)
{
  return Batch(options).run();
}

} // namespace Program
