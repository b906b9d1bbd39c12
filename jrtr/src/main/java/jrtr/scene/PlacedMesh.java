package jrtr.scene;

import java.util.Map;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import jrtr.gl.VertexBuffer;
import org.joml.Matrix3f;
import org.joml.Matrix4fc;

/** Mesh with its material, placed in world space by an affine, invertible matrix M: {@code M * v}. Owns none of its resources. */
public record PlacedMesh(
        VertexBuffer mesh,
        Matrix4fc modelToWorld,
        ShaderProgram program,
        Map<String, Texture> textures,
        RenderContext.Faces faces) {
    /** Sets the uniforms of jrtr/tangent_frame.glsl: rotation in radians about the normal, counter-clockwise seen from outside. */
    public static void turnTangents(ShaderProgram program, double radians) {
        program.set("tangentCosine", (float) Math.cos(radians));
        program.set("tangentSine", (float) Math.sin(radians));
    }

    /**
     * Clears the tile to zeros and draws the mesh there; no pixel outside is touched. Tiles that cover the target give the same picture as
     * one draw, bit for bit. Sets the uniforms of mesh.vert.glsl and surface.glsl's eye; the caller sets all others.
     *
     * @param area part of the picture that the target, which has depth, shows; it has the target's size in pixels
     */
    public void draw(RenderContext context, View view, View.Area area, FloatTarget target, Tile tile) {
        target.clear(tile, 0, 0, 0, 0);
        program.set("modelToWorld", modelToWorld);
        // The inverse transpose keeps normals orthogonal to the surface under any scaling.
        program.set("normalToWorld", modelToWorld.normal(new Matrix3f()));
        program.set("mirror", modelToWorld.determinant3x3() < 0 ? -1f : 1f);
        program.set("worldToClip", view.worldToClip(area));
        program.set("eyePosition", view.camera().centerOfProjection());
        context.draw(program, textures, mesh, faces, target, tile);
    }
}
