package sunbeam.precompute.patch;

import static sunbeam.precompute.patch.PatchSettings.CHANNEL;
import static sunbeam.precompute.patch.PatchSettings.MAX_HEIGHT;
import static sunbeam.precompute.patch.PatchSettings.WIDTH;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BandedSampleModel;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.awt.image.SampleModel;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Iterator;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriter;
import javax.imageio.stream.FileImageOutputStream;

final class TestImages {
    private TestImages() {}

    /** The value of a sample, or of one band of it. */
    interface Samples {
        double at(int column, int row, int band);
    }

    static BufferedImage gray8(int columns, int rows, Samples samples) {
        return filled(new BufferedImage(columns, rows, BufferedImage.TYPE_BYTE_GRAY), samples);
    }

    static BufferedImage gray16(int columns, int rows, Samples samples) {
        return filled(new BufferedImage(columns, rows, BufferedImage.TYPE_USHORT_GRAY), samples);
    }

    static BufferedImage rgb(int columns, int rows, Samples samples) {
        return filled(new BufferedImage(columns, rows, BufferedImage.TYPE_3BYTE_BGR), samples);
    }

    static BufferedImage rgba(int columns, int rows, Samples samples) {
        return filled(new BufferedImage(columns, rows, BufferedImage.TYPE_4BYTE_ABGR), samples);
    }

    static BufferedImage gray32f(int columns, int rows, Samples samples) {
        ComponentColorModel model = new ComponentColorModel(
                ColorSpace.getInstance(ColorSpace.CS_GRAY), false, false, Transparency.OPAQUE, DataBuffer.TYPE_FLOAT);
        SampleModel floats = new BandedSampleModel(DataBuffer.TYPE_FLOAT, columns, rows, 1);
        return filled(new BufferedImage(model, Raster.createWritableRaster(floats, null), false, null), samples);
    }

    /** An 8-bit palette image whose index i has the gray {@code grays[i]}. */
    static BufferedImage palette(int columns, int rows, byte[] grays, Samples indices) {
        IndexColorModel colors = new IndexColorModel(8, grays.length, grays, grays, grays);
        return filled(new BufferedImage(columns, rows, BufferedImage.TYPE_BYTE_INDEXED, colors), indices);
    }

    static Path write(BufferedImage image, Path file) throws IOException {
        String name = file.toString();
        String format = name.substring(name.lastIndexOf('.') + 1);
        ImageWriter writer = null;
        for (Iterator<ImageWriter> all = ImageIO.getImageWritersByFormatName(format); all.hasNext(); ) {
            ImageWriter next = all.next();
            writer = next.getClass().getName().startsWith("com.sun.") ? next : writer;
        }
        Files.deleteIfExists(file);
        try (FileImageOutputStream out = new FileImageOutputStream(file.toFile())) {
            writer.setOutput(out);
            writer.write(image);
        }
        return file;
    }

    private static BufferedImage filled(BufferedImage image, Samples samples) {
        WritableRaster raster = image.getRaster();
        for (int row = 0; row < image.getHeight(); row++) {
            for (int column = 0; column < image.getWidth(); column++) {
                for (int band = 0; band < raster.getNumBands(); band++) {
                    raster.setSample(column, row, band, samples.at(column, row, band));
                }
            }
        }
        return image;
    }

    /** Samples of the heights' channel as stored. */
    static double[] samples(Path file, double fullScale) {
        return samples(file, null, fullScale);
    }

    /** Samples of a channel as stored: heights with a full scale of 1 um, times the full scale of the samples. */
    static double[] samples(Path file, String channel, double fullScale) {
        PatchRequest request = PatchRequests.of(file, WIDTH, "10um", MAX_HEIGHT, "1um", CHANNEL, channel);
        return Arrays.stream(MeasuredHeights.read(file, request.choices()).map().heights())
                .map(height -> height / 1e-6 * fullScale)
                .toArray();
    }
}
