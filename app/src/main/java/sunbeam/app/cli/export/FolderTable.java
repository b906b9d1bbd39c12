package sunbeam.app.cli.export;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import sunbeam.app.cli.JsonOption;
import sunbeam.app.files.output.ExrFile;
import sunbeam.app.files.output.StreamContent;
import sunbeam.precompute.colortable.NumberFormat;

/** A folder for renderers: shader source and textures; for those that do not filter by averaging samples, with mip levels. */
record FolderTable(boolean isGlsl) implements TableWriter {
    /** Mip levels of the KTX2 texture beside the finest. */
    private static final int MOST_DOUBLINGS = 4;
    // Bytes per texel of KTX2: four half floats; coarser levels add a third to the bytes of the finest.
    private static final double TEXEL_BYTES = 8 * 4 / 3.0;
    // Bytes per evaluated texel in EXR: three half floats, which ZIP compresses by a third.
    private static final double EVALUATED_BYTES = 4;
    // Factor of the stored roots: without it dark ones would be subnormal half floats.
    private static final float SCALE = 256;
    private static final String QUANTITY =
            "square roots of CIE X, Y, Z of diffracted power, times 256: of sunbeam.exr the slices one below the other, from the"
                    + " first w on, rows of ascending v from the top";
    private static final String KTX2_QUANTITY =
            "; layers of sunbeam.ktx2, whose mip levels have orders twice as wide each";
    private static final String INTERPOLATION =
            "square roots linear along u and v; their squares by the cubic polynomial through the four nearest slices of w";

    @Override
    public GridShape fit(GridShape shape) {
        int multiple = isGlsl ? 1 << MOST_DOUBLINGS : 1;
        return new GridShape(
                shape.u().padded(multiple), shape.v().padded(multiple), shape.depth(), shape.largestAngle());
    }

    @Override
    public long leastBytes(GridShape shape) {
        return (long) ((isGlsl ? TEXEL_BYTES * shape.allTexels() : 0) + EVALUATED_BYTES * shape.evaluated());
    }

    @Override
    public ColorGrid asRead(ColorGrid grid) {
        float scale = scale(grid);
        float[][] read = Stream.of(grid.roots()).map(float[]::clone).toArray(float[][]::new);
        for (float[] roots : read) {
            for (int i = 0; i < roots.length; i++) {
                roots[i] = NumberFormat.ofHalf(NumberFormat.half(scale * roots[i])) / scale;
            }
        }
        return new ColorGrid(grid.level(), grid.shape(), read);
    }

    private static float scale(ColorGrid grid) {
        return SCALE * (float) Math.sqrt(grid.level().scale());
    }

    @Override
    public Output output(ColorGrid grid, GridBaker baker, TableMetadata metadata) {
        Map<String, Object> fields = metadata.fields(QUANTITY + (isGlsl ? KTX2_QUANTITY : ""), INTERPOLATION);
        fields.put("exposure", metadata.exposure());
        fields.put("exposure_theta_i_deg", metadata.theta());
        String json = JsonOption.text(fields);
        GridShape shape = grid.shape();
        int columns = shape.u().count();
        int rows = shape.v().count();
        int slices = shape.depth().count();
        int doublings = isGlsl ? Math.min(MOST_DOUBLINGS, baker.doublings(grid)) : 0;
        Map<String, StreamContent> files = new LinkedHashMap<>();
        String language = isGlsl ? "glsl" : "osl";
        String function = ShaderText.of("sunbeam." + language, metadata, doublings);
        if (!isGlsl) {
            files.put(".osl", StreamContent.of(function));
        } else {
            for (ShaderText.Language each : ShaderText.Language.values()) {
                files.put(each.ending(), StreamContent.of(each.translate(function)));
            }
        }
        files.put(
                ".exr",
                stream -> ExrFile.ofHalves(columns, rows * slices, halves(grid, 3), json)
                        .write(stream));
        files.put(".md", StreamContent.of(ShaderText.of(language + ".md", metadata, doublings)));
        files.put(".json", StreamContent.of(json));
        if (isGlsl) {
            List<short[]> levels = IntStream.rangeClosed(0, doublings)
                    .mapToObj(level -> halves(level == 0 ? grid : baker.coarser(grid, level), 4))
                    .toList();
            files.put(".ktx2", stream -> new Ktx2File(columns, rows, slices, levels, json).write(stream));
            String page = ShaderText.read("example.html").replace("@EXPOSURE@", "" + (float) metadata.exposure());
            files.put(".html", StreamContent.of(page));
        }
        return new Output(files, metadata);
    }

    private static short[] halves(ColorGrid grid, int channels) {
        int texels = grid.shape().texels();
        float scale = scale(grid);
        short one = NumberFormat.half(1);
        short[] halves = new short[Math.multiplyExact(Math.multiplyExact(texels, channels), grid.roots().length)];
        int at = 0;
        for (float[] roots : grid.roots()) {
            for (int texel = 0; texel < texels; texel++) {
                for (int c = 0; c < channels; c++) {
                    halves[at++] = c < ColorGrid.CHANNELS
                            ? NumberFormat.half(scale * roots[ColorGrid.CHANNELS * texel + c])
                            : one;
                }
            }
        }
        return halves;
    }

    /** A texture file in Khronos's format KTX 2.0: layers of four half floats, row by row from the bottom; mip levels, the finest first. */
    private record Ktx2File(int width, int height, int layers, List<short[]> levels, String metadata) {
        private static final byte[] IDENTIFIER = {
            (byte) 0xab, 'K', 'T', 'X', ' ', '2', '0', (byte) 0xbb, '\r', '\n', 0x1a, '\n'
        };
        private static final int R16G16B16A16_SFLOAT = 97;
        private static final int CHANNELS = 4;
        private static final int TEXEL_BYTES = CHANNELS * Short.BYTES;
        private static final int HEADER_BYTES = 80;
        private static final int LEVEL_BYTES = 24;
        private static final int SAMPLE_BYTES = 16;
        private static final int DESCRIPTOR_BYTES = 24 + CHANNELS * SAMPLE_BYTES;

        void write(OutputStream stream) throws IOException {
            byte[] keys = keys();
            int descriptor = HEADER_BYTES + LEVEL_BYTES * levels.size();
            int keysAt = descriptor + Integer.BYTES + DESCRIPTOR_BYTES;
            int dataAt = (keysAt + keys.length + TEXEL_BYTES - 1) / TEXEL_BYTES * TEXEL_BYTES;
            ByteBuffer head = ByteBuffer.allocate(dataAt).order(ByteOrder.LITTLE_ENDIAN);
            head.put(IDENTIFIER);
            // Fields: format, bytes of a number, width, height, no depth, layers, one face, levels, no compression.
            ints(head, R16G16B16A16_SFLOAT, Short.BYTES, width, height, 0, layers, 1, levels.size(), 0);
            ints(head, descriptor, Integer.BYTES + DESCRIPTOR_BYTES, keysAt, keys.length);
            head.putLong(0).putLong(0);
            // KTX2 stores the smallest level first.
            long at = dataAt + levels.stream().mapToLong(Ktx2File::bytes).sum();
            for (short[] level : levels) {
                at -= bytes(level);
                head.putLong(at).putLong(bytes(level)).putLong(bytes(level));
            }
            describe(head);
            head.put(keys);
            stream.write(head.array());
            for (int level = levels.size() - 1; level >= 0; level--) {
                ByteBuffer bytes = ByteBuffer.allocate((int) bytes(levels.get(level)));
                bytes.order(ByteOrder.LITTLE_ENDIAN).asShortBuffer().put(levels.get(level));
                stream.write(bytes.array());
            }
        }

        private static long bytes(short[] level) {
            return (long) level.length * Short.BYTES;
        }

        /** Writes Khronos's basic data format descriptor: linear, four signed floats of 16 bits. */
        private static void describe(ByteBuffer head) {
            ints(head, Integer.BYTES + DESCRIPTOR_BYTES, 0, 2 | DESCRIPTOR_BYTES << Short.SIZE);
            // Fields: color model RGBSDA, linear, alpha straight; blocks of one texel; bytes per texel.
            ints(head, 1 | 1 << Short.SIZE, 0, TEXEL_BYTES, 0);
            for (int channel = 0; channel < CHANNELS; channel++) {
                int kind = channel == CHANNELS - 1 ? 15 : channel;
                // Fields: bit offset and length, channel and signed float; position; least and largest value, -1 and 1.
                ints(head, 16 * channel | 15 << 16 | (kind | 0xc0) << 24, 0, 0xbf800000, 0x3f800000);
            }
        }

        private static void ints(ByteBuffer buffer, int... values) {
            IntStream.of(values).forEach(buffer::putInt);
        }

        private byte[] keys() {
            ByteArrayOutputStream keys = new ByteArrayOutputStream();
            for (String entry : List.of("KTXwriter\0sunbeam\0", "sunbeam\0" + metadata + "\0")) {
                byte[] bytes = entry.getBytes(StandardCharsets.UTF_8);
                int padded = (bytes.length + Integer.BYTES - 1) / Integer.BYTES * Integer.BYTES;
                ByteBuffer value = ByteBuffer.allocate(Integer.BYTES + padded).order(ByteOrder.LITTLE_ENDIAN);
                keys.writeBytes(value.putInt(bytes.length).put(bytes).array());
            }
            return keys.toByteArray();
        }
    }
}
