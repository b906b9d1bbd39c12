package jrtr.scene;

import java.util.Iterator;

/** What a renderer needs to know of a scene. */
public interface SceneManagerInterface {

    /** The shapes in their order, each at its place in the world. */
    Iterator<RenderItem> shapes();

    /** The lights in their order, with directions in the world. */
    Iterator<Light> lights();

    /** Where the scene is seen from. */
    Camera camera();

    /** How much of it is seen. */
    Frustum frustum();
}
