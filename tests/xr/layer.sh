# Debian's validation layer of OpenXR, where it is installed: what it has to say of calls is in $work/messages. Sourced by the
# tests of a headset.
layer=/usr/share/openxr/1/api_layers/explicit.d/XrApiLayer_core_validation.*.json
# shellcheck disable=SC2086
if ls $layer >/dev/null 2>&1; then
  export XR_ENABLE_API_LAYERS=XR_APILAYER_LUNARG_core_validation XR_CORE_VALIDATION_EXPORT_TYPE=text \
    XR_CORE_VALIDATION_FILE_NAME=$work/messages
else
  echo "openxr-layer-corevalidation is not installed: calls are judged by the tests' runtime alone"
fi
