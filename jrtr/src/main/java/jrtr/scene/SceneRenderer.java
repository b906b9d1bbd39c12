package jrtr.scene;

import java.util.List;
import jrtr.DepthUse;
import jrtr.FloatTarget;
import jrtr.RenderContext;
import jrtr.ShaderProgram;
import jrtr.Tile;
import jrtr.glsl.EngineShaders;
import org.joml.Matrix4f;

/**
 * Draws scenes, costly materials in two passes: first depth alone and then colours where depth is final, so that their
 * fragment shaders run once per pixel.
 *
 * <p>Owns its depth shader only.
 */
public final class SceneRenderer implements AutoCloseable {
    private final RenderContext context;
    private final ShaderProgram depthProgram;

    /** Compiles the depth shader. */
    public SceneRenderer(RenderContext context) {
        this.context = context;
        this.depthProgram = context.createMeshProgram(EngineShaders.library().load("jrtr/depth.frag.glsl"));
    }

    /** As {@link #draw(SceneManagerInterface, PictureArea, FloatTarget, Tile)} with the target showing all. */
    public RenderQueue draw(SceneManagerInterface scene, FloatTarget target, Tile tile) {
        PictureArea whole =
                PictureArea.whole(target.spec().width(), target.spec().height());
        return draw(scene, whole, target, tile);
    }

    /**
     * Clears the tile to zeros and draws the scene there; no pixel outside is touched. Tiles that cover the target give
     * the same picture as one draw, bit for bit. Pixels that no shape covers stay zero, so a shader that writes alpha 1
     * makes the covered ones known.
     *
     * @param area what the target shows; its part is as large as the target
     * @param target with depth
     * @param tile inside the target
     * @return what was drawn
     * @throws IllegalArgumentException if the scene has more than {@link LightUniforms#MOST} lights, or target, area and
     *     tile do not fit together
     */
    public RenderQueue draw(SceneManagerInterface scene, PictureArea area, FloatTarget target, Tile tile) {
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
            if (item.shape().material().isCostly()) {
                PlaceUniforms.set(depthProgram, item.modelToWorld(), worldToClip);
                context.draw(depthProgram, List.of(), item.shape().vertices(), DepthUse.DEPTH_ONLY, target, tile);
            } else {
                drawColors(item, scene.camera(), lights, worldToClip, DepthUse.NEARER, target, tile);
            }
        }
        for (RenderItem item : queue.items()) {
            if (item.shape().material().isCostly()) {
                drawColors(item, scene.camera(), lights, worldToClip, DepthUse.EQUAL, target, tile);
            }
        }
        return queue;
    }

    private void drawColors(
            RenderItem item,
            Camera camera,
            LightUniforms lights,
            Matrix4f worldToClip,
            DepthUse depth,
            FloatTarget target,
            Tile tile) {
        Material material = item.shape().material();
        ShaderProgram program = material.program();
        PlaceUniforms.set(program, item.modelToWorld(), worldToClip);
        if (program.isActive("eyePosition")) {
            program.set("eyePosition", camera.centerOfProjection());
        }
        lights.applyTo(program);
        material.uniforms().applyTo(program);
        context.draw(program, material.textures(), item.shape().vertices(), depth, target, tile);
    }

    @Override
    public void close() {
        depthProgram.close();
    }
}
