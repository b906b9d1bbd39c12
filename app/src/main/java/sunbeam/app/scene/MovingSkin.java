package sunbeam.app.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import jrtr.ContextInfo;
import jrtr.FloatTargetSpec;
import jrtr.Tile;
import jrtr.gl.Binding;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.scene.ViewRays;
import org.joml.Vector2f;
import sunbeam.app.gpu.KeptTarget;
import sunbeam.app.gpu.UploadedTables;

/**
 * Draws a skin that moves, by those levels of its colors that exist (shaders/moving.frag): a few looks a pixel, and nothing comes
 * back from the graphics card but the colors of the screen.
 */
final class MovingSkin implements AutoCloseable {
    // Along the major axis of what a pixel sees; a still picture has up to 32. Software renderers have no time for a
    // second one, nor for
    // the loop: what a pixel sees is then as wide as long.
    private static final int SOFTWARE_PLACES = 1;
    private static final int HARDWARE_PLACES = 4;

    private final RenderContext context;
    private final int lights;
    private final ShaderProgram program;
    private final SkinFootprints footprints;
    private final KeptTarget targets;

    MovingSkin(RenderContext context, UploadedTables method, SkinFootprints footprints, int lights) {
        this.context = context;
        this.lights = lights;
        int places = mostPlaces(context.info());
        this.program = method.program(
                "moving.frag", Map.of("PLACES", Integer.toString(places), "LIGHTS", Integer.toString(lights)));
        this.footprints = footprints;
        this.targets = new KeptTarget(context, "moving", FloatTargetSpec.Format.RGBA8, true);
        try {
            footprints.setLevels(program);
            program.set("mostPlaces", (float) places);
            program.set("samplesAcross", 1f);
        } catch (RuntimeException failure) {
            close();
            throw failure;
        }
    }

    /** In so many places along the major axis of what it sees a pixel looks at most. */
    private static int mostPlaces(ContextInfo info) {
        return info.software() ? SOFTWARE_PLACES : HARDWARE_PLACES;
    }

    int lights() {
        return lights;
    }

    /** The program, for what its uniforms share with others. */
    ShaderProgram program() {
        return program;
    }

    /**
     * Draws a block of a picture.
     *
     * @param ground below it
     * @param geometry what is drawn
     * @param buffer of {@link GeometryLayout#MOVING}
     * @param block in the picture
     * @param method textures of the method's tables
     * @return 0xffRRGGBB, top row first
     */
    int[] draw(
            Scene scene,
            Optional<Ground> ground,
            SkinGeometry geometry,
            GeometryBuffer buffer,
            Tile block,
            List<Binding> method,
            double exposure) {
        ViewRays rays = geometry.viewRays(block);
        rays.applyTo(program);
        program.set("targetToWorld", geometry.blockToWorld(block));
        geometry.shadows().applyTo(program, scene.around().shadows());
        program.set("exposure", (float) exposure);
        program.set("toneStart", (float) scene.display(exposure).tone().start());
        List<Binding> textures = new ArrayList<>(method);
        textures.addAll(buffer.bindings());
        textures.add(new Binding("depths", buffer.attributes().depth()));
        textures.add(geometry.shadows().binding());
        textures.addAll(footprints.tiles().bindings());
        Tile whole = Tile.whole(block.width(), block.height());
        program.set("perPicture", new Vector2f(1f / block.width(), 1f / block.height()));
        FloatTarget target = targets.of(block.width(), block.height());
        if (ground.isPresent()) {
            ground.get().move(target, scene, geometry, rays, exposure);
        } else {
            int rgb = scene.get(SceneSettings.BACKGROUND).rgb();
            target.clear(whole, (rgb >> 16) / 255f, (rgb >> 8 & 0xff) / 255f, (rgb & 0xff) / 255f, 1);
        }
        target.fillDepth(buffer.attributes());
        context.drawCovered(program, textures, target, whole);
        return target.readColors(0, whole);
    }

    @Override
    public void close() {
        targets.close();
        program.close();
    }
}
