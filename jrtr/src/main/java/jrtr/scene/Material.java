package jrtr.scene;

import java.util.HashMap;
import java.util.Map;
import jrtr.gl.Texture;

/**
 * Look of a {@link Shape}: textures by the name of their sampler, and values of uniforms of type {@code float}. A pass uses those that its
 * program has. Owns no texture.
 */
public record Material(Map<String, Texture> textures, Map<String, Float> values) {
    public Material {
        textures = Map.copyOf(textures);
        values = Map.copyOf(values);
    }

    public Material with(String uniform, double value) {
        Map<String, Float> all = new HashMap<>(values);
        all.put(uniform, (float) value);
        return new Material(textures, all);
    }

    /** Sets the uniforms of jrtr/tangent_frame.glsl: rotation in radians about the normal, counter-clockwise seen from outside. */
    public Material turned(double radians) {
        return with("tangentCosine", Math.cos(radians)).with("tangentSine", Math.sin(radians));
    }
}
