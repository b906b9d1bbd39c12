package sunbeam.app.render;

import java.util.List;
import java.util.Map;
import jrtr.Tile;
import jrtr.VertexData.BoundingSphere;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.scene.RenderItem;
import jrtr.scene.RenderPass;
import jrtr.scene.View;
import jrtr.scene.View.Camera;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import sunbeam.app.scene.Viewpoint;

/**
 * Input of the geometry pass; equal inputs draw equal attributes.
 *
 * @param items shapes in world space
 * @param bounds sphere around the shapes
 */
record SkinGeometry(List<RenderItem> items, BoundingSphere bounds, Viewpoint view, int width, int height) {
    // Distance of near and far plane from the center of all shapes, in radii; above 1, so that rounding clips nothing.
    private static final float MARGIN = 1.02f;
    // Near plane to far plane, for an eye inside the mesh's sphere; suits a 32-bit depth buffer.
    private static final float NEAREST = 1e-3f;
    // Distance of both planes from the mesh's center relative to the eye's, so that float32 separates them.
    private static final float THINNEST = 1e-4f;

    static View view(Viewpoint view, BoundingSphere bounds) {
        Camera camera = view.camera();
        Vector3f sight = camera.lookAtPoint().sub(camera.centerOfProjection(), new Vector3f());
        // From the eye to the mesh's center, along the line of sight.
        float distance =
                bounds.center().sub(camera.centerOfProjection(), new Vector3f()).dot(sight.normalize());
        float reach = Math.max(MARGIN * bounds.radius(), THINNEST * Math.abs(distance));
        // A mesh behind the eye is invisible with any planes.
        float far = Math.max(distance, 0) + reach;
        float near = Math.max(distance - reach, NEAREST * far);
        return new View(camera, (float) view.verticalFieldOfView(), (float) Viewpoint.LEAST_ASPECT, near, far);
    }

    private View sight() {
        return view(view, bounds);
    }

    void applyRaysTo(ShaderProgram program, Tile block) {
        sight().applyRaysTo(program, new View.Area(width, height, block));
    }

    /** From (x, y, depth) to world space: x and y in pixels from the block's lower left, depth as in the depth buffer. */
    Matrix4f blockToWorld(Tile block) {
        Matrix4f toClip = sight().worldToClip(new View.Area(width, height, block));
        return toClip.invert().translate(-1, -1, -1).scale(2f / block.width(), 2f / block.height(), 2);
    }

    void draw(RenderContext context, ShaderProgram program, FloatTarget target, Tile block) {
        // Then the near plane, and so the eye, is in front of all shapes in any orientation.
        boolean seesFromOutside = sight().near() > NEAREST * sight().far();
        new RenderPass(context, program, Map.of(), seesFromOutside)
                .draw(
                        items,
                        sight(),
                        new View.Area(width, height, block),
                        target,
                        Tile.whole(block.width(), block.height()));
    }
}
