package sunbeam.app.render;

import java.util.List;
import java.util.Map;
import java.util.Optional;
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
 */
record SkinGeometry(List<RenderItem> items, Viewpoint view, int width, int height) {
    // Distance of near and far plane from a shape's center, in radii; above 1, so that rounding clips nothing.
    private static final float MARGIN = 1.02f;
    // Near plane to far plane, for an eye inside a shape's sphere; suits a 32-bit depth buffer.
    private static final float NEAREST = 1e-3f;
    // The same at least, for shapes far apart; less would round the farthest depths to that of no shape.
    private static final float NEAREST_OF_ALL = 1e-6f;
    // Distance of both planes from a shape's center relative to the eye's, so that float32 separates them.
    private static final float THINNEST = 1e-4f;

    /** Distances from the eye, along the line of sight, between which a shape may be visible; none for one behind the eye. */
    private record Depths(float near, float far, boolean isEyeOutside) {
        static Optional<Depths> of(BoundingSphere bounds, Camera camera) {
            Vector3f sight = camera.lookAtPoint().sub(camera.centerOfProjection(), new Vector3f());
            float distance = bounds.center()
                    .sub(camera.centerOfProjection(), new Vector3f())
                    .dot(sight.normalize());
            float reach = Math.max(MARGIN * bounds.radius(), THINNEST * Math.abs(distance));
            float far = Math.max(distance, 0) + reach;
            boolean isOutside = distance - reach > NEAREST * far;
            return distance + reach > 0
                    ? Optional.of(new Depths(isOutside ? distance - reach : NEAREST * far, far, isOutside))
                    : Optional.empty();
        }

        /** Contains both. The far plane is moved away from shapes much farther than others, whose depths would be rounded to its own. */
        Depths with(Depths other) {
            float least = Math.min(near, other.near);
            float most = Math.max(far, other.far);
            return new Depths(Math.max(least, NEAREST_OF_ALL * most), most, isEyeOutside && other.isEyeOutside);
        }
    }

    private Depths depths() {
        return items.stream()
                .flatMap(item -> Depths.of(item.bounds(), view.camera()).stream())
                .reduce(Depths::with)
                .orElse(new Depths(1, 2, true));
    }

    View sight() {
        Depths depths = depths();
        float far = depths.near < NEAREST * depths.far ? 2 * depths.far : depths.far;
        float angle = (float) view.verticalFieldOfView();
        return new View(view.camera(), angle, (float) Viewpoint.LEAST_ASPECT, depths.near, far);
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
        new RenderPass(context, program, Map.of(), depths().isEyeOutside)
                .draw(
                        items,
                        sight(),
                        new View.Area(width, height, block),
                        target,
                        Tile.whole(block.width(), block.height()));
    }
}
