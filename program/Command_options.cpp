#include "command_line.h"

namespace Program {

namespace {

using Options_list = std::vector<Command_option>;

void append(Options_list& list, const Options_list& more)
{
  list.insert(list.end(), more.begin(), more.end());
}

Options_list method_options(const std::string& command)
{
  Options_list list = {{"--method", "METHOD", "bld, hierarchical, harmonic, stereographic, schnyder, conformal, arap"},
                       {"--paper", "", "the published method: harmonic start, s from 0.1 to 10, ..."}};
  if(command != "match") // whose surfaces have a map each
    append(list, {{"--initial", "START", "hierarchical, stereographic, harmonic, conformal, schnyder, or a FILE"}});
  if(command != "match" && command != "register")
    append(list, {{"--density", "FILE", "areas on the sphere by these values, or equal: in proportion to faces"}});
  append(list, {{"--energy", "ENERGY", "symmetric-dirichlet, the default, isometric, or conformal: angles only"},
                {"--prefer", "WHAT", "the lowest average distortion, worst, balance (the default), or sampling"},
                {"--sharpness", "B", "anything between: 0 is average, 20 balance, 40 worst"},
                {"--schedule", "S,T[,N]", "exp(s E), s from S to T, after N sweeps of the sum; --paper: 0.1,10,100"},
                {"--radius", "RADIUS", "objective, the default, two-phase, optimal, area, balanced or fixed=R"},
                {"--tolerance", "T", "end when two sweeps change the objective by no more than this share; 1e-3"},
                {"--iterations", "N", "most sweeps; 250, or more below 2000 vertices; 0 leaves the initial map"},
                {"--time-limit", "SECONDS", "sweep no longer than this; the map reached is written"}});
  return list;
}

const Options_list repair_limits = {
    {"--max-added-area", "SHARE", "what may be new, as a share of the area of the result; 0.05"},
    {"--max-hole", "LENGTH", "longest border of a hole, in square roots of the area; any"},
    {"--max-handle", "LENGTH", "longest cycle that a handle is cut along, in the same unit; any"},
    {"--coarse-patches", "", "close holes and cuts with as few triangles as can be"},
    {"--wrap", "ALPHA", "wrap it first; ALPHA is a share of its diagonal, such as 0.02"}};

const Options_list repair_options = {
    {"--repair", "", "repair surfaces first, see the command repair; so do options of that"},
    {"--repaired", "FILE", "write the repaired surface; .ply says which vertices and faces it is from"}};

const Options_list component_options = {{"--each-component", "", "map each component of SURFACE, to numbered files"}};

const Options_list common_options = {{"--threads", "N", "use no more threads; the result is always the same"},
                                     {"--quiet", "", "print nothing but errors"}};

const Options_list format_options = {
    {"--format", "FORMAT", "off, obj, ply, ts, gifti or freesurfer, whatever the names of files are"},
    {"--convention", "WHICH", "cortex: spheres lie as the surface, radius 100 (.gii, lh.*); or none"}};

const Options_list report_options = {
    {"--json", "FILE", "write the report and the distortions as JSON; - prints them instead"},
    {"--colored", "PREFIX", "write PREFIX_surface.ply and PREFIX_sphere.ply, coloured by distortion"},
    {"--page", "FILE.html", "write a page for web browsers that shows both sides, see show"},
    {"--labels", "FILE", "with --page: an annotation or .label.gii file, whose colours it shows"}};

const Options_list hint_options = {
    {"--landmarks", "A B", "files with the vertices that correspond, one a line, counted from 0"},
    {"--soft-landmarks", "W", "weight of their mean squared distance, instead of meeting them exactly"},
    {"--features", "A B", "values of vertices to align by; or depth, height, curvature, inflated"},
    {"--feature-weights", "NAME=W,...", "how much features of these names count; 1"},
    {"--compare", "WHAT", "ranks of features, the default, or their values"},
    {"--masks", "A B", "values of vertices, 0 where features are not to be compared; or labels"},
    {"--regularize", "WHAT", "keep low the distortion between surfaces, the default, or between spheres"},
    {"--overlay", "FILE.ply", "write the common refinement with positions on both, and both faces"},
    {"--expected-errors", "FILE", "write how far off each vertex may be: SURFACE as .ply, or values"}};

Options_list own_options(const std::string& command)
{
  if(command == "map")
    return {{"-o,--output", "SPHERE", "write the faces of SURFACE with the images of its vertices"}};
  if(command == "match" || command == "register")
  {
    const bool is_match = command == "match";
    Options_list list = {{"-o,--output", is_match ? "RESULT" : "SPHERE",
                          is_match ? "write SURFACE with its vertices on TARGET"
                                   : "write the sphere of SURFACE, its vertices on that of ATLAS"},
                         {"--sphere", "SPHERE",
                          is_match ? "write the directions on the sphere of TARGET, and that to SPHERE_target"
                                   : "write the sphere as it was before"}};
    append(list, hint_options);
    if(is_match)
      append(list, {{"--split", "", "split edges to lower the energy; at most half as many vertices again"},
                    {"--morph", "T FILE", "write the common refinement on its way from SURFACE, T = 0, to TARGET"}});
    return list;
  }
  if(command == "remesh")
    return {{"-o,--output", "MESH", "write the surface with the faces of DOMAIN; .ply has normals, too"},
            {"--sphere", "SPHERE", "write the sphere of SURFACE"},
            {"--transfer", "VALUES", "transfer properties of a .ply file, or files of values with commas"},
            {"--values-sphere", "SPHERE", "VALUES is another surface, and this its sphere"},
            {"--geometry-image", "FILE", "write points as colours, .png or .exr, and normals to FILE_normals"},
            {"--image-size", "N", "pixels in each of its rows and columns, odd; 257"}};
  if(command == "resample")
    return {{"-o,--output", "RESULT", "write what the vertices of SPHERE_B get"},
            {"--output-folder", "FOLDER", "for several VALUES: write each here, by its name"},
            {"--method", "METHOD", "barycentric, the default; adaptive, that with --areas; nearest or largest"},
            {"--areas", "A B", "surfaces with the vertices of the spheres, or areas: average by them"},
            {"--mask", "FILE", "the vertices of SPHERE_A that count: a positive value, or a label"},
            {"--valid", "FILE", "write 1 for the vertices of SPHERE_B that get something, 0 for the others"},
            {"--through", "", "VALUES are spheres: carry them through a registration, from A to B"}};
  if(command == "check")
    return {{"--json", "FILE", "write the report and the distortions as JSON; - prints them instead"}};
  if(command == "repair")
  {
    Options_list list = {
        {"-o,--output", "RESULT", "write the surface; in .ply with the vertices and faces that it is from"},
        {"--handles", "FILE.ply", "write the cycles that handles are cut along, as lines"}};
    append(list, repair_limits);
    append(list, {{"--each-component", "", "repair each component, to numbered files"}});
    return list;
  }
  if(command == "show")
    return {{"-o,--output", "PAGE.html", "write the page, which needs no network"},
            {"--beside", "SURFACE", "show this surface with the same faces in place of the sphere"},
            {"--labels", "FILE", "an annotation of FreeSurfer or .label.gii file, for colours"}};
  return {{"--output-folder", "FOLDER", "write each sphere and its report here, as NAME.off, say, and NAME.json"},
          {"--template", "T", "map the surface T onto each INPUT, and write T with its vertices there"},
          {"--resume", "", "leave out meshes that are done, by this version with these options"}};
}

} // namespace

const std::vector<Command> commands = {
    {"map", "map a surface to a sphere: map SURFACE -o SPHERE", "cow.off -o sphere.off",
     "SURFACE [-o SPHERE] [options]",
     "Maps a closed surface without handles to a sphere, one-to-one and with low distortion. Without -o,\nnothing but "
     "the report is printed.",
     1, 1},
    {"match", "map a surface onto another one: match SURFACE TARGET -o RESULT", "cat.off horse.off -o cat_on_horse.off",
     "SURFACE TARGET [-o RESULT] [options]", "Maps a surface one-to-one onto another one, through both spheres.", 2, 2},
    {"register", "register a sphere to an atlas: register SURFACE ATLAS --features A B",
     "lh.white atlas --features depth atlas.sulc -o lh.reg", "SURFACE ATLAS --features A B [-o SPHERE] [options]",
     "Registers a surface to an atlas: a sphere that has features.", 2, 2},
    {"remesh", "give a surface other faces: remesh SURFACE octahedron=64 -o MESH",
     "cow.off octahedron=64 -o remesh.ply", "SURFACE DOMAIN [-o MESH] [options]",
     "Samples a surface by octahedron=N, cube=N or icosahedron=N, whose edges are divided into N, or by a\nFILE with a "
     "mesh of the sphere. --prefer is sampling if nothing else is given.",
     1, 2},
    {"resample", "carry values from one sphere to another one: resample VALUES SPHERE_A SPHERE_B",
     "lh.sulc lh.sphere.reg fsaverage.sphere -o sulc.gii", "VALUES... SPHERE_A SPHERE_B -o RESULT [options]",
     "Carries values of vertices, labels or surfaces. Whole numbers are labels, which are not averaged.", 3,
     std::size_t(-1)},
    {"check", "say whether a surface can be mapped, or a sphere is one-to-one: check SURFACE [SPHERE]",
     "cow.off sphere.off", "SURFACE [SPHERE] [options]",
     "Says what keeps a surface from being mapped; or whether a sphere with its faces is one-to-one, and\nhow it is "
     "distorted.",
     1, 2},
    {"repair", "make any surface one that can be mapped: repair SURFACE -o RESULT", "scan.ply -o repaired.ply",
     "SURFACE [-o RESULT] [options]",
     "Triangulates polygons, removes degenerate and repeated faces, merges vertices of borders at the same\n"
     "point, orients faces alike, divides edges and vertices that are no manifold, keeps the largest\n"
     "component, fills holes, cuts handles and splits repeated edges; each only where it is needed.",
     1, 1},
    {"batch", "map many surfaces: batch INPUT... --output-folder FOLDER", "scans/ --output-folder spheres",
     "INPUT... --output-folder FOLDER [options]",
     "Maps meshes, and those in folders. One that fails does not stop the others; small ones are mapped\none on each "
     "core. After Ctrl-C nothing that is incomplete is left.",
     1, std::size_t(-1)},
    {"show", "write a page for web browsers: show SURFACE [SPHERE] -o PAGE.html", "cow.off sphere.off -o cow.html",
     "SURFACE [SPHERE] -o PAGE.html [options]",
     "Shows a surface and its sphere side by side, coloured, with the distortion at the pointer; of a\n"
     "surface with handles, where these are. Without SPHERE, the surface is mapped.",
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
  if(maps || command == "batch" || command == "show")
  {
    append(list, command == "batch" || command == "show" ? Options_list{repair_options[0]} : repair_options);
    append(list, is_among(command, {"match", "register"}) ? Options_list{repair_limits[0]} : repair_limits);
  }
  if(command == "map" || command == "remesh")
    append(list, component_options);
  if(maps || command == "batch")
  {
    append(list, method_options(command));
    append(list, format_options);
  }
  if(maps)
    append(list, report_options);
  append(list, common_options);
  return list;
}

} // namespace Program
