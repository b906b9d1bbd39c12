package sunbeam.app.scene;

import jrtr.FloatTargetSpec;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.scene.SceneRenderer;
import sunbeam.app.gpu.KeptTarget;
import sunbeam.app.gpu.Shaders;

/** Draws the body without diffraction (shaders/body.frag), with a geometry of its own size. */
final class BodyShading implements AutoCloseable {
    private final RenderContext context;
    private final GeometryBuffers buffers;
    private final ShaderProgram program;
    private final KeptTarget targets;

    BodyShading(RenderContext context, SceneRenderer renderer) {
        this.context = context;
        this.buffers = new GeometryBuffers(context, renderer, GeometryLayout.FULL);
        this.program = context.createFullScreenProgram(Shaders.library().load("body.frag"));
        this.targets = new KeptTarget(context, "body", FloatTargetSpec.Format.RGBA32F);
    }

    /** The whole picture of the geometry's size. */
    ScenePicture draw(Scene scene, SkinGeometry geometry) {
        SceneUniforms.set(program, scene);
        int width = geometry.width();
        int height = geometry.height();
        ScenePicture picture = ScenePicture.empty(width, height);
        for (SceneBlocks.Piece piece : SceneBlocks.split(width, height, Tile.whole(width, height))) {
            Tile part = piece.inBlock();
            GeometryBuffer buffer = buffers.of(geometry, piece.block());
            FloatTarget target = targets.of(piece.block().width(), piece.block().height());
            target.clear(part, 0, 0, 0, 0);
            context.drawFullScreen(program, buffer.bindings(), target, part);
            picture.put(new ScenePicture(part.width(), part.height(), target.read(0, part)), piece.x(), piece.y());
        }
        return picture;
    }

    @Override
    public void close() {
        targets.close();
        program.close();
        buffers.close();
    }
}
