package jrtr.scene;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.Iterator;
import java.util.List;
import jrtr.BoundingSphere;
import org.joml.FrustumIntersection;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;
import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * What of a scene has to be drawn, nearest first: what is drawn first hides most of the rest.
 *
 * @param items whose bounding spheres reach into the frustum
 */
public record RenderQueue(List<RenderItem> items) {
    // Planes from float matrices are off by a few units of the sixth digit; spheres are widened by more than that.
    private static final float WIDER = 1.001f;

    /** Copies the list. */
    public RenderQueue {
        items = List.copyOf(items);
    }

    private record Candidate(RenderItem item, float nearestDepth) {}

    /** Sorts a scene's shapes for an area of the picture. */
    public static RenderQueue of(SceneManagerInterface scene, PictureArea area) {
        Matrix4fc worldToCamera = scene.camera().worldToCamera();
        Matrix4f worldToClip = scene.frustum().cameraToClip(area).mul(worldToCamera);
        FrustumIntersection planes = new FrustumIntersection(worldToClip);
        List<Candidate> visible = new ArrayList<>();
        for (Iterator<RenderItem> shapes = scene.shapes(); shapes.hasNext(); ) {
            RenderItem item = shapes.next();
            BoundingSphere bounds = item.bounds();
            if (planes.testSphere(bounds.center(), WIDER * bounds.radius())) {
                visible.add(new Candidate(item, nearestDepth(worldToCamera, bounds)));
            }
        }
        visible.sort(Comparator.comparingDouble(Candidate::nearestDepth));
        return new RenderQueue(visible.stream().map(Candidate::item).toList());
    }

    private static float nearestDepth(Matrix4fc worldToCamera, BoundingSphere bounds) {
        Vector3fc center = worldToCamera.transformPosition(bounds.center(), new Vector3f());
        return -center.z() - bounds.radius();
    }
}
