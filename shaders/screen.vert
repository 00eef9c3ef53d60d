// One triangle that covers the picture, infinitely far away.
#version 460

layout(location = 0) out vec2 uv;  // 0,0 at the top left

void main() {
  uv = vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1) * 2.0;
  gl_Position = vec4(uv.x * 2.0 - 1.0, 1.0 - uv.y * 2.0, 0.0, 1.0);
}
