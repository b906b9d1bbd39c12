// Direction towards the viewer as a linear function of the position in the target; jrtr.scene.View sets the uniforms.

// In world space, not of unit length: the direction at the target's lower left corner, and its change per pixel to the right and upwards.
uniform vec3 viewAtCorner;
uniform vec3 viewPerColumn;
uniform vec3 viewPerRow;

// Returns the direction towards the viewer, a unit vector in world space, at a position in pixels from the lower left corner.
vec3 viewAt(vec2 position) {
    return normalize(viewAtCorner + position.x * viewPerColumn + position.y * viewPerRow);
}
