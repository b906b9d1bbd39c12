package jrtr.scene;

import java.util.List;
import java.util.Optional;
import jrtr.VertexData.BoundingSphere;
import jrtr.scene.View.Camera;

/** Scene for a renderer; all it contains is in world space. */
public interface SceneManagerInterface {
    /** Returns the shapes in the order in which they are drawn. */
    List<RenderItem> items();

    List<Light> lights();

    Optional<Camera> camera();

    /** Returns a sphere that contains all shapes; empty without shapes. */
    Optional<BoundingSphere> bounds();
}
