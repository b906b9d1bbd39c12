// Lights of a picture and the groups whose lights share a shadow map (app.render.LightTexture), one per column.

// Rows of lights: LIGHT_TOWARDS: unit vector towards the light, world space, and the variance of its directions along the shorter axis across
// it; LIGHT_COLOR: radiance, linear Rec. 709; LIGHT_STRETCH: vector along the longer axis, the root of what its variance has more. Rows of groups: GROUP_LIGHTS: first light, the light after the last, 1 with a shadow map or 0, and
// the lift of that map; GROUP_TILE: corner and side of the group's tile in the image of all maps, and the penumbra; from GROUP_MATRIX on the
// columns of the matrix from world space to the map's clip space.
uniform sampler2D lightList;
uniform int lightGroups;

// Most groups of a picture.
const int MOST_GROUPS = 17;

const int LIGHT_TOWARDS = 0;
const int LIGHT_COLOR = 1;
const int LIGHT_STRETCH = 2;
const int GROUP_LIGHTS = 3;
const int GROUP_TILE = 4;
const int GROUP_MATRIX = 5;

vec4 lightTexel(int column, int row) {
    return texelFetch(lightList, ivec2(column, row), 0);
}
