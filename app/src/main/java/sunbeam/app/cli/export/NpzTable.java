package sunbeam.app.cli.export;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.zip.ZipOutputStream;
import sunbeam.app.cli.JsonOption;
import sunbeam.app.files.output.NpyWriter;
import sunbeam.app.files.output.StreamContent;
import sunbeam.precompute.analysis.EnergyDivisor;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.color.WavelengthBand.SpectralBands;
import sunbeam.precompute.numerics.Floats;
import sunbeam.precompute.optics.Direction;

/** A NumPy archive: array {@code C} of shape (w, v, u, channel), its axes, and metadata.json; bands are for spectral channels. */
record NpzTable(Channels channels, SpectralBands bands) implements TableWriter {
    private static final String INTERPOLATION =
            "square roots (of negative values, minus that of the absolute) linear along u and v; their squares by the"
                    + " cubic polynomial through the four nearest slices of w";
    // Approximate bytes of a deflated value; texels that no directions reach take none.
    private static final double VALUE_BYTES = 8 / 3.0;
    // Lowest bits of a float's significand that are rounded away, which leaves 14: the others deflate well.
    private static final int DROPPED_BITS = 10;
    // Directions of light along each axis of the divisor.
    private static final int LIGHTS = 25;

    enum Channels {
        XYZ("CIE X, Y, Z of diffracted power"),
        REC709("linear Rec. 709 red, green, blue of diffracted power, negative outside of the gamut"),
        SPECTRAL("diffracted power, mean over each band, weighted by a triangle that ends at the bands beside it");

        private final String quantity;

        Channels(String quantity) {
            this.quantity = quantity;
        }
    }

    private boolean isSpectral() {
        return channels == Channels.SPECTRAL;
    }

    private int count() {
        return isSpectral() ? bands.count() : ColorGrid.CHANNELS;
    }

    @Override
    public long numbers(GridShape shape) {
        return Math.max(ColorGrid.CHANNELS, count()) * shape.allTexels();
    }

    @Override
    public CieTable errorWeights(CieTable light) {
        return isSpectral() ? bands.table(bands.tables() / 2) : light;
    }

    @Override
    public long leastBytes(GridShape shape) {
        return (long) (VALUE_BYTES * count() * shape.evaluated());
    }

    @Override
    public Output output(ColorGrid grid, GridBaker baker, TableMetadata metadata) {
        String json = JsonOption.text(description(metadata));
        GridShape shape = grid.shape();
        Optional<float[]> divisors = metadata.divisor().map(this::divisors);
        float[] colors = colors(shape, isSpectral() ? baker.bands(grid, bands) : List.of(grid));
        StreamContent content = stream -> {
            try (ZipOutputStream zip = new ZipOutputStream(stream)) {
                zip.setLevel(1);
                zip.putNextEntry(NpyWriter.entry("metadata.json"));
                zip.write(json.getBytes(StandardCharsets.UTF_8));
                put(zip, "u", values(shape.u(), 1), shape.u().count());
                put(zip, "v", values(shape.v(), 1), shape.v().count());
                put(zip, "w", values(shape.depth(), -1), shape.depth().count());
                put(
                        zip,
                        "C",
                        colors,
                        shape.depth().count(),
                        shape.v().count(),
                        shape.u().count(),
                        count());
                if (divisors.isPresent()) {
                    put(zip, "divisor", divisors.get(), count(), LIGHTS, LIGHTS);
                }
            }
        };
        return new Output(Map.of(".npz", content), metadata);
    }

    private Map<String, Object> description(TableMetadata metadata) {
        Map<String, Object> fields =
                metadata.fields(channels.quantity + ": array C, axes w, v, u, channel", INTERPOLATION);
        if (isSpectral()) {
            TableMetadata.putNoLight(fields);
            fields.put("unit", "1: a flat mirror in specular direction under the asked window, at each wavelength");
            fields.put(
                    "wavelengths_m",
                    DoubleStream.of(bands.nanometers()).map(nm -> nm / 1e9).toArray());
        }
        return fields;
    }

    private static float[] values(GridShape.Axis axis, int sign) {
        return Floats.of(axis.count(), i -> sign * axis.at(i));
    }

    private static void put(ZipOutputStream zip, String name, float[] values, int... shape) throws IOException {
        zip.putNextEntry(NpyWriter.entry(name + ".npy"));
        NpyWriter.write(zip, values, shape);
    }

    private float[] colors(GridShape shape, List<ColorGrid> grids) {
        int texels = shape.texels();
        int slices = shape.depth().count();
        float[] colors = new float[Math.multiplyExact(count(), Math.multiplyExact(texels, slices))];
        double[] values = new double[count()];
        int at = 0;
        for (int slice = 0; slice < slices; slice++) {
            for (int texel = 0; texel < texels; texel++) {
                for (int c = 0; c < values.length; c++) {
                    ColorGrid grid = grids.get(c / ColorGrid.CHANNELS);
                    double root = grid.roots()[slice][ColorGrid.CHANNELS * texel + c % ColorGrid.CHANNELS];
                    values[c] = grid.level().scale() * root * root;
                }
                for (int c = 0; c < values.length; c++) {
                    boolean isRgb = channels == Channels.REC709;
                    double value = isRgb ? Srgb.linear(c, values[0], values[1], values[2]) : values[c];
                    colors[at++] = rounded((float) value);
                }
            }
        }
        return colors;
    }

    /** Returns the divisor of each band over y and x of the direction of light, -1 to 1. */
    private float[] divisors(EnergyDivisor divisor) {
        float[] values = new float[count() * LIGHTS * LIGHTS];
        IntStream.range(0, values.length).parallel().forEach(i -> {
            Direction light = EnergyDivisor.light(
                    2.0 * (i % LIGHTS) / (LIGHTS - 1) - 1, 2.0 * (i / LIGHTS % LIGHTS) / (LIGHTS - 1) - 1);
            values[i] = (float) divisor.at(light, 1e-9 * bands.nanometers()[i / (LIGHTS * LIGHTS)]);
        });
        return values;
    }

    private static float rounded(float value) {
        int half = 1 << (DROPPED_BITS - 1);
        return Float.intBitsToFloat((Float.floatToIntBits(value) + half) & -(1 << DROPPED_BITS));
    }
}
