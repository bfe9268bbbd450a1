#include "Progress_visitor.h"

#include <iomanip>

namespace Program {

void Progress_visitor::on_level(std::size_t number_of_vertices)
{
  show("Initial map: ", number_of_vertices, " of ", m_number_of_vertices, " vertices");
}

void Progress_visitor::after_iteration(std::size_t iteration, double energy, double radius)
{
  if((iteration - 1) % m_stride == 0)
    m_history.push_back({static_cast<double>(iteration), energy, radius});
  if(m_history.size() > max_history)
  {
    for(std::size_t k = 0; 2 * k < m_history.size(); ++k)
      m_history[k] = m_history[2 * k];
    m_history.resize((m_history.size() + 1) / 2);
    m_stride *= 2;
  }
  show("Sweep ", iteration, ": energy ", std::setprecision(6), energy, ", radius ", radius);
}

void Progress_visitor::erase()
{
  if(m_length > 0)
    std::cerr << '\r' << std::string(m_length, ' ') << '\r' << std::flush;
  m_length = 0;
}
} // namespace Program
