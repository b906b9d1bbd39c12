package sunbeam.app.cli.export;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import sunbeam.app.files.output.NpyWriter;

/** Named arrays in the format of Mitsuba's and pbrt's tensor files: version 1.0, little endian, the last index runs fastest. */
final class TensorFile {
    private static final byte[] HEAD = "tensor_file\0\1\0".getBytes(StandardCharsets.US_ASCII);
    private static final byte UINT8 = 1;
    private static final byte FLOAT32 = 10;
    private static final int ALIGNMENT = 8;

    private TensorFile() {}

    /**
     * @param bytes bytes of a text or a flag; null for numbers
     * @param values float32 numbers in consecutive portions
     */
    record Field(String name, long[] shape, byte[] bytes, List<float[]> values) {
        static Field of(String name, byte... bytes) {
            return new Field(name, new long[] {bytes.length}, bytes, List.of());
        }

        static Field of(String name, String text) {
            return of(name, text.getBytes(StandardCharsets.UTF_8));
        }

        static Field of(String name, List<float[]> values, long... shape) {
            return new Field(name, shape, null, values);
        }

        /** Returns a field with a curve along its last axis, the same at each index of the axis before. */
        static Field curve(String name, IntToDoubleFunction curve, long... shape) {
            float[] values = new float[(int) shape[shape.length - 1]];
            for (int i = 0; i < values.length; i++) {
                values[i] = (float) curve.applyAsDouble(i);
            }
            return of(name, Collections.nCopies(shape.length == 1 ? 1 : (int) shape[0], values), shape);
        }

        private long size() {
            return Arrays.stream(shape).reduce(1, Math::multiplyExact) * (bytes == null ? Float.BYTES : 1);
        }

        private int headBytes() {
            return Short.BYTES + name.length() + Short.BYTES + 1 + Long.BYTES * (1 + shape.length);
        }
    }

    static void write(OutputStream stream, List<Field> fields) throws IOException {
        int head = HEAD.length
                + Integer.BYTES
                + fields.stream().mapToInt(Field::headBytes).sum();
        ByteBuffer header = ByteBuffer.allocate(Math.toIntExact(aligned(head))).order(ByteOrder.LITTLE_ENDIAN);
        header.put(HEAD).putInt(fields.size());
        long offset = header.capacity();
        for (Field field : fields) {
            header.putShort((short) field.name().length()).put(field.name().getBytes(StandardCharsets.US_ASCII));
            header.putShort((short) field.shape().length).put(field.bytes() == null ? FLOAT32 : UINT8);
            header.putLong(offset);
            Arrays.stream(field.shape()).forEach(header::putLong);
            offset += aligned(field.size());
        }
        stream.write(header.array());
        for (Field field : fields) {
            if (field.bytes() == null) {
                for (float[] portion : field.values()) {
                    NpyWriter.writeValues(stream, portion);
                }
            } else {
                stream.write(field.bytes());
            }
            stream.write(new byte[(int) (aligned(field.size()) - field.size())]);
        }
    }

    private static long aligned(long bytes) {
        return (bytes + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    }
}
