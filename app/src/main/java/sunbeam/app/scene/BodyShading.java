package sunbeam.app.scene;

import java.util.List;
import jrtr.FloatTarget;
import jrtr.FloatTargetSpec;
import jrtr.RenderContext;
import jrtr.ShaderProgram;
import jrtr.Tile;
import jrtr.scene.LightUniforms;
import sunbeam.app.gpu.Shaders;

/** Lights the body without diffraction (shaders/body.frag). Keeps a target of the last block's size. */
final class BodyShading implements AutoCloseable {
    private final RenderContext context;
    private final ShaderProgram program;
    private FloatTarget target;

    BodyShading(RenderContext context) {
        this.context = context;
        this.program = context.createFullScreenProgram(Shaders.library().load("body.frag"));
    }

    /**
     * Lights a part of a block.
     *
     * @param buffer the block, with that part drawn
     * @param part counted from the block's corner
     * @return linear XYZ and coverage, 4 values a pixel, the part's top row first; zeros where there is no skin
     */
    float[] shade(Scene scene, GeometryBuffer buffer, Tile part) {
        fit(FloatTargetSpec.color(
                buffer.attributes().spec().width(), buffer.attributes().spec().height()));
        LightUniforms.of(List.of(SceneGraphs.light(scene)).iterator()).applyTo(program);
        program.set("textureWeight", (float) scene.blend().texture());
        program.set("diffuseWeight", (float) scene.blend().diffuse());
        program.set("ambientWeight", (float) scene.blend().ambient());
        target.clear(part, 0, 0, 0, 0);
        context.drawFullScreen(program, buffer.bindings(), target, part);
        return target.read(0, part);
    }

    private void fit(FloatTargetSpec spec) {
        if (target != null && target.spec().equals(spec)) {
            return;
        }
        release();
        target = context.createFloatTarget("body", spec);
    }

    private void release() {
        if (target != null) {
            target.close();
            target = null;
        }
    }

    @Override
    public void close() {
        release();
        program.close();
    }
}
