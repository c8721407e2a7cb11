/* The C interface of Sarsim, a radar echo simulator: libsarsim.so.0.
 *
 *   cc program.c -lsarsim
 *
 * docs/formats/c-interface.md has a whole program. What follows holds for every function.
 *
 * Status. Every function that can fail returns a sarsim_status. SARSIM_OK is 0. What the call made is in its last
 * arguments but one; where it fails they are set to NULL, or left alone where they are memory of the caller's.
 *
 * Problems. The last argument of such a function takes a list of everything that is wrong or worth knowing: errors where
 * it failed, warnings and notes where it did not, NULL where there is nothing. It is freed with sarsim_problems_free. The
 * argument may be NULL if it is not needed.
 *
 * Handles. Functions that end in `_free` release a handle; NULL is allowed there. A handle keeps what it needs: a plan may be
 * used after its scene was freed. Strings that a function returns belong to the handle and live as long as it does,
 * unless the function says otherwise.
 *
 * Text is UTF-8 and ends with a zero byte. Names of files are the bytes that the system has for them.
 *
 * Units are SI and radians. Complex samples are pairs of numbers, I before Q, rows one after the other: the memory of an
 * array of C's `float complex` or `double complex`, of NumPy's complex64 or complex128.
 *
 * Threads. All functions may be called from many threads at once. One handle may be used by many threads at once as long
 * as none of them changes it (the functions that take it without `const`) or frees it. A sarsim_stop is an exception: it
 * may be requested from any thread and from a signal handler.
 *
 * The library writes nothing to standard streams, ends no process, installs no signal handler, changes no locale and lets
 * no exception out.
 *
 * Structures begin with `struct_size`. Set it to sizeof the structure and clear the rest, as SARSIM_INIT does:
 *
 *   sarsim_work work = SARSIM_INIT(sarsim_work);
 *
 * Later versions add members at the end, which programs compiled before then do not know; a library that is older than the
 * program refuses members that it does not know, unless they are zero.
 */
#pragma once

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define SARSIM_API __attribute__((visibility("default")))
#else
#define SARSIM_API
#endif

/* A cleared structure that knows its size; for the initialisation of a variable. */
#define SARSIM_INIT(type) {sizeof(type)}

/* ------------------------------------------------------------------------------------------------------ Versions */

/* Counts up with every function and member that is added. What a program was compiled for works with any library
 * libsarsim.so.0 whose number is not smaller. */
#define SARSIM_ABI_VERSION 2

/* The number of the library that runs. */
SARSIM_API int sarsim_abi_version(void);
/* Version of the program that the library belongs to: "0.1.0". Lives for ever. */
SARSIM_API const char* sarsim_version(void);

/* ------------------------------------------------------------------------------------------------ Status and text */

typedef int sarsim_status;
enum {
  SARSIM_OK = 0,           /* Done. */
  SARSIM_BAD_INPUT = 1,    /* Mistakes in a scene, a file or a value; all of them are in the list. */
  SARSIM_STOPPED = 2,      /* Stopped by a sarsim_stop. No partial output is left; memory of the caller is partly filled. */
  SARSIM_NO_MEMORY = 3,    /* The list may be NULL then. */
  SARSIM_FAILED = 4,       /* A failure of the world: a disk that is full, a folder that cannot be written. */
  SARSIM_BAD_ARGUMENT = 5, /* A mistake in the calling program: NULL, an index out of range, an unknown structure. */
  SARSIM_TRY_AGAIN = 6     /* Temporary failure: another process locks what is needed, or the system failed
                              temporarily. The same call may succeed later. */
};

/* A status in a word: "ok", "bad input", "stopped", "no memory", "failed", "bad argument",
 * "try again". Lives for ever. */
SARSIM_API const char* sarsim_status_word(sarsim_status status);

/* A text that a function made. */
typedef struct sarsim_text sarsim_text;
SARSIM_API void sarsim_text_free(sarsim_text* text);
/* Its characters, with a zero byte behind them; "" for NULL. */
SARSIM_API const char* sarsim_text_chars(const sarsim_text* text);
/* Number of bytes without that zero; 0 for NULL. */
SARSIM_API size_t sarsim_text_length(const sarsim_text* text);

/* ------------------------------------------------------------------------------------------------------ Problems */

/* What was found: errors before warnings before notes. */
typedef struct sarsim_problems sarsim_problems;

typedef int sarsim_severity;
enum {
  SARSIM_ERROR = 0,   /* The call failed for it. */
  SARSIM_WARNING = 1, /* Probably a mistake. */
  SARSIM_NOTE = 2     /* Worth knowing. */
};

/* One problem. Texts are "" and numbers 0 where they do not apply. */
typedef struct sarsim_problem {
  size_t struct_size;
  sarsim_severity severity;
  const char* message;  /* What is wrong, in words. */
  const char* found;    /* The text or value that is to blame. */
  const char* expected; /* What would have been right. */
  const char* hint;     /* How to mend it. */
  const char* file;     /* File of the problem, with line and column (in bytes) from 1. */
  size_t line;
  size_t column;
  const char* object;  /* What it is about: "platform", "target", "cloud", "surface", "radar", "simulation", "geometry",
                          "options", "world", "atmosphere". */
  size_t object_index; /* Of the objects of this kind, from 0. */
  const char* field;   /* "bandwidth_hz". */
  size_t count;        /* How often the same cause was met, at least 1. */
  const char* text;    /* All of it, as the command prints it: "a.toml:3:9: error: ..." */
} sarsim_problem;

SARSIM_API void sarsim_problems_free(sarsim_problems* problems);
/* How many there are; 0 for NULL. */
SARSIM_API size_t sarsim_problems_count(const sarsim_problems* problems);
/* Number `index` of them. SARSIM_BAD_ARGUMENT where there is none. */
SARSIM_API sarsim_status sarsim_problems_get(const sarsim_problems* problems, size_t index, sarsim_problem* problem);

/* ----------------------------------------------------------------------------------------------------------- Work */

/* A request to end work early. It stays requested. */
typedef struct sarsim_stop sarsim_stop;
SARSIM_API sarsim_status sarsim_stop_new(sarsim_stop** stop, sarsim_problems** problems);
/* Not before the calls that it was given to have returned. */
SARSIM_API void sarsim_stop_free(sarsim_stop* stop);
/* Ends the work that it was given to, within about the time of one row on each thread. From any thread, from a callback
 * and from a signal handler. */
SARSIM_API void sarsim_stop_request(sarsim_stop* stop);

/* Reports progress: `done` of `total` units (mostly rows) of a stage, named for people. Called on the thread
 * that called the function, never from two threads at once, and not after the function has returned. It may call
 * sarsim_stop_request; it must not free what the function works on, nor leave by longjmp or an exception. */
typedef void (*sarsim_progress)(void* user, const char* stage, uint64_t done, uint64_t total);

/* How work is done. Nothing here changes a bit of the result. NULL in place of it is the same as all zeros. */
typedef struct sarsim_work {
  size_t struct_size;
  unsigned threads;         /* 0: one for each core. */
  const sarsim_stop* stop;  /* NULL: nothing stops it. */
  sarsim_progress progress; /* NULL: no progress reports. */
  void* user;               /* For `progress`. */
} sarsim_work;

/* --------------------------------------------------------------------------------------------------------- Scenes */

/* A scene as it was read and, perhaps, changed. */
typedef struct sarsim_scene sarsim_scene;

/* How a scene is read. NULL in place of it is the same as all zeros. */
typedef struct sarsim_scene_options {
  size_t struct_size;
  const char* const* let; /* "NAME=VALUE": numbers or expressions in place of those in [let] of format 2. */
  size_t let_count;
  const sarsim_work* work; /* How it is done; NULL: nothing stops it, and a pipe, which may never end, is refused. */
} sarsim_scene_options;

/* Reads a scene, in either language, with the files that it includes and names. SARSIM_BAD_INPUT with all mistakes of the
 * text; otherwise remarks, with the warnings about these files. sarsim_scene_check tells whether it can be simulated. */
SARSIM_API sarsim_status sarsim_scene_read_file(const char* path, const sarsim_scene_options* options,
                                                sarsim_scene** scene, sarsim_problems** problems);
/* The same from `length` bytes. `name` is that of a file that need not exist: problems refer to it, and
 * included files and data files are looked for in its folder. NULL: "scene", in the current folder. */
SARSIM_API sarsim_status sarsim_scene_read_text(const char* text, size_t length, const char* name,
                                                const sarsim_scene_options* options, sarsim_scene** scene,
                                                sarsim_problems** problems);
SARSIM_API sarsim_status sarsim_scene_copy(const sarsim_scene* scene, sarsim_scene** copy, sarsim_problems** problems);
SARSIM_API void sarsim_scene_free(sarsim_scene* scene);

typedef int sarsim_language;
enum {
  SARSIM_FORMAT_2 = 0, /* TOML: docs/formats/scene.md. */
  SARSIM_SCRIPT = 1    /* The language of 1998: docs/formats/script.md. */
};

/* The scene as it is now, as a text; comments of the text that was read are not in it. SARSIM_BAD_INPUT where the
 * language cannot express it. */
SARSIM_API sarsim_status sarsim_scene_text(const sarsim_scene* scene, sarsim_language language, sarsim_text** text,
                                           sarsim_problems** problems);

/* Errors, warnings and notes on the scene and its echoes, as `sarsim check` lists them. SARSIM_BAD_INPUT
 * where it cannot be simulated. */
SARSIM_API sarsim_status sarsim_scene_check(const sarsim_scene* scene, const sarsim_work* work,
                                            sarsim_problems** problems);

/* Number of the objects of a kind: "platform", "target", "cloud", "surface", "radar", "simulation", "geometry". */
SARSIM_API sarsim_status sarsim_scene_count(const sarsim_scene* scene, const char* kind, size_t* count,
                                            sarsim_problems** problems);
/* What precedes the point in the names of its fields: "Radar1", "Target3". */
SARSIM_API sarsim_status sarsim_scene_name(const sarsim_scene* scene, const char* kind, size_t index, sarsim_text** name,
                                           sarsim_problems** problems);

/* The value of a field by the name that `sarsim run --set` has for it: "Radar1.bandwidth", "Target3.position.x", "seed".
 * Numbers have a unit: "50 MHz". SARSIM_BAD_INPUT for a name that means nothing, with the nearest one. */
SARSIM_API sarsim_status sarsim_scene_get(const sarsim_scene* scene, const char* field, sarsim_text** value,
                                          sarsim_problems** problems);
/* Sets it, as --set does: of all objects that the name means ("Target*.rcs"), in any unit ("0.05 GHz"), numbers without a
 * unit in SI units, degrees and decibels. Where the value is refused the scene is unchanged. What only makes no sense
 * together with other fields, sarsim_scene_check says. */
SARSIM_API sarsim_status sarsim_scene_set(sarsim_scene* scene, const char* field, const char* value,
                                          sarsim_problems** problems);

/* An empty scene, in format 2. `name` is as for sarsim_scene_read_text. */
SARSIM_API sarsim_status sarsim_scene_new(const char* name, sarsim_scene** scene, sarsim_problems** problems);

/* The value of a numeric field in its unit, which sarsim_scene_fields and sarsim_schema name: SI units, but degrees and
 * decibels, in which scenes have them. SARSIM_BAD_INPUT for a field that is not a number. A yes or no is 1 or 0. */
SARSIM_API sarsim_status sarsim_scene_get_number(const sarsim_scene* scene, const char* field, double* value,
                                                 sarsim_problems** problems);
/* Sets it, of all objects that the name means; exactly. */
SARSIM_API sarsim_status sarsim_scene_set_number(sarsim_scene* scene, const char* field, double value,
                                                 sarsim_problems** problems);
/* A field that is a function given by points: a pulse ("Radar1.pulse_iq"), a pattern ("Radar1.transmit_antenna.gain_db"), a
 * track ("Plane.trajectory_m"), an envelope. Sets it to `count` points: x ascending, and y of all points for each of its
 * `parts`, one part after the other, in the units that the field's name ends in. `method`: "linear", "cubic" or
 * "mfilter". The choice that the field belongs to has to be made before ("Radar1.pulse=user"). */
SARSIM_API sarsim_status sarsim_scene_set_points(sarsim_scene* scene, const char* field, size_t count, size_t parts,
                                                 const double* x, const double* y, const char* method,
                                                 sarsim_problems** problems);

/* Adds an object of a kind, at the end of its list, with the values that a new object has. `name` is that of a platform or
 * radar, or the file of a simulation or geometry table; NULL: one that is free. Its number comes back in `index`, which may
 * be NULL. */
SARSIM_API sarsim_status sarsim_scene_add(sarsim_scene* scene, const char* kind, const char* name, size_t* index,
                                          sarsim_problems** problems);
/* Removes an object; a platform together with all objects on it, a radar together with its recordings. */
SARSIM_API sarsim_status sarsim_scene_remove(sarsim_scene* scene, const char* kind, size_t index,
                                             sarsim_problems** problems);
/* Adds `count` targets on a platform: x, y, z of each in `positions_m`, cross-sections in `rcs_m2` (NULL: 1 m2). */
SARSIM_API sarsim_status sarsim_scene_add_targets(sarsim_scene* scene, const char* platform, size_t count,
                                                  const double* positions_m, const double* rcs_m2,
                                                  sarsim_problems** problems);
/* Adds a cloud of so many points, which take 32 bytes each, however many they are. `file` is the name that the scene's text
 * has for its table, which need not be there; writing it is left to the caller. */
SARSIM_API sarsim_status sarsim_scene_add_cloud(sarsim_scene* scene, const char* platform, const char* file,
                                                size_t count, const double* positions_m, const double* rcs_m2,
                                                sarsim_problems** problems);

/* The fields of an object that apply with its present choices, as a JSON array of objects: name (as sarsim_scene_get takes it),
 * id, value (a text), number (of fields that are numbers or a yes or no), unit (that the number is in). Kinds as in
 * sarsim_scene_count, and "options" and "atmosphere". */
SARSIM_API sarsim_status sarsim_scene_fields(const sarsim_scene* scene, const char* kind, size_t index,
                                             sarsim_text** text, sarsim_problems** problems);
/* The table of all fields of all kinds of objects as JSON, from which bindings are made: an object with a member "kinds", an
 * array of objects with name, title, meaning, single (whether a scene has one of them: options, and world and atmosphere,
 * which a text alone can say) and fields. Of a field: name (for sarsim_scene_set, behind that of the object and a point), id, path (in format 2), label,
 * group, type ("number", "choice", "check", "text", "platform", "radar", "function", "list"), unit, units, least, most,
 * default, default_number, choices (word, shown as sarsim_scene_get shows it, meaning), functions (how many values a point
 * has), when (it applies: field and among), tip. What does not apply is left out. */
SARSIM_API sarsim_status sarsim_schema(sarsim_text** text, sarsim_problems** problems);

typedef int sarsim_style;
enum {
  SARSIM_WORDS = 0, /* Lines for people. */
  SARSIM_JSON = 1   /* A JSON object. */
};

/* Explains a field, a choice, a kind of object or a word of format 2, as `sarsim explain` does: "radar.pulse.width".
 * "": what there is. */
SARSIM_API sarsim_status sarsim_explain(const char* word, sarsim_style style, sarsim_text** text,
                                        sarsim_problems** problems);

/* ----------------------------------------------------------------------------------------------------- Recordings */

/* A recording of a scene, checked and with everything decided before its first pulse. Never changes. */
typedef struct sarsim_plan sarsim_plan;

/* Plans recording `number` of a scene, from 1 as the commands count. SARSIM_BAD_INPUT with everything that keeps it from
 * being made; remarks on it where it can be. */
SARSIM_API sarsim_status sarsim_plan_new(const sarsim_scene* scene, size_t number, const sarsim_work* work,
                                         sarsim_plan** plan, sarsim_problems** problems);
SARSIM_API void sarsim_plan_free(sarsim_plan* plan);

/* What a recording is, and what it takes. */
typedef struct sarsim_plan_info {
  size_t struct_size;
  uint64_t rows;             /* Pulses; bursts where range profiles are synthesised. */
  uint64_t columns;          /* Complex samples of a row. */
  double sample_rate_hz;     /* Of the A/D converter. */
  int bits;                  /* Of the A/D converter. */
  double lsb_v;              /* Its least significant bit; 0 where the whole recording is needed to know it. */
  const char* radar;         /* Its name. */
  const char* processing;    /* "raw", "compressed", "range profiles". */
  const char* format;        /* Of the file that the scene asks for: "hdf5". */
  const char* file;          /* The name that the scene gives it. */
  const char* engine;        /* How echoes are added up. */
  const char* engine_reason; /* Why so. */
  double echoes;             /* Targets times pulses. */
  double seconds;            /* Estimate of the time on all cores, good to a factor of two. */
  double memory_bytes;       /* Estimate of the memory while it is made, on all cores. */
  double file_bytes;         /* Of the file that the scene asks for; an estimate for text. */
} sarsim_plan_info;

SARSIM_API sarsim_status sarsim_plan_get_info(const sarsim_plan* plan, sarsim_plan_info* info,
                                              sarsim_problems** problems);

/* Known values for each row or column. */
typedef int sarsim_axis;
enum {
  SARSIM_ROW_TIME_S = 0,       /* When its (first) pulse is sent; a number for each row. */
  SARSIM_ROW_CARRIER_HZ = 1,   /* Carrier of that pulse; a number for each row. */
  SARSIM_COLUMN_RANGE_M = 2,   /* Slant range, one way; a number for each column. */
  SARSIM_ROW_POSITION_M = 3,   /* x, y, z of the radar's platform in world axes then; three numbers for each row. */
  SARSIM_ROW_VELOCITY_MPS = 4, /* Its velocity; three numbers for each row. */
  SARSIM_ROW_ROTATION_RAD = 5  /* Its rotations about x, y and z; three numbers for each row. */
};

/* Copies rows or columns [first, first + count) of an axis to `values`, which has room for count (or 3 count) numbers. */
SARSIM_API sarsim_status sarsim_plan_axis(const sarsim_plan* plan, sarsim_axis axis, uint64_t first, uint64_t count,
                                          double* values, sarsim_problems** problems);

/* Computes rows [first, first + count) of a recording into `samples`, which has room for 2 * count * columns numbers: in
 * volts, without the A/D converter. The same numbers as in the HDF5 and NPY files of `sarsim run`, bit for bit, however
 * the rows are divided among calls and threads. */
SARSIM_API sarsim_status sarsim_record_float(const sarsim_plan* plan, uint64_t first, uint64_t count, float* samples,
                                             const sarsim_work* work, sarsim_problems** problems);
/* The same in double precision, as `sarsim run --double` has it. */
SARSIM_API sarsim_status sarsim_record_double(const sarsim_plan* plan, uint64_t first, uint64_t count, double* samples,
                                              const sarsim_work* work, sarsim_problems** problems);

/* How a recording is stored. NULL in place of it is the same as all zeros. */
typedef struct sarsim_file_options {
  size_t struct_size;
  const char* format; /* "ascii", "csv", "bracket", "binary", "npy", "hdf5", "zarr", "sigmf". NULL: as the file's ending
                         says, or, where that says nothing, as the scene does. */
  int replace;        /* A file that exists is replaced; 0: it is an error. */
  int counts;         /* Counts of the A/D converter in HDF5, NPY, Zarr and SigMF, in place of volts. */
  int header;         /* A header line in CSV. */
  int doubles;        /* Volts of HDF5, NPY, Zarr and SigMF in double precision. */
} sarsim_file_options;

/* What a file turned out to be. */
typedef struct sarsim_file_report {
  size_t struct_size;
  double seconds;     /* That it took. */
  double bytes;       /* Of the file. */
  double maximum_v;   /* Largest magnitude. */
  double lsb_v;       /* Least significant bit that was used. */
  uint64_t saturated; /* Samples whose I or Q was clipped. */
  uint64_t zero;      /* Samples whose counts are both 0. */
} sarsim_file_report;

/* Makes the file of a recording: the bytes that `sarsim run` writes. It appears when it is complete; stopped or failed,
 * nothing is left behind. `report` may be NULL. */
SARSIM_API sarsim_status sarsim_record_file(const sarsim_plan* plan, const char* path,
                                            const sarsim_file_options* options, const sarsim_work* work,
                                            sarsim_file_report* report, sarsim_problems** problems);

/* Called with rows [first, first + count) of a recording, count * columns pairs of numbers, which are gone when it
 * returns. Rows come in order, on the thread that called the function. 0: go on; anything else ends the work, which then
 * returns SARSIM_STOPPED. */
typedef int (*sarsim_rows)(void* user, uint64_t first, uint64_t count, const float* samples);

/* Computes rows [first, first + count) and hands them to `rows`, `block` at a time, in memory that does not grow with
 * their number. 0 blocks as many as make a few megabytes. `user` goes to `rows`; that of `work` goes to its progress. The
 * samples are those of sarsim_record_float. */
SARSIM_API sarsim_status sarsim_record_rows(const sarsim_plan* plan, uint64_t first, uint64_t count, uint64_t block,
                                            sarsim_rows rows, void* user, const sarsim_work* work,
                                            sarsim_problems** problems);

/* --------------------------------------------------------------------------------------------------------- Tables */

/* Numbers and texts in rows and named columns, as the commands write them to CSV. Never changes. */
typedef struct sarsim_table sarsim_table;
SARSIM_API void sarsim_table_free(sarsim_table* table);
/* Rows below the line of names; 0 for NULL. */
SARSIM_API size_t sarsim_table_rows(const sarsim_table* table);
SARSIM_API size_t sarsim_table_columns(const sarsim_table* table);
/* Name of a column, which ends in its unit: "range_m". "" where there is none. */
SARSIM_API const char* sarsim_table_name(const sarsim_table* table, size_t column);
/* Whether all of a column are numbers, but for what is empty. */
SARSIM_API int sarsim_table_is_number(const sarsim_table* table, size_t column);
/* Copies the numbers of a column to `values`, which has room for all rows: NaN for what is empty or none. */
SARSIM_API sarsim_status sarsim_table_numbers(const sarsim_table* table, size_t column, double* values,
                                              sarsim_problems** problems);
/* A value as text; "" where there is none. */
SARSIM_API const char* sarsim_table_text(const sarsim_table* table, size_t row, size_t column);
/* All of it as comma-separated values. */
SARSIM_API const char* sarsim_table_csv(const sarsim_table* table);

/* -------------------------------------------------------------------------------------------------------- Rasters */

/* Samples in rows and columns, with their metadata: a file of any format that Sarsim reads, an image that was
 * made, or the caller's memory. */
typedef struct sarsim_raster sarsim_raster;
SARSIM_API void sarsim_raster_free(sarsim_raster* raster);

/* Opens a file of samples: recordings, images, pictures. `options` are "NAME=VALUE" (sarsim_options of "raster"): the
 * layout of a file that does not describe itself. Its samples stay in the file until they are read; a text is read through,
 * which `work` can stop. */
SARSIM_API sarsim_status sarsim_raster_open(const char* path, const char* const* options, size_t option_count,
                                            const sarsim_work* work, sarsim_raster** raster,
                                            sarsim_problems** problems);
/* Makes a raster of rows * columns pairs of numbers in volts, which stay the caller's: they must not change or go before
 * the raster and everything that was made of it are freed. `pairs` 0: rows * columns real numbers. */
SARSIM_API sarsim_status sarsim_raster_of_floats(const float* samples, uint64_t rows, uint64_t columns, int pairs,
                                                 sarsim_raster** raster, sarsim_problems** problems);
/* Sets the coordinates of the rows or columns of such a raster. `name` is one of those of sarsim_axis_info: "pulse_time_s",
 * "carrier_hz", "azimuth_m", "cross_range_m", "y_m" of rows; "slant_range_m", "ground_range_m", "x_m" of columns.
 * Copies `count` values. */
SARSIM_API sarsim_status sarsim_raster_set_axis(sarsim_raster* raster, const char* name, const double* values,
                                                uint64_t count, sarsim_problems** problems);
/* Gives it an attribute; "script", "radar", "sample_rate_hz", "bits" and "lsb_v" are those of docs/formats/samples.md. */
SARSIM_API sarsim_status sarsim_raster_set_attribute(sarsim_raster* raster, const char* name, const char* value,
                                                     sarsim_problems** problems);

typedef int sarsim_value;
enum {
  SARSIM_COMPLEX = 0,   /* Pairs. */
  SARSIM_REAL = 1,      /* Numbers with a sign; the second of each pair that is read is 0. */
  SARSIM_MAGNITUDE = 2, /* Magnitudes; likewise. */
  SARSIM_POWER = 3,     /* Powers; likewise. */
  SARSIM_COLOUR = 4     /* Colours, which are read as their luminance. */
};

typedef struct sarsim_raster_info {
  size_t struct_size;
  uint64_t rows;
  uint64_t columns;
  sarsim_value value;
  int counts;            /* Not 0: numbers are counts of the A/D converter; else volts. */
  int bits;              /* Of the A/D converter; 0: unknown. */
  double lsb_v;          /* Volts of a count; 0: unknown. */
  double sample_rate_hz; /* 0: unknown. */
  const char* format;    /* "hdf5", "envi"; "" in memory. */
  const char* path;      /* "" in memory. */
  size_t attributes;     /* Number of them. */
  size_t axes;           /* Number of them. */
} sarsim_raster_info;

SARSIM_API sarsim_status sarsim_raster_get_info(const sarsim_raster* raster, sarsim_raster_info* info,
                                                sarsim_problems** problems);
/* Name and value of attribute number `index`; "" where there is none. The scene that a recording carries is "script". */
SARSIM_API const char* sarsim_raster_attribute_name(const sarsim_raster* raster, size_t index);
SARSIM_API const char* sarsim_raster_attribute_value(const sarsim_raster* raster, size_t index);
/* The value of an attribute by its name, in any case; NULL where there is none. */
SARSIM_API const char* sarsim_raster_attribute(const sarsim_raster* raster, const char* name);

/* Where rows or columns are. */
typedef struct sarsim_axis_info {
  size_t struct_size;
  const char* name; /* "pulse_time_s", "slant_range_m", ...; its unit is its end. */
  const char* unit; /* "s", "m", "Hz", ""; as the name has it. */
  int of_columns;   /* Not 0: a value for each column; else for each row. */
  uint64_t count;   /* Of its values. */
} sarsim_axis_info;

SARSIM_API sarsim_status sarsim_raster_axis_info(const sarsim_raster* raster, size_t index, sarsim_axis_info* info,
                                                 sarsim_problems** problems);
/* Copies values [first, first + count) of axis number `index`. */
SARSIM_API sarsim_status sarsim_raster_axis(const sarsim_raster* raster, size_t index, uint64_t first, uint64_t count,
                                            double* values, sarsim_problems** problems);

/* Which samples of a raster to read. All zeros but for the size, or NULL in place of it: all of them. */
typedef struct sarsim_window {
  size_t struct_size;
  uint64_t first_row;
  uint64_t rows; /* That are read; 0: all from the first on. */
  uint64_t first_column;
  uint64_t columns;     /* That are read; 0: all from the first on. */
  uint64_t row_step;    /* From one to the next; 0: 1. */
  uint64_t column_step; /* 0: 1. */
} sarsim_window;

/* Reads a window into `samples`, which has room for rows * columns pairs of numbers: volts, or counts as they are. */
SARSIM_API sarsim_status sarsim_raster_read_float(const sarsim_raster* raster, const sarsim_window* window,
                                                  float* samples, const sarsim_work* work, sarsim_problems** problems);
/* The same in double precision, without steps: counts are exact up to 2^53. */
SARSIM_API sarsim_status sarsim_raster_read_double(const sarsim_raster* raster, const sarsim_window* window,
                                                   double* samples, const sarsim_work* work,
                                                   sarsim_problems** problems);
/* Writes a raster to a file, in the format of its ending or of the option "to", with its axes and attributes as far as the
 * format has place for them. `options` are "NAME=VALUE" (sarsim_options of "write"). The file appears when it is complete. */
SARSIM_API sarsim_status sarsim_raster_write(const sarsim_raster* raster, const char* path, const char* const* options,
                                             size_t option_count, const sarsim_work* work, sarsim_problems** problems);

/* ----------------------------------------------------------------------------------------------- Work on echoes */

/* Echoes to work on. Keeps what it needs. */
typedef struct sarsim_source sarsim_source;
SARSIM_API void sarsim_source_free(sarsim_source* source);
/* Those of a file: a recording, or a scene, which is simulated. Opened by the functions that it is given to. */
SARSIM_API sarsim_status sarsim_source_file(const char* path, sarsim_source** source, sarsim_problems** problems);
/* Those of recording `number` of a scene, from 1, which are computed as they are needed. 0: the first that suits the
 * work. */
SARSIM_API sarsim_status sarsim_source_scene(const sarsim_scene* scene, size_t number, sarsim_source** source,
                                             sarsim_problems** problems);
/* Those of a recording in the caller's memory: all rows of the plan, in volts, as sarsim_record_float made them. The
 * memory must not change or go before the source is freed. */
SARSIM_API sarsim_status sarsim_source_floats(const sarsim_plan* plan, const float* samples, sarsim_source** source,
                                              sarsim_problems** problems);
/* The same in double precision. */
SARSIM_API sarsim_status sarsim_source_doubles(const sarsim_plan* plan, const double* samples, sarsim_source** source,
                                               sarsim_problems** problems);

/* What work came to: a report, rasters and tables. */
typedef struct sarsim_result sarsim_result;
SARSIM_API void sarsim_result_free(sarsim_result* result);
/* The report as a JSON object, as the command prints it with --json; "{}" where it has none. */
SARSIM_API const char* sarsim_result_json(const sarsim_result* result);
SARSIM_API size_t sarsim_result_raster_count(const sarsim_result* result);
/* Raster number `index`; a handle of its own, which may outlive the result. */
SARSIM_API sarsim_status sarsim_result_raster(const sarsim_result* result, size_t index, sarsim_raster** raster,
                                              sarsim_problems** problems);
SARSIM_API size_t sarsim_result_table_count(const sarsim_result* result);
/* Table number `index`; a handle of its own. */
SARSIM_API sarsim_status sarsim_result_table(const sarsim_result* result, size_t index, sarsim_table** table,
                                             sarsim_problems** problems);

/* The functions below take `options`: the words of the command of the same name, without hyphens before them: "window=hann",
 * "algorithm=back-projection", "autofocus". sarsim_options lists them. Names of files request files;
 * results without a file stay in memory. Numbers of threads come from `work`. */

/* The options of "focus", "profiles", "isar", "doppler", "search", "measure", "geometry", "theory", "export", "sweep",
 * "raster" or "write": as lines for people, or as a JSON array of objects with the members name, kind ("flag", "text", "texts",
 * "number", "whole", "choice"), takes (what stands for its value), help, words (of a choice), least and most (of a whole
 * number). */
SARSIM_API sarsim_status sarsim_options(const char* work, sarsim_style style, sarsim_text** text,
                                        sarsim_problems** problems);

/* Focuses echoes to a SAR image: raster 0. Its samples may be in memory or on disk, as the option "memory" allows. */
SARSIM_API sarsim_status sarsim_focus(const sarsim_source* source, const char* const* options, size_t option_count,
                                      const sarsim_work* work, sarsim_result** result, sarsim_problems** problems);
/* Range profiles of a stepped carrier: raster 0, a profile in each row. Table 0 has the targets of the scene in one. */
SARSIM_API sarsim_status sarsim_profiles(const sarsim_source* source, const char* const* options, size_t option_count,
                                         const sarsim_work* work, sarsim_result** result, sarsim_problems** problems);
/* Images of a turning target: a raster for each. */
SARSIM_API sarsim_status sarsim_isar(const sarsim_source* source, const char* const* options, size_t option_count,
                                     const sarsim_work* work, sarsim_result** result, sarsim_problems** problems);
/* Range-Doppler maps, one below the other: raster 0. Table 0: detections. */
SARSIM_API sarsim_status sarsim_doppler(const sarsim_source* source, const char* const* options, size_t option_count,
                                        const sarsim_work* work, sarsim_result** result, sarsim_problems** problems);
/* A plan position indicator: raster 0. Table 0: detections. */
SARSIM_API sarsim_status sarsim_search(const sarsim_source* source, const char* const* options, size_t option_count,
                                       const sarsim_work* work, sarsim_result** result, sarsim_problems** problems);
/* Measures the point targets of an image that sarsim_focus made, in memory or in a file: table 0, a row for each. */
SARSIM_API sarsim_status sarsim_measure(const sarsim_raster* image, const char* const* options, size_t option_count,
                                        const sarsim_work* work, sarsim_result** result, sarsim_problems** problems);
/* Expected values for the targets in the image that sarsim_focus would make with these options: table 0. Reads no
 * echoes. */
SARSIM_API sarsim_status sarsim_theory(const sarsim_source* source, const char* const* options, size_t option_count,
                                       const sarsim_work* work, sarsim_result** result, sarsim_problems** problems);
/* Where platforms and targets are, pulse by pulse: a table for each geometry table of the scene, or the one that options
 * describe. */
SARSIM_API sarsim_status sarsim_geometry(const sarsim_source* source, const char* const* options, size_t option_count,
                                         const sarsim_work* work, sarsim_result** result, sarsim_problems** problems);
/* Writes echoes as a file of a standard that programs of others read: CPHD or CRSD, by the extension of the option "out".
 * The report has its vectors and samples. The file appears when it is complete. */
SARSIM_API sarsim_status sarsim_export(const sarsim_source* source, const char* const* options, size_t option_count,
                                       const sarsim_work* work, sarsim_result** result, sarsim_problems** problems);
/* Runs a scene with many values: table 0, a row for each product of each variation. Files go to the folder of the option
 * "out". */
SARSIM_API sarsim_status sarsim_sweep(const sarsim_scene* scene, const char* const* options, size_t option_count,
                                      const sarsim_work* work, sarsim_result** result, sarsim_problems** problems);

#ifdef __cplusplus
}
#endif
