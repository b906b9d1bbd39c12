package sunbeam.app.render;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import org.joml.Vector2f;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.VirtualTexture;
import sunbeam.app.render.GeometryBuffer.SkinGeometry;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;

/** Draws pictures while something in the viewer moves, from resident tiles and with few taps per pixel. */
final class MovingPictures implements AutoCloseable {
    private final RenderContext context;
    private GeometryBuffer.Cache buffers;
    private long meshNanoseconds;

    MovingPictures(RenderContext context) {
        this.context = context;
    }

    /** Draws a picture in sRGB without baking tiles. The divisor reduces columns and rows and enlarges footprints. */
    BufferedImage draw(
            UploadedScene uploaded, Scene scene, int fullWidth, int fullHeight, double divisor, double exposure) {
        int width = (int) Math.ceil(fullWidth / divisor);
        int height = (int) Math.ceil(fullHeight / divisor);
        if (buffers == null) {
            buffers = new GeometryBuffer.Cache(context, GeometryBuffer.Layout.MOVING);
        }
        SkinGeometry geometry = uploaded.geometry(scene, width, height, true);
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        // Direct writes end Swing's acceleration, from which an image that is painted once gains nothing.
        int[] picture = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
        for (SceneBlocks.Piece piece : SceneBlocks.split(width, height)) {
            long start = System.nanoTime();
            GeometryBuffer buffer = buffers.of(geometry, piece.block());
            meshNanoseconds += System.nanoTime() - start;
            int[] part = uploaded.skin()
                    .drawMoving(context, scene, uploaded.ground(scene), geometry, buffer, piece.block(), exposure);
            int columns = piece.inBlock().width();
            for (int row = 0; row < piece.inBlock().height(); row++) {
                System.arraycopy(part, row * columns, picture, (piece.y() + row) * width + piece.x(), columns);
            }
        }
        return image;
    }

    long meshNanoseconds() {
        return meshNanoseconds;
    }

    @Override
    public void close() {
        if (buffers != null) {
            buffers.close();
        }
    }

    /** Shading pass of moving pictures (shaders/moving.frag): few taps per pixel in resident tiles, sRGB output only. */
    static final class MovingSkin implements AutoCloseable {
        // Software renderers have time for one tap along the major axis; a coarser level then blurs it, too.
        private static final int SOFTWARE_TAPS = 1;
        private static final int HARDWARE_TAPS = 4;

        private final RenderContext context;
        private final int lights;
        private final int mostTaps;
        private final ShaderProgram program;
        private final Optional<VirtualTexture> levels;
        private final CachedTarget targets;

        MovingSkin(RenderContext context, UploadedTables method, Optional<VirtualTexture> levels, int lights) {
            this.context = context;
            this.lights = lights;
            this.mostTaps = context.info().software() ? SOFTWARE_TAPS : HARDWARE_TAPS;
            this.program = method.program(
                    "moving.frag", Map.of("MOST_TAPS", Integer.toString(mostTaps), "LIGHTS", Integer.toString(lights)));
            this.levels = levels;
            this.targets = new CachedTarget(context, "moving", FloatTarget.Format.RGBA8, true);
        }

        int lights() {
            return lights;
        }

        ShaderProgram program() {
            return program;
        }

        /** Returns a block in pixels as 0xffRRGGBB, top row first, from a buffer in {@link GeometryBuffer.Layout#MOVING}. */
        int[] draw(
                Scene scene,
                Optional<Ground> ground,
                SkinGeometry geometry,
                GeometryBuffer buffer,
                Tile block,
                Map<String, Texture> method,
                double exposure) {
            Map<String, Texture> textures = new HashMap<>(method);
            levels.ifPresent(tiles -> {
                SkinSurface.setFootprints(program, tiles.table(), scene, mostTaps, 1, false);
                textures.putAll(tiles.textures());
            });
            geometry.applyRaysTo(program, block);
            program.set("targetToWorld", geometry.blockToWorld(block));
            geometry.shadows().applyTo(program, scene.hasShadows());
            program.set("exposure", (float) exposure);
            program.set("toneStart", (float) scene.display(exposure).tone().start());
            textures.putAll(buffer.textures());
            textures.put("depths", buffer.attributes().depth());
            textures.putAll(geometry.shadows().textures());
            Tile whole = Tile.whole(block.width(), block.height());
            program.set("perPicture", new Vector2f(1f / block.width(), 1f / block.height()));
            FloatTarget target = targets.of(block.width(), block.height());
            if (ground.isPresent()) {
                ground.get().fillMovingBlock(target, scene, geometry, block, exposure);
            } else {
                int rgb = scene.get(SceneSettings.BACKGROUND).rgb();
                target.clear(whole, (rgb >> 16) / 255f, (rgb >> 8 & 0xff) / 255f, (rgb & 0xff) / 255f, 1);
            }
            target.copyDepthFrom(buffer.attributes());
            context.drawCovered(program, textures, target, whole);
            return target.readColors(0, whole);
        }

        @Override
        public void close() {
            targets.close();
            program.close();
        }
    }
}
