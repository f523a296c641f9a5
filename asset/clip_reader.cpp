#include "asset/clip_reader.hpp"
#include "asset/transform.hpp"
#include "text/message.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace pelt::asset {

namespace {

class ClipReader {
 public:
  ClipReader(const GltfDocument& document, const NodeGraph& graph, AccessorReader& reader,
             const std::vector<MorphTarget>& targets);

  Result<Clip> read(std::uint32_t animation);
  std::size_t passed_over() const { return passed_over_; }

 private:
  Result<void> add_channel(const GltfAnimation& animation, const GltfChannel& source, Clip& clip);
  Result<Channel> read_channel(const GltfSampler& sampler, const GltfChannel& source,
                               std::vector<float> times);
  Result<std::vector<float>> read_times(std::uint32_t accessor);
  std::size_t weights_of(const GltfChannel& channel) const;
  bool is_of_interest(const GltfChannel& channel) const;
  Result<std::vector<float>> read_values(const GltfSampler& sampler, const GltfChannel& source,
                                         std::size_t key_count);
  Result<void> normalise_keys(std::uint32_t accessor, std::vector<float>& values);
  Result<void> require_animatable(const GltfChannel& channel);

  const GltfDocument& document_;
  const NodeGraph& graph_;
  AccessorReader& reader_;
  std::set<std::pair<std::uint32_t, GltfPath>> targets_;  ///< of the current clip
  std::map<std::uint32_t, std::size_t> target_counts_;    ///< morph targets by position of the node
  std::size_t passed_over_ = 0;
};

Path to_path(GltfPath path) {
  if (path == GltfPath::translation) return Path::translation;
  if (path == GltfPath::weights) return Path::weights;
  return path == GltfPath::rotation ? Path::rotation : Path::scale;
}

ClipReader::ClipReader(const GltfDocument& document, const NodeGraph& graph, AccessorReader& reader,
                       const std::vector<MorphTarget>& targets)
    : document_(document), graph_(graph), reader_(reader) {
  for (const MorphTarget& target : targets) ++target_counts_[target.node];
}

/// Number of morph targets that a channel of weights animates.
std::size_t ClipReader::weights_of(const GltfChannel& channel) const {
  const auto known = target_counts_.find(graph_.position[*channel.node]);
  return known == target_counts_.end() ? 0 : known->second;
}

/// Whether the channel animates anything that was read.
bool ClipReader::is_of_interest(const GltfChannel& channel) const {
  if (!channel.node || channel.path == GltfPath::unknown) return false;
  return channel.path != GltfPath::weights || weights_of(channel) > 0;
}

Result<Clip> ClipReader::read(std::uint32_t index) {
  const GltfAnimation& animation = document_.animations[index];
  Clip clip;
  clip.name = animation.name;
  targets_.clear();
  for (const GltfChannel& channel : animation.channels) {
    const Result<void> added = add_channel(animation, channel, clip);
    if (!added)
      return text::prefixed(text::label("animation", index, animation.name), added.error());
  }
  return clip;
}

Result<void> ClipReader::add_channel(const GltfAnimation& animation, const GltfChannel& source,
                                     Clip& clip) {
  const GltfSampler& sampler = animation.samplers[source.sampler];
  Result<std::vector<float>> times = read_times(sampler.times);
  if (!times) return times.error();
  clip.duration = std::max(clip.duration, times->back());
  if (!is_of_interest(source)) {
    ++passed_over_;
    return {};
  }
  const Result<void> animatable = require_animatable(source);
  if (!animatable) return animatable.error();
  Result<Channel> channel = read_channel(sampler, source, *std::move(times));
  if (!channel) return text::prefixed(node_label(document_, *source.node), channel.error());
  clip.channels.push_back(*std::move(channel));
  return {};
}

Result<Channel> ClipReader::read_channel(const GltfSampler& sampler, const GltfChannel& source,
                                         std::vector<float> times) {
  Channel channel;
  channel.node = graph_.position[*source.node];
  channel.path = to_path(source.path);
  channel.interpolation = sampler.interpolation;
  Result<std::vector<float>> values = read_values(sampler, source, times.size());
  if (!values) return values.error();
  channel.times = std::move(times);
  channel.values = *std::move(values);
  return channel;
}

Result<std::vector<float>> ClipReader::read_times(std::uint32_t accessor) {
  const std::string use = "times of keys";
  Result<std::vector<float>> times =
      reader_.floats(accessor, ElementType::scalar, Storage::floats, use);
  if (!times) return times;
  if (times->empty()) return text::malformed(accessor_label(accessor, use) + ": is empty");
  if (times->front() < 0) {
    return text::malformed(accessor_label(accessor, use) + ": the first time is negative");
  }
  const auto fault = std::adjacent_find(times->begin(), times->end(),
                                        [](float time, float next) { return !(time < next); });
  if (fault == times->end()) return times;
  return text::malformed(accessor_label(accessor, use) + ": key " +
                         std::to_string(fault - times->begin() + 1) +
                         " is not later than the one before it");
}

Result<std::vector<float>> ClipReader::read_values(const GltfSampler& sampler,
                                                   const GltfChannel& source,
                                                   std::size_t key_count) {
  const bool rotation = source.path == GltfPath::rotation;
  const bool weights = source.path == GltfPath::weights;
  const bool cubic = sampler.interpolation == Interpolation::cubic_spline;
  const std::string use = "values of keys";
  const std::uint64_t expected =
      std::uint64_t{key_count} * (cubic ? 3 : 1) * (weights ? weights_of(source) : 1);
  if (reader_.count(sampler.values) != expected) {
    return text::malformed(accessor_label(sampler.values, use) + ": has " +
                           std::to_string(reader_.count(sampler.values)) + " elements, must have " +
                           std::to_string(expected));
  }
  const ElementType type = weights    ? ElementType::scalar
                           : rotation ? ElementType::vec4
                                      : ElementType::vec3;
  Result<std::vector<float>> values =
      reader_.floats(sampler.values, type,
                     rotation || weights ? Storage::floats_or_normalised : Storage::floats, use);
  if (!values || !rotation || cubic) return values;
  const Result<void> unit = normalise_keys(sampler.values, *values);
  if (!unit) return unit.error();
  return values;
}

Result<void> ClipReader::normalise_keys(std::uint32_t accessor, std::vector<float>& values) {
  for (std::size_t key = 0; 4 * key < values.size(); ++key) {
    float* value = &values[4 * key];
    std::array<float, 4> rotation = {value[0], value[1], value[2], value[3]};
    if (!normalise(rotation)) {
      return text::malformed(accessor_label(accessor, "values of keys") + ": key " +
                             std::to_string(key) + " is not a unit quaternion");
    }
    std::copy(rotation.begin(), rotation.end(), value);
  }
  return {};
}

Result<void> ClipReader::require_animatable(const GltfChannel& channel) {
  const std::string node = node_label(document_, *channel.node);
  if (document_.nodes[*channel.node].has_matrix && channel.path != GltfPath::weights) {
    return text::malformed(node + " is animated, but has a matrix");
  }
  if (!targets_.emplace(*channel.node, channel.path).second) {
    return text::malformed(node + " has two channels for the same property");
  }
  return {};
}

}  // namespace

Result<std::vector<Clip>> read_clips(const GltfDocument& document, const NodeGraph& graph,
                                     AccessorReader& reader,
                                     const std::vector<MorphTarget>& targets,
                                     std::vector<std::string>& warnings) {
  ClipReader clip_reader(document, graph, reader, targets);
  std::vector<Clip> clips;
  for (std::uint32_t i = 0; i < document.animations.size(); ++i) {
    Result<Clip> clip = clip_reader.read(i);
    if (!clip) return clip.error();
    clips.push_back(*std::move(clip));
  }
  if (clip_reader.passed_over() > 0) {
    warnings.push_back(std::to_string(clip_reader.passed_over()) +
                       " animation channels are ignored: they animate nothing that was read");
  }
  return clips;
}

}  // namespace pelt::asset
