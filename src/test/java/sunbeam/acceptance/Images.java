package sunbeam.acceptance;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferFloat;
import java.awt.image.PixelInterleavedSampleModel;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Iterator;
import java.util.function.IntBinaryOperator;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriter;
import javax.imageio.stream.FileImageOutputStream;

/** Writes height maps as image files. */
public final class Images {
    private Images() {}

    /** Writes an 8-bit gray PNG with a value for each column and row. */
    public static Path gray(Path file, int columns, int rows, IntBinaryOperator value) throws IOException {
        BufferedImage image = new BufferedImage(columns, rows, BufferedImage.TYPE_BYTE_GRAY);
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                image.getRaster().setSample(column, row, 0, value.applyAsInt(column, row));
            }
        }
        ImageIO.write(image, "png", file.toFile());
        return file;
    }

    /** Writes a square TIFF of equal 32-bit floats. */
    public static Path floats(Path file, int side, float value) throws IOException {
        float[] samples = new float[side * side];
        Arrays.fill(samples, value);
        ComponentColorModel model = new ComponentColorModel(
                ColorSpace.getInstance(ColorSpace.CS_GRAY), false, false, BufferedImage.OPAQUE, DataBuffer.TYPE_FLOAT);
        PixelInterleavedSampleModel layout =
                new PixelInterleavedSampleModel(DataBuffer.TYPE_FLOAT, side, side, 1, side, new int[] {0});
        WritableRaster raster = Raster.createWritableRaster(layout, new DataBufferFloat(samples, samples.length), null);
        ImageWriter writer = writerOfJava("tiff");
        try (FileImageOutputStream out = new FileImageOutputStream(file.toFile())) {
            writer.setOutput(out);
            writer.write(new BufferedImage(model, raster, false, null));
        } finally {
            writer.dispose();
        }
        return file;
    }

    /** Returns Java's own writer; that of the program's library writes no floats. */
    private static ImageWriter writerOfJava(String format) {
        Iterator<ImageWriter> all = ImageIO.getImageWritersByFormatName(format);
        ImageWriter writer = all.next();
        while (!writer.getClass().getName().startsWith("com.sun.")) {
            writer = all.next();
        }
        return writer;
    }
}
