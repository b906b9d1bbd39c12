package jrtr.scene;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;
import jrtr.gl.RenderContext.Faces;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import org.joml.Matrix3f;
import org.joml.Matrix4fc;

/**
 * Draws shapes with one program.
 *
 * @param textures the pass's own, by sampler; each shape's material has further ones
 * @param fromOutside whether the eye is outside all closed shapes, so that their fronts are enough
 */
public record RenderPass(
        RenderContext context, ShaderProgram program, Map<String, Texture> textures, boolean fromOutside) {
    /**
     * Clears the tile to zeros and draws the shapes there; no pixel outside is touched. Tiles that cover the target give the same picture
     * as one draw, bit for bit. Sets the uniforms of mesh.vert.glsl, surface.glsl's eye and those of the materials; the caller sets all
     * others.
     *
     * @param area part of the picture that the target, which has depth, shows; it has the target's size in pixels
     */
    public void draw(List<RenderItem> items, View view, View.Area area, FloatTarget target, Tile tile) {
        target.clear(tile, 0, 0, 0, 0);
        program.set("worldToClip", view.worldToClip(area));
        program.set("eyePosition", view.camera().centerOfProjection());
        items.forEach(item -> draw(item, target, tile));
    }

    private void draw(RenderItem item, FloatTarget target, Tile tile) {
        Matrix4fc modelToWorld = item.modelToWorld();
        boolean isMirrored = modelToWorld.determinant3x3() < 0;
        program.set("modelToWorld", modelToWorld);
        // The inverse transpose keeps normals orthogonal to the surface under any scaling.
        program.set("normalToWorld", modelToWorld.normal(new Matrix3f()));
        program.set("mirror", isMirrored ? -1f : 1f);
        Material material = item.shape().material();
        material.values().forEach((uniform, value) -> {
            if (program.isActive(uniform)) {
                program.set(uniform, value);
            }
        });
        Map<String, Texture> used = new HashMap<>(material.textures());
        used.putAll(textures);
        used.keySet().removeIf(sampler -> !program.isActive(sampler));
        // A mirror exchanges clockwise and counter-clockwise.
        Faces faces = item.shape().closed() && fromOutside && !isMirrored ? Faces.FRONT : Faces.BOTH;
        context.draw(program, used, item.shape().mesh(), faces, target, tile);
    }
}
