package jrtr.scene;

import jrtr.FloatTarget;
import jrtr.RenderContext;
import jrtr.ShaderProgram;
import jrtr.Tile;
import org.joml.Matrix4f;

/** Draws scenes. */
public final class SceneRenderer {
    private final RenderContext context;

    /** Draws with a context, of which it keeps nothing. */
    public SceneRenderer(RenderContext context) {
        this.context = context;
    }

    /**
     * Clears the tile to zeros and draws the scene there; no pixel outside is touched. Tiles that cover the target give
     * the same picture as one draw, bit for bit. Pixels that no shape covers stay zero, so a shader that writes alpha 1
     * makes the covered ones known.
     *
     * @param area what the target shows; its part is as large as the target
     * @param target with depth
     * @param tile inside the target
     * @throws IllegalArgumentException if the scene has more than {@link LightUniforms#MOST} lights, or target, area and
     *     tile do not fit together
     */
    public void draw(SceneManagerInterface scene, PictureArea area, FloatTarget target, Tile tile) {
        if (area.part().width() != target.spec().width()
                || area.part().height() != target.spec().height()) {
            throw new IllegalArgumentException("target '" + target.label() + "' of "
                    + target.spec().width() + " x " + target.spec().height() + " cannot show " + area.part());
        }
        LightUniforms lights = LightUniforms.of(scene.lights());
        target.clear(tile, 0, 0, 0, 0);
        RenderQueue queue = RenderQueue.of(scene, area.within(tile));
        Matrix4f worldToClip =
                scene.frustum().cameraToClip(area).mul(scene.camera().worldToCamera());
        for (RenderItem item : queue.items()) {
            draw(item, scene.camera(), lights, worldToClip, target, tile);
        }
    }

    private void draw(
            RenderItem item, Camera camera, LightUniforms lights, Matrix4f worldToClip, FloatTarget target, Tile tile) {
        Material material = item.shape().material();
        ShaderProgram program = material.program();
        PlaceUniforms.set(program, item.modelToWorld(), worldToClip);
        if (program.isActive("eyePosition")) {
            program.set("eyePosition", camera.centerOfProjection());
        }
        lights.applyTo(program);
        material.uniforms().forEach((name, value) -> program.set(name, value.floatValue()));
        context.draw(program, material.textures(), item.shape().vertices(), material.faces(), target, tile);
    }
}
