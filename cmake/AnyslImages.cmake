# anysl_images: OpenImageIO. Debian's CMake package for it asks for headers of OpenCV that nobody here
# needs, so the library is looked up by hand.
if(NOT TARGET anysl_images)
  find_path(OPENIMAGEIO_INCLUDE_DIR OpenImageIO/imageio.h REQUIRED)
  find_library(OPENIMAGEIO_LIBRARY OpenImageIO REQUIRED)
  find_library(OPENIMAGEIO_UTIL_LIBRARY OpenImageIO_Util REQUIRED)
  add_library(anysl_images INTERFACE)
  target_include_directories(anysl_images SYSTEM INTERFACE ${OPENIMAGEIO_INCLUDE_DIR})
  target_link_libraries(anysl_images INTERFACE ${OPENIMAGEIO_LIBRARY} ${OPENIMAGEIO_UTIL_LIBRARY})
endif()
