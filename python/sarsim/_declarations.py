"""What sarsim.h declares. Written by tools/python-sources from src/capi/sarsim.h."""

from ctypes import CFUNCTYPE, Structure, c_char_p, c_double, c_int, c_size_t, c_uint, c_uint64, c_void_p

VERSION = "0.1.0"
ABI_VERSION = 2

SARSIM_OK = 0
SARSIM_BAD_INPUT = 1
SARSIM_STOPPED = 2
SARSIM_NO_MEMORY = 3
SARSIM_FAILED = 4
SARSIM_BAD_ARGUMENT = 5
SARSIM_TRY_AGAIN = 6

SARSIM_ERROR = 0
SARSIM_WARNING = 1
SARSIM_NOTE = 2

SARSIM_FORMAT_2 = 0
SARSIM_SCRIPT = 1

SARSIM_WORDS = 0
SARSIM_JSON = 1

SARSIM_ROW_TIME_S = 0
SARSIM_ROW_CARRIER_HZ = 1
SARSIM_COLUMN_RANGE_M = 2
SARSIM_ROW_POSITION_M = 3
SARSIM_ROW_VELOCITY_MPS = 4
SARSIM_ROW_ROTATION_RAD = 5

SARSIM_COMPLEX = 0
SARSIM_REAL = 1
SARSIM_MAGNITUDE = 2
SARSIM_POWER = 3
SARSIM_COLOUR = 4

sarsim_progress = CFUNCTYPE(None, c_void_p, c_char_p, c_uint64, c_uint64)

sarsim_rows = CFUNCTYPE(c_int, c_void_p, c_uint64, c_uint64, c_void_p)


class sarsim_problem(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("severity", c_int),
        ("message", c_char_p),
        ("found", c_char_p),
        ("expected", c_char_p),
        ("hint", c_char_p),
        ("file", c_char_p),
        ("line", c_size_t),
        ("column", c_size_t),
        ("object", c_char_p),
        ("object_index", c_size_t),
        ("field", c_char_p),
        ("count", c_size_t),
        ("text", c_char_p),
    ]


class sarsim_work(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("threads", c_uint),
        ("stop", c_void_p),
        ("progress", sarsim_progress),
        ("user", c_void_p),
    ]


class sarsim_scene_options(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("let", c_void_p),
        ("let_count", c_size_t),
        ("work", c_void_p),
    ]


class sarsim_plan_info(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("rows", c_uint64),
        ("columns", c_uint64),
        ("sample_rate_hz", c_double),
        ("bits", c_int),
        ("lsb_v", c_double),
        ("radar", c_char_p),
        ("processing", c_char_p),
        ("format", c_char_p),
        ("file", c_char_p),
        ("engine", c_char_p),
        ("engine_reason", c_char_p),
        ("echoes", c_double),
        ("seconds", c_double),
        ("memory_bytes", c_double),
        ("file_bytes", c_double),
    ]


class sarsim_file_options(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("format", c_char_p),
        ("replace", c_int),
        ("counts", c_int),
        ("header", c_int),
        ("doubles", c_int),
    ]


class sarsim_file_report(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("seconds", c_double),
        ("bytes", c_double),
        ("maximum_v", c_double),
        ("lsb_v", c_double),
        ("saturated", c_uint64),
        ("zero", c_uint64),
    ]


class sarsim_raster_info(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("rows", c_uint64),
        ("columns", c_uint64),
        ("value", c_int),
        ("counts", c_int),
        ("bits", c_int),
        ("lsb_v", c_double),
        ("sample_rate_hz", c_double),
        ("format", c_char_p),
        ("path", c_char_p),
        ("attributes", c_size_t),
        ("axes", c_size_t),
    ]


class sarsim_axis_info(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("name", c_char_p),
        ("unit", c_char_p),
        ("of_columns", c_int),
        ("count", c_uint64),
    ]


class sarsim_window(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("first_row", c_uint64),
        ("rows", c_uint64),
        ("first_column", c_uint64),
        ("columns", c_uint64),
        ("row_step", c_uint64),
        ("column_step", c_uint64),
    ]


# Name: what it returns, what it takes.
FUNCTIONS = {
    "sarsim_abi_version": (c_int, ()),
    "sarsim_version": (c_char_p, ()),
    "sarsim_status_word": (c_char_p, (c_int,)),
    "sarsim_text_free": (None, (c_void_p,)),
    "sarsim_text_chars": (c_char_p, (c_void_p,)),
    "sarsim_text_length": (c_size_t, (c_void_p,)),
    "sarsim_problems_free": (None, (c_void_p,)),
    "sarsim_problems_count": (c_size_t, (c_void_p,)),
    "sarsim_problems_get": (c_int, (c_void_p, c_size_t, c_void_p)),
    "sarsim_stop_new": (c_int, (c_void_p, c_void_p)),
    "sarsim_stop_free": (None, (c_void_p,)),
    "sarsim_stop_request": (None, (c_void_p,)),
    "sarsim_scene_read_file": (c_int, (c_char_p, c_void_p, c_void_p, c_void_p)),
    "sarsim_scene_read_text": (c_int, (c_char_p, c_size_t, c_char_p, c_void_p, c_void_p, c_void_p)),
    "sarsim_scene_copy": (c_int, (c_void_p, c_void_p, c_void_p)),
    "sarsim_scene_free": (None, (c_void_p,)),
    "sarsim_scene_text": (c_int, (c_void_p, c_int, c_void_p, c_void_p)),
    "sarsim_scene_check": (c_int, (c_void_p, c_void_p, c_void_p)),
    "sarsim_scene_count": (c_int, (c_void_p, c_char_p, c_void_p, c_void_p)),
    "sarsim_scene_name": (c_int, (c_void_p, c_char_p, c_size_t, c_void_p, c_void_p)),
    "sarsim_scene_get": (c_int, (c_void_p, c_char_p, c_void_p, c_void_p)),
    "sarsim_scene_set": (c_int, (c_void_p, c_char_p, c_char_p, c_void_p)),
    "sarsim_scene_new": (c_int, (c_char_p, c_void_p, c_void_p)),
    "sarsim_scene_get_number": (c_int, (c_void_p, c_char_p, c_void_p, c_void_p)),
    "sarsim_scene_set_number": (c_int, (c_void_p, c_char_p, c_double, c_void_p)),
    "sarsim_scene_set_points": (c_int, (c_void_p, c_char_p, c_size_t, c_size_t, c_void_p, c_void_p, c_char_p, c_void_p)),
    "sarsim_scene_add": (c_int, (c_void_p, c_char_p, c_char_p, c_void_p, c_void_p)),
    "sarsim_scene_remove": (c_int, (c_void_p, c_char_p, c_size_t, c_void_p)),
    "sarsim_scene_add_targets": (c_int, (c_void_p, c_char_p, c_size_t, c_void_p, c_void_p, c_void_p)),
    "sarsim_scene_add_cloud": (c_int, (c_void_p, c_char_p, c_char_p, c_size_t, c_void_p, c_void_p, c_void_p)),
    "sarsim_scene_fields": (c_int, (c_void_p, c_char_p, c_size_t, c_void_p, c_void_p)),
    "sarsim_schema": (c_int, (c_void_p, c_void_p)),
    "sarsim_explain": (c_int, (c_char_p, c_int, c_void_p, c_void_p)),
    "sarsim_plan_new": (c_int, (c_void_p, c_size_t, c_void_p, c_void_p, c_void_p)),
    "sarsim_plan_free": (None, (c_void_p,)),
    "sarsim_plan_get_info": (c_int, (c_void_p, c_void_p, c_void_p)),
    "sarsim_plan_axis": (c_int, (c_void_p, c_int, c_uint64, c_uint64, c_void_p, c_void_p)),
    "sarsim_record_float": (c_int, (c_void_p, c_uint64, c_uint64, c_void_p, c_void_p, c_void_p)),
    "sarsim_record_double": (c_int, (c_void_p, c_uint64, c_uint64, c_void_p, c_void_p, c_void_p)),
    "sarsim_record_file": (c_int, (c_void_p, c_char_p, c_void_p, c_void_p, c_void_p, c_void_p)),
    "sarsim_record_rows": (c_int, (c_void_p, c_uint64, c_uint64, c_uint64, sarsim_rows, c_void_p, c_void_p, c_void_p)),
    "sarsim_table_free": (None, (c_void_p,)),
    "sarsim_table_rows": (c_size_t, (c_void_p,)),
    "sarsim_table_columns": (c_size_t, (c_void_p,)),
    "sarsim_table_name": (c_char_p, (c_void_p, c_size_t)),
    "sarsim_table_is_number": (c_int, (c_void_p, c_size_t)),
    "sarsim_table_numbers": (c_int, (c_void_p, c_size_t, c_void_p, c_void_p)),
    "sarsim_table_text": (c_char_p, (c_void_p, c_size_t, c_size_t)),
    "sarsim_table_csv": (c_char_p, (c_void_p,)),
    "sarsim_raster_free": (None, (c_void_p,)),
    "sarsim_raster_open": (c_int, (c_char_p, c_void_p, c_size_t, c_void_p, c_void_p, c_void_p)),
    "sarsim_raster_of_floats": (c_int, (c_void_p, c_uint64, c_uint64, c_int, c_void_p, c_void_p)),
    "sarsim_raster_set_axis": (c_int, (c_void_p, c_char_p, c_void_p, c_uint64, c_void_p)),
    "sarsim_raster_set_attribute": (c_int, (c_void_p, c_char_p, c_char_p, c_void_p)),
    "sarsim_raster_get_info": (c_int, (c_void_p, c_void_p, c_void_p)),
    "sarsim_raster_attribute_name": (c_char_p, (c_void_p, c_size_t)),
    "sarsim_raster_attribute_value": (c_char_p, (c_void_p, c_size_t)),
    "sarsim_raster_attribute": (c_char_p, (c_void_p, c_char_p)),
    "sarsim_raster_axis_info": (c_int, (c_void_p, c_size_t, c_void_p, c_void_p)),
    "sarsim_raster_axis": (c_int, (c_void_p, c_size_t, c_uint64, c_uint64, c_void_p, c_void_p)),
    "sarsim_raster_read_float": (c_int, (c_void_p, c_void_p, c_void_p, c_void_p, c_void_p)),
    "sarsim_raster_read_double": (c_int, (c_void_p, c_void_p, c_void_p, c_void_p, c_void_p)),
    "sarsim_raster_write": (c_int, (c_void_p, c_char_p, c_void_p, c_size_t, c_void_p, c_void_p)),
    "sarsim_source_free": (None, (c_void_p,)),
    "sarsim_source_file": (c_int, (c_char_p, c_void_p, c_void_p)),
    "sarsim_source_scene": (c_int, (c_void_p, c_size_t, c_void_p, c_void_p)),
    "sarsim_source_floats": (c_int, (c_void_p, c_void_p, c_void_p, c_void_p)),
    "sarsim_source_doubles": (c_int, (c_void_p, c_void_p, c_void_p, c_void_p)),
    "sarsim_result_free": (None, (c_void_p,)),
    "sarsim_result_json": (c_char_p, (c_void_p,)),
    "sarsim_result_raster_count": (c_size_t, (c_void_p,)),
    "sarsim_result_raster": (c_int, (c_void_p, c_size_t, c_void_p, c_void_p)),
    "sarsim_result_table_count": (c_size_t, (c_void_p,)),
    "sarsim_result_table": (c_int, (c_void_p, c_size_t, c_void_p, c_void_p)),
    "sarsim_options": (c_int, (c_char_p, c_int, c_void_p, c_void_p)),
    "sarsim_focus": (c_int, (c_void_p, c_void_p, c_size_t, c_void_p, c_void_p, c_void_p)),
    "sarsim_profiles": (c_int, (c_void_p, c_void_p, c_size_t, c_void_p, c_void_p, c_void_p)),
    "sarsim_isar": (c_int, (c_void_p, c_void_p, c_size_t, c_void_p, c_void_p, c_void_p)),
    "sarsim_doppler": (c_int, (c_void_p, c_void_p, c_size_t, c_void_p, c_void_p, c_void_p)),
    "sarsim_search": (c_int, (c_void_p, c_void_p, c_size_t, c_void_p, c_void_p, c_void_p)),
    "sarsim_measure": (c_int, (c_void_p, c_void_p, c_size_t, c_void_p, c_void_p, c_void_p)),
    "sarsim_theory": (c_int, (c_void_p, c_void_p, c_size_t, c_void_p, c_void_p, c_void_p)),
    "sarsim_geometry": (c_int, (c_void_p, c_void_p, c_size_t, c_void_p, c_void_p, c_void_p)),
    "sarsim_export": (c_int, (c_void_p, c_void_p, c_size_t, c_void_p, c_void_p, c_void_p)),
    "sarsim_sweep": (c_int, (c_void_p, c_void_p, c_size_t, c_void_p, c_void_p, c_void_p)),
}
