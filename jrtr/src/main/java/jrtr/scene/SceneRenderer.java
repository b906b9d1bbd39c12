package jrtr.scene;

import java.util.Comparator;
import java.util.List;
import jrtr.BoundingSphere;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import org.joml.FrustumIntersection;
import org.joml.Matrix3f;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;
import org.joml.Vector3f;

/** Renderer of scene graphs, with frustum culling. */
public final class SceneRenderer {
    /** Factor on bounding radii, because the frustum's planes from float matrices err by a few 1e-6. */
    private static final float CULLING_RADIUS_FACTOR = 1.001f;

    private final RenderContext context;

    public SceneRenderer(RenderContext context) {
        this.context = context;
    }

    /**
     * Clears the tile to zeros and draws the scene there; no pixel outside is touched. Tiles that cover the target give the same picture as
     * one draw, bit for bit. Pixels without a shape stay zero, so a shader that writes alpha 1 marks the covered pixels.
     *
     * @param area part of the picture that the target shows; it has the target's size in pixels
     * @param target target with depth
     * @param tile tile inside the target
     * @throws IllegalArgumentException if the scene has more than {@link LightUniforms#MOST} lights, or target, area and tile do not fit
     *     together
     */
    public void draw(SceneGraph scene, PictureArea area, FloatTarget target, Tile tile) {
        if (area.part().width() != target.spec().width()
                || area.part().height() != target.spec().height()) {
            throw new IllegalArgumentException("target '" + target.label() + "' of "
                    + target.spec().width() + " x " + target.spec().height() + " cannot show " + area.part());
        }
        LightUniforms lights = LightUniforms.of(scene.lights());
        target.clear(tile, 0, 0, 0, 0);
        Matrix4f worldToClip =
                scene.frustum().cameraToClip(area).mul(scene.camera().worldToCamera());
        for (SceneGraph.ShapeInstance item : visible(scene, area.within(tile))) {
            draw(item, scene.camera(), lights, worldToClip, target, tile);
        }
    }

    /** Returns the shapes that intersect the frustum, nearest first, so that the depth test rejects most of the hidden fragments. */
    private static List<SceneGraph.ShapeInstance> visible(SceneGraph scene, PictureArea area) {
        Matrix4f worldToCamera = scene.camera().worldToCamera();
        FrustumIntersection planes =
                new FrustumIntersection(scene.frustum().cameraToClip(area).mul(worldToCamera));
        return scene.shapes().stream()
                .filter(item -> planes.testSphere(
                        item.bounds().center(),
                        CULLING_RADIUS_FACTOR * item.bounds().radius()))
                .sorted(Comparator.comparingDouble(item -> nearestDepth(worldToCamera, item.bounds())))
                .toList();
    }

    private static float nearestDepth(Matrix4f worldToCamera, BoundingSphere bounds) {
        Vector3f center = worldToCamera.transformPosition(bounds.center(), new Vector3f());
        return -center.z() - bounds.radius();
    }

    private void draw(
            SceneGraph.ShapeInstance item,
            Camera camera,
            LightUniforms lights,
            Matrix4f worldToClip,
            FloatTarget target,
            Tile tile) {
        Material material = item.shape().material();
        ShaderProgram program = material.program();
        Matrix4fc modelToWorld = item.modelToWorld();
        program.set("modelToWorld", modelToWorld);
        // The inverse transpose keeps normals orthogonal to the surface under any scaling.
        program.set("normalToWorld", modelToWorld.normal(new Matrix3f()));
        program.set("mirror", modelToWorld.determinant3x3() < 0 ? -1f : 1f);
        program.set("worldToClip", worldToClip);
        if (program.isActive("eyePosition")) {
            program.set("eyePosition", camera.centerOfProjection());
        }
        lights.applyTo(program);
        material.uniforms().forEach((name, value) -> program.set(name, value.floatValue()));
        context.draw(program, material.textures(), item.shape().vertices(), material.faces(), target, tile);
    }
}
