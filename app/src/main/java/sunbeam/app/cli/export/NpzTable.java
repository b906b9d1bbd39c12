package sunbeam.app.cli.export;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import java.util.zip.ZipOutputStream;
import sunbeam.app.cli.options.JsonOption;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.NpyWriter;
import sunbeam.app.files.output.Overwrite;
import sunbeam.precompute.analysis.EnergyDivisor;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.Direction;

/** Writes a NumPy archive: array {@code C} of shape (w, v, u, channel), the axes {@code w}, {@code v}, {@code u}, and metadata.json. */
record NpzTable(Channels channels) implements TableWriter {
    private static final String INTERPOLATION =
            "square roots (of negative values, minus that of the absolute) linear along u and v; their squares by the"
                    + " cubic polynomial through the four nearest slices of w";
    // Approximate bytes of a deflated value; texels that no directions reach take none.
    private static final double VALUE_BYTES = 8 / 3.0;
    // Lowest bits of a float's significand that are rounded away, which leaves 14: the others deflate well.
    private static final int DROPPED_BITS = 10;
    // Directions of light along each axis of the divisor.
    private static final int LIGHTS = 25;

    @Override
    public void check(Path output, Overwrite overwrite) {
        Ending.NPZ.require("--output", output);
        AtomicFile.checkWritable(output, overwrite);
    }

    @Override
    public long numbers(GridShape shape) {
        return channels.numbers(shape);
    }

    @Override
    public CieTable errorWeights(CieTable light) {
        return channels.errorWeights(light);
    }

    @Override
    public long leastBytes(GridShape shape) {
        return (long) (VALUE_BYTES * channels.count() * shape.evaluated());
    }

    @Override
    public List<Path> write(Path output, Overwrite overwrite, ColorGrid grid, GridBaker baker, TableMetadata metadata) {
        String json = JsonOption.text(
                channels.fields(metadata.fields(channels.words() + ": array C, axes w, v, u, channel", INTERPOLATION)));
        GridShape shape = grid.shape();
        float[] colors = colors(shape, channels.grids(grid, baker));
        return List.of(AtomicFile.write(output, overwrite, stream -> {
            try (ZipOutputStream zip = new ZipOutputStream(stream)) {
                zip.setLevel(1);
                zip.putNextEntry(NpyWriter.entry("metadata.json"));
                zip.write(json.getBytes(StandardCharsets.UTF_8));
                axis(zip, "u", shape.u().values(1));
                axis(zip, "v", shape.v().values(1));
                axis(zip, "w", shape.depth().values(-1));
                zip.putNextEntry(NpyWriter.entry("C.npy"));
                NpyWriter.write(
                        zip,
                        colors,
                        shape.depth().count(),
                        shape.v().count(),
                        shape.u().count(),
                        channels.count());
                zip.closeEntry();
                if (metadata.divisor().isPresent()) {
                    zip.putNextEntry(NpyWriter.entry("divisor.npy"));
                    float[] divisors =
                            divisors(metadata.divisor().get(), metadata.setup().cie());
                    NpyWriter.write(zip, divisors, channels.count(), LIGHTS, LIGHTS);
                    zip.closeEntry();
                }
            }
        }));
    }

    private static void axis(ZipOutputStream zip, String name, double... along) throws IOException {
        float[] values = new float[along.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = (float) along[i];
        }
        zip.putNextEntry(NpyWriter.entry(name + ".npy"));
        NpyWriter.write((OutputStream) zip, values, values.length);
    }

    private float[] colors(GridShape shape, List<ColorGrid> grids) {
        int texels = shape.texels();
        int slices = shape.depth().count();
        float[] colors = new float[Math.multiplyExact(channels.count(), Math.multiplyExact(texels, slices))];
        double[] values = new double[channels.count()];
        int at = 0;
        for (int slice = 0; slice < slices; slice++) {
            for (int texel = 0; texel < texels; texel++) {
                channels.at(grids, slice, texel, values);
                for (double value : values) {
                    colors[at++] = rounded((float) value);
                }
            }
        }
        return colors;
    }

    /** Returns the divisor of each channel over y and x of the direction of light, -1 to 1. */
    private float[] divisors(EnergyDivisor divisor, CieTable cie) {
        float[] values = new float[channels.count() * LIGHTS * LIGHTS];
        IntStream.range(0, values.length).parallel().forEach(i -> {
            Direction light = EnergyDivisor.light(
                    2.0 * (i % LIGHTS) / (LIGHTS - 1) - 1, 2.0 * (i / LIGHTS % LIGHTS) / (LIGHTS - 1) - 1);
            values[i] = (float) channels.divisor(divisor, i / (LIGHTS * LIGHTS), light, cie);
        });
        return values;
    }

    private static float rounded(float value) {
        int half = 1 << (DROPPED_BITS - 1);
        return Float.intBitsToFloat((Float.floatToIntBits(value) + half) & -(1 << DROPPED_BITS));
    }
}
