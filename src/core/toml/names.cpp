#include "core/toml/names.hpp"

#include <functional>

#include "core/toml/values.hpp"

namespace sarsim::core::toml {

namespace {

// What a part of a key means; `room` holds it where that is not a piece of the text.
std::string_view meaning(std::string_view text, Span part, std::string& room) {
  const std::string_view typed = piece(text, part);
  if (!typed.starts_with('"') && !typed.starts_with('\'')) return typed;
  if (typed[0] == '\'' || typed.find('\\') == std::string_view::npos) return typed.substr(1, typed.size() - 2);
  return room = decoded_key_part(text, part);
}

std::uint32_t hash_of(std::uint32_t parent, std::string_view name) {
  std::uint64_t hash = std::hash<std::string_view>{}(name) + parent * std::uint64_t{0x9E3779B97F4A7C15};
  hash = (hash ^ (hash >> 32U)) * 0xD6E8FEB86659FD93U;
  return static_cast<std::uint32_t>(hash >> 32U);
}

}  // namespace

Names::Names(std::string_view text) : text_(text), names_(1), buckets_(64) {}

std::optional<Clash> Names::add_header(const Parts& parts, bool element, Node& table) {
  Node node = root;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    const auto [next, added] = find_or_add(node, parts[i], Made::by_path);
    if (names_[next].made == Made::as_value) return Clash{parts[i], false, Made::as_value, names_[next].key.begin};
    node = next;
  }
  const auto [last, added] = find_or_add(node, parts.back(), element ? Made::as_elements : Made::by_header);
  Name& name = names_[last];
  const bool allowed = added || name.made == (element ? Made::as_elements : Made::by_path);
  if (!allowed) return Clash{parts.back(), true, name.made, name.key.begin};
  if (element) {
    drop_children(last);
  } else {
    name.made = Made::by_header;
    name.key = parts.back();
  }
  table = last;
  return std::nullopt;
}

std::optional<Clash> Names::add_key(Node table, const Parts& parts) {
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    const auto [next, added] = find_or_add(table, parts[i], Made::by_dots);
    Name& name = names_[next];
    // A table that only a path has made so far is defined here.
    if (name.made == Made::by_path) name.made = Made::by_dots;
    if (name.made != Made::by_dots) return Clash{parts[i], false, name.made, name.key.begin};
    table = next;
  }
  const auto [last, added] = find_or_add(table, parts.back(), Made::as_value);
  if (!added) return Clash{parts.back(), true, names_[last].made, names_[last].key.begin};
  return std::nullopt;
}

Names::Node Names::begin_nameless() {
  Name name;
  name.made = Made::by_header;
  return new_name(name);
}

void Names::drop(Node table) {
  drop_children(table);
  release(table);
}

std::pair<Names::Node, bool> Names::find_or_add(Node parent, Span part, Made made) {
  const std::string_view wanted = meaning(text_, part, decoded_);
  const std::uint32_t hash = hash_of(parent, wanted);
  std::string room;
  for (Node node = buckets_[hash & (buckets_.size() - 1)]; node != 0; node = names_[node].next) {
    const Name& name = names_[node];
    if (name.hash == hash && name.parent == parent && meaning(text_, name.key, room) == wanted) return {node, false};
  }
  if (linked_ >= buckets_.size()) double_buckets();
  Node& bucket = buckets_[hash & (buckets_.size() - 1)];
  const Node node = new_name({part, parent, hash, bucket, 0, names_[parent].first_child, made});
  bucket = node;
  names_[parent].first_child = node;
  ++linked_;
  return {node, true};
}

Names::Node Names::new_name(const Name& name) {
  if (free_ == 0) {
    names_.push_back(name);
    return static_cast<Node>(names_.size() - 1);
  }
  const Node node = free_;
  free_ = names_[node].sibling;
  names_[node] = name;
  return node;
}

void Names::release(Node node) {
  names_[node].key = {};
  names_[node].sibling = std::exchange(free_, node);
}

void Names::unlink(Node node) {
  Node* link = &buckets_[names_[node].hash & (buckets_.size() - 1)];
  while (*link != node) link = &names_[*link].next;
  *link = names_[node].next;
  --linked_;
}

void Names::drop_children(Node table) {
  to_drop_.assign(1, table);
  while (!to_drop_.empty()) {
    const Node node = to_drop_.back();
    to_drop_.pop_back();
    for (Node child = names_[node].first_child; child != 0; child = names_[child].sibling) {
      unlink(child);
      to_drop_.push_back(child);
    }
    names_[node].first_child = 0;
    if (node != table) release(node);
  }
}

void Names::double_buckets() {
  buckets_.assign(2 * buckets_.size(), 0);
  for (Node node = 1; node < names_.size(); ++node) {
    if (names_[node].key.end == 0) continue;  // Free, or without a name.
    Node& bucket = buckets_[names_[node].hash & (buckets_.size() - 1)];
    names_[node].next = std::exchange(bucket, node);
  }
}

}  // namespace sarsim::core::toml
