#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/fe/vector3.h>
#include <taut/structure/device_nodes.h>
#include <taut/structure/frame_nodes.h>

#include <algorithm>
#include <cmath>

namespace taut::structure
{
namespace
{
using fe::Coordinates;
using fe::GlobalNode;
using DoFHandler = dealii::DoFHandler<2, 3>;

[[noreturn]] void refuse(const std::string& kind, const Named& entry,
                         const std::string& message)
{
  throw BadInput(message, "", entry.source_line, kind + " " + entry.name);
}

/// Refuses groups of points and lines that the mesh does not have.
void check_groups(const std::vector<std::string>& groups,
                  const std::string& kind, const Named& entry,
                  const fe::MeshData& mesh)
{
  for (const auto& group : groups)
  {
    if (mesh.groups.has(0, group) || mesh.groups.has(1, group))
      continue;
    auto names = mesh.groups.get_names(0);
    for (const auto& name : mesh.groups.get_names(1))
      names.push_back(name);
    refuse(kind, entry,
           "the mesh has no point or line '" + group + "'; " +
               suggest(group, names));
  }
}

Coordinates add(const Coordinates& a, const Coordinates& b,
                const double factor = 1)
{
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

/// From the axis of the frame to the film.
Coordinates make_arm(const Frame& frame)
{
  const double length = std::sqrt(fe::dot(frame.normal, frame.normal));
  return add({}, frame.normal, frame.offset / length);
}

/// The film's nodes in the groups, of all ranks, with their positions.
std::map<GlobalNode, Coordinates>
gather_film_nodes(const std::vector<std::string>& groups, const Named& entry,
                  const std::string& kind, const fe::MeshData& mesh,
                  const DoFHandler& dof_handler, const NodePositions& positions)
{
  std::map<GlobalNode, Coordinates> nodes;
  if (!mesh.only_lines)
    for (const auto node :
         find_group_nodes(groups, mesh, dof_handler, entry, kind))
      if (dof_handler.locally_owned_dofs().is_element(node))
      {
        const auto& x = positions.at(node);
        nodes[node] = {x[0], x[1], x[2]};
      }
  std::map<GlobalNode, Coordinates> all;
  for (const auto& part : dealii::Utilities::MPI::all_gather(
           dof_handler.get_communicator(), nodes))
    all.insert(part.begin(), part.end());
  return all;
}

/// Builds FrameNodes step by step.
class Builder
{
public:
  Builder(const Device& device, const fe::MeshData& mesh,
          const DoFHandler& dof_handler, const NodePositions& positions)
      : device_(device), mesh_(mesh), dof_handler_(dof_handler),
        positions_(positions), n_film_(dof_handler.n_dofs())
  {
    result_.mesh = make_frame_mesh(device, mesh, dof_handler, positions);
    result_.rotation_length = compute_extent(mesh);
  }

  FrameNodes make();

private:
  GlobalNode add_extra(const Coordinates& x, std::uint8_t held = 0);
  unsigned int add_rotation();
  void find_frames();
  void add_body(unsigned int body);
  void find_attached();
  void add_node(unsigned int place);
  void add_rotations(unsigned int place);
  void follow(GlobalNode node, const Coordinates& x, GlobalNode centre,
              unsigned int rotation);
  const Coordinates& get_position(GlobalNode node) const
  {
    return result_.extras[node - n_film_].mesh_position;
  }

  const Device& device_;
  const fe::MeshData& mesh_;
  const DoFHandler& dof_handler_;
  const NodePositions& positions_;
  const GlobalNode n_film_;
  FrameNodes result_;
  std::vector<std::set<unsigned int>> frames_at_; ///< by place
  std::vector<std::optional<unsigned int>> body_of_;
  std::map<GlobalNode, unsigned int> film_in_body_;
  std::set<unsigned int> hinged_;
  std::vector<bool> attached_;
};

GlobalNode Builder::add_extra(const Coordinates& x, const std::uint8_t held)
{
  result_.extras.push_back({x, held});
  return n_film_ + result_.extras.size() - 1;
}

unsigned int Builder::add_rotation()
{
  result_.rotations.push_back(add_extra({}));
  // The scalar part uses one of three components.
  add_extra({result_.rotation_length, 0, 0}, 6);
  return result_.rotations.size() - 1;
}

void Builder::find_frames()
{
  frames_at_.resize(result_.mesh.places.size());
  for (const auto& edge : result_.mesh.edges)
    for (const auto place : edge.places)
      frames_at_[place].insert(edge.frame);
  for (const auto& hinge : device_.hinges)
  {
    check_groups(hinge.groups, "Hinge", hinge, mesh_);
    const auto places = find_group_places(hinge.groups, result_.mesh, mesh_);
    for (const auto place : places)
      if (frames_at_[place].size() < 2)
        refuse("Hinge", hinge, "fewer than two frames meet there");
    if (places.empty())
      refuse("Hinge", hinge, "there is no node of a frame");
    hinged_.insert(places.begin(), places.end());
  }
}

void Builder::add_body(const unsigned int body)
{
  const RigidBody& description = device_.bodies[body];
  check_groups(description.groups, "Rigid body", description, mesh_);
  const auto places =
      find_group_places(description.groups, result_.mesh, mesh_);
  const auto film =
      gather_film_nodes(description.groups, description, "Rigid body", mesh_,
                        dof_handler_, positions_);
  Coordinates mean{};
  for (const auto place : places)
    mean = add(mean, result_.mesh.places[place]);
  double count = places.size();
  for (const auto& [node, x] : film)
  {
    if (!film_in_body_.insert({node, body}).second)
      refuse("Rigid body", description,
             "it shares nodes with the body '" +
                 device_.bodies[film_in_body_[node]].name + "'");
    // Where film and frame share a place it counts once.
    if (result_.mesh.find_place(x))
      continue;
    mean = add(mean, x);
    ++count;
  }
  if (places.empty() && film.empty())
    refuse("Rigid body", description, "its groups have no nodes");
  for (auto& component : mean)
    component /= count;
  for (const auto place : places)
  {
    if (body_of_[place])
      refuse("Rigid body", description,
             "it shares nodes with the body '" +
                 device_.bodies[*body_of_[place]].name + "'");
    body_of_[place] = body;
  }
  const GlobalNode centre = add_extra(description.centre.value_or(mean));
  result_.bodies.push_back({centre, add_rotation()});
}

void Builder::find_attached()
{
  attached_.assign(result_.mesh.places.size(), false);
  for (unsigned int f = 0; f < device_.frames.size(); ++f)
  {
    const Frame& frame = device_.frames[f];
    std::set<unsigned int> at;
    if (frame.attachment == Frame::Attachment::at)
    {
      check_groups(frame.attached_at, "Frame", frame, mesh_);
      at = find_group_places(frame.attached_at, result_.mesh, mesh_);
      bool any = false;
      for (const auto place : at)
        any = any || (frames_at_[place].count(f) > 0 &&
                      result_.mesh.film_nodes[place]);
      if (!any)
        refuse("Frame", frame,
               "no node of both the frame and a film is in 'Attached at'");
    }
    for (unsigned int place = 0; place < attached_.size(); ++place)
      if (frames_at_[place].count(f) > 0 && result_.mesh.film_nodes[place] &&
          (frame.attachment == Frame::Attachment::along || at.count(place) > 0))
        attached_[place] = true;
  }
}

void Builder::follow(const GlobalNode node, const Coordinates& x,
                     const GlobalNode centre, const unsigned int rotation)
{
  result_.followers.push_back(
      {node, centre, rotation, add(x, get_position(centre), -1)});
}

void Builder::add_rotations(const unsigned int place)
{
  FrameNode& node = result_.nodes[place];
  const bool hinged = hinged_.count(place) > 0;
  if (hinged && node.body)
    refuse("Hinge", device_.hinges.front(), "a rigid body has no hinges");
  std::optional<unsigned int> rotation;
  if (node.body)
    rotation = result_.bodies[*node.body].rotation;
  for (const auto frame : frames_at_[place])
  {
    if (!rotation || hinged)
      rotation = add_rotation();
    node.rotations[frame] = *rotation;
  }
}

void Builder::add_node(const unsigned int place)
{
  FrameNode& node = result_.nodes[place];
  node.body = body_of_[place];
  const Coordinates& x = result_.mesh.places[place];
  const Frame& frame = device_.frames[*frames_at_[place].begin()];
  const Coordinates arm = make_arm(frame);
  for (const auto other : frames_at_[place])
  {
    const Coordinates difference =
        add(make_arm(device_.frames[other]), arm, -1);
    if (std::sqrt(fe::dot(difference, difference)) > result_.mesh.tolerance)
      refuse("Frame", device_.frames[other],
             "it meets the frame '" + frame.name +
                 "', which has another offset: frames that meet must have "
                 "the same");
  }
  add_rotations(place);
  const auto film = result_.mesh.film_nodes[place];
  const bool is_film = attached_[place] && frame.offset == 0;
  node.position = is_film ? *film : add_extra(add(x, arm, -1));
  if (node.body)
  {
    const BodyNode& body = result_.bodies[*node.body];
    follow(node.position, is_film ? x : add(x, arm, -1), body.centre,
           body.rotation);
    if (attached_[place] && !is_film)
      follow(*film, x, body.centre, body.rotation);
  }
  else if (attached_[place] && !is_film)
    follow(*film, x, node.position, node.rotations.begin()->second);
}

FrameNodes Builder::make()
{
  find_frames();
  body_of_.resize(result_.mesh.places.size());
  for (unsigned int body = 0; body < device_.bodies.size(); ++body)
    add_body(body);
  find_attached();
  result_.nodes.resize(result_.mesh.places.size());
  for (unsigned int place = 0; place < result_.nodes.size(); ++place)
    add_node(place);
  std::set<GlobalNode> following;
  for (const auto& follower : result_.followers)
    following.insert(follower.node);
  for (const auto& [node, body] : film_in_body_)
    if (following.count(node) == 0)
    {
      const auto& centre = result_.bodies[body];
      Coordinates x{};
      if (const auto found = positions_.find(node); found != positions_.end())
        x = {found->second[0], found->second[1], found->second[2]};
      follow(node, x, centre.centre, centre.rotation);
    }
  return std::move(result_);
}
} // namespace

std::vector<GlobalNode>
FrameNodes::get_shared_film_nodes(const GlobalNode n_film) const
{
  std::vector<GlobalNode> shared;
  for (const auto& node : nodes)
    if (node.position < n_film)
      shared.push_back(node.position);
  return shared;
}

FrameNodes make_frame_nodes(const Device& device, const fe::MeshData& mesh,
                            const DoFHandler& dof_handler,
                            const NodePositions& positions)
{
  return Builder(device, mesh, dof_handler, positions).make();
}

void add_frame_nodes(const FrameNodes& frame_nodes, fe::Nodes& nodes)
{
  for (const auto node : frame_nodes.rotations)
    nodes.rotations.push_back({nodes.local(node), frame_nodes.rotation_length});
  for (const auto& follower : frame_nodes.followers)
  {
    fe::LocalNode node;
    try
    {
      node = nodes.local(follower.node);
    }
    catch (const std::out_of_range&)
    {
      // A film node of other ranks.
      continue;
    }
    nodes.followers.push_back(
        {node, nodes.local(follower.centre), follower.rotation, follower.arm});
    nodes.dependent[node] = true;
    nodes.held[node] = 0;
  }
}
} // namespace taut::structure
