#version 330 core
// Depth comes from the rasteriser; nothing is left to do.
void main() {
}
