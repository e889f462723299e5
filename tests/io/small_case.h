#pragma once

#include <taut/io/parameters.h>

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace taut::io::testing
{
/// A case file in a folder of its own that vanishes with it.
class CaseOnDisk
{
public:
  explicit CaseOnDisk(const std::string& content,
                      const std::string& name = "case.prm")
  {
    static std::atomic<int> number{0};
    folder_ = std::filesystem::temp_directory_path() /
              ("taut_parameters_" + std::to_string(getpid()) + "_" +
               std::to_string(number++));
    std::filesystem::create_directories(folder_);
    file_ = folder_ / name;
    std::ofstream(file_) << content;
  }
  ~CaseOnDisk()
  {
    std::filesystem::remove_all(folder_);
  }
  CaseOnDisk(const CaseOnDisk&) = delete;
  CaseOnDisk& operator=(const CaseOnDisk&) = delete;

  std::string file() const
  {
    return file_.string();
  }
  const std::filesystem::path& folder() const
  {
    return folder_;
  }

private:
  std::filesystem::path folder_, file_;
};

/// A complete case, one of every named section. The line numbers matter.
inline const char* const small_case = R"(set Title = small
subsection Mesh
  set File = meshes/two.geo
  set Parameters = width: 0.02, cells: 4
end
subsection Material rubber
  set Density = 1000
  subsection Spring ground
    set Law = Gent
    set Shear modulus = 20e3
    set Limit = 67
  end
  subsection Network slow
    set Law = neo-Hookean
    set Shear modulus = 10e3
    set Relaxation time = 100
  end
  subsection Dielectric
    set Relative permittivity = 4.7
    set Breakdown strength = 1e8
  end
end
subsection Film left
  set Surfaces = left
  set Material = rubber
  set Thickness = 1e-3
  set Pre-stretch = 2, 4
end
subsection Film right
  set Surfaces = right
  set Material = rubber
  set Thickness = 1e-3
end
subsection Electrode left
  set Surfaces = left
  set Voltage = table(0: 0, 1: 5000)
end
subsection Support frame
  set Groups = edge
  set Held = x, y, z
  set Shape x = 0.1*sin(pi*y)
  set Amplitude = ramp(rate = 1, start = 0, limit = 1)
end
subsection Bar middle
  set Lines = bar
  set Mass = 0.02
end
subsection Pressure below
  set Surfaces = left
  set Pressure = 10
end
subsection Edge load pull
  set Lines = edge
  set Direction = 0, 0, 1
  set Force = 3
end
subsection Probe top
  set Quantity = displacement
  set Point = 0, 0.01, 0
  set Component = z
end
subsection Probe swing
  set Quantity = bar displacement
  set Of = middle
end
subsection Event slack
  set Kind = tension loss
  set Of = left
end
subsection Event far
  set Kind = probe above
  set Of = swing
  set Threshold = 1e-3
end
subsection Environment
  set Gravity = 0, 0, -9.81
end
subsection Procedure
  set End time = 2
  subsection Integrator
    set First step = 1e-5
  end
end
subsection Output
  set History times = 0.5, 1.5
end
subsection Comparison
  set Active film = left
  set Passive film = right
  set Electrode = left
  set Bar = middle
end
)";
} // namespace taut::io::testing
