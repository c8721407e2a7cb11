#include "raster/hdf5/hdf5_dataset.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "raster/hdf5/hdf5_numbers.hpp"
#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace {

constexpr std::uint64_t best_compression = 1032;  // No deflate stream grows by more.
constexpr std::uint64_t allowed_chunk_growth = 16;
constexpr std::uint64_t small_chunk = std::uint64_t{1} << 20;
constexpr std::size_t largest_element = 1024;
constexpr int max_filters = 32;

// Those that every build of the library has: of others it would look for a plug-in, which is foreign code.
constexpr std::array<H5Z_filter_t, 6> built_in_filters{H5Z_FILTER_DEFLATE, H5Z_FILTER_SHUFFLE, H5Z_FILTER_FLETCHER32,
                                                       H5Z_FILTER_SZIP,    H5Z_FILTER_NBIT,    H5Z_FILTER_SCALEOFFSET};

// Whether the library itself has a filter: whatever HDF5_PLUGIN_PATH says, no code is loaded because of a file.
bool is_built_in(H5Z_filter_t filter) {
  if (std::ranges::find(built_in_filters, filter) == built_in_filters.end()) return false;
  unsigned plugins = 0;
  H5PLget_loading_state(&plugins);
  H5PLset_loading_state(0);
  const bool there = H5Zfilter_avail(filter) > 0;
  H5PLset_loading_state(plugins);  // It is that of the whole process.
  return there;
}

core::ProblemBuilder problem_of(const std::string& path, const std::string& what) {
  return core::error(fmt::format("the dataset {} {}", path, what));
}

// The names of filters that the HDF Group has registered and people use; the file says some of them too.
std::string name_of_filter(H5Z_filter_t filter, std::string_view said) {
  constexpr std::pair<H5Z_filter_t, std::string_view> known[] = {
      {H5Z_FILTER_SZIP, "szip"}, {305, "lzo"},   {307, "bzip2"},  {32000, "lzf"}, {32001, "blosc"}, {32004, "lz4"},
      {32008, "bitshuffle"},     {32013, "zfp"}, {32015, "zstd"}, {32017, "sz"},  {32024, "sz3"},   {32026, "blosc2"}};
  const auto* const found = std::ranges::find(known, filter, &std::pair<H5Z_filter_t, std::string_view>::first);
  std::string name(found != std::end(known) ? found->second : said.substr(0, said.find(';')));
  std::erase_if(name, [](char c) { return c < ' ' || c > '~'; });
  return name.empty() ? fmt::format("{}", filter) : fmt::format("{} ({})", name, filter);
}

std::optional<core::Problem> filter_problem(hid_t properties, const std::string& path) {
  const int filters = H5Pget_nfilters(properties);
  if (filters < 0 || filters > max_filters) return problem_of(path, "has a damaged list of filters");
  for (int i = 0; i < filters; ++i) {
    unsigned flags = 0;
    unsigned configuration = 0;
    std::size_t values = 0;
    std::array<char, 64> name{};
    const H5Z_filter_t filter = H5Pget_filter2(properties, static_cast<unsigned>(i), &flags, &values, nullptr,
                                               name.size(), name.data(), &configuration);
    name.back() = '\0';
    if (!is_built_in(filter))
      return problem_of(path, "is stored with a filter that is not built in")
          .found(name_of_filter(filter, name.data()))
          .expected("deflate, shuffle, fletcher32, szip, nbit or scaleoffset, or none")
          .hint(fmt::format("where the filter's plug-in is installed: h5repack -f {}:NONE IN.h5 OUT.h5", path));
  }
  return std::nullopt;
}

std::optional<core::Problem> chunk_problem(hid_t properties, const std::string& path, std::size_t element,
                                           std::uint64_t file_bytes) {
  std::array<hsize_t, 2> chunk{1, 1};
  if (H5Pget_chunk(properties, 2, chunk.data()) < 1) return problem_of(path, "has damaged chunks");
  const auto bytes = checked_product(chunk[0], chunk[1], element);
  const std::uint64_t most = small_chunk + allowed_chunk_growth * file_bytes;
  if (!bytes || *bytes > most)
    return problem_of(path, "has chunks larger than its file allows").found(fmt::format("{} x {}", chunk[0], chunk[1]));
  return std::nullopt;
}

// A contiguous dataset must lie within the file as a whole; chunks may be compressed, or absent and then zero.
std::optional<core::Problem> storage_problem(const Hdf5Dataset& dataset, const std::string& path,
                                             std::uint64_t file_bytes) {
  const Hdf5Handle properties(H5Dget_create_plist(dataset.id.get()), H5Pclose);
  if (!properties) return problem_of(path, "cannot be understood").found(hdf5_error_text());
  const std::size_t element = H5Tget_size(dataset.type.get());
  const std::uint64_t columns = dataset.shape.size() > 1 ? dataset.shape[1] : 1;
  const auto bytes = checked_product(dataset.shape[0], columns, element);
  const std::string size = fmt::format("{} x {} elements of {} bytes", dataset.shape[0], columns, element);
  if (!bytes) return problem_of(path, "is too large").found(size);
  if (H5Pget_external_count(properties.get()) != 0) return problem_of(path, "is stored in other files");
  if (auto problem = filter_problem(properties.get(), path)) return problem;
  switch (H5Pget_layout(properties.get())) {
    case H5D_COMPACT: break;
    case H5D_CONTIGUOUS: {
      const haddr_t offset = H5Dget_offset(dataset.id.get());
      const bool inside = offset != HADDR_UNDEF && offset <= file_bytes && *bytes <= file_bytes - offset;
      if (*bytes > 0 && !inside) return problem_of(path, "lies beyond the end of the file").found(size);
      break;
    }
    case H5D_CHUNKED:
      if (auto problem = chunk_problem(properties.get(), path, element, file_bytes)) return problem;
      break;
    default: return problem_of(path, "has a layout that is not read");
  }
  if (*bytes / best_compression > file_bytes) return problem_of(path, "is larger than its file can hold").found(size);
  return std::nullopt;
}

// What a walk through a file has found.
struct DatasetList {
  hid_t file;
  std::string text;
  std::size_t count;
};

const char* word_of_type(hid_t type) {
  switch (H5Tget_class(type)) {
    case H5T_COMPOUND: return complex_members(type) ? "complex" : "compound";
    case H5T_FLOAT: return "float";
    case H5T_INTEGER: return "integer";
    case H5T_STRING: return "text";
    default: return "other";
  }
}

herr_t note_dataset(hid_t root, const char* name, const H5O_info_t* info, void* data) {
  constexpr std::size_t max_listed = 12;
  constexpr std::size_t longest_name = 60;
  auto& list = *static_cast<DatasetList*>(data);
  if (info->type != H5O_TYPE_DATASET) return 0;
  if (list.count++ == max_listed) {
    list.text += ", ...";
    return 1;
  }
  const Hdf5Handle dataset(H5Dopen2(root, name, H5P_DEFAULT), H5Dclose);
  const Hdf5Handle space(H5Dget_space(dataset.get()), H5Sclose);
  const Hdf5Handle type(H5Dget_type(dataset.get()), H5Tclose);
  std::array<hsize_t, H5S_MAX_RANK> sizes{};
  const int rank = H5Sget_simple_extent_dims(space.get(), sizes.data(), nullptr);
  std::string shape;
  for (int i = 0; i < rank; ++i) shape += fmt::format("{}{}", i > 0 ? " x " : "", sizes[static_cast<std::size_t>(i)]);
  std::string shown = std::string(name).substr(0, longest_name);
  std::erase_if(shown, [](char c) { return c >= 0 && c < ' '; });
  list.text += fmt::format("{}/{} ({}{}{})", list.text.empty() ? "" : ", ", shown, shape, shape.empty() ? "" : ", ",
                           word_of_type(type.get()));
  return 0;
}

}  // namespace

std::variant<Hdf5Handle, core::Problem> open_hdf5_file(const std::filesystem::path& path) {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fclose_degree(access.get(), H5F_CLOSE_STRONG);
#if H5_VERSION_GE(1, 10, 7)
  H5Pset_file_locking(access.get(), false, true);  // Reading needs no lock, and some file systems have none.
#endif
  Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose);
  if (!file)
    return file_problem({}, "cannot be read as HDF5: " + hdf5_error_text(), {}, {},
                        "the file is damaged or of another format");
  return file;
}

bool has_object(hid_t file, const std::string& path) {
  for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
    const std::string part = path.substr(0, end);
    H5L_info_t link{};
    if (H5Lexists(file, part.c_str(), H5P_DEFAULT) <= 0) return false;
    if (H5Lget_info(file, part.c_str(), &link, H5P_DEFAULT) < 0 || link.type != H5L_TYPE_HARD) return false;
    if (end == std::string::npos) return true;
  }
}

bool has_link(hid_t file, const std::string& path) { return H5Lexists(file, path.c_str(), H5P_DEFAULT) > 0; }

bool is_of_2015(hid_t file) { return !has_object(file, samples_path) && has_object(file, old_samples_path); }

std::string path_of_samples(hid_t file, const std::string& dataset) {
  if (!dataset.empty()) return dataset.starts_with('/') ? dataset : "/" + dataset;
  return is_of_2015(file) ? old_samples_path : samples_path;
}

std::string list_of_datasets(hid_t file) {
  DatasetList list{file, {}, 0};
  H5Ovisit_by_name2(file, "/", H5_INDEX_NAME, H5_ITER_INC, note_dataset, &list, H5O_INFO_BASIC, H5P_DEFAULT);
  return list.text;
}

std::variant<Hdf5Dataset, core::Problem> open_dataset(hid_t file, const std::string& path, std::uint64_t file_bytes) {
  if (!has_object(file, path)) return problem_of(path, "is not in the file");
  H5O_info_t object{};
  if (H5Oget_info_by_name2(file, path.c_str(), &object, H5O_INFO_BASIC, H5P_DEFAULT) < 0 ||
      object.type != H5O_TYPE_DATASET)
    return problem_of(path, "is not a dataset");
  Hdf5Dataset dataset;
  dataset.id = Hdf5Handle(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset.id) return problem_of(path, "cannot be opened").found(hdf5_error_text());
  dataset.type = Hdf5Handle(H5Dget_type(dataset.id.get()), H5Tclose);
  const Hdf5Handle space(H5Dget_space(dataset.id.get()), H5Sclose);
  if (!dataset.type || !space) return problem_of(path, "cannot be understood").found(hdf5_error_text());
  const int rank = H5Sget_simple_extent_ndims(space.get());
  if (rank != 1 && rank != 2)
    return problem_of(path, "has the wrong rank").found(fmt::format("{}", rank)).expected("1 or 2");
  std::array<hsize_t, 2> sizes{};
  H5Sget_simple_extent_dims(space.get(), sizes.data(), nullptr);
  dataset.shape.assign(sizes.begin(), sizes.begin() + rank);
  const std::size_t element = H5Tget_size(dataset.type.get());
  if (element == 0 || element > largest_element)
    return problem_of(path, "has elements of a strange size").found(fmt::format("{} bytes", element));
  if (auto problem = storage_problem(dataset, path, file_bytes)) return std::move(*problem);
  return dataset;
}

}  // namespace sarsim::raster
