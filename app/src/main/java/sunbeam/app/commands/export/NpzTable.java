package sunbeam.app.commands.export;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.NpyWriter;
import sunbeam.app.files.output.Overwrite;
import sunbeam.precompute.color.Srgb;

/**
 * NumPy's archive of arrays: {@code C} of shape (w, v, u, 3), {@code w}, {@code v}, {@code u}, and metadata.json.
 *
 * @param channels of C
 */
record NpzTable(Channels channels) implements TableWriter {
    // Of what is not dark, deflated values take about so many bytes; corners that no directions see take none.
    private static final double TEXEL_BYTES = 8;
    // Values are rounded to 14 bits, which deflate well.
    private static final int DROPPED_BITS = 10;

    /** What C is. */
    enum Channels {
        /** CIE X, Y, Z. */
        XYZ("CIE X, Y, Z of diffracted power"),
        /** Linear red, green and blue, which are negative outside of their gamut. */
        REC709("linear Rec. 709 red, green, blue of diffracted power, negative outside of the gamut");

        private final String words;

        Channels(String words) {
            this.words = words;
        }

        private float of(double[] xyz, int channel) {
            return rounded((float) (this == XYZ ? xyz[channel] : Srgb.linear(channel, xyz[0], xyz[1], xyz[2])));
        }

        private static float rounded(float value) {
            int half = 1 << (DROPPED_BITS - 1);
            return Float.intBitsToFloat((Float.floatToIntBits(value) + half) & -(1 << DROPPED_BITS));
        }
    }

    @Override
    public void check(Path output, Overwrite overwrite) {
        Ending.NPZ.require("--output", output);
        AtomicFile.checkWritable(output, overwrite);
    }

    @Override
    public long leastBytes(GridShape shape) {
        return (long) (TEXEL_BYTES * shape.evaluated());
    }

    @Override
    public List<Path> write(Path output, Overwrite overwrite, ColorGrid grid, GridBaker baker, TableText text) {
        String json = text.json(
                channels.words + ": array C, axes w, v, u, channel",
                "square roots (of negative values, minus that of the absolute) linear along u and v; their squares by the"
                        + " cubic polynomial through the four nearest slices of w");
        GridShape shape = grid.shape();
        return List.of(AtomicFile.write(output, overwrite, stream -> {
            try (ZipOutputStream zip = new ZipOutputStream(stream)) {
                zip.setLevel(1);
                zip.putNextEntry(new ZipEntry("metadata.json"));
                zip.write(json.getBytes(StandardCharsets.UTF_8));
                axis(zip, "u", shape.u(), 1);
                axis(zip, "v", shape.v(), 1);
                axis(zip, "w", shape.depth(), -1);
                zip.putNextEntry(new ZipEntry("C.npy"));
                int slices = shape.depth().count();
                NpyWriter.write(
                        zip, colors(grid), slices, shape.v().count(), shape.u().count(), ColorGrid.CHANNELS);
                zip.closeEntry();
            }
        }));
    }

    private static void axis(ZipOutputStream zip, String name, GridAxis axis, int sign) throws IOException {
        float[] values = new float[axis.count()];
        for (int i = 0; i < values.length; i++) {
            values[i] = (float) (sign * axis.at(i));
        }
        zip.putNextEntry(new ZipEntry(name + ".npy"));
        NpyWriter.write((OutputStream) zip, values, values.length);
    }

    private float[] colors(ColorGrid grid) {
        int perSlice = ColorGrid.CHANNELS * grid.shape().texels();
        float[] colors = new float[Math.multiplyExact(perSlice, grid.roots().length)];
        double[] xyz = new double[ColorGrid.CHANNELS];
        for (int slice = 0; slice < grid.roots().length; slice++) {
            float[] roots = grid.roots()[slice];
            for (int at = 0; at < perSlice; at += ColorGrid.CHANNELS) {
                for (int c = 0; c < ColorGrid.CHANNELS; c++) {
                    xyz[c] = grid.level().scale() * roots[at + c] * roots[at + c];
                }
                for (int c = 0; c < ColorGrid.CHANNELS; c++) {
                    colors[slice * perSlice + at + c] = channels.of(xyz, c);
                }
            }
        }
        return colors;
    }
}
