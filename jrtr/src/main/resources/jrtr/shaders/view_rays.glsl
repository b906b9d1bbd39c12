// Towards the viewer from what a pixel shows, by its place in the target alone; the engine sets them (jrtr.scene.ViewRays).

// World space: that of the target's lower left corner, and by how much a pixel to the right and one upwards differ; not of unit length.
uniform vec3 viewAtCorner;
uniform vec3 viewPerColumn;
uniform vec3 viewPerRow;

// Unit vector, world space.
vec3 viewAt(vec2 place) {
    return normalize(viewAtCorner + place.x * viewPerColumn + place.y * viewPerRow);
}
