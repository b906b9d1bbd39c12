package sunbeam.precompute.shader;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import sunbeam.precompute.table.TableException;
import sunbeam.precompute.table.TableLabel;

/**
 * Header of a {@link ShaderTablesFile}: {@link ShaderTables} without the arrays' floats, as JSON.
 *
 * @param key text that determines the tables
 * @param label description for lists of the cache
 */
record TablesHeader(
        String key,
        TableLabel label,
        String shader,
        Map<String, String> defines,
        Map<String, List<Float>> reals,
        Map<String, List<Integer>> integers,
        double windowSigma,
        double specularReach,
        String trial,
        List<ArrayLayout> layouts) {
    // Longer than any method's header.
    private static final int MOST_BYTES = 1 << 20;
    private static final int ALIGNMENT = 16;
    private static final JsonMapper JSON = JsonMapper.builder()
            .enable(DeserializationFeature.FAIL_ON_NULL_CREATOR_PROPERTIES)
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .build();

    static TablesHeader of(String key, TableLabel label, ShaderTables tables) {
        Map<String, List<Float>> reals = new TreeMap<>();
        Map<String, List<Integer>> integers = new TreeMap<>();
        tables.uniforms().forEach((name, value) -> {
            if (value instanceof UniformValue.Reals some) {
                reals.put(name, some.components());
            } else if (value instanceof UniformValue.Integers some) {
                integers.put(name, some.components());
            }
        });
        return new TablesHeader(
                key,
                label,
                tables.shader(),
                tables.defines(),
                reals,
                integers,
                tables.windowSigma(),
                tables.specularReach(),
                tables.trial(),
                tables.arrays().stream().map(TableArray::layout).toList());
    }

    ShaderTables tables(List<TableArray> arrays) {
        Map<String, UniformValue> uniforms = new TreeMap<>();
        reals.forEach((name, value) -> uniforms.put(name, new UniformValue.Reals(value)));
        integers.forEach((name, value) -> uniforms.put(name, new UniformValue.Integers(value)));
        return new ShaderTables(shader, defines, uniforms, arrays, windowSigma, specularReach, trial);
    }

    /**
     * Returns the number of bytes of all arrays.
     *
     * @throws ArithmeticException if they overflow a long, or one layer an int, which limits a mapping to memory
     */
    long arrayBytes() {
        long bytes = 0;
        for (ArrayLayout layout : layouts) {
            long layer = Math.multiplyExact(Float.BYTES, layout.floatsPerLayer());
            bytes = Math.addExact(bytes, Math.multiplyExact(layer, layout.layers()));
        }
        return bytes;
    }

    byte[] encoded() {
        try {
            byte[] json = JSON.writeValueAsBytes(this);
            // Blanks align the floats.
            byte[] bytes = Arrays.copyOf(json, (json.length + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT);
            Arrays.fill(bytes, json.length, bytes.length, (byte) ' ');
            return bytes;
        } catch (JsonProcessingException e) {
            throw new UncheckedIOException(e);
        }
    }

    static TablesHeader decoded(byte[] bytes) {
        try {
            return JSON.readValue(bytes, TablesHeader.class);
        } catch (IOException e) {
            throw new TableException("its header cannot be read");
        }
    }

    static boolean isPlausible(int bytes) {
        return bytes > 0 && bytes <= MOST_BYTES;
    }
}
