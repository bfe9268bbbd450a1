#include "command_line.h"

#include <algorithm>

namespace Program {

namespace {

using Options_list = std::vector<Command_option>;

// Adds options, all of the same group.
void append(Options_list& list, const std::string& group, const Options_list& more)
{
  for(Command_option option : more)
  {
    option.group = group;
    list.push_back(option);
  }
}

Options_list method_options(const std::string& command)
{
  Options_list list = {
      {"--method", "METHOD", "bld (default), hierarchical, arap, conformal, harmonic, stereographic or schnyder"},
      {"--paper", "",
       "settings of the published method: isometric energy, harmonic initial map, s from 0.1 to 10, two-phase radius"}};
  if(command != "match") // which maps two surfaces
    append(list, "",
           {{"--initial", "MAP",
             "initial map: hierarchical (default), stereographic, harmonic, conformal, schnyder or a FILE"}});
  if(command != "match" && command != "register")
    append(list, "",
           {{"--density", "FILE",
             "prescribe areas on the sphere: area times the density of each vertex or face in FILE; or equal, for the "
             "density 1"}});
  append(list, "",
         {{"--energy", "ENERGY", "symmetric-dirichlet (default), isometric, or conformal, which preserves only angles"},
          {"--prefer", "WHAT", "average or worst distortion, balance (default), or sampling"},
          {"--sharpness", "B", "weight of the worst triangles: 0 is average, 20 balance, 40 worst"},
          {"--schedule", "S,T[,N]", "minimize exp(s E), s from S to T, after N sweeps of the sum of E"},
          {"--radius", "RADIUS", "objective (default), two-phase, optimal, area, balanced or fixed=R"},
          {"--tolerance", "T",
           "stop when two sweeps change the objective by at most this fraction (default: 1e-3, for sampling 3e-3)"},
          {"--iterations", "N",
           "maximum number of sweeps over the mesh (default: 250, more below 2000 vertices); 0 keeps the initial map"},
          {"--time-limit", "SECONDS", "stop sweeping after this time and write the current map"}});
  return list;
}

const Options_list repair_limits = {
    {"--max-added-area", "FRACTION",
     "maximum area of all patches, as a fraction of the resulting area (default: 0.05)"},
    {"--max-hole", "LENGTH", "longest border of a hole, relative to the square root of the area (default: no limit)"},
    {"--max-handle", "LENGTH", "longest cycle along which a handle is cut, in the same unit (default: no limit)"},
    {"--coarse-patches", "", "fill holes and cuts with as few triangles as possible"},
    {"--wrap", "ALPHA", "wrap the surface first; ALPHA is a fraction of its diagonal, such as 0.02"}};

const Options_list repair_options = {
    {"--repair", "", "repair surfaces before mapping; implied by other repair options"},
    {"--repaired", "FILE", "write the repaired surface; .ply includes source vertices and faces"}};

const Options_list component_options = {
    {"--each-component", "", "map each connected component of SURFACE, to numbered files"}};

const Options_list common_options = {
    {"--threads", "N", "use at most N threads; the result does not depend on their number"},
    {"--quiet", "", "print only warnings and errors"}};

const Options_list format_options = {
    {"--format", "FORMAT", "off, obj, ply, ts, gifti or freesurfer, regardless of file names"},
    {"--convention", "WHICH",
     "cortex (default for .gii and lh.*): spheres in the pose of the surface, with radius 100; or none"}};

const Command_option json_option = {"--json", "FILE",
                                    "write the report as JSON; - prints it instead of the text report"};

const Options_list report_options = {
    json_option,
    {"--colored", "PREFIX", "write PREFIX_surface.ply and PREFIX_sphere.ply, colored by distortion"},
    {"--page", "FILE.html", "write an interactive page for web browsers, as the command show does"},
    {"--labels", "FILE", "with --page: show the labels of an annotation or .label.gii file"}};

const Options_list hint_options = {
    {"--landmarks", "A B", "files of corresponding vertices, one per line, counted from 0"},
    {"--soft-landmarks", "W", "weight of the mean squared landmark distance (default: landmarks are met exactly)"},
    {"--features", "A B", "vertex values to align by: files, or depth, height, curvature, inflated"},
    {"--feature-weights", "NAME=W,...", "weights of named features (default: 1)"},
    {"--compare", "WHAT", "compare ranks of features (default) or values"},
    {"--masks", "A B", "compare features only at vertices with a nonzero value or in a label"},
    {"--regularize", "WHAT", "minimize the distortion between surfaces (default) or spheres"}};

const Options_list hint_outputs = {
    {"--overlay", "FILE.ply", "write the common refinement, with positions and faces on both surfaces"},
    {"--expected-errors", "FILE", "write the expected error of each vertex: SURFACE as .ply, or values only"}};

Options_list own_options(const std::string& command)
{
  if(command == "map")
    return {{"-o,--output", "SPHERE", "write the faces of SURFACE with the images of its vertices"},
            {"--texture", "FILE.obj",
             "write SURFACE with longitude and latitude as texture coordinates; the y-axis points north"}};
  if(command == "match" || command == "register")
  {
    const bool is_match = command == "match";
    Options_list list = {{"-o,--output", is_match ? "RESULT" : "SPHERE",
                          is_match ? "write the faces of SURFACE with its vertices on TARGET"
                                   : "write the sphere of SURFACE, registered to ATLAS"},
                         {"--sphere", "SPHERE",
                          is_match ? "write the images on the sphere of TARGET, and that sphere to SPHERE_target"
                                   : "write the sphere of SURFACE before registration"}};
    append(list, "", hint_outputs);
    if(is_match)
      append(list, "",
             {{"--morph", "T FILE",
               "write the morph from SURFACE (T = 0) to TARGET (T = 1) at time T; TARGET is aligned to SURFACE"}});
    append(list, "Alignment", hint_options);
    if(is_match)
      append(list, "Alignment",
             {{"--split", "", "split edges of SURFACE to lower the energy; adds at most half as many vertices"}});
    return list;
  }
  if(command == "remesh")
    return {{"-o,--output", "MESH", "write the surface with the connectivity of DOMAIN; .ply includes normals"},
            {"--sphere", "SPHERE", "write the sphere of SURFACE"},
            {"--transfer", "VALUES", "transfer properties of a .ply file, or of comma-separated files of values"},
            {"--values-sphere", "SPHERE", "VALUES belong to another surface, whose sphere this is"},
            {"--geometry-image", "FILE", "write points as a .png or .exr image, and normals to FILE_normals"},
            {"--image-size", "N", "pixels per row and column of the image, odd (default: 257)"}};
  if(command == "resample")
    return {{"-o,--output", "RESULT", "write the values at the vertices of SPHERE_B"},
            {"--output-folder", "FOLDER", "write the result of each of several VALUES here, under its name"},
            {"--method", "METHOD", "barycentric (default), adaptive (default with --areas), nearest or largest"},
            {"--areas", "A B", "vertex areas of both spheres for adaptive and largest: values or surfaces"},
            {"--mask", "FILE", "use only vertices of SPHERE_A with a positive value or in a label"},
            {"--valid", "FILE", "write 1 for vertices of SPHERE_B that receive a value, 0 for others"},
            {"--through", "", "VALUES are spheres: apply the registration that maps SPHERE_A to SPHERE_B"}};
  if(command == "check")
    return {json_option};
  if(command == "repair")
  {
    Options_list list = {{"-o,--output", "RESULT", "write the surface; .ply includes source vertices and faces"},
                         {"--handles", "FILE.ply", "write the cycles along which handles are cut, as lines"}};
    append(list, "", repair_limits);
    append(list, "", {{"--each-component", "", "repair each connected component, to numbered files"}});
    return list;
  }
  if(command == "show")
    return {{"-o,--output", "PAGE.html", "write the page; it needs no network access"},
            {"--beside", "SURFACE", "show this surface, with the same faces, instead of the sphere"},
            {"--labels", "FILE", "show the labels of an annotation or .label.gii file"}};
  return {{"--output-folder", "FOLDER", "write each sphere and report here, such as NAME.off and NAME.json"},
          {"--template", "T", "map the surface T onto each INPUT, and write T with its vertices there"},
          {"--resume", "", "skip meshes that this version has mapped with the same options"}};
}

} // namespace

const std::vector<Command> commands = {
    {"map", "map a surface to a sphere", "cow.off -o sphere.off", "SURFACE [-o SPHERE] [OPTION...]",
     "Maps a closed surface of genus 0 to a sphere, bijectively and with low distortion. Without -o, only "
     "the report is printed.",
     1, 1},
    {"match", "map a surface onto another one", "cat.off horse.off -o cat_on_horse.off",
     "SURFACE TARGET [-o RESULT] [OPTION...]",
     "Maps a surface bijectively onto another one. Both are mapped to spheres first.", 2, 2},
    {"register", "register a surface to a spherical atlas", "lh.white atlas --features depth atlas.sulc -o lh.reg",
     "SURFACE ATLAS --features A B [-o SPHERE] [OPTION...]",
     "Registers the sphere of a surface to an atlas, which is a sphere with features.", 2, 2},
    {"remesh", "resample a surface with another connectivity", "cow.off octahedron=64 -o remesh.ply",
     "SURFACE DOMAIN [-o MESH] [OPTION...]",
     "Samples a surface at the vertices of DOMAIN: octahedron=N, cube=N or icosahedron=N, whose edges are "
     "divided into N, or a FILE with a mesh of the sphere. The default of --prefer is sampling.",
     1, 2},
    {"resample", "transfer vertex data between spheres", "lh.sulc lh.sphere.reg fsaverage.sphere -o sulc.gii",
     "VALUES... SPHERE_A SPHERE_B -o RESULT [OPTION...]",
     "Transfers values, labels or coordinates from the vertices of SPHERE_A to those of SPHERE_B. Integers "
     "are labels; they are not averaged.",
     3, std::size_t(-1)},
    {"check", "check a surface, or a map to the sphere", "cow.off sphere.off", "SURFACE [SPHERE] [OPTION...]",
     "Reports whether a surface can be mapped and, if not, why. With SPHERE, a sphere with the same faces, "
     "reports whether that map is bijective, and its distortion.",
     1, 2},
    {"repair", "repair a surface so that it can be mapped", "scan.ply -o repaired.ply",
     "SURFACE [-o RESULT] [OPTION...]",
     "Triangulates polygons, removes degenerate and duplicate faces, merges coincident border vertices, "
     "orients faces consistently, separates faces at non-manifold edges and vertices, keeps the largest "
     "component, fills holes, cuts handles, and splits duplicate edges. Each step is done only where needed.",
     1, 1},
    {"batch", "map many surfaces", "scans/ --output-folder spheres", "INPUT... --output-folder FOLDER [OPTION...]",
     "Maps meshes and all meshes in folders. A mesh that fails does not stop the others. Small meshes are "
     "mapped in parallel, one per core. Ctrl-C leaves no incomplete files.",
     1, std::size_t(-1)},
    {"show", "write an interactive page for web browsers", "cow.off sphere.off -o cow.html",
     "SURFACE [SPHERE] -o PAGE.html [OPTION...]",
     "Shows a surface and its sphere side by side, colored by distortion. Without SPHERE, the surface is "
     "mapped. For a surface with handles, the page shows the handles.",
     1, 2}};

const std::map<std::string, std::string> needed_options = {{"--soft-landmarks", "--landmarks"},
                                                           {"--feature-weights", "--features"},
                                                           {"--compare", "--features"},
                                                           {"--values-sphere", "--transfer"},
                                                           {"--image-size", "--geometry-image"}};

std::vector<Command_option> options_of(const std::string& command)
{
  Options_list list = own_options(command);
  const bool maps = is_among(command, {"map", "match", "register", "remesh"});
  if(command == "map" || command == "remesh")
    append(list, "", component_options);
  if(maps)
    append(list, "", report_options);
  if(maps || command == "batch")
    append(list, "", format_options);
  append(list, "", common_options);
  if(maps || command == "batch")
    append(list, "Method", method_options(command));
  if(maps || command == "batch" || command == "show")
  {
    append(list, "Repair", command == "batch" || command == "show" ? Options_list{repair_options[0]} : repair_options);
    append(list, "Repair", is_among(command, {"match", "register"}) ? Options_list{repair_limits[0]} : repair_limits);
  }
  // Groups in the order in which they appear first; those without a name come first.
  Words groups;
  for(const Command_option& option : list)
    if(!is_among(option.group, groups))
      groups.push_back(option.group);
  const auto rank = [&](const Command_option& option) {
    return std::find(groups.begin(), groups.end(), option.group) - groups.begin();
  };
  std::stable_sort(list.begin(), list.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return list;
}

} // namespace Program
