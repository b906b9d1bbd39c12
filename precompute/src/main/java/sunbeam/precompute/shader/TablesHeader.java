package sunbeam.precompute.shader;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import sunbeam.precompute.shader.ArrayLayout.Kind;
import sunbeam.precompute.shader.ArrayLayout.Reading;
import sunbeam.precompute.table.TableException;
import sunbeam.precompute.table.TableLabel;

/**
 * All of {@link ShaderTables} but the arrays' floats, as bytes, big-endian.
 *
 * @param key all that determines the tables
 * @param label what they are, for people
 * @param tables without arrays
 * @param layouts of the arrays, in their order
 */
record TablesHeader(String key, TableLabel label, ShaderTables tables, List<ArrayLayout> layouts) {
    // Far more than any method has; a header that claims more is damaged.
    private static final int MOST_BYTES = 1 << 20;
    private static final int ALIGNMENT = 16;

    static TablesHeader of(String key, TableLabel label, ShaderTables tables) {
        return new TablesHeader(
                key,
                label,
                tables,
                tables.arrays().stream().map(TableArray::layout).toList());
    }

    /** Bytes of all arrays; fails where they are more than a number can count. */
    long arrayBytes() {
        long bytes = 0;
        for (ArrayLayout layout : layouts) {
            long layer = Math.multiplyExact((long) Float.BYTES, layout.floatsPerLayer());
            bytes = Math.addExact(bytes, Math.multiplyExact(layer, layout.layers()));
        }
        return bytes;
    }

    byte[] encoded() {
        ByteBuffer out = ByteBuffer.allocate(MOST_BYTES);
        put(out, key);
        put(out, label.patch());
        put(out, label.what());
        put(out, tables.shader());
        out.putInt(tables.defines().size());
        tables.defines().forEach((name, value) -> {
            put(out, name);
            put(out, value);
        });
        out.putInt(tables.uniforms().size());
        tables.uniforms().forEach((name, value) -> {
            put(out, name);
            put(out, value);
        });
        out.putDouble(tables.windowSigma()).putDouble(tables.specularReach());
        put(out, tables.trial());
        out.putInt(layouts.size());
        for (ArrayLayout layout : layouts) {
            put(out, layout.sampler());
            out.putInt(layout.width()).putInt(layout.height()).putInt(layout.layers());
            put(out, layout.kind().name());
            out.putInt(layout.channels());
            put(out, layout.reading().name());
        }
        // Floats that follow lie where processors read them fastest.
        byte[] bytes = new byte[(out.position() + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT];
        out.flip().get(bytes, 0, out.limit());
        return bytes;
    }

    private static void put(ByteBuffer out, String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        out.putInt(bytes.length).put(bytes);
    }

    private static void put(ByteBuffer out, UniformValue value) {
        if (value instanceof UniformValue.Reals reals) {
            out.put((byte) 'f').putInt(reals.components().size());
            reals.components().forEach(out::putFloat);
        } else if (value instanceof UniformValue.Integers integers) {
            out.put((byte) 'i').putInt(integers.components().size());
            integers.components().forEach(out::putInt);
        }
    }

    /**
     * Reads what {@link #encoded} wrote.
     *
     * @throws TableException when it did not
     */
    static TablesHeader decoded(ByteBuffer in) {
        try {
            String key = text(in);
            TableLabel label = new TableLabel(text(in), text(in));
            String shader = text(in);
            Map<String, String> defines = new TreeMap<>();
            for (int left = in.getInt(); left > 0; left--) {
                defines.put(text(in), text(in));
            }
            Map<String, UniformValue> uniforms = new TreeMap<>();
            for (int left = in.getInt(); left > 0; left--) {
                uniforms.put(text(in), uniform(in));
            }
            ShaderTables tables =
                    new ShaderTables(shader, defines, uniforms, List.of(), in.getDouble(), in.getDouble(), text(in));
            List<ArrayLayout> layouts = new ArrayList<>();
            for (int left = in.getInt(); left > 0; left--) {
                layouts.add(layout(in));
            }
            return new TablesHeader(key, label, tables, layouts);
        } catch (BufferUnderflowException | IllegalArgumentException | ArithmeticException e) {
            throw new TableException("its header cannot be read");
        }
    }

    private static String text(ByteBuffer in) {
        byte[] bytes = new byte[count(in, 1)];
        in.get(bytes);
        return new String(bytes, StandardCharsets.UTF_8);
    }

    private static UniformValue uniform(ByteBuffer in) {
        boolean reals = in.get() == 'f';
        int count = count(in, Integer.BYTES);
        List<Float> floats = new ArrayList<>();
        List<Integer> integers = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            if (reals) {
                floats.add(in.getFloat());
            } else {
                integers.add(in.getInt());
            }
        }
        return reals ? new UniformValue.Reals(floats) : new UniformValue.Integers(integers);
    }

    private static ArrayLayout layout(ByteBuffer in) {
        String sampler = text(in);
        int width = in.getInt();
        int height = in.getInt();
        int layers = in.getInt();
        Kind kind = Kind.valueOf(text(in));
        int channels = in.getInt();
        ArrayLayout layout = new ArrayLayout(sampler, width, height, layers, kind, channels, Reading.valueOf(text(in)));
        // A layer is mapped in one piece.
        Math.multiplyExact(Float.BYTES, layout.floatsPerLayer());
        return layout;
    }

    /** A number of things of a size, which must still be there before memory is taken for them. */
    private static int count(ByteBuffer in, int bytesEach) {
        int count = in.getInt();
        if (count < 0 || count > in.remaining() / bytesEach) {
            throw new IllegalArgumentException("count " + count);
        }
        return count;
    }

    /** Whether a header may be so long. */
    static boolean isPlausible(int bytes) {
        return bytes > 0 && bytes <= MOST_BYTES;
    }
}
