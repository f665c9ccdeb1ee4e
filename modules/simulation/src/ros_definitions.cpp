#include "ros_messages.hpp"

// Definitions without comments; the check sums are those of ROS, which ignore comments.

namespace hybridfusion {

#define HF_ROS_RULE \
  "================================================================================\n"
#define HF_ROS_HEADER HF_ROS_RULE "MSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n"

const RosMessageType kImuMessage = {
    .name = "sensor_msgs/Imu",
    .md5 = "6a62c6daae103f4ff57a132d6f95cec2",
    .definition =
        "Header header\n"
        "geometry_msgs/Quaternion orientation\n"
        "float64[9] orientation_covariance\n"
        "geometry_msgs/Vector3 angular_velocity\n"
        "float64[9] angular_velocity_covariance\n"
        "geometry_msgs/Vector3 linear_acceleration\n"
        "float64[9] linear_acceleration_covariance\n" HF_ROS_HEADER HF_ROS_RULE
        "MSG: geometry_msgs/Quaternion\n"
        "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n" HF_ROS_RULE
        "MSG: geometry_msgs/Vector3\n"
        "float64 x\nfloat64 y\nfloat64 z\n"};

const RosMessageType kNavSatFixMessage = {
    .name = "sensor_msgs/NavSatFix",
    .md5 = "2d3a8cd499b9b4a0249fb98fd05cfa48",
    .definition =
        "Header header\n"
        "NavSatStatus status\n"
        "float64 latitude\nfloat64 longitude\nfloat64 altitude\n"
        "float64[9] position_covariance\n"
        "uint8 COVARIANCE_TYPE_UNKNOWN = 0\n"
        "uint8 COVARIANCE_TYPE_APPROXIMATED = 1\n"
        "uint8 COVARIANCE_TYPE_DIAGONAL_KNOWN = 2\n"
        "uint8 COVARIANCE_TYPE_KNOWN = 3\n"
        "uint8 position_covariance_type\n" HF_ROS_HEADER HF_ROS_RULE
        "MSG: sensor_msgs/NavSatStatus\n"
        "int8 STATUS_NO_FIX = -1\n"
        "int8 STATUS_FIX = 0\n"
        "int8 STATUS_SBAS_FIX = 1\n"
        "int8 STATUS_GBAS_FIX = 2\n"
        "int8 status\n"
        "uint16 SERVICE_GPS = 1\n"
        "uint16 SERVICE_GLONASS = 2\n"
        "uint16 SERVICE_COMPASS = 4\n"
        "uint16 SERVICE_GALILEO = 8\n"
        "uint16 service\n"};

const RosMessageType kPointCloud2Message = {
    .name = "sensor_msgs/PointCloud2",
    .md5 = "1158d486dd51d683ce2f1be655c3c181",
    .definition =
        "Header header\n"
        "uint32 height\nuint32 width\n"
        "PointField[] fields\n"
        "bool is_bigendian\n"
        "uint32 point_step\nuint32 row_step\n"
        "uint8[] data\n"
        "bool is_dense\n" HF_ROS_HEADER HF_ROS_RULE
        "MSG: sensor_msgs/PointField\n"
        "uint8 INT8 = 1\nuint8 UINT8 = 2\nuint8 INT16 = 3\nuint8 UINT16 = 4\n"
        "uint8 INT32 = 5\nuint8 UINT32 = 6\nuint8 FLOAT32 = 7\nuint8 FLOAT64 = 8\n"
        "string name\nuint32 offset\nuint8 datatype\nuint32 count\n"};

const RosMessageType kLivoxMessage = {
    .name = "livox_ros_driver/CustomMsg",
    .md5 = "e4d6829bdfe657cb6c21a746c86b21a6",
    .definition =
        "Header header\n"
        "uint64 timebase\nuint32 point_num\nuint8 lidar_id\nuint8[3] rsvd\n"
        "CustomPoint[] points\n" HF_ROS_HEADER HF_ROS_RULE
        "MSG: livox_ros_driver/CustomPoint\n"
        "uint32 offset_time\n"
        "float32 x\nfloat32 y\nfloat32 z\n"
        "uint8 reflectivity\nuint8 tag\nuint8 line\n"};

const RosMessageType kCompressedImageMessage = {
    .name = "sensor_msgs/CompressedImage",
    .md5 = "8f7a12909da2c9d3332d540a0977563f",
    .definition = "Header header\nstring format\nuint8[] data\n" HF_ROS_HEADER};

#undef HF_ROS_HEADER
#undef HF_ROS_RULE

}  // namespace hybridfusion
