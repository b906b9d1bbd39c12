package sunbeam.app.cli.export;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.IntToDoubleFunction;
import java.util.stream.Stream;
import sunbeam.app.cli.DirectionSampler;
import sunbeam.app.cli.JsonOption;
import sunbeam.app.cli.export.BsdfMaterial.Slice;
import sunbeam.app.files.output.NpyWriter;
import sunbeam.app.files.output.StreamContent;
import sunbeam.app.gpu.DirectionQuery;
import sunbeam.precompute.color.WavelengthBand;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.numerics.Floats;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.text.Text;

/** A tensor file that Mitsuba 3 and pbrt-v4 read as their material {@code measured}. */
record BsdfTable(WavelengthBand range, int bandCount) implements TableWriter {
    // Format of tensor files: version 1.0, little endian, the last index runs fastest.
    private static final byte[] HEAD = "tensor_file\0\1\0".getBytes(StandardCharsets.US_ASCII);
    private static final byte UINT8 = 1;
    private static final byte FLOAT32 = 10;
    private static final int ALIGNMENT = 8;
    private static final int CURVE_SAMPLES = 1024;
    private static final int COMPARED_PAIRS = 300;
    private static final long SEED = 5;
    // Least power at which errors are measured: in a Gaussian's tail linear interpolation has large relative errors.
    private static final double LEAST_POWER = 1e-3;

    private BsdfMaterial.Shape shape(GridShape shape) {
        return BsdfMaterial.Shape.of(shape, range, bandCount);
    }

    @Override
    public long numbers(GridShape shape) {
        return shape(shape).floatCount()
                + (ColorGrid.CHANNELS + shape(shape).bands().count()) * shape.allTexels();
    }

    @Override
    public long leastBytes(GridShape shape) {
        return Float.BYTES * shape(shape).floatCount();
    }

    /** The errors of power exceed the color grid's, because the file's grid of directions is coarser. */
    @Override
    public Output output(ColorGrid grid, GridBaker baker, TableMetadata metadata) {
        BsdfMaterial.Shape shape = shape(grid.shape());
        BsdfMaterial material = BsdfMaterial.of(shape, baker.bands(grid, shape.bands()), metadata);
        ErrorStatistics errors = errors(material, grid, metadata);
        int side = shape.side();
        String note = Text.format(
                "%d x %d first directions, %d x %d second, %d bands; error of power as it is read, where it exceeds %.0e: beside"
                        + " the reference at %s %s",
                shape.phis(), shape.thetas(), side, side, shape.bands().count(), LEAST_POWER, errors.pairs(), errors);
        StreamContent content = stream -> write(stream, fields(material, metadata, note));
        return new Output(Map.of(".bsdf", content), List.of(note), errors);
    }

    private static List<Field> fields(BsdfMaterial material, TableMetadata metadata, String note) {
        BsdfMaterial.Shape shape = material.shape();
        int phis = shape.phis();
        int thetas = shape.thetas();
        int side = shape.side();
        double[] nanometers = shape.bands().nanometers();
        // Readers interpolate sigma and ndf between the first and the last azimuth, where the curves are the same.
        return List.of(
                Field.of("description", metadata.summary()),
                Field.of("metadata", description(metadata, note)),
                Field.of("jacobian", (byte) 1),
                Field.curve("phi_i", shape::phi, phis),
                Field.curve("theta_i", shape::theta, thetas),
                Field.curve("wavelengths", i -> nanometers[i], nanometers.length),
                Field.curve("sigma", i -> Math.cos(angle(i)), 2, CURVE_SAMPLES),
                Field.curve("ndf", i -> BsdfMaterial.normalFactor(angle(i)), 2, CURVE_SAMPLES),
                Field.of("vndf", material, Slice::density, phis, thetas, shape.rows(), shape.columns()),
                Field.of("luminance", material, Slice::luminance, phis, thetas, side, side),
                Field.of("spectra", material, Slice::spectra, phis, thetas, nanometers.length, side, side));
    }

    private static String description(TableMetadata metadata, String note) {
        Map<String, Object> fields = metadata.fields(
                "BRDF times the cosine of the second direction, by bands of wavelengths, as material measured has it",
                "linear in all angles and wavelengths, along the unit square of half vectors");
        TableMetadata.putNoLight(fields);
        fields.put("power_scale", 1);
        fields.put("unit", "1/sr");
        fields.put("read", note);
        return JsonOption.text(fields);
    }

    private static double angle(int i) {
        return HalfVectors.angle(i, CURVE_SAMPLES);
    }

    /** Measures errors of power at pairs aimed at orders: most other pairs are dark. */
    private static ErrorStatistics errors(BsdfMaterial material, ColorGrid grid, TableMetadata metadata) {
        ExactLight exact =
                metadata.setup().exact(new ReferenceMethod(grid.level().area()));
        DirectionSampler sampler = new DirectionSampler(
                metadata.setup().patch().heights(), grid.level().area().window(), SEED);
        double lowest = Math.cos(material.shape().largest());
        List<DirectionQuery> queries = Stream.generate(sampler::aimed)
                .limit(COMPARED_PAIRS)
                .filter(query -> Math.min(query.pair().cosThetaI(), query.pair().cosThetaR()) > lowest)
                .toList();
        List<Comparison> compared = metadata.setup().progress().map("Exact powers", queries, query -> {
            double power = exact.power(query.pair(), query.wavelength());
            double unit = Gain.KERATIN.brdf(query.pair(), exact.window(), query.wavelength());
            double read = material.eval(query.pair(), query.wavelength())
                    / (unit * query.pair().cosThetaR());
            double divisor = metadata.divisor()
                    .map(found -> found.at(query.pair().wi(), query.wavelength()))
                    .orElse(1.0);
            return Comparison.ofPower(read * divisor, power);
        });
        return ErrorStatistics.of(compared.stream()
                .filter(one -> Math.max(one.exact()[0], one.computed()[0]) > LEAST_POWER)
                .mapToDouble(Comparison::relative)
                .toArray());
    }

    /** An array of bytes or of float32 numbers. */
    private record Field(String name, byte type, long[] shape, StreamContent content) {
        static Field of(String name, byte... bytes) {
            return new Field(name, UINT8, new long[] {bytes.length}, stream -> stream.write(bytes));
        }

        static Field of(String name, String text) {
            return of(name, text.getBytes(StandardCharsets.UTF_8));
        }

        static Field of(String name, BsdfMaterial material, Function<Slice, float[]> array, long... shape) {
            return of(name, material.slices().stream().map(array).toList(), shape);
        }

        static Field of(String name, List<float[]> portions, long... shape) {
            return new Field(name, FLOAT32, shape, stream -> {
                for (float[] portion : portions) {
                    NpyWriter.writeValues(stream, portion);
                }
            });
        }

        /** Returns a field with a curve along its last axis, the same at each index of the axis before. */
        static Field curve(String name, IntToDoubleFunction curve, long... shape) {
            float[] values = Floats.of((int) shape[shape.length - 1], curve);
            return of(name, Collections.nCopies(shape.length == 1 ? 1 : (int) shape[0], values), shape);
        }

        private long size() {
            return Arrays.stream(shape).reduce(1, Math::multiplyExact) * (type == FLOAT32 ? Float.BYTES : 1);
        }

        private int headBytes() {
            return Short.BYTES + name.length() + Short.BYTES + 1 + Long.BYTES * (1 + shape.length);
        }
    }

    private static void write(OutputStream stream, List<Field> fields) throws IOException {
        int head = HEAD.length
                + Integer.BYTES
                + fields.stream().mapToInt(Field::headBytes).sum();
        ByteBuffer header = ByteBuffer.allocate(Math.toIntExact(aligned(head))).order(ByteOrder.LITTLE_ENDIAN);
        header.put(HEAD).putInt(fields.size());
        long offset = header.capacity();
        for (Field field : fields) {
            header.putShort((short) field.name().length()).put(field.name().getBytes(StandardCharsets.US_ASCII));
            header.putShort((short) field.shape().length).put(field.type());
            header.putLong(offset);
            Arrays.stream(field.shape()).forEach(header::putLong);
            offset += aligned(field.size());
        }
        stream.write(header.array());
        for (Field field : fields) {
            field.content().writeTo(stream);
            stream.write(new byte[(int) (aligned(field.size()) - field.size())]);
        }
    }

    private static long aligned(long bytes) {
        return (bytes + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    }
}
