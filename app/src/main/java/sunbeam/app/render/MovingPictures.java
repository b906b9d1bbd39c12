package sunbeam.app.render;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import jrtr.gl.RenderContext;
import sunbeam.app.scene.Scene;

/** Draws pictures while something in the viewer moves, from resident tiles and with few taps per pixel. */
final class MovingPictures implements AutoCloseable {
    private final RenderContext context;
    private GeometryBuffers buffers;
    private long meshNanoseconds;

    MovingPictures(RenderContext context) {
        this.context = context;
    }

    /**
     * Draws a picture without baking tiles. A larger divisor draws fewer pixels with larger footprints.
     *
     * @param divisor factor by which columns and rows are reduced
     * @return sRGB picture
     */
    BufferedImage draw(
            UploadedScene uploaded, Scene scene, int fullWidth, int fullHeight, double divisor, double exposure) {
        int width = (int) Math.ceil(fullWidth / divisor);
        int height = (int) Math.ceil(fullHeight / divisor);
        if (buffers == null) {
            buffers = new GeometryBuffers(context, GeometryBuffer.Layout.MOVING);
        }
        SkinGeometry geometry = uploaded.geometry(scene, width, height, true);
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        // Pixels are written directly, which ends Swing's acceleration of the image; an image that is painted once
        // gains nothing from it.
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
}
