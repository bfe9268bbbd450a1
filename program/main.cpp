// The command line program of the package. --help describes the commands.

#include "Options.h"
#include "for_each_mesh.h"
#include "system.h"

#include <cstdlib>
#include <iostream>

using namespace Program;

namespace {

void limit_threads([[maybe_unused]] const Options& options)
{
#ifdef CGAL_LINKED_WITH_TBB
  // Each requested thread would allocate its own memory.
  const std::size_t n_wanted = options.max_threads, n_cores = Thread_limit::number_of_threads();
  // Never deleted: TBB creates a thread when a limit ends.
  [[maybe_unused]] static const Thread_limit* const threads = new Thread_limit((std::min)(n_wanted, n_cores));
  if(const std::size_t n = Thread_limit::number_of_threads(); n_wanted > n && !options.has("quiet"))
    std::cerr << "spherical_parameterization: --threads " << n_wanted << ": only " << n
              << (n == 1 ? " thread is" : " threads are") << " available\n";
#endif
}

// Returns the exit status.
int run_program(const Command_line& line)
{
  if(!line.printed.empty())
  {
    std::cout << line.printed;
    return EXIT_SUCCESS;
  }
  const Options options = read_options(line);
  limit_threads(options);
  return options.is("resample") ? run_resample(options)
         : options.is("batch")  ? run_batch(options)
         : options.is("check")  ? run_check(options)
                                : run_map(options); // all others map a surface to a sphere first
}

} // namespace

int main(int argc, char** argv)
{
  const Words words = start_process(argc, argv);
  try
  {
    const int status = run_program(parse_command_line(words));
    if(!std::cout.flush())
      throw Program_error("cannot write to the standard output");
    return status;
  }
  catch(const std::exception& error)
  {
    std::cerr << "spherical_parameterization: " << message_of(error) << '\n';
    return EXIT_FAILURE;
  }
}
